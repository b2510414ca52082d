#include "transpiler/compilation/option_check.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "transpiler/compilation/compilation.h"

namespace plcxx::compilation {
namespace {

/// Is it the option `key` that was written?
bool IsWritten(const dialects::Dialect& dialect, std::string_view key, std::string_view written) {
  return std::ranges::equal(key, written, [&dialect](unsigned char a, unsigned char b) {
    return a == b || (dialect.options_ignore_case && std::tolower(a) == std::tolower(b)) ||
           (dialect.options_take_underscores && a == '-' && b == '_');
  });
}

}  // namespace

std::string OptionName(const dialects::Dialect& dialect, const std::string& name) {
  for (const dialects::OptionInfo& option : dialect.options) {
    if (IsWritten(dialect, option.key, name)) return std::string(option.key);
  }
  return name;
}

void SetOption(const dialects::Dialect& dialect, const std::string& name, const std::string& value,
               std::map<std::string, std::string>& options) {
  const std::string key = OptionName(dialect, name);
  const auto row = std::ranges::find(dialect.options, key, &dialects::OptionInfo::key);
  if (row != dialect.options.end()) {
    for (const std::string_view part : row->replaces) options.erase(std::string(part));
  }
  options[key] = value;
}

std::vector<diag::Diagnostic> CheckOption(const dialects::Dialect& dialect, const std::string& name,
                                          const std::string& value) {
  diag::Engine diagnostics;
  if (name == kFactsOption) {
    static_cast<void>(ReadFacts(value, diagnostics));
  } else {
    dialect.check_options({{OptionName(dialect, name), value}}, diagnostics);
  }
  std::vector<diag::Diagnostic> faults = diagnostics.all();
  // Of values that do not fit together more is quoted than this one.
  std::erase_if(faults, [quoted = "'" + value + "'"](const diag::Diagnostic& fault) {
    return fault.row->key != diag::UnknownOption.row.key && fault.text.find(quoted) == std::string::npos;
  });
  return faults;
}

ir::Facts ReadFacts(const std::string& value, diag::Engine& diagnostics) {
  if (value == "checked") return ir::Facts::kChecked;
  if (value != "trusted")
    diagnostics.Report({}, diag::BadOptionValue, std::string(kFactsOption), value, "trusted or checked");
  return ir::Facts::kTrusted;
}

}  // namespace plcxx::compilation
