// What is known of each operand beside its use: symbols, the control's name and meaning, HELP (specification 9.2).
#pragma once

#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/dialects/nc110/parser/help_file.h"
#include "transpiler/dialects/nc110/syntax/syntax.h"
#include "transpiler/ir/program.h"

namespace plcxx::nc110 {

/// One entry for every operand that the program uses or names by a symbol: memory by package and connector, then
/// timers, counters and one-shots.
std::vector<ir::Documentation> Document(const Program& tree, const Settings& settings,
                                        const source::SourceManager& sources, const HelpTexts& help);

}  // namespace plcxx::nc110
