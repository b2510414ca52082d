#include "transpiler/dialects/hnc/lowering/locals.h"

#include <utility>

namespace plcxx::hnc {

namespace {

constexpr uint32_t kLocalBytes = 8;  // of a local of a routine, which is no place of memory

}  // namespace

ir::PlaceId Locals::Add(std::string name, ir::Type type) {
  const uint32_t offset = position_.bytes;
  position_.bytes += kLocalBytes;
  program_.spaces[position_.space].bytes = position_.bytes;
  return program_.places.Add({.name = std::move(name),
                              .address = {},
                              .type = type,
                              .space = position_.space,
                              .offset = offset,
                              .bit = type == ir::Type::kBit ? uint8_t{0} : ir::kNoBit});
}

Locals::Position Locals::Begin(std::string name) {
  const ir::SpaceId space = program_.spaces.Add(
      {.name = std::move(name), .title = "", .bytes = 0, .lifetime = ir::Lifetime::kRoutine, .own = true});
  return std::exchange(position_, {.space = space, .bytes = 0});
}

}  // namespace plcxx::hnc
