// The commands and options of plcxx as a table, read from the parser that takes them: manual pages and completion are
// made from it, so that they cannot say anything else.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace plcxx::driver {

struct OptionRow {
  std::vector<std::string> names;  // "-q", "--quiet"; none: a positional argument
  std::string placeholder;         // "DIR"; of a positional one its name; empty: a flag
  std::string meaning, group;
  std::vector<std::string> values;  // all that it takes; empty where others may be
  bool takes_value = false;
};

struct CommandRow {
  std::string name, meaning, footer;
  std::vector<OptionRow> options;
};

/// The tool itself first, with an empty name.
std::vector<CommandRow> CommandTable(CLI::App& app);

}  // namespace plcxx::driver
