// Where the bits of a value are in State, so that it can be read and written by offset.
//
// In: the layout of a program and a place. Out: cells, each a stretch of bits of one byte of State. A processor that
// keeps the least significant byte first is meant. Not its job: reading them (client.h).
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "transpiler/emit/layout/layout.h"
#include "transpiler/ir/program.h"
#include "transpiler/link/transport.h"

namespace plcxx::debug_link {

struct Cell {
  uint32_t offset = 0;  // byte of State
  uint8_t bit = 0;      // its lowest bit there
  uint8_t bits = 8;     // so many
  uint8_t at = 0;       // the number of that bit in the value
  bool operator==(const Cell&) const = default;
};

/// Empty: the program does not keep it. `place` is not indexed.
std::vector<Cell> CellsOf(const ir::Program& program, const emit::layout::Layout& layout, const ir::Place& place);

/// Bytes that are next to each other.
struct Run {
  uint32_t offset = 0, bytes = 0;
  bool operator==(const Run&) const = default;
};
/// Those of all cells, ascending, each once, none longer than `most`.
std::vector<Run> RunsOf(const std::vector<Cell>& cells, uint32_t most);

/// Bytes of State that are known.
using KnownBytes = std::map<uint32_t, uint8_t>;
uint64_t ValueOf(const std::vector<Cell>& cells, const KnownBytes& bytes);

/// What is to be written for a value, in runs of at most `most` bytes.
struct MaskedRun {
  uint32_t offset = 0;
  Bytes masks, values;
  bool operator==(const MaskedRun&) const = default;
};
std::vector<MaskedRun> WritesOf(const std::vector<Cell>& cells, uint64_t value, uint32_t most);

}  // namespace plcxx::debug_link
