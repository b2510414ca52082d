#include "transpiler/dialects/technol/syntax/syntax.h"

namespace plcxx::technol {

UnitId FindModule(const Program& program, ModuleKind kind) {
  for (uint32_t i = 0; i < program.units.size(); ++i) {
    const Unit& unit = program.units[UnitId(i)];
    if (unit.kind == UnitKind::kModule && unit.module == kind) return UnitId(i);
  }
  return {};
}

uint32_t BytesOf(const Program& program, Area area) {
  return area == Area::kUser ? static_cast<uint32_t>(program.user_data.size()) : BytesOf(area);
}

}  // namespace plcxx::technol
