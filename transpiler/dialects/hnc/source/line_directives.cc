// #line: places after it show as it says, as places of a text with its name and its lines.
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/dialects/hnc/source/source_text.h"

namespace plcxx::hnc {
namespace {

uint32_t LineEndsIn(std::string_view text) {
  uint32_t count = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n' || (text[i] == '\r' && !text.substr(i + 1).starts_with('\n'))) ++count;
  }
  return count;
}

/// One text that is shown in place of parts of a file. Parts whose lines follow one another share it, for each text has
/// empty lines up to its first part.
class ShownText {
 public:
  ShownText(source::SourceManager& sources, SourceText& text) : sources_(sources), text_(text) {}

  /// False: too many empty lines; the part keeps its place in the file, which is also true.
  bool Add(const std::string& name, uint32_t line, source::Offset from, std::string_view part) {
    if (name != name_ || line < next_line_) Finish();
    const uint32_t blank = line - next_line_;
    if (blank > blanks_left_) return false;
    blanks_left_ -= blank;
    name_ = name;
    shown_.append(blank, '\n');
    parts_.push_back({from, static_cast<source::Offset>(shown_.size())});
    shown_ += part;
    next_line_ = line + LineEndsIn(part);
    return true;
  }
  void Finish() {
    if (parts_.empty()) return;
    const source::Offset base = sources_.Get(sources_.AddText(name_, std::move(shown_))).base;
    for (const SourceText::Moved& part : parts_) text_.moved.push_back({part.from, base + part.to});
    shown_.clear();
    parts_.clear();
    next_line_ = 1;
  }

 private:
  source::SourceManager& sources_;
  SourceText& text_;
  std::string name_, shown_;
  std::vector<SourceText::Moved> parts_;  // `to`: in `shown_`
  uint32_t next_line_ = 1;                // the line after `shown_`
  uint32_t blanks_left_ = 1'000'000;      // in all texts of the file
};

}  // namespace

void ApplyLineDirectives(source::SourceManager& sources, SourceText& text) {
  const std::string original = sources.Get(text.file).text;
  std::string name = sources.Get(text.file).path;
  ShownText shown(sources, text);
  for (size_t i = 0; i < text.line_directives.size(); ++i) {
    const SourceText::LineDirective& directive = text.line_directives[i];
    if (!directive.name.empty()) name = directive.name;
    const bool last = i + 1 == text.line_directives.size();
    const size_t end = last ? original.size() : text.line_directives[i + 1].at;
    const source::Offset from = text.base + directive.at;
    const std::string_view part = std::string_view(original).substr(directive.at, end - directive.at);
    if (shown.Add(name, directive.line, from, part)) continue;
    shown.Finish();
    text.moved.push_back({from, from});
  }
  shown.Finish();
  if (text.moved.empty()) return;
  const auto move = [&](source::Range& range) { range = {text.Shown(range.begin), text.Shown(range.end)}; };
  for (Comment& comment : text.comments) move(comment.range);
  for (Finding& finding : text.findings.all()) move(finding.range);
}

}  // namespace plcxx::hnc
