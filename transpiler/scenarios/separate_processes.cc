#include "transpiler/scenarios/separate_processes.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <deque>
#include <exception>
#include <list>
#include <memory>
#include <utility>

#include "transpiler/compile/end_signals.h"
#include "transpiler/support/exit_code.h"

namespace plcxx::scenarios {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kHeadBytes = 1 + 2 * sizeof(uint32_t);  // kind, item, size of what follows
constexpr size_t kMostErrorBytes = 4096;                 // shown of what a child wrote to standard error

/// Compilers and emulators that the child started go with it.
void EndGroup(int /*signal*/) { kill(0, SIGKILL); }

struct Child {
  pid_t pid = -1;
  std::unique_ptr<compile::NotedGroup> noted;
  int pipe = -1;
  std::FILE* errors = nullptr;  // its standard error
  ItemGroup left;               // not reported yet
  std::optional<uint32_t> current;
  Clock::time_point deadline;
  unsigned seconds = 0;  // the deadline is of
  bool late = false;
  std::string bytes;  // received, not yet understood
};

/// No folder is asked for room.
std::FILE* FileInMemory() {
  const int descriptor = memfd_create("standard error", MFD_CLOEXEC);
  std::FILE* const file = descriptor < 0 ? nullptr : fdopen(descriptor, "w+b");
  if (file == nullptr && descriptor >= 0) close(descriptor);
  return file;
}

std::string TextOf(std::FILE* file) {
  std::string text(kMostErrorBytes, '\0');
  if (std::fseek(file, 0, SEEK_SET) != 0) return {};
  text.resize(std::fread(text.data(), 1, text.size(), file));
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

std::string HowItEnded(const Child& child, int status) {
  if (child.late) return "did not end within " + std::to_string(child.seconds) + " s; --time-limit SECONDS allows more";
  std::string why = "ended by a fault of plcxx itself";
  if (WIFSIGNALED(status)) {
    why += ": signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
  } else if (WEXITSTATUS(status) != support::kInternalFaultExit) {
    why += ": exit code " + std::to_string(WEXITSTATUS(status)) + " without a result";
  }
  const std::string errors = TextOf(child.errors);
  if (!errors.empty()) why += "\n" + errors;
  return why;
}

class Pool {
 public:
  Pool(const std::vector<ItemGroup>& groups, const SeparateOptions& options, const GroupWork& work,
       const ItemEnded& ended)
      : waiting_(groups.begin(), groups.end()), options_(options), work_(work), ended_(ended) {}

  void Run() {
    compile::CleanUpAtEndSignals();  // before anything is forked: this process cleans up
    while (!waiting_.empty() || !children_.empty()) {
      while (!waiting_.empty() && children_.size() < std::max(1U, options_.jobs)) {
        ItemGroup items = std::move(waiting_.front());
        waiting_.pop_front();
        if (!items.empty()) Start(std::move(items));
      }
      Listen();
    }
  }

 private:
  void Start(ItemGroup items) {
    int ends[2];
    std::FILE* const errors = FileInMemory();
    if (errors == nullptr || pipe2(ends, O_CLOEXEC) != 0) {
      if (errors != nullptr) std::fclose(errors);
      return FailAll(items);
    }
    std::fflush(nullptr);
    const pid_t pid = fork();
    if (pid == 0) {
      close(ends[0]);
      RunChild(items, ends[1], fileno(errors));
    }
    close(ends[1]);
    if (pid < 0) {
      close(ends[0]);
      std::fclose(errors);
      return FailAll(items);
    }
    setpgid(pid, pid);  // here and in the child: whoever comes first
    Child& child = children_.emplace_back();
    child.pid = pid;
    child.noted = std::make_unique<compile::NotedGroup>(pid);
    child.pipe = ends[0];
    child.errors = errors;
    child.left = std::move(items);
    SetDeadline(child, options_.common_seconds);
  }

  void FailAll(const ItemGroup& items) {
    const std::string why = std::string("cannot start a process: ") + std::strerror(errno);
    for (const uint32_t item : items) ended_(item, {std::nullopt, why});
  }

  [[noreturn]] void RunChild(const ItemGroup& items, int pipe, int errors) {
    setpgid(0, 0);
    signal(SIGTERM, EndGroup);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    dup2(errors, STDERR_FILENO);
    for (const Child& other : children_) close(other.pipe);
    WorkReport report(pipe);
    try {
      work_(items, report);
    } catch (const std::exception& fault) {
      std::fprintf(stderr, "plcxx: %s\n", fault.what());
      std::fflush(stderr);
      _exit(support::kInternalFaultExit);
    }
    _exit(0);
  }

  static void SetDeadline(Child& child, unsigned seconds) {
    child.seconds = seconds;
    child.deadline = Clock::now() + std::chrono::seconds(seconds);
  }

  /// Waits for a word of any child, or for the first deadline.
  void Listen() {
    if (children_.empty()) return;
    Clock::time_point first = children_.front().deadline;
    std::vector<pollfd> polled;
    for (const Child& child : children_) {
      polled.push_back({child.pipe, POLLIN, 0});
      first = std::min(first, child.deadline);
    }
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(first - Clock::now()).count();
    poll(polled.data(), polled.size(), static_cast<int>(std::clamp<int64_t>(wait, 0, 1'000'000)));
    auto child = children_.begin();
    for (const pollfd& entry : polled) {
      const auto next = std::next(child);
      if (entry.revents != 0) {
        if (!Receive(*child)) End(child);
      } else if (!child->late && Clock::now() >= child->deadline) {
        child->late = true;  // its pipe ends with it
        kill(-child->pid, SIGKILL);
        kill(child->pid, SIGKILL);
        SetLater(*child);
      }
      child = next;
    }
  }

  static void SetLater(Child& child) { child.deadline = Clock::now() + std::chrono::hours(1); }

  /// False at the end of the pipe.
  bool Receive(Child& child) {
    std::array<char, 65536> buffer;
    const ssize_t count = read(child.pipe, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) return true;
    if (count <= 0) return false;
    child.bytes.append(buffer.data(), static_cast<size_t>(count));
    while (child.bytes.size() >= kHeadBytes) {
      std::array<uint32_t, 2> head{};
      std::memcpy(head.data(), child.bytes.data() + 1, sizeof head);
      if (child.bytes.size() < kHeadBytes + head[1]) break;
      const char kind = child.bytes[0];
      std::string result = child.bytes.substr(kHeadBytes, head[1]);
      child.bytes.erase(0, kHeadBytes + head[1]);
      Take(child, kind, head[0], std::move(result));
    }
    return true;
  }

  void Take(Child& child, char kind, uint32_t item, std::string result) {
    if (child.late) return;  // it is too late for words
    child.current.reset();
    if (kind == 'b') {
      child.current = item;
      SetDeadline(child, options_.item_seconds);
      return;
    }
    SetDeadline(child, options_.common_seconds);
    if (kind != 'd') return;
    std::erase(child.left, item);
    ended_(item, {std::move(result), {}});
  }

  void End(std::list<Child>::iterator ended) {
    Child child = std::move(*ended);
    children_.erase(ended);
    close(child.pipe);
    int status = 0;
    child.noted->Forget();
    while (waitpid(child.pid, &status, 0) < 0 && errno == EINTR) continue;
    kill(-child.pid, SIGKILL);  // what it left behind
    compile::WaitIfEnding();
    if (!child.current && child.left.size() == 1) child.current = child.left.front();
    if (child.left.empty()) {
      // Nothing is missing.
    } else if (child.current) {
      ended_(*child.current, {std::nullopt, HowItEnded(child, status)});
      std::erase(child.left, *child.current);
      waiting_.push_front(std::move(child.left));
    } else {
      for (const uint32_t item : child.left) waiting_.push_front({item});
    }
    std::fclose(child.errors);
  }

  std::deque<ItemGroup> waiting_;
  std::list<Child> children_;
  const SeparateOptions& options_;
  const GroupWork& work_;
  const ItemEnded& ended_;
};

}  // namespace

void WorkReport::Send(char kind, uint32_t item, std::string_view bytes) {
  std::string message(1, kind);
  const std::array<uint32_t, 2> head = {item, static_cast<uint32_t>(bytes.size())};
  message.append(reinterpret_cast<const char*>(head.data()), sizeof head);
  message += bytes;
  for (size_t at = 0; at < message.size();) {
    const ssize_t count = write(pipe_, message.data() + at, message.size() - at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) _exit(support::kInternalFaultExit);  // nobody listens
    at += static_cast<size_t>(count);
  }
}

void WorkSeparately(const std::vector<ItemGroup>& groups, const SeparateOptions& options, const GroupWork& work,
                    const ItemEnded& ended) {
  Pool(groups, options, work, ended).Run();
}

}  // namespace plcxx::scenarios
