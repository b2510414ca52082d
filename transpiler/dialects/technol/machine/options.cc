#include "transpiler/dialects/technol/machine/options.h"

#include <string_view>
#include <vector>

#include "transpiler/dialects/common/option_rows.h"
#include "transpiler/dialects/common/option_values.h"

namespace plcxx::technol {
namespace {

using dialects::OneOf;
using dialects::Switch;

constexpr uint32_t kMostMilliseconds = 1000;
constexpr uint32_t kMostLoops = 16'777'216;

constexpr dialects::OptionRow<Settings> kRows[] = {
    {{"slow-ms", "1..1000, a multiple of fast-ms", "20", "period of the slow part in ms"},
     [](std::string_view t, Settings& s) { return dialects::Number(t, 1, kMostMilliseconds, s.slow_ms); }},
    {{"fast-ms", "1..1000", "1", "period of MODULE_FAST in ms"},
     [](std::string_view t, Settings& s) { return dialects::Number(t, 1, kMostMilliseconds, s.fast_ms); }},
    {{"strict", "off or on", "off", "a missing standard module is an error"},
     [](std::string_view t, Settings& s) { return Switch(t, s.strict); }},
    {{"evidence", "all or strict", "all", "strict warns of instructions that the manual does not show"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "all", EvidenceRule::kAll, "strict", EvidenceRule::kStrict, s.evidence);
     }},
    {{"case", "insensitive or sensitive", "insensitive", "are names told by the case of their letters"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "insensitive", CaseRule::kInsensitive, "sensitive", CaseRule::kSensitive, s.names);
     }},
    {{"retain", "cmos or dual", "cmos", "dual keeps backed-up memory only when the program has requested it"},
     [](std::string_view t, Settings& s) { return OneOf(t, "cmos", Retain::kCmos, "dual", Retain::kDual, s.retain); }},
    {{"bounds", "check or trap", "check", "what an access outside its area does: a fault, or leaving the module, too"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "check", Bounds::kCheck, "trap", Bounds::kTrap, s.bounds);
     }},
    {{"loop-limit", "1..16777216", "65536", "backward jumps of one run of a module or mechanism"},
     [](std::string_view t, Settings& s) { return dialects::Number(t, 1, kMostLoops, s.loop_limit); }},
    {{"rl", "rotate or shift", "rotate", "what RL and RR do"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "rotate", Rotation::kRotate, "shift", Rotation::kShift, s.rotation);
     }},
    {{"mech-clear", "suspend or abort", "suspend", "what clearing a mechanism's bit does while it waits"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "suspend", MechClear::kSuspend, "abort", MechClear::kAbort, s.mech_clear);
     }},
    {{"eset", "bcd or binary", "bcd", "how ESET stores its numbers"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "bcd", EsetForm::kBcd, "binary", EsetForm::kBinary, s.eset);
     }},
    {{"tch-version", "1 or any", "1", "versions of technology tables that are taken"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "1", TableVersion::kOne, "any", TableVersion::kAny, s.table_version);
     }},
    {{"tch-glued", "refuse or accept", "refuse", "items of technology tables that only a sign separates"},
     [](std::string_view t, Settings& s) {
       return OneOf(t, "refuse", GluedItems::kRefuse, "accept", GluedItems::kAccept, s.glued_items);
     }},
    {{"signals", "file", "", "table of further cells and bits of the control"},
     [](std::string_view t, Settings& s) {
       s.signals = t;
       return !t.empty();
     }},
};

}  // namespace

std::span<const dialects::OptionInfo> Options() {
  static const std::vector<dialects::OptionInfo> options = dialects::OptionInfos(kRows);
  return options;
}

void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics) {
  const uint32_t before = diagnostics.error_count();
  const auto settings =
      dialects::CheckOptionRows<Settings>(kRows, options, "technol", dialects::IsKeyWithUnderscores, diagnostics);
  if (diagnostics.error_count() == before && settings.slow_ms % settings.fast_ms != 0) {
    const std::string value =
        std::to_string(settings.slow_ms) + " is no multiple of fast-ms " + std::to_string(settings.fast_ms);
    diagnostics.Report({}, diag::BadOptionValue, "slow-ms", value, "a multiple of fast-ms");
  }
}

Settings ReadSettings(const std::map<std::string, std::string>& options) {
  Settings settings;
  dialects::ApplyOptionRows(kRows, options, dialects::IsKeyWithUnderscores, settings);
  return settings;
}

}  // namespace plcxx::technol
