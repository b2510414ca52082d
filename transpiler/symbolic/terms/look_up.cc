#include "transpiler/symbolic/terms/look_up.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "transpiler/symbolic/terms/index_bits.h"

namespace plcxx::terms {
namespace {

class Tree {
 public:
  Tree(Terms& terms, std::span<const IndexBit> bits, std::vector<TermId> leaves)
      : terms_(terms), bits_(bits), leaves_(std::move(leaves)) {}

  /// Of the values from `first` on that differ in the lowest `count` bits; none: nothing is there.
  TermId Build(size_t first, size_t count) const {
    if (count == 0) return leaves_[first];
    const size_t half = size_t{1} << (count - 1);
    const TermId low = Build(first, count - 1), high = Build(first + half, count - 1);
    if (!low.valid()) return high;
    if (!high.valid()) return low;
    const IndexBit& bit = bits_[count - 1];
    return terms_.Ite(terms_.Extract(bit.of, bit.number, 1), high, low);
  }

 private:
  Terms& terms_;
  std::span<const IndexBit> bits_;
  std::vector<TermId> leaves_;  // by value of the bits
};

}  // namespace

TermId LookUp(Terms& terms, TermId given, TermId index, const std::vector<TableElement>& elements, TermId otherwise) {
  if (terms.IsConst(index)) {
    const auto at = std::ranges::lower_bound(elements, terms.Value(index), {}, &TableElement::index);
    if (at != elements.end() && at->index == terms.Value(index)) return at->value;
    return otherwise.valid() ? otherwise : elements.back().value;
  }
  if (const std::optional<IndexBits> known = IndexBitsOf(terms, index)) {
    const std::vector<bool> possible = PossibleWhere(terms, given, known->bits);
    std::vector<TermId> leaves(possible.size());
    for (size_t i = 0; i < leaves.size(); ++i) {
      if (!possible[i]) continue;
      const auto at = std::ranges::lower_bound(elements, known->values[i], {}, &TableElement::index);
      leaves[i] = at != elements.end() && at->index == known->values[i] ? at->value : otherwise;
    }
    const TermId value = Tree(terms, known->bits, std::move(leaves)).Build(0, known->bits.size());
    if (value.valid()) return value;
    // Nothing is given in which the index has a value: of no element, perhaps, for all were known to be elsewhere.
    return elements.empty() ? otherwise : elements.back().value;
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
