// What a write at an index that is a term does to each of the elements.
//
//   m[a * 20 + 6] = m[a * 20 + 6] | 0x40   ->   element 46: a == 2 ? (element 46) | 0x40 : element 46
//
// An element is written when the index is its own, and then much is known of what is written: here, which element was
// read. Two programs that write the same then give the same terms, however each computes its index. In: index and
// value. Not its job: to tell which elements there are.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "transpiler/symbolic/terms/index_bits.h"
#include "transpiler/symbolic/terms/specialization.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

class IndexedWrite {
 public:
  /// Nothing is written where `given` does not hold, whatever At says of it.
  IndexedWrite(Terms& terms, TermId given, TermId index, TermId value);
  IndexedWrite(const IndexedWrite&) = delete;
  IndexedWrite& operator=(const IndexedWrite&) = delete;

  struct Change {
    TermId when;   // the index is this one, where `given` holds
    TermId value;  // what is written then
  };
  /// Of one element.
  Change At(uint64_t index);

 private:
  /// A value of the bits, and the index that it gives.
  struct Origin {
    uint64_t index = 0;
    uint32_t bits = 0;
    auto operator<=>(const Origin&) const = default;
  };
  TermId WhenOneOf(std::span<const Origin> origins);

  Terms& terms_;
  TermId index_, value_;
  std::optional<IndexBits> of_;
  std::vector<Origin> origins_;  // ascending
  std::optional<Specialization> specialization_;
};

}  // namespace plcxx::terms
