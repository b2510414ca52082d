// One period, or power-on, of one version as a function of the state before it.
#pragma once

#include <functional>
#include <vector>

#include "transpiler/prove/machine/version.h"
#include "transpiler/symbolic/execute/execute.h"

namespace plcxx::prove::machine {

/// What a host function has seen of each cell that is observed, call by call: two terms are one where all its calls,
/// in whichever branches they stand, have found the same values there, in the same order.
struct Seen {
  ir::HostFunctionId function;
  std::vector<terms::TermId> cells;  // by index of PartEnvironment::observed; none: not seen by the function
};

struct Transition {
  std::vector<terms::TermId> next;  // by cell; none: the cell keeps its value
  std::vector<Seen> seen;           // by function, of those that see some of what is observed (execute::HostSees)
  execute::Refusal refusal;
};

enum class HostAnswers : uint8_t {
  kAny,     // whatever a host may answer and write
  kNothing  // 0, no second result, and nothing is written: a simulation without a stub
};

/// Instructions in all rounds of a loop with a proven bound that is executed to its bound, so that something can be
/// said of what it does: a page of 50 rounds and a hundred steps. Of others, and of Version::shared_loops, nothing is.
inline constexpr uint32_t kMostUnrolled = 50'000;

struct PartEnvironment {
  std::function<terms::TermId(execute::CellId)> initial;
  terms::TermId now;
  HostAnswers answers = HostAnswers::kAny;
  bool has_copy = false;                  // of retentive memory, whatever the host answers
  std::vector<execute::CellId> observed;  // bits of Transition::seen
  std::function<execute::Environment::HostBit(execute::CellId)> host_bit;  // see Environment; may be empty
  std::function<bool(execute::CellId)> may_be_left;                        // see Environment; may be empty
  std::function<terms::TermId(execute::CellId, terms::TermId)> cut;        // see Environment; may be empty
  std::function<bool(execute::CellId)> is_cut;
  std::function<bool(ir::InstId, terms::TermId)> never_holds;  // see Environment; may be empty
  std::function<bool()> is_late;                               // see Environment; may be empty
};

/// What runs by itself: the schedule's period, and the fast part alone: it may have a time of its own (fast_ms, the
/// period is the slow part alone then), or the slow part may not be done yet when the next period begins.
enum class Part : uint8_t { kPeriod, kFast };
/// Whether the fast part alone is something else than a period.
bool HasFastPart(const Version& version);
/// Schedule::fast_ms: the period is the slow part alone then.
bool HasTimedFastPart(const Version& version);
Transition RunPart(terms::Terms& terms, const Version& version, Part part, const PartEnvironment& environment);
/// What the host calls by itself, whenever it likes (RoutineKind::kInterrupt).
Transition RunCalledByHost(terms::Terms& terms, const Version& version, ir::RoutineId routine,
                           const PartEnvironment& environment);
/// Power-on: memory is as the program says, and then, as far as it is retentive, as it was when the power failed:
/// `initial` is asked for that and for the calls.
/// Whether memory lives on without power.
bool HasRetentiveMemory(const Version& version);
Transition RunInit(terms::Terms& terms, const Version& version, const PartEnvironment& environment);

/// The value of a cell when power comes: 0, or the program's initial byte.
bool PowerOnBit(const ir::Space& space, uint32_t offset, uint8_t bit);
/// The same of a cell; 0 of what is no bit of memory.
bool PowerOnValue(const Version& version, execute::CellId cell);

}  // namespace plcxx::prove::machine
