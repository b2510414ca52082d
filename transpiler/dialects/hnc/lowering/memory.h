// The memory map: register areas, variables, what automatic variables need in memory, the runtime's own scalars.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Memory : Context {
 public:
  explicit Memory(const Context& context) : Context(context) {}

  void AddSpaces();
  void AddVariables();
  ir::PlaceId AddScalar(std::string name, ir::Type type);
  /// Four scalars one after the other, "NAME_0" to "NAME_3", which the control writes whatever the program does with
  /// them; scenarios name one ADDRESS[0].
  std::array<ir::PlaceId, 4> AddInputs(const std::string& name, const std::string& address, ir::Type type);
  /// What the host hands to a routine of the runtime.
  ir::PlaceId AddArgument(std::string name, ir::Type type);
  /// The sizes of spaces to which scalars were added.
  void Finish();
  ir::SpaceId SpaceOf(ObjectId object) const { return object_space_[object.index]; }
  uint32_t BeginOf(ObjectId object) const { return object_begin_[object.index]; }
  /// Whether the object is a variable of the program with static memory.
  bool IsData(ObjectId object) const {
    return objects_[object].kind == ObjectKind::kVariable && object_space_[object.index] == data_;
  }
  ir::SpaceId data() const { return data_; }
  ir::SpaceId SpaceOf(Area area) const { return area_spaces_[static_cast<size_t>(area)]; }
  /// Whether it is that of an area.
  bool IsOfArea(ir::SpaceId space) const { return space.index < area_spaces_.size(); }

 private:
  void PutBytes(ir::SpaceId space, uint32_t offset, uint64_t value, uint32_t bytes);
  void InitialBytesOf(const InitialValue& initial, uint32_t begin);
  void AddPointerPlaces(VariableId id);

  std::array<ir::SpaceId, 7> area_spaces_;
  ir::SpaceId data_, automatic_, strings_, system_, pointers_, arguments_;
  uint32_t system_bytes_ = 0, pointer_bytes_ = 0, argument_bytes_ = 0;
  std::vector<uint32_t> object_begin_;     // by ObjectId: byte in its space
  std::vector<ir::SpaceId> object_space_;  // by ObjectId
};

}  // namespace plcxx::hnc
