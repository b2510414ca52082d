#include "transpiler/prove/verify/llvm_ir/object_memory.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "transpiler/symbolic/terms/indexed_write.h"
#include "transpiler/symbolic/terms/look_up.h"

namespace plcxx::prove::verify::llvm_ir {
namespace {

constexpr uint64_t kMostPlaces = 1 << 14;  // that one access may reach
constexpr uint64_t kLargestLocal = 1 << 20;

}  // namespace

terms::TermId ObjectMemory::ReadSlot(const Slots& slots, uint32_t slot) {
  const terms::TermId value = slots.At(slot);
  if (value.valid()) return value;
  if (slot >= initial_.size()) return Undefined(8);
  if (!initial_[slot].valid()) initial_[slot] = environment_.Initial(slot);
  return initial_[slot];
}

uint32_t ObjectMemory::NewLocal(uint64_t bytes, uint64_t align) {
  if (bytes > kLargestLocal) {
    Refuse("a local of " + std::to_string(bytes) + " bytes");
    bytes = 0;
  }
  objects_.push_back(
      {.kind = ObjectKind::kLocal, .first_slot = now_.next_slot, .bytes = bytes, .align = align, .values = {}});
  for (uint64_t i = 0; i < bytes; ++i) slots_.Set(now_.next_slot++, terms::TermId());
  return static_cast<uint32_t>(objects_.size() - 1);
}

ObjectMemory::Reach ObjectMemory::ReachOf(const Object& object, terms::TermId offset, uint32_t bytes) {
  const ValueRange range = ranges_.Of(offset);
  Reach reach;
  if (object.bytes < bytes || range.low > object.bytes - bytes) {
    reach.none = reach.beyond = true;
    return reach;
  }
  reach.low = range.low;
  reach.step = std::max<uint64_t>(range.step, 1);
  const uint64_t last = object.bytes - bytes;
  reach.beyond = range.high > last;
  reach.high = reach.beyond ? reach.low + (last - reach.low) / reach.step * reach.step : range.high;
  if ((reach.high - reach.low) / reach.step >= kMostPlaces) {
    Refuse("an access that may reach more than " + std::to_string(kMostPlaces) + " places");
    reach.none = true;
  }
  return reach;
}

terms::TermId ObjectMemory::IsBeyond(const Reach& reach, terms::TermId offset) {
  return terms_.Or(terms_.Ult(terms_.Const(reach.high, 64), offset), terms_.Ult(offset, terms_.Const(reach.low, 64)));
}

terms::TermId ObjectMemory::LoadAt(const Object& object, uint64_t offset, uint32_t bytes) {
  terms::TermId value;
  for (uint32_t i = 0; i < bytes; ++i) {
    terms::TermId byte;
    if (object.kind == ObjectKind::kConstant) {
      const int16_t known = object.values[offset + i];
      byte = known < 0 ? Undefined(8) : terms_.Const(static_cast<uint64_t>(known), 8);
    } else {
      byte = ReadSlot(object.first_slot + static_cast<uint32_t>(offset) + i);
    }
    value = value.valid() ? terms_.Concat(byte, value) : byte;
  }
  return object.kind == ObjectKind::kLocal && bytes > 1 ? AsStored(object, offset, value) : value;
}

/// The word that was stored there last, if these are its bytes: of a sum they are not put together to the sum again,
/// and only a sum is an address with an offset.
terms::TermId ObjectMemory::AsStored(const Object& object, uint64_t offset, terms::TermId loaded) {
  const auto found = stored_words_.find(object.first_slot + static_cast<uint32_t>(offset));
  if (found == stored_words_.end() || terms_.Width(found->second) != terms_.Width(loaded)) return loaded;
  for (uint8_t low = 0; low < terms_.Width(loaded); low = static_cast<uint8_t>(low + 8)) {
    if (terms_.Extract(found->second, low, 8).index != terms_.Extract(loaded, low, 8).index) return loaded;
  }
  return found->second;
}

terms::TermId ObjectMemory::LoadFrom(terms::TermId when, uint32_t number, terms::TermId offset, uint32_t bytes) {
  const auto width = static_cast<uint8_t>(8 * bytes);
  const Object& object = objects_[number];
  if (object.kind == ObjectKind::kNull && run_.language == CodeRun::Language::kSource) {
    Require(when, "a read through a null pointer");
    return Undefined(width);
  }
  if (object.kind == ObjectKind::kTable) {
    Refuse("a read of an address as a number");
    return Undefined(width);
  }
  if (object.kind == ObjectKind::kHost || object.kind == ObjectKind::kNull) {
    Refuse(object.kind == ObjectKind::kHost ? "a read of the host's own memory" : "a read through a null pointer");
    return Undefined(width);
  }
  const Reach reach = ReachOf(object, offset, bytes);
  constexpr const char* kOutside = "a read outside of its object";
  if (reach.none) {
    Require(when, kOutside);
    return Undefined(width);
  }
  if (reach.beyond) Require(terms_.And(when, IsBeyond(reach, offset)), kOutside);
  std::vector<terms::TableElement> elements;
  for (uint64_t at = reach.low; at <= reach.high; at += reach.step) {
    if (at == reach.high || !terms_.IsFalse(terms_.Eq(offset, terms_.Const(at, 64))))
      elements.push_back({at, LoadAt(object, at, bytes)});
  }
  return terms::LookUp(terms_, terms_.And(context_, when), offset, elements,
                       reach.beyond ? Undefined(width) : terms::TermId());
}

terms::TermId ObjectMemory::Load(const std::vector<Target>& targets, uint64_t at, uint32_t bytes) {
  terms::TermId value;
  for (auto target = targets.rbegin(); target != targets.rend(); ++target) {
    const terms::TermId offset = at == 0 ? target->offset : terms_.Add(target->offset, terms_.Const(at, 64));
    const terms::TermId here = LoadFrom(target->when, target->object, offset, bytes);
    value = value.valid() ? terms_.Ite(target->when, here, value) : here;
  }
  return value;
}

void ObjectMemory::StoreAt(terms::TermId when, const Object& object, uint64_t offset, terms::TermId value) {
  if (object.kind == ObjectKind::kLocal && terms_.Width(value) > 8)
    stored_words_[object.first_slot + static_cast<uint32_t>(offset)] = value;
  for (uint32_t i = 0; i < terms_.Width(value) / 8U; ++i) {
    const uint32_t slot = object.first_slot + static_cast<uint32_t>(offset) + i;
    const terms::TermId byte = terms_.Extract(value, static_cast<uint8_t>(8 * i), 8);
    slots_.Set(slot, terms_.IsTrue(when) ? byte : terms_.Ite(when, byte, ReadSlot(slot)));
  }
}

void ObjectMemory::StoreTo(terms::TermId when, uint32_t number, terms::TermId offset, terms::TermId value) {
  const Object& object = objects_[number];
  if (object.kind == ObjectKind::kNull && run_.language == CodeRun::Language::kSource) {
    Require(when, "a write through a null pointer");
    return;
  }
  const bool writable =
      object.kind == ObjectKind::kState || object.kind == ObjectKind::kLocal || object.kind == ObjectKind::kGlobal;
  if (!writable) {
    Refuse("a write to memory that is neither State nor a local");
    return;
  }
  const uint32_t bytes = terms_.Width(value) / 8U;
  const Reach reach = ReachOf(object, offset, bytes);
  constexpr const char* kOutside = "a write outside of its object";
  if (reach.none) {
    Require(when, kOutside);
    return;
  }
  if (reach.beyond) Require(terms_.And(when, IsBeyond(reach, offset)), kOutside);
  terms::IndexedWrite write(terms_, terms_.And(context_, when), offset, value);
  for (uint64_t at = reach.low; at <= reach.high; at += reach.step) {
    const auto [here, written] = write.At(at);
    StoreAt(terms_.And(when, here), object, at, written);
  }
}

void ObjectMemory::Store(const std::vector<Target>& targets, uint64_t at, terms::TermId value) {
  for (const Target& target : targets) {
    const terms::TermId offset = at == 0 ? target.offset : terms_.Add(target.offset, terms_.Const(at, 64));
    StoreTo(target.when, target.object, offset, value);
  }
}

void ObjectMemory::ForgetLocals(const std::vector<Target>& targets) {
  for (const Target& target : targets) {
    const Object& object = objects_[target.object];
    if (!IsOwnLocal(object)) continue;
    for (uint64_t at = 0; at < object.bytes; ++at)
      slots_.Set(static_cast<uint32_t>(object.first_slot + at), terms::TermId());
  }
}

void ObjectMemory::RequireApart(const std::vector<Target>& to, const std::vector<Target>& from, uint64_t bytes) {
  const terms::TermId length = terms_.Const(bytes, 64);
  for (const Target& one : to) {
    for (const Target& other : from) {
      if (one.object != other.object) continue;
      const terms::TermId up = terms_.Sub(one.offset, other.offset), down = terms_.Sub(other.offset, one.offset);
      const terms::TermId overlap =
          terms_.And(terms_.Ne(one.offset, other.offset), terms_.Or(terms_.Ult(up, length), terms_.Ult(down, length)));
      Require(terms_.And(terms_.And(one.when, other.when), overlap), "a copy onto a part of itself");
    }
  }
}

void ObjectMemory::RequireAligned(const std::vector<Target>& targets, uint64_t align, const char* text) {
  if (align <= 1) return;
  const auto low_bits = static_cast<uint8_t>(std::countr_zero(align));
  for (const Target& target : targets) {
    const Object& object = objects_[target.object];
    if (object.kind == ObjectKind::kHost || object.kind == ObjectKind::kNull) continue;
    if (object.align % align != 0) {
      Require(target.when, text);
      continue;
    }
    const ValueRange range = ranges_.Of(target.offset);
    if (range.low % align == 0 && range.step % align == 0) continue;
    const terms::TermId rest = terms_.Extract(target.offset, 0, low_bits);
    Require(terms_.And(target.when, terms_.Ne(rest, terms_.Const(0, low_bits))), text);
  }
}

}  // namespace plcxx::prove::verify::llvm_ir
