#include "transpiler/driver/command_table.h"

#include <algorithm>

#include "transpiler/project/keys.h"

namespace plcxx::driver {
namespace {

/// What an option takes by its name: the tables that the commands check with.
std::vector<std::string> KnownValues(const std::string& name) {
  if (name == "--dialect") return project::WordsOf(project::Shape::kDialect);
  if (name == "--encoding") return project::WordsOf(project::Shape::kEncoding);
  if (name == "--target") return project::WordsOf(project::Shape::kTargets);
  return {};
}

/// "FORM:{text,json}" as what stands in front of the colon, and the words.
void SplitType(std::string type, OptionRow& row) {
  const size_t open = type.find(":{");
  if (open != std::string::npos && type.ends_with('}')) {
    std::string words = type.substr(open + 2, type.size() - open - 3);
    for (size_t begin = 0; begin <= words.size();) {
      const size_t end = std::min(words.find(',', begin), words.size());
      row.values.push_back(words.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  row.placeholder = type.substr(0, type.find(':'));
}

OptionRow RowOf(const CLI::Option& option) {
  OptionRow row;
  for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
  row.takes_value = option.get_items_expected_max() > 0;
  if (row.takes_value) SplitType(option.get_type_name(), row);
  if (row.names.empty()) row.placeholder = option.get_name();
  row.meaning = option.get_description();
  row.group = option.get_group();
  for (const std::string& name : row.names) {
    std::vector<std::string> known = KnownValues(name);
    if (!known.empty()) row.values = std::move(known);
  }
  return row;
}

CommandRow RowOf(CLI::App& app, const std::string& name) {
  CommandRow row{name, app.get_description(), app.get_footer(), {}};
  for (const CLI::Option* option : app.get_options()) row.options.push_back(RowOf(*option));
  return row;
}

}  // namespace

std::vector<CommandRow> CommandTable(CLI::App& app) {
  std::vector<CommandRow> table = {RowOf(app, "")};
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    table.push_back(RowOf(*command, command->get_name()));
  return table;
}

}  // namespace plcxx::driver
