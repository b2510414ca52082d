// Options of the command line whose value is a word of a list.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace plcxx::driver {

/// Refuses any other value, with the word that was probably meant and all of them. --help and completion show them.
CLI::Validator OneOf(std::vector<std::string> words);

}  // namespace plcxx::driver
