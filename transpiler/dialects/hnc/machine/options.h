// The options of dialect hnc (specification 10.5) and the settings of a program.
//
// `--set` and the options of a scenario mean the same names; '-' and '_' are the same in a name.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/hnc/machine/headers.h"

namespace plcxx::hnc {

enum class CharOption : uint8_t { kSigned, kUnsigned };
enum class SysfuncOption : uint8_t { kImage, kHost };
enum class HandlerCallsOption : uint8_t { kEach, kOnce };
enum class M00FlagsOption : uint8_t { kOn, kOff };
enum class StopOption : uint8_t { kCorrected, kPrinted };
enum class FaultsOption : uint8_t { kContinue, kStop };

struct Settings {
  CharOption plain_char = CharOption::kSigned;
  AbsMeaning abs = AbsMeaning::kInt;
  std::string system_header;  // a further name of it; empty: none
  uint32_t x_mirror = 28;     // bytes of X that are copied to X[100] and on, 0..28
  SysfuncOption sysfunc = SysfuncOption::kImage;
  HandlerCallsOption handler_calls = HandlerCallsOption::kEach;
  M00FlagsOption m00_flags = M00FlagsOption::kOn;
  StopOption stop = StopOption::kCorrected;
  uint32_t loop_warn = 1000;  // rounds from which a loop is warned about
  FaultsOption faults = FaultsOption::kContinue;
  uint32_t base_cycle_ms = 1;  // 1..100
  ir::Facts facts = ir::Facts::kTrusted;
};

std::span<const dialects::OptionInfo> Options();
/// Reports unknown names and values that do not fit.
void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics);
/// What is not valid is passed over: CheckOptions has reported it.
Settings ReadSettings(const std::map<std::string, std::string>& options);

}  // namespace plcxx::hnc
