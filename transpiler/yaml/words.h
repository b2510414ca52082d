// Words of YAML that the tool writes.
#pragma once

#include <string>
#include <string_view>

namespace plcxx::yaml {

/// A text as YAML reads it back: as it is where it has but letters, digits and characters of `plain` and is no
/// word for nothing (null), else in quotes: double ones where it has control characters.
std::string YamlWord(const std::string& text, std::string_view plain);

/// A text of several lines as the value of a key: a literal block whose lines stand `indent` to the right, or a word in
/// double quotes where a block cannot hold it (control characters, no text). Without a line's end after it.
std::string YamlText(std::string_view text, size_t indent);

}  // namespace plcxx::yaml
