#include "transpiler/lsp/positions.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "transpiler/support/hex.h"

namespace plcxx::lsp {
namespace {

/// Bytes of the character that begins with `lead`; 1 for what is no beginning.
size_t BytesOf(char lead) {
  const auto byte = static_cast<unsigned char>(lead);
  if (byte >= 0xF0) return 4;
  if (byte >= 0xE0) return 3;
  return byte >= 0xC0 ? 2 : 1;
}

int64_t UnitsOf(size_t bytes, Units units) {
  switch (units) {
    case Units::kUtf8:
      return static_cast<int64_t>(bytes);
    case Units::kUtf16:
      return bytes == 4 ? 2 : 1;
    case Units::kUtf32:
      return 1;
  }
  return 1;
}

bool IsPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("/-_.~").find(c) != std::string_view::npos;
}

}  // namespace

std::string_view Name(Units units) {
  switch (units) {
    case Units::kUtf8:
      return "utf-8";
    case Units::kUtf16:
      return "utf-16";
    case Units::kUtf32:
      return "utf-32";
  }
  return {};
}

Lines::Lines(std::string_view text, Units units) : text_(text), units_(units), starts_{0} {
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    if (text[i] == '\n' || text[i] == '\r') starts_.push_back(static_cast<uint32_t>(i) + 1);
  }
}

Position Lines::At(size_t offset) const {
  offset = std::min(offset, text_.size());
  const auto next = std::ranges::upper_bound(starts_, static_cast<uint32_t>(offset));
  const auto line = static_cast<size_t>(next - starts_.begin()) - 1;
  Position position{static_cast<int64_t>(line), 0};
  for (size_t at = starts_[line]; at < offset;) {
    const size_t bytes = BytesOf(text_[at]);
    if (at + bytes > offset) break;  // within a character: its beginning
    position.character += UnitsOf(bytes, units_);
    at += bytes;
  }
  return position;
}

size_t Lines::Offset(Position position) const {
  if (position.line < 0) return 0;
  if (position.line >= static_cast<int64_t>(starts_.size())) return text_.size();
  const auto line = static_cast<size_t>(position.line);
  size_t at = starts_[line];
  size_t end = line + 1 < starts_.size() ? starts_[line + 1] : text_.size();
  if (line + 1 < starts_.size()) {
    while (end > at && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
  }
  for (int64_t units = 0; at < end;) {
    const size_t bytes = BytesOf(text_[at]);
    units += UnitsOf(bytes, units_);
    if (units > position.character) break;
    at += bytes;
  }
  return std::min(at, end);
}

Position ReadPosition(const Json& position) {
  return {rpc::NumberOf(position, "line"), rpc::NumberOf(position, "character")};
}

Json ToJson(Position position) { return {{"line", position.line}, {"character", position.character}}; }

std::string PathOfUri(std::string_view uri) {
  constexpr std::string_view kScheme = "file://";
  if (!uri.starts_with(kScheme)) return {};
  uri.remove_prefix(kScheme.size());
  const size_t slash = uri.find('/');  // a host ("localhost") stands before it
  if (slash == std::string_view::npos) return {};
  uri.remove_prefix(slash);
  std::string path;
  for (size_t i = 0; i < uri.size(); ++i) {
    unsigned value = 0;
    const char* digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2) {
      path += static_cast<char>(value);
      i += 2;
    } else {
      path += uri[i];
    }
  }
  return path.find('\0') == std::string::npos ? path : std::string();
}

std::string UriOfPath(std::string_view path) {
  std::string uri = "file://";
  for (const char c : path) {
    if (IsPlain(c)) {
      uri += c;
      continue;
    }
    uri += '%' + support::HexDigits(static_cast<unsigned char>(c), 2, support::HexLetters::kCapital);
  }
  return uri;
}

}  // namespace plcxx::lsp
