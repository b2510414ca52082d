#include "transpiler/live/locations.h"

#include <optional>

#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/near_location.h"
#include "transpiler/scenarios/plan.h"

namespace plcxx::live {

std::variant<dialects::Location, std::string> FindLocation(const dialects::Dialect& dialect, const ir::NameIndex& names,
                                                           std::string_view name) {
  const std::optional<dialects::Location> found = dialect.locate(names, name);
  if (!found) return scenarios::NoSuchLocation(dialect, names.program(), name);
  if (found->absent) return "the program does not use '" + std::string(name) + "'";
  return *found;
}

std::string CannotBeForced(const compilation::Compilation& compilation, const dialects::Location& location) {
  if (location.text_input) return "the operator's keyboard cannot be forced";
  if (location.cell) return "it is the simulated control's own, and cannot be forced";
  const ir::Place& place = location.place;
  if (!place.is_field() && place.space.valid() &&
      compilation.program.spaces[place.space].lifetime == ir::Lifetime::kRoutine) {
    return "it is a local name, which begins anew with each part";
  }
  return {};
}

std::variant<uint64_t, std::string> FindValue(const compilation::Compilation& compilation, std::string_view name,
                                              const dialects::Location& location, std::string_view text) {
  const std::optional<uint64_t> value = scenarios::ParseScenarioValue(text, location.place.type, *compilation.dialect);
  if (!value) return scenarios::WhyNoValue(text, location.place.type, name, *compilation.dialect);
  return scenarios::FittingField(location, *value);
}

}  // namespace plcxx::live
