// Strobes of M, S, T and index axis, tool update, spindle change, and the small answers.

#include "transpiler/dialects/nc110/control/stub_control.h"

namespace plcxx::nc110 {
namespace {

constexpr Bit kSStrobe = BitK(4, 16), kTStrobe = BitK(4, 17), kIndexStrobe = BitK(4, 20);
constexpr Bit kIndexHomed = BitK(10, 27);
constexpr Bit kFirstRange = BitK(6, 16), kSpindleUsed = BitK(6, 23);
constexpr Byte kRangeNumber = ByteN(6, 1);
constexpr Bit kToolRequest = BitK(10, 21), kToolDone = BitK(0, 27), kToolRefused = BitK(0, 26);
constexpr Byte kSpindleRequest = ByteK(11, 3);
constexpr Bit kSpindleRefused = BitK(0, 30);
constexpr uint32_t kSpindleCycles = 2;

template <size_t kCount>
bool IsZero(const std::array<uint8_t, kCount>& bytes) {
  for (const uint8_t byte : bytes) {
    if (byte != 0) return false;
  }
  return true;
}

}  // namespace

/// The code waits for CEFA; code and strobe end together.
void NcStub::MFunction() {
  if (Get(kMCode) != 0 && !Get(kMStrobe) && Get(kFunctionsAllowed)) Pulse(kMStrobe);
}

void NcStub::SFunction() {
  const std::array<uint8_t, 3> code = {Get(ByteK(8, 0)), Get(ByteK(8, 1)), Get(ByteK(8, 2))};
  if (code != s_code_) {
    s_code_ = code;
    if (!IsZero(code)) {
      Put(kFirstRange, true);
      Put(kRangeNumber, 1);
      Pulse(kSStrobe);
    }
  }
  // Orientation, rotation with a forced voltage, rotation at the programmed S.
  bool used = false;
  for (uint8_t bit = 0; bit <= 4; ++bit) used = used || Get(BitK(11, bit));
  Follow(kSpindleUsed, used, spindle_used_);
}

void NcStub::TFunction() {
  const std::array<uint8_t, 2> code = {Get(ByteK(4, 0)), Get(ByteK(4, 1))};
  if (code == t_code_) return;
  t_code_ = code;
  if (IsZero(code)) return;
  Put(ByteK(2, 2), code[0]);
  Put(ByteK(2, 3), code[1]);
  Pulse(kTStrobe);
}

void NcStub::IndexAxis() {
  const std::array<uint8_t, 4> code = {Get(ByteK(1, 0)), Get(ByteK(1, 1)), Get(ByteK(1, 2)), Get(ByteK(1, 3))};
  if (code == index_code_) return;
  index_code_ = code;
  // Not homed: only the displacement 0, which needs no strobe here, is accepted.
  if (!IsZero(code) && Get(kIndexHomed)) Pulse(kIndexStrobe);
}

void NcStub::ToolUpdate() {
  tool_update_.Look(Get(kToolRequest));
  if (tool_update_.rose()) {
    const bool accepted = !Get(kReleased);
    Put(accepted ? kToolDone : kToolRefused, true);
    if (!accepted) Pulse(kReset);
  }
  if (tool_update_.fell()) {
    Put(kToolDone, false);
    Put(kToolRefused, false);
  }
}

void NcStub::SpindleChange() {
  const uint8_t name = Get(kSpindleRequest);
  if (name != spindle_name_) {
    spindle_name_ = name;
    spindle_answer_due_ = true;
    spindle_change_begin_ = slow_cycles_;
    Put(kSpindleDone, false);
    Put(kSpindleRefused, false);
  } else if (spindle_answer_due_ && slow_cycles_ - spindle_change_begin_ >= kSpindleCycles) {
    spindle_answer_due_ = false;
    const bool known = name == 0 || (name >= 'A' && name <= 'Z');
    Put(known ? kSpindleDone : kSpindleRefused, true);
  }
}

/// Answers that need no state of their own.
void NcStub::SmallAnswers() {
  constexpr Byte kSwitchRequest = ByteK(17, 1), kSwitchAnswer = ByteK(6, 0);
  Follow(kSwitchAnswer, Get(kSwitchRequest), switched_axes_);

  constexpr Bit kSave = BitN(10, 4), kSaved = BitN(0, 1);
  save_.Look(Get(kSave));
  if (save_.rose()) Put(kSaved, true);
  if (save_.fell()) Put(kSaved, false);

  constexpr Bit kProfileShift = BitN(10, 5);
  if (Get(kProfileShift)) Put(kProfileShift, false);

  // There is one characterisation only, so a change is refused.
  constexpr Bit kRefused = BitN(0, 7);
  configuration_.Look((Get(ByteN(10, 1)) & 0xF0) != 0);
  if (configuration_.rose()) Put(kRefused, true);
  if (configuration_.fell()) Put(kRefused, false);

  constexpr Bit kActiveReset = BitK(13, 0), kActiveResetRuns = BitK(9, 16);
  active_reset_.Look(Get(kActiveReset));
  if (active_reset_.rose()) Pulse(kActiveResetRuns);

  constexpr Bit kTeach = BitK(13, 1), kTeaches = BitK(9, 19), kPositions = BitK(9, 20), kBlocks = BitK(9, 21),
                kProblem = BitK(9, 22);
  Follow(kTeaches, Get(kTeach), teaching_);
  store_positions_.Look(Get(BitK(13, 2)));
  store_block_.Look(Get(BitK(13, 3)));
  if (store_positions_.rose()) Put(teaching_ ? kPositions : kProblem, true);
  if (store_block_.rose()) Put(teaching_ ? kBlocks : kProblem, true);
  if (store_positions_.fell()) Put(kPositions, false);
  if (store_block_.fell()) Put(kBlocks, false);
  if (store_positions_.fell() || store_block_.fell()) Put(kProblem, false);
}

void NcStub::Functions() {
  MFunction();
  SFunction();
  TFunction();
  IndexAxis();
  ToolUpdate();
  SpindleChange();
  SmallAnswers();
}

}  // namespace plcxx::nc110
