// The lathe of samples/nc110 on a controller without an operating system: its scan runs in the timer's interrupt, the
// image is exchanged with simulated inputs and outputs, and package T is kept in two copies.
//
// Where a real machine differs is marked with "Your machine:".

#include <plcxx/retentive_store.h>

#include "board.h"
#include "lathe.hpp"
#include "link.h"

namespace {

constexpr uint32_t kPeriodMs = 10;  // the cycle of the program
#ifndef EXAMPLE_PROVOKES            // a fault (1) or an endless loop (2) in the scan: how the tests reach the hooks
#define EXAMPLE_PROVOKES 0
#endif
#ifndef EXAMPLE_PERIODS  // until it ends
#define EXAMPLE_PERIODS 200
#endif
#ifndef EXAMPLE_DIGEST  // 1: its last word is a checksum of State after each period
#define EXAMPLE_DIGEST 0
#endif

}  // namespace

// ---- retentive memory
// ------------------------------------------------------------------------------------------------

// Your machine: battery-backed RAM, FRAM or flash. Here memory that the start-up code leaves alone.
struct plcxx::RetentiveStorage {
  volatile uint8_t bytes[2 * plcxx::RetentiveSlotBytes(sizeof(lathe::Retentive))];
};

void plcxx::retentive_storage_read(RetentiveStorage& storage, uint32_t at, void* bytes, uint32_t size) noexcept {
  for (uint32_t i = 0; i < size; ++i) static_cast<uint8_t*>(bytes)[i] = storage.bytes[at + i];
}

void plcxx::retentive_storage_write(RetentiveStorage& storage, uint32_t at, const void* bytes, uint32_t size) noexcept {
  for (uint32_t i = 0; i < size; ++i) storage.bytes[at + i] = static_cast<const uint8_t*>(bytes)[i];
}

namespace {

[[gnu::section(".backup")]] plcxx::RetentiveStorage backup;
constexpr uint32_t kSlotBytes = plcxx::RetentiveSlotBytes(sizeof(lathe::Retentive));

}  // namespace

namespace {
lathe::State machine;
}

// ---- how the scan reaches the control
// --------------------------------------------------------------------------------

struct lathe::Host {
  uint32_t now = 0;  // ms
  bool stored = false;
  uint32_t faults = 0;
  // What the simulated machine remembers of the outputs.
  bool pump = false;
  uint8_t axes_wanted = 0;
  bool machine_on = false;
};

namespace lathe {

uint32_t now_ms(Host& host) noexcept { return host.now; }

// Your machine: read the input modules here. The whole image is written before the scan begins.
void read_inputs(Host& host, State& m) noexcept {
  constexpr Bit kClosed[] = {ESTOK,  LIMXP,  LIMXN, LIMZP,  LIMZN,  P24OK,  PHASOK, CABOK, DRXOK,  DRZOK, SPDRV,
                             SPZERO, OILLVL, THHYD, LUBLVL, THCOOL, THCONV, THTUR,  DOOR,  LOCKED, CHKCL, TSBACK};
  for (const Bit signal : kClosed) m[signal] = true;
  m[TURCOD] = 0x31;
  m[RNGSEN] = 0x01;
  m[I6K21] = true;  // the control has finished its self-test
  m[KEYON] = host.now >= 30 && host.now < 60;
  m[KEYOFF] = host.now < 1800;  // opens when pressed
  m[PRESS] = host.pump;
  m[I0K2] = host.machine_on;
  m[W0K1] = host.axes_wanted;
  machine_link::AfterInputs(m);
}

// Your machine: write the output modules here. `m` does not change meanwhile.
void write_outputs(Host& host, const State& m) noexcept {
  machine_link::BeforeOutputs(machine);
  host.pump = m[HYDPMP];
  host.axes_wanted = m[W10K1];
  host.machine_on = !m[U10K0];
}

void retentive_load(Host&, Retentive& retentive) noexcept {
  static_cast<void>(plcxx::LoadRetentive(backup, kSlotBytes, &retentive, sizeof retentive));
}

void retentive_store(Host& host, const Retentive& retentive) noexcept {
  host.stored = plcxx::StoreRetentive(backup, kSlotBytes, &retentive, sizeof retentive);
}

void fault(Host& host, fault_kind, uint32_t) noexcept { ++host.faults; }

}  // namespace lathe

// ---- the scan in the timer's interrupt
// -------------------------------------------------------------------------------

namespace {

lathe::Host host;
uint32_t digest = 0;
volatile uint32_t periods = 0;  // written by the interrupt only

/// Of one that runs through: the first mistake, or none.
const char* volatile mistake = nullptr;

void Expect(bool holds, const char* what) {
  if (!holds && mistake == nullptr) mistake = what;
}

void CheckTheLathe(uint32_t now) {
  if (now == 1500) Expect(!machine[lathe::MACON], "MACON came before 1.5 s with pressure were over");
  if (now == 1700) Expect(machine[lathe::MACON] && machine[lathe::AXON], "the machine is not on");
  if (now == 1700) machine[lathe::CNTLOW] = 7;
  if (now == 1900) Expect(!machine[lathe::MACON] && machine[lathe::U10K0], "the machine is not off");
}

}  // namespace

void TimerTick() {
  if (EXAMPLE_PROVOKES == 1 && periods == 20) *reinterpret_cast<volatile uint32_t*>(0xFFFFFF00) = 1;
  while (EXAMPLE_PROVOKES == 2 && periods == 20) {
  }
  host.now = periods * kPeriodMs;
  lathe::period(machine, host);
  CheckTheLathe(host.now);
  if (EXAMPLE_DIGEST == 1) {
    digest = plcxx::Crc32(digest, reinterpret_cast<const uint8_t*>(&machine), sizeof machine);
  }
  periods = periods + 1;
}

void FaultHook(FaultKind kind) {
  // Your machine: take the enable of the outputs away first, with as little code as possible.
  board::End(kind == FaultKind::kWatchdog ? "watchdog" : "fault", kind == FaultKind::kWatchdog ? 4 : 3);
}

/// Until the next scan, or for a moment.
void Rest() {
#if EXAMPLE_LINK == 0
  board::WaitForInterrupt();
#else
  machine_link::MoveBytes();
#endif
}

[[noreturn]] void EndWithDigest() {
  char word[] = "digest 00000000";
  for (int i = 14; i > 6; --i, digest >>= 4) word[i] = "0123456789abcdef"[digest & 15];
  board::End(word, 0);
}

int main() {
  lathe::init(machine, host);
#if EXAMPLE_LINK != 0
  board::StartLink();
#endif
  board::StartWatchdog();
  board::StartTimer(1000 * kPeriodMs);
  // The background. It feeds the watchdog only after a scan, so that a scan that hangs and an interrupt that does not
  // come are both found.
  for (uint32_t seen = 0; seen < EXAMPLE_PERIODS;) {
    Rest();
    if (seen != periods) board::FeedWatchdog();
    seen = periods;
  }
  if (EXAMPLE_DIGEST == 1) EndWithDigest();
  if (mistake != nullptr) board::End(mistake, 1);
  // Power off, power on: what the program stored when it was switched off is there again.
  static lathe::State after;
  static lathe::Host next;
  lathe::init(after, next);
  if (!host.stored || host.faults > 0 || after[lathe::CNTLOW] != 7) board::End("package T is not kept", 2);
  board::End("the lathe ran", 0);
}
