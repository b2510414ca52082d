// Statements that are nothing of the language: what may be meant.
#pragma once

#include <cstdint>

#include "transpiler/dialects/technol/parser/statement_reader.h"

namespace plcxx::technol {

/// Where a statement stands.
enum class CodePlace : uint8_t { kData, kCode, kOutside };

/// Reports it. True: an instruction may be meant, so that what it would load is not missed after it.
bool ReportUnknown(const Statement& statement, CodePlace place, ParsingContext& context);

}  // namespace plcxx::technol
