// The words of a failed step: where, when, what was expected, what was there, and who wrote it last.
//
// In: a place and the simulator's record of writes. Out: text for a person. Not its job: deciding that it failed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "transpiler/dialects/dialect.h"
#include "transpiler/engines/lockstep.h"
#include "transpiler/ir/program.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/sim/last_writes.h"
#include "transpiler/source/source.h"

namespace plcxx::scenarios {

/// "turret.yaml:12:13: step 3 (expect), at 120 ms: <message>"
std::string StepFailure(const Scenario& scenario, const ScenarioStep& step, ScenarioMark mark, uint64_t time_ms,
                        std::string_view message);

/// Indented lines, newest write first, each with the source's place and statement. `writes` is none when no simulator
/// takes part.
std::string LastWritesText(const std::string& name, const dialects::Location& location, const sim::LastWrites* writes,
                           const ir::Program& program, const source::SourceManager& sources);

/// "main.cld:7:9: a[i] = 0;"; without a statement it is the control's own.
std::string StatementPlace(ir::StatementId statement, const ir::Program& program, const source::SourceManager& sources);

/// What a call of false_fact (ir/facts.h) tells: the kind of the fact, the value, the statement.
std::string FalseFactText(const sim::HostEvent& call, const ir::Program& program, const source::SourceManager& sources);

/// "simulator and compiled differ in U4A8 (simulator: 1, compiled: 0)"
std::string DifferenceText(const engines::Difference& difference);

}  // namespace plcxx::scenarios
