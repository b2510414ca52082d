#include "transpiler/live/panel_hands.h"

#include <algorithm>
#include <utility>

namespace plcxx::live {
namespace {

/// A button is held so long at least, in the machine's time: a finger is not faster, and a program looks at its inputs
/// once in a pass.
constexpr uint64_t kShortestPressMs = 100;
/// Some controls deliver an input a few periods later; until then the panel shows what was done.
constexpr uint64_t kDeliveredAfter = 3;

constexpr const char* kNoControl = "there is no such control on the panel";

}  // namespace

void PanelHands::Equip(std::shared_ptr<const BoundPanel> panel) {
  panel_ = std::move(panel);
  held_.assign(panel_ ? panel_->controls.size() : 0, Held());
}

void PanelHands::TakeOff() { std::ranges::fill(held_, Held()); }

void PanelHands::PutAsDelivered() {
  if (!panel_) return;
  for (const plant::PanelControl* control : panel_->controls) {
    if (!control->positions.empty()) Write(*control, control->start, Zeros::kLeftOut);
  }
}

void PanelHands::Write(const plant::PanelControl& control, size_t position, Zeros zeros) {
  for (const plant::Setting& setting : control.positions[position]) {
    const dialects::Location& location = panel_->writes[setting.write];
    const uint64_t value = scenarios::PlantBits(location, setting.value);
    if (zeros == Zeros::kLeftOut && value == 0) continue;
    write_({.kind = ActionKind::kSet,
            .name = panel_->panel.writes[setting.write].text,
            .location = location,
            .value = value,
            .text = {},
            .statement = {}});
  }
}

void PanelHands::PutBack(const std::vector<ControlState>& before) {
  for (size_t i = 0; i < before.size(); ++i) {
    const plant::PanelControl& control = *panel_->controls[i];
    if (control.positions.empty() || before[i].position < 0) continue;
    const bool springs_back = control.kind == plant::ControlKind::kButton;
    Write(control, springs_back ? 0 : static_cast<size_t>(before[i].position), Zeros::kLeftOut);
  }
}

std::vector<ControlState> PanelHands::States() const {
  if (!panel_) return {};
  std::vector<ControlState> states = StatesOf(*panel_, timeline_.machine());
  const uint64_t period = timeline_.period();
  for (size_t i = 0; i < states.size(); ++i) {
    const Held& held = held_[i];
    if (panel_->controls[i]->kind == plant::ControlKind::kButton) {
      states[i].position = held.is_pressed ? 1 : 0;
    } else if (held.position && period >= held.period && period < held.period + kDeliveredAfter) {
      states[i].position = *held.position;
    }
  }
  return states;
}

Refusal PanelHands::Press(size_t control) {
  if (control >= held_.size()) return kNoControl;
  if (panel_->controls[control]->kind != plant::ControlKind::kButton) return "only a button is pressed";
  Held& held = held_[control];
  held = {.is_pressed = true, .since_ms = timeline_.machine().time_ms()};
  Write(*panel_->controls[control], 1, Zeros::kWritten);
  return {};
}

Refusal PanelHands::Release(size_t control) {
  if (control >= held_.size()) return kNoControl;
  Held& held = held_[control];
  if (!held.is_pressed) return {};
  held.is_let_go = true;
  LetButtonsGo();
  return {};
}

void PanelHands::LetButtonsGo() {
  const uint64_t now_ms = timeline_.machine().time_ms();
  for (size_t i = 0; i < held_.size(); ++i) {
    Held& held = held_[i];
    if (!held.is_let_go || now_ms < held.since_ms + kShortestPressMs) continue;
    held = {};
    Write(*panel_->controls[i], 0, Zeros::kWritten);
  }
}

Refusal PanelHands::Turn(size_t control, size_t position) {
  if (control >= held_.size()) return kNoControl;
  const plant::PanelControl& turned = *panel_->controls[control];
  if (turned.kind == plant::ControlKind::kButton || turned.positions.empty()) return "it stays nowhere";
  if (position >= turned.positions.size()) return "it has no such position";
  held_[control].position = static_cast<int64_t>(position);
  held_[control].period = timeline_.period();
  Write(turned, position, Zeros::kWritten);
  return {};
}

}  // namespace plcxx::live
