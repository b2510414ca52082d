// Who wrote a bit, a byte or a field last: what a failing expectation tells beside the wrong value.
//
// Each cell (a bit, a byte, a field) keeps its last writes, newest first. A write that repeats the newest one (same
// writer, same value) only renews its time, so that a coil written in every scan does not push the others out.
// Not its job: words (names, messages): the scenario runner has the source.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::sim {

enum class Writer : uint8_t { kProgram, kHost, kForce };

struct LastWrite {
  Writer writer = Writer::kProgram;
  ir::StatementId statement;  // of kProgram; none: the program's own schedule
  uint64_t first_ms = 0;      // since when this writer writes this value
  uint64_t last_ms = 0;
  uint64_t value = 0;  // what the cell held afterwards: a forced bit keeps its own
  /// Of an access of several bytes that wrote it: its first byte, their number, and what they held afterwards.
  uint32_t offset = 0;
  uint8_t bytes = 1;
  uint64_t accessed = 0;
  bool operator==(const LastWrite&) const = default;
};

class LastWrites {
 public:
  static constexpr size_t kKept = 3;

  void NoteByte(ir::SpaceId space, uint32_t offset, uint8_t mask, uint8_t byte, LastWrite write);
  void NoteField(ir::StateId state, uint8_t field, LastWrite write);

  /// At power-on: what was before explains nothing any more.
  void Clear() { cells_.clear(); }

  /// The last writes of a place, newest first. Of a place of several bytes: those of its first byte (in memory), with
  /// the value of the place where it was written as a whole.
  std::vector<LastWrite> Of(const ir::Place& place) const;

 private:
  using Cell = uint64_t;
  void Note(Cell cell, const LastWrite& write);

  std::unordered_map<Cell, std::vector<LastWrite>> cells_;  // looked up only, never walked
};

}  // namespace plcxx::sim
