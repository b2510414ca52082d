#include "transpiler/dialects/hnc/parser/clang/macro_uses.h"

#include <algorithm>
#include <iterator>

namespace plcxx::hnc {
namespace {

constexpr size_t kNearUses = 8;  // after the last one, that are looked at before all are searched

source::Offset PlaceOf(const std::pair<source::Offset, MacroUseId>& use) { return use.first; }

}  // namespace

void MacroUses::Sort() {
  if (!std::ranges::is_sorted(uses_, {}, PlaceOf)) std::ranges::stable_sort(uses_, {}, PlaceOf);
}

MacroUseId MacroUses::At(source::Offset begin) {
  if (uses_.empty()) return {};
  size_t at = last_;
  for (size_t i = 0; i < kNearUses && at + 1 < uses_.size() && uses_[at + 1].first <= begin; ++i) ++at;
  const bool is_last_before = at + 1 == uses_.size() || uses_[at + 1].first > begin;
  if (uses_[at].first > begin || !is_last_before) {
    const auto next = std::ranges::upper_bound(uses_, begin, {}, PlaceOf);
    if (next == uses_.begin()) return {};
    at = static_cast<size_t>(std::distance(uses_.begin(), next)) - 1;
  }
  last_ = at;
  return uses_[at].first == begin ? uses_[at].second : MacroUseId();
}

}  // namespace plcxx::hnc
