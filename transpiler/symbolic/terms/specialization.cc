#include "transpiler/symbolic/terms/specialization.h"

#include <algorithm>
#include <array>

#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::terms {
namespace {

constexpr size_t kMostDependent = 50'000;
constexpr uint32_t kDeepest = 2000;  // operands of operands: Of goes as deep

}  // namespace

Specialization::Specialization(Terms& terms, TermId term, const std::vector<IndexBit>& bits)
    : terms_(terms), term_(term), bits_(bits) {
  const std::array roots = {term};
  for (const TermId id : ConeAboveFunctions(terms_, roots)) {
    const bool is_leaf = std::ranges::find(bits_, id, &IndexBit::of) != bits_.end();
    const Term& part = terms_[id];
    uint32_t depth = is_leaf ? 1 : 0;
    if (!is_leaf && part.kind != TermKind::kApply) {
      terms_.ForEachOperand(part, [&](TermId operand) {
        const auto below = dependent_.find(operand.index);
        if (below != dependent_.end()) depth = std::max(depth, below->second + 1);
      });
    }
    if (depth == 0) continue;
    dependent_.emplace(id.index, depth);
    if (depth <= kDeepest && dependent_.size() <= kMostDependent) continue;
    dependent_.clear();
    return;
  }
}

TermId Specialization::Where(uint32_t ones, uint32_t zeros) {
  if (dependent_.empty() || (ones | zeros) == 0) return term_;
  known_.clear();
  for (size_t i = 0; i < bits_.size();) {
    // The word of which these are bits, from its lowest bit on.
    const TermId leaf = bits_[i].of;
    TermId word;
    for (uint8_t bit = 0; bit < terms_.Width(leaf); ++bit) {
      TermId one = terms_.Extract(leaf, bit, 1);
      if (i < bits_.size() && bits_[i] == IndexBit{leaf, bit}) {
        if (((ones | zeros) >> i & 1) != 0) one = terms_.Bit((ones >> i & 1) != 0);
        ++i;
      }
      word = word.valid() ? terms_.Concat(one, word) : one;
    }
    known_.emplace(leaf.index, word);
  }
  return Of(term_);
}

TermId Specialization::Of(TermId id) {
  if (const auto known = known_.find(id.index); known != known_.end()) return known->second;
  if (!dependent_.contains(id.index)) return id;
  const Term term = terms_[id];
  TermId now;
  if (term.kind == TermKind::kIte) {
    const TermId condition = Of(TermId(term.a));
    if (terms_.IsConst(condition)) {
      now = Of(TermId(terms_.IsTrue(condition) ? term.b : term.c));
    } else {
      const TermId then = Of(TermId(term.b));
      now = terms_.Ite(condition, then, Of(TermId(term.c)));
    }
  } else {
    std::vector<TermId> operands;
    terms_.ForEachOperand(term, [&](TermId operand) { operands.push_back(operand); });
    for (TermId& operand : operands) operand = Of(operand);
    now = terms_.Rebuild(term, operands);
  }
  known_.emplace(id.index, now);
  return now;
}

TermId WhereKnown(Terms& terms, TermId term, const KnownIndexBits& known) {
  if (known.bits.empty()) return term;
  return Specialization(terms, term, known.bits).Where(known.ones, known.zeros);
}

}  // namespace plcxx::terms
