// A folder is a project: plcxx.yaml says what its programs are made of, once for every command.
//
// In: the file's text. Out: its programs with all their paths as they are opened from the current directory, or all
// that is wrong with it, each with its place. Not its job: reading sources (compilation), scenarios, commands.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/project/reach.h"
#include "transpiler/yaml/place.h"

namespace plcxx::project {

inline constexpr std::string_view kProjectFile = "plcxx.yaml";

/// What `plcxx build` is to make for one target. Limits and clock are texts as its options take them.
struct Target {
  std::string name;
  std::string clock;
  std::optional<uint64_t> max_fast_us, max_slow_us, max_stack, max_code;
  std::string optimize;  // empty: as the command does by itself
  std::string compiler;  // likewise
  std::string output;
};

/// One program. Paths are relative to the current directory (or absolute), but those of `sources` and of files that
/// `options` name: these are relative to `folder`.
struct Program {
  std::string name;    // as the file says; empty: from the first source with logic
  std::string folder;  // empty: the current directory
  std::string dialect;
  std::vector<std::string> sources;  // patterns have become names
  std::string encoding;              // empty: detected
  std::vector<std::pair<std::string, std::string>> options;
  std::vector<std::string> include, system_include;
  std::vector<dialects::MacroOption> macros;
  std::vector<std::string> warnings;  // as the words of -W: "W370", "no-W303", "error=W356", "error"
  std::string baseline;
  std::vector<std::string> scenarios;  // files and folders
  std::vector<std::string> properties;
  std::string plant, panel;  // files; empty: none
  std::string generated;
  std::string host;  // empty: own
  std::vector<Target> targets;
};

struct Project {
  std::string path;    // of plcxx.yaml
  std::string folder;  // of the file; empty: the current directory
  std::vector<Program> programs;
};

using ProjectOrErrors = std::variant<Project, std::vector<yaml::Error>>;

/// Whether a YAML file is no scenario by its name: plcxx.yaml, plant.yaml, panel.yaml, NAME.plant.yaml,
/// NAME.panel.yaml.
bool IsNoScenario(const std::string& path);

/// The plcxx.yaml of a folder or of the folder of a file: there, or in the nearest folder above it, up to the folder
/// that is under version control. Relative where `path` is: "../plcxx.yaml".
std::optional<std::string> FindProject(const std::string& path);

ProjectOrErrors ReadProject(const std::string& path, Reach reach = Reach::kProject);
/// As ReadProject, from a text in memory (an editor's).
ProjectOrErrors ParseProject(const std::string& path, const std::string& text, Reach reach = Reach::kProject);

/// What the file says of a program, as the phases take it.
compilation::CompilationRequest RequestOf(const Program& program);

/// The program of this name; else nullptr. One without a name is called by its folder, or by its first source.
const Program* FindProgram(const Project& project, std::string_view name);
std::string NameOf(const Program& program);

}  // namespace plcxx::project
