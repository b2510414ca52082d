#include "transpiler/dialects/host50/options.h"

#include <charconv>
#include <optional>
#include <vector>

#include "transpiler/dialects/host50/machine.h"

namespace plcxx::host50 {
namespace {

struct Row {
  dialects::OptionInfo info;
  bool (*apply)(std::string_view text, Settings& settings);
  bool is_directive = false;  // of its own: no OPTION names it
};

bool Number(std::string_view text, uint32_t most, uint32_t& value) {
  uint32_t number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = result.ptr == text.data() + text.size();
  if (result.ec != std::errc{} || !whole || number < 1 || number > most) return false;
  value = number;
  return true;
}

template <class Choice>
bool Choose(std::string_view text, std::string_view first, std::string_view second, Choice a, Choice b,
            Choice& choice) {
  if (EqualIgnoringCase(text, first)) {
    choice = a;
  } else if (EqualIgnoringCase(text, second)) {
    choice = b;
  } else {
    return false;
  }
  return true;
}

constexpr Row kRows[] = {
    {{"slowdiv", "1..1000", "8", "ticks of 1 ms in a slow cycle"},
     [](std::string_view text, Settings& s) { return Number(text, kMostSlowdiv, s.slowdiv); },
     true},
    {{"channels", "1..8", "1", "channels of the control"},
     [](std::string_view text, Settings& s) { return Number(text, kMostChannels, s.channels); },
     true},
#define HOST50_OPTION(Name, Member, Key, First, FirstText, Second, SecondText, Meaning)               \
  {{Key, FirstText " or " SecondText, FirstText, Meaning}, [](std::string_view text, Settings& s) {   \
     return Choose(text, FirstText, SecondText, Name##Option::First, Name##Option::Second, s.Member); \
   }},
#include "transpiler/dialects/host50/machine.def"
};

const Row* RowOf(std::string_view key) {
  for (const Row& row : kRows) {
    if (EqualIgnoringCase(row.info.key, key)) return &row;
  }
  return nullptr;
}

std::string Names(bool with_directives) {
  std::string names;
  for (const Row& row : kRows) {
    if (row.is_directive && !with_directives) continue;
    if (!names.empty()) names += ", ";
    names += row.info.key;
  }
  return names;
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
  for (const auto& [key, value] : options) {
    const Row* row = RowOf(key);
    if (row == nullptr) {
      diagnostics.Report({}, diag::UnknownOption, key, "host50", Names(true));
    } else if (!row->apply(value, scratch)) {
      diagnostics.Report({}, diag::BadOptionValue, key, value, row->info.values);
    }
  }
}

void ApplyOptions(const std::map<std::string, std::string>& options, Settings& settings) {
  for (const auto& [key, value] : options) {
    if (const Row* row = RowOf(key)) row->apply(value, settings);
  }
}

OptionFault ApplyOption(std::string_view name, std::string_view value, Settings& settings) {
  const Row* row = RowOf(name);
  if (row == nullptr || row->is_directive) return OptionFault::kName;
  return row->apply(value, settings) ? OptionFault::kNone : OptionFault::kValue;
}

std::string ExpectedOption(std::string_view name) {
  const Row* row = RowOf(name);
  return row == nullptr || row->is_directive ? Names(false) : std::string(row->info.values);
}

}  // namespace plcxx::host50
