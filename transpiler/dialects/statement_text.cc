#include "transpiler/dialects/statement_text.h"

#include <utility>

#include "transpiler/dialects/classicladder/machine/elements.h"
#include "transpiler/dialects/classicladder/source/elsewhere.h"

namespace plcxx::dialects {

std::string StatementText(std::string_view dialect, std::string_view source) {
  constexpr std::pair<std::string_view, std::string (*)(std::string_view)> kRows[] = {
      {"classicladder", classicladder::StatementText}};
  for (const auto& [name, text] : kRows) {
    if (name == dialect) return text(source);
  }
  return std::string(source);
}

std::vector<std::vector<source::Range>> LinesElsewhere(std::string_view dialect, const source::SourceManager& sources,
                                                       std::span<const source::Range> statements) {
  using Lines =
      std::vector<std::vector<source::Range>> (*)(const source::SourceManager&, std::span<const source::Range>);
  constexpr std::pair<std::string_view, Lines> kRows[] = {{"classicladder", classicladder::LinesElsewhere}};
  for (const auto& [name, lines] : kRows) {
    if (name == dialect) return lines(sources, statements);
  }
  return std::vector<std::vector<source::Range>>(statements.size());
}

}  // namespace plcxx::dialects
