// The functions by which a program reaches its host, and the requests (specification 8.1 to 8.4).

#include "transpiler/dialects/technol/lowering_internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

struct HostRow {
  HostCall call;
  std::string_view name;
  std::vector<ir::Parameter> parameters;
  Type result = Type::kNone;
  ir::HostAccess access = ir::HostAccess::kNone;
  bool routine_exchange = false;
  bool polled = false;
  std::string_view comment;
};

constexpr uint64_t kDone = 1;  // of the results of request()

const std::vector<std::string>& RequestNames() {
  static const std::vector<std::string> names = {"SEND_PLCMEM", "SEND_TABTECH", "SEND_NCTAB",
                                                 "BACKUP_POS",  "BACKUP_MEM",   "CLOSE_ALL"};
  return names;
}

const std::vector<HostRow>& HostRows() {
  using ir::HostAccess;
  static const std::vector<HostRow> rows = {
      {HostCall::kReadInputs,
       "read_inputs",
       {},
       Type::kNone,
       HostAccess::kWritesState,
       true,
       false,
       "Before each slow pass: fill IN0 to IN63, MATTL, UPS_STAT, UPS_FAULT; set bits of SYSNC."},
      {HostCall::kWriteOutputs,
       "write_outputs",
       {},
       Type::kNone,
       HostAccess::kReadsState,
       true,
       false,
       "Behind each slow pass: OUT0 to OUT63, UPS_CMD, BZH11, BZH21, BZH22."},
      {HostCall::kMachineConstants,
       "machine_constants",
       {},
       Type::kNone,
       HostAccess::kWritesState,
       true,
       false,
       "At power-on: fill BUKON00 to BUKON99 with the machine constants, packed BCD with a sign."},
      {HostCall::kRestore,
       "restore",
       {},
       Type::kNone,
       HostAccess::kWritesRetentive,
       true,
       false,
       "At power-on: fill LABEL_MEM and TAB_TECHNOL with the copy saved last; leave them alone if there is none."},
      {HostCall::kRequest,
       "request",
       {{"id", Type::kI8, RequestNames()}},
       Type::kI8,
       HostAccess::kNone,
       false,
       true,
       "Behind each slow pass for each request that stands: 0 busy, 1 done, 2 failed. Done clears the request."},
      {HostCall::kSendPlcmem,
       "send_plcmem",
       {},
       Type::kNone,
       HostAccess::kReadsRetentive,
       false,
       true,
       "Right before request(SEND_PLCMEM): archive LABEL_MEM."},
      {HostCall::kSendTabtech,
       "send_tabtech",
       {},
       Type::kNone,
       HostAccess::kReadsRetentive,
       false,
       true,
       "Right before request(SEND_TABTECH): write TAB_TECHNOL back to its table."},
      {HostCall::kSetNcTable,
       "set_nc_table",
       {{"ver", Type::kI8, {}},
        {"mode", Type::kI8, {}},
        {"table", Type::kI8, {}},
        {"column", Type::kI8, {}},
        {"row", Type::kI8, {}},
        {"bcd", Type::kI32, {}}},
       Type::kNone,
       HostAccess::kNone,
       false,
       true,
       "Right before request(SEND_NCTAB): set one item of an NC table; the arguments are valid."},
      {HostCall::kBackupPos,
       "backup_pos",
       {},
       Type::kNone,
       HostAccess::kNone,
       false,
       true,
       "Right before request(BACKUP_POS): save the positions of the axes."},
      {HostCall::kBackupMem,
       "backup_mem",
       {},
       Type::kNone,
       HostAccess::kReadsRetentive,
       false,
       true,
       "Right before request(BACKUP_MEM): save LABEL_MEM and TAB_TECHNOL."},
      {HostCall::kCloseAll,
       "close_all",
       {},
       Type::kNone,
       HostAccess::kNone,
       false,
       true,
       "Right before request(CLOSE_ALL): close all files."},
      {HostCall::kHaltPass,
       "halt_pass",
       {},
       Type::kNone,
       HostAccess::kNone,
       false,
       true,
       "In each slow pass in which MODULE_HALT has run."},
      {HostCall::kErrorRaised,
       "error_raised",
       {{"main", Type::kI8, {}}, {"sub", Type::kI8, {}}},
       Type::kNone,
       HostAccess::kNone,
       false,
       false,
       "An ESET has been executed."},
      {HostCall::kFault,
       "fault",
       {{"kind", Type::kI8, {"BOUNDS", "LOOP", "DIVIDE", "BCD_RANGE", "BCD_DIGIT"}},
        {.name = "statement", .type = Type::kI32, .enumerators = {}, .is_statement = true}},
       Type::kNone,
       HostAccess::kNone,
       false,
       false,
       "A fault in a statement (the map file tells its line). Execution goes on."},
  };
  return rows;
}

struct RequestRow {
  std::string_view bit;
  HostCall data;
};
/// In the order of their bits, and of the names above.
constexpr RequestRow kRequests[] = {
    {"REQ_SEND_PLCMEM", HostCall::kSendPlcmem}, {"REQ_SEND_TABTECH", HostCall::kSendTabtech},
    {"REQ_SEND_NCTAB", HostCall::kSetNcTable},  {"REQ_BACKUP_POS", HostCall::kBackupPos},
    {"REQ_BACKUP_MEM", HostCall::kBackupMem},   {"REQ_CLOSE_ALL", HostCall::kCloseAll}};

