#include "transpiler/mcp/child_run.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "transpiler/compile/child_process.h"
#include "transpiler/compile/end_signals.h"

namespace plcxx::mcp {
namespace {

using Clock = std::chrono::steady_clock;

/// Both ends of a pipe; closed when it goes.
class Pipe {
 public:
  Pipe() { valid_ = pipe2(ends_, O_CLOEXEC) == 0; }
  ~Pipe() {
    CloseReading();
    CloseWriting();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  bool valid() const { return valid_; }
  int reading() const { return ends_[0]; }
  int writing() const { return ends_[1]; }
  void CloseReading() { Close(ends_[0]); }
  void CloseWriting() { Close(ends_[1]); }

 private:
  static void Close(int& end) {
    if (end >= 0) close(end);
    end = -1;
  }
  int ends_[2] = {-1, -1};
  bool valid_ = false;
};

/// `scratch`: for its temporary files, which it leaves behind when it is killed.
[[noreturn]] void BecomeChild(std::vector<char*>& words, const std::string& directory, const std::string& scratch,
                              const Pipe& output, const Pipe& errors) {
  setpgid(0, 0);
  if (!scratch.empty()) setenv("TMPDIR", scratch.c_str(), 1);
  signal(SIGPIPE, SIG_DFL);
  const int nothing = open("/dev/null", O_RDONLY);
  const bool ready = nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(output.writing(), STDOUT_FILENO) >= 0 &&
                     dup2(errors.writing(), STDERR_FILENO) >= 0 && (directory.empty() || chdir(directory.c_str()) == 0);
  if (ready) execv(words[0], words.data());
  _exit(127);
}

/// False: there is nothing more to read.
bool ReadSome(int from, std::string& to, size_t limit, bool& cut_off) {
  char piece[1 << 14];
  const ssize_t count = read(from, piece, sizeof piece);
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  const size_t room = limit - std::min(limit, to.size());
  to.append(piece, std::min(room, static_cast<size_t>(count)));
  cut_off = cut_off || static_cast<size_t>(count) > room;
  return count > 0;
}

/// First as a user would: it ends what it has started, which is not in its group.
void EndInTime(pid_t child) {
  constexpr int kPauses = 100;
  constexpr std::chrono::milliseconds kPause(20);
  kill(-child, SIGTERM);
  siginfo_t ended = {};
  for (int i = 0; i < kPauses && ended.si_pid == 0; ++i) {
    std::this_thread::sleep_for(kPause);
    if (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) != 0) break;
  }
  kill(-child, SIGKILL);
}

}  // namespace

ChildResult RunChild(const std::vector<std::string>& arguments, const std::string& directory, const Limits& limits) {
  ChildResult result;
  Pipe output, errors;
  if (!output.valid() || !errors.valid()) return result;
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const compile::TemporaryDirectory scratch;
  const pid_t child = fork();
  if (child < 0) return result;
  if (child == 0) BecomeChild(words, directory, scratch.path(), output, errors);
  setpgid(child, child);  // whoever comes first
  compile::NotedGroup noted(child);
  output.CloseWriting();
  errors.CloseWriting();

  const Clock::time_point end = Clock::now() + std::chrono::seconds(limits.seconds);
  pollfd ends[] = {{.fd = output.reading(), .events = POLLIN, .revents = 0},
                   {.fd = errors.reading(), .events = POLLIN, .revents = 0}};
  while (ends[0].fd >= 0 || ends[1].fd >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    if (left <= 0) {
      result.timed_out = true;
      break;
    }
    if (poll(ends, 2, static_cast<int>(std::min<long long>(left, 1000))) < 0 && errno != EINTR) break;
    if (ends[0].revents != 0 && !ReadSome(ends[0].fd, result.output, limits.output_bytes, result.cut_off))
      ends[0].fd = -1;
    if (ends[1].revents != 0 && !ReadSome(ends[1].fd, result.errors, limits.output_bytes, result.cut_off))
      ends[1].fd = -1;
  }
  int status = 0;
  if (result.timed_out) EndInTime(child);
  noted.Forget();
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  kill(-child, SIGKILL);  // what it has left behind
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  return result;
}

}  // namespace plcxx::mcp
