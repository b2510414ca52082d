#include "transpiler/compile/end_signals.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <ctime>

namespace plcxx::compile {
namespace {

constexpr std::array kEndSignals = {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU};
constexpr size_t kMaxDirectories = 64;  // what is beyond is not noted
constexpr size_t kMaxGroups = 512;
constexpr size_t kMaxPath = 1024;
constexpr int kMaxDepth = 64;
constexpr int kMaxPauses = 25;   // until those that were asked to end are killed
constexpr int kMaxAttempts = 5;  // a child that is being killed may still make a file

struct DirectorySlot {
  std::atomic<bool> is_taken = false;
  std::atomic<bool> is_noted = false;
  std::array<char, kMaxPath> path{};
};

std::array<DirectorySlot, kMaxDirectories> noted_directories;
std::array<std::atomic<pid_t>, kMaxGroups> noted_groups;
std::atomic<pid_t> owner = 0;
std::atomic<bool> ends = false;

// What follows runs in a signal handler: system calls and memory of its own stack only.

/// As the kernel lists a directory.
struct Entry {
  uint64_t inode;
  int64_t next;
  uint16_t bytes;
  uint8_t type;
  char name[1];
};

void Empty(int directory, int depth) {
  alignas(Entry) std::array<char, 1024> buffer;
  for (;;) {
    const long count = syscall(SYS_getdents64, directory, buffer.data(), buffer.size());
    if (count <= 0) return;
    for (long at = 0; at < count;) {
      const auto* const entry = reinterpret_cast<const Entry*>(buffer.data() + at);
      at += entry->bytes;
      if (strcmp(entry->name, ".") == 0 || strcmp(entry->name, "..") == 0) continue;
      if (unlinkat(directory, entry->name, 0) == 0 || depth == 0) continue;
      const int below = openat(directory, entry->name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
      if (below < 0) continue;
      Empty(below, depth - 1);
      close(below);
      unlinkat(directory, entry->name, AT_REMOVEDIR);
    }
  }
}

void Pause() {
  const timespec pause = {.tv_sec = 0, .tv_nsec = 20'000'000};
  nanosleep(&pause, nullptr);
}

void Remove(const char* path) {
  for (int i = 0; i < kMaxAttempts; ++i) {
    const int directory = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (directory < 0) return;
    Empty(directory, kMaxDepth);
    close(directory);
    if (rmdir(path) == 0) return;
    Pause();
  }
}

/// A child that is plcxx itself has children in noted_groups of their own, and ends them when it is asked to end.
void EndGroups() {
  for (const std::atomic<pid_t>& group : noted_groups) {
    if (group > 0) kill(-group, SIGTERM);
  }
  bool waits = true;
  for (int i = 0; i < kMaxPauses && waits; ++i) {
    waits = false;
    for (const std::atomic<pid_t>& group : noted_groups)
      waits = (group > 0 && waitpid(group, nullptr, WNOHANG) == 0) || waits;
    if (waits) Pause();
  }
  for (const std::atomic<pid_t>& group : noted_groups) {
    if (group > 0) kill(-group, SIGKILL);
  }
}

void EndNow(int number) {
  struct sigaction standard = {};
  standard.sa_handler = SIG_DFL;
  sigaction(number, &standard, nullptr);
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, number);
  pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
  raise(number);
}

void Handle(int number) {
  const int problem = errno;
  if (getpid() != owner) {
    EndNow(number);
  } else if (!ends.exchange(true)) {  // a second signal waits for the first one
    EndGroups();
    for (const DirectorySlot& slot : noted_directories) {
      if (slot.is_noted) Remove(slot.path.data());
    }
    EndNow(number);
  }
  errno = problem;
}

}  // namespace

void CleanUpAtEndSignals() {
  pid_t none = 0;
  if (!owner.compare_exchange_strong(none, getpid())) return;
  struct sigaction action = {};
  action.sa_handler = Handle;
  sigemptyset(&action.sa_mask);
  for (const int number : kEndSignals) sigaddset(&action.sa_mask, number);
  for (const int number : kEndSignals) {
    struct sigaction before = {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler == SIG_DFL) sigaction(number, &action, nullptr);
  }
}

bool CleansUp() { return owner == getpid(); }

void WaitIfEnding() {
  while (ends && CleansUp()) pause();
}

bool IsEndSignalHandler(void (*handler)(int)) { return handler == Handle; }

void NotedDirectory::Note(const std::string& path) {
  CleanUpAtEndSignals();
  if (!CleansUp() || path.size() >= kMaxPath) return;
  for (size_t i = 0; i < noted_directories.size(); ++i) {
    DirectorySlot& slot = noted_directories[i];
    bool is_free = false;
    if (!slot.is_taken.compare_exchange_strong(is_free, true)) continue;
    path.copy(slot.path.data(), path.size());
    slot.path[path.size()] = '\0';
    slot.is_noted = true;
    slot_ = static_cast<int>(i);
    return;
  }
}

NotedDirectory::~NotedDirectory() {
  if (slot_ < 0 || !CleansUp()) return;
  noted_directories[static_cast<size_t>(slot_)].is_noted = false;
  noted_directories[static_cast<size_t>(slot_)].is_taken = false;
}

void NotedGroup::Note(int leader) {
  if (!CleansUp()) return;
  for (size_t i = 0; i < noted_groups.size(); ++i) {
    pid_t none = 0;
    if (!noted_groups[i].compare_exchange_strong(none, leader)) continue;
    slot_ = static_cast<int>(i);
    return;
  }
}

void NotedGroup::Forget() {
  if (slot_ >= 0 && CleansUp()) noted_groups[static_cast<size_t>(slot_)] = 0;
  slot_ = -1;
}

}  // namespace plcxx::compile
