// Bits and cells of the memory map as places, each once (specification sections 5 and 6.1).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <tuple>

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class CellPlaces : Context {
 public:
  explicit CellPlaces(const Context& context) : Context(context) {}

  /// A bit of memory, or a cell without an index register.
  ir::PlaceId Of(const Operand& operand);
  /// What an index counted from `offset` reaches.
  ir::PlaceId Indexed(const Operand& operand, uint32_t offset);
  ir::PlaceId Cell(Area area, uint32_t offset, ir::Type type, std::string name);
  /// A cell or bit of the control.
  ir::PlaceId System(std::string_view symbol);
  /// None when the program has no such name.
  const Symbol* Find(std::string_view name) const;
  /// "POCET", "TAB_TECHNOL_TCH_AKTIV", "LABEL_MEM_40": the names of the source; with its width where that is another
  /// one.
  std::string NameOf(const Operand& operand) const;

 private:
  ir::PlaceId Bit(Area area, uint32_t offset, uint8_t bit, std::string name);

  std::map<std::tuple<Area, uint32_t, ir::Type, uint8_t>, ir::PlaceId> places_;
  std::map<std::tuple<Area, uint32_t, ir::Type>, ir::PlaceId> indexed_;
};

}  // namespace plcxx::technol
