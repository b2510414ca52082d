// One period, or power-on, of one version as a function of the state before it.
#pragma once

#include <functional>
#include <vector>

#include "transpiler/prove/compare/match.h"
#include "transpiler/prove/execute/execute.h"

namespace plcxx::prove {

/// What the host sees at a call that reads the state.
struct Observation {
  ir::HostFunctionId function;
  TermId when;
  std::vector<TermId> outputs;  // by index of Surroundings::outputs
};

struct Transition {
  std::vector<TermId> next;  // by cell; none: the cell keeps its value
  std::vector<Observation> observations;
  Refusal refusal;
};

enum class HostAnswers : uint8_t {
  kAny,     // whatever a host may answer and write
  kNothing  // 0, no second result, and nothing is written: a simulation without a stub
};

struct Surroundings {
  std::function<TermId(CellId)> initial;
  TermId now;
  HostAnswers answers = HostAnswers::kAny;
  std::vector<CellId> outputs;                           // what observations look at
  std::function<Environment::HostBit(CellId)> host_bit;  // see Environment; may be empty
  std::function<TermId(CellId, TermId)> cut;             // see Environment; may be empty
  std::function<bool(CellId)> is_cut;
};

/// What runs by itself: the schedule's period, and, where it has a time of its own, the fast part.
enum class Part : uint8_t { kPeriod, kFast };
/// Schedule::fast_ms: the period is the slow part alone then.
bool HasFastPart(const Version& version);
Transition RunPart(Terms& terms, const Version& version, Part part, const Surroundings& surroundings);
/// Power-on: memory is as the program says, and then, as far as it is retentive, as it was when the power failed:
/// `initial` is asked for that and for the calls.
/// Whether memory lives on without power.
bool HasRetentiveMemory(const Version& version);
Transition RunInit(Terms& terms, const Version& version, const Surroundings& surroundings);

/// The value of a cell when power comes: 0, or the program's initial byte.
bool PowerOnBit(const ir::Space& space, uint32_t offset, uint8_t bit);

}  // namespace plcxx::prove
