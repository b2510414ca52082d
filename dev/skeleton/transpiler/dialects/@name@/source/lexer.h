// The lexer of dialect @name@: the text of one file to tokens.
//
// A line is a word and its operands; a comment is from ';' to the end of its line. Not its job: which operands belong
// to which instruction.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "transpiler/source/source.h"

namespace plcxx::@name@ {

enum class TokenKind : uint8_t {
  kWord,      // the first one of a line
  kOperands,  // what follows it, up to the end of the line or its comment
  kComment,
};
std::string_view Name(TokenKind kind);

struct Token {
  TokenKind kind = TokenKind::kComment;
  source::Range range;
};

std::vector<Token> Lex(const source::SourceManager& sources, source::FileId file);

}  // namespace plcxx::@name@
