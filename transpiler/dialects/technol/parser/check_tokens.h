// Characters that belong to no statement (specification 2.1, 2.3).
#pragma once

#include <span>

#include "transpiler/dialects/technol/parser/parsing_context.h"

namespace plcxx::technol {

/// Characters and continuations; false: the statement has them (reported), and is not looked at. `tokens` is not empty.
bool CheckTokens(std::span<const Token> tokens, ParsingContext& context);

}  // namespace plcxx::technol
