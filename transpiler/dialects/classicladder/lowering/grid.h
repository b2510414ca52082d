// The signals of the rung that is executed, cell by cell.
#pragma once

#include "transpiler/dialects/classicladder/lowering/logic.h"

namespace plcxx::classicladder {

class Grid {
 public:
  explicit Grid(Logic& logic) : logic_(logic) {}

  void Begin(const Rung& rung);
  /// What arrives at the left side of a cell: the outputs left of it in its row, and in the rows that are joined there.
  Signal Left(uint32_t x, uint32_t y);
  void Put(uint32_t x, uint32_t y, Signal output) { outputs_[x][y] = output; }

 private:
  Logic& logic_;
  const Rung* rung_ = nullptr;
  Signal outputs_[kRungWidth][kRungHeight];
  Signal lefts_[kRungWidth][kRungHeight];  // by the topmost row that is joined
  bool knows_left_[kRungWidth][kRungHeight] = {};
};

}  // namespace plcxx::classicladder
