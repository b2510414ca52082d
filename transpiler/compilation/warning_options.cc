#include "transpiler/compilation/warning_options.h"

#include <algorithm>
#include <string_view>

namespace plcxx::compilation {
namespace {

std::string_view WithoutDialect(std::string_view code) { return code.substr(code.find('-') + 1); }

/// Is `name` the code of a warning or note, whole ("nc110-W356") or without its dialect ("W356")?
bool NamesWarning(std::string_view name) {
  return std::ranges::any_of(diag::Catalogue(), [&](const diag::Row& row) {
    if (row.severity == diag::Severity::kError) return false;
    return row.code == name || WithoutDialect(row.code) == name;
  });
}

/// A code as a reader may take it for another one: capitals, signs between its parts, O and 0, I and 1.
std::string Folded(std::string_view code) {
  std::string text;
  for (char c : code) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == 'o') c = '0';
    if (c == 'i' || c == 'l') c = '1';
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) text += c;
  }
  return text;
}

}  // namespace

std::string RemedyOfUnknownWarning(std::string_view name) {
  for (const std::string_view prefix : {"-W", "no-", "error="}) {
    if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
  }
  const std::string folded = Folded(name);
  for (const diag::Row& row : diag::Catalogue()) {
    const bool is_whole = folded == Folded(row.code);
    if (!is_whole && folded != Folded(WithoutDialect(row.code))) continue;
    const std::string code(is_whole ? row.code : WithoutDialect(row.code));
    if (row.severity != diag::Severity::kError) return "did you mean '" + code + "'";
    if (is_whole) return "'" + code + "' is an error, and errors cannot be chosen";
  }
  return "plcxx explain --list shows them all";
}

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
