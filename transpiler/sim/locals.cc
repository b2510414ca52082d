#include "transpiler/sim/locals.h"

namespace plcxx::sim {

void Locals::Begin(Memory& memory, const LocalStretches& locals) const {
  for (const auto& [space, begin, end] : locals) memory.SpaceAt(space).Renew(begin, end - begin);
}

void Locals::Keep(Memory& memory, const LocalStretches& locals) {
  for (const auto& [space, begin, end] : locals) {
    const size_t at = kept_.size();
    kept_.resize(at + size_t{ForcedBytes::kKeptForEach} * (end - begin));
    memory.SpaceAt(space).Keep(begin, end - begin, &kept_[at]);
  }
}

void Locals::PutBack(Memory& memory, const LocalStretches& locals, size_t from) {
  size_t at = from;
  for (const auto& [space, begin, end] : locals) at += memory.SpaceAt(space).PutBack(begin, end - begin, &kept_[at]);
  kept_.resize(from);
}

}  // namespace plcxx::sim
