// One command of plcxx for a tool: its words from the tool's parameters, its run, and what came out as JSON.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/mcp/tools.h"

namespace plcxx::mcp {

/// Schemas of parameters that several tools have.
Json ObjectSchema(Json properties, Json required);
Json TextSchema(std::string_view description);
Json TextsSchema(std::string_view description);
Json NumberSchema(std::string_view description);
/// `sources`, `dialect`, `options`, `encoding`, `include`, `define`, `project`, `program`, `seconds`, and the given
/// ones.
Json ProgramSchema(const Json& more, Json required);

class Command {
 public:
  /// Throws rpc::Error where `arguments` is wrong.
  Command(const Workplace& workplace, const Json& arguments, std::string_view subcommand);

  void Add(std::string word) { words_.push_back(std::move(word)); }
  /// A file or folder of the workplace; throws rpc::Error when it is outside of it, or looks like an option.
  void AddPath(const std::string& path);
  /// A word that a client chose: never an option.
  void AddWord(const std::string& word);
  /// `sources`, else `project` and `program`.
  void AddSources();
  /// `project` and `program`.
  void AddProject();
  /// --time for each of so many questions: what is found out until then is worth more than none of it, which is left of
  /// a process that is ended.
  void AddTime(size_t questions);
  /// Options of the dialect and what else makes the program.
  void AddProgram();

  ChildResult Run() const;
  /// The path as a path of the workplace; throws as AddPath.
  std::string Checked(const std::string& path) const;

 private:
  /// Where a file that an option names may be looked for.
  std::vector<std::filesystem::path> FoldersOfOptions() const;

  const Workplace& workplace_;
  const Json& arguments_;
  std::vector<std::string> words_;
  int seconds_ = 60;
};

std::vector<std::string> TextsOf(const Json& arguments, const char* key);

/// exitCode, and what was wrong with the run: timedOut, cutOff, messages (standard error).
Json ResultOf(const ChildResult& run);
/// The same with the output as JSON under `key`; as text under "output" where it is none.
Json JsonResultOf(const ChildResult& run, const char* key);
Json TextResultOf(const ChildResult& run, const char* key);

}  // namespace plcxx::mcp
