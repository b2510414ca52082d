// Names that the program defines and does not use.
#pragma once

#include <span>

#include "transpiler/dialects/technol/parser/parsing_context.h"

namespace plcxx::technol {

/// TW004. A definition file's constants serve many programs, so those that one of them leaves out are no fault: only
/// `sources` count, the files of the command line.
void WarnOfUnused(ParsingContext& context, std::span<const source::FileId> sources);

}  // namespace plcxx::technol
