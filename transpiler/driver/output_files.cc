#include "transpiler/driver/output_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "transpiler/compile/end_signals.h"
#include "transpiler/driver/own_files.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/support/file_names.h"
#include "transpiler/support/system_words.h"

namespace plcxx::driver {
namespace {

namespace fs = std::filesystem;

/// Of one run: whose files have been written.
struct Written {
  std::string program;                    // that is being written; empty: there is only one
  std::map<std::string, std::string> of;  // by whole paths: the program
};
Written& Outputs() {
  static Written written;
  return written;
}

std::string WholePath(const std::string& path) {
  std::error_code error;
  return fs::weakly_canonical(path, error).string();
}

std::string RemedyOf(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "make room there, or write to another disk";
    case EROFS:
      return "write to another place: that disk can only be read";
    case EACCES:
    case EPERM:
      return "write where you may, or have the rights of the folder changed";
    case ENOENT:
      return "check its name, and make the folder that it is to lie in";
    case ENOTDIR:
      return "a file is where the path needs a folder: check the path";
    case ENAMETOOLONG:
      return "choose a shorter name";
    case EINTR:
      return "run it again";
    default:
      return "check the path and the rights";
  }
}

WriteFailure Failed(const std::string& path, int error) { return {path, support::SystemWords(error), RemedyOf(error)}; }
WriteFailure IsADirectory(const std::string& path) {
  return {path, "it is a directory", "choose another name for the file, or move the directory away"};
}

bool HasBytes(const std::string& path, std::string_view bytes) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return false;
  std::string piece(64u << 10, '\0');
  while (!bytes.empty()) {
    const size_t wanted = std::min(piece.size(), bytes.size());
    file.read(piece.data(), static_cast<std::streamsize>(wanted));
    if (static_cast<size_t>(file.gcount()) != wanted ||
        bytes.substr(0, wanted) != std::string_view(piece).substr(0, wanted)) {
      return false;
    }
    bytes.remove_prefix(wanted);
  }
  return file.peek() == std::ifstream::traits_type::eof();
}

volatile std::sig_atomic_t ended_by = 0;

/// Who ends the process while it writes gets it undone first: a signal that would end it is kept until then.
class DelayedSignals {
 public:
  DelayedSignals() {
    struct sigaction keep = {};
    keep.sa_handler = [](int signal) { ended_by = signal; };
    for (size_t i = 0; i < kSignals.size(); ++i) {
      sigaction(kSignals[i], nullptr, &before_[i]);
      const auto before = before_[i].sa_handler;
      if (before == SIG_DFL || compile::IsEndSignalHandler(before)) sigaction(kSignals[i], &keep, nullptr);
    }
  }
  DelayedSignals(const DelayedSignals&) = delete;
  DelayedSignals& operator=(const DelayedSignals&) = delete;
  ~DelayedSignals() {
    for (size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
    if (ended_by != 0) kill(getpid(), ended_by);
  }

 private:
  static constexpr std::array kSignals = {SIGTERM, SIGINT, SIGHUP, SIGXCPU};
  std::array<struct sigaction, kSignals.size()> before_;
};

/// The work of one call; what it has begun is undone unless it ends well.
class Transaction {
 public:
  explicit Transaction(const OutputRequest& request) : request_(request) {}
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  std::optional<WriteFailure> Run();
  /// All of Run that can be undone.
  std::optional<WriteFailure> Prepare();

 private:
  struct Replacement {
    std::string path, temporary, backup;
    bool existed = false;
    bool has_backup = false;
    bool renamed = false;
  };

  std::optional<WriteFailure> MakeDirectory();
  std::optional<WriteFailure> FindSameName() const;
  std::optional<WriteFailure> CheckTarget(const emit::OutputFile& file) const;
  std::optional<WriteFailure> WriteTemporary(const emit::OutputFile& file);
  std::optional<WriteFailure> WriteThrough(const emit::OutputFile& file) const;
  std::optional<WriteFailure> Replace(Replacement& replacement);

