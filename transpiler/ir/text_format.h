// How the text form of a program spells words and strings; shared by printer and reader, so that they agree.
//
// A line is a row of words, strings and single punctuation marks; `;` begins a comment. A name that is no word (it is
// empty, or holds blanks or punctuation) is written as a string. Not its job: what a line means.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/ir/memory.h"
#include "transpiler/ir/program.h"

namespace plcxx::ir::text {

enum class TokenKind : uint8_t { kWord, kString, kPunctuation };

struct Token {
  TokenKind kind;
  std::string text;  // of a string: what it stands for
};

/// `"..."`, with quotes, backslashes and control characters escaped.
std::string Quoted(std::string_view text);
/// The text itself when it is a word, otherwise quoted.
std::string Word(std::string_view text);
/// The tokens of one line without its comment; none when a string is not closed or an escape is unknown.
std::optional<std::vector<Token>> Tokens(std::string_view line);
/// Decimal, or hexadecimal after 0x; none when it is no number or does not fit.
std::optional<uint64_t> Number(std::string_view text);
std::string Hex(uint64_t value);
/// As Number reads it: in base 16 after 0x, otherwise decimal.
std::string Spelled(uint64_t value, uint32_t base);

/// Handles: distinct names in the order of the items; a repeated name gets ~2, ~3 ...
std::vector<std::string> Handles(const std::vector<std::string>& names);
/// What a statement is called: `s` and its id, which its own text decides, so that an insertion above renames nothing.
std::vector<std::string> StatementHandles(const Program& program);

// The spellings of the enums.
inline constexpr std::string_view kLifetimes[] = {"routine", "volatile", "retentive"};
inline constexpr std::string_view kOrders[] = {"little", "big"};
inline constexpr std::string_view kDirections[] = {"input", "output", "internal"};
inline constexpr std::string_view kBounds[] = {"proven", "guard", "budget"};
inline constexpr std::string_view kAccesses[] = {"none", "reads_state", "writes_state", "reads_retentive",
                                                 "writes_retentive"};
inline constexpr std::string_view kRoutineKinds[] = {"init", "fast", "slow", "interrupt", "subroutine", "schedule"};
inline constexpr Type kTypes[] = {Type::kNone, Type::kBit, Type::kI8,  Type::kI16,
                                  Type::kI32,  Type::kI64, Type::kF32, Type::kF64};

}  // namespace plcxx::ir::text
