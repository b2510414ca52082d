#include "tests/reference/host50_machine.h"

#include <bit>
#include <string>
#include <utility>

#include "transpiler/dialects/host50/parser/parser.h"

namespace plcxx::reference {

using namespace host50;           // the syntax tree
using namespace host50_elements;  // section 7

namespace {

float FloatOf(uint32_t bits) { return std::bit_cast<float>(bits); }
uint32_t BitsOf(float value) { return std::bit_cast<uint32_t>(value); }

using Value = Host50Value;
Value Whole(int32_t value) { return {.whole = value}; }
Value Real(float value) { return {.is_float = true, .real = value}; }

template <class Number>
bool Related(ExprKind relation, Number a, Number b) {
  if (relation == ExprKind::kGreater) return a > b;
  if (relation == ExprKind::kLess) return a < b;
  if (relation == ExprKind::kGreaterEqual) return a >= b;
  if (relation == ExprKind::kLessEqual) return a <= b;
  if (relation == ExprKind::kEqual) return a == b;
  return a != b;
}
Value Negated(const Value& value) {
  return value.is_float ? Real(FloatOf(BitsOf(value.real) ^ 0x8000'0000)) : Whole(Wrap(-int64_t{value.whole}));
}

}  // namespace

bool Compare(ExprKind relation, const Value& a, const Value& b) {
  if (a.is_float || b.is_float) return Related(relation, a.AsFloat(), b.AsFloat());
  return Related(relation, a.whole, b.whole);
}

Host50Machine::Host50Machine(dialects::Request& request, HostCalls host)
    : Reference(std::move(host)),
      tree_(Parse(*request.sources, request.files, request.options, *request.diagnostics)),
      image_(memories_, tree_.settings.channels) {}

const Operand& Host50Machine::OperandOf(InstructionId id, uint32_t number) const {
  return tree_.operands[tree_.instructions[id].operands.first + number];
}

bool Host50Machine::Bit(const Operand& operand) const {
  if (operand.kind == OperandKind::kConstant) return operand.bits != 0;
  return Bit(operand.address);
}
bool Host50Machine::Bit(const Address& address) const {
  if (address.area == Area::kTm) return timers_[address.number].q;
  if (address.area == Area::kC) return counters_[address.number].q;
  return image_.Bit(address.area, address.number);
}

Value Host50Machine::Number(const Operand& operand) const {
  if (operand.kind == OperandKind::kConstant) {
    return operand.type == Type::kFloat ? Real(FloatOf(operand.bits)) : Whole(static_cast<int32_t>(operand.bits));
  }
  return Number(operand.address);
}
Value Host50Machine::Number(const Address& address) const {
  switch (address.area) {
    case Area::kW:
    case Area::kIw:
    case Area::kQw:
      return Whole(static_cast<int32_t>(image_.Unit(address.area, address.number)));
    case Area::kF:
    case Area::kIf:
    case Area::kQf:
      return Real(FloatOf(image_.Unit(address.area, address.number)));
    case Area::kTm:
      if (address.attribute == Attribute::kV) return Whole(timers_[address.number].value);
      if (address.attribute == Attribute::kP) return Whole(timers_[address.number].preset);
      return Whole(Bit(address) ? 1 : 0);
    case Area::kC:
      if (address.attribute == Attribute::kV) return Whole(counters_[address.number].value);
      if (address.attribute == Attribute::kP) return Whole(counters_[address.number].preset);
      return Whole(Bit(address) ? 1 : 0);
    case Area::kI:
    case Area::kQ:
    case Area::kB:
      return Whole(Bit(address) ? 1 : 0);
  }
  return {};
}

void Host50Machine::Store(const Operand& operand, const Value& value) {
  const Address address = operand.address;
  const bool to_float = address.area == Area::kF || address.area == Area::kIf || address.area == Area::kQf;
  if (to_float) {
    image_.SetUnit(address.area, address.number, BitsOf(value.AsFloat()));
    return;
  }
  const int32_t whole = value.is_float ? ToInteger(value.real, tree_.settings.ftow == FtowOption::kRound) : value.whole;
  if (address.area == Area::kC) {
    counters_[address.number].value = whole;
    PutBackForced();
  } else {
    image_.SetUnit(address.area, address.number, static_cast<uint32_t>(whole));
  }
}

Value Host50Machine::Evaluate(ExprId id) const {
  const Expr& expr = tree_.exprs[id];
  if (expr.kind == ExprKind::kConstant) {
    return expr.type == Type::kFloat ? Real(FloatOf(expr.bits)) : Whole(static_cast<int32_t>(expr.bits));
  }
  if (expr.kind == ExprKind::kAddress) return Number(expr.address);
  const Value left = Evaluate(expr.left);
  if (expr.kind == ExprKind::kNegate) return Negated(left);
  const Value right = Evaluate(expr.right);
  const bool real = left.is_float || right.is_float;
  const float a = left.AsFloat(), b = right.AsFloat();
  const int64_t x = left.whole, y = right.whole;
  if (expr.kind == ExprKind::kMultiply) return real ? Real(a * b) : Whole(Wrap(x * y));
  if (expr.kind == ExprKind::kDivide) return real ? Real(Divide(a, b)) : Whole(Divide(left.whole, right.whole));
  if (expr.kind == ExprKind::kAdd) return real ? Real(a + b) : Whole(Wrap(x + y));
  if (expr.kind == ExprKind::kSubtract) return real ? Real(a - b) : Whole(Wrap(x - y));
  if (expr.kind == ExprKind::kAnd) return Whole(left.whole & right.whole);
  return Whole(left.whole | right.whole);
}

void Host50Machine::RunBlock(InstructionId id, Op op) {
  const auto whole = [&](uint32_t i) { return Number(OperandOf(id, i)).whole; };
  const auto real = [&](uint32_t i) { return Number(OperandOf(id, i)).AsFloat(); };
  const auto store = [&](uint32_t i, Value value) { Store(OperandOf(id, i), value); };
  const auto bits = [&](uint32_t i) { return static_cast<uint32_t>(whole(i)); };
  switch (op) {
    case Op::kAddw:
      return store(2, Whole(Wrap(int64_t{whole(0)} + whole(1))));
    case Op::kSubw:
      return store(2, Whole(Wrap(int64_t{whole(0)} - whole(1))));
    case Op::kMulw:
      return store(2, Whole(Wrap(int64_t{whole(0)} * whole(1))));
    case Op::kDivw:
      return store(2, Whole(Divide(whole(0), whole(1))));
    case Op::kWand:
      return store(2, Whole(static_cast<int32_t>(bits(0) & bits(1))));
    case Op::kWor:
      return store(2, Whole(static_cast<int32_t>(bits(0) | bits(1))));
    case Op::kWxor:
      return store(2, Whole(static_cast<int32_t>(bits(0) ^ bits(1))));
    case Op::kAddf:
      return store(2, Real(real(0) + real(1)));
    case Op::kSubf:
      return store(2, Real(real(0) - real(1)));
    case Op::kMulf:
      return store(2, Real(real(0) * real(1)));
    case Op::kDivf:
      return store(2, Real(Divide(real(0), real(1))));
    case Op::kNeg:
      return store(0, Negated(Number(OperandOf(id, 0))));
    case Op::kMov:
    case Op::kFtow:
    case Op::kWtof:
      return store(1, Number(OperandOf(id, 0)));
    case Op::kBtow: {
      const Address field = OperandOf(id, 0).address;
      const uint32_t count = OperandOf(id, 2).bits;
      uint64_t value = 0;
      for (uint32_t i = 0; i < count; ++i) {
        value |= uint64_t{image_.Bit(field.area, field.number + i)} << i;
      }
      if (tree_.settings.btow == BtowOption::kKeep) value |= uint64_t{bits(1)} >> count << count;
      return store(1, Whole(static_cast<int32_t>(static_cast<uint32_t>(value))));
    }
    case Op::kWtob: {
      const Address field = OperandOf(id, 1).address;
      const uint32_t count = OperandOf(id, 2).bits, value = bits(0);
      for (uint32_t i = 0; i < count; ++i) image_.SetBit(field.area, field.number + i, (value >> i & 1) != 0);
      return;
    }
    case Op::kOprt:
      return store(0, Evaluate(OperandOf(id, 1).expr));
    default:
      Unsupported("instruction " + std::string(Info(op).name));
      return;
  }
}

}  // namespace plcxx::reference
