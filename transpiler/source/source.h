// Source files: bytes in, UTF-8 text out, with a map back to the line, the column and the byte of the file.
//
// Every loaded file gets a stretch of one global offset space, so that a place in any file is one number
// and a range is two. Nothing here knows a dialect.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/support/ids.h"

namespace plcxx::source {

using FileId = support::Id<struct FileTag>;
using Offset = uint32_t;  // a byte of the UTF-8 text of some file, in the global space

/// Half open [begin, end) in the global offset space; begin == end marks a point. {0, 0} is "no place".
struct Range {
  Offset begin = 0;
  Offset end = 0;
  bool operator==(const Range&) const = default;
};

enum class Encoding : uint8_t {
  kUtf8,
  kCp866,
  kCp1251,
  kKoi8R,
  kMazovia,    // Polish letters over code page 437
  kKamenicky,  // KEYBCS2, Czech and Slovak letters over code page 437
  kCp852,
  kCp1250,
  kGb18030,  // of one, two or four bytes a character; GBK and code page 936 are parts of it
};

/// The encoding's name as on the command line ("utf-8", "cp866", "gb18030", ...).
std::string_view Name(Encoding encoding);
/// Case-insensitive; also the usual other names (ibm866, windows-1251, utf8, gbk). Empty when unknown.
std::optional<Encoding> EncodingByName(std::string_view name);
/// The names of all encodings, for messages.
std::vector<std::string_view> EncodingNames();

/// What ends a line; the longest that fits, read from the left.
enum class LineEnds : uint8_t {
  kLfCrLfOrCr,    // LF, CR LF, CR
  kEveryCrAndLf,  // LF, CR LF, LF CR, CR
  kLfOrCrLf,      // LF, CR LF; a lone CR is a character of the line
};

/// How the encoding of a text without BOM that is not valid UTF-8 is found where nobody chose one.
enum class Detection : uint8_t {
  kByLetters,  // the Russian encoding in which it reads best, else the fallback
  kFallback,   // always the fallback
};

/// When a chosen encoding is taken.
enum class Choice : uint8_t {
  kUnlessUtf8,  // only for what is not valid UTF-8
  kAlways,      // for every text without BOM
};

/// Who reports bytes that the encoding does not define.
enum class Undecodable : uint8_t {
  kOneWarningPerFile,  // plcxx-6, by the driver
  kByTheDialect,       // at each place (File::replaced), by the dialect's own code
};

/// Text that follows the end mark, which is not read: not blanks, line ends, zeros or further marks, with which DOS
/// fills a file up.
enum class TextBehindEnd : uint8_t {
  kIsReported,  // plcxx-26, by the driver
  kIsNothing,   // the control's rule: what follows the mark is ignored without a message
};

inline constexpr Encoding kRussianEncodings[] = {Encoding::kUtf8, Encoding::kCp866, Encoding::kCp1251,
                                                 Encoding::kKoi8R};

struct LoadOptions {
  std::optional<Encoding> encoding;                         // what the user chose; none: found as `detection` says
  std::span<const Encoding> encodings = kRussianEncodings;  // what the user may choose
  Choice choice = Choice::kUnlessUtf8;
  Detection detection = Detection::kByLetters;
  Encoding fallback = Encoding::kCp866;
  Undecodable undecodable = Undecodable::kOneWarningPerFile;
  LineEnds line_ends = LineEnds::kLfCrLfOrCr;
  std::string_view end_marks = "\x1A";  // the first of these bytes and what follows is not part of the text (DOS: 1AH)
  TextBehindEnd text_behind_end = TextBehindEnd::kIsReported;
  size_t max_bytes = 64u << 20;       // a larger file is refused before it is read
  size_t max_line_bytes = 64u << 10;  // a longer line is refused
};

enum class LoadProblem : uint8_t {
  kMissing,
  kDirectory,
  kNoFile,
  kUnreadable,
  kTooLarge,
  kLineTooLong,
  kBinary,
  kUtf16,
  kCutOff,
  kEmpty
};

/// What the user can do about it; as the remedy of a message.
std::string_view RemedyOf(LoadProblem problem);

struct LoadError {
  LoadProblem problem;
  std::string detail;  // the operating system's words, a size, ...: lower case, no full stop
  uint32_t line = 0;   // for kLineTooLong, kBinary and kUtf16
};

/// A place for a person: 1-based line, 1-based column in characters of the file (not bytes of our UTF-8).
struct Position {
  FileId file;
  uint32_t line = 0;
  uint32_t column = 0;
};

/// Why a file is read in its encoding.
enum class EncodingOrigin : uint8_t { kBom, kChosen, kValidUtf8, kDetected, kFallback };

struct File {
  std::string path;  // as the user wrote it; "<stdin>" for "-"
  std::string text;  // UTF-8, line ends as in the file, BOM and everything from the end mark on removed
  Encoding encoding = Encoding::kUtf8;
  EncodingOrigin origin = EncodingOrigin::kValidUtf8;
  bool had_bom = false;
  LineEnds line_ends = LineEnds::kLfCrLfOrCr;
  Offset base = 0;                    // global offset of text[0]
  std::vector<uint32_t> line_starts;  // offsets into text
  std::vector<uint32_t> line_bytes;   // not UTF-8: the byte of the file at which each line starts; else empty
  std::vector<uint32_t> replaced;     // offsets into text of the U+FFFD that stand for an undefined byte each
  size_t unread_bytes = 0;            // what follows the end mark and is to be reported, to its last byte of text
};

class SourceManager {
 public:
  /// Reads `path` ("-": standard input). A file is read once: the same path again gives another FileId only when asked
  /// again.
  std::variant<FileId, LoadError> Load(const std::string& path, const LoadOptions& options);
  /// Text that is already UTF-8 (tests, generated text), taken as it is: no limits, BOM and end marks stay.
  FileId AddText(std::string path, std::string text);
  /// As Load, from bytes in memory (fuzzing, standard input).
  std::variant<FileId, LoadError> AddBytes(std::string path, std::string_view bytes, const LoadOptions& options);

  const File& Get(FileId file) const { return files_[file.index]; }
  uint32_t size() const { return static_cast<uint32_t>(files_.size()); }
  Range WholeFile(FileId file) const;
  /// The text of a range that lies in one file.
  std::string_view Text(Range range) const;
  /// The file that holds `offset`; an offset one past the end of a file still belongs to it. None for offset 0.
  FileId FileAt(Offset offset) const;
  /// For offset 0 ("no place"): no file, line 0, column 0. A tab counts as one column.
  Position Locate(Offset offset) const;
  /// The text of a 1-based line without its line end; empty for a line that does not exist.
  std::string_view Line(FileId file, uint32_t line) const;
  /// Lines as a person counts them: what follows the last line end is a line only if there is something.
  uint32_t LineCount(FileId file) const;
  /// The byte of the original file (in its own encoding, BOM counted) at which `offset` stands.
  size_t OriginalByte(Offset offset) const;

 private:
  std::variant<FileId, LoadError> AddOwnedBytes(std::string path, std::string bytes, const LoadOptions& options);
  FileId Add(File file);
  std::deque<File> files_;  // stable addresses: tokens hold views into the text
  Offset next_base_ = 1;    // 0 stays "no place"
};

}  // namespace plcxx::source
