#include "transpiler/source/read_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

#include "transpiler/source/near_file.h"
#include "transpiler/source/unsaved.h"
#include "transpiler/support/read_file.h"
#include "transpiler/support/system_words.h"

namespace plcxx::source {
namespace {

constexpr size_t kPiece = 64u << 10;

LoadError FromErrno(int error) {
  if (error == ENOENT || error == ENOTDIR) return {LoadProblem::kMissing, "no such file"};
  return {LoadProblem::kUnreadable, support::SystemWords(error)};
}

std::string KindOf(mode_t mode) {
  if (S_ISFIFO(mode)) return "a pipe";
  return S_ISSOCK(mode) ? "a socket" : "a device";
}

/// Reads to the end; one byte above the limit is enough to know that it is exceeded.
template <class ReadPiece>
std::variant<std::string, LoadError> ReadBounded(size_t expected, size_t max_bytes, ReadPiece read_piece) {
  std::string bytes;
  size_t size = 0;
  bytes.resize(std::min(expected, max_bytes) + 1);
  while (true) {
    if (size == bytes.size()) bytes.resize(std::min(max_bytes + 1, size + std::max(size, kPiece)));
    const ssize_t got = read_piece(bytes.data() + size, bytes.size() - size);
    if (got < 0) return FromErrno(errno);
    if (got == 0) break;
    size += static_cast<size_t>(got);
    if (size > max_bytes) return TooLarge(max_bytes);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

LoadError TooLarge(size_t max_bytes) {
  return {LoadProblem::kTooLarge, "it is larger than " + std::to_string(max_bytes) + " bytes"};
}

std::variant<std::string, LoadError> ReadBytes(const std::string& path, size_t max_bytes) {
  if (const std::string* unsaved = UnsavedBytesOf(path)) {
    if (unsaved->size() > max_bytes) return TooLarge(max_bytes);
    return *unsaved;
  }
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) {
    LoadError error = FromErrno(errno);
    if (error.problem == LoadProblem::kMissing) error.detail += DidYouMeanFile(path);
    return error;
  }
  if (S_ISDIR(status.st_mode)) return LoadError{LoadProblem::kDirectory, "it is a directory"};
  // To open a pipe may last for ever, and a device may have no end.
  const bool is_opened_pipe = S_ISFIFO(status.st_mode) && support::IsOpened(path);
  if (!S_ISREG(status.st_mode) && !is_opened_pipe)
    return LoadError{LoadProblem::kNoFile, "it is no file, but " + KindOf(status.st_mode)};
  const size_t size = status.st_size > 0 ? static_cast<size_t>(status.st_size) : 0;
  if (size > max_bytes) return TooLarge(max_bytes);

  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return FromErrno(errno);
  auto bytes = ReadBounded(size, max_bytes, [&](char* to, size_t room) {
    ssize_t got = -1;
    do {
      got = read(descriptor, to, room);
    } while (got < 0 && errno == EINTR);
    return got;
  });
  close(descriptor);
  return bytes;
}

std::variant<std::string, LoadError> ReadStandardInput(size_t max_bytes) {
  // The stream, not the descriptor: somebody may have looked at the beginning of it already.
  return ReadBounded(kPiece, max_bytes, [](char* to, size_t room) -> ssize_t {
    const size_t got = std::fread(to, 1, room, stdin);
    if (got == 0 && std::ferror(stdin) != 0) return -1;
    return static_cast<ssize_t>(got);
  });
}

}  // namespace plcxx::source
