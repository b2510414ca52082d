// Places of objects in memory, each made once, named as the source names them.
#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <utility>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Memory;

class CellPlaces : Context {
 public:
  CellPlaces(const Context& context, Memory& memory) : Context(context), memory_(memory) {}

  /// Names that the program's macros give to cells: `#define mode_sel R[0]`; those of the control come second.
  void CollectNames();
  /// A scalar at a constant offset of an object, named by what the source calls it.
  ir::PlaceId At(ObjectId object, uint32_t offset, ir::Type type);
  ir::PlaceId IndexedAt(ObjectId object, uint32_t offset, uint32_t stride, ir::Type type);
  ir::ValueId LoadWord(Area area, uint32_t word, ir::Type type = ir::Type::kI16);

 private:
  std::string NameOf(ObjectId id, uint32_t offset, ir::Type type) const;
  std::string AddressOf(ObjectId id, uint32_t offset, ir::Type type) const;

  Memory& memory_;
  std::unordered_map<std::string, ir::PlaceId> places_;              // by object, offset, type, stride
  std::map<std::pair<uint32_t, uint32_t>, std::string> cell_names_;  // by area object and byte: a macro's name
};

}  // namespace plcxx::hnc
