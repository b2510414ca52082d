// A window into a running machine: State is read, traced and, where the machine's builder allows it, written and
// forced.
//
// In: bytes of a port, read and written within the scan, never more than a declared number a period. Out: answers, and
// samples of watched places, one a scan. A frame: A5, bytes of payload, command or status, number of the request,
// offset (4 bytes), payload, CRC-16 (of all but A5); numbers have the least significant byte first. What is no frame is
// skipped; what is one and asks for something outside of State is refused. No heap, no blocking, no library.
// Not its job: bytes on the wire (the port), which place has which offset (the symbol map), a bit in the course of a
// part: forces are put in after the inputs and before the outputs, so that the part itself sees what it writes.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace plcxx {

inline constexpr uint8_t kLinkVersion = 1;
inline constexpr uint8_t kLinkStart = 0xA5;
inline constexpr uint8_t kLinkPayload = 64, kLinkHead = 8, kLinkCrc = 2;
inline constexpr uint8_t kLinkFrame = kLinkHead + kLinkPayload + kLinkCrc;  // the longest one
inline constexpr uint8_t kLinkIdentityBytes = 64;                           // those of `plcxx identify`
inline constexpr uint8_t kLinkWatched = 16, kLinkWatchedBytes = 8;          // places of a sample, bytes of one

enum class LinkCommand : uint8_t {
  kIdentity = 1,  // payload: how many bytes; the answer has them, of the program's identity from the offset on
  kLimits = 2,    // likewise, of LinkLimits
  kCounts = 3,    // likewise, of LinkCounts
  kRead = 4,      // likewise, of State
  kWrite = 5,     // payload: masks, then as many values; once, in this period
  kForce = 6,     // likewise; held in each period. A mask of 0 lets the byte go, no payload everything
  kWatch = 7,     // payload: which one of the sample, bytes (0: none). Empties the ring
  kTrace = 8      // payload: how many bytes; those of the ring from the offset on, what is before is forgotten
};

enum class LinkStatus : uint8_t {
  kDone = 0x80,
  kUnknown = 0xC0,   // no such command, or not of this length
  kReadOnly = 0xC1,  // writing is not permitted now
  kOutside = 0xC2,   // not within State
  kNoRoom = 0xC3     // more bytes than can be forced
};

/// What the machine's builder has chosen.
struct LinkLimits {
  uint8_t version;
  uint8_t can_write;
  uint8_t forces;  // bytes that can be forced
  uint8_t reserved;
  uint32_t state_bytes, ring_bytes, period_bytes;
};
static_assert(sizeof(LinkLimits) == 16, "what is sent has no gaps");

struct LinkCounts {
  uint8_t may_write = 0;  // now
  uint8_t forced = 0;     // bytes
  uint16_t reserved = 0;
  uint32_t scans = 0;           // since the start; the number of a sample
  uint32_t lost = 0;            // samples for which the ring had no room
  uint32_t sample_bytes = 0;    // of all watched places; in the ring the number of the scan (4 bytes) is before them
  uint32_t begin = 0, end = 0;  // of what is in the ring, counted in bytes since the start
};
static_assert(sizeof(LinkCounts) == 24, "what is sent has no gaps");

/// CRC-16 (polynomial 1021, begin with FFFF; check value of "123456789" 29B1).
[[gnu::cold]] constexpr uint16_t LinkCrc(const uint8_t* bytes, uint32_t size) noexcept {
  uint32_t crc = 0xFFFF;
  for (uint32_t i = 0; i < size; ++i) {
    uint32_t x = (crc >> 8 ^ bytes[i]) & 0xFFU;
    x ^= x >> 4;
    crc = (crc << 8 ^ x << 12 ^ x << 5 ^ x) & 0xFFFFU;
  }
  return static_cast<uint16_t>(crc);
}

/// What a link costs and may do; a machine's builder derives his own from it, and adds
/// `static constexpr const uint8_t* kIdentity`, kLinkIdentityBytes that `plcxx emit --link` writes.
struct LinkSettings {
  static constexpr bool kCanWrite = false;         // false: there is no code that writes
  static constexpr uint8_t kForces = 32;           // bytes that can be forced at a time
  static constexpr uint32_t kRing = 256;           // bytes of samples: a power of two
  static constexpr uint32_t kBytesPerPeriod = 64;  // received and sent, together
  static constexpr uint32_t kSilentPeriods = 500;  // without a request: then what is forced is let go; 0: never
};

/// One for each machine; zeros at the start are all that it needs.
template <class State, class Settings>
class DebugLink {
 public:
  /// A key switch, say: whether State may be written. At first it may not; when it no longer may, nothing stays forced.
  void Permit(bool may_write) noexcept {
    counts_.may_write = Settings::kCanWrite && may_write ? 1 : 0;
    if (counts_.may_write == 0) counts_.forced = 0;
  }

