#include "transpiler/checks/checks.h"

namespace plcxx::checks {

void RunAll(const ir::Program& program, const diag::Lints& lints, diag::Engine& diagnostics) {
  const std::vector<PartAccesses> parts = CollectAccesses(program);
  const Context context{program, parts, diagnostics};
  const auto run = [&](auto* check, const diag::Message<diag::Text>* message) {
    if (message != nullptr && diagnostics.Enabled(message->row)) check(context, *message);
  };
  run(&DrivenInBothParts, lints.driven_in_both_parts);
  run(&DrivenTwice, lints.driven_twice);
  run(&ReadNeverDriven, lints.read_never_driven);
  run(&SlicedCarryRead, lints.sliced_carry_read);
  run(&WrittenInBothParts, lints.written_in_both_parts);
  run(&DoubleCoil, lints.double_coil);
  run(&DeadStore, lints.dead_store);
}

}  // namespace plcxx::checks
