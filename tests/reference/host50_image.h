// The memory of host50 as section 5 of the specification has it: areas of bits, int32 and binary32.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "tests/reference/reference.h"
#include "transpiler/dialects/host50/machine/machine.h"

namespace plcxx::reference {

class Host50Image {
 public:
  /// Adds the areas of so many channels to `spaces`, which the image works on from then on.
  Host50Image(std::vector<AddressSpace>& spaces, uint32_t channels) : spaces_(spaces) {
    const uint32_t bits = 2001 + 2000 * (channels - 1), words = 301 + 200 * (channels - 1);
    for (const char* name : {"I", "Q"}) spaces.emplace_back(name, (bits + 7) / 8);
    spaces.emplace_back("B", (2001 + 7) / 8);
    for (const char* name : {"W", "F"}) spaces.emplace_back(name, 4 * 301);
    for (const char* name : {"IW", "QW", "IF", "QF"}) spaces.emplace_back(name, 4 * words);
    spaces.emplace_back("B_retentive", (501 + 7) / 8);
    for (const char* name : {"W_retentive", "F_retentive"}) spaces.emplace_back(name, 4 * 101);
  }

  bool Bit(host50::Area area, uint32_t number) const {
    return (SpaceOf(area, number)[number / 8] >> number % 8 & 1) != 0;
  }
  void SetBit(host50::Area area, uint32_t number, bool value) {
    SpaceOf(area, number).Write(number / 8, static_cast<uint8_t>(1u << number % 8), value ? 0xFF : 0);
  }
  uint32_t Unit(host50::Area area, uint32_t number) const {
    uint32_t value = 0;
    for (uint32_t i = 0; i < 4; ++i) value |= uint32_t{SpaceOf(area, number)[4 * number + i]} << (8 * i);
    return value;
  }
  void SetUnit(host50::Area area, uint32_t number, uint32_t value) {
    for (uint32_t i = 0; i < 4; ++i) {
      SpaceOf(area, number).Write(4 * number + i, 0xFF, static_cast<uint8_t>(value >> (8 * i)));
    }
  }

  /// Of %B0..500, %W0..100, %F0..100.
  std::vector<std::vector<uint8_t>> Retentive() const {
    std::vector<std::vector<uint8_t>> kept;
    for (size_t i = kRetentive; i < kRetentive + 3; ++i) kept.push_back(spaces_[i].bytes());
    return kept;
  }
  void PutBack(const std::vector<std::vector<uint8_t>>& kept) {
    for (size_t i = 0; i < kept.size(); ++i) {
      for (uint32_t k = 0; k < kept[i].size(); ++k) spaces_[kRetentive + i].Write(k, 0xFF, kept[i][k]);
    }
  }

 private:
  static constexpr size_t kRetentive = 9;

  /// In the order of Area: I Q B W F IW QW IF QF.
  AddressSpace& SpaceOf(host50::Area area, uint32_t number) const {
    using host50::Area;
    if (area == Area::kB && number <= 500) return spaces_[kRetentive];
    if (area == Area::kW && number <= 100) return spaces_[kRetentive + 1];
    if (area == Area::kF && number <= 100) return spaces_[kRetentive + 2];
    return spaces_[static_cast<size_t>(area)];
  }

  std::vector<AddressSpace>& spaces_;
};

}  // namespace plcxx::reference
