#include "transpiler/compilation/warning_options.h"

#include <algorithm>
#include <string_view>

namespace plcxx::compilation {
namespace {

/// Is `name` the code of a warning or note, whole ("nc110-W356") or without its dialect ("W356")?
bool NamesWarning(std::string_view name) {
  return std::ranges::any_of(diag::Catalogue(), [&](const diag::Row& row) {
    if (row.severity == diag::Severity::kError) return false;
    return row.code == name || row.code.substr(row.code.find('-') + 1) == name;
  });
}

}  // namespace

diag::WarningOptions ReadWarningOptions(const std::vector<std::string>& arguments, std::vector<std::string>& unknown) {
  constexpr std::string_view kNo = "no-";
  constexpr std::string_view kError = "error=";
  diag::WarningOptions options;
  for (const std::string& argument : arguments) {
    std::string_view name = argument;
    if (name == "error" || name == "no-error") {
      options.all_errors = name == "error";
      continue;
    }
    const bool off = name.starts_with(kNo);
    if (off) name.remove_prefix(kNo.size());
    const bool error = name.starts_with(kError);
    if (error) name.remove_prefix(kError.size());
    if (!NamesWarning(name)) {
      unknown.push_back("-W" + argument);
      continue;
    }
    const std::string key(name);
    if (error && off) {
      options.errors.erase(key);
    } else if (off) {
      options.enabled.erase(key);
      options.disabled.insert(key);
    } else {
      options.disabled.erase(key);
      options.enabled.insert(key);
      if (error) options.errors.insert(key);
    }
  }
  return options;
}

}  // namespace plcxx::compilation
