#include "transpiler/prove/verify/loop_facts.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::verify {
namespace {

constexpr size_t kMostLeaves = 24;

/// What a condition is made of: comparisons and bits, in the order of their making.
std::vector<terms::TermId> LeavesOf(const terms::Terms& terms, terms::TermId condition) {
  std::vector<bool> seen(terms.size());
  std::vector<terms::TermId> open = {condition}, leaves;
  while (!open.empty()) {
    const terms::TermId id = open.back();
    open.pop_back();
    if (seen[id.index] || terms.IsConst(id)) continue;
    seen[id.index] = true;
    bool joins = false;
    switch (terms[id].kind) {
      case terms::TermKind::kNot:
      case terms::TermKind::kAnd:
      case terms::TermKind::kOr:
      case terms::TermKind::kXor:
      case terms::TermKind::kIte:
        joins = true;
        break;
      case terms::TermKind::kEq:
        joins = terms.Width(terms::TermId(terms[id].a)) == 1;
        break;
      case terms::TermKind::kConst:
      case terms::TermKind::kVariable:
      case terms::TermKind::kAdd:
      case terms::TermKind::kSub:
      case terms::TermKind::kMul:
      case terms::TermKind::kUdiv:
      case terms::TermKind::kUrem:
      case terms::TermKind::kSdiv:
      case terms::TermKind::kSrem:
      case terms::TermKind::kShl:
      case terms::TermKind::kLshr:
      case terms::TermKind::kAshr:
      case terms::TermKind::kUlt:
      case terms::TermKind::kSlt:
      case terms::TermKind::kConcat:
      case terms::TermKind::kExtract:
      case terms::TermKind::kApply:
        break;
    }
    if (joins) {
      terms.ForEachOperand(terms[id], [&open](terms::TermId operand) { open.push_back(operand); });
    } else {
      leaves.push_back(id);
    }
  }
  std::ranges::sort(leaves);
  return leaves;
}

uint64_t Mixed(uint64_t hash, uint64_t value) {
  hash ^= value + 0x9E3779B97F4A7C15 + (hash << 6) + (hash >> 2);
  return hash * 0xFF51AFD7ED558CCD;
}

/// By what the terms say, not by their numbers.
uint64_t HashOf(const terms::Terms& terms, terms::TermId root) {
  std::unordered_map<uint32_t, uint64_t> hashes;  // looked up only
  for (const terms::TermId id : terms::ConeOf(terms, {&root, 1})) {
    const terms::Term& term = terms[id];
    uint64_t hash = Mixed(static_cast<uint64_t>(term.kind), term.width);
    if (term.kind == terms::TermKind::kConst) hash = Mixed(hash, terms.Value(id));
    if (term.kind == terms::TermKind::kExtract) hash = Mixed(hash, term.b);
    std::string_view name;
    if (term.kind == terms::TermKind::kVariable) name = terms.VariableName(term.a);
    if (term.kind == terms::TermKind::kApply) name = terms.Info(terms::FunctionId(term.a)).name;
    for (const char c : name) hash = Mixed(hash, static_cast<unsigned char>(c));
    terms.ForEachOperand(term, [&](terms::TermId operand) { hash = Mixed(hash, hashes.at(operand.index)); });
    hashes.emplace(id.index, hash);
  }
  return hashes.at(root.index);
}

class Facts {
 public:
  Facts(terms::Terms& terms, terms::TermId round, terms::TermId later,
        const std::function<terms::TermId(terms::TermId)>& at_entry)
      : terms_(terms), round_(round), at_entry_(at_entry), first_(terms.Not(later)) {
    Add(terms_.Eq(first_, terms_.Eq(round_, terms_.Const(0, terms_.Width(round_)))));
  }

  void AddLeaf(terms::TermId leaf);
  std::vector<FactCandidate> Take() { return std::move(found_); }

 private:
  void Add(terms::TermId fact);
  void AddDistance(terms::TermId distance);

  terms::Terms& terms_;
  terms::TermId round_;
  const std::function<terms::TermId(terms::TermId)>& at_entry_;
  terms::TermId first_;
  std::vector<FactCandidate> found_;
};

void Facts::Add(terms::TermId fact) {
  const bool there = std::ranges::any_of(found_, [fact](const FactCandidate& one) { return one.always == fact; });
  if (terms_.IsConst(fact) || there) return;
  found_.push_back({.always = fact, .later = terms_.Or(first_, fact), .key = std::to_string(HashOf(terms_, fact))});
}

/// What is left becomes less, by 1 each round where it does so evenly, and does not begin anew after 0.
void Facts::AddDistance(terms::TermId distance) {
  const terms::TermId before = at_entry_(distance);
  if (before == distance) return;
  Add(terms_.Ule(distance, before));
  const uint8_t width = terms_.Width(round_);
  if (terms_.Width(distance) >= width) return;
  const terms::TermId now = terms_.Zext(distance, width), then = terms_.Zext(before, width);
  Add(terms_.Eq(terms_.Add(now, round_), then));
}

/// What a comparison says, weakly and strongly, in both directions.
void Facts::AddLeaf(terms::TermId leaf) {
  Add(leaf);
  Add(terms_.Not(leaf));
  // So it was when the first round began.
  const terms::TermId at_first = at_entry_(leaf);
  if (at_first != leaf) {
    Add(at_first);
    Add(terms_.Not(at_first));
  }
  const terms::Term term = terms_[leaf];
  if (term.kind != terms::TermKind::kUlt && term.kind != terms::TermKind::kSlt && term.kind != terms::TermKind::kEq)
    return;
  const terms::TermId a(term.a), b(term.b);
  const bool is_signed = term.kind == terms::TermKind::kSlt;
  Add(is_signed ? terms_.Sle(a, b) : terms_.Ule(a, b));
  Add(is_signed ? terms_.Sle(b, a) : terms_.Ule(b, a));
  AddDistance(terms_.Sub(a, b));
  AddDistance(terms_.Sub(b, a));
}

}  // namespace

std::vector<FactCandidate> FactsFrom(terms::Terms& terms, terms::TermId again, terms::TermId round, terms::TermId later,
                                     const std::function<bool(terms::TermId variable)>& is_known,
                                     const std::function<terms::TermId(terms::TermId term)>& at_entry) {
  Facts facts(terms, round, later, at_entry);
  size_t used = 0;
  for (const terms::TermId leaf : LeavesOf(terms, again)) {
    if (used == kMostLeaves) break;
    const bool known = std::ranges::all_of(terms::ConeOf(terms, {&leaf, 1}), [&](terms::TermId id) {
      return terms[id].kind != terms::TermKind::kVariable || is_known(id);
    });
    if (!known) continue;
    ++used;
    facts.AddLeaf(leaf);
  }
  return facts.Take();
}

}  // namespace plcxx::prove::verify
