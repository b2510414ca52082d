#include "transpiler/dialects/prostep/control/stub_axes.h"

#include <algorithm>
#include <bit>

namespace plcxx::prostep {
namespace {

constexpr uint32_t kFirstBase = 100, kBytesPerAxis = 10, kFirstStatus = 34, kFirstControl = 34;

// Bits of the first control byte, O base + 6.
constexpr uint8_t kAbort = 0, kStartHoming = 1, kStartPositioning = 3, kSetPosition = 6, kReset = 7;
// Mode bits of the second one, O base + 7, and the options of a rotary axis in it.
constexpr uint8_t kModes = 0x0E, kModeHoming = 0x02, kModeJog = 0x04, kModePositioning = 0x08, kWays = 0xE0;
// The axis' control word.
constexpr uint8_t kReady = 2, kReferenceSwitch = 4, kFeedEnable = 5;  // first byte
constexpr uint8_t kLocked = 3, kJogMinus = 6, kJogPlus = 7;           // second byte
// Its status byte.
constexpr uint8_t kMovesMinus = 2, kMovesPlus = 3, kReferenced = 4, kIsReady = 5, kIsPlcAxis = 6;
// I base + 4: how the operation ended; then the causes.
constexpr uint8_t kStarted = 0x01, kDone = 0x02, kAborted = 0x04, kFailed = 0x0C;
constexpr uint8_t kNoMode = 0, kSeveralModes = 1, kModeLost = 2, kWaysConflict = 3, kNoSpeed = 4, kNoWay = 5;  // + 5
constexpr uint8_t kNoEnable = 1, kNotReady = 2, kIsLocked = 3;                                                 // + 6
constexpr uint32_t kState = 4, kCauses = 5, kMoreCauses = 6;
constexpr uint32_t kJogSpeed = 1000;

bool Has(uint8_t byte, uint8_t bit) { return (byte >> bit & 1) != 0; }

}  // namespace

void PlcAxes::PutIn(uint32_t byte, uint8_t value) {
  if (In(byte) != value) image_->Set(inputs_, byte, value);
}
void PlcAxes::PutInBit(uint32_t byte, uint8_t bit, bool value) {
  const auto mask = static_cast<uint8_t>(1u << bit);
  PutIn(byte, static_cast<uint8_t>(value ? In(byte) | mask : In(byte) & ~mask));
}
void PlcAxes::PutOut(uint32_t byte, uint8_t value) {
  if (Out(byte) != value) image_->Set(outputs_, byte, value);
}

int32_t PlcAxes::Target(const Addresses& at) const {
  uint32_t target = 0;
  for (uint32_t i = 0; i < 4; ++i) target |= uint32_t{Out(at.base + i)} << 8 * i;
  return static_cast<int32_t>(target);
}

void PlcAxes::ClearStatus(const Addresses& at) {
  for (uint32_t i = kState; i < kState + 4; ++i) PutIn(at.base + i, 0);
}
void PlcAxes::ClearControl(const Addresses& at) {
  PutOut(at.base + 6, 0);
  PutOut(at.base + 7, 0);
}

void PlcAxes::Move(uint32_t elapsed_ms, dialects::ImagePort& image) {
  image_ = &image;
  for (uint32_t j = 0; j < count_; ++j) {
    MoveOne(axes_[j], {kFirstBase + kBytesPerAxis * j, kFirstStatus + j, kFirstControl + 2 * j}, elapsed_ms);
  }
  image_ = nullptr;
}

void PlcAxes::MoveOne(Axis& axis, const Addresses& at, uint32_t elapsed_ms) {
  const int32_t before = axis.position_um;
  const bool ready = OutBit(at.control, kReady);
  PutInBit(at.status, kIsPlcAxis, true);
  PutInBit(at.status, kIsReady, ready);

  const uint8_t control = Out(at.base + 6);
  const auto rises = [&](uint8_t bit) { return Has(control, bit) && !Has(axis.control_was, bit); };
  if (Has(control, kReset)) {
    axis.operation = Operation::kNone;
    ClearControl(at);
    ClearStatus(at);
  } else if (Has(control, kAbort) && axis.operation != Operation::kNone) {
    axis.operation = Operation::kNone;
    PutIn(at.base + kState, kAborted);
    PutIn(at.base + kCauses, 0);
    PutOut(at.base + 6, 0);
  } else if (Has(control, kSetPosition) && !ready) {
    axis.position_um = Target(at);
    ClearControl(at);
    ClearStatus(at);
  } else if (rises(kStartHoming)) {
    Start(axis, at, Operation::kHoming);
  } else if (rises(kStartPositioning)) {
    Start(axis, at, Operation::kPositioning);
  } else if (axis.operation != Operation::kNone) {
    Run(axis, at, elapsed_ms);
  } else {
    Jog(axis, at, elapsed_ms);
  }
  axis.control_was = Out(at.base + 6);

  const bool by_motion = !Has(control, kSetPosition);
  PutInBit(at.status, kMovesPlus, by_motion && axis.position_um > before);
  PutInBit(at.status, kMovesMinus, by_motion && axis.position_um < before);
  const int64_t way = by_motion ? int64_t{axis.position_um} - before : 0;
  const auto difference = static_cast<uint16_t>(way / 3);
  PutIn(at.base + 8, static_cast<uint8_t>(difference));
  PutIn(at.base + 9, static_cast<uint8_t>(difference >> 8));
  for (uint32_t i = 0; i < 4; ++i) {
    PutIn(at.base + i, static_cast<uint8_t>(static_cast<uint32_t>(axis.position_um) >> 8 * i));
  }
}

void PlcAxes::Start(Axis& axis, const Addresses& at, Operation operation) {
  ClearStatus(at);
  const bool homing = operation == Operation::kHoming;
  const uint8_t mode = Out(at.base + 7) & kModes, own = homing ? kModeHoming : kModePositioning;
  uint8_t causes = 0, more = 0;
  const auto add = [](uint8_t& to, bool condition, uint8_t bit) {
    if (condition) to = static_cast<uint8_t>(to | 1u << bit);
  };
  const int modes = std::popcount(mode);
  add(causes, modes == 0 || (modes == 1 && mode != own), kNoMode);
  add(causes, modes > 1, kSeveralModes);
  add(more, !OutBit(at.control, kReady), kNotReady);
  add(more, !OutBit(at.control, kFeedEnable), kNoEnable);
  add(more, OutBit(at.control + 1, kLocked), kIsLocked);
  if (!homing) {
    add(causes, Out(at.base + 4) == 0 && Out(at.base + 5) == 0, kNoSpeed);
    add(causes, Target(at) == axis.position_um, kNoWay);
    add(causes, std::popcount(static_cast<uint8_t>(Out(at.base + 7) & kWays)) > 1, kWaysConflict);
  }
  PutIn(at.base + kCauses, causes);
  PutIn(at.base + kMoreCauses, more);
  axis.rest = 0;
  if (causes != 0 || more != 0) {
    axis.operation = Operation::kNone;
    PutIn(at.base + kState, kFailed);
    return;
  }
  axis.operation = operation;
  PutIn(at.base + kState, kStarted);
  if (!homing) return;
  PutOut(at.base + 6, static_cast<uint8_t>(Out(at.base + 6) & ~(1u << kStartHoming)));
  PutInBit(at.status, kReferenced, false);
}

int64_t PlcAxes::Way(Axis& axis, uint32_t mm_per_min, uint32_t elapsed_ms) {
  const uint64_t sixtieths = uint64_t{mm_per_min} * elapsed_ms + axis.rest;
  axis.rest = static_cast<uint32_t>(sixtieths % 60);
  return static_cast<int64_t>(sixtieths / 60);
}

void PlcAxes::Run(Axis& axis, const Addresses& at, uint32_t elapsed_ms) {
  const bool homing = axis.operation == Operation::kHoming;
  if ((Out(at.base + 7) & (homing ? kModeHoming : kModePositioning)) == 0) {
    axis.operation = Operation::kNone;
    PutIn(at.base + kState, kFailed);
    PutInBit(at.base + kCauses, kModeLost, true);
    return;
  }
  if (homing) {
    if (!OutBit(at.control, kReferenceSwitch)) return;
    axis.position_um = 0;
    PutInBit(at.status, kReferenced, true);
  } else {
    const uint32_t speed = Out(at.base + 4) | uint32_t{Out(at.base + 5)} << 8;
    const int64_t left = int64_t{Target(at)} - axis.position_um;
    const int64_t way = std::min(Way(axis, speed, elapsed_ms), left < 0 ? -left : left);
    axis.position_um = static_cast<int32_t>(axis.position_um + (left < 0 ? -way : way));
    if (axis.position_um != Target(at)) return;
  }
  axis.operation = Operation::kNone;
  PutIn(at.base + kState, kDone);
}

void PlcAxes::Jog(Axis& axis, const Addresses& at, uint32_t elapsed_ms) {
  const uint8_t mode = Out(at.base + 7) & kModes;
  if ((mode & kModeJog) == 0) return;
  if (mode != kModeJog) return PutInBit(at.base + kCauses, kSeveralModes, true);
  const bool plus = OutBit(at.control + 1, kJogPlus), minus = OutBit(at.control + 1, kJogMinus);
  if (plus == minus) return;
  const int64_t way = Way(axis, kJogSpeed, elapsed_ms);
  axis.position_um = static_cast<int32_t>(axis.position_um + (plus ? way : -way));
}

}  // namespace plcxx::prostep
