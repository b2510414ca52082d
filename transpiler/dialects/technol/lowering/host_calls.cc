#include "transpiler/dialects/technol/lowering/host_calls.h"

#include "transpiler/ir/host_functions.h"

namespace plcxx::technol {

using ir::HostAccess;
using ir::Type;

namespace {

using Rows = std::vector<dialects::HostRow<HostCall>>;

const std::vector<std::string>& RequestNames() {
  static const std::vector<std::string> names = {"SEND_PLCMEM", "SEND_TABTECH", "SEND_NCTAB",
                                                 "BACKUP_POS",  "BACKUP_MEM",   "CLOSE_ALL"};
  return names;
}

/// What is exchanged around a pass and at power-on.
Rows ExchangeRows() {
  return {
      {.call = HostCall::kReadInputs,
       .name = "read_inputs",
       .access = HostAccess::kWritesState,
       .routine_exchange = true,
       .comment = "Before each slow pass: fill IN0 to IN63, MATTL, UPS_STAT, UPS_FAULT; set bits of SYSNC."},
      {.call = HostCall::kWriteOutputs,
       .name = "write_outputs",
       .access = HostAccess::kReadsState,
       .routine_exchange = true,
       .comment = "Behind each slow pass: OUT0 to OUT63, UPS_CMD, BZH11, BZH21, BZH22."},
      {.call = HostCall::kMachineConstants,
       .name = "machine_constants",
       .access = HostAccess::kWritesState,
       .routine_exchange = true,
       .comment = "At power-on: fill BUKON00 to BUKON99 with the machine constants, packed BCD with a sign."},
      {.call = HostCall::kRestore,
       .name = "restore",
       .access = HostAccess::kWritesRetentive,
       .routine_exchange = true,
       .comment =
           "At power-on: fill LABEL_MEM and TAB_TECHNOL with the copy saved last; leave them alone if there is none."},
  };
}

/// What the program asks the control to do, by bits that stand until it is done.
Rows RequestRows() {
  return {
      {.call = HostCall::kRequest,
       .name = "request",
       .comment =
           "Behind each slow pass for each request that stands: 0 busy, 1 done, 2 failed. Done clears the request.",
       .result = Type::kI8,
       .parameters = {{"id", Type::kI8, RequestNames()}},
       .polled = true},
      {.call = HostCall::kSendPlcmem,
       .name = "send_plcmem",
       .access = HostAccess::kReadsRetentive,
       .comment = "Right before request(SEND_PLCMEM): archive LABEL_MEM.",
       .polled = true},
      {.call = HostCall::kSendTabtech,
       .name = "send_tabtech",
       .access = HostAccess::kReadsRetentive,
       .comment = "Right before request(SEND_TABTECH): write TAB_TECHNOL back to its table.",
       .polled = true},
      {.call = HostCall::kSetNcTable,
       .name = "set_nc_table",
       .comment = "Right before request(SEND_NCTAB): set one item of an NC table; the arguments are valid.",
       .parameters = {{"ver", Type::kI8, {}},
                      {"mode", Type::kI8, {}},
                      {"table", Type::kI8, {}},
                      {"column", Type::kI8, {}},
                      {"row", Type::kI8, {}},
                      {"bcd", Type::kI32, {}}},
       .polled = true},
      {.call = HostCall::kNcTableRefused,
       .name = "nc_table_refused",
       .comment = "Instead of request(SEND_NCTAB), which has failed: the first field of SET_NCTAB that is not valid.",
       .parameters = {{"field", Type::kI8, NcTableFields()}},
       .polled = true},
      {.call = HostCall::kBackupPos,
       .name = "backup_pos",
       .comment = "Right before request(BACKUP_POS): save the positions of the axes.",
       .polled = true},
      {.call = HostCall::kBackupMem,
       .name = "backup_mem",
       .access = HostAccess::kReadsRetentive,
       .comment = "Right before request(BACKUP_MEM): save LABEL_MEM and TAB_TECHNOL.",
       .polled = true},
      {.call = HostCall::kCloseAll,
       .name = "close_all",
       .comment = "Right before request(CLOSE_ALL): close all files.",
       .polled = true},
  };
}

/// What the control is told, and answers nothing to.
Rows NoticeRows() {
  return {
      {.call = HostCall::kHaltPass,
       .name = "halt_pass",
       .comment = "In each slow pass in which MODULE_HALT has run.",
       .polled = true},
      {.call = HostCall::kErrorRaised,
       .name = "error_raised",
       .comment = "An ESET has been executed.",
       .parameters = {{"main", Type::kI8, {}}, {"sub", Type::kI8, {}}}},
      {.call = HostCall::kFault,
       .name = ir::kFaultFunction,
       .comment = "A fault in a statement (the map file tells its line). Execution goes on.",
       .parameters = {{"kind", Type::kI8, {"BOUNDS", "LOOP", "DIVIDE", "BCD_RANGE", "BCD_DIGIT"}},
                      {.name = "statement", .type = Type::kI32, .enumerators = {}, .is_statement = true}}},
  };
}

}  // namespace

const std::vector<std::string>& NcTableFields() {
  static const std::vector<std::string> names = {"NCTAB_VERZE",   "NCTAB_MOD",   "NCTAB_TAB",
                                                 "NCTAB_SLOUPEC", "NCTAB_RADEK", "NCTAB_DATA"};
  return names;
}

const std::vector<dialects::HostRow<HostCall>>& HostRows() {
  static const Rows rows = [] {
    Rows all = ExchangeRows();
    for (const Rows& further : {RequestRows(), NoticeRows()}) all.insert(all.end(), further.begin(), further.end());
    return all;
  }();
  return rows;
}

}  // namespace plcxx::technol
