// Memory at a computed address (specification 6.9, D40). What is not wholly inside the space reads 0 and writes
// nothing.
//
// D may be in up to three parts by retention, which are spaces of their own. An access is tried in each of them:
// outside of its part it reads 0, so that the results can be joined.
//
//   the byte at D + i, where bytes 100 to 199 are kept:   D_before[i] | D_kept[i - 100] | D_after[i - 200]
#pragma once

#include <string>
#include <unordered_map>

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class IndexedCells : Context {
 public:
  explicit IndexedCells(const Context& context) : Context(context) {}

  /// `address`: in bytes, an i32.
  ir::ValueId Load(Space space, ir::ValueId address, ir::Type type);
  void Store(Space space, ir::ValueId address, ir::Type type, ir::ValueId value);
  ir::ValueId Moved(ir::ValueId address, uint32_t by);

 private:
  /// A word in D as two bytes, which may lie in different parts; `number` is 0 for the low one.
  template <class Visit>
  void ForEachPart(uint32_t number, uint32_t bytes, Visit&& visit);
  ir::PlaceId PlaceOf(ir::SpaceId space, ir::Type type, std::string name, uint32_t low, uint32_t high);

  std::unordered_map<std::string, ir::PlaceId> places_;  // by name
};

}  // namespace plcxx::prostep
