#!/usr/bin/env python3
"""What a link costs a scan, and that nothing sent into it changes one: the lathe's scan on an emulated Cortex-M4 and RV32,
instructions counted.

cost.py ROOT [--table]

The same 400 periods run without a link; with one that nobody uses; with one that samples 16 places and is read as fast as
it allows; with one that gets random bytes and random frames with right CRCs, at the most that it takes. After each period
State must be what it is without a link. Fails where a period costs more than its bound, which docs/debug_link.md names.
"""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(ROOT / "tests" / "bench"))
sys.dont_write_bytecode = True
import emulated  # noqa: E402

# Instructions of the link in a period of 64 bytes, at most, by board: nothing to do; anything.
BOUNDS = {"M4": (120, 7000), "RV32": (60, 7000)}

MAIN = r"""
#include <plcxx/debug_link.h>
#include "lathe.hpp"
#ifndef CAN_WRITE
#define CAN_WRITE 0
#endif
static const uint8_t identity[plcxx::kLinkIdentityBytes] = {'p', 'l', 'c', 'x', 'x', '-', 'i', 'd', 1};
struct Settings : plcxx::LinkSettings {
  static constexpr bool kCanWrite = CAN_WRITE;
  static constexpr const uint8_t* kIdentity = identity;
};
static uint32_t seed = 20261126;
static uint32_t Random() { seed = seed * 1664525u + 1013904223u; return seed >> 8; }
enum Mode { kWithout, kIdle, kTraced, kRubbish, kFrames, kModes };
static int mode;
// What comes: frames, or rubbish, one after the other.
struct Port {
  uint8_t bytes[256];
  uint32_t at = 0, size = 0;
  uint32_t moved = 0;
  uint8_t watches = 0;
  uint32_t position = 0;
  uint8_t seen = 0;  // bytes of an answer
  uint8_t answer[8];
  void Add(uint8_t command, uint32_t offset, const uint8_t* payload, uint8_t count) {
    uint8_t* const frame = bytes + size;
    frame[0] = plcxx::kLinkStart; frame[1] = count; frame[2] = command; frame[3] = 1;
    for (int i = 0; i < 4; ++i) frame[4 + i] = static_cast<uint8_t>(offset >> (8 * i));
    for (int i = 0; i < count; ++i) frame[8 + i] = payload[i];
    const uint16_t crc = plcxx::LinkCrc(frame + 1, 7u + count);
    frame[8 + count] = static_cast<uint8_t>(crc >> 8);
    frame[9 + count] = static_cast<uint8_t>(crc);
    size += 10u + count;
  }
  // Outside of what is measured.
  void Prepare() {
    if (mode == kTraced && at != size) return;
    for (uint32_t i = 0; i < size - at; ++i) bytes[i] = bytes[at + i];
    size -= at;
    at = 0;
    while (size < 128) {
      uint8_t payload[64];
      if (mode == kTraced) {
        const bool all = watches == 16;
        payload[0] = all ? 64 : watches;
        payload[1] = 8;
        Add(all ? 8 : 7, all ? position : 500u + 8u * watches, payload, all ? 1 : 2);
        if (!all) ++watches;
        return;
      }
      const uint8_t count = static_cast<uint8_t>((Random() & 3) == 0 ? Random() % 65 : Random() % 3);
      for (int i = 0; i < count; ++i) payload[i] = static_cast<uint8_t>(Random());
      if (mode == kRubbish) {
        for (int i = 0; i < 64; ++i) bytes[size++] = (Random() & 7) == 0 ? plcxx::kLinkStart : static_cast<uint8_t>(Random());
      } else {
        Add(static_cast<uint8_t>(Random() % 10), (Random() & 1) != 0 ? Random() % 1200 : Random() << 8, payload, count);
      }
    }
  }
  bool Get(uint8_t& byte) {
    if (mode == kIdle || at == size) return false;
    ++moved;
    byte = bytes[at++];
    return true;
  }
  bool Put(uint8_t byte) {
    ++moved;
    if (seen < 8) answer[seen] = byte;
    ++seen;
    if (seen >= 8 && seen == 10 + answer[1]) {
      if (answer[2] == 0x80 && mode == kTraced && watches == 16) {
        uint32_t begin = 0;
        for (int i = 0; i < 4; ++i) begin |= static_cast<uint32_t>(answer[4 + i]) << (8 * i);
        position = begin + answer[1];
      }
      seen = 0;
    }
    return true;
  }
};
static lathe::State machine;
static plcxx::DebugLink<lathe::State, Settings> link;
static Port port;
struct lathe::Host { uint32_t now; };
static uint32_t spent;
namespace lathe {
uint32_t now_ms(Host& host) noexcept { return host.now; }
void read_inputs(Host& host, State& m) noexcept {
  static constexpr Bit kClosed[] = {ESTOK, LIMXP, LIMXN, LIMZP, LIMZN, P24OK, PHASOK, CABOK, DRXOK, DRZOK, SPDRV, SPZERO, OILLVL,
                             THHYD, LUBLVL, THCOOL, THCONV, THTUR, LOCKED, CHKCL, TSBACK};
  for (const Bit signal : kClosed) m[signal] = true;
  m[TURCOD] = 0x31;
  m[RNGSEN] = 1;
  m[I6K21] = true;
  m[DOOR] = (host.now / 370) % 2 == 0;
  m[KEYON] = host.now >= 30 && host.now < 60;
  m[KEYOFF] = host.now < 3000;
  m[PRESS] = m[HYDPMP];
  if (mode == kWithout) return;
  const uint32_t begin = Ticks();
  link.AfterInputs(m);
  spent += Ticks() - begin;
}
void write_outputs(Host&, const State&) noexcept {
  if (mode == kWithout) return;
  port.Prepare();
  const uint32_t begin = Ticks();
  link.BeforeOutputs(machine, port);
  spent += Ticks() - begin;
}
void retentive_load(Host&, Retentive&) noexcept {}
void retentive_store(Host&, const Retentive&) noexcept {}
void fault(Host&, fault_kind, uint32_t) noexcept {}
}
static uint32_t Digest() {
  uint32_t sum = 2166136261u;
  for (uint32_t i = 0; i < sizeof machine; ++i) sum = (sum ^ reinterpret_cast<const uint8_t*>(&machine)[i]) * 16777619u;
  return sum;
}
static const uint32_t kPeriods = 400;
static uint32_t digests[kPeriods];
static void Clear(void* object, uint32_t size) { for (uint32_t i = 0; i < size; ++i) static_cast<volatile uint8_t*>(object)[i] = 0; }
void Measure() {
  for (mode = kWithout; mode < kModes; ++mode) {
    Clear(&machine, sizeof machine);
    Clear(&link, sizeof link);
    Clear(&port, sizeof port);
    lathe::Host host{0};
    lathe::init(machine, host);
    uint64_t total = 0, of_link = 0;
    uint32_t worst = 0, moved = 0, most = 0, different = 0;
    for (uint32_t i = 0; i < kPeriods; ++i) {
      host.now = 10 * i;
      spent = 0;
      port.moved = 0;
      const uint32_t begin = Ticks();
      lathe::period(machine, host);
      total += (Ticks() - begin) * static_cast<uint64_t>(kInstructions);
      spent *= kInstructions;
      of_link += spent;
      if (spent > worst) worst = spent;
      moved += port.moved;
      if (port.moved > most) most = port.moved;
      if (mode == kWithout) digests[i] = Digest();
      if (digests[i] != Digest()) ++different;
    }
    Print(total / kPeriods); Print(of_link / kPeriods); Print(worst); Print(moved); Print(most); Print(different); Print("\n");
  }
}
"""
NAMES = ["without a link", "nobody connected", "16 places of 8 bytes, read at once", "random bytes", "random frames"]


