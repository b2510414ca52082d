// The options of a dialect as rows: what a key may be, and what its value sets.
//
// In: a dialect's own table of rows, each with `info` (OptionInfo) and `apply` (takes the value into the dialect's
// Settings; false when it does not fit). Out: the list for --help, the checks of `--set`, the settings.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"

namespace plcxx::dialects {

template <class Settings>
struct OptionRow {
  OptionInfo info;
  bool (*apply)(std::string_view value, Settings& settings);
};

/// Whether what the user wrote is this key.
using SameKey = bool (*)(std::string_view key, std::string_view written);

inline bool IsKey(std::string_view key, std::string_view written) { return key == written; }
/// '-' may be written as '_'.
inline bool IsKeyWithUnderscores(std::string_view key, std::string_view written) {
  return std::ranges::equal(key, written, [](char a, char b) { return a == b || (a == '-' && b == '_'); });
}

/// Null: no row has this key.
template <class Rows>
const auto* FindOptionRow(const Rows& rows, std::string_view written, SameKey same) {
  const auto row = std::ranges::find_if(rows, [&](const auto& candidate) { return same(candidate.info.key, written); });
  return row == std::end(rows) ? nullptr : &*row;
}

/// In the order of the rows.
template <class Rows>
std::vector<std::string_view> OptionKeys(Rows&& rows) {
  std::vector<std::string_view> keys;
  for (const auto& row : rows) keys.push_back(row.info.key);
  return keys;
}

template <class Rows>
std::vector<OptionInfo> OptionInfos(const Rows& rows) {
  std::vector<OptionInfo> infos;
  for (const auto& row : rows) infos.push_back(row.info);
  return infos;
}

/// `dialect`: its name.
template <class Rows>
void ReportUnknownOption(const Rows& rows, std::string_view key, std::string_view dialect, diag::Engine& diagnostics) {
  const std::vector<std::string_view> keys = OptionKeys(rows);
  diagnostics.Report({}, diag::UnknownOption, key, dialect, support::CommaSeparated(keys),
                     support::DidYouMean(key, keys));
}

/// Reports unknown keys and values that do not fit; the settings of those that do. `dialect`: its name.
template <class Settings, class Rows>
Settings CheckOptionRows(const Rows& rows, const std::map<std::string, std::string>& options, std::string_view dialect,
                         SameKey same, diag::Engine& diagnostics) {
  Settings settings;
  for (const auto& [key, value] : options) {
    const auto* row = FindOptionRow(rows, key, same);
    if (row == nullptr) {
      ReportUnknownOption(rows, key, dialect, diagnostics);
    } else if (!row->apply(value, settings)) {
      diagnostics.Report({}, diag::BadOptionValue, key, value, row->info.values);
    }
  }
  return settings;
}

/// Values that do not fit are passed over: CheckOptionRows has reported them.
template <class Settings, class Rows>
void ApplyOptionRows(const Rows& rows, const std::map<std::string, std::string>& options, SameKey same,
                     Settings& settings) {
  for (const auto& [key, value] : options) {
    if (const auto* row = FindOptionRow(rows, key, same)) row->apply(value, settings);
  }
}

}  // namespace plcxx::dialects
