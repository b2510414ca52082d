#include "transpiler/scenarios/near_location.h"

#include <set>
#include <vector>

#include "transpiler/support/near_words.h"

namespace plcxx::scenarios {
namespace {

/// "LAMP, LIGHT": each.
void AddNames(std::string_view list, std::set<std::string, std::less<>>& names) {
  while (!list.empty()) {
    const size_t end = list.find(", ");
    names.emplace(list.substr(0, end));
    list = end == std::string_view::npos ? std::string_view() : list.substr(end + 2);
  }
}

}  // namespace

std::string DidYouMeanLocation(const dialects::Dialect& dialect, const ir::Program& program, std::string_view text) {
  std::set<std::string, std::less<>> names;
  for (const ir::Place& place : program.places) names.insert(place.address);
  for (const ir::Symbol& symbol : program.symbols) names.insert(symbol.name);
  for (const ir::Documentation& documented : program.documentation) {
    names.insert(documented.address);
    AddNames(documented.symbols, names);
  }
  // '!LAMP' and 'LAMP' are one name where the language marks names so.
  const bool marked = text.starts_with('!');
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string near(support::NearestWord(marked ? text.substr(1) : text, views));
  if (near.empty()) return {};
  const std::string as_written = marked && dialect.locate(program, "!" + near) ? "!" + near : near;
  return dialect.locate(program, as_written) ? ", did you mean '" + as_written + "'" : std::string();
}

}  // namespace plcxx::scenarios
