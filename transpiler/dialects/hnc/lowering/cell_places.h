// Places of objects in memory, each made once, named as the source names them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
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
  const Member* MemberAt(const Record& record, uint32_t offset) const;
  std::string NameOf(ObjectId id, uint32_t offset, ir::Type type) const;
  std::string AddressOf(ObjectId id, uint32_t offset, ir::Type type) const;

  Memory& memory_;
  static constexpr uint32_t kNoStride = UINT32_MAX;
  struct Key {
    uint32_t object = 0, offset = 0, stride = kNoStride;  // stride: of indexed ones
    ir::Type type{};
    auto operator<=>(const Key&) const = default;
  };
  std::map<Key, ir::PlaceId> places_;
  std::map<std::pair<uint32_t, uint32_t>, std::string> cell_names_;  // by area object and byte: a macro's name
};

}  // namespace plcxx::hnc
