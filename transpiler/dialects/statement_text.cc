#include "transpiler/dialects/statement_text.h"

#include <utility>

#include "transpiler/dialects/classicladder/machine/elements.h"

namespace plcxx::dialects {

std::string StatementText(std::string_view dialect, std::string_view source) {
  constexpr std::pair<std::string_view, std::string (*)(std::string_view)> kRows[] = {
      {"classicladder", classicladder::StatementText}};
  for (const auto& [name, text] : kRows) {
    if (name == dialect) return text(source);
  }
  return std::string(source);
}

}  // namespace plcxx::dialects
