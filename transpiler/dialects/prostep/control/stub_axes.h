// The PLC axes of the simulated control, to the letter of specification 8.7: for tests of programs, no motion of a
// machine.
#pragma once

#include <array>
#include <cstdint>

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/prostep/machine/memory.h"

namespace plcxx::prostep {

constexpr uint32_t kMostPlcAxes = 5;

class PlcAxes {
 public:
  /// `count` axes are modelled, from the first one on.
  PlcAxes(const Memory& memory, uint32_t count)
      : inputs_(memory[SpaceKey::kI]), outputs_(memory[SpaceKey::kO]), count_(count) {}

  void PowerOn() { axes_ = {}; }
  /// Of the same control.
  bool IsAtMomentOf(const PlcAxes& other) const { return axes_ == other.axes_; }
  /// Step 6 of a tick, `elapsed_ms` after the last one.
  void Move(uint32_t elapsed_ms, dialects::ImagePort& image);

 private:
  enum class Operation : uint8_t { kNone, kHoming, kPositioning };
  struct Axis {
    Operation operation = Operation::kNone;
    int32_t position_um = 0;
    uint32_t rest = 0;        // of the last division by 60
    uint8_t control_was = 0;  // first control byte at the last tick
    bool operator==(const Axis&) const = default;
  };
  /// Where an axis has its bytes.
  struct Addresses {
    uint32_t base;     // of its own block in I and O
    uint32_t status;   // in I
    uint32_t control;  // two bytes in O
  };

  void MoveOne(Axis& axis, const Addresses& at, uint32_t elapsed_ms);
  void Start(Axis& axis, const Addresses& at, Operation operation);
  void Run(Axis& axis, const Addresses& at, uint32_t elapsed_ms);
  void Jog(Axis& axis, const Addresses& at, uint32_t elapsed_ms);
  /// How far the axis goes at this speed; what the division leaves is kept for the next tick.
  static int64_t Way(Axis& axis, uint32_t mm_per_min, uint32_t elapsed_ms);
  void ClearStatus(const Addresses& at);
  void ClearControl(const Addresses& at);

  uint8_t In(uint32_t byte) const { return image_->Get(inputs_, byte); }
  uint8_t Out(uint32_t byte) const { return image_->Get(outputs_, byte); }
  bool OutBit(uint32_t byte, uint8_t bit) const { return (Out(byte) >> bit & 1) != 0; }
  int32_t Target(const Addresses& at) const;
  void PutIn(uint32_t byte, uint8_t value);
  void PutInBit(uint32_t byte, uint8_t bit, bool value);
  void PutOut(uint32_t byte, uint8_t value);

  ir::SpaceId inputs_, outputs_;
  uint32_t count_;
  std::array<Axis, kMostPlcAxes> axes_{};
  dialects::ImagePort* image_ = nullptr;  // during a call
};

}  // namespace plcxx::prostep
