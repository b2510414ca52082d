// The lexer of dialect prostep (specification section 2): the text of one file to lines with tokens.
//
// What a line is does not depend on the lines around it, and where its comment begins depends on its mnemonic only, so
// the lexer decides both. Reports characters that may not stand where they stand (E01) and late headers (E02); the
// token is then marked faulty, so that the parser says nothing more about it. Not its job: which operands belong to
// which instruction, ranges, labels.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/prostep/syntax/syntax.h"
#include "transpiler/source/characters.h"
#include "transpiler/source/source.h"

namespace plcxx::prostep {

enum class LineKind : uint8_t { kBlank, kHeader, kComment, kDeclaration, kStatement };

enum class TokenKind : uint8_t {
  kHeader,
  kComment,      // with its marker, if it has one
  kDeclaration,  // DDB, DDW, DDD, DMF, DM, DT
  kSwitch,       // of DMF
  kText,         // of DM and DT, after the dot; may be empty
  kLabel,        // a word before the colon; only one is right
  kColon,
  kMnemonic,    // a mnemonic of machine.def
  kModuleMark,  // MOD, END
  kUnknown,     // what stands where an instruction should
  kClass,       // the letters of an operand; as the first token after the colon: an operand line
  kNumber,      // up to a blank, well formed or not; with the dot and the bit
  kTarget,      // a label after JU or JC
  kJunk,        // what stands where an operand, a dot or a switch should
};
std::string_view Name(TokenKind kind);

struct Token {
  TokenKind kind = TokenKind::kComment;
  bool faulty = false;  // already reported
  source::Range range;
};

struct Line {
  LineKind kind = LineKind::kBlank;
  source::Range range;  // without the line end
  Span tokens;
};

struct LexedFile {
  std::vector<Line> lines;
  std::vector<Token> tokens;
};

LexedFile Lex(const source::SourceManager& sources, source::FileId file, diag::Engine& diagnostics);

/// Does the text begin as a ProStep program: is its first line with a colon that is neither a comment nor a declaration
/// ':MOD PM n' (section 1)?
bool Recognize(std::string_view text);

// Characters, for lexer and parser.
bool IsBlank(char c);
bool IsDigit(char c);
bool IsLetter(char c);
std::string Upper(std::string_view text);
std::string_view TrimBlanks(std::string_view text);
bool IsMarked(std::string_view comment);

/// After an instruction without operand: is `rest` meant as an operand (2.2)? One or two letters, blanks, a digit.
bool IsOperandLike(std::string_view rest);
/// As above, with letters that name an operand class.
bool LooksLikeOperand(std::string_view rest);

}  // namespace plcxx::prostep
