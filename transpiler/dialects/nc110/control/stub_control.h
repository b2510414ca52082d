// The state of the simulated control, split over stub_*.cc by topic. Only those files include it.
#pragma once

#include <array>
#include <vector>

#include "transpiler/dialects/nc110/control/stub.h"
#include "transpiler/dialects/nc110/machine/machine.h"

namespace plcxx::nc110 {

struct Bit {
  Package package;
  uint16_t connector;
  uint8_t bit;
  bool operator==(const Bit&) const = default;
};
struct Byte {
  Package package;
  uint16_t connector;
  uint8_t index;
};
constexpr Bit BitK(uint16_t connector, uint8_t bit) { return {Package::kK, connector, bit}; }
constexpr Bit BitN(uint16_t connector, uint8_t bit) { return {Package::kN, connector, bit}; }
constexpr Byte ByteK(uint16_t connector, uint8_t index) { return {Package::kK, connector, index}; }
constexpr Byte ByteN(uint16_t connector, uint8_t index) { return {Package::kN, connector, index}; }

// What several topics look at.
inline constexpr Bit kEmergency = BitK(0, 0), kReset = BitK(0, 1), kReady = BitK(0, 2), kBlock = BitK(0, 3),
                     kStandBy = BitK(0, 4), kHold = BitK(0, 28), kSpindleDone = BitK(0, 29);
inline constexpr Bit kMStrobe = BitK(4, 18);
inline constexpr Byte kMCode = ByteK(3, 0);
inline constexpr Bit kFunctionsAllowed = BitK(10, 25), kReleased = BitK(10, 26);

/// A request bit: did it rise or fall since the last look?
class Edge {
 public:
  void Look(bool now) {
    rose_ = now && !was_;
    fell_ = !now && was_;
    was_ = now;
  }
  bool rose() const { return rose_; }
  bool fell() const { return fell_; }
  bool operator==(const Edge&) const = default;

 private:
  bool was_ = false, rose_ = false, fell_ = false;
};

/// All that decides how the control goes on.
struct NcState {
  struct Timed {
    bool running = false;
    uint32_t end_ms = 0;
    bool operator==(const Timed&) const = default;
  };

  uint32_t now_ms_ = 0;
  uint32_t slow_cycles_ = 0;
  bool cycle_begins_ = true;  // the next period runs slice 0

  struct RunningPulse {
    Bit bit;
    uint32_t begin;  // in slow cycles
    bool operator==(const RunningPulse&) const = default;
  };
  std::vector<RunningPulse> pulses_;
  std::vector<Bit> waiting_pulses_;  // for the begin of a slow cycle

  Edge machine_off_, fault_off_, emergency_, reset_request_;
  uint8_t axes_ = 0, mode_ = 0;
  bool spindle_used_ = false;
  std::array<uint8_t, 3> s_code_{};
  std::array<uint8_t, 2> t_code_{};
  std::array<uint8_t, 4> index_code_{};
  Edge tool_update_, active_reset_, save_, configuration_, store_positions_, store_block_;
  bool teaching_ = false;
  uint8_t spindle_name_ = 0, switched_axes_ = 0;
  bool spindle_answer_due_ = false;
  uint32_t spindle_change_begin_ = 0;

  uint8_t filmas_request_ = 0;
  bool filmas_done_ = false;
  Timed filmas_, start_, orientation_;
  Edge start_request_, orientation_request_, selection_;
  bool hold_ = false;
  struct Channel {
    uint8_t axis = 0;
    std::array<uint8_t, 4> target{};
    Timed motion;
    bool operator==(const Channel&) const = default;
  };
  std::array<Channel, 2> channels_;

  bool operator==(const NcState&) const = default;
};

class NcStub final : public dialects::ControlStub, private NcState {
 public:
  explicit NcStub(uint32_t motion_ms) : motion_ms_(motion_ms) {}

  std::unique_ptr<dialects::ControlStub> Clone() const override { return std::make_unique<NcStub>(*this); }
  bool IsAtMomentOf(const dialects::ControlStub& other) const override {
    return static_cast<const NcState&>(*this) == static_cast<const NcState&>(static_cast<const NcStub&>(other));
  }
  void PowerOn(dialects::ImagePort& image) override;
  void BeforePeriod(uint32_t now_ms, dialects::ImagePort& image) override;
  void AfterPeriod(uint32_t now_ms, uint32_t slow_cycles, dialects::ImagePort& image) override;

 private:
  // --- the image (stub.cc) ---
  bool Get(const Bit& bit) const;
  uint8_t Get(const Byte& byte) const;
  void Put(const Bit& bit, bool value);
  void Put(const Byte& byte, uint8_t value);
  /// Writes when the value that the stub wants has changed.
  void Follow(const Bit& bit, bool value, bool& driven);
  void Follow(const Byte& byte, uint8_t value, uint8_t& driven);

  // --- state of the machine (stub.cc) ---
  void Pulse(const Bit& bit);
  void EndPulses();
  void Machine();
  void Mode();
  void Reset();
  void StopMotions();

  // --- M, S, T, tools (stub_functions.cc) ---
  void Functions();
  void MFunction();
  void SFunction();
  void TFunction();
  void IndexAxis();
  void ToolUpdate();
  void SpindleChange();
  void SmallAnswers();

  // --- motions and requests (stub_motions.cc) ---
  void Motions();
  void Filmas();
  void Start();
  void Orientation();
  void PointToPoint(uint8_t channel);
  void ProgramSelection();
  bool HasSelectionText() const;

  void Begin(Timed& motion) { motion = {true, now_ms_ + motion_ms_}; }
  /// True once, when the motion has run its time.
  bool Ends(Timed& motion) const;

  uint32_t motion_ms_;
  dialects::ImagePort* image_ = nullptr;  // during a call
};

}  // namespace plcxx::nc110
