#include "transpiler/symbolic/terms/index_bits.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>

#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::terms {
namespace {

constexpr size_t kMostBits = 16;
constexpr size_t kMostKnown = 32;       // bits of KnownIndexBits::ones
constexpr size_t kMostConditions = 32;  // of a condition
constexpr size_t kMostTerms = 200;      // of an index that is computed for all values of its bits

/// The bits of variables and functions' results that an index is made of, ascending; none: they are too many.
class BitsOf {
 public:
  explicit BitsOf(const Terms& terms) : terms_(terms) {}

  std::optional<std::vector<IndexBit>> Run(TermId root) {
    const std::vector<TermId> cone = CutCone(root);
    if (cone.size() > kMostTerms) return std::nullopt;
    for (const TermId id : cone) {
      const Term& term = terms_[id];
      if (term.kind == TermKind::kExtract && IsLeaf(TermId(term.a)))
        Use(TermId(term.a), static_cast<uint8_t>(term.b), term.width);
      if (term.kind == TermKind::kExtract) continue;
      terms_.ForEachOperand(term, [&](TermId operand) {
        if (IsLeaf(operand) && !IsLeaf(id)) Use(operand, 0, terms_.Width(operand));
      });
    }
    if (IsLeaf(root)) Use(root, 0, terms_.Width(root));
    std::ranges::sort(bits_);
    bits_.erase(std::ranges::unique(bits_).begin(), bits_.end());
    if (bits_.size() > kMostBits) return std::nullopt;
    return std::move(bits_);
  }

  bool IsLeaf(TermId id) const { return terms_[id].kind == TermKind::kVariable || terms_[id].kind == TermKind::kApply; }
  /// All that the root is made of, leaves included, operands first; not what leaves are made of.
  std::vector<TermId> CutCone(TermId root) const {
    std::vector<TermId> open = {root}, cone;
    while (!open.empty() && cone.size() <= kMostTerms) {
      const TermId id = open.back();
      open.pop_back();
      if (std::ranges::find(cone, id) != cone.end()) continue;
      cone.push_back(id);
      if (!IsLeaf(id)) terms_.ForEachOperand(terms_[id], [&open](TermId operand) { open.push_back(operand); });
    }
    std::ranges::sort(cone);
    return cone;
  }

 private:
  void Use(TermId leaf, uint8_t low, uint8_t width) {
    for (uint8_t i = 0; i < width; ++i) bits_.push_back({leaf, static_cast<uint8_t>(low + i)});
  }

