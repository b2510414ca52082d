// The locations that scenarios and watch lists name (specification appendix A).
//
// Not its job: what ports do; their cells are the simulated control's (stub.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/program.h"

namespace plcxx::prostep {

/// "I0.3", "IB0", "IW0", "ID100", "P0.3", "T5", "C5"; capitals or small letters. None for what is no location.
std::optional<dialects::Location> Locate(const ir::NameIndex& names, std::string_view text);

/// A location that is no place: a port, or bytes of D that lie in two spaces of the program.
struct ControlCell {
  bool is_data = false;
  uint32_t number = 0;       // port, or address in D
  uint8_t bit = ir::kNoBit;  // of a port; none: bytes
  uint8_t bytes = 1;
};
constexpr uint32_t ToNumber(const ControlCell& cell) {
  return (cell.is_data ? 1u << 31 : 0) | cell.number << 16 | uint32_t{cell.bit} << 8 | cell.bytes;
}
constexpr ControlCell CellOf(uint32_t number) {
  return {number >> 31 != 0, number >> 16 & 0x7FFF, static_cast<uint8_t>(number >> 8), static_cast<uint8_t>(number)};
}

}  // namespace plcxx::prostep
