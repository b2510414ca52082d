// The operator's panel joined to one program, and what it shows at a moment.
//
// In: a panel as panel.yaml lays it out. Out: its names as locations, or all that are none; the state of each control.
// Not its job: what operating it does to the machine (panel_hands.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/plant/panel.h"
#include "transpiler/scenarios/bound_plant.h"

namespace plcxx::live {

class Machine;

struct BoundPanel {
  plant::Panel panel;
  std::vector<dialects::Location> writes, reads;
  std::vector<const plant::PanelControl*> controls;  // of all groups, in their order
};

using PanelOrErrors = std::variant<std::shared_ptr<const BoundPanel>, std::vector<yaml::Error>>;
/// `plant` may be none: what it drives is not the operator's.
PanelOrErrors BindPanel(plant::Panel panel, const compilation::Compilation& compilation,
                        const scenarios::BoundPlant* plant);

/// What the page shows of a control.
struct ControlState {
  int64_t position = 0;  // of a knob -1: none of its positions
  bool is_lit = false;
  uint64_t value = 0;  // of a display
  bool operator==(const ControlState&) const = default;
};

/// As the machine's memory has it.
std::vector<ControlState> StatesOf(const BoundPanel& panel, Machine& machine);

}  // namespace plcxx::live
