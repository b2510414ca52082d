#include "transpiler/prove/properties/condition.h"

#include <algorithm>
#include <map>
#include <utility>

namespace plcxx::prove {
namespace {

constexpr uint8_t kWide = 64;  // of numbers that are compared

/// One more, up to `most`.
TermId CountedOn(Terms& terms, TermId count, TermId most) {
  return terms.Ite(terms.Eq(count, most), count, terms.Add(count, terms.Const(1, terms.Width(count))));
}

class Meaning {
 public:
  Meaning(Terms& terms, const Property& property, const ValueAfter& value, CountPeriods count = {})
      : terms_(terms), property_(property), value_(value), count_(std::move(count)) {}

  TermId Holds(uint32_t index, uint32_t period) {
    const Condition& condition = property_.conditions[index];
    const std::vector<uint32_t>& children = condition.children;
    switch (condition.kind) {
      case ConditionKind::kOperand:
      case ConditionKind::kNumber:
        return terms_.Ne(Number(index, period), terms_.Const(0, kWide));
      case ConditionKind::kNot:
        return terms_.Not(Holds(children[0], period));
      case ConditionKind::kAnd: {
        TermId all = terms_.Bit(true);
        for (const uint32_t child : children) all = terms_.And(all, Holds(child, period));
        return all;
      }
      case ConditionKind::kOr: {
        TermId any = terms_.Bit(false);
        for (const uint32_t child : children) any = terms_.Or(any, Holds(child, period));
        return any;
      }
      case ConditionKind::kEqual:
        return terms_.Eq(Number(children[0], period), Number(children[1], period));
      case ConditionKind::kLess:
        return terms_.Slt(Number(children[0], period), Number(children[1], period));
      case ConditionKind::kRange: {
        const TermId number = Number(children[0], period);
        return terms_.And(terms_.Sle(Constant(condition.low), number), terms_.Sle(number, Constant(condition.high)));
      }
      case ConditionKind::kAtMostOne:
        return terms_.Not(Count(children, period).two);
      case ConditionKind::kExactlyOne: {
        const Counted count = Count(children, period);
        return terms_.And(count.one, terms_.Not(count.two));
      }
      case ConditionKind::kHeld: {
        if (count_) return HeldByCounting(index);
        if (period < condition.periods) return terms_.Bit(false);
        TermId all = terms_.Bit(true);
        for (uint32_t back = 0; back < condition.periods; ++back)
          all = terms_.And(all, Holds(children[0], period - back));
        return all;
      }
    }
    PLCXX_UNREACHABLE();
  }

 private:
  struct Counted {
    TermId one, two;  // at least so many hold
  };

  TermId HeldByCounting(uint32_t index) {
    const Condition& condition = property_.conditions[index];
    const auto known = held_.find(index);
    if (known != held_.end()) return known->second;
    const TermId holds = Holds(condition.children[0], 1);
    TermId most;
    const TermId length = count_(condition.periods, [&](TermId before) {
      const uint8_t width = terms_.Width(before);
      most = terms_.Const(condition.periods, width);
      return terms_.Ite(holds, CountedOn(terms_, before, most), terms_.Const(0, width));
    });
    return held_[index] = terms_.Eq(length, most);
  }

  TermId Constant(int64_t value) { return terms_.Const(static_cast<uint64_t>(value), kWide); }

  TermId Number(uint32_t index, uint32_t period) {
    const Condition& condition = property_.conditions[index];
    if (condition.kind == ConditionKind::kNumber) return Constant(condition.low);
    const PropertyOperand& operand = property_.operands[condition.operand];
    const TermId value = ValueOf(terms_, operand, period, value_);
    return operand.has_sign && !operand.is_bit ? terms_.Sext(value, kWide) : terms_.Zext(value, kWide);
  }

  Counted Count(const std::vector<uint32_t>& children, uint32_t period) {
    Counted count{terms_.Bit(false), terms_.Bit(false)};
    for (const uint32_t child : children) {
      const TermId holds = Holds(child, period);
      count.two = terms_.Or(count.two, terms_.And(count.one, holds));
      count.one = terms_.Or(count.one, holds);
    }
    return count;
  }

  Terms& terms_;
  const Property& property_;
  const ValueAfter& value_;
  CountPeriods count_;               // none: periods are looked at one by one
  std::map<uint32_t, TermId> held_;  // by condition
};

uint32_t WindowOf(const Property& property, uint32_t index) {
  const Condition& condition = property.conditions[index];
  uint32_t window = 1;
  for (const uint32_t child : condition.children) window = std::max(window, WindowOf(property, child));
  return condition.kind == ConditionKind::kHeld ? window + condition.periods - 1 : window;
}

}  // namespace

TermId ValueOf(Terms& terms, const PropertyOperand& operand, uint32_t period, const ValueAfter& value) {
  TermId number;
  for (const CellId cell : operand.cells) {
    const TermId part = value(cell, period);
    number = number.valid() ? terms.Concat(part, number) : part;
  }
  if (!number.valid()) return terms.Const(0, operand.width);
  const int rest = terms.Width(number) - operand.low_bit;
  if (rest < operand.width) return terms.Resize(terms.Zext(number, operand.width), operand.width);
  return terms.Extract(number, operand.low_bit, operand.width);
}

TermId HoldsAfter(Terms& terms, const Property& property, uint32_t period, const ValueAfter& value) {
  Meaning meaning(terms, property, value);
  if (property.kind == PropertyKind::kAlways) return meaning.Holds(property.condition, period);
  // What was asked for in the first of these periods must have come by now.
  if (period < property.periods) return terms.Bit(true);
  const uint32_t asked = period - property.periods + 1;
  TermId fine = terms.Not(meaning.Holds(property.condition, asked));
  for (uint32_t answer = asked; answer <= period; ++answer)
    fine = terms.Or(fine, meaning.Holds(property.consequence, answer));
  return fine;
}

TermId HoldsByCounting(Terms& terms, const Property& property, const std::function<TermId(CellId cell)>& value,
                       const CountPeriods& count) {
  const ValueAfter after = [&value](CellId cell, uint32_t) { return value(cell); };
  Meaning meaning(terms, property, after, count);
  const TermId condition = meaning.Holds(property.condition, 1);
  if (property.kind == PropertyKind::kAlways) return condition;
  const TermId answered = meaning.Holds(property.consequence, 1);
  if (property.periods == 1) return terms.Or(terms.Not(condition), answered);
  // The age of the oldest question that is open, the period in which it was asked included.
  TermId most;
  const TermId age = count(property.periods, [&](TermId before) {
    const uint8_t width = terms.Width(before);
    const TermId none = terms.Const(0, width), one = terms.Const(1, width);
    most = terms.Const(property.periods, width);
    const TermId open =
        terms.Ite(terms.Ne(before, none), CountedOn(terms, before, most), terms.Ite(condition, one, none));
    return terms.Ite(answered, none, open);
  });
  return terms.Ne(age, most);
}

uint32_t WindowOf(const Property& property) {
  const uint32_t condition = WindowOf(property, property.condition);
  if (property.kind != PropertyKind::kResponse) return condition;
  return property.periods - 1 + std::max(condition, WindowOf(property, property.consequence));
}

}  // namespace plcxx::prove
