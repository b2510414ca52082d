// The options of dialect nc110 (specification 10.4) and what they set.
//
// In: `--set key=value` as a map, the characterisation files that it names. Out: Settings.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/nc110/machine/machine.h"

namespace plcxx::nc110 {

/// How sources are read.
enum class XorPrecedence : uint8_t { kSameAsOr, kAboveOr };

struct ParseOptions {
  bool strict_case = false;        // lower-case keywords and operands are error 1 instead of W305
  bool accept_homoglyphs = false;  // Cyrillic look-alikes are mapped, one warning per file
  bool enable_dow = false;         // DOW ... ENDW is a loop instead of NC104
  XorPrecedence xor_precedence = XorPrecedence::kSameAsOr;
  uint32_t max_symbols = 1000;  // SPL
};

/// When CnnR falls again (specification D9).
enum class CarryEnd : uint8_t { kScan, kInput, kNext };

struct Settings {
  ParseOptions parse;
  uint32_t period_ms = 10;  // CLO
  uint32_t slot_ms = 2;
  uint8_t slices = 1;
  bool slices_by_cost = false;
  bool latch_slow_inputs = false;
  uint32_t tim_ms = 2;
  std::optional<uint8_t> t_initial[kRetainedBytes];
  bool retention = false;
  uint32_t processes = 1;
  std::vector<Operand> external;
  CarryEnd carry = CarryEnd::kScan;
  uint32_t stub_ms = 200;
  ir::Facts facts = ir::Facts::kTrusted;
};

std::span<const dialects::OptionInfo> Options();
/// Reports unknown keys and values that do not fit.
void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics);
/// Reads the characterisation files first: what an option says explicitly wins.
Settings ReadSettings(const dialects::Request& request);
/// Of the options alone; values that do not fit are passed over.
void ApplyOptions(const std::map<std::string, std::string>& options, Settings& settings);

/// The file that an option names; none when it names none or the file cannot be read (reported).
std::optional<source::FileId> LoadNamedFile(const dialects::Request& request, const std::string& key);

/// "nn=hh" of package T: byte 0..63 and its value; none when out of range or malformed.
struct InitialByteSetting {
  uint32_t offset = 0;
  uint8_t value = 0;
};
std::optional<InitialByteSetting> ParseInitialByte(std::string_view number, std::string_view value);

std::string_view Trim(std::string_view text);

}  // namespace plcxx::nc110
