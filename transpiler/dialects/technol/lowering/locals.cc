#include "transpiler/dialects/technol/lowering/locals.h"

#include <utility>

namespace plcxx::technol {

using ir::Type;

namespace {

constexpr uint32_t kFirstLocal = 256;  // bytes of the registers' space below are RLO, flags and registers

}  // namespace

ir::PlaceId Locals::AddShared(std::string name, Type type) {
  const uint32_t offset = kFirstLocal + 4 * shared_count_++;
  return program_.places.Add({.name = std::move(name),
                              .type = type,
                              .space = memory_[SpaceKey::kRegisters],
                              .offset = offset,
                              .bit = type == Type::kBit ? uint8_t{0} : ir::kNoBit});
}

ir::PlaceId Locals::operator()(std::string_view name, Type type) {
  const bool own = frame_.routine != nullptr && frame_.routine->unit.valid() && !frame_.routine->calls;
  const auto [found, is_new] = (own ? own_ : shared_).try_emplace(std::string(name));
  if (!is_new) return found->second;
  found->second = own ? AddOwn(std::string(name), type) : AddShared(std::string(name), type);
  return found->second;
}

ir::PlaceId Locals::AddOwn(std::string name, Type type) {
  const ir::RoutineId routine = frame_.routine->id;
  ir::SpaceId& space = own_spaces_[routine.index];
  if (!space.valid()) {
    space = program_.spaces.Add({.name = program_.routines[routine].name + "_locals",
                                 .title = "",
                                 .bytes = 0,
                                 .lifetime = ir::Lifetime::kRoutine,
                                 .own = true});
  }
  const uint32_t offset = std::exchange(program_.spaces[space].bytes, program_.spaces[space].bytes + 4);
  return program_.places.Add({.name = std::move(name),
                              .type = type,
                              .space = space,
                              .offset = offset,
                              .bit = type == Type::kBit ? uint8_t{0} : ir::kNoBit});
}

}  // namespace plcxx::technol
