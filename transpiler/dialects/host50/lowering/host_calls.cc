#include "transpiler/dialects/host50/lowering/host_calls.h"

#include "transpiler/ir/host_functions.h"

namespace plcxx::host50 {

const std::vector<dialects::HostRow<HostCall>>& HostRows() {
  static const std::vector<dialects::HostRow<HostCall>> rows = {
      {.call = HostCall::kReadInputs,
       .name = "read_inputs",
       .access = ir::HostAccess::kWritesState,
       .routine_exchange = true,
       .comment = "In init and at the start of each tick: fill %I, %IW and %IF, all at once."},
      {.call = HostCall::kWriteOutputs,
       .name = "write_outputs",
       .access = ir::HostAccess::kReadsState,
       .routine_exchange = true,
       .comment = "At the end of each tick: deliver %Q, %QW and %QF."},
      {.call = HostCall::kRetentiveLoad,
       .name = "retentive_load",
       .access = ir::HostAccess::kWritesRetentive,
       .routine_exchange = true,
       .comment =
           "In init: fill %B0 to %B500, %W0 to %W100 and %F0 to %F100 as stored last; leave them alone if nothing is "
           "stored."},
      {.call = HostCall::kAlarm,
       .name = "alarm",
       .comment = "After write_outputs: an alarm bit, %Q400 + index, has changed.",
       .parameters = {{.name = "index", .type = ir::Type::kI32, .enumerators = {}},
                      {.name = "on", .type = ir::Type::kBit, .enumerators = {}}}},
      {.call = HostCall::kAxisCommand,
       .name = "axis_command",
       .comment =
           "An axis block starts, changes (active 1) or withdraws (active 0) its request. Axis: 0 to 9; position in mm "
           "or degrees; speed of HOME, POSA and POSM in units/min, of VELP and VELN in rev/min; 0 where the kind has "
           "none.",
       .parameters = {{.name = "axis", .type = ir::Type::kI32, .enumerators = {}},
                      {.name = "kind", .type = ir::Type::kI8, .enumerators = {"HOME", "POSA", "POSM", "VELP", "VELN"}},
                      {.name = "active", .type = ir::Type::kBit, .enumerators = {}},
                      {.name = "method", .type = ir::Type::kI32, .enumerators = {}},
                      {.name = "position", .type = ir::Type::kF32, .enumerators = {}},
                      {.name = "speed", .type = ir::Type::kF32, .enumerators = {}}}},
      {.call = HostCall::kFault,
       .name = ir::kFaultFunction,
       .comment =
           "A diagnostic that does not stop the program. Section: -2 FAST, -1 SLOW, else the number of the subroutine.",
       .parameters = {{.name = "code", .type = ir::Type::kI8, .enumerators = {"JUMP_LOOP", "ROT_RANGE", "AXIS_RANGE"}},
                      {.name = "section", .type = ir::Type::kI32, .enumerators = {}},
                      {.name = "network", .type = ir::Type::kI32, .enumerators = {}}}},
  };
  return rows;
}

}  // namespace plcxx::host50
