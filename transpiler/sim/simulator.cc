#include "transpiler/sim/simulator.h"

#include <algorithm>
#include <utility>

#include "transpiler/support/check.h"

namespace plcxx::sim {

Simulator::Simulator(const ir::Program& program)
    : program_(program),
      instances_(program),
      values_(program.insts.size() + 2),
      switched_off_(program.statements.size()) {
  for (const ir::Place& place : program.places) places_.push_back(AccessTo(program, place));
  for (const ir::Space& space : program.spaces) spaces_.emplace_back(space.bytes);
  locals_ = FindLocalStretches(program, places_);
  for (uint32_t i = 0; i < program.insts.size(); ++i) {
    const ir::Inst& inst = program[ir::InstId(i)];
    if (inst.op == ir::OpKind::kConst) values_[i] = ir::ConstantValue(inst);
  }
  Decode();
  FindBases();
}

void Simulator::PowerOn() {
  if (last_writes_) last_writes_->Clear();
  for (uint32_t i = 0; i < spaces_.size(); ++i) {
    spaces_[i].Clear();
    for (const ir::InitialByte& initial : program_.spaces[ir::SpaceId(i)].initial) {
      if (initial.offset < spaces_[i].size()) spaces_[i].Write(initial.offset, 0xFF, initial.value);
    }
  }
  instances_.Clear();
  now_ms_ = 0;
  whole_ms_ = 0;
  Run(program_.schedule.init);
}

/// A control's clock wraps; what is told of last writes does not.
void Simulator::SetTime(uint32_t now_ms) {
  whole_ms_ += static_cast<uint32_t>(now_ms - now_ms_);
  now_ms_ = now_ms;
}

void Simulator::RunPeriod(uint32_t now_ms) {
  SetTime(now_ms);
  RunPartition(program_.schedule.period);
}

void Simulator::RunFastOnly(uint32_t now_ms) {
  SetTime(now_ms);
  RunPartition(program_.schedule.fast_only);
}

void Simulator::RunElapse(uint32_t now_ms) {
  SetTime(now_ms);
  RunPartition(program_.schedule.elapse);
}

uint64_t Simulator::Read(const ir::Place& place) { return Get(AccessTo(program_, place), 0); }

void Simulator::Write(const ir::Place& place, uint64_t value) {
  Set(AccessTo(program_, place), 0, value, Writer::kHost);
}

void Simulator::Force(const ir::Place& place, uint64_t value) {
  const PlaceAccess access = AccessTo(program_, place);
  Release(place);  // so that the value gets through; a place that was forced before gets the new one
  Set(access, 0, value, Writer::kForce);
  if (access.kind == AccessKind::kField) {
    instances_.Force(access.owner, access.field, value);
  } else if (access.kind != AccessKind::kAbsent) {
    const auto mask = access.kind == AccessKind::kBit ? static_cast<uint8_t>(1u << access.bit) : uint8_t{0xFF};
    for (uint32_t i = 0; i < access.bytes; ++i) spaces_[access.owner].Force(access.offset + i, mask);
  }
}

void Simulator::Release(const ir::Place& place) {
  const PlaceAccess access = AccessTo(program_, place);
  if (access.kind == AccessKind::kField) {
    instances_.Release(access.owner, access.field);
  } else if (access.kind != AccessKind::kAbsent) {
    const auto mask = access.kind == AccessKind::kBit ? static_cast<uint8_t>(1u << access.bit) : uint8_t{0xFF};
    for (uint32_t i = 0; i < access.bytes; ++i) spaces_[access.owner].Release(access.offset + i, mask);
  }
}

void Simulator::SendText(std::string_view text) {
  if (!program_.text_inbox.valid()) return;
  const uint32_t inbox = program_.text_inbox.index;
  plcxx::SendText(instances_.Get<plcxx::TextInbox>(inbox), text.data(), text.size());
  instances_.Reforce(inbox);
}

void Simulator::EnableStatement(ir::StatementId statement, bool enabled) {
  PLCXX_CHECK(statement.index < switched_off_.size());
  if (switched_off_[statement.index] == !enabled) return;
  switched_off_[statement.index] = !enabled;
  switched_off_count_ += enabled ? size_t{0} - 1 : 1;
}

void Simulator::StoreRetentive() {
  std::vector<uint8_t> image;
  for (uint32_t i = 0; i < spaces_.size(); ++i) {
    if (program_.spaces[ir::SpaceId(i)].lifetime != ir::Lifetime::kRetentive) continue;
    image.insert(image.end(), spaces_[i].bytes().begin(), spaces_[i].bytes().end());
  }
  stored_ = std::move(image);
}

void Simulator::LoadRetentive() {
  if (!stored_) return;
  size_t next = 0;
  for (uint32_t i = 0; i < spaces_.size(); ++i) {
    if (program_.spaces[ir::SpaceId(i)].lifetime != ir::Lifetime::kRetentive) continue;
    for (uint32_t offset = 0; offset < spaces_[i].size(); ++offset) spaces_[i].Write(offset, 0xFF, (*stored_)[next++]);
  }
}

std::vector<HostEvent> Simulator::TakeEvents() { return std::exchange(events_, {}); }

std::vector<uint8_t> Simulator::Snapshot() {
  std::vector<uint8_t> bytes;
  for (uint32_t i = 0; i < spaces_.size(); ++i) {
    if (!program_.spaces[ir::SpaceId(i)].host_visible) continue;
    bytes.insert(bytes.end(), spaces_[i].bytes().begin(), spaces_[i].bytes().end());
  }
  instances_.AppendTo(bytes);
  return bytes;
}

void Simulator::Restore(const Saved& saved) {
  spaces_ = saved.spaces;
  instances_ = saved.instances;
  FindBases();
  stored_ = saved.stored;
  events_.clear();
  stopped_ = false;
}

void Simulator::Exchange(Saved& other) {
  std::swap(spaces_, other.spaces);
  std::swap(instances_, other.instances);
  FindBases();
  std::swap(stored_, other.stored);
  events_.clear();
  stopped_ = false;
}

bool Simulator::IsAt(const Saved& other) const {
  for (uint32_t i = 0; i < spaces_.size(); ++i) {
    const ir::Space& space = program_.spaces[ir::SpaceId(i)];
    // What a routine has for itself begins anew with it.
    if (space.lifetime == ir::Lifetime::kRoutine && !space.host_visible) continue;
    if (spaces_[i].bytes() != other.spaces[i].bytes()) return false;
  }
  return instances_.IsAt(other.instances) && stored_ == other.stored;
}

Simulator::Noted Simulator::SaveNoted() const {
  return {.now_ms = now_ms_, .whole_ms = whole_ms_, .writes = last_writes_ ? *last_writes_ : LastWrites()};
}

void Simulator::RestoreNoted(const Noted& noted) {
  now_ms_ = noted.now_ms;
  whole_ms_ = noted.whole_ms;
  if (last_writes_) *last_writes_ = noted.writes;
}

void Simulator::RecordLastWrites() {
  if (!last_writes_) last_writes_ = std::make_unique<LastWrites>();
}

uint64_t Simulator::Get(const PlaceAccess& access, uint64_t index) const {
  uint32_t offset = access.offset;
  if (access.indexed && !ElementOffset(access, index, offset)) return 0;
  switch (access.kind) {
    case AccessKind::kAbsent:
      return 0;
    case AccessKind::kBit:
      return spaces_[access.owner][offset] >> access.bit & 1;
    case AccessKind::kByte:
      return spaces_[access.owner][offset];
    case AccessKind::kWide: {
      uint64_t value = 0;
      for (uint32_t i = 0; i < access.bytes; ++i) {
        const uint32_t significance = access.big_endian ? access.bytes - 1 - i : i;
        value |= uint64_t{spaces_[access.owner][offset + i]} << (8 * significance);
      }
      return value;
    }
    case AccessKind::kField:
      return instances_.Read(access.owner, access.field);
  }
  PLCXX_UNREACHABLE();
}

void Simulator::Set(const PlaceAccess& access, uint64_t index, uint64_t value, Writer writer) {
  uint32_t offset = access.offset;
  if (access.indexed && !ElementOffset(access, index, offset)) return;
  uint8_t mask = 0xFF;
  switch (access.kind) {
    case AccessKind::kAbsent:
      return;
    case AccessKind::kBit:
      mask = static_cast<uint8_t>(1u << access.bit);
      spaces_[access.owner].Write(offset, mask, (value & 1) != 0 ? mask : uint8_t{0});
      break;
    case AccessKind::kByte:
      spaces_[access.owner].Write(offset, mask, static_cast<uint8_t>(value));
      break;
    case AccessKind::kWide:
      for (uint32_t i = 0; i < access.bytes; ++i) {
        const uint32_t significance = access.big_endian ? access.bytes - 1 - i : i;
        spaces_[access.owner].Write(offset + i, mask, static_cast<uint8_t>(value >> (8 * significance)));
      }
      break;
    case AccessKind::kField:
      instances_.Write(access.owner, access.field, value);
      break;
  }
  if (!last_writes_) return;
  LastWrite write = NewWrite(writer);
  if (access.kind == AccessKind::kField) {
    NoteField(access.owner, access.field, write);
    return;
  }
  if (access.kind == AccessKind::kWide) {
    write.offset = offset;
    write.bytes = access.bytes;
    write.accessed = Get(access, index);
  }
  for (uint32_t i = 0; i < access.bytes; ++i) {
    last_writes_->NoteByte(ir::SpaceId(access.owner), offset + i, mask, spaces_[access.owner][offset + i], write);
  }
}

LastWrite Simulator::NewWrite(Writer writer) const {
  return {.writer = writer,
          .statement = writer == Writer::kProgram ? current_.statement : ir::StatementId(),
          .first_ms = whole_ms_,
          .last_ms = whole_ms_};
}

void Simulator::NoteField(uint32_t instance, uint8_t field, LastWrite write) {
  write.value = instances_.Read(instance, field);
  last_writes_->NoteField(ir::StateId(instance), field, write);
}

void Simulator::Stepped(uint32_t instance) {
  instances_.Reforce(instance);
  if (!last_writes_) return;
  const auto fields = ir::Info(instances_.KindOf(instance)).fields;
  for (uint8_t field = 0, count = static_cast<uint8_t>(fields.size()); field < count; ++field) {
    if (!fields[field].hidden) NoteField(instance, field, NewWrite(Writer::kProgram));
  }
}

}  // namespace plcxx::sim
