// C++ as words and signs, as far as the rules about sources need it.
#pragma once

#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

namespace plcxx::policy {

struct Token {
  std::string text;
  size_t line = 0;  // from 1
};

inline bool IsWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Words and single signs; "::" is one sign. Comments, literals and preprocessor lines are left out.
std::vector<Token> TokensOf(const std::string& text);

}  // namespace plcxx::policy
