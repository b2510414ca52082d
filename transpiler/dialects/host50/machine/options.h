// The options of dialect host50 (specification section 9) and the settings of a program.
//
// Directives of the source, `--set` and the options of a scenario mean the same names; the driver has put the last two
// into one map. Names and values without regard to case.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "transpiler/dialects/dialect.h"

namespace plcxx::host50 {

#define HOST50_OPTION(Name, Member, Key, First, FirstText, Second, ...) \
  enum class Name##Option : uint8_t{First, Second};
#include "transpiler/dialects/host50/machine/machine.def"

struct Settings {
  uint32_t slowdiv = 8;   // ticks of a slow cycle, 1..1000
  uint32_t channels = 1;  // 1..8
#define HOST50_OPTION(Name, Member, Key, First, ...) Name##Option Member = Name##Option::First;
#include "transpiler/dialects/host50/machine/machine.def"
  ir::Facts facts = ir::Facts::kTrusted;
};

std::span<const dialects::OptionInfo> Options();
/// Reports unknown names and values that do not fit.
void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics);
/// What is not valid is passed over: CheckOptions has reported it.
void ApplyOptions(const std::map<std::string, std::string>& options, Settings& settings);

enum class OptionFault : uint8_t { kNone, kName, kValue };
/// OPTION name=value of a source.
OptionFault ApplyOption(std::string_view name, std::string_view value, Settings& settings);
/// What the option takes, "MANUAL or IEC"; all names when there is no such option.
std::string ExpectedOption(std::string_view name);

}  // namespace plcxx::host50
