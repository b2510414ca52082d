// Names that a program has without defining them: those of the control, and those of the machine's signal table.
#pragma once

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/technol/parser/parsing_context.h"

namespace plcxx::technol {

void AddControlSymbols(SymbolTable& names);
/// Option signals.
void AddSignalFile(dialects::Request& request, ParsingContext& context);

}  // namespace plcxx::technol
