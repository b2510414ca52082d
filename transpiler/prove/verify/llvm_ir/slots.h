// The row of slots, as values that share what they have in common: every path has its own, and copying one costs
// little.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::verify::llvm_ir {

class Slots {
 public:
  static constexpr uint32_t kPage = 64;

  /// None: nothing has written it.
  terms::TermId At(uint32_t slot) const {
    const uint32_t page = slot / kPage;
    return page < pages_.size() && pages_[page] != nullptr ? (*pages_[page])[slot % kPage] : terms::TermId();
  }
  void Set(uint32_t slot, terms::TermId value);

  /// Calls `visit(slot)` for each slot that may differ between the two.
  template <class Visit>
  static void ForEachDifference(const Slots& a, const Slots& b, Visit&& visit) {
    const size_t pages = a.pages_.size() > b.pages_.size() ? a.pages_.size() : b.pages_.size();
    for (size_t page = 0; page < pages; ++page) {
      if (a.PageAt(page) == b.PageAt(page)) continue;
      for (uint32_t i = 0; i < kPage; ++i) {
        const auto slot = static_cast<uint32_t>(page) * kPage + i;
        if (a.At(slot) != b.At(slot)) visit(slot);
      }
    }
  }

 private:
  using Page = std::array<terms::TermId, kPage>;
  const Page* PageAt(size_t page) const { return page < pages_.size() ? pages_[page].get() : nullptr; }

  std::vector<std::shared_ptr<Page>> pages_;
};

inline void Slots::Set(uint32_t slot, terms::TermId value) {
  const uint32_t page = slot / kPage;
  if (page >= pages_.size()) pages_.resize(page + 1);
  if (pages_[page] == nullptr) {
    pages_[page] = std::make_shared<Page>();
  } else if (pages_[page].use_count() > 1) {
    pages_[page] = std::make_shared<Page>(*pages_[page]);
  }
  (*pages_[page])[slot % kPage] = value;
}

}  // namespace plcxx::prove::verify::llvm_ir
