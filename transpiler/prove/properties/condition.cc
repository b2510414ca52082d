#include "transpiler/prove/properties/condition.h"

#include <algorithm>
#include <map>
#include <utility>

namespace plcxx::prove::properties {
namespace {

constexpr uint8_t kWide = 64;  // of numbers that are compared

/// One more, up to `most`.
terms::TermId CountedOn(terms::Terms& terms, terms::TermId count, terms::TermId most) {
  return terms.Ite(terms.Eq(count, most), count, terms.Add(count, terms.Const(1, terms.Width(count))));
}

class Meaning {
 public:
  Meaning(terms::Terms& terms, const Property& property, const ValueAfter& value, CountPeriods count = {})
      : terms_(terms), property_(property), value_(value), count_(std::move(count)) {}

  terms::TermId Holds(uint32_t index, uint32_t period) {
    const Condition& condition = property_.conditions[index];
    const std::vector<uint32_t>& children = condition.children;
    switch (condition.kind) {
      case ConditionKind::kOperand:
      case ConditionKind::kNumber:
        return terms_.Ne(Number(index, period), terms_.Const(0, kWide));
      case ConditionKind::kNot:
        return terms_.Not(Holds(children[0], period));
      case ConditionKind::kAnd: {
        terms::TermId all = terms_.Bit(true);
        for (const uint32_t child : children) all = terms_.And(all, Holds(child, period));
        return all;
      }
      case ConditionKind::kOr: {
        terms::TermId any = terms_.Bit(false);
        for (const uint32_t child : children) any = terms_.Or(any, Holds(child, period));
        return any;
      }
      case ConditionKind::kEqual:
        return terms_.Eq(Number(children[0], period), Number(children[1], period));
      case ConditionKind::kLess:
        return terms_.Slt(Number(children[0], period), Number(children[1], period));
      case ConditionKind::kRange: {
        const terms::TermId number = Number(children[0], period);
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
        terms::TermId all = terms_.Bit(true);
        for (uint32_t back = 0; back < condition.periods; ++back)
          all = terms_.And(all, Holds(children[0], period - back));
        return all;
      }
    }
    PLCXX_UNREACHABLE();
  }

 private:
  struct Counted {
    terms::TermId one, two;  // at least so many hold
  };

  terms::TermId HeldByCounting(uint32_t index) {
    const Condition& condition = property_.conditions[index];
    const auto known = held_.find(index);
    if (known != held_.end()) return known->second;
    const terms::TermId holds = Holds(condition.children[0], 1);
    terms::TermId most;
    const terms::TermId length = count_(condition.periods, [&](terms::TermId before) {
      const uint8_t width = terms_.Width(before);
      most = terms_.Const(condition.periods, width);
      return terms_.Ite(holds, CountedOn(terms_, before, most), terms_.Const(0, width));
    });
    return held_[index] = terms_.Eq(length, most);
  }

  terms::TermId Constant(int64_t value) { return terms_.Const(static_cast<uint64_t>(value), kWide); }

  terms::TermId Number(uint32_t index, uint32_t period) {
    const Condition& condition = property_.conditions[index];
    if (condition.kind == ConditionKind::kNumber) return Constant(condition.low);
    const PropertyOperand& operand = property_.operands[condition.operand];
    const terms::TermId value = ValueOf(terms_, operand, period, value_);
    return operand.has_sign && !operand.is_bit ? terms_.Sext(value, kWide) : terms_.Zext(value, kWide);
  }

  Counted Count(const std::vector<uint32_t>& children, uint32_t period) {
    Counted count{terms_.Bit(false), terms_.Bit(false)};
    for (const uint32_t child : children) {
      const terms::TermId holds = Holds(child, period);
      count.two = terms_.Or(count.two, terms_.And(count.one, holds));
      count.one = terms_.Or(count.one, holds);
    }
    return count;
  }

  terms::Terms& terms_;
  const Property& property_;
  const ValueAfter& value_;
  CountPeriods count_;                      // none: periods are looked at one by one
  std::map<uint32_t, terms::TermId> held_;  // by condition
};

uint32_t WindowOf(const Property& property, uint32_t index) {
  const Condition& condition = property.conditions[index];
  uint32_t window = 1;
  for (const uint32_t child : condition.children) window = std::max(window, WindowOf(property, child));
  return condition.kind == ConditionKind::kHeld ? window + condition.periods - 1 : window;
}

}  // namespace

terms::TermId ValueOf(terms::Terms& terms, const PropertyOperand& operand, uint32_t period, const ValueAfter& value) {
  terms::TermId number;
  for (const execute::CellId cell : operand.cells) {
    const terms::TermId part = value(cell, period);
    number = number.valid() ? terms.Concat(part, number) : part;
  }
  if (!number.valid()) return terms.Const(0, operand.width);
  const int rest = terms.Width(number) - operand.low_bit;
  if (rest < operand.width) return terms.Resize(terms.Zext(number, operand.width), operand.width);
  return terms.Extract(number, operand.low_bit, operand.width);
}

terms::TermId HoldsAfter(terms::Terms& terms, const Property& property, uint32_t period, const ValueAfter& value) {
  Meaning meaning(terms, property, value);
  if (property.kind == PropertyKind::kAlways) return meaning.Holds(property.condition, period);
  // What was asked for in the first of these periods must have come by now.
  if (period < property.periods) return terms.Bit(true);
  const uint32_t asked = period - property.periods + 1;
  terms::TermId fine = terms.Not(meaning.Holds(property.condition, asked));
  for (uint32_t answer = asked; answer <= period; ++answer)
    fine = terms.Or(fine, meaning.Holds(property.consequence, answer));
  return fine;
}

terms::TermId HoldsByCounting(terms::Terms& terms, const Property& property,
                              const std::function<terms::TermId(execute::CellId cell)>& value,
                              const CountPeriods& count) {
  const ValueAfter after = [&value](execute::CellId cell, uint32_t) { return value(cell); };
  Meaning meaning(terms, property, after, count);
  const terms::TermId condition = meaning.Holds(property.condition, 1);
  if (property.kind == PropertyKind::kAlways) return condition;
  const terms::TermId answered = meaning.Holds(property.consequence, 1);
  if (property.periods == 1) return terms.Or(terms.Not(condition), answered);
  // The age of the oldest question that is open, the period in which it was asked included.
  terms::TermId most;
  const terms::TermId age = count(property.periods, [&](terms::TermId before) {
    const uint8_t width = terms.Width(before);
    const terms::TermId none = terms.Const(0, width), one = terms.Const(1, width);
    most = terms.Const(property.periods, width);
    const terms::TermId open =
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

}  // namespace plcxx::prove::properties
