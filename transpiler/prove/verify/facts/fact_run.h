// One execution of one function of a program in its checked flavour, and which of its facts hold in it.
//
// In: a unit (a partition, a subroutine, a chunk), and whether its calls are followed or are anything. Out: a verdict
// for each fact that execution may reach. Of loops that do not end after a known number of iterations an arbitrary
// iteration is executed (verify/loop_relation.h): candidates for what its words have in common are claimed and shown,
// or dropped. Not its job: which function to look at next (facts.cc).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/prove/verify/facts/facts.h"
#include "transpiler/prove/verify/loop_relation.h"
#include "transpiler/prove/verify/units.h"
#include "transpiler/symbolic/execute/execute.h"
#include "transpiler/symbolic/solver/answered.h"
#include "transpiler/symbolic/solver/deadline.h"
#include "transpiler/symbolic/solver/solver.h"

namespace plcxx::prove::verify::facts {

struct CheckedProgram {
  explicit CheckedProgram(const emit::Emittable& checked)
      : emittable(checked),
        ir(*checked.program),
        cells(execute::MakeCells(ir)),
        image(ir, checked.layout, cells),
        units(verify::MakeUnits(checked, cells)) {}

  const emit::Emittable& emittable;
  const ir::Program& ir;
  execute::Cells cells;
  verify::StateImage image;
  verify::Units units;
  std::unique_ptr<solver::AnsweredForms> answered = std::make_unique<solver::AnsweredForms>();
};

enum class Calls : uint8_t { kAnything, kFollowed };

/// What one execution shows of one fact. Not listed: execution does not come to it.
struct Shown {
  ir::InstId call;
  FactResult result = FactResult::kProved;
  std::string reason;
  uint64_t value = 0;
  std::optional<Violation> violation;  // of kViolated in a routine that the control calls
};

class FactRun {
 public:
  /// `deadline` outlives the run.
  FactRun(const CheckedProgram& program, const verify::Unit& unit, Calls calls, const FactLimits& limits,
          const solver::Deadline& deadline)
      : program_(program), unit_(unit), calls_(calls), limits_(limits), deadline_(deadline) {}

  std::vector<Shown> Run();
  /// Why nothing is shown; empty: it is.
  const std::string& refusal() const { return refusal_; }

 private:
  struct Question {
    ir::InstId call;
    terms::TermId when, value;
    size_t given;  // noted by the relation
    bool in_loop;  // in an arbitrary iteration: a state there need not be one that is reached
  };
  struct Attempt;

  /// One attempt with the candidates that are left; false: some of them were refuted, and are dropped now.
  bool Try(std::vector<Shown>& shown);
  bool AreClaimsShown(Attempt& attempt);
  std::vector<Shown> Decide(Attempt& attempt);
  Shown Show(Attempt& attempt, const Question& question, terms::TermId wrong);
  /// A part that works on its caller's locals.
  bool is_inner() const;

  const CheckedProgram& program_;
  const verify::Unit& unit_;
  Calls calls_;
  const FactLimits& limits_;
  const solver::Deadline& deadline_;
  verify::DroppedGuesses dropped_;
  std::string refusal_;
};

}  // namespace plcxx::prove::verify::facts
