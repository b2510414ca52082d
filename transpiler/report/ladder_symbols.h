// The symbols of a ladder: how much room each takes, and how it is drawn. Only ladder_*.cc include this.
#pragma once

#include "transpiler/report/ladder_drawing.h"

namespace plcxx::report {

/// In pixels; `up` and `down` from the wire.
struct Extent {
  int width = 0, up = 0, down = 0;
};

/// Of anything but kSeries and kParallel.
Extent SymbolExtent(const Element& element);
/// Draws the symbol from x to the right, its wire at y; gives where it ends.
int PlaceSymbol(const Element& element, int x, int y, Drawing& drawing);

}  // namespace plcxx::report
