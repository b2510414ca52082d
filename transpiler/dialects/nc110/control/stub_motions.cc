// Motions that the program requests, and the selection of programs.

#include <algorithm>
#include <bit>

#include "transpiler/dialects/nc110/control/stub_control.h"

namespace plcxx::nc110 {
namespace {

constexpr Bit kHoldByOperator = BitK(10, 2), kHoldByProgram = BitK(10, 3);
constexpr Bit kMdiMode = BitK(8, 24);
constexpr Byte kFilmasRequest = ByteK(12, 1);
constexpr Bit kFilmasDone = BitK(0, 24);
constexpr Bit kStartRequest = BitK(10, 4), kStartDone = BitK(4, 30), kStartRefused = BitK(4, 31);
constexpr Bit kOrient = BitK(11, 0), kOriented = BitK(0, 25);
constexpr Bit kSelect = BitK(10, 18), kIsCommand = BitK(10, 19), kByRecord = BitK(10, 23), kSelected = BitK(5, 30),
              kNotSelected = BitK(5, 31);
constexpr Byte kSelection = ByteK(17, 0);
constexpr uint32_t kTextConnectors = 10;
constexpr uint8_t kLineFeed = 0x0A;

}  // namespace

void NcStub::Filmas() {
  const uint8_t request = Get(kFilmasRequest);
  if (request != filmas_request_) {
    filmas_request_ = request;
    if (filmas_done_) Put(kFilmasDone, false);
    filmas_done_ = false;
    if (filmas_.running) StopMotions();
  }
  if (request != 0 && !filmas_.running && !filmas_done_) {
    const bool in_m_function = Get(kFunctionsAllowed) && !Get(kReleased);
    const bool idle = Get(kStandBy) && Get(kMdiMode);
    if ((in_m_function || idle) && !start_.running) {
      Begin(filmas_);
      Put(kStandBy, false);
    }
  }
  if (Ends(filmas_)) {
    filmas_done_ = true;
    Put(kFilmasDone, true);
    Put(kStandBy, true);
  }
}

void NcStub::Start() {
  start_request_.Look(Get(kStartRequest));
  if (start_request_.rose()) {
    const bool free = !filmas_.running && !start_.running && !Get(kEmergency) && !Get(kStartDone);
    if (free) {
      Begin(start_);
      Put(kBlock, true);
      Put(kStandBy, false);
    } else {
      Put(kStartRefused, true);
    }
  }
  if (Ends(start_)) {
    Put(kBlock, false);
    Put(kStandBy, true);
    if (Get(kStartRequest)) Put(kStartDone, true);
  }
  if (start_request_.fell()) {
    Put(kStartDone, false);
    Put(kStartRefused, false);
  }
}

void NcStub::Orientation() {
  orientation_request_.Look(Get(kOrient));
  if (orientation_request_.rose()) Begin(orientation_);
  if (orientation_request_.fell()) {
    orientation_.running = false;
    Put(kOriented, false);
  }
  if (Ends(orientation_)) Put(kOriented, true);
}

/// Channel 0 or 1: one axis, switched on by its bit; its target is reached after the time of a motion.
void NcStub::PointToPoint(uint8_t number) {
  Channel& channel = channels_[number];
  const uint8_t axis = Get(ByteK(20, number));
  const auto connector = static_cast<uint16_t>(18 + number), actual = static_cast<uint16_t>(4 + number);
  const auto signal = [number](uint8_t first) { return BitK(5, static_cast<uint8_t>(first + number)); };
  const Bit plus = signal(16), minus = signal(18), in_position = signal(24), busy = signal(26), wrong = signal(28);
  std::array<uint8_t, 4> target{}, position{};
  for (uint8_t i = 0; i < 4; ++i) {
    target[i] = Get(ByteK(connector, i));
    position[i] = Get(ByteN(actual, i));
  }
  const bool one = std::has_single_bit(axis);
  if (axis != channel.axis) {
    Put(busy, one);
    Put(wrong, axis != 0 && !one);
    Put(in_position, false);
    Put(plus, false);
    Put(minus, false);
    channel.motion.running = false;
  }
  if (one && (axis != channel.axis || target != channel.target)) {
    Begin(channel.motion);
    Put(in_position, false);
    // The digits ascend from byte 0: compare from the highest one.
    const bool up = std::lexicographical_compare(position.rbegin(), position.rend(), target.rbegin(), target.rend());
    Put(plus, up);
    Put(minus, !up && position != target);
    channel.target = target;
  }
  channel.axis = axis;
  if (!Ends(channel.motion)) return;
  for (uint8_t i = 0; i < 4; ++i) Put(ByteN(actual, i), channel.target[i]);
  Put(plus, false);
  Put(minus, false);
  Put(in_position, true);
  Put(BitN(3, static_cast<uint8_t>(std::countr_zero(axis))), true);  // homed
}

/// Up to ten connectors of package K hold a text that ends with a line feed.
bool NcStub::HasSelectionText() const {
  const uint32_t first = Get(kSelection);
  for (uint32_t connector = first; connector < first + kTextConnectors && connector < 256; ++connector) {
    for (uint8_t i = 0; i < kBytesPerConnector; ++i) {
      if (Get(ByteK(static_cast<uint16_t>(connector), i)) == kLineFeed) return true;
    }
  }
  return false;
}

void NcStub::ProgramSelection() {
  selection_.Look(Get(kSelect));
  if (selection_.rose()) {
    const bool accepted = Get(kSelection) != 0 && !Get(kReset) && (Get(kByRecord) || HasSelectionText());
    Put(accepted ? kSelected : kNotSelected, true);
    if (accepted && !Get(kIsCommand)) Pulse(kReset);
  }
  if (selection_.fell()) {
    Put(kSelected, false);
    Put(kNotSelected, false);
  }
}

void NcStub::Motions() {
  Filmas();
  Start();
  Orientation();
  PointToPoint(0);
  PointToPoint(1);
  ProgramSelection();
  const bool moving = filmas_.running || start_.running;
  Follow(kHold, moving && (Get(kHoldByOperator) || Get(kHoldByProgram)), hold_);
}

}  // namespace plcxx::nc110
