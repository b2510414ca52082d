// The first word of the command line: which subcommand is meant, and what was probably meant where there is none such.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace plcxx::driver {

/// What is wrong where the options of a command are in front of it; empty: nothing. The first word of `words` that is a
/// command is taken for it.
std::string OptionsInFront(const CLI::App& app, const std::vector<std::string>& words);

/// "help" and "help COMMAND" become --help. Gives what is wrong with the first word; empty: nothing.
std::string TakeHelpWord(const CLI::App& app, std::vector<std::string>& words);

/// ", did you mean '--dialect'" for the first of the words that is no option of the command, or which commands have it;
/// empty where none is near and none has it.
std::string DidYouMeanOption(const CLI::App& app, const CLI::App& command, const std::vector<std::string>& words);

/// What the parser of the command line says is wrong, as our messages are written.
std::string UsageProblem(const CLI::ParseError& error);

/// What is wrong with the first option or argument of the chosen command whose value is an empty text, as an empty
/// variable of a shell leaves it: what it asks for would be left undone, and nothing would say so. Empty: nothing is.
std::string EmptyValue(const CLI::App& app);

}  // namespace plcxx::driver
