// Constant expressions (specification 2.4, 2.5): evaluated while they are read, in signed 64-bit arithmetic.
#pragma once

#include <cstdint>
#include <optional>

#include "transpiler/dialects/technol/parser/parsing_context.h"
#include "transpiler/dialects/technol/source/token_reader.h"

namespace plcxx::technol {

/// Reads the longest constant expression at the reader. None when there is none or it is wrong (reported); its value
/// fits kLeastNumber to kGreatestNumber. Names have the values that they have in the context's statement.
std::optional<int64_t> ReadConstant(TokenReader& reader, ParsingContext& context);

/// A product (`const_term`): what may follow a '+' or '-' in an address.
std::optional<int64_t> ReadConstantTerm(TokenReader& reader, ParsingContext& context);

enum class NumberFault : uint8_t { kNone, kMalformed, kRange };
struct Number {
  int64_t value = 0;
  NumberFault fault = NumberFault::kNone;
};
/// 62, 62D, 0FFh, 1010b, 17q: `text` begins with a digit.
Number ReadNumber(std::string_view text);

}  // namespace plcxx::technol
