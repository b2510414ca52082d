#include "transpiler/dialects/nc110/lowering/host_calls.h"

#include "transpiler/ir/host_functions.h"

namespace plcxx::nc110 {

const std::vector<dialects::HostRow<HostCall>>& HostRows() {
  static const std::vector<dialects::HostRow<HostCall>> rows = {
      {.call = HostCall::kNow,
       .name = "now_ms",
       .routine_exchange = true,
       .comment = "Monotonic time in ms; it may wrap. Latched once at the start of each period.",
       .result = ir::Type::kI32},
      {.call = HostCall::kReadInputs,
       .name = "read_inputs",
       .access = ir::HostAccess::kWritesState,
       .routine_exchange = true,
       .comment =
           "Start of each period: fill the input connectors of package A, the NC -> PLC signals of packages K and N, "
           "and what else the control writes."},
      {.call = HostCall::kWriteOutputs,
       .name = "write_outputs",
       .access = ir::HostAccess::kReadsState,
       .routine_exchange = true,
       .comment =
           "End of each period: deliver the output connectors of package A and the PLC -> NC signals of packages K "
           "and N."},
      {.call = HostCall::kRetentiveLoad,
       .name = "retentive_load",
       .access = ir::HostAccess::kWritesRetentive,
       .routine_exchange = true,
       .comment = "At power-on: fill package T with the image stored last; leave it alone if there is none."},
      {.call = HostCall::kRetentiveStore,
       .name = "retentive_store",
       .access = ir::HostAccess::kReadsRetentive,
       .comment = "Store package T: U10K0 (machine off, retention enabled) or U10N4 (request of the program) rose."},
      {.call = HostCall::kFault,
       .name = ir::kFaultFunction,
       .comment = "A diagnostic that never stops the logic. Index: the counter's number (PARAM_RANGE), otherwise the "
                  "statement's id as the map lists it.",
       .parameters = {{.name = "kind",
                       .type = ir::Type::kI8,
                       .enumerators = {"PARAM_RANGE", "LOOP_LIMIT", "BCD_RANGE", "BIN_DIGIT"}},
                      {.name = "index", .type = ir::Type::kI32, .enumerators = {}}}},
  };
  return rows;
}

}  // namespace plcxx::nc110