  const Terms& terms_;
  std::vector<IndexBit> bits_;
};

/// A term of a cone, and where in it its operands are.
struct Step {
  Term term;
  std::array<size_t, 3> operands{};
};

std::vector<Step> StepsOf(const Terms& terms, std::span<const TermId> cone) {
  std::vector<Step> steps;
  for (const TermId id : cone) {
    Step step{.term = terms[id]};
    // The arguments of a function are not in the cone.
    if (step.term.kind != TermKind::kApply) {
      size_t count = 0;
      terms.ForEachOperand(step.term, [&](TermId operand) {
        step.operands[count++] = static_cast<size_t>(std::ranges::lower_bound(cone, operand) - cone.begin());
      });
    }
    steps.push_back(step);
  }
  return steps;
}

/// The root for every value of the bits; the first bit is the least significant.
std::vector<uint64_t> AllValues(const Terms& terms, TermId root, std::span<const TermId> cone,
                                std::span<const IndexBit> bits) {
  const std::vector<Step> steps = StepsOf(terms, cone);
  const auto place = [&](TermId id) { return static_cast<size_t>(std::ranges::lower_bound(cone, id) - cone.begin()); };
  std::vector<size_t> leaves;  // by bit; of one that the cone does not have, none
  for (const IndexBit& bit : bits)
    leaves.push_back(std::ranges::binary_search(cone, bit.of) ? place(bit.of) : cone.size());
  std::vector<uint64_t> values(cone.size() + 1), results;
  results.reserve(size_t{1} << bits.size());
  for (uint64_t all = 0; all >> bits.size() == 0; ++all) {
    for (const size_t leaf : leaves) values[leaf] = 0;
    for (size_t i = 0; i < bits.size(); ++i) values[leaves[i]] |= (all >> i & 1) << bits[i].number;
    for (size_t i = 0; i < steps.size(); ++i) {
      const auto& [term, operands] = steps[i];
      if (term.kind == TermKind::kVariable || term.kind == TermKind::kApply) continue;
      const auto value = [&](TermId operand) {
        return values[operands[operand.index == term.a ? 0 : operand.index == term.b ? 1 : 2]];
      };
      values[i] = EvaluateTerm(terms, term, value, [](uint32_t) { return uint64_t{0}; });
    }
    results.push_back(values[place(root)]);
  }
  return results;
}

/// Calls visit(part, BitsOf, bits) for what has to hold so that the condition does, and is about a few bits.
template <class Visit>
void ForEachPart(const Terms& terms, TermId condition, Visit&& visit) {
  std::vector<TermId> parts = {condition};
  for (size_t i = 0; i < parts.size(); ++i) {
    const Term term = terms[parts[i]];
    if (term.kind == TermKind::kAnd && parts.size() < kMostConditions) {
      parts.emplace_back(term.a);
      parts.emplace_back(term.b);
      continue;
    }
    BitsOf of(terms);
    const std::optional<std::vector<IndexBit>> bits = of.Run(parts[i]);
    if (bits && !bits->empty()) visit(parts[i], of, *bits);
  }
}

}  // namespace

std::optional<IndexBits> IndexBitsOf(const Terms& terms, TermId index) {
  BitsOf bits_of(terms);
  std::optional<std::vector<IndexBit>> bits = bits_of.Run(index);
  if (!bits) return std::nullopt;
  std::vector<uint64_t> values = AllValues(terms, index, bits_of.CutCone(index), *bits);
  return IndexBits{.bits = std::move(*bits), .values = std::move(values)};
}

std::vector<bool> PossibleWhere(const Terms& terms, TermId condition, const std::vector<IndexBit>& bits) {
  std::vector<bool> possible(size_t{1} << bits.size(), true);
  ForEachPart(terms, condition, [&](TermId part, BitsOf& of, const std::vector<IndexBit>& of_part) {
    if (!std::ranges::includes(bits, of_part)) return;
    const std::vector<uint64_t> holds = AllValues(terms, part, of.CutCone(part), bits);
    for (size_t value = 0; value < holds.size(); ++value) possible[value] = possible[value] && holds[value] != 0;
  });
  return possible;
}

KnownIndexBits KnownWhere(const Terms& terms, TermId condition) {
  std::map<IndexBit, bool> known;
  ForEachPart(terms, condition, [&](TermId part, BitsOf& of, const std::vector<IndexBit>& of_part) {
    const std::vector<uint64_t> holds = AllValues(terms, part, of.CutCone(part), of_part);
    uint32_t ones = ~uint32_t{0}, zeros = ~uint32_t{0};
    for (uint32_t value = 0; value < holds.size(); ++value) {
      if (holds[value] == 0) continue;
      ones &= value;
      zeros &= ~value;
    }
    // Where it never holds, nothing is to be known.
    if ((ones & zeros) != 0) return;
    for (size_t i = 0; i < of_part.size() && known.size() < kMostKnown; ++i) {
      if (((ones | zeros) >> i & 1) != 0) known.emplace(of_part[i], (ones >> i & 1) != 0);
    }
  });
  KnownIndexBits all;
  for (const auto& [bit, one] : known) {
    (one ? all.ones : all.zeros) |= uint32_t{1} << all.bits.size();
    all.bits.push_back(bit);
  }
  return all;
}

}  // namespace plcxx::terms