  /// After the inputs have been read.
  void AfterInputs(State& machine) noexcept {
    state_ = reinterpret_cast<uint8_t*>(&machine);
    if constexpr (Settings::kCanWrite) PutForces();
  }

  /// Before the outputs are written: what is forced, the scan's sample, and the port's bytes. Port:
  /// `bool Get(uint8_t& byte)` and `bool Put(uint8_t byte)`, which come back at once; false: nothing there, no room.
  template <class Port>
  void BeforeOutputs(State& machine, Port& port) noexcept {
    AfterInputs(machine);
    Sample();
    for (uint32_t i = 0; i < Settings::kBytesPerPeriod; ++i) {
      if (sent_ < answer_) {
        if (!port.Put(frame_[sent_])) break;
        ++sent_;
      } else {
        uint8_t byte = 0;
        if (!port.Get(byte)) break;
        Receive(byte);
      }
    }
  }

  const LinkCounts& counts() const noexcept { return counts_; }

 private:
  static_assert(Settings::kRing >= 4 && (Settings::kRing & (Settings::kRing - 1)) == 0, "the ring is a power of two");
  static_assert(Settings::kBytesPerPeriod > 0, "a link without bytes says nothing");

  struct Place {
    uint32_t offset = 0;
    uint8_t bytes = 0;
  };
  struct Force {
    uint32_t offset = 0;
    uint8_t mask = 0, value = 0;
  };

  static bool IsWithin(uint32_t offset, uint32_t count, uint32_t size) noexcept {
    return offset <= size && count <= size - offset;
  }

  [[gnu::noinline, gnu::cold]] void PutForces() noexcept {
    for (uint32_t i = 0; i < counts_.forced; ++i) PutMasked(forces_[i]);
  }
  void PutMasked(const Force& force) noexcept {
    uint8_t& byte = state_[force.offset];
    byte = static_cast<uint8_t>((byte & ~force.mask) | (force.value & force.mask));
  }

  void Add(uint8_t byte) noexcept { ring_[counts_.end++ % Settings::kRing] = byte; }

  [[gnu::noinline, gnu::cold]] void Sample() noexcept {
    ++counts_.scans;
    if constexpr (Settings::kCanWrite && Settings::kSilentPeriods != 0) {
      if (++silent_ > Settings::kSilentPeriods) counts_.forced = 0, silent_ = 0;
    }
    if (counts_.sample_bytes == 0) return;
    if (counts_.sample_bytes + 4 > Settings::kRing - (counts_.end - counts_.begin)) {
      ++counts_.lost;
      return;
    }
    for (uint32_t number = counts_.scans, i = 0; i < 4; ++i, number >>= 8) Add(static_cast<uint8_t>(number));
    for (const Place& place : watched_) {
      for (uint32_t i = 0; i < place.bytes; ++i) Add(state_[place.offset + i]);
    }
  }

  [[gnu::noinline, gnu::cold]] void Receive(uint8_t byte) noexcept {
    if (received_ == 0 && byte != kLinkStart) return;
    frame_[received_++] = byte;
    if (received_ < 2) return;
    if (frame_[1] > kLinkPayload) {
      received_ = 0;
      return;
    }
    if (received_ < kLinkHead + frame_[1] + kLinkCrc) return;
    received_ = 0;
    // The CRC of a text and its own CRC, the high byte first, is 0.
    if (LinkCrc(frame_ + 1, kLinkHead - 1U + frame_[1] + kLinkCrc) != 0) return;
    silent_ = 0;
    const LinkStatus status = Do();
    frame_[2] = static_cast<uint8_t>(status);
    if (status != LinkStatus::kDone) frame_[1] = 0;
    const uint32_t end = static_cast<uint32_t>(kLinkHead) + frame_[1];
    const uint32_t crc = LinkCrc(frame_ + 1, end - 1);
    frame_[end] = static_cast<uint8_t>(crc >> 8);
    frame_[end + 1] = static_cast<uint8_t>(crc);
    answer_ = static_cast<uint8_t>(end + kLinkCrc);
    sent_ = 0;
  }

