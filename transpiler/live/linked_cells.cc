#include "transpiler/live/linked_cells.h"

namespace plcxx::live {

std::vector<debug_link::Cell> CellsOf(const ir::Program& program, const emit::layout::Layout& layout,
                                      const dialects::Location& location) {
  if (location.bits.empty()) return debug_link::CellsOf(program, layout, location.place);
  std::vector<debug_link::Cell> all;
  for (size_t i = 0; i < location.bits.size(); ++i) {
    for (debug_link::Cell cell : debug_link::CellsOf(program, layout, location.bits[i])) {
      cell.at = static_cast<uint8_t>(i);
      all.push_back(cell);
    }
  }
  return all;
}

}  // namespace plcxx::live
