#include "transpiler/compilation/option_check.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "transpiler/compilation/compilation.h"

namespace plcxx::compilation {
namespace {

bool SameLetters(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::string OptionName(const dialects::Dialect& dialect, const std::string& name) {
  if (!dialect.options_ignore_case) return name;
  for (const dialects::OptionInfo& option : dialect.options) {
    if (SameLetters(option.key, name)) return std::string(option.key);
  }
  return name;
}

void CheckOption(const dialects::Dialect& dialect, const std::string& name, const std::string& value,
                 diag::Engine& diagnostics) {
  if (name == kFactsOption) {
    static_cast<void>(ReadFacts(value, diagnostics));
  } else {
    dialect.check_options({{OptionName(dialect, name), value}}, diagnostics);
  }
}

ir::Facts ReadFacts(const std::string& value, diag::Engine& diagnostics) {
  if (value == "checked") return ir::Facts::kChecked;
  if (value != "trusted")
    diagnostics.Report({}, diag::BadOptionValue, std::string(kFactsOption), value, "trusted or checked");
  return ir::Facts::kTrusted;
}

}  // namespace plcxx::compilation
