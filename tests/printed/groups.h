// A printed phase as groups of lines, and what of them another text does not have.
//
// A group is a line without indentation (`routine plc1 ... {`, `struct State {`) and the indented lines below it. Most
// of what is printed of a small program is the control's: the groups of a program without statements. What is left when
// its lines are taken away is what the program's own statements became.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plcxx::printed {

struct Group {
  std::string heading;
  std::vector<std::string> lines;  // indented; one after an empty line begins with '\n'
};

/// In the text's order; a line that is alone is a group without lines. Empty lines between groups are left out.
std::vector<Group> GroupsOf(std::string_view text);

/// What `text` has and no text of `known` has: of a group with the same heading the lines that are not among its lines,
/// each as often as it is there more often; of any other group everything. Ends with a line end unless it is empty.
std::string OwnLines(std::string_view text, const std::vector<std::string_view>& known);

/// Values without their numbers: "%s1.12 = add.i16 %3 %4" -> "% = add.i16 % %".
std::string WithoutNumbers(std::string_view text);

/// The headings that open a brace, in order: which functions a file has.
std::string Headings(std::string_view text);

}  // namespace plcxx::printed
