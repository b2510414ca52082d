// The files of a proposal.
#include <algorithm>
#include <filesystem>
#include <set>

#include "transpiler/compilation/compilation.h"
#include "transpiler/project/proposal.h"
#include "transpiler/support/file_names.h"
#include "transpiler/yaml/words.h"

namespace plcxx::project {
namespace {

std::string Word(const std::string& text) { return yaml::YamlWord(text, "_-./"); }

std::string List(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + Word(word);
  return "[" + text + "]";
}

std::string Keys(const ProposedProgram& program, const std::string& indent) {
  std::string text = "name: " + Word(program.name) + "\n";
  if (!program.folder.empty()) text += indent + "folder: " + Word(program.folder) + "\n";
  text += indent + "dialect: " + program.dialect + "\n";
  text += indent + "sources: " + List(program.sources) + "\n";
  std::string options;
  for (const auto& [key, value] : program.options) options += (options.empty() ? "" : ", ") + key + ": " + Word(value);
  if (!options.empty()) text += indent + "options: {" + options + "}\n";
  return text;
}

// A merge request shows what changes, and nothing is merged whose scenarios fail. The package of plcxx is a file of the
// repository here: write down where yours is.
constexpr const char* kGitHub = R"(name: plc
on:
  push:
  pull_request:
permissions: {contents: read}
jobs:
  plc:
    runs-on: ubuntu-latest
    container: debian:bookworm
    steps:
    - run: apt-get update && apt-get install -y git g++
    - uses: actions/checkout@v4
      with: {fetch-depth: 0}
    - run: apt-get install -y ./ci/plcxx.deb    # where the package of plcxx is
    - run: plcxx check@ALL@@IN@
    - run: plcxx test@ALL@ --junit results.xml@IN@
    - if: github.event_name == 'pull_request'@IN@
      env: {BASE: "${{ github.base_ref }}"}
      run: |
        git config --global --add safe.directory "$GITHUB_WORKSPACE"
        plcxx diff "origin/$BASE.."@ALL@ --format markdown >> "$GITHUB_STEP_SUMMARY" || test $? = 1
)";

constexpr const char* kGitLab = R"(plc:
  image: debian:bookworm
  variables: {GIT_DEPTH: "0"}
  before_script:
  - apt-get update && apt-get install -y git g++ ./ci/plcxx.deb    # where the package of plcxx is
  script:@IN@
  - plcxx check@ALL@
  - plcxx test@ALL@ --junit results.xml
  - |
    if [ -n "$CI_MERGE_REQUEST_DIFF_BASE_SHA" ]; then
      plcxx diff "$CI_MERGE_REQUEST_DIFF_BASE_SHA.."@ALL@ --format markdown > changes.md || test $? = 1
    fi
  artifacts:
    when: always
    paths: [@CHANGES@]
    reports: {junit: @RESULTS@}
)";

std::string Filled(std::string text, std::string_view place, const std::string& with) {
  for (size_t at = 0; (at = text.find(place, at)) != std::string::npos; at += with.size())
    text.replace(at, place.size(), with);
  return text;
}

/// A word of a shell: whatever is in it.
std::string ShellWord(const std::string& text) { return "'" + Filled(text, "'", "'\\''") + "'"; }

}  // namespace

std::string ProjectText(const std::vector<ProposedProgram>& programs) {
  std::string text = "# What the program is made of, for every command of plcxx. Keys: plcxx print schema\n";
  if (programs.size() == 1) return text + Keys(programs.front(), "");
  text += "programs:\n";
  for (const ProposedProgram& program : programs) text += "- " + Keys(program, "  ");
  return text;
}

std::string AttributesText(const std::vector<ProposedProgram>& programs) {
  // git gives a diff tool one file, and a program of several is none without the others.
  const bool alone = std::ranges::all_of(
      programs, [](const ProposedProgram& program) { return program.loaded.size() == 1 && program.options.empty(); });
  std::string text =
      "# The bytes of the control's files are kept: line ends and code pages are part of them. What changed in what "
      "the\n";
  text += alone                 ? "# program does: git config diff.plc.command \"plcxx diff --git-external\"\n"
          : programs.size() > 1 ? "# programs do: plcxx diff HEAD.. --all\n"
                                : "# program does: plcxx diff HEAD..\n";
  std::set<std::string> sources, others;
  for (const ProposedProgram& program : programs) {
    for (const std::string& source : program.sources) {
      const std::string extension = std::filesystem::path(source).extension().string();
      sources.insert(support::IsFileName("x" + extension) && !extension.empty() ? "*" + extension : source);
    }
    for (const auto& [key, value] : program.options) others.insert(value);
    for (const ProposedFile& file : program.files) {
      if (file.what == "included") others.insert(file.name);
    }
  }
  const auto line = [](const std::string& pattern, const char* attributes) {
    const bool plain = pattern.find_first_of(" \t\"\\#!") == std::string::npos;
    return plain ? pattern + " " + attributes + "\n" : "";
  };
  for (const std::string& pattern : sources) text += line(pattern, alone ? "-text diff=plc" : "-text");
  for (const std::string& pattern : others) text += line(pattern, "-text");
  return text;
}

std::string ScenarioText() {
  return "# From power-on with nothing connected. Set inputs, run, and write down what has to come out:\n"
         "# - set: {INPUT: 1}\n"
         "# - run: {ms: 500}\n"
         "# - expect: {OUTPUT: 1}\n"
         "steps:\n"
         "- run: {slow: 2}\n";
}

std::optional<PipelineFile> Pipeline(std::string_view service, size_t programs, const std::string& folder) {
  const std::string all = programs > 1 ? " --all" : "";
  if (service == "github") {
    // The steps before are of the repository: there is no folder of the project yet.
    const std::string in = folder.empty() ? "" : "\n      working-directory: " + Word(folder);
    const std::string name = folder.empty() ? "" : "_" + compilation::NameFrom(Filled(folder, "/", "_"));
    return PipelineFile{".github/workflows/plcxx" + name + ".yml", Filled(Filled(kGitHub, "@ALL@", all), "@IN@", in)};
  }
  if (service == "gitlab") {
    const std::string in = folder.empty() ? "" : "\n  - " + Word("cd " + ShellWord(folder));
    const std::string before = folder.empty() ? "" : folder + "/";
    std::string text = Filled(Filled(kGitLab, "@ALL@", all), "@CHANGES@", Word(before + "changes.md"));
    text = Filled(text, "@RESULTS@", Word(before + "results.xml"));
    return PipelineFile{".gitlab-ci.yml", Filled(text, "@IN@", in)};
  }
  return std::nullopt;
}

}  // namespace plcxx::project
