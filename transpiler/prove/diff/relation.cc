#include "transpiler/prove/diff/relation.h"

#include <algorithm>

namespace plcxx::prove::diff {
namespace {

using Value = std::function<terms::TermId(Which which, execute::CellId cell)>;

terms::TermId TermOf(terms::Terms& terms, const Number& number, const Value& value) {
  terms::TermId whole;
  for (const execute::CellId cell : number.cells) {
    const terms::TermId part = value(number.which, cell);
    whole = whole.valid() ? terms.Concat(whole, part) : part;
  }
  return terms.Extract(whole, number.low, number.width);
}

terms::TermId Unconditional(terms::Terms& terms, const Relation& relation, const Value& value) {
  const terms::TermId number = TermOf(terms, relation.number, value), other = TermOf(terms, relation.other, value);
  const auto is = [&terms](terms::TermId term, uint64_t constant) {
    return terms.Eq(term, terms.Const(constant, terms.Width(term)));
  };
  switch (relation.kind) {
    case Relation::Kind::kLinear: {
      const uint8_t width = terms.Width(number);
      const terms::TermId product = terms.Mul(terms.Resize(other, width), terms.Const(relation.factor, width));
      return terms.Eq(number, terms.Add(product, terms.Const(relation.constant, width)));
    }
    case Relation::Kind::kSum: {
      const uint8_t width = terms.Width(number);
      const terms::TermId sum =
          terms.Add(terms.Resize(other, width), terms.Resize(TermOf(terms, relation.third, value), width));
      return terms.Eq(number, terms.Add(sum, terms.Const(relation.constant, width)));
    }
    case Relation::Kind::kAmong: {
      terms::TermId holds = terms.Bit(false);
      for (const auto& [first, second] : relation.values)
        holds = terms.Or(holds, terms.And(is(number, first), is(other, second)));
      return holds;
    }
    case Relation::Kind::kIs:
    case Relation::Kind::kAtLeast: {
      const terms::TermId there = relation.kind == Relation::Kind::kIs
                                      ? is(other, relation.constant)
                                      : terms.Ule(terms.Const(relation.constant, terms.Width(other)), other);
      return terms.Eq(number, relation.is_inverted ? terms.Not(there) : there);
    }
  }
  return terms.Bit(true);
}

}  // namespace

terms::TermId ConditionOf(terms::Terms& terms, const Relation& relation, const Value& value) {
  terms::TermId holds = Unconditional(terms, relation, value);
  for (const auto& [number, is_set] : relation.whiles) {
    const terms::TermId bit = TermOf(terms, number, value);
    holds = terms.Or(is_set ? terms.Not(bit) : bit, holds);
  }
  return holds;
}

}  // namespace plcxx::prove::diff
