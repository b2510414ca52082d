#include "transpiler/symbolic/terms/look_up.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <utility>

#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::terms {
namespace {

constexpr size_t kMostBits = 16;
constexpr size_t kMostTerms = 200;  // of an index that is computed for all values of its bits

struct Bit {
  TermId of;
  uint8_t number = 0;
  auto operator<=>(const Bit&) const = default;
};

/// The bits of variables and functions' results that an index is made of, ascending; none: they are too many.
class BitsOf {
 public:
  explicit BitsOf(const Terms& terms) : terms_(terms) {}

  std::optional<std::vector<Bit>> Run(TermId root) {
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
  std::vector<Bit> bits_;
};

/// The index for every value of the bits; the first bit is the least significant.
std::vector<uint64_t> AllValues(const Terms& terms, TermId index, std::span<const TermId> cone,
                                std::span<const Bit> bits) {
  std::vector<uint64_t> results;
  std::unordered_map<uint32_t, uint64_t> values;  // looked up only
  for (uint64_t all = 0; all >> bits.size() == 0; ++all) {
    for (const TermId id : cone) values[id.index] = 0;
    for (size_t i = 0; i < bits.size(); ++i) values[bits[i].of.index] |= (all >> i & 1) << bits[i].number;
    for (const TermId id : cone) {
      const Term& term = terms[id];
      if (term.kind == TermKind::kVariable || term.kind == TermKind::kApply) continue;
      values[id.index] = EvaluateTerm(
          terms, term, [&](TermId operand) { return values[operand.index]; }, [](uint32_t) { return uint64_t{0}; });
    }
    results.push_back(values[index.index]);
  }
  return results;
}

class Tree {
 public:
  Tree(Terms& terms, std::span<const Bit> bits, std::vector<TermId> leaves)
      : terms_(terms), bits_(bits), leaves_(std::move(leaves)) {}

  /// Of the values from `first` on that differ in the lowest `count` bits; none: nothing is there.
  TermId Build(size_t first, size_t count) const {
    if (count == 0) return leaves_[first];
    const size_t half = size_t{1} << (count - 1);
    const TermId low = Build(first, count - 1), high = Build(first + half, count - 1);
    if (!low.valid()) return high;
    if (!high.valid()) return low;
    const Bit& bit = bits_[count - 1];
    return terms_.Ite(terms_.Extract(bit.of, bit.number, 1), high, low);
  }

 private:
  Terms& terms_;
  std::span<const Bit> bits_;
  std::vector<TermId> leaves_;  // by value of the bits
};

}  // namespace

TermId LookUp(Terms& terms, TermId index, const std::vector<TableElement>& elements, TermId otherwise) {
  if (terms.IsConst(index)) {
    const auto at = std::ranges::lower_bound(elements, terms.Value(index), {}, &TableElement::index);
    if (at != elements.end() && at->index == terms.Value(index)) return at->value;
    return otherwise.valid() ? otherwise : elements.back().value;
  }
  BitsOf bits_of(terms);
  if (const auto bits = bits_of.Run(index)) {
    std::vector<TermId> leaves;
    for (const uint64_t value : AllValues(terms, index, bits_of.CutCone(index), *bits)) {
      const auto at = std::ranges::lower_bound(elements, value, {}, &TableElement::index);
      leaves.push_back(at != elements.end() && at->index == value ? at->value : otherwise);
    }
    const TermId value = Tree(terms, *bits, std::move(leaves)).Build(0, bits->size());
    return value.valid() ? value : elements.back().value;
  }
  TermId value = otherwise;
  for (auto element = elements.rbegin(); element != elements.rend(); ++element) {
    const TermId when = terms.Eq(index, terms.Const(element->index, terms.Width(index)));
    if (terms.IsTrue(when)) return element->value;
    if (!terms.IsFalse(when)) value = value.valid() ? terms.Ite(when, element->value, value) : element->value;
  }
  return value.valid() ? value : elements.back().value;
}

}  // namespace plcxx::terms
