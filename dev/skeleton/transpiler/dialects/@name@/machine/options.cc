#include "transpiler/dialects/@name@/machine/options.h"

#include <string_view>
#include <vector>

#include "transpiler/dialects/common/option_rows.h"
#include "transpiler/dialects/common/option_values.h"

namespace plcxx::@name@ {
namespace {

constexpr dialects::OptionRow<Settings> kRows[] = {
    {{"period", "1..1000", "10", "period of the control in ms"},
     [](std::string_view t, Settings& s) { return dialects::Number(t, 1, 1000, s.period_ms); }},
};

}  // namespace

std::span<const dialects::OptionInfo> Options() {
  static const std::vector<dialects::OptionInfo> options = dialects::OptionInfos(kRows);
  return options;
}

void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics) {
  dialects::CheckOptionRows<Settings>(kRows, options, "@name@", dialects::IsKey, diagnostics);
}

Settings ReadSettings(const std::map<std::string, std::string>& options) {
  Settings settings;
  dialects::ApplyOptionRows(kRows, options, dialects::IsKey, settings);
  return settings;
}

}  // namespace plcxx::@name@
