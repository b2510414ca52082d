#include "transpiler/soak/moment_logic.h"

#include <algorithm>
#include <vector>

#include "transpiler/support/check.h"

namespace plcxx::soak {
namespace {

using ir::OpKind;
using prove::properties::Condition;
using prove::properties::ConditionKind;
using prove::properties::Property;
using prove::properties::PropertyKind;
using prove::properties::PropertyOperand;

/// A number in two's complement, the least significant bit first; the last one is its sign.
using Bits = std::vector<ir::ValueId>;

class LogicWriter {
 public:
  LogicWriter(ir::Builder& builder, const execute::Cells& cells, const Property& property)
      : builder_(builder), cells_(cells), property_(property) {}

  ir::ValueId Bit(uint32_t number) {
    const Condition& condition = property_.conditions[number];
    const auto child = [&](size_t i) { return condition.children[i]; };
    switch (condition.kind) {
      case ConditionKind::kOperand:
        return Number(number).front();
      case ConditionKind::kNumber:
        return builder_.Bit(condition.low != 0 ? 1 : 0);
      case ConditionKind::kNot:
        return Not(Bit(child(0)));
      case ConditionKind::kAnd:
        return All(condition, OpKind::kBitAnd);
      case ConditionKind::kOr:
        return All(condition, OpKind::kBitOr);
      case ConditionKind::kEqual:
        return Equal(Number(child(0)), Number(child(1)));
      case ConditionKind::kLess:
        return Less(Number(child(0)), Number(child(1)));
      case ConditionKind::kRange: {
        const Bits value = Number(child(0));
        const ir::ValueId below = Less(value, Constant(condition.low)), above = Less(Constant(condition.high), value);
        return Not(Pure(OpKind::kBitOr, below, above));
      }
      case ConditionKind::kAtMostOne:
        return Not(Ones(condition).two);
      case ConditionKind::kExactlyOne: {
        const Counted ones = Ones(condition);
        return Pure(OpKind::kBitAnd, ones.one, Not(ones.two));
      }
      case ConditionKind::kHeld:
        break;
    }
    PLCXX_UNREACHABLE();  // IsOfOneMoment says no
  }

 private:
  ir::ValueId Pure(OpKind op, ir::ValueId a, ir::ValueId b) { return builder_.Pure(op, {a, b}); }
  ir::ValueId Not(ir::ValueId a) { return builder_.Pure(OpKind::kBitNot, {a}); }

  ir::ValueId All(const Condition& condition, OpKind op) {
    ir::ValueId all = Bit(condition.children.front());
    for (size_t i = 1; i < condition.children.size(); ++i) all = Pure(op, all, Bit(condition.children[i]));
    return all;
  }

  /// Whether at least one, at least two of the children are 1.
  struct Counted {
    ir::ValueId one, two;
  };
  Counted Ones(const Condition& condition) {
    Counted ones{.one = builder_.Bit(0), .two = builder_.Bit(0)};
    for (const uint32_t child : condition.children) {
      const ir::ValueId bit = Bit(child);
      ones.two = Pure(OpKind::kBitOr, ones.two, Pure(OpKind::kBitAnd, ones.one, bit));
      ones.one = Pure(OpKind::kBitOr, ones.one, bit);
    }
    return ones;
  }

  ir::ValueId LoadCell(execute::CellId id) {
    const execute::Cell cell = execute::CellAt(builder_.program(), cells_, id);
    ir::Place place;
    place.name = "watched";
    place.space = cell.space;
    place.offset = cell.offset;
    place.bit = cell.bit;
    return builder_.Load(builder_.program().places.Add(std::move(place)));
  }

  Bits Number(uint32_t number) {
    const Condition& condition = property_.conditions[number];
    if (condition.kind == ConditionKind::kNumber) return Constant(condition.low);
    if (condition.kind != ConditionKind::kOperand) return {Bit(number), builder_.Bit(0)};
    const PropertyOperand& operand = property_.operands[condition.operand];
    Bits bits;
    for (uint8_t i = 0; i < operand.width; ++i) {
      const size_t at = size_t{operand.low_bit} + i;
      bits.push_back(at < operand.cells.size() ? LoadCell(operand.cells[at]) : builder_.Bit(0));
    }
    if (!operand.has_sign || operand.is_bit) bits.push_back(builder_.Bit(0));
    return bits;
  }

  Bits Constant(int64_t value) {
    Bits bits;
    const int64_t sign = value < 0 ? -1 : 0;
    for (;; value >>= 1) {
      bits.push_back(builder_.Bit(static_cast<uint64_t>(value) & 1));
      if (value == sign) return bits;
    }
  }

  ir::ValueId Equal(Bits a, Bits b) {
    Widen(a, b);
    ir::ValueId differs = builder_.Bit(0);
    for (size_t i = 0; i < a.size(); ++i) differs = Pure(OpKind::kBitOr, differs, Pure(OpKind::kBitXor, a[i], b[i]));
    return Not(differs);
  }

  ir::ValueId Less(Bits a, Bits b) {
    Widen(a, b);
    // Of the signs the greater one is the less number.
    std::swap(a.back(), b.back());
    ir::ValueId less = builder_.Bit(0);
    for (size_t i = 0; i < a.size(); ++i) {
      const ir::ValueId here = Pure(OpKind::kBitAnd, Not(a[i]), b[i]);
      const ir::ValueId before = Pure(OpKind::kBitAnd, Not(Pure(OpKind::kBitXor, a[i], b[i])), less);
      less = Pure(OpKind::kBitOr, here, before);
    }
    return less;
  }

  static void Widen(Bits& a, Bits& b) {
    const size_t width = std::max(a.size(), b.size());
    a.resize(width, a.back());
    b.resize(width, b.back());
  }

  ir::Builder& builder_;
  const execute::Cells& cells_;
  const Property& property_;
};

}  // namespace

bool IsOfOneMoment(const ir::Program& program, const execute::Cells& cells, const Property& property) {
  const bool is_implication = property.kind == PropertyKind::kResponse && property.periods == 1;
  if (property.kind != PropertyKind::kAlways && !is_implication) return false;
  const auto is_held = [](const Condition& condition) { return condition.kind == ConditionKind::kHeld; };
  const auto is_bit = [&](execute::CellId id) {
    return execute::CellAt(program, cells, id).kind == execute::CellKind::kBit;
  };
  return std::ranges::none_of(property.conditions, is_held) &&
         std::ranges::all_of(property.operands, [&](const PropertyOperand& operand) {
           return std::ranges::all_of(operand.cells, is_bit);
         });
}

ir::ValueId HoldsNow(ir::Builder& builder, const execute::Cells& cells, const Property& property) {
  LogicWriter writer(builder, cells, property);
  const ir::ValueId condition = writer.Bit(property.condition);
  if (property.kind == PropertyKind::kAlways) return condition;
  const ir::ValueId not_asked = builder.Pure(OpKind::kBitNot, {condition});
  return builder.Pure(OpKind::kBitOr, {not_asked, writer.Bit(property.consequence)});
}

}  // namespace plcxx::soak
