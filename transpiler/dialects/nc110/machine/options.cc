#include "transpiler/dialects/nc110/machine/options.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "transpiler/dialects/common/option_rows.h"
#include "transpiler/dialects/nc110/machine/records.h"
#include "transpiler/dialects/nc110/source/tokens.h"
#include "transpiler/support/near_words.h"

namespace plcxx::nc110 {
namespace {

constexpr uint32_t kAny = 1'000'000'000;

std::optional<uint32_t> Plain(std::string_view text) {
  text = Trim(text);
  if (text.empty() || text.size() > 9 || !std::all_of(text.begin(), text.end(), IsDigit)) return std::nullopt;
  uint32_t value = 0;
  for (const char c : text) value = value * 10 + static_cast<uint32_t>(c - '0');
  return value;
}

bool Number(std::string_view text, uint32_t low, uint32_t high, uint32_t& into) {
  const auto value = Plain(text);
  if (!value || *value < low || *value > high) return false;
  into = *value;
  return true;
}

bool Switch(std::string_view text, bool& into) {
  const bool on = text == "on" || text == "true", off = text == "off" || text == "false";
  if (on || off) into = on;
  return on || off;
}

bool ApplyClo(std::string_view text, Settings& s) {
  const size_t comma = text.find(',');
  if (comma == std::string_view::npos) return false;
  uint32_t period = 0, slot = 0;
  if (!Number(text.substr(0, comma), 1, 60'000, period) || !Number(text.substr(comma + 1), 1, 60'000, slot))
    return false;
  s.period_ms = period;
  s.slot_ms = slot;
  return true;
}

bool ApplySlices(std::string_view text, Settings& s) {
  uint32_t slices = 1;
  s.slices_by_cost = text == "auto";
  if (!s.slices_by_cost && !Number(text, 1, 64, slices)) return false;
  s.slices = static_cast<uint8_t>(slices);
  return true;
}

/// Calls `take` with each part of a list; false as soon as it says so.
template <class Take>
bool ForEachPart(std::string_view list, Take&& take) {
  while (!list.empty()) {
    const size_t comma = std::min(list.find(','), list.size());
    if (!take(Trim(list.substr(0, comma)))) return false;
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return true;
}

bool ApplyInitial(std::string_view text, Settings& s) {
  return ForEachPart(text, [&s](std::string_view part) {
    if (part.starts_with('T') || part.starts_with('t')) part.remove_prefix(1);
    const size_t equals = part.find('=');
    if (equals == std::string_view::npos) return false;
    const auto initial = ParseInitialByte(Trim(part.substr(0, equals)), Trim(part.substr(equals + 1)));
    if (initial) s.t_initial[initial->offset] = initial->value;
    return initial.has_value();
  });
}

bool ApplyExternal(std::string_view text, Settings& s) {
  std::vector<Operand> operands;
  const bool valid = ForEachPart(text, [&operands](std::string_view part) {
    operands.push_back(OperandFromText(part));
    return operands.back().kind != OperandKind::kNone;
  });
  if (valid) s.external = std::move(operands);
  return valid;
}

bool ApplyCarry(std::string_view text, Settings& s) {
  if (text == "scan")
    s.carry = CarryEnd::kScan;
  else if (text == "input")
    s.carry = CarryEnd::kInput;
  else if (text == "next")
    s.carry = CarryEnd::kNext;
  else
    return false;
  return true;
}

bool ApplyXor(std::string_view text, Settings& s) {
  s.parse.xor_precedence = text == "above-or" ? XorPrecedence::kAboveOr : XorPrecedence::kSameAsOr;
  return text == "same" || text == "above-or";
}

/// What the driver acts on by itself is only looked at here.
bool SwitchOnly(std::string_view text, Settings&) {
  bool ignored = false;
  return Switch(text, ignored);
}
bool NumberOnly(std::string_view text, Settings&) {
  uint32_t ignored = 0;
  return Number(text, 0, kAny, ignored);
}
bool FileOnly(std::string_view text, Settings&) { return !text.empty(); }

constexpr std::string_view kPartsOfClo[] = {"cycle_ms", "slice_ms"};

constexpr dialects::OptionRow<Settings> kRows[] = {
    {{"clo", "P,S in ms", "10,2", "period of the logic and time slot of its slow part", false, kPartsOfClo}, ApplyClo},
    {{"cycle_ms", "1..60000", "10", "P of clo alone"},
     [](std::string_view t, Settings& s) { return Number(t, 1, 60'000, s.period_ms); }},
    {{"slice_ms", "1..60000", "2", "S of clo alone"},
     [](std::string_view t, Settings& s) { return Number(t, 1, 60'000, s.slot_ms); }},
    {{"slices", "1..64 or auto", "1", "pieces that the slow part is cut into, one per period"}, ApplySlices},
    {{"latch-slow-inputs", "on or off", "off", "all slices of a slow cycle see the inputs of its first slice"},
     [](std::string_view t, Settings& s) { return Switch(t, s.latch_slow_inputs); }},
    {{"tim", "1..1000", "2", "tick of the control in ms, for parametric delays"},
     [](std::string_view t, Settings& s) { return Number(t, 1, 1000, s.tim_ms); }},
    {{"t-init", "nn=hh,...", "", "initial values of package T: nn 01 to 64, hh 00 to FF hexadecimal"}, ApplyInitial},
    {{"old", "on or off", "off", "package T is retained (record OLD)"},
     [](std::string_view t, Settings& s) { return Switch(t, s.retention); }},
    {{"spl", "number", "1000", "greatest number of symbols"},
     [](std::string_view t, Settings& s) { return Number(t, 0, kAny, s.parse.max_symbols); }},
    {{"processes", "1..5", "1", "processes of the control, each with 26 connectors of packages K and N"},
     [](std::string_view t, Settings& s) { return Number(t, 1, kMostProcesses, s.processes); }},
    {{"extern", "operands with ','", "", "free memory that the control writes"}, ApplyExternal},
    {{"carry", "scan, input or next", "scan", "when the carry of a counter falls"}, ApplyCarry},
    {{"xor-prec", "same or above-or", "same", "level of '&' against '+'"}, ApplyXor},
    {{"enable-dow", "on or off", "off", "DOW ... ENDW is a loop of at most 255 rounds"},
     [](std::string_view t, Settings& s) { return Switch(t, s.parse.enable_dow); }},
    {{"accept-homoglyphs", "on or off", "off", "Cyrillic look-alike letters are read as Latin ones"},
     [](std::string_view t, Settings& s) { return Switch(t, s.parse.accept_homoglyphs); }},
    {{"strict-case", "on or off", "off", "keywords and operands in lower case are errors"},
     [](std::string_view t, Settings& s) { return Switch(t, s.parse.strict_case); }},
    {{"fast-budget-us", "number, 0 = none", "0", "error 38 above this time of the fast part"}, NumberOnly},
    {{"slow-budget-ms", "number, 0 = none", "0", "error 39 above this time of the slow part"}, NumberOnly},
    {{"code-budget-kb", "number, 0 = none", "0", "error NC105 above this size of the code"}, NumberOnly},
    {{"iocfil", "file", "", "characterisation of the logic: CLO, SPL, values of package T"}, FileOnly},
    {{"axcfil", "file", "", "characterisation of the axes: TIM"}, FileOnly},
    {{"pgcfil", "file", "", "characterisation of the process: OLD"}, FileOnly},
    {{"messages", "file", "", "operator messages (FILMS5)"}, FileOnly},
    {{"menu", "file", "", "texts of the soft keys (LGCMNU)"}, FileOnly},
    {{"help", "file", "", "descriptions of signals (HELP)"}, FileOnly},
    {{"stop-on-error", "on or off", "off", "stop at the first error"}, SwitchOnly},
    {{"ladder-lint", "on or off", "off", "warn where the ladder editor cannot show a statement (W370)"}, SwitchOnly},
    {{"nc-stub", "on or off", "off in test, on in sim", "a simulated control answers the program's requests", true},
     SwitchOnly},
    {{"stub-ms", "ms", "200", "time that a motion of the simulated control takes", true},
     [](std::string_view t, Settings& s) { return Number(t, 0, kAny, s.stub_ms); }},
};

/// The part of a t-init list that is out of range, when the list is well formed otherwise.
bool IsInitialValueOutOfRange(std::string_view list) {
  return ForEachPart(list, [](std::string_view part) {
    const size_t equals = part.find('=');
    return equals != std::string_view::npos && equals > 0 && equals + 1 < part.size();
  });
}

}  // namespace

std::string_view Trim(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\f\r\n";
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::optional<InitialByteSetting> ParseInitialByte(std::string_view number, std::string_view value) {
  const auto record = Plain(number);
  if (value.size() > 1 && Upper(value.back()) == 'H') value.remove_suffix(1);
  if (!record || *record < 1 || *record > kRetainedBytes || value.empty() || value.size() > 8) return std::nullopt;
  uint32_t byte = 0;
  for (const char c : value) {
    const char digit = Upper(c);
    if (IsDigit(digit))
      byte = byte * 16 + static_cast<uint32_t>(digit - '0');
    else if (digit >= 'A' && digit <= 'F')
      byte = byte * 16 + static_cast<uint32_t>(digit - 'A') + 10;
    else
      return std::nullopt;
  }
  if (byte > 255) return std::nullopt;
  return InitialByteSetting{.offset = *record - 1, .value = static_cast<uint8_t>(byte)};
}

std::span<const dialects::OptionInfo> Options() {
  static const std::vector<dialects::OptionInfo> options = dialects::OptionInfos(kRows);
  return options;
}

void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics) {
  Settings scratch;
  for (const auto& [key, value] : options) {
    const auto* row = dialects::FindOptionRow(kRows, key, dialects::IsKey);
    if (row == nullptr) {
      dialects::ReportUnknownOption(kRows, key, "nc110", diagnostics);
    } else if (!row->apply(value, scratch)) {
      if (key == "t-init" && IsInitialValueOutOfRange(value)) {
        diagnostics.Report({}, diag::Nc110InitialValue, value);
      } else {
        diagnostics.Report({}, diag::BadOptionValue, key, value, row->info.values);
      }
    }
  }
}

void ApplyOptions(const std::map<std::string, std::string>& options, Settings& settings) {
  for (const auto& row : kRows) {  // in the table's order: cycle_ms and slice_ms come after clo
    const auto option = options.find(std::string(row.info.key));
    if (option != options.end()) row.apply(option->second, settings);
  }
}

std::optional<source::FileId> LoadNamedFile(const dialects::Request& request, const std::string& key) {
  const auto option = request.options.find(key);
  if (option == request.options.end() || option->second.empty()) return std::nullopt;
  const auto loaded = request.load(option->second);
  if (const auto* file = std::get_if<source::FileId>(&loaded)) return *file;
  const auto& error = std::get<source::LoadError>(loaded);
  // An empty file is a file without entries.
  if (error.problem == source::LoadProblem::kEmpty) return std::nullopt;
  request.diagnostics->Report({}, diag::Nc110CannotRead, option->second, error.detail, source::RemedyOf(error.problem));
  return std::nullopt;
}

Settings ReadSettings(const dialects::Request& request) {
  Settings settings;
  constexpr std::pair<const char*, RecordFile> kFiles[] = {
      {"iocfil", RecordFile::kIocfil}, {"axcfil", RecordFile::kAxcfil}, {"pgcfil", RecordFile::kPgcfil}};
  for (const auto& [key, kind] : kFiles) {
    if (const auto file = LoadNamedFile(request, key)) {
      ReadRecords(*request.sources, *file, kind, settings, *request.diagnostics);
    }
  }
  ApplyOptions(request.options, settings);
  return settings;
}

}  // namespace plcxx::nc110
