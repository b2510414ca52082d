// The functions by which a program reaches its host, and the requests (specification 8.1 to 8.4).

#include <utility>

#include "transpiler/dialects/technol/lowering/internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

constexpr uint64_t kRequestDone = 1;  // of the results of request()

const std::vector<std::string>& RequestNames() {
  static const std::vector<std::string> names = {"SEND_PLCMEM", "SEND_TABTECH", "SEND_NCTAB",
                                                 "BACKUP_POS",  "BACKUP_MEM",   "CLOSE_ALL"};
  return names;
}

/// In the order of SET_NCTAB (5.5).
const std::vector<std::string>& NcTableFields() {
  static const std::vector<std::string> names = {"NCTAB_VERZE",   "NCTAB_MOD",   "NCTAB_TAB",
                                                 "NCTAB_SLOUPEC", "NCTAB_RADEK", "NCTAB_DATA"};
  return names;
}

const std::vector<dialects::HostRow<HostCall>>& HostRows() {
  using ir::HostAccess;
  static const std::vector<dialects::HostRow<HostCall>> rows = {
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
      {.call = HostCall::kHaltPass,
       .name = "halt_pass",
       .comment = "In each slow pass in which MODULE_HALT has run.",
       .polled = true},
      {.call = HostCall::kErrorRaised,
       .name = "error_raised",
       .comment = "An ESET has been executed.",
       .parameters = {{"main", Type::kI8, {}}, {"sub", Type::kI8, {}}}},
      {.call = HostCall::kFault,
       .name = "fault",
       .comment = "A fault in a statement (the map file tells its line). Execution goes on.",
       .parameters = {{"kind", Type::kI8, {"BOUNDS", "LOOP", "DIVIDE", "BCD_RANGE", "BCD_DIGIT"}},
                      {.name = "statement", .type = Type::kI32, .enumerators = {}, .is_statement = true}}},
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

void Lowering::AddHostFunctions() { host_.Add(HostRows()); }

void Lowering::CallFault(Fault fault) {
  const ValueId kind = builder_.Byte(static_cast<uint64_t>(fault));
  host_(HostCall::kFault, {kind, builder_.Number(program_.statements[statement_].id)});
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

void Lowering::CheckNcTable(const std::function<void(std::vector<ValueId>)>& transfer) {
  const auto field = [&](size_t number, Type type) {
    const Symbol* symbol = FindSymbol(NcTableFields()[number]);
    PLCXX_CHECK(symbol != nullptr);
    return builder_.Load(
        CellPlace(Area::kSetNctab, static_cast<uint32_t>(symbol->value), type, "SET_NCTAB_" + NcTableFields()[number]));
  };
  const ValueId version = field(0, Type::kI8), mode = field(1, Type::kI8), table = field(2, Type::kI8),
                column = field(3, Type::kI8), row = field(4, Type::kI8), data = field(5, Type::kI32);
  const auto is_table = [&](const NcTable& known) {
    return builder_.Pure(OpKind::kEqual8, {table, builder_.Byte(known.number)});
  };
  const auto outside = [&](ValueId value, uint64_t low, uint64_t high) {
    const ValueId above = builder_.Pure(OpKind::kGreater8, {value, builder_.Byte(high)});
    return low == 0
               ? above
               : builder_.Pure(OpKind::kBitOr, {builder_.Pure(OpKind::kLess8, {value, builder_.Byte(low)}), above});
  };
  /// Whether what `bad` tells of the table holds for the one that is named.
  const auto in_its_table = [&](const std::function<ValueId(const NcTable&)>& bad) {
    ValueId any;
    for (const NcTable& known : kNcTables) {
      const ValueId here = builder_.Pure(OpKind::kBitAnd, {is_table(known), bad(known)});
      any = any.valid() ? builder_.Pure(OpKind::kBitOr, {any, here}) : here;
    }
    return any;
  };
  const std::function<ValueId()> bad[] = {
      [&] { return builder_.Pure(OpKind::kNotEqual8, {version, builder_.Byte(1)}); },
      [&] { return outside(mode, 0, 1); },
      [&] {
        ValueId none;
        for (const NcTable& known : kNcTables) {
          const ValueId other = builder_.Pure(OpKind::kNotEqual8, {table, builder_.Byte(known.number)});
          none = none.valid() ? builder_.Pure(OpKind::kBitAnd, {none, other}) : other;
        }
        return none;
      },
      [&] { return in_its_table([&](const NcTable& known) { return outside(column, 1, known.last_column); }); },
      [&] { return in_its_table([&](const NcTable& known) { return outside(row, known.first_row, known.last_row); }); },
      [&] {
        const ValueId digits = builder_.Pure(OpKind::kAnd32, {data, builder_.Constant(Type::kI32, 0x7FFFFFFF, 16)});
        return builder_.Pure(OpKind::kHasNoDigit32, {digits});
      }};
  const std::function<void(size_t)> check = [&](size_t number) {
    if (number == std::size(bad)) return transfer({version, mode, table, column, row, data});
    builder_.Choose(
        bad[number](), [&] { host_(HostCall::kNcTableRefused, {builder_.Byte(number)}); }, [&] { check(number + 1); });
  };
  check(0);
}

/// Behind the outputs: each request that stands is given its data and asked for (8.2).
void Lowering::Requests() {
  builder_.SetRegion(program_.routines[requests_].body);
  for (size_t i = 0; i < std::size(kRequests); ++i) {
    const RequestRow& row = kRequests[i];
    if (!CanRequest(row.bit)) continue;
    const ir::PlaceId bit = SystemPlace(row.bit);
    const auto ask = [&] {
      const ValueId result = host_(HostCall::kRequest, {builder_.Byte(i)});
      builder_.When(builder_.Pure(OpKind::kEqual8, {result, builder_.Byte(kRequestDone)}),
                    [&] { builder_.Store(bit, builder_.Bit(0)); });
    };
    builder_.When(builder_.Load(bit), [&] {
      if (row.data != HostCall::kSetNcTable) {
        host_(row.data);
        return ask();
      }
      // What is not valid is not handed on, and the request stays (8.4).
      CheckNcTable([&](std::vector<ValueId> arguments) {
        host_(row.data, std::move(arguments));
        ask();
      });
    });
  }
}

}  // namespace plcxx::technol
