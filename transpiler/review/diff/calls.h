// Host calls of a run, as a scenario expects them, and the first one in which two versions differ.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/engine.h"

namespace plcxx::review::diff {

/// The number that a fault has from its statement's text: no reader knows it by heart.
enum class StatementNumbers : uint8_t { kLeftOut, kNamed };

/// The list of an `expect_calls` step that a run with these events passes: calls of the regular exchange do not count,
/// those of a polled function only when it is `function`, or `function` is empty: all. None when there are too many of
/// them to be read.
std::optional<std::string> ExpectedCalls(const ir::Program& program, const std::vector<sim::HostEvent>& events,
                                         const std::string& function, StatementNumbers numbers);

/// The first call of the function (empty: of any but the exchange's) in which two runs differ, in words: "fault(kind:
/// PARAM_RANGE, index: 20)", "no call". Where the program calls it alike, the first one of the regular exchange.
struct FirstDifferentCall {
  std::string old_text, new_text;
  bool is_of_exchange = false;
};
FirstDifferentCall FindDifferentCall(const ir::Program& old_program, const std::vector<sim::HostEvent>& old_events,
                                     const ir::Program& new_program, const std::vector<sim::HostEvent>& new_events,
                                     const std::string& function);

}  // namespace plcxx::review::diff
