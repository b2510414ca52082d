#include "transpiler/dialects/host50/machine/options.h"

#include <charconv>
#include <ranges>
#include <vector>

#include "transpiler/dialects/common/option_rows.h"
#include "transpiler/dialects/host50/machine/machine.h"
#include "transpiler/support/listed.h"

namespace plcxx::host50 {
namespace {

struct DirectiveOrOption {
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

constexpr DirectiveOrOption kRows[] = {
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
#include "transpiler/dialects/host50/machine/machine.def"
};

bool IsKey(std::string_view key, std::string_view written) { return EqualIgnoringCase(key, written); }

const DirectiveOrOption* RowOf(std::string_view key) { return dialects::FindOptionRow(kRows, key, IsKey); }

/// Without the directives of their own.
std::string OptionNames() {
  return support::CommaSeparated(
      dialects::OptionKeys(kRows | std::views::filter([](const DirectiveOrOption& row) { return !row.is_directive; })));
}

}  // namespace

std::span<const dialects::OptionInfo> Options() {
  static const std::vector<dialects::OptionInfo> options = dialects::OptionInfos(kRows);
  return options;
}

void CheckOptions(const std::map<std::string, std::string>& options, diag::Engine& diagnostics) {
  dialects::CheckOptionRows<Settings>(kRows, options, "host50", IsKey, diagnostics);
}

void ApplyOptions(const std::map<std::string, std::string>& options, Settings& settings) {
  dialects::ApplyOptionRows(kRows, options, IsKey, settings);
}

OptionFault ApplyOption(std::string_view name, std::string_view value, Settings& settings) {
  const DirectiveOrOption* row = RowOf(name);
  if (row == nullptr || row->is_directive) return OptionFault::kName;
  return row->apply(value, settings) ? OptionFault::kNone : OptionFault::kValue;
}

std::string ExpectedOption(std::string_view name) {
  const DirectiveOrOption* row = RowOf(name);
  return row == nullptr || row->is_directive ? OptionNames() : std::string(row->info.values);
}

}  // namespace plcxx::host50
