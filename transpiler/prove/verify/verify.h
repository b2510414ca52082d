// Whether compiled code does what the typed IR says: function by function, for every state and every input.
//
// Callees come first: a function that is proved is, where others call it, one unknown function of what it may read, on
// both sides. One that is not proved by itself is followed where it is called, and so are all when a caller cannot be
// proved otherwise.
// Both are executed on terms from the same state: the IR by symbolic/execute, with the meanings of symbolic/meaning;
// the code by the module, instruction by instruction. Afterwards every byte of State must be what the IR's cells say,
// the routine's result must be the same, and every host function must have been told the same, in the same order, with
// the same state to be read. Out: a proof, or what differs with a state that shows it, or why it is not decided.
// Assumed: bits that have a byte of their own are 0 or 1 there before the routine; the host writes what its declaration
// says and nothing else; the retentive copy that it gives has the program's layout.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/prove/verify/compiled_code.h"
#include "transpiler/prove/verify/units.h"

namespace plcxx::prove::verify {

struct VariableValue {
  std::string name;  // of what State holds, of a parameter, or of what a host answers
  uint64_t value = 0;
};

struct CodeDifference {
  std::string what;  // "U.10", "calls of fault", "the result", "a division by zero"
  bool has_values = false;
  uint64_t expected = 0, compiled = 0;  // for the state below
  std::vector<VariableValue> state;     // what it depends on, and is not 0
};

enum class ProofResult : uint8_t { kProved, kDifferent, kNotDecided };

struct RoutineProof {
  std::string routine;
  bool exported = true;  // the generated header declares it; others are steps on the way
  ProofResult result = ProofResult::kNotDecided;
  std::string reason;                       // of kNotDecided
  ir::StatementId statement;                // whose loop the reason is about; none: it is about no loop
  uint64_t bytes = 0;                       // of State, compared
  uint64_t host_functions = 0;              // whose calls were compared
  uint64_t obligations = 0;                 // shown to be impossible
  uint64_t claims = 0;                      // of loops that were not unrolled
  uint64_t instructions = 0;                // of LLVM that were executed
  uint64_t asked = 0;                       // comparisons that are not one term
  std::vector<std::string> relies_on;       // functions whose proofs this one takes for granted
  std::vector<CodeDifference> differences;  // not more than a few
};

/// What the code is that the program is compared with. As it is made: what plcxx prints, compiled.
struct CodeShape {
  Passes passes = Passes::kStateAndHost;
  std::vector<CodeGlobal> globals;  // slots are bytes of State
  /// What the program calls where the code's language says nothing: only executions that do not come to a call of it
  /// are compared. None: all are.
  ir::RoutineId fault;
  std::vector<uint64_t> open_faults;  // numbers of those that are recorded only where the code's language is open, too
  std::vector<ir::RoutineId>
      unknown;  // that the code only declares, or that are not compared: anything, the same when called alike
  /// That are compared in each of their calls alone: their parameters are others in the code.
  std::vector<ir::RoutineId> in_callers;
  /// Calls of the code that are calls of a host function, by the name in the code.
  std::vector<std::pair<std::string, ir::HostFunctionId>> hosts;
  /// By RoutineId: bytes of State that nothing reads after the routine, [begin, end).
  std::vector<std::vector<std::pair<uint32_t, uint32_t>>> dead_behind;
  std::vector<std::vector<bool>> is_constant;  // by SpaceId and byte: nothing writes it after power-on
  /// What a function of the language's library gives, by its name and arguments; may be empty.
  std::function<terms::TermId(terms::Terms& terms, std::string_view name, std::span<const terms::TermId> arguments)>
      library;

  /// Only executions without a fault are compared.
  bool IsUpToFaults() const { return fault.valid(); }
};

/// In time of the processor: what a verdict is must not depend on what else the machine does. A function has its time
/// once, for all ways in which it is tried.
struct VerifyLimits {
  uint32_t question_ms = 5'000;
  uint64_t routine_ms = 60'000;
  uint32_t jobs = 1;  // functions that are proved at a time; nothing that is told depends on it
  std::function<void(const std::string& text)> progress;      // may be empty
  std::function<void(const RoutineProof& proof)> is_decided;  // each when it is and all before it are; may be empty
};

/// The routines that the generated header declares, in its order.
std::vector<ir::RoutineId> RoutinesToVerify(const ir::Program& program);

/// Of these routines, and of the functions that they call, callees first. `emittable` is what the code was printed
/// from.
std::vector<RoutineProof> Verify(const emit::Emittable& emittable, CompiledCode& code,
                                 std::span<const ir::RoutineId> routines, const VerifyLimits& limits,
                                 const CodeShape& shape = {});

}  // namespace plcxx::prove::verify
