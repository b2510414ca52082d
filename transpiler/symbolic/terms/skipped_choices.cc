// Choices that a condition rules out: c ? x : (d ? y : x) is d ? y : x where c and d never hold together, as the cases
// of one switch do not.
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {
namespace {

constexpr size_t kMostLevels = 64;      // of choices, one in the other
constexpr size_t kMostFacts = 64;       // that a condition consists of
constexpr int kMostTermsAskedFor = 64;  // about one condition

/// What a condition consists of, and what follows from it for others by their parts alone.
class Facts {
 public:
  Facts(const Terms& terms, TermId condition, bool holds) : terms_(terms) {
    std::vector<std::pair<TermId, bool>> open = {{condition, holds}};
    while (!open.empty() && facts_.size() < kMostFacts) {
      const auto [id, value] = open.back();
      open.pop_back();
      const Term& term = terms[id];
      facts_.emplace_back(id, value);
      if (term.kind == TermKind::kNot) open.emplace_back(TermId(term.a), !value);
      if (term.width != 1 || term.kind != (value ? TermKind::kAnd : TermKind::kOr)) continue;
      for (const uint32_t part : {term.a, term.b}) open.emplace_back(TermId(part), value);
    }
    std::ranges::sort(facts_);
  }

  std::optional<bool> Of(TermId condition) const {
    int left = kMostTermsAskedFor;
    return Of(condition, left);
  }

 private:
  std::optional<bool> Of(TermId id, int& left) const {
    if (--left < 0) return std::nullopt;
    const auto at = std::ranges::lower_bound(facts_, id, {}, &std::pair<TermId, bool>::first);
    if (at != facts_.end() && at->first == id) return at->second;
    const Term& term = terms_[id];
    if (term.kind == TermKind::kNot) {
      const std::optional<bool> of = Of(TermId(term.a), left);
      return of ? std::optional(!*of) : std::nullopt;
    }
    if (term.kind == TermKind::kEq) return IsOtherConstant(term) ? std::optional(false) : std::nullopt;
    if (term.width != 1 || (term.kind != TermKind::kAnd && term.kind != TermKind::kOr)) return std::nullopt;
    const bool deciding = term.kind == TermKind::kOr;
    const std::optional<bool> a = Of(TermId(term.a), left);
    if (a == deciding) return a;
    const std::optional<bool> b = Of(TermId(term.b), left);
    if (b == deciding) return b;
    return a && b ? a : std::nullopt;
  }

  /// Something is compared with another constant than the one that it is.
  bool IsOtherConstant(const Term& asked) const {
    const auto split = [this](const Term& equality) {
      const bool is_first = terms_.IsConst(TermId(equality.a));
      return is_first ? std::pair(equality.b, equality.a) : std::pair(equality.a, equality.b);
    };
    const auto [what, constant] = split(asked);
    if (!terms_.IsConst(TermId(constant))) return false;
    return std::ranges::any_of(facts_, [&](const std::pair<TermId, bool>& fact) {
      const Term& term = terms_[fact.first];
      if (!fact.second || term.kind != TermKind::kEq) return false;
      const auto [known, value] = split(term);
      return known == what && terms_.IsConst(TermId(value)) && value != constant;
    });
  }

  const Terms& terms_;
  std::vector<std::pair<TermId, bool>> facts_;  // sorted
};

}  // namespace

bool Terms::IsWhere(TermId choice, TermId leaf, TermId condition, bool value) const {
  // Most choices have no such leaf; finding out costs a look at each level.
  const auto has_leaf = [&] {
    TermId at = choice;
    for (size_t level = 0; level < kMostLevels && terms_[at.index].kind == TermKind::kIte; ++level) {
      const Term& term = terms_[at.index];
      if (TermId(term.b) == leaf || TermId(term.c) == leaf) return true;
      at = TermId(term.c);
    }
    return false;
  };
  if (!has_leaf()) return false;
  const Facts facts(*this, condition, value);
  for (size_t level = 0; level < kMostLevels; ++level) {
    if (choice == leaf) return true;
    const Term& term = terms_[choice.index];
    if (term.kind != TermKind::kIte) return false;
    const std::optional<bool> taken = facts.Of(TermId(term.a));
    if (taken) {
      choice = TermId(*taken ? term.b : term.c);
    } else if (TermId(term.b) == leaf) {
      choice = TermId(term.c);
    } else if (TermId(term.c) == leaf) {
      choice = TermId(term.b);
    } else {
      return false;
    }
  }
  return false;
}

}  // namespace plcxx::terms
