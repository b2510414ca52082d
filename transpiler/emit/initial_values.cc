#include "transpiler/emit/initial_values.h"

#include <utility>

namespace plcxx::emit {
namespace {

/// The initial bytes, gathered to the values that they are parts of.
class InitialValues {
 public:
  explicit InitialValues(const Emittable& emittable) : emittable_(emittable) {
    for (uint32_t s = 0; s < emittable.program->spaces.size(); ++s) Space(ir::SpaceId(s));
  }

  std::map<layout::Storage, InitialArray> Take() { return std::move(arrays_); }

 private:
  void Add(layout::Storage storage, std::string_view member, ir::Type type, InitialElement initial) {
    InitialArray& array = arrays_[storage];
    array.member = "m." + std::string(member);
    array.type = type;
    array.values.emplace(initial.index, initial).first->second.value |= initial.value;
  }

  void Space(ir::SpaceId id) {
    const ir::Space& space = emittable_.program->spaces[id];
    if (emittable_.layout.bytes[id.index].empty()) return;
    for (const ir::InitialByte& initial : space.initial) {
      if (initial.value != 0) Byte(emittable_.layout.bytes[id.index][initial.offset], id, initial);
    }
  }

  void Byte(const layout::ByteStorage& stored, ir::SpaceId id, const ir::InitialByte& initial) {
    const uint32_t index = stored.whole.index;
    if (layout::IsWord(stored.whole.storage)) {
      const layout::WordMember& word = layout::WordMemberOf(stored.whole.storage);
      for (const layout::Member& member : emittable_.layout.members) {
        if (member.name != word.name) continue;
        const uint32_t significance = (stored.whole.offset - member.offset) % member.element_bytes;
        Add(stored.whole.storage, word.name, word.type,
            {index, id, initial.offset, uint64_t{initial.value} << (8 * significance)});
      }
    } else if (stored.whole.storage == layout::Storage::kRetentiveByte) {
      Add(layout::Storage::kRetentiveByte, "retentive.bytes", ir::Type::kI8,
          {index, id, initial.offset, initial.value});
    } else if (stored.whole.storage == layout::Storage::kByte) {
      Add(layout::Storage::kByte, "byte", ir::Type::kI8, {index, id, initial.offset, initial.value});
    } else {
      uint32_t left = initial.value;
      for (const layout::PlaceStorage& bit : stored.bits) {
        if (bit.storage == layout::Storage::kBit && (left & 1) != 0)
          Add(layout::Storage::kBit, "bit", ir::Type::kBit, {bit.index, id, initial.offset, 1});
        left >>= 1;
      }
    }
  }

  const Emittable& emittable_;
  std::map<layout::Storage, InitialArray> arrays_;
};

}  // namespace

std::map<layout::Storage, InitialArray> InitialArraysOf(const Emittable& emittable) {
  return InitialValues(emittable).Take();
}

}  // namespace plcxx::emit
