// The words of dialect nc110 (specification 2.4, 2.5): what a run of letters and digits is.
//
// In: the text of one run. Out: its kind, the operand or the number it spells, or the field that is wrong.
// Not its job: places in files, diagnostics, symbols.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "transpiler/dialects/nc110/syntax/syntax.h"

namespace plcxx::nc110 {

enum class TokenKind : uint8_t {
#define NC110_TOKEN(Key, ...) k##Key,
#include "transpiler/dialects/nc110/source/tokens.def"
};

/// "operand", "operator": for `print tokens`.
std::string_view Name(TokenKind kind);

enum class Function : uint8_t {
#define PLCXX_WORD_FUNCTION(Kind, ...) k##Kind,
#include "transpiler/dialects/nc110/machine/functions.def"
  kSgn,
  kMux
};

std::string_view Name(Function function);
/// kMux has none.
ExprKind ExprKindOf(Function function);

struct Word {
  TokenKind kind = TokenKind::kRun;
  Function function = Function::kDec;  // kFunction only
};

/// What a run is; capitals and small letters are not told apart.
Word Classify(std::string_view run);

bool IsBlockWord(TokenKind kind);
/// Functions, block words, DOW, ENDW, END, MSG: no block names.
bool IsKeyword(TokenKind kind);

enum class OperandFault : uint8_t {
  kNone,
  kUnknown,
  kConnector,
  kBit,
  kBitMissing,
  kWordIndex,
  kWordIndexMissing,
  kTimer,
  kCounter,
  kOneShot,
};

struct Decoded {
  Operand operand;  // meaningful without a fault
  OperandFault fault = OperandFault::kUnknown;
  uint32_t found = 0;  // the number out of range
};

/// Leading zeros do not count: "I00A20" is I0A20.
Decoded Decode(std::string_view run);
/// An operand from outside a program (options, scenarios): its spelling, complete and in range, else kind kNone.
Operand OperandFromText(std::string_view text);

uint32_t ConnectorLimit(Package package);

/// Characters that tell symbols apart.
inline constexpr size_t kSignificant = 10;

struct Number {
  bool well_formed = false;
  uint32_t value = 0;  // stops at 1,000,000: the ranges are far below
};

/// 45, 45D, 55O, 2DH; applied to the whole run.
Number Evaluate(std::string_view run);

/// The operand or block word that `run` becomes when O and 0, I and 1 are exchanged where needed; empty: none.
std::string LookAlike(std::string_view run);

/// What is meant by a run that is no operand, where that is plain, as a remedy; empty: nobody knows.
std::string CauseOfUnknown(std::string_view run);

std::string Capitals(std::string_view run);

constexpr char Upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
constexpr bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\f'; }
constexpr bool IsDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace plcxx::nc110
