// Whether compiled code does what the typed IR says: function by function, for every state and every input.
//
// Callees come first: a function that is proved is, where others call it, one unknown function of what it may read, on
// both sides. One that is not proved by itself is followed where it is called, and so are all when a caller cannot be
// proved otherwise.
// Both are executed on terms from the same state: the IR by prove/execute, with the meanings of prove/meaning; the code
// by the module, instruction by instruction. Afterwards every byte of State must be what the IR's cells say, the
// routine's result must be the same, and every host function must have been told the same, in the same order, with the
// same state to be read. Out: a proof, or what differs with a state that shows it, or why it is not decided.
// Assumed: bits that have a byte of their own are 0 or 1 there before the routine; the host writes what its declaration
// says and nothing else; the retentive copy that it gives has the program's layout.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/prove/compiled/compiled_code.h"

namespace plcxx::prove::compiled {

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
  uint64_t bytes = 0;                       // of State, compared
  uint64_t host_functions = 0;              // whose calls were compared
  uint64_t obligations = 0;                 // shown to be impossible
  uint64_t claims = 0;                      // of loops that were not unrolled
  uint64_t instructions = 0;                // of LLVM that were executed
  uint64_t asked = 0;                       // comparisons that are not one term
  std::vector<std::string> relies_on;       // functions whose proofs this one takes for granted
  std::vector<CodeDifference> differences;  // not more than a few
};

struct VerifyLimits {
  uint32_t question_ms = 10'000;
  uint64_t routine_ms = 60'000;
  std::function<void(const std::string& text)> progress;  // may be empty
};

/// The routines that the generated header declares, in its order.
std::vector<ir::RoutineId> RoutinesToVerify(const ir::Program& program);

/// Of these routines, and of the functions that they call, callees first. `emittable` is what the code was printed
/// from.
std::vector<RoutineProof> Verify(const emit::Emittable& emittable, CompiledCode& code,
                                 std::span<const ir::RoutineId> routines, const VerifyLimits& limits);

}  // namespace plcxx::prove::compiled
