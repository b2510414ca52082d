#include "transpiler/prove/compiled/loop_facts.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "transpiler/prove/terms/cone.h"

namespace plcxx::prove {
namespace {

constexpr size_t kMostLeaves = 24;

/// What a condition is made of: comparisons and bits, in the order of their making.
std::vector<TermId> LeavesOf(const Terms& terms, TermId condition) {
  std::vector<bool> seen(terms.size());
  std::vector<TermId> open = {condition}, leaves;
  while (!open.empty()) {
    const TermId id = open.back();
    open.pop_back();
    if (seen[id.index] || terms.IsConst(id)) continue;
    seen[id.index] = true;
    bool joins = false;
    switch (terms[id].kind) {
      case TermKind::kNot:
      case TermKind::kAnd:
      case TermKind::kOr:
      case TermKind::kXor:
      case TermKind::kIte:
        joins = true;
        break;
      case TermKind::kEq:
        joins = terms.Width(TermId(terms[id].a)) == 1;
        break;
      case TermKind::kConst:
      case TermKind::kVariable:
      case TermKind::kAdd:
      case TermKind::kSub:
      case TermKind::kMul:
      case TermKind::kUdiv:
      case TermKind::kUrem:
      case TermKind::kSdiv:
      case TermKind::kSrem:
      case TermKind::kShl:
      case TermKind::kLshr:
      case TermKind::kAshr:
      case TermKind::kUlt:
      case TermKind::kSlt:
      case TermKind::kConcat:
      case TermKind::kExtract:
      case TermKind::kApply:
        break;
    }
    if (joins) {
      terms.ForEachOperand(terms[id], [&open](TermId operand) { open.push_back(operand); });
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
uint64_t HashOf(const Terms& terms, TermId root) {
  std::unordered_map<uint32_t, uint64_t> hashes;  // looked up only
  for (const TermId id : ConeOf(terms, {&root, 1})) {
    const Term& term = terms[id];
    uint64_t hash = Mixed(static_cast<uint64_t>(term.kind), term.width);
    if (term.kind == TermKind::kConst) hash = Mixed(hash, terms.Value(id));
    if (term.kind == TermKind::kExtract) hash = Mixed(hash, term.b);
    std::string_view name;
    if (term.kind == TermKind::kVariable) name = terms.VariableName(term.a);
    if (term.kind == TermKind::kApply) name = terms.Info(FunctionId(term.a)).name;
    for (const char c : name) hash = Mixed(hash, static_cast<unsigned char>(c));
    terms.ForEachOperand(term, [&](TermId operand) { hash = Mixed(hash, hashes.at(operand.index)); });
    hashes.emplace(id.index, hash);
  }
  return hashes.at(root.index);
}

class Facts {
 public:
  Facts(Terms& terms, TermId round, TermId later, const std::function<TermId(TermId)>& at_entry)
      : terms_(terms), round_(round), at_entry_(at_entry), first_(terms.Not(later)) {
    Add(terms_.Eq(first_, terms_.Eq(round_, terms_.Const(0, terms_.Width(round_)))));
  }

  void AddLeaf(TermId leaf);
  std::vector<FactCandidate> Take() { return std::move(found_); }

 private:
  void Add(TermId fact);
  void AddDistance(TermId distance);

  Terms& terms_;
  TermId round_;
  const std::function<TermId(TermId)>& at_entry_;
  TermId first_;
  std::vector<FactCandidate> found_;
};

void Facts::Add(TermId fact) {
  const bool there = std::ranges::any_of(found_, [fact](const FactCandidate& one) { return one.always == fact; });
  if (terms_.IsConst(fact) || there) return;
  found_.push_back({.always = fact, .later = terms_.Or(first_, fact), .key = std::to_string(HashOf(terms_, fact))});
}

/// What is left becomes less, by 1 each round where it does so evenly, and does not begin anew behind 0.
void Facts::AddDistance(TermId distance) {
  const TermId before = at_entry_(distance);
  if (before == distance) return;
  Add(terms_.Ule(distance, before));
  const uint8_t width = terms_.Width(round_);
  if (terms_.Width(distance) >= width) return;
  const TermId now = terms_.Zext(distance, width), then = terms_.Zext(before, width);
  Add(terms_.Eq(terms_.Add(now, round_), then));
}

/// What a comparison says, weakly and strongly, in both directions.
void Facts::AddLeaf(TermId leaf) {
  Add(leaf);
  Add(terms_.Not(leaf));
  const Term term = terms_[leaf];
  if (term.kind != TermKind::kUlt && term.kind != TermKind::kSlt && term.kind != TermKind::kEq) return;
  const TermId a(term.a), b(term.b);
  const bool is_signed = term.kind == TermKind::kSlt;
  Add(is_signed ? terms_.Sle(a, b) : terms_.Ule(a, b));
  Add(is_signed ? terms_.Sle(b, a) : terms_.Ule(b, a));
  AddDistance(terms_.Sub(a, b));
  AddDistance(terms_.Sub(b, a));
}

}  // namespace

std::vector<FactCandidate> FactsFrom(Terms& terms, TermId again, TermId round, TermId later,
                                     const std::function<bool(TermId variable)>& is_known,
                                     const std::function<TermId(TermId term)>& at_entry) {
  Facts facts(terms, round, later, at_entry);
  size_t used = 0;
  for (const TermId leaf : LeavesOf(terms, again)) {
    if (used == kMostLeaves) break;
    const bool known = std::ranges::all_of(
        ConeOf(terms, {&leaf, 1}), [&](TermId id) { return terms[id].kind != TermKind::kVariable || is_known(id); });
    if (!known) continue;
    ++used;
    facts.AddLeaf(leaf);
  }
  return facts.Take();
}

}  // namespace plcxx::prove
