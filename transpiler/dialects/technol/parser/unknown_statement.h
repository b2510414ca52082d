// Statements that are nothing of the language: what may be meant.
#pragma once

#include "transpiler/dialects/technol/parser/statement_reader.h"

namespace plcxx::technol {

/// Reports it. True: an instruction may be meant, so that what it would load is not missed after it.
bool ReportUnknown(const Statement& statement, ParsingContext& context);

}  // namespace plcxx::technol
