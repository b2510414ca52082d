// Whether states are reached, by facts about those that are.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "transpiler/prove/properties/checked_program.h"
#include "transpiler/prove/properties/program_invariants.h"
#include "transpiler/prove/properties/reachable.h"

namespace plcxx::prove::properties {

/// What the state words of a property mean, beside those of the program; none: there are none.
using MoreWords = std::function<std::optional<StateWord>(terms::TermId variable)>;

/// What runs in any order, the period itself last.
std::vector<const std::vector<terms::TermId>*> PartsOf(const machine::Relation& relation);

/// Whether a state, after whole periods, that is `bad`, is reached: over the variables of Widest() and those of `more`,
/// which outlives the question.
ReachQuestion QuestionOf(CheckedProgram& checked, const ProgramInvariants& invariants, terms::TermId bad,
                         const MoreWords& more);
/// Counts the facts.
bool IsNeverReached(const CheckedProgram& checked, const ReachQuestion& question, PropertyResult& result);

}  // namespace plcxx::prove::properties
