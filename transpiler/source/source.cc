#include "transpiler/source/source.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "transpiler/source/decode.h"
#include "transpiler/source/line_starts.h"

namespace plcxx::source {
namespace {

/// Continuation bytes do not begin a character.
size_t CountCharacters(std::string_view text) {
  return static_cast<size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// The index of the line (from 0) in which `at` stands.
size_t LineIndex(const File& file, uint32_t at) {
  const auto next = std::ranges::upper_bound(file.line_starts, at);
  return static_cast<size_t>(next - file.line_starts.begin()) - 1;
}

/// Into the middle of a character: back to its beginning.
uint32_t CharacterStart(std::string_view text, uint32_t at) {
  while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) --at;
  return at;
}

std::string_view Between(std::string_view text, size_t begin, size_t end) { return text.substr(begin, end - begin); }

}  // namespace

FileId SourceManager::AddText(std::string path, std::string text) {
  File file;
  file.path = std::move(path);
  file.text = std::move(text);
  return Add(std::move(file));
}

FileId SourceManager::Add(File file) {
  // One more than the text, so that the end of one file is not the beginning of the next.
  PLCXX_CHECK(file.text.size() < std::numeric_limits<Offset>::max() - next_base_);
  file.base = next_base_;
  file.line_starts = FindLineStarts(file.text, file.line_ends);
  next_base_ += static_cast<Offset>(file.text.size()) + 1;
  files_.push_back(std::move(file));
  return FileId(size() - 1);
}

Range SourceManager::WholeFile(FileId file) const {
  const File& source = Get(file);
  return {source.base, source.base + static_cast<Offset>(source.text.size())};
}

FileId SourceManager::FileAt(Offset offset) const {
  const auto next = std::ranges::upper_bound(files_, offset, {}, &File::base);
  if (next == files_.begin()) return FileId();
  return FileId(static_cast<uint32_t>(next - files_.begin()) - 1);
}

std::string_view SourceManager::Text(Range range) const {
  const FileId id = FileAt(range.begin);
  if (!id.valid() || range.end <= range.begin) return {};
  const File& file = Get(id);
  const size_t begin = std::min<size_t>(range.begin - file.base, file.text.size());
  const size_t end = std::min<size_t>(range.end - file.base, file.text.size());
  return Between(file.text, begin, end);
}

Position SourceManager::Locate(Offset offset) const {
  const FileId id = FileAt(offset);
  if (!id.valid()) return {};
  const File& file = Get(id);
  const uint32_t at = CharacterStart(file.text, std::min(offset - file.base, static_cast<uint32_t>(file.text.size())));
  const size_t line = LineIndex(file, at);
  const size_t before = CountCharacters(Between(file.text, file.line_starts[line], at));
  return {id, static_cast<uint32_t>(line) + 1, static_cast<uint32_t>(before) + 1};
}

std::string_view SourceManager::Line(FileId file, uint32_t line) const {
  const File& source = Get(file);
  if (line == 0 || line > source.line_starts.size()) return {};
  const size_t begin = source.line_starts[line - 1];
  const size_t end = line < source.line_starts.size() ? source.line_starts[line] : source.text.size();
  return WithoutLineEnd(Between(source.text, begin, end), source.line_ends);
}

uint32_t SourceManager::LineCount(FileId file) const {
  const File& source = Get(file);
  const bool nothing_behind_last_end = source.line_starts.back() == source.text.size();
  return static_cast<uint32_t>(source.line_starts.size()) - (nothing_behind_last_end ? 1 : 0);
}

size_t SourceManager::OriginalByte(Offset offset) const {
  const FileId id = FileAt(offset);
  if (!id.valid()) return 0;
  const File& file = Get(id);
  const size_t bom = file.had_bom ? 3 : 0;
  const uint32_t at = CharacterStart(file.text, std::min(offset - file.base, static_cast<uint32_t>(file.text.size())));
  if (file.encoding == Encoding::kUtf8) {
    // A replaced byte takes three bytes of our text and stood for one.
    const auto replaced_before = std::ranges::lower_bound(file.replaced, at) - file.replaced.begin();
    return bom + at - 2 * static_cast<size_t>(replaced_before);
  }
  const size_t line = LineIndex(file, at);
  const std::string_view before = Between(file.text, file.line_starts[line], at);
  return bom + file.line_bytes[line] +
         (file.encoding == Encoding::kGb18030 ? Gb18030Length(before) : CountCharacters(before));
}

}  // namespace plcxx::source
