// The options of dialect @name@ and what they set.
//
// In: `--set key=value` as a map. Out: Settings. The encoding of the sources is the tool's own option.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/dialect.h"

namespace plcxx::@name@ {

struct Settings {
  uint32_t period_ms = 10;
  ir::Facts facts = ir::Facts::kTrusted;
};

std::span<const dialects::OptionInfo> Options();
/// Reports unknown keys and values that do not fit.
void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics);
/// Values that do not fit are passed over: CheckOptions has reported them.
Settings ReadSettings(const std::map<std::string, std::string>& options);

}  // namespace plcxx::@name@
