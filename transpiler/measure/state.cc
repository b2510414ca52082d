#include "transpiler/measure/state.h"

#include <algorithm>

#include "transpiler/compilation/preemption.h"
#include "transpiler/ir/accesses.h"

namespace plcxx::measure {
namespace {

bool IsRetentive(emit::layout::Storage storage) {
  using enum emit::layout::Storage;
  return storage == kRetentiveByte || storage == kRetentiveBit || storage == kRetentiveWide ||
         storage == kRetentiveIndexed;
}

/// Bytes of State, each of them counted once.
class UsedBytes {
 public:
  explicit UsedBytes(const emit::Emittable& emittable)
      : emittable_(emittable), program_(*emittable.program), used_(emittable.layout.size) {}

  void Use(const ir::Inst& inst) {
    ir::ForEachAccess(
        program_, inst, [this](ir::PlaceId place, ir::Access) { Use(place); },
        [this](ir::StateId state) { Use(state); });
  }
  StateBytes bytes() const { return bytes_; }

 private:
  void Use(ir::PlaceId place) {
    const emit::layout::PlaceStorage& storage = emittable_.layout.places[place.index];
    const checks::StoredPlace stored = compilation::StoredAs(program_.places[place], storage);
    Use(stored.offset, stored.bytes, IsRetentive(storage.storage) ? bytes_.retentive : bytes_.volatile_bytes);
  }
  void Use(ir::StateId state) {
    const uint32_t bytes = emit::layout::StructBytes(program_.states[state].kind);
    Use(emittable_.layout.states[state.index].offset, bytes, bytes_.volatile_bytes);
  }
  void Use(uint32_t offset, uint32_t bytes, uint64_t& sum) {
    const size_t end = std::min<size_t>(size_t{offset} + bytes, used_.size());
    for (size_t at = offset; at < end; ++at) {
      sum += used_[at] ? 0 : 1;
      used_[at] = true;
    }
  }

  const emit::Emittable& emittable_;
  const ir::Program& program_;
  std::vector<bool> used_;  // by byte of State
  StateBytes bytes_;
};

}  // namespace

StateBytes StateUsed(const emit::Emittable& emittable, const std::vector<bool>& regions) {
  UsedBytes used(emittable);
  const ir::Program& program = *emittable.program;
  for (uint32_t i = 0; i < regions.size(); ++i) {
    if (!regions[i]) continue;
    for (const ir::InstId id : program.regions[ir::RegionId(i)].insts) used.Use(program[id]);
  }
  return used.bytes();
}

}  // namespace plcxx::measure