/// The tables of 5.5: where their columns and rows begin and end.
struct NcTable {
  uint64_t number, last_column, first_row, last_row;
};
constexpr NcTable kNcTables[] = {{1, 5, 1, 99}, {2, 6, 53, 59}, {6, 1, 0, 95}};

}  // namespace

void Lowering::AddHostFunctions() {
  for (const HostRow& row : HostRows()) {
    host_[static_cast<size_t>(row.call)] = program_.host_functions.Add({.name = std::string(row.name),
                                                                        .parameters = row.parameters,
                                                                        .result = row.result,
                                                                        .access = row.access,
                                                                        .routine_exchange = row.routine_exchange,
                                                                        .polled = row.polled,
                                                                        .comment = std::string(row.comment)});
  }
}

ValueId Lowering::CallHost(HostCall call, std::vector<ValueId> arguments) {
  return builder_.CallHost(host_[static_cast<size_t>(call)], std::move(arguments));
}

void Lowering::CallFault(Fault fault) {
  const ValueId kind = Byte(static_cast<uint64_t>(fault));
  CallHost(HostCall::kFault, {kind, Number(program_.statements[statement_].id)});
}

/// Whether the program can set a request: by its bit, its byte, or an index.
bool Lowering::CanRequest(std::string_view bit) const {
  const Symbol* symbol = FindSymbol(bit);
  if (symbol == nullptr) return false;
  for (uint32_t i = 0; i < tree_.instructions.size(); ++i) {
    const Instruction& instruction = tree_.instructions[InstructionId(i)];
    const InstructionInfo& info = Info(instruction.op);
    if (info.first == Access::kNone || info.first == Access::kRead) continue;
    for (uint32_t k = 0; k < instruction.operands.count; ++k) {
      const Operand& operand = tree_.OperandOf(instruction, k);
      const Address& address = operand.address;
      if (address.area != symbol->area) continue;
      if (operand.kind == OperandKind::kBit && address.offset == symbol->offset && operand.bit == symbol->bit)
        return true;
      if (operand.kind != OperandKind::kMemory) continue;
      const bool holds = address.offset <= symbol->offset && symbol->offset < address.offset + operand.width / 8;
      if (address.index != Register::kNone || holds) return true;
    }
  }
  return false;
}

/// The arguments as 8.4 wants them.
ValueId Lowering::ValidNcTable() {
  const auto field = [&](std::string_view name, uint32_t width) {
    const Symbol* symbol = FindSymbol(name);
    PLCXX_CHECK(symbol != nullptr);
    const auto offset = static_cast<uint32_t>(symbol->value);
    return builder_.Load(
        CellPlace(Area::kSetNctab, offset, width == 8 ? Type::kI8 : Type::kI32, "SET_NCTAB_" + std::string(name)));
  };
  const auto is = [&](ValueId value, uint64_t wanted) { return Pure(OpKind::kEqual8, {value, Byte(wanted)}); };
  const auto within = [&](ValueId wide, uint64_t low, uint64_t high) {
    const ValueId below = Pure(OpKind::kLessEqual32, {wide, Number(high)});
    if (low == 0) return below;
    return Pure(OpKind::kBitAnd, {Pure(OpKind::kGreaterEqual32, {wide, Number(low)}), below});
  };
  const auto both = [&](ValueId a, ValueId b) { return Pure(OpKind::kBitAnd, {a, b}); };
  const ValueId version = field("NCTAB_VERZE", 8), mode = field("NCTAB_MOD", 8), table = field("NCTAB_TAB", 8),
                column = field("NCTAB_SLOUPEC", 8), row = field("NCTAB_RADEK", 8), data = field("NCTAB_DATA", 32);
  const ValueId wide_column = ToWidth(column, 32), wide_row = ToWidth(row, 32);
  ValueId place;
  for (const NcTable& known : kNcTables) {
    const ValueId fits = both(is(table, known.number), both(within(wide_column, 1, known.last_column),
                                                            within(wide_row, known.first_row, known.last_row)));
    place = place.valid() ? Pure(OpKind::kBitOr, {place, fits}) : fits;
  }
  const ValueId digits = Pure(OpKind::kAnd32, {data, builder_.Constant(Type::kI32, 0x7FFFFFFF, 16)});
  const ValueId numbers = Not(Pure(OpKind::kHasNoDigit32, {digits}));
  nc_table_arguments_ = {version, mode, table, column, row, data};
  return both(both(is(version, 1), within(ToWidth(mode, 32), 0, 1)), both(place, numbers));
}

/// Behind the outputs: each request that stands is given its data and asked for (8.2).
void Lowering::Requests() {
  builder_.SetRegion(program_.routines[requests_].body);
  for (size_t i = 0; i < std::size(kRequests); ++i) {
    const RequestRow& row = kRequests[i];
    if (!CanRequest(row.bit)) continue;
    const ir::PlaceId bit = SystemPlace(row.bit);
    const auto ask = [&] {
      const ValueId result = CallHost(HostCall::kRequest, {Byte(i)});
      When(Pure(OpKind::kEqual8, {result, Byte(kDone)}), [&] { builder_.Store(bit, builder_.Bit(0)); });
    };
    When(builder_.Load(bit), [&] {
      if (row.data != HostCall::kSetNcTable) {
        CallHost(row.data);
        return ask();
      }
      // What is not valid is not handed on, and the request stays.
      When(ValidNcTable(), [&] {
        CallHost(row.data, nc_table_arguments_);
        ask();
      });
    });
  }
}

}  // namespace plcxx::technol
