// What depends on who reads: colours and the progress line, both only where a person looks at a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

namespace plcxx::driver {

enum class Stream : uint8_t { kOutput, kErrors };

bool IsTerminal(Stream stream);

/// A terminal that shows colours: not redirected, NO_COLOR unset or empty, TERM not "dumb".
bool ShowsColours(Stream stream);

/// In columns; none when it is no terminal.
std::optional<unsigned> TerminalWidth(Stream stream);

/// "plcxx: error: <text>" on standard error: faults of the command line, which have no place in a source.
void PrintUsageError(std::string_view text);

/// "plcxx: note: <text>" there: what the user should know of a command that goes on.
void PrintNote(std::string_view text);

/// Prints it; the exit code of a usage error, for commands that end with it.
int UsageError(std::string_view text);

/// One line on standard error that names the phase at work; nothing unless standard error is a terminal and the work
/// has taken longer than a moment. Erases itself.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { Clear(); }

  void Show(std::string_view phase);
  void Clear();

 private:
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace plcxx::driver
