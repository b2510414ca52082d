#include "transpiler/dialects/nc110/control/stub.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "transpiler/dialects/nc110/control/stub_control.h"
#include "transpiler/dialects/nc110/machine/options.h"

namespace plcxx::nc110 {
namespace {

constexpr Bit kSelfTest = BitK(6, 21);
constexpr Bit kSwitchOff = BitK(10, 0), kResetRequest = BitK(10, 1), kFaultOff = BitK(10, 7), kModeLock = BitK(15, 2);
constexpr Byte kAxes = ByteK(0, 1), kAxesRequest = ByteK(10, 1), kEmergencyCode = ByteK(6, 3), kMode = ByteK(8, 3),
               kModeRequest = ByteK(15, 1), kPanelMode = ByteN(1, 3);
constexpr uint8_t kModeMdi = 0x01, kFullOverride = 100;
constexpr uint32_t kPulseCycles = 2;

// What the control raises for two slow cycles: FUAS, FUAT, FUAM, TASC1..TASC3, FUTKO, CUMAN, RESE, BUSY, NSPRES.
constexpr Bit kPulses[] = {BitK(4, 16), BitK(4, 17), BitK(4, 18), BitK(4, 20), BitK(4, 21), BitK(4, 22),
                           BitK(4, 23), BitK(4, 26), kReset,      BitK(9, 16), BitN(0, 6)};
// Cleared by a reset.
constexpr Bit kStrobes[] = {BitK(4, 16), BitK(4, 17), BitK(4, 18), BitK(4, 20), BitK(4, 21),
                            BitK(4, 22), BitK(4, 23), BitK(4, 24), BitK(4, 26)};
constexpr Byte kCodes[] = {ByteK(1, 0), ByteK(1, 1), ByteK(1, 2), ByteK(1, 3), ByteK(2, 0),
                           ByteK(2, 1), ByteK(2, 2), ByteK(2, 3), ByteK(3, 0), ByteK(3, 1),
                           ByteK(4, 0), ByteK(4, 1), ByteK(8, 0), ByteK(8, 1), ByteK(8, 2)};

uint32_t OffsetOf(const Bit& bit) { return bit.connector * kBytesPerConnector + bit.bit / 8u; }
uint8_t MaskOf(const Bit& bit) { return static_cast<uint8_t>(1u << (bit.bit % 8)); }
uint32_t OffsetOf(const Byte& byte) { return byte.connector * kBytesPerConnector + byte.index; }

}  // namespace

bool NcStub::Get(const Bit& bit) const { return (image_->Get(SpaceOf(bit.package), OffsetOf(bit)) & MaskOf(bit)) != 0; }
uint8_t NcStub::Get(const Byte& byte) const { return image_->Get(SpaceOf(byte.package), OffsetOf(byte)); }

void NcStub::Put(const Bit& bit, bool value) {
  const uint8_t is = image_->Get(SpaceOf(bit.package), OffsetOf(bit));
  const auto wanted = static_cast<uint8_t>(value ? is | MaskOf(bit) : is & ~MaskOf(bit));
  if (wanted != is) image_->Set(SpaceOf(bit.package), OffsetOf(bit), wanted);
}
void NcStub::Put(const Byte& byte, uint8_t value) {
  if (Get(byte) != value) image_->Set(SpaceOf(byte.package), OffsetOf(byte), value);
}

void NcStub::Follow(const Bit& bit, bool value, bool& driven) {
  if (value != driven) Put(bit, value);
  driven = value;
}
void NcStub::Follow(const Byte& byte, uint8_t value, uint8_t& driven) {
  if (value != driven) Put(byte, value);
  driven = value;
}

bool NcStub::Ends(Timed& motion) const {
  // By difference, so that the time may wrap.
  if (!motion.running || now_ms_ - motion.end_ms >= 0x80000000U) return false;
  motion.running = false;
  return true;
}

/// A pulse lasts two complete slow cycles, so it waits for the begin of one.
void NcStub::Pulse(const Bit& bit) {
  if (!cycle_begins_) {
    if (std::find(waiting_pulses_.begin(), waiting_pulses_.end(), bit) == waiting_pulses_.end()) {
      waiting_pulses_.push_back(bit);
    }
    return;
  }
  Put(bit, true);
  std::erase_if(pulses_, [&](const RunningPulse& pulse) { return pulse.bit == bit; });
  pulses_.push_back({bit, slow_cycles_});
}

void NcStub::EndPulses() {
  for (const Bit& bit : kPulses) {
    const auto running =
        std::find_if(pulses_.begin(), pulses_.end(), [&](const RunningPulse& pulse) { return pulse.bit == bit; });
    if (running == pulses_.end()) {
      if (!Get(bit)) continue;
      pulses_.push_back({bit, slow_cycles_});  // set by the user
      if (bit == kReset) Reset();
    } else if (slow_cycles_ - running->begin >= kPulseCycles || !Get(bit)) {
      pulses_.erase(running);
      Put(bit, false);
      if (bit == kMStrobe) Put(kMCode, 0);
    }
  }
  if (!cycle_begins_) return;
  for (const Bit& bit : std::exchange(waiting_pulses_, {})) Pulse(bit);
}

void NcStub::Reset() {
  for (const Bit& bit : kStrobes) Put(bit, false);
  for (const Byte& byte : kCodes) Put(byte, 0);
  std::erase_if(pulses_, [](const RunningPulse& pulse) { return pulse.bit != kReset; });
  waiting_pulses_.clear();
  s_code_ = {};
  t_code_ = {};
  index_code_ = {};
  StopMotions();
  Pulse(kReset);
}

void NcStub::StopMotions() {
  if (!filmas_.running && !start_.running) return;
  filmas_.running = start_.running = false;
  Put(kBlock, false);
  Put(kStandBy, true);
  Put(kHold, false);
  hold_ = false;
}

void NcStub::Machine() {
  machine_off_.Look(Get(kSwitchOff));
  fault_off_.Look(Get(kFaultOff));
  emergency_.Look(Get(kEmergency));
  reset_request_.Look(Get(kResetRequest));
  if (machine_off_.fell()) {
    Put(kEmergency, false);
    Put(kEmergencyCode, 0);
    Put(kReady, true);
    Reset();
  }
  if (machine_off_.rose()) {
    Put(kReady, false);
    Reset();
  }
  if (fault_off_.rose() || emergency_.rose()) Put(kReady, false);
  if (reset_request_.rose()) Reset();
  Follow(kAxes, Get(kReady) ? Get(kAxesRequest) : uint8_t{0}, axes_);
}

/// Exactly one mode: the one that was set last, by the user or, where the panel is locked, by the program.
void NcStub::Mode() {
  const auto added = static_cast<uint8_t>(Get(kMode) & ~mode_);
  if (added != 0) mode_ = static_cast<uint8_t>(added & -added);
  const uint8_t requested = Get(kModeRequest);
  if (Get(kModeLock) && std::has_single_bit(requested)) mode_ = requested;
  Put(kMode, mode_);
}

void NcStub::PowerOn(dialects::ImagePort& image) {
  *this = NcStub(motion_ms_);
  image_ = &image;
  Put(kSelfTest, true);
  Put(kStandBy, true);
  Put(kSpindleDone, true);
  mode_ = kModeMdi;
  Put(kMode, mode_);
  Put(kPanelMode, mode_);
  for (uint8_t i = 0; i < 3; ++i) Put(ByteN(1, i), kFullOverride);
  image_ = nullptr;
}

void NcStub::BeforePeriod(uint32_t now_ms, dialects::ImagePort& image) {
  image_ = &image;
  now_ms_ = now_ms;
  EndPulses();
  Machine();
  Mode();
  Functions();
  Motions();
  image_ = nullptr;
}

void NcStub::AfterPeriod(uint32_t, uint32_t slow_cycles, dialects::ImagePort&) {
  cycle_begins_ = slow_cycles != slow_cycles_;
  slow_cycles_ = slow_cycles;
}

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program&, const std::map<std::string, std::string>& options) {
  const auto wanted = options.find("nc-stub");
  if (wanted == options.end() || (wanted->second != "on" && wanted->second != "true")) return nullptr;
  Settings settings;
  ApplyOptions(options, settings);
  return std::make_unique<NcStub>(settings.stub_ms);
}

}  // namespace plcxx::nc110
