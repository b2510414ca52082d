// Power cut at every write of the retentive store: the same test on the host and on the emulated processors.
//
// A store counts the bytes that are written, and from a chosen one on keeps none; of the word that is being written at
// that moment any part of the bytes may be kept. Behind each cut the content that is read back must be the old or the
// new one, and storing goes on from there, which is cut again.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include <plcxx/retentive_store.h>

namespace plcxx {

struct RetentiveStorage {
  static constexpr uint32_t kBytes = 256;
  static constexpr uint32_t kNever = 0xFFFFFFFF;
  uint8_t bytes[kBytes] = {};
  uint32_t written = 0;       // bytes so far
  uint32_t cut_at = kNever;   // the number of the word's first byte with which power goes
  uint32_t kept_of_word = 0;  // a bit for each byte of that word that is kept nevertheless
};

inline void retentive_storage_read(RetentiveStorage& storage, uint32_t at, void* bytes, uint32_t size) noexcept {
  for (uint32_t i = 0; i < size; ++i) static_cast<uint8_t*>(bytes)[i] = storage.bytes[at + i];
}

inline void retentive_storage_write(RetentiveStorage& storage, uint32_t at, const void* bytes, uint32_t size) noexcept {
  for (uint32_t i = 0; i < size; ++i, ++storage.written) {
    const bool in_torn_word = storage.written >= storage.cut_at && storage.written < storage.cut_at + 4;
    const bool torn_away = in_torn_word && (storage.kept_of_word >> (storage.written - storage.cut_at) & 1U) == 0;
    if (torn_away || (!in_torn_word && storage.written > storage.cut_at)) continue;
    storage.bytes[at + i] = static_cast<const uint8_t*>(bytes)[i];
  }
}

}  // namespace plcxx

namespace plcxx_test {

struct CutCounts {
  uint32_t cuts = 0, wrong = 0, old_content = 0, new_content = 0;
};

template <uint32_t kSize>
class PowerCuts {
 public:
  CutCounts Run() {
    plcxx::RetentiveStorage empty;
    // A new store, one slot in use, both in use, the other order of the two.
    for (uint8_t history = 0; history < 4; ++history) {
      plcxx::RetentiveStorage storage = empty;
      for (uint8_t i = 0; i < history; ++i) Store(storage, static_cast<uint8_t>(10 + i));
      CutEverywhere(storage, history > 0, static_cast<uint8_t>(9 + history), 50, 2);
    }
    return counts_;
  }

 private:
  struct Content {
    uint8_t bytes[kSize];
  };

  static Content Of(uint8_t seed) {
    Content content;
    for (uint32_t i = 0; i < kSize; ++i) content.bytes[i] = static_cast<uint8_t>(seed * 31U + i * 7U + (i >> 3));
    return content;
  }

  static bool Same(const Content& first, const Content& second) {
    for (uint32_t i = 0; i < kSize; ++i) {
      if (first.bytes[i] != second.bytes[i]) return false;
    }
    return true;
  }

  static bool Store(plcxx::RetentiveStorage& storage, uint8_t seed) {
    const Content content = Of(seed);
    return plcxx::StoreRetentive(storage, kSlot, &content, kSize);
  }

  /// Cuts a store of content `next` at every byte, with every part of the torn word, where `old` is what was there.
  void CutEverywhere(const plcxx::RetentiveStorage& before, bool has_old, uint8_t old, uint8_t next, uint8_t depth) {
    plcxx::RetentiveStorage whole = before;
    whole.written = 0;
    whole.cut_at = plcxx::RetentiveStorage::kNever;
    if (!Store(whole, next)) ++counts_.wrong;
    for (uint32_t cut = 0; cut < whole.written; ++cut) {
      for (uint32_t kept = 0; kept < 16; ++kept) {
        // The second cut behind a first one need not try each part of each word.
        if (depth == 1 && (cut + kept) % 5 != 0) continue;
        plcxx::RetentiveStorage storage = before;
        storage.written = 0;
        storage.cut_at = cut;
        storage.kept_of_word = kept;
        static_cast<void>(Store(storage, next));
        ++counts_.cuts;
        Content found{};
        const bool loaded = plcxx::LoadRetentive(storage, kSlot, &found, kSize);
        const bool is_new = loaded && Same(found, Of(next));
        const bool is_old = has_old ? loaded && Same(found, Of(old)) : !loaded;
        if (!is_new && !is_old) ++counts_.wrong;
        if (is_new) ++counts_.new_content;
        if (is_old) ++counts_.old_content;
        if (depth > 1 && (is_new || is_old) && (cut + kept) % 7 == 0) {
          CutEverywhere(storage, is_new || has_old, is_new ? next : old, static_cast<uint8_t>(next + 1), 1);
        }
      }
    }
  }

  static constexpr uint32_t kSlot = plcxx::RetentiveSlotBytes(kSize);
  static_assert(2 * kSlot <= plcxx::RetentiveStorage::kBytes, "the store of the test is too small");

  CutCounts counts_;
};

}  // namespace plcxx_test
