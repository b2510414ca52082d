// Retentive memory in a store that keeps its bytes without power: two copies, of which a loss of power at any moment
// leaves one whole.
//
// A slot of the store holds: mark, sequence number, size, checksum (each four bytes, least significant first), then the
// content. The older slot is overwritten: its mark is taken away first and set last, so that content changes only while
// there is no mark; a mark of which a part was written is none. The newer of the whole slots counts. The checksum
// (CRC-32 of sequence number, size and content) finds what the store itself has lost.
// In: a store after two functions that the integrator defines. Not its job: which layout of the content a program
// accepts (retentive.h), when it is stored (the control's specification).
#pragma once

#include <stdint.h>

namespace plcxx {

/// The integrator's: battery-backed RAM, FRAM, EEPROM, or two pages of flash.
struct RetentiveStorage;

/// Bytes [at, at + size) of the store. Never more than two slots.
void retentive_storage_read(RetentiveStorage& storage, uint32_t at, void* bytes, uint32_t size) noexcept;
/// Likewise. Comes back when the bytes are kept: a later call must not be kept without an earlier one. Flash erases the
/// page when `at` is the begin of a slot.
void retentive_storage_write(RetentiveStorage& storage, uint32_t at, const void* bytes, uint32_t size) noexcept;

inline constexpr uint32_t kRetentiveHeaderBytes = 16;

/// What a slot needs for a content of `size` bytes; a multiple of 8.
constexpr uint32_t RetentiveSlotBytes(uint32_t size) noexcept { return (kRetentiveHeaderBytes + size + 7U) / 8U * 8U; }

/// CRC-32 (polynomial 04C11DB7, reflected; check value of "123456789" CBF43926), continued from `crc`; begin with 0.
constexpr uint32_t Crc32(uint32_t crc, const uint8_t* bytes, uint32_t size) noexcept {
  crc = ~crc;
  for (uint32_t i = 0; i < size; ++i) {
    crc ^= bytes[i];
    for (uint8_t bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

namespace retentive_internal {

inline constexpr uint32_t kWhole = 0x600DC0DE;  // no byte is 00, which a mark taken away has
inline constexpr uint32_t kChunk = 32;

inline void PutWord(uint8_t* bytes, uint32_t value) noexcept {
  for (uint8_t i = 0; i < 4; ++i) bytes[i] = static_cast<uint8_t>(value >> (8 * i));
}

inline uint32_t GetWord(const uint8_t* bytes) noexcept {
  uint32_t value = 0;
  for (uint8_t i = 0; i < 4; ++i) value |= static_cast<uint32_t>(bytes[i]) << (8 * i);
  return value;
}

struct Slot {
  bool whole;
  uint32_t sequence;
};

/// Reads a slot through and checks it; with `content` also whether it holds just that.
inline Slot Examine(RetentiveStorage& storage, uint32_t at, uint32_t size, const uint8_t* content,
                    bool& same) noexcept {
  uint8_t header[kRetentiveHeaderBytes] = {};
  retentive_storage_read(storage, at, header, kRetentiveHeaderBytes);
  Slot slot{false, GetWord(header + 4)};
  same = content != nullptr;
  if (GetWord(header) != kWhole || GetWord(header + 8) != size) return slot;
  uint32_t crc = Crc32(0, header + 4, 8);
  for (uint32_t done = 0; done < size;) {
    uint8_t chunk[kChunk] = {};
    const uint32_t count = size - done < kChunk ? size - done : kChunk;
    retentive_storage_read(storage, at + kRetentiveHeaderBytes + done, chunk, count);
    crc = Crc32(crc, chunk, count);
    for (uint32_t i = 0; i < count && same; ++i) same = chunk[i] == content[done + i];
    done += count;
  }
  slot.whole = crc == GetWord(header + 12);
  return slot;
}

/// Which of two whole slots is the newer one; sequence numbers wrap.
constexpr bool IsNewer(const Slot& slot, const Slot& other) noexcept {
  return slot.whole && (!other.whole || static_cast<int32_t>(slot.sequence - other.sequence) > 0);
}

}  // namespace retentive_internal

/// The content stored last, into `bytes`. False, and `bytes` is untouched, when there is none of this size.
/// `slot_bytes`: the distance of the two slots, RetentiveSlotBytes(size) or more (the size of a page of flash).
inline bool LoadRetentive(RetentiveStorage& storage, uint32_t slot_bytes, void* bytes, uint32_t size) noexcept {
  if (slot_bytes < RetentiveSlotBytes(size)) return false;
  bool same = false;
  const retentive_internal::Slot first = retentive_internal::Examine(storage, 0, size, nullptr, same);
  const retentive_internal::Slot second = retentive_internal::Examine(storage, slot_bytes, size, nullptr, same);
  if (!first.whole && !second.whole) return false;
  const uint32_t at = retentive_internal::IsNewer(second, first) ? slot_bytes : 0;
  retentive_storage_read(storage, at + kRetentiveHeaderBytes, bytes, size);
  return true;
}

/// Stores a content. When power is lost before it comes back, LoadRetentive gives this content or the one before.
/// Nothing is written when the store holds it already. False, and nothing is written, when the slots are too small.
inline bool StoreRetentive(RetentiveStorage& storage, uint32_t slot_bytes, const void* bytes, uint32_t size) noexcept {
  if (slot_bytes < RetentiveSlotBytes(size)) return false;
  const auto* const content = static_cast<const uint8_t*>(bytes);
  bool first_same = false, second_same = false;
  const retentive_internal::Slot first = retentive_internal::Examine(storage, 0, size, content, first_same);
  const retentive_internal::Slot second = retentive_internal::Examine(storage, slot_bytes, size, content, second_same);
  const bool second_counts = retentive_internal::IsNewer(second, first);
  const retentive_internal::Slot& newest = second_counts ? second : first;
  if (newest.whole && (second_counts ? second_same : first_same)) return true;

  const uint32_t at = second_counts || !newest.whole ? 0 : slot_bytes;
  uint8_t header[kRetentiveHeaderBytes] = {};
  retentive_internal::PutWord(header + 4, newest.whole ? newest.sequence + 1 : 1);
  retentive_internal::PutWord(header + 8, size);
  retentive_internal::PutWord(header + 12, Crc32(Crc32(0, header + 4, 8), content, size));
  retentive_storage_write(storage, at, header, 4);  // no mark
  retentive_storage_write(storage, at + 4, header + 4, kRetentiveHeaderBytes - 4);
  retentive_storage_write(storage, at + kRetentiveHeaderBytes, content, size);
  retentive_internal::PutWord(header, retentive_internal::kWhole);
  retentive_storage_write(storage, at, header, 4);
  return true;
}

}  // namespace plcxx
