#include "transpiler/dialects/classicladder/machine/options.h"

#include <string_view>
#include <vector>

#include "transpiler/dialects/common/option_rows.h"
#include "transpiler/dialects/common/option_values.h"

namespace plcxx::classicladder {
namespace {

constexpr uint32_t kMostSize = 10'000;

constexpr dialects::OptionRow<Settings> kRows[] = {
    {{"period", "1..1000", "1", "period of the thread in ms"},
     [](std::string_view t, Settings& s) { return dialects::Number(t, 1, 1000, s.period_ms); }},
    {{"linuxcnc", "2.9 or 2.10", "2.9", "version of LinuxCNC whose engine is followed"},
     [](std::string_view t, Settings& s) {
       return dialects::OneOf(t, "2.9", LinuxCnc::kTwoNine, "2.10", LinuxCnc::kTwoTen, s.sizes.version);
     }},
#define CLASSICLADDER_SIZE(Member, Parameter, Line, Default, Meaning)                   \
  {{Parameter, "1..10000", "of general.txt, else " #Default, "as of loadrt: " Meaning}, \
   [](std::string_view t, Settings& s) {                                                \
     return s.given[Parameter] = dialects::Number(t, 1, kMostSize, s.sizes.Member);     \
   }},
#include "transpiler/dialects/classicladder/machine/machine.def"
};

}  // namespace

std::span<const dialects::OptionInfo> Options() {
  static const std::vector<dialects::OptionInfo> options = dialects::OptionInfos(kRows);
  return options;
}

void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics) {
  dialects::CheckOptionRows<Settings>(kRows, options, "classicladder", dialects::IsKey, diagnostics);
}

Settings ReadSettings(const std::map<std::string, std::string>& options) {
  Settings settings;
  dialects::ApplyOptionRows(kRows, options, dialects::IsKey, settings);
  return settings;
}

}  // namespace plcxx::classicladder
