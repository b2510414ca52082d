// Retentive memory in two files, of which a loss of power at any moment leaves one whole.
//
// FOLDER/NAME.a and FOLDER/NAME.b hold: mark, sequence number, size, checksum (each four bytes, least significant
// first), then the content. The older one is replaced: a new file is written, brought to the disk (fsync), given the
// name (rename), and the folder is brought to the disk. The newer of the whole files counts.
// Not its job: which layout of the content a program accepts (retentive.h); to be called by a real-time thread.
#pragma once

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <plcxx/retentive_store.h>

namespace plcxx::host {

enum class Loaded : uint8_t {
  kNothing,  // there is no file yet
  kContent,
  kDamaged,     // there are files, and none of them is whole
  kOtherSize,   // a whole file of another program, or of another version of this one
  kUnreadable,  // errno says why
};

class RetentiveFiles {
 public:
  /// False, errno set: the name is too long, or the folder cannot be written.
  bool Open(const char* folder, const char* name) noexcept {
    const int length = snprintf(stem_, sizeof stem_, "%s/%s", folder, name);
    const int folder_length = snprintf(folder_, sizeof folder_, "%s", folder);
    if (length < 0 || folder_length < 0 || static_cast<size_t>(length) + 8 > sizeof stem_) {
      errno = ENAMETOOLONG;
      return false;
    }
    struct stat found{};
    if (stat(folder, &found) == 0 && !S_ISDIR(found.st_mode)) {
      errno = ENOTDIR;
      return false;
    }
    return access(folder, R_OK | W_OK | X_OK) == 0;
  }

  /// The content stored last, into `bytes`, which is untouched unless the answer is kContent.
  Loaded Load(void* bytes, uint32_t size) noexcept {
    Loaded worst = Loaded::kNothing;
    const Slot first = Examine('a', size, worst), second = Examine('b', size, worst);
    if (!first.whole && !second.whole) return worst;
    const bool second_counts =
        second.whole && (!first.whole || static_cast<int32_t>(second.sequence - first.sequence) > 0);
    newest_ = second_counts ? 'b' : 'a';
    sequence_ = second_counts ? second.sequence : first.sequence;
    return Read(newest_, static_cast<uint8_t*>(bytes), size, sequence_) == Loaded::kContent ? Loaded::kContent
                                                                                            : Loaded::kUnreadable;
  }

  /// False: errno says why, and what was stored before is still there.
  bool Store(const void* bytes, uint32_t size) noexcept {
    const char slot = newest_ == 'a' ? 'b' : 'a';
    char path[kPathBytes + 8], fresh[kPathBytes + 8];
    snprintf(path, sizeof path, "%s.%c", stem_, slot);
    snprintf(fresh, sizeof fresh, "%s.new", stem_);
    uint8_t header[kHeaderBytes] = {};
    Put(header, kMark);
    Put(header + 4, sequence_ + 1);
    Put(header + 8, size);
    Put(header + 12, Checksum(header, static_cast<const uint8_t*>(bytes), size));
    const int file = open(fresh, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0) return false;
    const bool written = WriteAll(file, header, sizeof header) &&
                         WriteAll(file, static_cast<const uint8_t*>(bytes), size) && fsync(file) == 0;
    const int error = errno;
    const bool closed = close(file) == 0;
    if (!written || !closed) {
      if (!written) errno = error;
      return false;
    }
    if (rename(fresh, path) != 0) return false;
    const int folder = open(folder_, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return false;
    const bool kept = fsync(folder) == 0;
    close(folder);
    if (!kept) return false;
    newest_ = slot;
    ++sequence_;
    return true;
  }

 private:
  static constexpr uint32_t kHeaderBytes = 16, kMark = 0x600DF11E;
  static constexpr size_t kPathBytes = 1024;

  struct Slot {
    bool whole = false;
    uint32_t sequence = 0;
  };

  static void Put(uint8_t* bytes, uint32_t value) noexcept { retentive_internal::PutWord(bytes, value); }
  static uint32_t Get(const uint8_t* bytes) noexcept { return retentive_internal::GetWord(bytes); }
  static uint32_t Checksum(const uint8_t* header, const uint8_t* content, uint32_t size) noexcept {
    return Crc32(Crc32(0, header + 4, 8), content, size);
  }

  static bool WriteAll(int file, const uint8_t* bytes, uint32_t size) noexcept {
    for (uint32_t done = 0; done < size;) {
      const ssize_t count = write(file, bytes + done, size - done);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return false;
      done += static_cast<uint32_t>(count);
    }
    return true;
  }
  /// The bytes that were there, `size` at most.
  static uint32_t ReadUpTo(int file, uint8_t* bytes, uint32_t size) noexcept {
    uint32_t done = 0;
    while (done < size) {
      const ssize_t count = read(file, bytes + done, size - done);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) break;
      done += static_cast<uint32_t>(count);
    }
    return done;
  }

  Slot Examine(char slot, uint32_t size, Loaded& worst) noexcept {
    uint32_t sequence = 0;
    const Loaded found = Read(slot, nullptr, size, sequence);
    if (found != Loaded::kContent && found != Loaded::kNothing) worst = found;
    return {found == Loaded::kContent, sequence};
  }

  /// Checks one file; with `bytes`, which a checksum has been made of before, its content goes there.
  Loaded Read(char slot, uint8_t* bytes, uint32_t size, uint32_t& sequence) noexcept {
    char path[kPathBytes + 8];
    snprintf(path, sizeof path, "%s.%c", stem_, slot);
    const int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) return errno == ENOENT ? Loaded::kNothing : Loaded::kUnreadable;
    uint8_t header[kHeaderBytes] = {};
    Loaded found = Loaded::kDamaged;
    if (ReadUpTo(file, header, kHeaderBytes) == kHeaderBytes && Get(header) == kMark) {
      const uint32_t stored = Get(header + 8);
      uint32_t crc = Crc32(0, header + 4, 8), left = stored;
      while (left > 0) {
        uint8_t chunk[256];
        const uint32_t part = left < sizeof chunk ? left : static_cast<uint32_t>(sizeof chunk);
        if (ReadUpTo(file, chunk, part) != part) break;
        crc = Crc32(crc, chunk, part);
        if (bytes != nullptr && stored == size) memcpy(bytes + (stored - left), chunk, part);
        left -= part;
      }
      if (left == 0 && crc == Get(header + 12)) found = stored == size ? Loaded::kContent : Loaded::kOtherSize;
      sequence = Get(header + 4);
    }
    close(file);
    return found;
  }

  char stem_[kPathBytes] = {};
  char folder_[kPathBytes] = {};
  char newest_ = 0;
  uint32_t sequence_ = 0;
};

}  // namespace plcxx::host
