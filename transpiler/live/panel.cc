#include "transpiler/live/panel.h"

#include <algorithm>
#include <utility>

#include "transpiler/live/locations.h"
#include "transpiler/live/machine.h"

namespace plcxx::live {
namespace {

class PanelBinder {
 public:
  PanelBinder(const plant::Panel& panel, const compilation::Compilation& compilation)
      : panel_(panel), dialect_(*compilation.dialect), names_(compilation.program) {}

  dialects::Location Find(const yaml::MarkedText& name) {
    const auto found = FindLocation(dialect_, names_, name.text);
    if (const auto* why = std::get_if<std::string>(&found)) {
      Fail(name, *why, "write it as in a scenario; plcxx report --print-symbols lists the names");
      return {};
    }
    const auto& location = std::get<dialects::Location>(found);
    if (location.text_input) Fail(name, "'" + name.text + "' is the operator's keyboard", "name an input or an output");
    return location;
  }
  void CheckIsFree(const yaml::MarkedText& name, const dialects::Location& location,
                   const scenarios::BoundPlant& plant) {
    const plant::Driven* const driver = plant.DriverOf(location);
    if (driver == nullptr) return;
    Fail(name,
         "'" + name.text + "' is driven by the plant, and not the operator's: " +
             scenarios::DriverText(*driver, plant.model().path()),
         "delete it here or there");
  }
  std::vector<yaml::Error>& errors() { return errors_; }

 private:
  void Fail(const yaml::MarkedText& name, std::string message, std::string remedy) {
    errors_.push_back({panel_.path, name.mark, std::move(message), std::move(remedy)});
  }

  const plant::Panel& panel_;
  const dialects::Dialect& dialect_;
  const ir::NameIndex names_;
  std::vector<yaml::Error> errors_;
};

bool IsSetTo(const BoundPanel& panel, const std::vector<plant::Setting>& settings, Machine& machine) {
  return !settings.empty() && std::ranges::all_of(settings, [&](const plant::Setting& setting) {
    const dialects::Location& location = panel.writes[setting.write];
    return machine.Read(location) == scenarios::PlantBits(location, setting.value);
  });
}

int64_t PositionOf(const BoundPanel& panel, const plant::PanelControl& control, Machine& machine) {
  for (size_t i = control.positions.size(); i-- > 0;) {
    if (IsSetTo(panel, control.positions[i], machine)) return static_cast<int64_t>(i);
  }
  return control.kind == plant::ControlKind::kKnob ? -1 : 0;
}

}  // namespace

PanelOrErrors BindPanel(plant::Panel panel, const compilation::Compilation& compilation,
                        const scenarios::BoundPlant* plant) {
  const auto bound = std::make_shared<BoundPanel>();
  bound->panel = std::move(panel);
  PanelBinder binder(bound->panel, compilation);
  for (const yaml::MarkedText& name : bound->panel.writes) {
    bound->writes.push_back(binder.Find(name));
    if (plant != nullptr) binder.CheckIsFree(name, bound->writes.back(), *plant);
  }
  for (const yaml::MarkedText& name : bound->panel.reads) bound->reads.push_back(binder.Find(name));
  if (!binder.errors().empty()) return std::move(binder.errors());
  for (const plant::PanelGroup& group : bound->panel.groups) {
    for (const plant::PanelControl& control : group.controls) bound->controls.push_back(&control);
  }
  return std::shared_ptr<const BoundPanel>(bound);
}

std::vector<ControlState> StatesOf(const BoundPanel& panel, Machine& machine) {
  std::vector<int64_t> reads;
  for (const dialects::Location& location : panel.reads) {
    reads.push_back(scenarios::PlantNumber(location, machine.Read(location)));
  }
  std::vector<ControlState> states;
  for (const plant::PanelControl* control : panel.controls) {
    states.push_back({.position = PositionOf(panel, *control, machine),
                      .is_lit = control->lamp && control->lamp->Holds(reads),
                      .value = control->shows ? machine.Read(panel.reads[*control->shows]) : 0});
  }
  return states;
}

}  // namespace plcxx::live
