#include "transpiler/sim/write_recorder.h"

namespace plcxx::sim {

void WriteRecorder::Begin() {
  if (!writes_) writes_ = std::make_unique<LastWrites>();
}

void WriteRecorder::Note(const Memory& memory, const PlaceAccess& access, uint64_t index, LastWrite write) {
  uint32_t offset = access.offset;
  if (access.indexed && !ElementOffset(access, index, offset)) return;
  switch (access.kind) {
    case AccessKind::kAbsent:
      return;
    case AccessKind::kField:
      return NoteField(memory, access.owner, access.field, write);
    case AccessKind::kBit:
    case AccessKind::kByte:
      break;
    case AccessKind::kWide:
      write.offset = offset;
      write.bytes = access.bytes;
      write.accessed = memory.Get(access, index);
      break;
  }
  const ForcedBytes& space = memory.spaces()[access.owner];
  for (uint32_t i = 0; i < access.bytes; ++i) {
    writes_->NoteByte(ir::SpaceId(access.owner), offset + i, MaskOf(access), space[offset + i], write);
  }
}

void WriteRecorder::NoteFields(const Memory& memory, uint32_t instance, LastWrite write) {
  const auto fields = ir::Info(memory.instances().KindOf(instance)).fields;
  for (uint8_t field = 0, count = static_cast<uint8_t>(fields.size()); field < count; ++field) {
    if (!fields[field].hidden) NoteField(memory, instance, field, write);
  }
}

void WriteRecorder::NoteField(const Memory& memory, uint32_t instance, uint8_t field, LastWrite write) {
  write.value = memory.instances().Read(instance, field);
  writes_->NoteField(ir::StateId(instance), field, write);
}

}  // namespace plcxx::sim
