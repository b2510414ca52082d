// Timers, monostables, counters (calc.c's rules, docs/dialects/classicladder.md 6).
#pragma once

#include "transpiler/dialects/classicladder/lowering/grid.h"
#include "transpiler/dialects/classicladder/lowering/logic.h"
#include "transpiler/dialects/classicladder/lowering/places.h"

namespace plcxx::classicladder {

/// Each block is executed at its upper right cell; its inputs come from the column left of that.
class Blocks : Context {
 public:
  Blocks(const Context& context, Logic& logic, Grid& grid, Places& places)
      : Context(context), logic_(logic), grid_(grid), places_(places) {}

  /// Counts down while both inputs are 1; an expired one is done in the next scan only.
  void Timer(uint32_t x, uint32_t y, uint32_t number);
  /// Starts at exactly 0 only, counts in the scan that starts it, and is over one scan after its time.
  void Monostable(uint32_t x, uint32_t y, uint32_t number);
  /// Up, down, preset, reset, in this order; each keeps the value before it for the outputs empty and full.
  void Counter(uint32_t x, uint32_t y, uint32_t number);
  /// The part of a unit that has passed stays when the input falls: the next time begins with it.
  void TimerIec(uint32_t x, uint32_t y, uint32_t number);

 private:
  Logic& logic_;
  Grid& grid_;
  Places& places_;
};

}  // namespace plcxx::classicladder
