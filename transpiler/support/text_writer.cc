#include "transpiler/support/text_writer.h"

#include "transpiler/support/check.h"

namespace plcxx::support {

void TextWriter::Outdent() {
  PLCXX_CHECK(indent_ >= indent_width_);
  indent_ -= indent_width_;
}

void TextWriter::EndLine(size_t begin) {
  if (text_.size() == begin + indent_) text_.resize(begin);
  text_ += '\n';
}

void TextWriter::Lines(std::string_view text) {
  while (!text.empty()) {
    const size_t end = text.find('\n');
    Line(text.substr(0, end));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
}

}  // namespace plcxx::support
