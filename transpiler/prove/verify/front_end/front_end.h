// Whether a front end has understood its sources: each function as another compiler of the language compiles it,
// against the typed IR that the generated code is printed from.
//
// The other compiler's code is executed on terms as compiled code is (prove/compiled), on the program's own spaces: its
// variables are the bytes that lowering has given them, calls of proved functions are unknown functions, called alike.
// Where the program records a run-time fault, C says nothing: compared are executions in which no function that is
// looked at comes to one. In: the emittable program, the reference. Out: a proof for each function, or why there is
// none. Not its job: compiling the sources, and the control's own routines (the schedule, what it does when called).
#pragma once

#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/ir/reference.h"
#include "transpiler/prove/verify/verify.h"

namespace plcxx::prove::verify::front_end {

struct FunctionProof {
  verify::RoutineProof proof;  // its routine is the function's name in the sources
  std::string not_compared;    // what in it cannot be; empty: it was compared
  /// Those in whose proofs it is executed, for every call; empty: it was compared by itself.
  std::vector<std::string> in_callers;
};

struct Comparison {
  std::string compiler;                  // the other one
  std::string reason;                    // why nothing was compared; empty: something was
  std::vector<FunctionProof> functions;  // callees first
};

Comparison Compare(const emit::Emittable& emittable, const ir::Reference& reference,
                   const verify::VerifyLimits& limits);

/// What a function of C's library gives, by name and arguments; none: it is none of those that are known.
terms::TermId LibraryResult(terms::Terms& terms, std::string_view name, std::span<const terms::TermId> arguments);

}  // namespace plcxx::prove::verify::front_end
