#include "transpiler/symbolic/terms/indexed_write.h"

#include <algorithm>
#include <utility>

#include "transpiler/support/low_bits.h"

namespace plcxx::terms {
namespace {

constexpr size_t kMostOrigins = 4;  // that a condition names one by one

}  // namespace

IndexedWrite::IndexedWrite(Terms& terms, TermId given, TermId index, TermId value)
    : terms_(terms), index_(index), value_(value), of_(IndexBitsOf(terms, index)) {
  if (!of_) return;
  const std::vector<bool> possible = PossibleWhere(terms, given, of_->bits);
  for (size_t i = 0; i < of_->values.size(); ++i) {
    if (possible[i]) origins_.push_back({of_->values[i], static_cast<uint32_t>(i)});
  }
  std::ranges::sort(origins_);
  specialization_.emplace(terms, value, of_->bits);
}

TermId IndexedWrite::WhenOneOf(std::span<const Origin> origins) {
  TermId when = terms_.Bit(false);
  for (const Origin& origin : origins) {
    TermId here = terms_.Bit(true);
    for (size_t i = of_->bits.size(); i-- > 0;) {
      const TermId bit = terms_.Extract(of_->bits[i].of, of_->bits[i].number, 1);
      here = terms_.And((origin.bits >> i & 1) != 0 ? bit : terms_.Not(bit), here);
    }
    when = terms_.Or(when, here);
  }
  return when;
}

IndexedWrite::Change IndexedWrite::At(uint64_t index) {
  const auto equal = [&] { return terms_.Eq(index_, terms_.Const(index, terms_.Width(index_))); };
  if (!of_) return {equal(), value_};
  const auto found = std::ranges::equal_range(std::as_const(origins_), index, {}, &Origin::index);
  const std::span<const Origin> origins(found.begin(), found.end());
  if (origins.empty()) return {terms_.Bit(false), value_};
  auto ones = static_cast<uint32_t>(support::LowBits(static_cast<uint32_t>(of_->bits.size()))), zeros = ones;
  for (const Origin& origin : origins) {
    ones &= origin.bits;
    zeros &= ~origin.bits;
  }
  const TermId when = origins.size() <= kMostOrigins ? WhenOneOf(origins) : equal();
  return {when, specialization_->Where(ones, zeros)};
}

}  // namespace plcxx::terms
