#include "transpiler/rpc/frames.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

namespace plcxx::rpc {
namespace {

constexpr std::string_view kLength = "content-length:";
constexpr size_t kMaxHeaderBytes = 4096;

char LowerCase(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// The first place at or after `from` where a header with the length begins.
size_t FindLength(std::string_view text, size_t from) {
  const auto found = std::search(text.begin() + static_cast<ptrdiff_t>(std::min(from, text.size())), text.end(),
                                 kLength.begin(), kLength.end(), [](char a, char b) { return LowerCase(a) == b; });
  return found == text.end() ? std::string_view::npos : static_cast<size_t>(found - text.begin());
}

/// The first place where a line with the length begins whose end is there, too. Such bytes are within no JSON: a text
/// has no line's end, and outside of a text no letters mean anything.
size_t FindLengthLine(std::string_view text) {
  for (size_t at = 0; (at = FindLength(text, at)) != std::string_view::npos; ++at) {
    size_t end = text.find_first_not_of(" \t", at + kLength.size());
    const size_t digits = end;
    end = text.find_first_not_of("0123456789", end);
    if (end == std::string_view::npos) return end;
    if (end > digits && (text[end] == '\n' || text.substr(end, 2) == "\r\n")) return at;
  }
  return std::string_view::npos;
}

struct Header {
  size_t end = 0;  // where the message begins
  std::optional<size_t> length;
};

/// None while the empty line after the header has not arrived. Lines may end with LF alone, as careless clients write.
std::optional<Header> ReadHeader(std::string_view text) {
  Header header;
  size_t at = 0;
  while (true) {
    const size_t end = text.find('\n', at);
    if (end == std::string_view::npos) return std::nullopt;
    std::string_view line = text.substr(at, end - at);
    if (line.ends_with('\r')) line.remove_suffix(1);
    at = end + 1;
    if (line.empty()) break;
    if (FindLength(line, 0) != 0) continue;
    line.remove_prefix(kLength.size());
    while (line.starts_with(' ') || line.starts_with('\t')) line.remove_prefix(1);
    size_t value = 0;
    const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    header.length = std::nullopt;
    if (error == std::errc() && stop == line.data() + line.size()) header.length = value;
  }
  header.end = at;
  return header;
}

}  // namespace

void FrameReader::Feed(std::string_view bytes) { bytes_.append(bytes); }

void FrameReader::Drop(size_t count) {
  at_ += count;
  constexpr size_t kKept = size_t{1} << 16;
  if (at_ < bytes_.size() && at_ < kKept) return;
  bytes_.erase(0, at_);
  at_ = 0;
}

std::optional<Frame> FrameReader::Next() {
  switch (framing_) {
    case Framing::kHeaders:
      return NextWithHeaders();
    case Framing::kLines:
      return NextLine();
  }
  return std::nullopt;
}

std::optional<Frame> FrameReader::NextLine() {
  while (true) {
    const std::string_view rest = Rest();
    const size_t end = rest.find('\n');
    if (end == std::string_view::npos) {
      if (rest.size() <= max_bytes_) return std::nullopt;
      Drop(rest.size());
      if (std::exchange(in_long_line_, true)) return std::nullopt;
      return Frame{{}, "a message is longer than " + std::to_string(max_bytes_) + " bytes"};
    }
    std::string line(rest.substr(0, end));
    Drop(end + 1);
    if (std::exchange(in_long_line_, false)) continue;  // the end of a line that was refused
    if (line.ends_with('\r')) line.pop_back();
    if (line.size() > max_bytes_) return Frame{{}, "a message is longer than " + std::to_string(max_bytes_) + " bytes"};
    if (line.find_first_not_of(" \t") != std::string::npos) return Frame{std::move(line), {}};
  }
}

void FrameReader::SkipToHeader() {
  const size_t next = FindLength(Rest(), 1);
  // The last bytes may be the beginning of a header whose rest has not arrived.
  const size_t size = Rest().size();
  Drop(next != std::string_view::npos ? next : size - std::min(size - 1, kLength.size() - 1));
}

void FrameReader::SkipMessage() {
  const std::string_view rest = Rest();
  const size_t next = FindLengthLine(rest);
  if (next < skipping_) {
    Drop(next);
    skipping_ = 0;
    return;
  }
  // The last bytes may be the beginning of a header whose rest has not arrived.
  constexpr size_t kLineBytes = 64;
  const size_t skipped =
      rest.size() < skipping_ ? rest.size() - std::min(rest.size(), kLineBytes) : std::min(rest.size(), skipping_);
  Drop(skipped);
  skipping_ -= skipped;
}

std::optional<Frame> FrameReader::NextWithHeaders() {
  if (skipping_ > 0) SkipMessage();
  if (skipping_ > 0) return std::nullopt;
  const std::string_view rest = Rest();
  if (rest.empty()) return std::nullopt;
  const std::optional<Header> header = ReadHeader(rest.substr(0, kMaxHeaderBytes));
  if (!header) {
    if (rest.size() < kMaxHeaderBytes) return std::nullopt;
    SkipToHeader();
    return Frame{{}, "a header has no end within " + std::to_string(kMaxHeaderBytes) + " bytes"};
  }
  if (!header->length) {
    SkipToHeader();
    return Frame{{}, "a message has no header Content-Length with its number of bytes"};
  }
  if (*header->length > max_bytes_) {
    skipping_ = *header->length;
    Drop(header->end);
    return Frame{{}, "a message is longer than " + std::to_string(max_bytes_) + " bytes"};
  }
  if (rest.size() - header->end < *header->length) return std::nullopt;
  Frame frame{std::string(rest.substr(header->end, *header->length)), {}};
  Drop(header->end + *header->length);
  return frame;
}

void FrameReader::Reread(std::string_view text) {
  if (framing_ == Framing::kLines) return;
  const size_t next = FindLength(text, 0);
  if (next == std::string_view::npos) return;
  bytes_.replace(0, at_, text.substr(next));
  at_ = 0;
}

std::string Framed(Framing framing, std::string_view text) {
  switch (framing) {
    case Framing::kHeaders:
      return "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + std::string(text);
    case Framing::kLines:
      return std::string(text) + "\n";
  }
  return {};
}

}  // namespace plcxx::rpc
