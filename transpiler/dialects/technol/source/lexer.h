// The lexer of dialect technol (specification section 2): one line of text to tokens.
//
// What a line is does not depend on the lines around it. Lines of a macro's expansion are lexed like those of a file,
// but all their tokens stand where the macro is called. Reports nothing: whether a character may stand where it stands
// depends on the statement (an ignored TITLE, an argument of a macro).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/source/source.h"

namespace plcxx::technol {

enum class TokenKind : uint8_t {
  kWord,         // name, mnemonic, register, directive; also a lone '?'
  kNumber,       // begins with a digit; well formed or not
  kString,       // 'text', with its quotes
  kQuoted,       // "text", with its quotes
  kOpenString,   // not closed on its line
  kPunctuation,  // one character
  kPath,         // after T_INCLUDE or INCLUDE
  kText,         // after TITLE and the like
  kComment,      // from ';' on, without blanks at the end
  kInvalid,      // one character that belongs into comments
};
std::string_view Name(TokenKind kind);

struct Token {
  TokenKind kind = TokenKind::kComment;
  bool glued = false;  // nothing between it and the token before it
  std::string_view text;
  source::Range range;
};

/// Where a line stands: in a file from `begin` on, or wholly at the call of a macro.
struct LinePlace {
  source::Offset begin = 0;
  source::Range call;  // not empty: of every token
};

/// Appends the tokens of one line (without line end); the comment comes last. `text` outlives the tokens.
void LexLine(std::string_view text, const LinePlace& place, std::vector<Token>& tokens);

// Characters, for lexer and parser.
bool IsBlank(char c);  // also form feed and vertical tab
bool IsDigit(char c);
bool IsNameStart(char c);
bool IsNameCharacter(char c);
std::string Upper(std::string_view text);
/// Ignoring the case of ASCII letters; `upper` is in capitals.
bool Means(std::string_view text, std::string_view upper);
std::string_view TrimBlanks(std::string_view text);

}  // namespace plcxx::technol
