#include "transpiler/dialects/classicladder/lowering/grid.h"

namespace plcxx::classicladder {

void Grid::Begin(const Rung& rung) {
  rung_ = &rung;
  for (uint32_t x = 0; x < kRungWidth; ++x) {
    for (uint32_t y = 0; y < kRungHeight; ++y) {
      outputs_[x][y] = {};
      knows_left_[x][y] = false;
    }
  }
}

Signal Grid::Left(uint32_t x, uint32_t y) {
  if (x == 0) return Signal::One();
  uint32_t top = y, bottom = y;
  while (top > 0 && rung_->At(x, top).joined_above) --top;
  while (bottom + 1 < kRungHeight && rung_->At(x, bottom + 1).joined_above) ++bottom;
  Signal& left = lefts_[x][top];
  if (knows_left_[x][top]) return left;
  knows_left_[x][top] = true;
  left = {};
  for (uint32_t row = top; row <= bottom; ++row) left = logic_.Or(left, outputs_[x - 1][row]);
  return left;
}

}  // namespace plcxx::classicladder
