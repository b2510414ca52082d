#include "transpiler/symbolic/solver/counterparts.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace plcxx::solver {
namespace {

constexpr size_t kMostOperands = 64;  // of a chain of one operation

bool IsChain(terms::TermKind kind) {
  using enum terms::TermKind;
  return kind == kAnd || kind == kOr || kind == kXor || kind == kAdd || kind == kMul;
}

class Walk {
 public:
  Walk(const terms::Terms& terms, size_t most_pairs,
       const std::function<bool(terms::TermId, terms::TermId)>& may_be_equal)
      : terms_(terms), most_pairs_(most_pairs), may_be_equal_(may_be_equal) {}

  void From(const TermPair& pair) {
    Visit(pair.a, pair.b);
    while (!open_.empty()) {
      const TermPair next = open_.back();
      open_.pop_back();
      Descend(next);
    }
  }
  CounterpartsOfTerms Take() {
    for (auto& [newer, older] : older_) std::ranges::sort(older);
    return std::move(older_);
  }

 private:
  void Visit(terms::TermId a, terms::TermId b) {
    if (a == b || terms_.Width(a) != terms_.Width(b) || seen_.size() >= most_pairs_) return;
    const auto [older, newer] = std::minmax(a, b);
    if (!seen_.insert((uint64_t{older.index} << 32) | newer.index).second) return;
    if (may_be_equal_(older, newer)) older_[newer.index].push_back(older);
    open_.push_back({a, b});
  }

  void Descend(const TermPair& pair) {
    const terms::Term &a = terms_[pair.a], &b = terms_[pair.b];
    if (a.kind != b.kind) return;
    if (IsChain(a.kind)) {
      DescendChain(pair);
      return;
    }
    if (a.kind == terms::TermKind::kExtract && a.b != b.b) return;
    if (a.kind == terms::TermKind::kApply && (a.a != b.a || a.c != b.c)) return;
    std::vector<terms::TermId> of_a;
    terms_.ForEachOperand(a, [&of_a](terms::TermId operand) { of_a.push_back(operand); });
    size_t at = 0;
    terms_.ForEachOperand(b, [&](terms::TermId operand) { Visit(of_a[at++], operand); });
  }

  /// The order of operands is that of their making: those that both have are taken out first.
  void DescendChain(const TermPair& pair) {
    const std::vector<terms::TermId> of_a = OperandsOf(pair.a), of_b = OperandsOf(pair.b);
    std::vector<terms::TermId> only_a, only_b;
    std::ranges::set_difference(of_a, of_b, std::back_inserter(only_a));
    std::ranges::set_difference(of_b, of_a, std::back_inserter(only_b));
    std::vector<terms::TermId> alone;
    for (const terms::TermId operand : only_a) {
      const auto other = std::ranges::find_if(only_b, [&](terms::TermId candidate) {
        return terms_.Width(operand) == terms_.Width(candidate) && may_be_equal_(operand, candidate);
      });
      if (other == only_b.end()) {
        alone.push_back(operand);
        continue;
      }
      Visit(operand, *other);
      only_b.erase(other);
    }
    if (alone.size() == only_b.size()) {
      for (size_t i = 0; i < alone.size(); ++i) Visit(alone[i], only_b[i]);
    }
  }

  std::vector<terms::TermId> OperandsOf(terms::TermId id) const {
    const terms::TermKind kind = terms_[id].kind;
    std::vector<terms::TermId> operands, open = {id};
    while (!open.empty()) {
      const terms::TermId next = open.back();
      open.pop_back();
      if (terms_[next].kind != kind || operands.size() + open.size() >= kMostOperands) {
        operands.push_back(next);
        continue;
      }
      terms_.ForEachOperand(terms_[next], [&open](terms::TermId operand) { open.push_back(operand); });
    }
    std::ranges::sort(operands);
    return operands;
  }

  const terms::Terms& terms_;
  const size_t most_pairs_;
  const std::function<bool(terms::TermId, terms::TermId)>& may_be_equal_;
  CounterpartsOfTerms older_;
  std::unordered_set<uint64_t> seen_;  // looked up only
  std::vector<TermPair> open_;
};

}  // namespace

CounterpartsOfTerms Counterparts(const terms::Terms& terms, std::span<const TermPair> pairs, size_t most_pairs,
                                 const std::function<bool(terms::TermId, terms::TermId)>& may_be_equal) {
  Walk walk(terms, most_pairs, may_be_equal);
  for (const TermPair& pair : pairs) walk.From(pair);
  return walk.Take();
}

}  // namespace plcxx::solver
