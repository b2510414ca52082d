// A child process with pipes, and a private temporary directory: what running compiled code needs of the system.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/compile/end_signals.h"

namespace plcxx::compile {

/// Where temporary directories are made, and what to do when they cannot be.
std::string TemporaryPlace();
inline constexpr std::string_view kTemporaryRemedy = "let TMPDIR name a folder with room and rights";

/// A directory that disappears with the object, and when a signal ends the process.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  const std::string& path() const { return path_; }
  bool valid() const { return !path_.empty(); }
  bool Write(const std::string& name, std::string_view text) const;
  /// Where there is none, or something could not be written into it: place, cause and remedy; the cause alone.
  std::string WhyNot() const;
  std::string Cause() const;

 private:
  std::string path_;
  int problem_ = 0;  // why there is none
  NotedDirectory noted_;
};

struct ProcessResult {
  int exit_code = -1;  // -1: it could not be started or was killed
  std::string output;  // standard output and error together
};

/// Runs a program to its end in `directory` (empty: the current one). It is killed after `seconds`, and when a signal
/// ends this process, together with all that it started; its temporary files go with it.
ProcessResult RunProcess(const std::vector<std::string>& arguments, int seconds, const std::string& directory = {});
/// The same; it is killed when `stops` says so, too, which is asked several times a second.
ProcessResult RunProcessGroup(const std::vector<std::string>& arguments, int seconds, const std::string& directory,
                              const std::function<bool()>& stops);

/// A running program whose standard input and output are ours.
class ChildProcess {
 public:
  ChildProcess() = default;
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// A program, found as the shell finds it, and its arguments.
  bool Start(const std::vector<std::string>& arguments);
  /// False when the child is gone or does not answer within ten seconds. What the child writes while it is sent to is
  /// kept for Receive, so that neither waits for the other.
  bool Send(std::string_view bytes);
  bool Receive(void* bytes, size_t size);

 private:
  /// What the child has written by now, behind what is kept.
  bool Fetch();

  int pid_ = -1;
  NotedGroup noted_;
  int to_child_ = -1;
  int from_child_ = -1;
  std::string fetched_;
  size_t taken_ = 0;  // of fetched_
};

}  // namespace plcxx::compile
