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

/// "I0.3", "IB0", "IW0", "ID100", "P0.3", "T5", "C5"; capitals or small letters. None for what is no location, and for
/// a word that lies half in the retentive part of D.
std::optional<dialects::Location> Locate(const ir::Program& program, std::string_view text);

/// The cell of a port: its number, the bit (none: a byte or word), and bytes.
struct PortCell {
  uint32_t port = 0;
  uint8_t bit = ir::kNoBit;
  uint8_t bytes = 1;
};
constexpr uint32_t ToCell(const PortCell& cell) { return cell.port << 16 | uint32_t{cell.bit} << 8 | cell.bytes; }
constexpr PortCell FromCell(uint32_t cell) {
  return {cell >> 16, static_cast<uint8_t>(cell >> 8), static_cast<uint8_t>(cell)};
}

}  // namespace plcxx::prostep
