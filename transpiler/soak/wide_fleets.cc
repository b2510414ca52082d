#include "transpiler/soak/wide_fleets.h"

#include <algorithm>
#include <bit>
#include <span>

namespace plcxx::soak {

WideFleets::WideFleets(const std::shared_ptr<const fleet::Library>& library, uint32_t machines) {
  for (uint32_t lanes = 0; lanes < machines; lanes += library->lanes) {
    fleets_.push_back(std::make_unique<fleet::Fleet>(library));
  }
}

void WideFleets::BecomeFirst() {
  for (const auto& fleet : fleets_) fleet->BecomeAll(*fleets_.front(), 0);
}

std::optional<size_t> WideFleets::FirstWith(const ir::Place& bit) const {
  size_t first = 0;
  for (const auto& fleet : fleets_) {
    const std::span<const uint64_t> words = fleet->PlaneOf(bit.space, bit.offset, bit.bit);
    // What is the same in every machine.
    if (words.empty()) return fleet->Bit(0, bit.space, bit.offset, bit.bit) ? std::optional(first) : std::nullopt;
    const auto found = std::ranges::find_if(words, [](uint64_t word) { return word != 0; });
    if (found != words.end()) {
      return first + 64 * static_cast<size_t>(found - words.begin()) + static_cast<size_t>(std::countr_zero(*found));
    }
    first += fleet->lanes();
  }
  return std::nullopt;
}

bool WideFleets::IsSet(size_t machine, const ir::Place& bit) const {
  const unsigned lanes = fleets_.front()->lanes();
  return fleets_[machine / lanes]->Bit(static_cast<unsigned>(machine % lanes), bit.space, bit.offset, bit.bit);
}

WideFleets::Values WideFleets::ValuesOf(const ir::Place& bit) const {
  Values values;
  for (const auto& fleet : fleets_) {
    const std::span<const uint64_t> words = fleet->PlaneOf(bit.space, bit.offset, bit.bit);
    for (const uint64_t word : words) {
      values.one |= word != 0;
      values.zero |= ~word != 0;
    }
    if (words.empty()) (fleet->Bit(0, bit.space, bit.offset, bit.bit) ? values.one : values.zero) = true;
  }
  return values;
}

void WideFleets::PowerOn() {
  for (size_t i = 0; i < running_; ++i) fleets_[i]->PowerOn();
}

void WideFleets::StoreRetentive() {
  for (size_t i = 0; i < running_; ++i) fleets_[i]->StoreRetentive();
}

void WideFleets::Run(fleet::Piece piece, uint32_t now_ms) {
  for (size_t i = 0; i < running_; ++i) fleets_[i]->Run(piece, now_ms);
}

}  // namespace plcxx::soak
