// Which place of a program a byte of Engine::Snapshot belongs to.
//
// In: an index into a snapshot and the bits of that byte in question. Out: the narrowest place that holds one of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::engines {

struct SnapshotCell {
  std::string name;                // as the source writes it, else "K byte 12", "T5.elapsed_ms"
  std::optional<ir::Place> place;  // none: a hidden field
  ir::Type type = ir::Type::kI8;
  size_t at = 0;  // its first byte in the snapshot
  uint8_t bit = 0;
  bool big_endian = false;
};

/// `bits`: which bits of the byte at `at` to look for; not 0.
SnapshotCell CellAt(const ir::Program& program, size_t at, uint8_t bits);

uint64_t CellValue(const SnapshotCell& cell, const std::vector<uint8_t>& snapshot);

}  // namespace plcxx::engines
