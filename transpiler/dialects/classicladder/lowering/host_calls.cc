#include "transpiler/dialects/classicladder/lowering/host_calls.h"

#include "transpiler/ir/host_functions.h"

namespace plcxx::classicladder {

const std::vector<dialects::HostRow<HostCall>>& HostRows() {
  static const std::vector<dialects::HostRow<HostCall>> rows = {
      {.call = HostCall::kReadInputs,
       .name = "read_inputs",
       .access = ir::HostAccess::kWritesState,
       .routine_exchange = true,
       .comment = "At the start of each period: fill %I, %IW and %IF. Floats lose what is behind the point."},
      {.call = HostCall::kWriteOutputs,
       .name = "write_outputs",
       .access = ir::HostAccess::kReadsState,
       .routine_exchange = true,
       .comment = "At the end of each period: deliver %Q, %QW and %QF."},
      {.call = HostCall::kFault,
       .name = ir::kFaultFunction,
       .comment = "JUMP_LOOP: a section has jumped 99999 times, and the program stands still from the next period on. "
                  "INDEX: an indexed variable leads out of its memory. DIVISION: by 0. The last two end the process of "
                  "LinuxCNC's engine, or spoil its memory; here what is read is 0, and nothing is written.",
       .parameters = {{.name = "code", .type = ir::Type::kI8, .enumerators = {"JUMP_LOOP", "INDEX", "DIVISION"}}}},
  };
  return rows;
}

}  // namespace plcxx::classicladder
