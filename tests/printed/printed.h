// What the phases print of a program, as a text of the lines that are its own.
//
// In: a row of corpus.txt. Out: a section for each phase that the row asks for, without what the phase prints of every
// program of the language (groups.h), and without what an earlier section shows: `checked` has what checked facts add
// to the IR, `debug` what the debug flavour adds to the C++.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/printed/phases.h"

namespace plcxx::printed {

namespace fs = std::filesystem;

struct Row {
  std::vector<std::string> phases;  // names of Phases(), in the order of the sections
  std::string path;                 // of a scenario, a source of hnc or an IR text, from the project's root
};

/// "ir,cpp tests/golden/hnc/loops/do_while.yaml" a row; empty lines and those that begin with '#' are left out.
std::vector<Row> ReadCorpus(const fs::path& file);

/// Those that a row may ask for.
std::vector<std::string_view> PhaseNames();

/// A scenario's program, a source of hnc or an IR text; none: it cannot be read.
std::optional<Input> InputOf(const fs::path& file);

/// What the phase prints of it and does not print of every program of its language.
std::string OwnTextOf(const Phase& phase, const Input& input);

/// The text to keep of a row; what is wrong with the row, as its only line, when it asks for what is not there.
std::string PrintedText(const fs::path& root, const Row& row);

}  // namespace plcxx::printed
