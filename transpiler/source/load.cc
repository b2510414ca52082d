// What makes the bytes of a file a text: the end-of-file mark, the limits, the encoding.
#include <limits>
#include <optional>
#include <utility>

#include "transpiler/source/decode.h"
#include "transpiler/source/detect.h"
#include "transpiler/source/line_starts.h"
#include "transpiler/source/read_bytes.h"
#include "transpiler/source/source.h"
#include "transpiler/support/byte_order_mark.h"

namespace plcxx::source {
namespace {

std::string_view UpToEndMark(std::string_view bytes, const LoadOptions& options) {
  return bytes.substr(0, bytes.find_first_of(options.end_marks));
}

/// How many bytes behind the end mark are text, and not filling: those up to the last one of text.
size_t CountUnread(std::string_view bytes, const LoadOptions& options) {
  if (options.text_behind_end == TextBehindEnd::kIsNothing) return 0;
  constexpr std::string_view kFilling(" \t\r\n\f\v\0", 7);
  const size_t mark = UpToEndMark(bytes, options).size();
  const size_t last = bytes.find_last_not_of(std::string(kFilling).append(options.end_marks));
  return last == std::string_view::npos || last <= mark || mark == bytes.size() ? 0 : last - mark;
}

bool IsUtf16(std::string_view bytes) { return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"); }

std::optional<LoadError> FindNul(std::string_view bytes, LineEnds ends) {
  const size_t nul = bytes.find('\0');
  if (nul == std::string_view::npos) return std::nullopt;
  const auto line = static_cast<uint32_t>(FindLineStarts(bytes.substr(0, nul), ends).size());
  if (IsUtf16(bytes)) return LoadError{LoadProblem::kUtf16, "it is UTF-16", line};
  return LoadError{LoadProblem::kBinary, "line " + std::to_string(line) + " contains a NUL byte, it is no text", line};
}

/// `starts` are those of `bytes`.
std::optional<LoadError> FindLongLine(std::string_view bytes, const std::vector<uint32_t>& starts, size_t max_bytes) {
  for (size_t i = 0; i < starts.size(); ++i) {
    size_t end = i + 1 < starts.size() ? starts[i + 1] : bytes.size();
    if (end - starts[i] <= max_bytes) continue;
    while (end > starts[i] && (bytes[end - 1] == '\n' || bytes[end - 1] == '\r')) --end;
    if (end - starts[i] <= max_bytes) continue;
    const auto line = static_cast<uint32_t>(i) + 1;
    return LoadError{LoadProblem::kLineTooLong,
                     "line " + std::to_string(line) + " is longer than " + std::to_string(max_bytes) + " bytes", line};
  }
  return std::nullopt;
}

struct ChosenEncoding {
  Encoding encoding;
  EncodingOrigin origin;
};

ChosenEncoding ChooseEncoding(std::string_view bytes, const LoadOptions& options, bool had_bom) {
  // A BOM is the author's word, even if a byte of another encoding has crept in later.
  if (had_bom) return {Encoding::kUtf8, EncodingOrigin::kBom};
  if (options.encoding && options.choice == Choice::kAlways) return {*options.encoding, EncodingOrigin::kChosen};
  // No text in an 8-bit encoding is valid UTF-8 but by accident, so one command line serves a project whose files were
  // converted one by one.
  if (IsValidUtf8(bytes)) return {Encoding::kUtf8, EncodingOrigin::kValidUtf8};
  if (options.encoding) return {*options.encoding, EncodingOrigin::kChosen};
  if (options.detection == Detection::kFallback) return {options.fallback, EncodingOrigin::kFallback};
  return {DetectEightBit(bytes, options.fallback), EncodingOrigin::kDetected};
}

}  // namespace

std::string_view RemedyOf(LoadProblem problem) {
  switch (problem) {
    case LoadProblem::kMissing:
      return "check its name, upper and lower case too, and the folder that the name starts from";
    case LoadProblem::kDirectory:
      return "name the files in it; 'plcxx init' makes a project of a folder of files";
    case LoadProblem::kNoFile:
      return "write it into a file, and name that; for a source, '-' is standard input";
    case LoadProblem::kUnreadable:
      return "check the path and the rights";
    case LoadProblem::kTooLarge:
    case LoadProblem::kLineTooLong:
      return "no control has such a program: check that this is the file with its text";
    case LoadProblem::kBinary:
      return "name the file with the text of the program: what was compiled or packed from it is not read";
    case LoadProblem::kUtf16:
      return "save it as UTF-8, as 'iconv -f UTF-16 -t UTF-8' does";
    case LoadProblem::kCutOff:
      return "copy it again, its end is missing";
    case LoadProblem::kEmpty:
      return "copy it again from the control, or leave it out of the sources";
  }
  return {};
}

std::variant<FileId, LoadError> SourceManager::Load(const std::string& path, const LoadOptions& options) {
  const bool standard_input = path == "-";
  auto bytes = standard_input ? ReadStandardInput(options.max_bytes) : ReadBytes(path, options.max_bytes);
  if (auto* error = std::get_if<LoadError>(&bytes)) return std::move(*error);
  return AddOwnedBytes(standard_input ? "<stdin>" : path, std::get<std::string>(std::move(bytes)), options);
}

std::variant<FileId, LoadError> SourceManager::AddBytes(std::string path, std::string_view bytes,
                                                        const LoadOptions& options) {
  if (bytes.size() > options.max_bytes) return TooLarge(options.max_bytes);
  return AddOwnedBytes(std::move(path), std::string(bytes), options);
}

std::variant<FileId, LoadError> SourceManager::AddOwnedBytes(std::string path, std::string bytes,
                                                             const LoadOptions& options) {
  if (bytes.empty()) return LoadError{LoadProblem::kEmpty, "it is empty"};
  const size_t unread = CountUnread(bytes, options);
  bytes.resize(UpToEndMark(bytes, options).size());
  if (auto error = FindNul(bytes, options.line_ends)) return std::move(*error);

  File file;
  file.path = std::move(path);
  file.unread_bytes = unread;
  file.had_bom = bytes.starts_with(support::kByteOrderMark);
  support::RemoveByteOrderMark(bytes);
  std::vector<uint32_t> starts = FindLineStarts(bytes, options.line_ends);
  if (auto error = FindLongLine(bytes, starts, options.max_line_bytes)) return std::move(*error);

  const ChosenEncoding chosen = ChooseEncoding(bytes, options, file.had_bom);
  file.encoding = chosen.encoding;
  file.origin = chosen.origin;
  file.line_ends = options.line_ends;
  if (file.encoding == Encoding::kUtf8 && IsValidUtf8(bytes)) {
    file.text = std::move(bytes);
  } else {
    Decoded decoded = Decode(bytes, file.encoding);
    file.text = std::move(decoded.text);
    file.replaced = std::move(decoded.replaced);
    if (file.encoding != Encoding::kUtf8) file.line_bytes = std::move(starts);
  }
  if (file.text.size() >= std::numeric_limits<Offset>::max() - next_base_) {
    return LoadError{LoadProblem::kTooLarge, "all sources together are larger than 4 GB"};
  }
  return Add(std::move(file));
}

}  // namespace plcxx::source
