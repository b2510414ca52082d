// Initial values of data (specification 9.2): '?', numbers, texts and repetitions.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/dialects/technol/parser/parsing_context.h"
#include "transpiler/dialects/technol/source/token_reader.h"

namespace plcxx::technol {

/// Values of DB, DW, DD separated by commas, `width` bits each; false when one is wrong (reported).
bool ReadValues(TokenReader& reader, uint8_t width, std::vector<uint8_t>& bytes, ParsingContext& context);

/// One of them.
bool ReadValue(TokenReader& reader, uint8_t width, std::vector<uint8_t>& bytes, ParsingContext& context);

}  // namespace plcxx::technol
