// The options of dialect classicladder and what they set.
//
// In: `--set key=value` as a map. Out: Settings. The sizes are the parameters of LinuxCNC's real-time module, which
// takes no notice of the project's own (general.txt): one that is not given is taken from there.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/classicladder/machine/machine.h"
#include "transpiler/dialects/dialect.h"

namespace plcxx::classicladder {

struct Settings {
  uint32_t period_ms = 1;
  Sizes sizes;                        // the version; sizes where the option was given
  std::map<std::string, bool> given;  // by the parameter's name
  ir::Facts facts = ir::Facts::kTrusted;
};

std::span<const dialects::OptionInfo> Options();
/// Reports unknown keys and values that do not fit.
void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics);
/// Values that do not fit are passed over: CheckOptions has reported them.
Settings ReadSettings(const std::map<std::string, std::string>& options);

}  // namespace plcxx::classicladder
