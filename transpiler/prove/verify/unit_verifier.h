// One function: both executions, and their comparison.
//
// In: a unit, and how calls and loops are treated. Out: its proof, or why there is none. Not its job: which treatment
// to try next (verify.cc).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "transpiler/prove/verify/constant_arguments.h"
#include "transpiler/prove/verify/unit_environment.h"
#include "transpiler/prove/verify/verified_program.h"
#include "transpiler/symbolic/execute/execute.h"
#include "transpiler/symbolic/solver/solver.h"
#include "transpiler/symbolic/solver/sweep.h"

namespace plcxx::prove::verify {

/// What is done with calls of functions that are proved; the first is the cheapest, the last finds differences.
enum class Callees : uint8_t { kReplacedInOrder, kReplacedByArguments, kFollowed };

/// What is done with loops of which it is not known how often they go round.
enum class Loops : uint8_t {
  kInStep,      // one round stands for each (loop_relation.h); where calls are replaced in order, as kFirstRounds
  kUnrolled,    // as often as they may go round
  kFirstRounds  // what goes round more often is left out: finds differences, proves nothing
};

struct Treatment {
  Callees callees{};
  Loops loops{};
  DroppedGuesses dropped;
  bool is_glance = false;  // only what is seen soon
};

class UnitVerifier {
 public:
  /// `workplace` outlives the verifier.
  UnitVerifier(const VerifiedProgram& program, Workplace& workplace, const Unit& unit, const ArgumentCase& given,
               const Treatment& treatment)
      : program_(program),
        workplace_(workplace),
        unit_(unit),
        given_(given),
        treatment_(treatment),
        routine_(program.ir.routines[unit.part.routine]),
        image_(program.image) {}

  RoutineProof Run();
  /// Not decided, and looking into what it calls, or at it in its callers, would not help.
  bool gave_up() const { return gave_up_; }
  /// A loop was not executed as often as it may go round.
  bool has_loops() const { return has_loops_; }
  /// No execution gives a greater result, read without a sign; none: the unit has no result, or was not executed.
  std::optional<uint64_t> greatest_result() const { return greatest_result_; }
  /// What was guessed of loops and is not so.
  const std::vector<std::string>& refuted() const { return refuted_; }

 private:
  struct Question {
    std::string what;
    solver::TermPair pair;  // the IR's, the code's
    terms::TermId given;    // where it is asked; none: everywhere
    std::string guess;      // of which it is; may be none
    /// What must not happen, and that rounds which were left out are none: no value of the program.
    enum class Of : uint8_t { kValue, kObligation, kLeftOut } of = Of::kValue;
  };

  /// A chunk or subroutine: it works on its caller's locals.
  bool is_inner() const { return unit_.part.region.valid() || emit::SharesLocals(routine_.kind); }
  bool is_init() const { return !is_inner() && routine_.kind == ir::RoutineKind::kInit; }
  uint32_t locals_begin() const { return image_.size() + program_.cells.CallCells(); }
  uint32_t MostRounds() const;
  execute::Environment MakeEnvironment(solver::Solver& solver);
  /// Of width 1; false where the solver does not say so soon.
  bool NeverHolds(solver::Solver& solver, terms::TermId condition) const;
  void Observe(execute::Memory& memory, ir::HostFunctionId function, terms::TermId when);
  terms::TermId InitialSlot(uint32_t slot);
  terms::TermId CellBefore(execute::CellId cell);
  /// What is not read again after the unit.
  bool IsDead(uint32_t slot) const;
  terms::TermId LeftOut(const CodeOutcome& outcome);
  void NoteFault(terms::TermId when, terms::TermId code);
  void AskAboutFaults(const CodeOutcome& outcome, terms::TermId given);
  void MakeArguments();
  void CheckFootprint(const execute::Memory& memory) const;
  std::string ExecuteProgram(execute::Memory& memory);
  CodeOutcome ExecuteCode(solver::Solver& solver);
  void AskAboutCalls(const std::string& what, terms::TermId given, const solver::TermPair& calls);
  void Ask(execute::Memory& memory, const CodeOutcome& outcome);
  /// What is given everywhere after loops.
  terms::TermId GivenAtEnd(const CodeOutcome& outcome);
  /// Both where `given` holds, and 0 elsewhere.
  solver::TermPair Where(terms::TermId given, const solver::TermPair& pair);
  solver::TermPair Asked(const Question& question);
  /// Whether the two are one operation of operands that are equal where it is asked (operand_pairs.h).
  bool HaveEqualOperands(solver::Solver& solver, const Question& question, const solver::SweepLimits& limits);
  std::vector<solver::Verdict> Compare(solver::Solver& solver, std::span<const Question> questions);
  /// Whether what is claimed of loops is so.
  bool DecideLoops(solver::Solver& solver);
  /// Why the unit is not decided, and of which statement the claim's loop is.
  void SayOfLoop(std::string reason, const LoopClaim& claim);
  void SayOfRounds();
  void Decide(solver::Solver& solver);
  /// Numbers for which the two differ, evaluated; without values: none were found.
  CodeDifference Show(solver::Solver& solver, const Question& question);
  std::vector<terms::TermId> VariablesOf(const solver::TermPair& pair) const;

  const VerifiedProgram& program_;
  Workplace& workplace_;
  const Unit& unit_;
  const ArgumentCase& given_;
  const Treatment& treatment_;
  const ir::Routine& routine_;
  StateImage image_;
  terms::Terms terms_;
  terms::TermId now_, hash_;
  terms::TermId faulted_, open_faults_;  // all, and those at which the code's language leaves something open, too
  std::vector<CodeArgument> arguments_;
  std::vector<terms::TermId> values_, references_;  // of the arguments, in the unit's order
  std::vector<uint32_t> slots_;                     // of the references
  std::vector<terms::TermId> local_bytes_;
  std::unique_ptr<Replaced> replaced_;
  std::unique_ptr<LoopRelation> relation_;
  execute::LoopPolicy policy_;
  std::vector<Question> questions_;
  RoutineProof proof_;
  std::vector<std::string> refuted_;
  std::optional<uint64_t> greatest_result_;
  bool gave_up_ = false, has_loops_ = false;
};

}  // namespace plcxx::prove::verify