def main():
    lathe = ROOT / "samples" / "nc110" / "lathe_16k20" / "generated"
    ran = False
    rows = []
    for name, board in emulated.BOARDS.items():
        with tempfile.TemporaryDirectory() as folder:
            directory = pathlib.Path(folder)
            include = ["-I", str(ROOT / "runtime_support"), "-I", str(lathe)]
            try:
                subprocess.run([board["prefix"] + "g++", "-std=c++17", "-O2", "-fno-exceptions", "-fno-rtti", "-ffreestanding",
                                *board["flags"], *include, "-c", str(lathe / "lathe.cpp"), "-o", "lathe.o"], cwd=directory, check=True)
            except FileNotFoundError:
                continue
            text = emulated.execute(name, directory, MAIN, ["lathe.o"], include)
        if text is None:
            continue
        ran = True
        lines = [[int(word) for word in line.split()] for line in text.splitlines()]
        if len(lines) != len(NAMES) or any(len(line) != 6 for line in lines):
            sys.exit(f"{name}: no figures from the emulator: {text}")
        scan = lines[0][0]
        for what, (_, link, worst, moved, most, different) in zip(NAMES, lines):
            rows.append((name, what, scan + link, link, worst, moved, most))
            bound = BOUNDS[name][0 if what == "nobody connected" else 1]
            if different:
                sys.exit(f"{name}, {what}: State differs after {different} periods from what it is without a link")
            if worst > bound:
                sys.exit(f"{name}, {what}: {worst} instructions of the link in a period, more than {bound}")
            if most > 64:
                sys.exit(f"{name}, {what}: {most} bytes in a period")
            if what in NAMES[2:] and moved < 20000:
                sys.exit(f"{name}, {what}: only {moved} bytes were moved: nothing was tried")
    if not ran:
        print("no compiler and emulator of a board")
        return 77
    print(f"{'board':6}{'what the link does':36}{'instructions of a period':>26}{'of the link':>13}{'at most':>9}{'bytes':>8}{'at most':>9}")
    for name, what, mean, link, worst, moved, most in rows:
        print(f"{name:6}{what:36}{mean:>26,}{link:>13,}{worst:>9,}{moved:>8,}{most:>9}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