  const OutputRequest& request_;
  std::vector<Replacement> replacements_;
  std::vector<std::string> new_directories_;  // outermost first
  bool done_ = false;
};

Transaction::~Transaction() {
  for (const Replacement& replacement : replacements_) {
    if (!replacement.renamed) unlink(replacement.temporary.c_str());
    if (!done_ && replacement.renamed) {
      if (replacement.has_backup) {
        if (rename(replacement.backup.c_str(), replacement.path.c_str()) == 0) continue;
      } else if (!replacement.existed) {
        unlink(replacement.path.c_str());
      }
    }
    if (replacement.has_backup) unlink(replacement.backup.c_str());
  }
  if (done_) return;
  for (size_t i = new_directories_.size(); i-- > 0;) rmdir(new_directories_[i].c_str());
}

std::optional<WriteFailure> Transaction::MakeDirectory() {
  if (request_.directory.empty()) return std::nullopt;
  fs::path missing = fs::path(request_.directory).lexically_normal();
  std::error_code error;
  std::vector<std::string> to_make;
  while (!missing.empty() && !fs::exists(missing, error)) {
    if (missing.has_filename()) to_make.push_back(missing.string());
    if (missing == missing.parent_path()) break;
    missing = missing.parent_path();
  }
  for (size_t i = to_make.size(); i-- > 0;) {
    if (mkdir(to_make[i].c_str(), 0777) != 0) {
      if (errno == EEXIST) continue;  // another process was faster
      return Failed(request_.directory, errno);
    }
    new_directories_.push_back(to_make[i]);
  }
  if (!fs::is_directory(request_.directory, error))
    return WriteFailure{request_.directory, "it is not a directory", "name a directory, or one that is to be made"};
  return std::nullopt;
}

std::optional<WriteFailure> Transaction::CheckTarget(const emit::OutputFile& file) const {
  const std::string& path = file.name;
  std::error_code error;
  if (fs::is_directory(path, error)) return IsADirectory(path);
  for (const std::string& read : request_.protected_paths) {
    if (fs::equivalent(path, read, error))
      return WriteFailure{path, "it is a source of this program", "write to another folder, or under another name"};
  }
  if (std::ranges::find(request_.named, path) == request_.named.end() && IsForeign(path, file.text) &&
      !HasBytes(path, file.text)) {
    return WriteFailure{path, "it is there already, and plcxx did not write it",
                        "move it away, or write to another folder or under another name"};
  }
  const auto before = Outputs().of.find(WholePath(path));
  if (before != Outputs().of.end() && before->second != Outputs().program && !HasBytes(path, file.text)) {
    return WriteFailure{path, "it has just been written for program '" + before->second + "'",
                        "let each program have a folder or a name of its own, or choose one with --program"};
  }
  return std::nullopt;
}

/// To an open file, or the reason why it is not open in `errno`.
std::optional<WriteFailure> WriteAndClose(int descriptor, const emit::OutputFile& file) {
  if (descriptor < 0) return Failed(file.name, errno);
  std::string_view rest = file.text;
  int problem = 0;
  while (!rest.empty() && problem == 0) {
    const ssize_t written = write(descriptor, rest.data(), rest.size());
    if (ended_by != 0) {
      problem = EINTR;
    } else if (written >= 0) {
      rest.remove_prefix(static_cast<size_t>(written));
    } else if (errno != EINTR) {
      problem = errno;
    }
  }
  if (close(descriptor) != 0 && problem == 0) problem = errno;
  if (problem != 0) return Failed(file.name, problem);
  return std::nullopt;
}

/// A device or a pipe: to be written to, never to be replaced by a file (`-o /dev/stdout`).
bool IsSpecial(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// A file that two results are to get.
std::optional<WriteFailure> NamedTwice(std::span<const std::string> paths) {
  std::set<std::string> seen;
  for (const std::string& path : paths) {
    if (path.empty() || IsSpecial(path) || seen.insert(WholePath(path)).second) continue;
    return WriteFailure{path, "it is named for two results", "give each of them a name of its own"};
  }
  return std::nullopt;
}

/// What a link leads to: the link stays one.
std::string Resolved(const std::string& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target.string();
}

/// What a process left that was killed while it wrote this file: hidden files whose process is no longer there. A file
/// server may show files of other machines' processes, so that young ones are left alone.
void RemoveLeftovers(const fs::path& place) {
  constexpr auto kYoung = std::chrono::minutes(1);
  const std::string begin = "." + place.filename().string() + ".";
  std::error_code error;
  const fs::path directory = place.has_parent_path() ? place.parent_path() : fs::path(".");
  for (fs::directory_iterator entry(directory, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(begin) || !(name.ends_with(".new") || name.ends_with(".old"))) continue;
    const std::string_view number = std::string_view(name).substr(begin.size(), name.size() - begin.size() - 4);
    pid_t process = 0;
    const auto [last, problem] = std::from_chars(number.data(), number.data() + number.size(), process);
    if (problem != std::errc() || last != number.data() + number.size() || process <= 0) continue;
    if (kill(process, 0) == 0 || errno != ESRCH) continue;
    std::error_code gone;
    const auto written = fs::last_write_time(entry->path(), gone);
    if (!gone && fs::file_time_type::clock::now() - written > kYoung) fs::remove(entry->path(), gone);
  }
}

std::optional<WriteFailure> Transaction::WriteTemporary(const emit::OutputFile& file) {
  Replacement replacement;
  replacement.path = Resolved(file.name);
  const fs::path place(replacement.path);
  const std::string hidden = "." + place.filename().string() + "." + std::to_string(getpid());
  replacement.temporary = (place.parent_path() / (hidden + ".new")).string();
  replacement.backup = (place.parent_path() / (hidden + ".old")).string();
  replacements_.push_back(replacement);
  RemoveLeftovers(place);

  const int descriptor = open(replacement.temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  return WriteAndClose(descriptor, file);
}

std::optional<WriteFailure> Transaction::WriteThrough(const emit::OutputFile& file) const {
  return WriteAndClose(open(file.name.c_str(), O_WRONLY | O_CLOEXEC), file);
}
std::optional<WriteFailure> Transaction::Replace(Replacement& replacement) {
  replacement.existed = access(replacement.path.c_str(), F_OK) == 0;
  unlink(replacement.backup.c_str());  // left by a process that was killed
  replacement.has_backup = replacement.existed && link(replacement.path.c_str(), replacement.backup.c_str()) == 0;
  if (rename(replacement.temporary.c_str(), replacement.path.c_str()) != 0) {
    return Failed(replacement.path, errno);
  }
  replacement.renamed = true;
  return std::nullopt;
}

/// Both would be written beside the one place, and one of them would be lost.
std::optional<WriteFailure> Transaction::FindSameName() const {
  std::vector<std::string> names;
  for (const emit::OutputFile& file : request_.files) names.push_back(file.name);
  return NamedTwice(names);
}

std::optional<WriteFailure> Transaction::Prepare() {
  if (auto failure = FindSameName()) return failure;
  if (auto failure = MakeDirectory()) return failure;
  for (const emit::OutputFile& file : request_.files) {
    if (auto failure = CheckTarget(file)) return failure;
  }
  for (const emit::OutputFile& file : request_.files) {
    if (IsSpecial(file.name) || HasBytes(file.name, file.text)) continue;
    if (auto failure = WriteTemporary(file)) return failure;
  }
  return std::nullopt;
}

std::optional<WriteFailure> Transaction::Run() {
  if (auto failure = Prepare()) return failure;
  // Nothing takes this back; all that can fail before it has been done.
  for (const emit::OutputFile& file : request_.files) {
    if (!IsSpecial(file.name)) continue;
    if (auto failure = WriteThrough(file)) return failure;
  }
  for (Replacement& replacement : replacements_) {
    if (auto failure = Replace(replacement)) return failure;
    if (ended_by != 0) return Failed(replacement.path, EINTR);
  }
  done_ = true;
  if (!Outputs().program.empty()) {
    for (const emit::OutputFile& file : request_.files) {
      if (!IsSpecial(file.name)) Outputs().of.emplace(WholePath(file.name), Outputs().program);
    }
  }
  return std::nullopt;
}

}  // namespace

OutputsOfProgram::OutputsOfProgram(std::string name) { Outputs().program = std::move(name); }
OutputsOfProgram::~OutputsOfProgram() { Outputs().program.clear(); }

int CannotWrite(const WriteFailure& failure) {
  return UsageError("cannot write '" + failure.path + "': " + failure.reason + "; " + failure.remedy);
}

bool IsFileName(std::string_view name) { return support::IsFileName(name); }

std::string PathIn(const std::string& directory, const std::string& name) {
  return directory.empty() ? name : (fs::path(directory) / name).string();
}

std::optional<WriteFailure> WriteAll(const OutputRequest& request) {
  const DelayedSignals delayed;  // ends after the transaction: what was begun is undone by then
  return Transaction(request).Run();
}

std::optional<WriteFailure> CannotWriteAll(const OutputRequest& request) {
  const DelayedSignals delayed;
  return Transaction(request).Prepare();
}

std::optional<WriteFailure> WriteWithFolders(const OutputRequest& request) {
  for (const emit::OutputFile& file : request.files) {
    const fs::path directory = fs::path(file.name).parent_path();
    std::error_code error;  // what is wrong is told when the file is written
    if (!directory.empty()) fs::create_directories(directory, error);
  }
  return WriteAll(request);
}

std::optional<WriteFailure> CannotBeWritten(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return IsADirectory(path);
  if (IsSpecial(path)) {
    if (fs::is_socket(path, error)) return Failed(path, ENXIO);
    return access(path.c_str(), W_OK) == 0 ? std::nullopt : std::optional(Failed(path, errno));
  }
  fs::path above = fs::path(Resolved(path)).parent_path();
  while (!above.empty() && !fs::exists(above, error)) {
    if (error == std::errc::not_a_directory) return Failed(path, ENOTDIR);
    above = above.parent_path();
  }
  const std::string folder = above.empty() ? "." : above.string();
  if (!fs::is_directory(folder, error)) return Failed(path, ENOTDIR);
  return access(folder.c_str(), W_OK) == 0 ? std::nullopt : std::optional(Failed(path, errno));
}

bool CanBeWritten(std::initializer_list<std::string> paths) {
  for (const std::string& path : paths) {
    if (path.empty()) continue;
    if (path == "-" || path.starts_with("-/")) {
      PrintUsageError("'-': standard output shows the results; name a file (./- is one called '-')");
      return false;
    }
    if (const auto failure = CannotBeWritten(path)) return CannotWrite(*failure), false;
  }
  if (const auto failure = NamedTwice(std::span(paths.begin(), paths.size()))) return CannotWrite(*failure), false;
  return true;
}

}  // namespace plcxx::driver
