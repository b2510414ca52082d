#include "transpiler/compile/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "transpiler/support/system_words.h"

extern char** environ;

namespace plcxx::compile {
namespace {

constexpr int kAnswerMilliseconds = 10'000;
constexpr int64_t kAskMilliseconds = 200;

std::vector<char*> Pointers(const std::vector<std::string>& arguments) {
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// Of what a program makes of its own while it runs, such as a compiler's assembly: it would stay when it is killed.
const std::string& ScratchPath() {
  static const TemporaryDirectory scratch;
  return scratch.path();
}

/// Ours, with another TMPDIR. `words` has what the pointers point to.
std::vector<char*> EnvironmentOf(std::vector<std::string>& words) {
  constexpr std::string_view kName = "TMPDIR=";
  for (char** word = environ; *word != nullptr; ++word) {
    if (ScratchPath().empty() || !std::string_view(*word).starts_with(kName)) words.emplace_back(*word);
  }
  if (!ScratchPath().empty()) {
    std::error_code ignored;
    words.push_back(std::string(kName) + std::filesystem::absolute(ScratchPath(), ignored).string());
  }
  return Pointers(words);
}

/// The child leads a process group of its own, which is killed whole; that of a process which was forked stays in the
/// group of that one, which is killed whole as well.
class GroupAttributes {
 public:
  GroupAttributes() {
    posix_spawnattr_init(&attributes_);
    CleanUpAtEndSignals();
    if (CleansUp()) posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
  }
  ~GroupAttributes() { posix_spawnattr_destroy(&attributes_); }
  GroupAttributes(const GroupAttributes&) = delete;
  GroupAttributes& operator=(const GroupAttributes&) = delete;

  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

ProcessResult Run(const std::vector<std::string>& arguments, int seconds, const std::string& directory,
                  const std::function<bool()>* stops) {
  ProcessResult result;
  int fds[2];
  if (pipe2(fds, O_CLOEXEC) != 0) return result;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, fds[1], 1);
  posix_spawn_file_actions_adddup2(&actions, fds[1], 2);
  if (!directory.empty()) posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  const GroupAttributes attributes;
  pid_t pid = -1;
  const std::vector<char*> pointers = Pointers(arguments);
  std::vector<std::string> variables;
  const std::vector<char*> environment = EnvironmentOf(variables);
  const int failed = posix_spawnp(&pid, pointers[0], &actions, attributes.get(), pointers.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  close(fds[1]);
  if (failed != 0) {
    close(fds[0]);
    return result;
  }
  NotedGroup noted(pid);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  char buffer[4096];
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
    pollfd poll_fd{fds[0], POLLIN, 0};
    const auto wait = static_cast<int>(stops == nullptr ? left : std::min<int64_t>(left, kAskMilliseconds));
    const int ready = left <= 0 ? 0 : poll(&poll_fd, 1, wait);
    const bool is_interrupted = ready < 0 && errno == EINTR;
    const bool goes_on = is_interrupted || (ready == 0 && left > wait);
    if (left <= 0 || (ready <= 0 && !goes_on) || (stops != nullptr && (*stops)())) {
      kill(CleansUp() ? -pid : pid, SIGKILL);
      break;
    }
    if (ready <= 0) continue;
    const ssize_t count = read(fds[0], buffer, sizeof buffer);
    if (count <= 0) break;
    result.output.append(buffer, static_cast<size_t>(count));
  }
  close(fds[0]);
  int status = 0;
  noted.Forget();
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  WaitIfEnding();
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  return result;
}

}  // namespace

std::string TemporaryPlace() {
  const char* const base = std::getenv("TMPDIR");
  return base != nullptr && *base != '\0' ? base : "/tmp";
}

TemporaryDirectory::TemporaryDirectory() {
  std::string pattern = TemporaryPlace() + "/plcxx-XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) {
    problem_ = errno;
    return;
  }
  path_ = pattern;
  noted_.Note(path_);
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  if (valid()) std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryDirectory::WhyNot() const {
  return "cannot write temporary files below '" + TemporaryPlace() + "': " + Cause() + "; " +
         std::string(kTemporaryRemedy);
}

std::string TemporaryDirectory::Cause() const {
  if (problem_ != 0) return support::SystemWords(problem_);
  // What others wrote they wrote as streams, which do not tell.
  const std::string page(64u << 10, '0');
  std::FILE* const probe = std::fopen((path_ + "/room").c_str(), "wb");
  const bool has_room =
      probe != nullptr && std::fwrite(page.data(), 1, page.size(), probe) == page.size() && std::fflush(probe) == 0;
  const int problem = has_room ? ENOSPC : errno;
  if (probe != nullptr) std::fclose(probe);
  return support::SystemWords(problem);
}

bool TemporaryDirectory::Write(const std::string& name, std::string_view text) const {
  std::FILE* file = std::fopen((path_ + "/" + name).c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  return std::fclose(file) == 0 && written;
}

ProcessResult RunProcess(const std::vector<std::string>& arguments, int seconds, const std::string& directory) {
  return Run(arguments, seconds, directory, nullptr);
}

ProcessResult RunProcessGroup(const std::vector<std::string>& arguments, int seconds, const std::string& directory,
                              const std::function<bool()>& stops) {
  return Run(arguments, seconds, directory, &stops);
}

ChildProcess::~ChildProcess() {
  if (to_child_ >= 0) close(to_child_);
  if (from_child_ >= 0) close(from_child_);
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    noted_.Forget();
    waitpid(pid_, nullptr, 0);
  }
}

bool ChildProcess::Start(const std::vector<std::string>& arguments) {
  int down[2], up[2];
  if (pipe2(down, O_CLOEXEC) != 0) return false;
  if (pipe2(up, O_CLOEXEC) != 0) {
    close(down[0]);
    close(down[1]);
    return false;
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, down[0], 0);
  posix_spawn_file_actions_adddup2(&actions, up[1], 1);
  const GroupAttributes attributes;
  const std::vector<char*> pointers = Pointers(arguments);
  pid_t pid = -1;
  const int failed = posix_spawnp(&pid, pointers[0], &actions, attributes.get(), pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(down[0]);
  close(up[1]);
  to_child_ = down[1];
  from_child_ = up[0];
  fcntl(to_child_, F_SETFL, O_NONBLOCK);  // Send waits for both directions
  if (failed == 0) {
    pid_ = pid;
    noted_.Note(pid);
  }
  return failed == 0;
}

bool ChildProcess::Send(std::string_view bytes) {
  // A child that died must be a message, not the end of this process.
  static const bool ignored = (signal(SIGPIPE, SIG_IGN), true);
  static_cast<void>(ignored);
  while (!bytes.empty()) {
    const ssize_t count = write(to_child_, bytes.data(), bytes.size());
    if (count > 0) {
      bytes.remove_prefix(static_cast<size_t>(count));
      continue;
    }
    if (count == 0 || errno != EAGAIN) return false;
    pollfd either[] = {{to_child_, POLLOUT, 0}, {from_child_, POLLIN, 0}};
    if (poll(either, 2, kAnswerMilliseconds) <= 0) return false;
    if ((either[1].revents & POLLIN) != 0 && !Fetch()) return false;
  }
  return true;
}

bool ChildProcess::Fetch() {
  std::array<char, 65536> bytes;  // as many as a pipe holds
  const ssize_t count = read(from_child_, bytes.data(), bytes.size());
  if (count <= 0) {
    WaitIfEnding();
    return false;
  }
  fetched_.erase(0, std::exchange(taken_, 0));
  fetched_.append(bytes.data(), static_cast<size_t>(count));
  return true;
}

bool ChildProcess::Receive(void* bytes, size_t size) {
  while (fetched_.size() - taken_ < size) {
    pollfd poll_fd{from_child_, POLLIN, 0};
    if (poll(&poll_fd, 1, kAnswerMilliseconds) <= 0 || !Fetch()) return false;
  }
  fetched_.copy(static_cast<char*>(bytes), size, taken_);
  taken_ += size;
  return true;
}

}  // namespace plcxx::compile
