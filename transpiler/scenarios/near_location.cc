#include "transpiler/scenarios/near_location.h"

#include <set>
#include <vector>

#include "transpiler/ir/symbol_names.h"
#include "transpiler/support/near_words.h"

namespace plcxx::scenarios {
namespace {

/// Empty where none is near.
std::string DidYouMeanLocation(const dialects::Dialect& dialect, const ir::Program& program, std::string_view text) {
  std::set<std::string, std::less<>> names;
  for (const ir::Place& place : program.places) names.insert(place.address);
  for (const ir::Symbol& symbol : program.symbols) names.insert(symbol.name);
  for (const ir::Documentation& documented : program.documentation) {
    names.insert(documented.address);
    ir::ForEachSymbolName(documented, [&names](std::string_view symbol) { names.emplace(symbol); });
  }
  const ir::NameIndex index(program);
  // '!LAMP' and 'LAMP' are one name where the language marks names so.
  const bool marked = text.starts_with('!');
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string near(support::NearestWord(marked ? text.substr(1) : text, views));
  if (near.empty()) return {};
  const std::string as_written = marked && dialect.locate(index, "!" + near) ? "!" + near : near;
  return dialect.locate(index, as_written) ? ", did you mean '" + as_written + "'" : std::string();
}

}  // namespace

std::string WhichLocations(const dialects::Dialect& dialect, const ir::Program& program, std::string_view text) {
  const std::string near = DidYouMeanLocation(dialect, program, text);
  return near.empty() ? "; 'plcxx report --print-symbols' lists those of the program" : near;
}

std::string NoSuchLocation(const dialects::Dialect& dialect, const ir::Program& program, std::string_view text) {
  return "'" + std::string(text) + "' is no location of " + std::string(dialect.name) +
         WhichLocations(dialect, program, text);
}

}  // namespace plcxx::scenarios
