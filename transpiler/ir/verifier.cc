#include "transpiler/ir/verifier.h"

#include "transpiler/ir/verifier_state.h"

namespace plcxx::ir {

Verifier::Verifier(const Program& verified, Stage at)
    : program(verified),
      stage(at),
      region_owned(verified.regions.size()),
      region_open(verified.regions.size()),
      body_open(verified.insts.size()),
      marked(verified.statements.size()),
      position(verified.insts.size()),
      home(verified.insts.size()),
      callees(verified.routines.size()) {}

void Verifier::Report(const Inst& inst, const std::string& finding) {
  std::string where = program.routines[routine].name;
  if (statement.valid()) {
    where += ", statement " + std::to_string(statement.index);
    const std::string& subject = program.statements[statement].subject;
    if (!subject.empty()) where += " (" + subject + ")";
  }
  findings.push_back(where + ", " + std::string(Info(inst.op).text) + ": " + finding);
}

std::vector<std::string> Verify(const Program& program, Stage stage) {
  Verifier verifier(program, stage);
  verifier.VerifyMemory();
  // The walk looks up places and states by the ids in instructions; it does not look into broken declarations.
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    verifier.routine = RoutineId(i);
    verifier.statement = {};
    verifier.VerifyRoutine(program.routines[verifier.routine]);
  }
  verifier.VerifySchedule();
  verifier.VerifyCallGraph();
  verifier.VerifyStatements();
  return std::move(verifier.findings);
}

}  // namespace plcxx::ir
