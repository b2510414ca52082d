#include "transpiler/prove/verify/operand_pairs.h"

#include <algorithm>
#include <array>
#include <utility>

#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/division.h"

namespace plcxx::prove::verify {
namespace {

constexpr size_t kMostPairs = 8;
constexpr size_t kMostOpen = 64;

/// The operands of two operations that are the same but for these; empty: they are not the same.
std::vector<solver::TermPair> Operands(const terms::Terms& terms, const solver::TermPair& pair) {
  const terms::Term a = terms[pair.a], b = terms[pair.b];
  if (a.kind != b.kind || a.width != b.width) return {};
  if (a.kind == terms::TermKind::kExtract && a.b != b.b) return {};
  if (a.kind == terms::TermKind::kApply && (a.a != b.a || a.c != b.c)) return {};
  std::vector<terms::TermId> of_a, of_b;
  terms.ForEachOperand(a, [&](terms::TermId operand) { of_a.push_back(operand); });
  terms.ForEachOperand(b, [&](terms::TermId operand) { of_b.push_back(operand); });
  // The factors of a product are in the order in which they were made.
  if (a.kind == terms::TermKind::kMul && (of_a[0] == of_b[1] || of_a[1] == of_b[0])) std::swap(of_b[0], of_b[1]);
  std::vector<solver::TermPair> operands;
  for (size_t i = 0; i < of_a.size(); ++i) {
    if (terms.Width(of_a[i]) != terms.Width(of_b[i])) return {};
    operands.push_back({of_a[i], of_b[i]});
  }
  return operands;
}

/// Of the terms that are in one of two, those in which something is multiplied or divided.
class LaboriousTerms {
 public:
  LaboriousTerms(const terms::Terms& terms, const solver::TermPair& pair) : is_one_(terms.size()) {
    for (const terms::TermId id : terms::ConeOf(terms, std::array{pair.a, pair.b})) {
      bool is_one = terms::IsLaborious(terms[id].kind);
      terms.ForEachOperand(terms[id], [&](terms::TermId operand) { is_one = is_one || is_one_[operand.index]; });
      is_one_[id.index] = is_one;
    }
  }
  bool Has(terms::TermId id) const { return is_one_[id.index]; }

 private:
  std::vector<bool> is_one_;
};

/// c ? x : y beside y, as what a call is given where the other side does not come to it: x and y where c holds.
void TakeOffChoices(terms::Terms& terms, PairWhere& asked) {
  for (int side = 0; side < 2; ++side) {
    for (terms::Term whole = terms[asked.pair.a]; whole.kind == terms::TermKind::kIte; whole = terms[asked.pair.a]) {
      const bool is_otherwise = terms::TermId(whole.c) == asked.pair.b;
      if (!is_otherwise && terms::TermId(whole.b) != asked.pair.b) break;
      const terms::TermId condition(whole.a);
      asked.given = terms.And(asked.given, is_otherwise ? condition : terms.Not(condition));
      asked.pair.a = terms::TermId(is_otherwise ? whole.b : whole.c);
    }
    std::swap(asked.pair.a, asked.pair.b);
  }
}

}  // namespace

std::vector<PairWhere> OperandPairs(terms::Terms& terms, const PairWhere& asked, Choices choices) {
  const LaboriousTerms laborious(terms, asked.pair);
  if (!laborious.Has(asked.pair.a) || !laborious.Has(asked.pair.b)) return {};
  std::vector<PairWhere> open = {asked}, pairs;
  bool is_less = false;  // a product or a quotient is not asked about
  for (size_t i = 0; i < open.size(); ++i) {
    PairWhere next = open[i];
    TakeOffChoices(terms, next);
    if (next.pair.a == next.pair.b) continue;
    const terms::TermKind kind = terms[next.pair.a].kind;
    const bool is_left = kind == terms::TermKind::kIte && choices == Choices::kAsked;
    const std::vector<solver::TermPair> all =
        is_left || !laborious.Has(next.pair.a) ? std::vector<solver::TermPair>() : Operands(terms, next.pair);
    if (all.empty()) {
      if (pairs.size() == kMostPairs) return {};
      pairs.push_back(next);
      continue;
    }
    is_less = is_less || terms::IsLaborious(kind);
    if (open.size() + all.size() > kMostOpen) return {};
    for (const solver::TermPair& operands : all) {
      const auto is_known = [&](const PairWhere& one) {
        return one.pair.a == operands.a && one.pair.b == operands.b && one.given == next.given;
      };
      if (std::ranges::none_of(open, is_known)) open.push_back({operands, next.given});
    }
  }
  return is_less ? pairs : std::vector<PairWhere>();
}

}  // namespace plcxx::prove::verify
