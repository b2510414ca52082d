// How the number of a position is spread over inputs.
#pragma once

#include <cstdint>
#include <string_view>

namespace plcxx::plant {

enum class Coding : uint8_t { kBinary, kGray, kBcd, kOneHot };

/// Of a word that is one; else binary.
constexpr Coding CodingOf(std::string_view word) {
  if (word == "gray") return Coding::kGray;
  if (word == "bcd") return Coding::kBcd;
  return word == "one-hot" ? Coding::kOneHot : Coding::kBinary;
}

/// `index` counts positions from 0, whatever their numbers are.
constexpr uint64_t CodeOf(Coding coding, uint64_t number, uint64_t index) {
  switch (coding) {
    case Coding::kBinary:
      return number;
    case Coding::kGray:
      return number ^ (number >> 1);
    case Coding::kBcd: {
      uint64_t code = 0;
      for (int shift = 0; number != 0 && shift < 64; shift += 4, number /= 10) code |= number % 10 << shift;
      return code;
    }
    case Coding::kOneHot:
      return index < 64 ? uint64_t{1} << index : 0;
  }
  return 0;
}

}  // namespace plcxx::plant
