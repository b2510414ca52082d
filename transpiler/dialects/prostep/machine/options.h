// The options of dialect prostep (specification appendix C) and what they set.
//
// In: `--set key=value` as a map. Out: Settings. The encoding of the sources is the tool's own option.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/dialect.h"

namespace plcxx::prostep {

/// Encoding of the generated text tables (1).
enum class TextEncoding : uint8_t { kUtf8, kMazovia };
/// How the first operation of a sequence is known (D14).
enum class FirstCheck : uint8_t { kTextual, kDynamic };
/// When S C n takes its preset (D28).
enum class CounterSet : uint8_t { kLevel, kEdge };
/// FM 2, 3, 32, 33, 62, 63 (D34).
enum class MulDiv : uint8_t { kSigned, kUnsigned };
/// When the images are refreshed (D32).
enum class IoRefresh : uint8_t { kTick, kMillisecond };

struct Settings {
  TextEncoding text_encoding = TextEncoding::kUtf8;
  FirstCheck first_check = FirstCheck::kTextual;
  CounterSet counter_set = CounterSet::kLevel;
  MulDiv muldiv = MulDiv::kSigned;
  IoRefresh io_refresh = IoRefresh::kTick;
  uint32_t first_retentive = 500;  // bytes of D, both inclusive
  uint32_t last_retentive = 999;
  uint32_t tick_ms = 12;
  uint32_t loop_budget = 10'000;
  uint32_t plc_axes = 0;  // modelled by the stub, 0 to 5
  bool strict = false;    // W01, W13 and W14 are errors
  ir::Facts facts = ir::Facts::kTrusted;
};

std::span<const dialects::OptionInfo> Options();
/// Reports unknown keys and values that do not fit.
void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics);
/// Values that do not fit are passed over: CheckOptions has reported them.
Settings ReadSettings(const std::map<std::string, std::string>& options);

}  // namespace plcxx::prostep
