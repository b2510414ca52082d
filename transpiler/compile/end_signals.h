// What a signal that ends the process would leave behind: temporary directories, and programs that it has started.
// They are noted here while they exist; a signal handler removes them, and then the process ends as the signal says.
// SIGKILL cannot be caught: what it leaves is in the temporary directory alone.
#pragma once

#include <string>

namespace plcxx::compile {

/// From now on, of this process. A process that is forked of it has none of what is noted: it belongs to the one that
/// has forked it, and so do the programs that the fork starts.
void CleanUpAtEndSignals();

/// Is it this process that cleans up? False in what it has forked.
bool CleansUp();

/// Returns unless the process is ending: who finds that a child is gone concludes nothing from it then.
void WaitIfEnding();

/// Is it the handler of such signals? Who replaces a signal's default action for a while has to replace it, too.
bool IsEndSignalHandler(void (*handler)(int));

/// A directory with all in it.
class NotedDirectory {
 public:
  NotedDirectory() = default;
  ~NotedDirectory();
  NotedDirectory(const NotedDirectory&) = delete;
  NotedDirectory& operator=(const NotedDirectory&) = delete;
  void Note(const std::string& path);

 private:
  int slot_ = -1;
};

/// A process group: a child that leads it, and what that one has started.
class NotedGroup {
 public:
  NotedGroup() = default;
  explicit NotedGroup(int leader) { Note(leader); }
  ~NotedGroup() { Forget(); }
  NotedGroup(const NotedGroup&) = delete;
  NotedGroup& operator=(const NotedGroup&) = delete;
  void Note(int leader);
  /// Before the leader is waited for: its number may be another process's then.
  void Forget();

 private:
  int slot_ = -1;
};

}  // namespace plcxx::compile
