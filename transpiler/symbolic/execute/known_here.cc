#include "transpiler/symbolic/execute/known_here.h"

#include <utility>
#include <vector>

namespace plcxx::execute {
namespace {

constexpr size_t kMostParts = 2000, kMostKnown = 50'000;
constexpr uint32_t kDeepest = 500;  // operands of operands

}  // namespace

KnownHere::KnownHere(terms::Terms& terms, terms::TermId condition) : terms_(terms) {
  std::vector<std::pair<terms::TermId, bool>> open = {{condition, true}};
  while (!open.empty() && known_.size() < kMostParts) {
    const auto [part, value] = open.back();
    open.pop_back();
    if (!known_.emplace(part.index, value).second) continue;
    const terms::Term& term = terms_[part];
    if (term.width != 1) continue;
    if (term.kind == terms::TermKind::kNot) open.emplace_back(terms::TermId(term.a), !value);
    if (term.kind == (value ? terms::TermKind::kAnd : terms::TermKind::kOr)) {
      open.emplace_back(terms::TermId(term.a), value);
      open.emplace_back(terms::TermId(term.b), value);
    }
  }
}

std::optional<bool> KnownHere::ValueOf(terms::TermId bit) {
  if (terms_.IsConst(bit)) return terms_.IsTrue(bit);
  const auto known = known_.find(bit.index);
  if (known != known_.end()) return known->second;
  if (known_.size() > kMostKnown || depth_ >= kDeepest) return std::nullopt;
  ++depth_;
  const std::optional<bool> value = Compute(bit);
  --depth_;
  known_.emplace(bit.index, value);
  return value;
}

std::optional<bool> KnownHere::OfChoice(terms::TermId condition, terms::TermId then, terms::TermId otherwise) {
  const std::optional<bool> chosen = ValueOf(condition);
  if (chosen) return ValueOf(*chosen ? then : otherwise);
  const std::optional<bool> one = ValueOf(then);
  return one && one == ValueOf(otherwise) ? one : std::nullopt;
}

std::optional<bool> KnownHere::Compute(terms::TermId bit) {
  const terms::Term term = terms_[bit];
  const terms::TermId a(term.a), b(term.b);
  if (term.kind == terms::TermKind::kNot) {
    const std::optional<bool> value = ValueOf(a);
    return value ? std::optional(!*value) : std::nullopt;
  }
  if (term.kind == terms::TermKind::kAnd || term.kind == terms::TermKind::kOr) {
    const bool decides = term.kind == terms::TermKind::kOr;
    const std::optional<bool> one = ValueOf(a);
    if (one == decides) return decides;
    const std::optional<bool> other = ValueOf(b);
    if (other == decides) return decides;
    return one && other ? std::optional(!decides) : std::nullopt;
  }
  if (term.kind == terms::TermKind::kXor) {
    const std::optional<bool> one = ValueOf(a), other = ValueOf(b);
    return one && other ? std::optional(*one != *other) : std::nullopt;
  }
  if (term.kind == terms::TermKind::kIte) return OfChoice(a, b, terms::TermId(term.c));
  if (term.kind != terms::TermKind::kExtract) return std::nullopt;
  const terms::Term word = terms_[a];
  if (word.kind != terms::TermKind::kIte) return std::nullopt;
  const auto low = static_cast<uint8_t>(term.b);
  return OfChoice(terms::TermId(word.a), terms_.Extract(terms::TermId(word.b), low, 1),
                  terms_.Extract(terms::TermId(word.c), low, 1));
}

}  // namespace plcxx::execute
