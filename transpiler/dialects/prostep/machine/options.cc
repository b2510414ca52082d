#include "transpiler/dialects/prostep/machine/options.h"

#include <string_view>
#include <vector>

#include "transpiler/dialects/common/option_rows.h"
#include "transpiler/dialects/common/option_values.h"

namespace plcxx::prostep {
namespace {

using dialects::Number;
using dialects::OneOf;
using dialects::Switch;

bool ApplyRetentive(std::string_view text, Settings& s) {
  const size_t dash = text.find('-');
  uint32_t first = 0, last = 0;
  if (dash == std::string_view::npos || !Number(text.substr(0, dash), 0, 999, first) ||
      !Number(text.substr(dash + 1), first, 999, last)) {
    return false;
  }
  s.first_retentive = first;
  s.last_retentive = last;
  return true;
}

constexpr dialects::OptionRow<Settings> kRows[] = {
    {{"text-encoding", "utf-8 or mazovia", "utf-8", "encoding of the generated tables of texts"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "utf-8", TextEncoding::kUtf8, "mazovia", TextEncoding::kMazovia, s.text_encoding);
     }},
    {{"first-check", "textual or dynamic", "textual", "how the first operation of a sequence is told"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "textual", FirstCheck::kTextual, "dynamic", FirstCheck::kDynamic, s.first_check);
     }},
    {{"counter-set", "level or edge", "level", "S C n takes the preset whenever S is 1, or when S rises"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "level", CounterSet::kLevel, "edge", CounterSet::kEdge, s.counter_set);
     }},
    {{"muldiv", "signed or unsigned", "signed", "operands of FM 2, 3, 32, 33, 62 and 63"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "signed", MulDiv::kSigned, "unsigned", MulDiv::kUnsigned, s.muldiv);
     }},
    {{"retentive", "A-B, 0 to 999", "500-999", "bytes of D that survive power-off"}, ApplyRetentive},
    {{"tick", "1..1000", "12", "period of the interrupt modules in ms"},
     [](std::string_view t, Settings& s) { return Number(t, 1, 1000, s.tick_ms); }},
    {{"io-refresh", "tick or 1ms", "tick", "when the images of inputs and outputs are refreshed"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "tick", IoRefresh::kTick, "1ms", IoRefresh::kMillisecond, s.io_refresh);
     }},
    {{"loop-budget", "1..1000000000", "10000", "backward jumps of one run of a partition"},
     [](std::string_view t, Settings& s) { return Number(t, 1, 1'000'000'000, s.loop_budget); }},
    {{"plc-axes", "0..5", "0", "PLC axes that the simulated control moves", true},
     [](std::string_view t, Settings& s) { return Number(t, 0, 5, s.plc_axes); }},
    {{"strict", "on or off", "off", "W01, W13 and W14 are errors"},
     [](std::string_view t, Settings& s) { return Switch(t, s.strict); }},
};

}  // namespace

std::span<const dialects::OptionInfo> Options() {
  static const std::vector<dialects::OptionInfo> options = dialects::OptionInfos(kRows);
  return options;
}

void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics) {
  dialects::CheckOptionRows<Settings>(kRows, options, "prostep", dialects::IsKey, diagnostics);
}

Settings ReadSettings(const std::map<std::string, std::string>& options) {
  Settings settings;
  dialects::ApplyOptionRows(kRows, options, dialects::IsKey, settings);
  return settings;
}

}  // namespace plcxx::prostep
