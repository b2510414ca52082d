#include "transpiler/dialects/technol/options.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "transpiler/dialects/common/option_values.h"

namespace plcxx::technol {
namespace {

using dialects::Number;
using dialects::OneOf;
using dialects::Switch;

/// Takes the value into the settings; false when it does not fit.
using Apply = bool (*)(std::string_view value, Settings& settings);

struct Row {
  dialects::OptionInfo info;
  Apply apply;
};

constexpr uint32_t kMostMilliseconds = 1000;
constexpr uint32_t kMostLoops = 16'777'216;

constexpr Row kRows[] = {
    {{"slow-ms", "1..1000, a multiple of fast-ms", "20", "period of the slow part in ms"},
     [](std::string_view t, Settings& s) { return Number(t, 1, kMostMilliseconds, s.slow_ms); }},
    {{"fast-ms", "1..1000", "1", "period of MODULE_FAST in ms"},
     [](std::string_view t, Settings& s) { return Number(t, 1, kMostMilliseconds, s.fast_ms); }},
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
     [](std::string_view t, Settings& s) { return Number(t, 1, kMostLoops, s.loop_limit); }},
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

const Row* RowOf(std::string_view key) {
  const auto same = [](char a, char b) { return a == b || (a == '-' && b == '_'); };
  const auto row = std::ranges::find_if(
      kRows, [&](const Row& candidate) { return std::ranges::equal(candidate.info.key, key, same); });
  return row == std::end(kRows) ? nullptr : row;
}

std::string AllKeys() {
  std::string keys;
  for (const Row& row : kRows) keys += (keys.empty() ? "" : ", ") + std::string(row.info.key);
  return keys;
}

}  // namespace

std::span<const dialects::OptionInfo> Options() {
  static const std::vector<dialects::OptionInfo> options = [] {
    std::vector<dialects::OptionInfo> infos;
    for (const Row& row : kRows) infos.push_back(row.info);
    return infos;
  }();
  return options;
}

void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics) {
  Settings scratch;
  bool right = true;
  for (const auto& [key, value] : options) {
    const Row* row = RowOf(key);
    if (row == nullptr) {
      diagnostics.Report({}, diag::UnknownOption, key, "technol", AllKeys());
      right = false;
    } else if (!row->apply(value, scratch)) {
      diagnostics.Report({}, diag::BadOptionValue, key, value, row->info.values);
      right = false;
    }
  }
  if (right && scratch.slow_ms % scratch.fast_ms != 0) {
    const std::string value =
        std::to_string(scratch.slow_ms) + " is no multiple of fast-ms " + std::to_string(scratch.fast_ms);
    diagnostics.Report({}, diag::BadOptionValue, "slow-ms", value, "a multiple of fast-ms");
  }
}

Settings ReadSettings(const std::map<std::string, std::string>& options) {
  Settings settings;
  for (const auto& [key, value] : options) {
    if (const Row* row = RowOf(key)) row->apply(value, settings);
  }
  return settings;
}

}  // namespace plcxx::technol
