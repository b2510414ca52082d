#include "transpiler/driver/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string_view>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/exit_codes.h"

namespace plcxx::driver {
namespace {

constexpr std::chrono::milliseconds kMoment(300);

int Descriptor(Stream stream) { return stream == Stream::kOutput ? STDOUT_FILENO : STDERR_FILENO; }

std::string_view EnvironmentValue(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

}  // namespace

bool IsTerminal(Stream stream) { return isatty(Descriptor(stream)) != 0; }

bool ShowsColours(Stream stream) {
  if (!IsTerminal(stream)) return false;
  return EnvironmentValue("NO_COLOR").empty() && EnvironmentValue("TERM") != "dumb";
}

std::optional<unsigned> TerminalWidth(Stream stream) {
  winsize size = {};
  if (ioctl(Descriptor(stream), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return size.ws_col;
}

void PrintUsageError(std::string_view text) { std::cerr << "plcxx: error: " << diag::EscapedLines(text) << '\n'; }

void PrintNote(std::string_view text) { std::cerr << "plcxx: note: " << diag::EscapedLines(text) << '\n'; }

int UsageError(std::string_view text) {
  PrintUsageError(text);
  return kWrongUse;
}

ProgressLine::ProgressLine()
    : terminal_(isatty(STDERR_FILENO) != 0 && EnvironmentValue("TERM") != "dumb"),
      start_(std::chrono::steady_clock::now()) {}

void ProgressLine::Show(std::string_view phase) {
  if (!terminal_ || std::chrono::steady_clock::now() - start_ < kMoment) return;
  std::cerr << "\r\x1b[K" << phase << " ..." << std::flush;
  shown_ = true;
}

void ProgressLine::Clear() {
  if (shown_) std::cerr << "\r\x1b[K" << std::flush;
  shown_ = false;
}

}  // namespace plcxx::driver
