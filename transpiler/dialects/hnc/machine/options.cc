#include "transpiler/dialects/hnc/machine/options.h"

#include <string_view>
#include <vector>

#include "transpiler/dialects/common/option_rows.h"
#include "transpiler/dialects/common/option_values.h"

namespace plcxx::hnc {
namespace {

using dialects::Number;
using dialects::OneOf;

constexpr dialects::OptionRow<Settings> kRows[] = {
    {{"char", "signed or unsigned", "signed", "sign of plain char and of character constants"},
     [](std::string_view text, Settings& s) {
       return OneOf(text, "signed", CharOption::kSigned, "unsigned", CharOption::kUnsigned, s.plain_char);
     }},
    {{"abs", "int or long", "int", "abs() takes an int, or keeps the type of its argument"},
     [](std::string_view text, Settings& s) {
       return OneOf(text, "int", AbsMeaning::kInt, "long", AbsMeaning::kLong, s.abs);
     }},
    {{"system-header", "a file name", "", "a further name of the system header plc.h"},
     [](std::string_view text, Settings& s) {
       s.system_header = text;
       return !text.empty();
     }},
    {{"x-mirror", "0..28", "28", "bytes of X that are copied to X[100] and on for the slow part"},
     [](std::string_view text, Settings& s) { return Number(text, 0, 28, s.x_mirror); }},
    {{"sysfunc", "image or host", "image", "system functions write G, or call functions of the host"},
     [](std::string_view text, Settings& s) {
       return OneOf(text, "image", SysfuncOption::kImage, "host", SysfuncOption::kHost, s.sysfunc);
     }},
    {{"handler-calls", "each or once", "each", "handlers are called in each fast cycle of a request, or once"},
     [](std::string_view text, Settings& s) {
       return OneOf(text, "each", HandlerCallsOption::kEach, "once", HandlerCallsOption::kOnce, s.handler_calls);
     }},
    {{"m00-flags", "on or off", "on", "the dispatcher sets CH_M00 and CH_M01"},
     [](std::string_view text, Settings& s) {
       return OneOf(text, "on", M00FlagsOption::kOn, "off", M00FlagsOption::kOff, s.m00_flags);
     }},
    {{"stop", "corrected or printed", "corrected", "set_axis_stop() of a negative rest"},
     [](std::string_view text, Settings& s) {
       return OneOf(text, "corrected", StopOption::kCorrected, "printed", StopOption::kPrinted, s.stop);
     }},
    {{"loop-warn", "1..10000000", "1000", "rounds of a loop from which it is warned about"},
     [](std::string_view text, Settings& s) { return Number(text, 1, 10'000'000, s.loop_warn); }},
    {{"faults", "continue or stop", "continue", "what the machine does after a run-time fault"},
     [](std::string_view text, Settings& s) {
       return OneOf(text, "continue", FaultsOption::kContinue, "stop", FaultsOption::kStop, s.faults);
     }},
    {{"base-cycle", "1..100 in ms", "1", "the host's base cycle"},
     [](std::string_view text, Settings& s) { return Number(text, 1, 100, s.base_cycle_ms); }},
};

}  // namespace

std::span<const dialects::OptionInfo> Options() {
  static const std::vector<dialects::OptionInfo> options = dialects::OptionInfos(kRows);
  return options;
}

void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics) {
  dialects::CheckOptionRows<Settings>(kRows, options, "hnc", dialects::IsKeyWithUnderscores, diagnostics);
}

Settings ReadSettings(const std::map<std::string, std::string>& options) {
  Settings settings;
  dialects::ApplyOptionRows(kRows, options, dialects::IsKeyWithUnderscores, settings);
  return settings;
}

}  // namespace plcxx::hnc
