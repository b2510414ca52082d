// What a folder of files, as they came from a control, holds: which are programs, in which language and encoding, and
// which are tables that options name.
//
// In: a folder. Out: a proposal for plcxx.yaml with the reason of each decision, tried by compiling it. Nothing is
// written.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plcxx::project {

struct ProposedFile {
  std::string name;      // relative to the folder
  std::string what;      // "source", "messages", "included", "left out"
  std::string encoding;  // of sources: its name
  std::string reason;
};

struct ProposedProgram {
  std::string folder;  // relative to the whole; empty: the same
  std::string name;
  std::string dialect, why_dialect;
  std::vector<std::string> sources;  // in their order
  std::vector<std::pair<std::string, std::string>> options;
  std::vector<ProposedFile> files;  // all that was found, with what was decided
  std::set<std::string> loaded;     // what its sources are and include, relative to the folder
  std::string order;                // why the sources are in this order; empty: there is one
  std::string check;                // "no errors, 3 warnings"
  bool ok = false;                  // no errors
  std::string no_program;           // a file in a language that only looks like this one, and what to do about it
};

/// The programs of the folder itself, else one for each folder in it, or for what lies deeper there; empty: no file is
/// a source that plcxx knows. One without sources has files that cannot be a program, and says so in `no_program`.
std::vector<ProposedProgram> ProposePrograms(const std::string& folder, std::string_view dialect);

/// The text of plcxx.yaml.
std::string ProjectText(const std::vector<ProposedProgram>& programs);
/// Which bytes git keeps as they are, and how it compares the sources.
std::string AttributesText(const std::vector<ProposedProgram>& programs);
/// A first scenario of a program.
std::string ScenarioText();

/// Of a pipeline: where its file is in the repository, and what it says.
struct PipelineFile {
  std::string path, text;
};
/// `folder`: of the project, relative to the repository; empty: its root.
std::optional<PipelineFile> Pipeline(std::string_view service, size_t programs, const std::string& folder);

}  // namespace plcxx::project