  /// Does what the frame asks for, and leaves the answer's payload in it.
  LinkStatus Do() noexcept {
    uint32_t offset = frame_[4] | static_cast<uint32_t>(frame_[5]) << 8 | static_cast<uint32_t>(frame_[6]) << 16 |
                      static_cast<uint32_t>(frame_[7]) << 24;
    const uint32_t size = frame_[1];
    uint32_t count = frame_[kLinkHead];
    frame_[1] = 0;
    // What is given: bytes [offset, offset + count) of so many, counted in a ring where it is one.
    const uint8_t* from = nullptr;
    uint32_t there = sizeof(State), ring = 0xFFFFFFFF;
    switch (static_cast<LinkCommand>(frame_[2])) {
      case LinkCommand::kIdentity:
        from = Settings::kIdentity;
        there = kLinkIdentityBytes;
        break;
      case LinkCommand::kLimits:
        from = reinterpret_cast<const uint8_t*>(&kLimits);
        there = sizeof kLimits;
        break;
      case LinkCommand::kCounts:
        from = reinterpret_cast<const uint8_t*>(&counts_);
        there = sizeof counts_;
        break;
      case LinkCommand::kRead:
        from = state_;
        break;
      case LinkCommand::kTrace:
        // An offset that is none of the ring asks where it begins.
        if (offset - counts_.begin <= counts_.end - counts_.begin) counts_.begin = offset;
        for (uint32_t i = 0, begin = counts_.begin; i < 4; ++i, begin >>= 8)
          frame_[4 + i] = static_cast<uint8_t>(begin);
        if (count > counts_.end - counts_.begin) count = counts_.end - counts_.begin;
        from = ring_;
        ring = Settings::kRing - 1;
        offset = counts_.begin & ring;
        there = offset + count;
        break;
      case LinkCommand::kWrite:
      case LinkCommand::kForce:
        if constexpr (Settings::kCanWrite) {
          if (counts_.may_write != 0) return Change(offset, size / 2U);
        }
        return LinkStatus::kReadOnly;
      case LinkCommand::kWatch:
        return size == 2 ? Watch(count, offset, frame_[kLinkHead + 1]) : LinkStatus::kUnknown;
    }
    if (from == nullptr || size != 1 || count > kLinkPayload) return LinkStatus::kUnknown;
    if (!IsWithin(offset, count, there)) return LinkStatus::kOutside;
    for (uint32_t i = 0; i < count; ++i) frame_[kLinkHead + i] = from[(offset + i) & ring];
    frame_[1] = static_cast<uint8_t>(count);
    return LinkStatus::kDone;
  }

  LinkStatus Change(uint32_t offset, uint32_t count) noexcept {
    if (!IsWithin(offset, count, sizeof(State))) return LinkStatus::kOutside;
    const uint8_t* const masks = frame_ + kLinkHead;
    const bool forces = frame_[2] == static_cast<uint8_t>(LinkCommand::kForce);
    if (forces) {
      if (count == 0) counts_.forced = 0;
      // A value of which a part is held is worse than none: there is room for all of its bytes.
      uint32_t wanted = counts_.forced;
      for (uint32_t i = 0; i < count; ++i) wanted += Find(offset + i) == counts_.forced ? 1U : 0U;
      if (wanted > Settings::kForces) return LinkStatus::kNoRoom;
    }
    for (uint32_t i = 0; i < count; ++i) {
      const Force force{offset + i, masks[i], masks[count + i]};
      PutMasked(force);
      if (forces) Hold(force);
    }
    return LinkStatus::kDone;
  }

  /// The entry of a byte, or the first free one.
  [[gnu::noinline, gnu::cold]] uint32_t Find(uint32_t offset) const noexcept {
    uint32_t at = 0;
    while (at < counts_.forced && forces_[at].offset != offset) ++at;
    return at;
  }

  /// There is room for it.
  void Hold(const Force& force) noexcept {
    const uint32_t at = Find(force.offset);
    forces_[at] = force;
    if (at == counts_.forced) ++counts_.forced;
    if (force.mask == 0) forces_[at] = forces_[--counts_.forced];
  }

  LinkStatus Watch(uint32_t number, uint32_t offset, uint8_t bytes) noexcept {
    if (number >= kLinkWatched || bytes > kLinkWatchedBytes) return LinkStatus::kUnknown;
    if (!IsWithin(offset, bytes, sizeof(State))) return LinkStatus::kOutside;
    Place& place = watched_[number];
    counts_.sample_bytes += static_cast<uint32_t>(bytes) - place.bytes;
    place = {offset, bytes};
    counts_.begin = counts_.end;
    counts_.lost = 0;
    return LinkStatus::kDone;
  }

  static constexpr LinkLimits kLimits = {kLinkVersion,
                                         Settings::kCanWrite ? uint8_t{1} : uint8_t{0},
                                         Settings::kCanWrite ? Settings::kForces : uint8_t{0},
                                         0,
                                         sizeof(State),
                                         Settings::kRing,
                                         Settings::kBytesPerPeriod};

  // What is used most has the shortest addresses.
  uint8_t received_ = 0, answer_ = 0, sent_ = 0;
  uint8_t* state_ = nullptr;
  uint32_t silent_ = 0;  // periods
  LinkCounts counts_;
  uint8_t frame_[kLinkFrame] = {};  // the request, then its answer
  Place watched_[kLinkWatched];
  Force forces_[Settings::kCanWrite ? Settings::kForces : 1];
  uint8_t ring_[Settings::kRing] = {};
};

}  // namespace plcxx
