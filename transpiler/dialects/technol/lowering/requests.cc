#include "transpiler/dialects/technol/lowering/requests.h"

#include <iterator>
#include <utility>

#include "transpiler/dialects/technol/lowering/cell_places.h"
#include "transpiler/support/check.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

constexpr uint64_t kRequestDone = 1;  // of the results of request()

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

bool Requests::CanRequest(std::string_view bit) const {
  const Symbol* symbol = cells_.Find(bit);
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

void Requests::CheckNcTable(const std::function<void(std::vector<ValueId>)>& transfer) {
  const auto field = [&](size_t number, Type type) {
    const Symbol* symbol = cells_.Find(NcTableFields()[number]);
    PLCXX_CHECK(symbol != nullptr);
    return builder_.Load(cells_.Cell(Area::kSetNctab, static_cast<uint32_t>(symbol->value), type,
                                     "SET_NCTAB_" + NcTableFields()[number]));
  };
  const ValueId version = field(0, Type::kI8), mode = field(1, Type::kI8), table = field(2, Type::kI8),
                column = field(3, Type::kI8), row = field(4, Type::kI8), data = field(5, Type::kI32);
  const auto is_table = [&](const NcTable& known) {
    return Pure(OpKind::kEqual8, {table, builder_.Byte(known.number)});
  };
  const auto outside = [&](ValueId value, uint64_t low, uint64_t high) {
    const ValueId above = Pure(OpKind::kGreater8, {value, builder_.Byte(high)});
    return low == 0 ? above : Pure(OpKind::kBitOr, {Pure(OpKind::kLess8, {value, builder_.Byte(low)}), above});
  };
  /// Whether what `bad` tells of the table holds for the one that is named.
  const auto in_its_table = [&](const std::function<ValueId(const NcTable&)>& bad) {
    ValueId any;
    for (const NcTable& known : kNcTables) {
      const ValueId here = Pure(OpKind::kBitAnd, {is_table(known), bad(known)});
      any = any.valid() ? Pure(OpKind::kBitOr, {any, here}) : here;
    }
    return any;
  };
  const std::function<ValueId()> bad[] = {
      [&] { return Pure(OpKind::kNotEqual8, {version, builder_.Byte(1)}); },
      [&] { return outside(mode, 0, 1); },
      [&] {
        ValueId none;
        for (const NcTable& known : kNcTables) {
          const ValueId other = Pure(OpKind::kNotEqual8, {table, builder_.Byte(known.number)});
          none = none.valid() ? Pure(OpKind::kBitAnd, {none, other}) : other;
        }
        return none;
      },
      [&] { return in_its_table([&](const NcTable& known) { return outside(column, 1, known.last_column); }); },
      [&] { return in_its_table([&](const NcTable& known) { return outside(row, known.first_row, known.last_row); }); },
      [&] {
        const ValueId digits = Pure(OpKind::kAnd32, {data, builder_.Constant(Type::kI32, 0x7FFFFFFF, 16)});
        return Pure(OpKind::kHasNoDigit32, {digits});
      }};
  const std::function<void(size_t)> check = [&](size_t number) {
    if (number == std::size(bad)) return transfer({version, mode, table, column, row, data});
    builder_.Choose(
        bad[number](), [&] { host_(HostCall::kNcTableRefused, {builder_.Byte(number)}); }, [&] { check(number + 1); });
  };
  check(0);
}

void Requests::Serve() {
  for (size_t i = 0; i < std::size(kRequests); ++i) {
    const RequestRow& row = kRequests[i];
    if (!CanRequest(row.bit)) continue;
    const ir::PlaceId bit = cells_.System(row.bit);
    const auto ask = [&] {
      const ValueId result = host_(HostCall::kRequest, {builder_.Byte(i)});
      builder_.When(Pure(OpKind::kEqual8, {result, builder_.Byte(kRequestDone)}),
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
