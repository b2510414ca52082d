// The options of dialect technol (specification 10.5) and what they set.
//
// In: `--set key=value` as a map, the signal file that it names. Out: Settings.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/dialect.h"

namespace plcxx::technol {

enum class EvidenceRule : uint8_t { kAll, kStrict };         // D14
enum class CaseRule : uint8_t { kInsensitive, kSensitive };  // D1: of names
enum class Retain : uint8_t { kCmos, kDual };                // 4.4
enum class Bounds : uint8_t { kCheck, kTrap };               // D16
enum class Rotation : uint8_t { kRotate, kShift };           // D18: RL and RR
enum class MechClear : uint8_t { kSuspend, kAbort };         // D8
enum class EsetForm : uint8_t { kBcd, kBinary };             // D10
enum class TableVersion : uint8_t { kOne, kAny };            // D32
enum class GluedItems : uint8_t { kRefuse, kAccept };        // D33

struct Settings {
  uint32_t slow_ms = 20;  // a multiple of fast_ms
  uint32_t fast_ms = 1;
  bool strict = false;  // a missing standard module is an error
  EvidenceRule evidence = EvidenceRule::kAll;
  CaseRule names = CaseRule::kInsensitive;
  Retain retain = Retain::kCmos;
  Bounds bounds = Bounds::kCheck;
  uint32_t loop_limit = 65'536;  // 1 to 16777216
  Rotation rotation = Rotation::kRotate;
  MechClear mech_clear = MechClear::kSuspend;
  EsetForm eset = EsetForm::kBcd;
  TableVersion table_version = TableVersion::kOne;
  GluedItems glued_items = GluedItems::kRefuse;
  std::string signals;  // path of a table of signals; empty: none
  ir::Facts facts = ir::Facts::kTrusted;
};

std::span<const dialects::OptionInfo> Options();
/// Reports unknown keys and values that do not fit, slow-ms that is no multiple of fast-ms included.
void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics);
/// Values that do not fit are passed over: CheckOptions has reported them. '-' and '_' are the same in a key.
Settings ReadSettings(const std::map<std::string, std::string>& options);

}  // namespace plcxx::technol
