#include "transpiler/sim/memory.h"

#include <utility>

#include "transpiler/support/check.h"

namespace plcxx::sim {

Memory::Memory(const ir::Program& program) : program_(program), instances_(program) {
  for (const ir::Space& space : program.spaces) spaces_.emplace_back(space.bytes);
}

void Memory::Clear() {
  for (uint32_t i = 0; i < spaces_.size(); ++i) {
    spaces_[i].Clear();
    for (const ir::InitialByte& initial : program_.spaces[ir::SpaceId(i)].initial) {
      if (initial.offset < spaces_[i].size()) spaces_[i].Write(initial.offset, 0xFF, initial.value);
    }
  }
  instances_.Clear();
}

uint64_t Memory::Get(const PlaceAccess& access, uint64_t index) const {
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

void Memory::Set(const PlaceAccess& access, uint64_t index, uint64_t value) {
  uint32_t offset = access.offset;
  if (access.indexed && !ElementOffset(access, index, offset)) return;
  switch (access.kind) {
    case AccessKind::kAbsent:
      return;
    case AccessKind::kBit:
      spaces_[access.owner].Write(offset, MaskOf(access), (value & 1) != 0 ? MaskOf(access) : uint8_t{0});
      break;
    case AccessKind::kByte:
      spaces_[access.owner].Write(offset, 0xFF, static_cast<uint8_t>(value));
      break;
    case AccessKind::kWide:
      for (uint32_t i = 0; i < access.bytes; ++i) {
        const uint32_t significance = access.big_endian ? access.bytes - 1 - i : i;
        spaces_[access.owner].Write(offset + i, 0xFF, static_cast<uint8_t>(value >> (8 * significance)));
      }
      break;
    case AccessKind::kField:
      instances_.Write(access.owner, access.field, value);
      break;
  }
}

void Memory::Force(const PlaceAccess& access, uint64_t value) {
  Release(access);  // so that the value gets through; a place that was forced before gets the new one
  Set(access, 0, value);
  if (access.kind == AccessKind::kField) {
    instances_.Force(access.owner, access.field, value);
  } else if (access.kind != AccessKind::kAbsent) {
    for (uint32_t i = 0; i < access.bytes; ++i) spaces_[access.owner].Force(access.offset + i, MaskOf(access));
  }
}

void Memory::Release(const PlaceAccess& access) {
  if (access.kind == AccessKind::kField) {
    instances_.Release(access.owner, access.field);
  } else if (access.kind != AccessKind::kAbsent) {
    for (uint32_t i = 0; i < access.bytes; ++i) spaces_[access.owner].Release(access.offset + i, MaskOf(access));
  }
}

void Memory::SendText(std::string_view text) {
  if (!program_.text_inbox.valid()) return;
  const uint32_t inbox = program_.text_inbox.index;
  plcxx::SendText(instances_.Get<plcxx::TextInbox>(inbox), text.data(), text.size());
  instances_.Reforce(inbox);
}

void Memory::StoreRetentive() {
  std::vector<uint8_t> image;
  for (uint32_t i = 0; i < spaces_.size(); ++i) {
    if (program_.spaces[ir::SpaceId(i)].lifetime != ir::Lifetime::kRetentive) continue;
    image.insert(image.end(), spaces_[i].bytes().begin(), spaces_[i].bytes().end());
  }
  stored_ = std::move(image);
}

void Memory::LoadRetentive() {
  if (!stored_) return;
  size_t next = 0;
  for (uint32_t i = 0; i < spaces_.size(); ++i) {
    if (program_.spaces[ir::SpaceId(i)].lifetime != ir::Lifetime::kRetentive) continue;
    for (uint32_t offset = 0; offset < spaces_[i].size(); ++offset) spaces_[i].Write(offset, 0xFF, (*stored_)[next++]);
  }
}

std::vector<uint8_t> Memory::Snapshot() const {
  std::vector<uint8_t> bytes;
  for (uint32_t i = 0; i < spaces_.size(); ++i) {
    if (!program_.spaces[ir::SpaceId(i)].host_visible) continue;
    bytes.insert(bytes.end(), spaces_[i].bytes().begin(), spaces_[i].bytes().end());
  }
  instances_.AppendTo(bytes);
  return bytes;
}

void Memory::Restore(const Saved& saved) {
  spaces_ = saved.spaces;
  instances_ = saved.instances;
  stored_ = saved.stored;
}

void Memory::Exchange(Saved& other) {
  std::swap(spaces_, other.spaces);
  std::swap(instances_, other.instances);
  std::swap(stored_, other.stored);
}

bool Memory::IsAt(const Saved& other) const {
  for (uint32_t i = 0; i < spaces_.size(); ++i) {
    const ir::Space& space = program_.spaces[ir::SpaceId(i)];
    // What a routine has for itself begins anew with it.
    if (space.lifetime == ir::Lifetime::kRoutine && !space.host_visible) continue;
    if (spaces_[i].bytes() != other.spaces[i].bytes()) return false;
  }
  return instances_.IsAt(other.instances) && stored_ == other.stored;
}

}  // namespace plcxx::sim
