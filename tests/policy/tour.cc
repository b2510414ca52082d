#include "tests/policy/tour.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "tests/policy/explain.h"
#include "tests/temporary_directory.h"

namespace plcxx::policy {
namespace {

/// git takes no commit from a person without a name; files of the reader's home decide nothing.
constexpr std::string_view kCommitter =
    "GIT_AUTHOR_NAME=Reader GIT_AUTHOR_EMAIL=reader@localhost GIT_COMMITTER_NAME=Reader "
    "GIT_COMMITTER_EMAIL=reader@localhost GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1";

struct Command {
  std::string text;
  std::vector<std::string> expected;
  size_t line = 0;
};

std::vector<Command> CommandsOf(const Fence& fence) {
  std::vector<Command> commands;
  size_t line = fence.line;
  for (const std::string& text : Lines(fence.text)) {
    ++line;
    if (text.starts_with("$ ")) {
      commands.push_back({text.substr(2), {}, line});
    } else if (!commands.empty()) {
      commands.back().expected.push_back(text);
    }
  }
  return commands;
}

struct Result {
  int exit_code = -1;
  std::string output;
};

/// Where a page keeps what its commands leave for the next one, outside of the directory that its reader sees.
class Workplace {
 public:
  Workplace() { std::filesystem::create_directory(work_ = directory_.path() / "work"); }

  /// The directory of the next command.
  const std::filesystem::path& here() const { return work_; }
  std::string errors() const { return directory_.File("errors"); }
  std::string next() const { return directory_.File("next"); }
  void MoveOn() {
    std::ifstream file(next());
    if (std::string line; std::getline(file, line)) work_ = line;
  }

 private:
  testing_support::TemporaryDirectory directory_;
  std::filesystem::path work_;
};

/// Standard error follows standard output, so that the order does not depend on buffers.
Result Run(const std::string& command, Workplace& workplace, const std::string& tool_directory) {
  const std::string script = "cd '" + workplace.here().string() + "' && export PATH='" + tool_directory +
                             "':\"$PATH\" PLCXX='" + Root() + "' " + std::string(kCommitter) + " && { " + command +
                             "\n} 2>'" + workplace.errors() + "'; code=$?\npwd >'" + workplace.next() + "'; cat '" +
                             workplace.errors() + "'; exit $code\n";
  Result result;
  FILE* pipe = popen(script.c_str(), "r");
  if (pipe == nullptr) return result;
  char piece[4096];
  for (size_t n = 0; (n = fread(piece, 1, sizeof piece, pipe)) > 0;) result.output.append(piece, n);
  const int status = pclose(pipe);
  workplace.MoveOn();
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

/// The first line that is not as expected; empty when all are.
std::string Difference(const std::vector<std::string>& expected, const std::vector<std::string>& actual) {
  size_t at = 0;
  bool skipping = false;
  for (const std::string& line : expected) {
    if (line == "...") {
      skipping = true;
      continue;
    }
    if (skipping)
      at = static_cast<size_t>(std::find(actual.begin() + std::ptrdiff_t(at), actual.end(), line) - actual.begin());
    if (at >= actual.size()) return "nothing where '" + line + "' is expected";
    if (actual[at] != line) return "'" + actual[at] + "' where '" + line + "' is expected";
    skipping = false;
    ++at;
  }
  if (!skipping && at < actual.size()) return "also '" + actual[at] + "'";
  return {};
}

}  // namespace

Findings RunTour(const std::string& name, std::string_view text, const std::string& tool_directory) {
  Workplace workplace;
  Findings findings;
  size_t commands = 0;
  for (const Fence& fence : Fences(text)) {
    for (const std::string& word : fence.words) {
      if (!word.starts_with("file=")) continue;
      const std::filesystem::path file = workplace.here() / word.substr(5);
      std::filesystem::create_directories(file.parent_path());
      std::ofstream(file, std::ios::binary) << fence.text;
    }
    if (fence.words.empty() || fence.words.front() != "console") continue;
    const bool fails = std::ranges::find(fence.words, "fails") != fence.words.end();
    for (const Command& command : CommandsOf(fence)) {
      ++commands;
      const Result result = Run(command.text, workplace, tool_directory);
      if (result.exit_code != (fails ? 1 : 0)) {
        findings.push_back(Place(name, command.line) + "exit code " + std::to_string(result.exit_code) + ": " +
                           result.output);
        continue;
      }
      const std::string difference = Difference(command.expected, Lines(result.output));
      if (!difference.empty()) findings.push_back(Place(name, command.line) + difference);
    }
  }
  if (commands == 0) findings.push_back(name + ": no commands");
  return findings;
}

}  // namespace plcxx::policy
