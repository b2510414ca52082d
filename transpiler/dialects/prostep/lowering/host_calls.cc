#include "transpiler/dialects/prostep/lowering/host_calls.h"

#include "transpiler/ir/host_functions.h"

namespace plcxx::prostep {

using ir::Type;

const std::vector<dialects::HostRow<HostCall>>& HostRows() {
  static const std::vector<dialects::HostRow<HostCall>> rows = {
      {.call = HostCall::kNow,
       .name = "now_ms",
       .routine_exchange = true,
       .comment = "Time since power-on in ms.",
       .result = Type::kI32},
      {.call = HostCall::kReadPort,
       .name = "read_port",
       .comment =
           "A byte of direct inputs: 0 to 23 (inputs 8 n + 1 to 8 n + 8), 100 to 131 extra cards (ports 340H to 35FH).",
       .result = Type::kI8,
       .parameters = {{"port", Type::kI32, {}}}},
      {.call = HostCall::kWritePort,
       .name = "write_port",
       .comment = "A byte of direct outputs: 0 to 11, 100 to 131 extra cards.",
       .parameters = {{"port", Type::kI32, {}}, {"value", Type::kI8, {}}}},
      {.call = HostCall::kNcRead,
       .name = "nc_read",
       .comment = "FM 41, 42, 44: a system variable of 1, 2 or 4 bytes; offset is signed. False: there is none.",
       .result = Type::kBit,
       .parameters = {{"width", Type::kI32, {}}, {"index", Type::kI16, {}}, {"offset", Type::kI16, {}}},
       .out = {.name = "value", .type = Type::kI32, .enumerators = {}}},
      {.call = HostCall::kNcWrite,
       .name = "nc_write",
       .comment = "FM 51, 52, 54: as nc_read; the value has no bits above its width.",
       .result = Type::kBit,
       .parameters = {{"width", Type::kI32, {}},
                      {"index", Type::kI16, {}},
                      {"offset", Type::kI16, {}},
                      {"value", Type::kI32, {}}}},
      {.call = HostCall::kNcToPlc,
       .name = "nc_to_plc",
       .access = ir::HostAccess::kWritesState,
       .routine_exchange = true,
       .comment = "In each tick before the interrupt modules: the NC sets its signals in I, F and D."},
      {.call = HostCall::kPlcToNc,
       .name = "plc_to_nc",
       .access = ir::HostAccess::kWritesState,
       .routine_exchange = true,
       .comment = "In each tick behind the output refresh: the NC looks at the signals in O and F, and clears "
                  "handshake bits."},
      {.call = HostCall::kRetentiveLoad,
       .name = "retentive_load",
       .access = ir::HostAccess::kWritesRetentive,
       .routine_exchange = true,
       .comment =
           "At power-on: fill the retentive block with the copy saved at power-off; leave it alone if there is none."},
      {.call = HostCall::kFault,
       .name = ir::kFaultFunction,
       .comment = "A fault in module PM pm. It never stops the PLC.",
       .parameters = {{"code", Type::kI8, {"div_zero", "div_overflow", "index", "nc_access", "loop_budget"}},
                      {"pm", Type::kI32, {}}}},
  };
  return rows;
}

}  // namespace plcxx::prostep
