// What words, operators and numbers of other languages are in C, for the remedies of syntax errors.
//
// In: the text of the line around the place where the syntax breaks. Out: a remedy, or nothing where nobody knows. Not
// its job: whether something is wrong at all.
#pragma once

#include <string>
#include <string_view>

namespace plcxx::hnc {

/// `before`: the line in front of the place; `token`: what was found there, without quotes; `after`: the rest of the
/// line.
std::string MeantBy(std::string_view before, std::string_view token, std::string_view after);

/// Is the last word of the line, apart from stars, one of a type?
bool EndsWithType(std::string_view before);

/// For a name that is not declared, or is no type.
std::string MeantByName(std::string_view name);

/// For what a message about types says; empty where nobody knows more than that they do not fit.
std::string_view RemedyOfTypes(std::string_view words);

/// For words of newer compilers, such as _Bool or __attribute__.
std::string InsteadOfWord(std::string_view word);

/// For 0b101: the number in hexadecimal.
std::string InsteadOfBinary(std::string_view number);

}  // namespace plcxx::hnc
