// A program with one word changed, as a slip of a writer changes it: the same edit for the same number everywhere.
//
// Most edits leave a program that compiles and is another one: a relation, an operator or a number becomes its
// neighbour, a name another name of the text, a statement goes. The others are what a compiler has to refuse.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace plcxx::printed {

enum class Writing : uint8_t {
  kC,      // statements end with ';', comments are those of C
  kLines,  // a statement a line, a comment from ';' to the line's end
};

struct Edit {
  size_t begin = 0, end = 0;  // what goes
  std::string with;           // what stands there then
};

/// Nothing where the text has no word.
Edit EditOf(std::string_view text, Writing writing, uint64_t number);

std::string Edited(std::string_view text, const Edit& edit);

/// "12: 'a < b' -> '<='": for a message.
std::string Described(std::string_view text, const Edit& edit);

}  // namespace plcxx::printed
