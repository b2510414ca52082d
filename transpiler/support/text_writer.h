// Builds generated text line by line: one growing string and an indentation.
//
// In: pieces of text. Out: the text. Not its job: layout, wrapping, names.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace plcxx::support {

class TextWriter {
 public:
  explicit TextWriter(size_t indent_width = 2) : indent_width_(indent_width) {}

  void Reserve(size_t bytes) { text_.reserve(bytes); }
  void Indent() { indent_ += indent_width_; }
  void Outdent();

  /// The pieces as one indented line; without pieces, or with empty ones only, an empty line without blanks.
  template <class... Pieces>
  void Line(const Pieces&... pieces) {
    const size_t begin = text_.size();
    text_.append(indent_, ' ');
    (text_.append(std::string_view(pieces)), ...);
    EndLine(begin);
  }
  /// Text as it is: no indentation, no line end.
  void Write(std::string_view text) { text_.append(text); }
  /// Several lines at once, each indented; a line end after the last one is not needed.
  void Lines(std::string_view text);

  bool empty() const { return text_.empty(); }
  size_t size() const { return text_.size(); }
  const std::string& text() const { return text_; }
  std::string Take() { return std::exchange(text_, {}); }

 private:
  void EndLine(size_t begin);

  std::string text_;
  size_t indent_ = 0;
  size_t indent_width_;
};

/// One level deeper as long as it lives.
class Indented {
 public:
  explicit Indented(TextWriter& writer) : writer_(writer) { writer_.Indent(); }
  ~Indented() { writer_.Outdent(); }
  Indented(const Indented&) = delete;
  Indented& operator=(const Indented&) = delete;

 private:
  TextWriter& writer_;
};

}  // namespace plcxx::support
