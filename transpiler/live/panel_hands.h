// Operating the panel: each control writes its inputs as a click on them does, so that it becomes part of the
// recording.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "transpiler/live/panel.h"
#include "transpiler/live/refusal.h"
#include "transpiler/live/timeline.h"

namespace plcxx::live {

/// The hands on the controls of a panel, which may be none.
class PanelHands {
 public:
  /// `write`: does what a control does. Both outlive it.
  PanelHands(Timeline& timeline, std::function<void(Action)> write) : timeline_(timeline), write_(std::move(write)) {}

  void Equip(std::shared_ptr<const BoundPanel> panel);
  const BoundPanel* panel() const { return panel_.get(); }
  /// Nothing is touched.
  void TakeOff();
  /// Writes what each control says that stays where it is put, as it is at delivery.
  void PutAsDelivered();
  /// Power has come back: what stayed where it was put is still there.
  void PutBack(const std::vector<ControlState>& before);

  // Of controls, by number.
  Refusal Press(size_t control);
  Refusal Release(size_t control);
  Refusal Turn(size_t control, size_t position);
  /// After each period: buttons that were released before they had been pressed long enough.
  void LetButtonsGo();

  /// What is shown of the controls; none without a panel.
  std::vector<ControlState> States() const;

 private:
  enum class Zeros : uint8_t { kWritten, kLeftOut };
  void Write(const plant::PanelControl& control, size_t position, Zeros zeros);

  struct Held {
    bool is_pressed = false, is_let_go = false;  // of a button
    uint64_t since_ms = 0;
    std::optional<int64_t> position;  // of what stays where it is put, before the period
    uint64_t period = 0;
  };

  Timeline& timeline_;
  std::function<void(Action)> write_;
  std::shared_ptr<const BoundPanel> panel_;
  std::vector<Held> held_;  // by control
};

}  // namespace plcxx::live
