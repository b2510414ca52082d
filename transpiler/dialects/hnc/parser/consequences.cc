#include "transpiler/dialects/hnc/parser/consequences.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "transpiler/dialects/hnc/machine/headers.h"
#include "transpiler/dialects/hnc/syntax/characters.h"

namespace plcxx::hnc {
namespace {

/// Of a line of any length what is near the place.
std::string_view LineAt(const source::SourceManager& sources, source::Offset place) {
  constexpr size_t kNear = 200;
  const source::File& file = sources.Get(sources.FileAt(place));
  const size_t at = std::min<size_t>(place - file.base, file.text.size());
  const size_t before = std::min(at, kNear);
  const std::string_view near = std::string_view(file.text).substr(at - before, before + kNear);
  const size_t line_end = near.substr(0, before).find_last_of("\r\n");
  const size_t begin = line_end == std::string_view::npos ? 0 : line_end + 1;
  return near.substr(begin, near.find_first_of("\r\n", before) - begin);
}

bool NamesHeader(std::string_view line) {
  for (size_t at = 0; at < line.size();) {
    size_t end = at;
    while (end < line.size() && IsWord(line[end])) ++end;
    if (end > at && IsNameOfSystemHeader(line.substr(at, end - at))) return true;
    at = std::max(end, at + 1);
  }
  return false;
}

bool IsCode(const Finding& finding, std::initializer_list<const diag::Row*> rows) {
  return std::ranges::any_of(rows, [&](const diag::Row* row) { return finding.row.code == row->code; });
}

/// The braces of a file outside of comments, texts and directives.
struct Braces {
  struct At {
    source::Offset place = 0;
    int depth = 0;  // behind it
  };
  std::vector<At> all;

  explicit Braces(const source::File& file) {
    const std::string_view text = file.text;
    int depth = 0;
    bool at_line_begin = true;
    for (size_t at = 0; at < text.size(); ++at) {
      const char c = text[at];
      if (c == '\n' || c == '\r') {
        at_line_begin = true;
      } else if (text.substr(at).starts_with("//") || (c == '#' && at_line_begin)) {
        at = std::min(EndOfLogicalLine(text, at), text.size()) - 1;
      } else if (text.substr(at).starts_with("/*")) {
        at = std::min(text.find("*/", at + 2), text.size() - 2) + 1;
      } else if (c == '"' || c == '\'') {
        at = EndOfLiteral(text, at);
      } else if (c == '{' || c == '}') {
        depth += c == '{' ? 1 : -1;
        all.push_back({file.base + static_cast<source::Offset>(at), depth});
        if (depth < 0) break;
      }
      if (!IsBlank(c)) at_line_begin = false;
    }
  }

  int DepthBefore(source::Offset place) const {
    const auto behind = std::ranges::lower_bound(all, place, {}, &At::place);
    return behind == all.begin() ? 0 : std::prev(behind)->depth;
  }
  /// A '}' too much: the file is not looked at behind it.
  std::optional<source::Offset> Surplus() const {
    return all.empty() || all.back().depth >= 0 ? std::nullopt : std::optional(all.back().place);
  }
  bool IsOpenAtEnd() const { return !all.empty() && all.back().depth > 0; }
  /// The innermost '{' that nothing closes.
  std::optional<source::Offset> LastOpen() const {
    if (!IsOpenAtEnd()) return std::nullopt;
    const int depth = all.back().depth;
    const auto opened = std::ranges::find_if(all.rbegin(), all.rend(), [&](const At& at) { return at.depth < depth; });
    return std::prev(opened)->place;
  }

 private:
  static size_t EndOfLogicalLine(std::string_view text, size_t at) {
    for (; at < text.size() && text[at] != '\n' && text[at] != '\r'; ++at) {
      if (text[at] == '\\' && at + 1 < text.size()) {
        ++at;
        if (text.substr(at).starts_with("\r\n")) ++at;
      }
    }
    return at;
  }
  static size_t EndOfLiteral(std::string_view text, size_t at) {
    const char quote = text[at];
    for (++at; at < text.size() && text[at] != quote && text[at] != '\n' && text[at] != '\r'; ++at) {
      if (text[at] == '\\') ++at;
    }
    return at;
  }
};

/// A header that ends within a block has taken in what follows its #include: one finding, at its end, is left of that.
bool MergeOpenHeader(const source::SourceManager& sources, std::vector<Finding>& findings) {
  const auto shows_it = [](const Finding& finding) {
    const bool at_end = finding.row.key == diag::HncSyntax.row.key && !finding.arguments.empty() &&
                        finding.arguments.front() == "the end of the file";
    return finding.row.key == diag::HncFunctionInside.row.key || at_end;
  };
  const auto shown = std::ranges::find_if(findings, shows_it);
  if (shown == findings.end() || shown->range.begin == 0) return false;
  const source::FileId including = sources.FileAt(shown->range.begin);
  if (Braces(sources.Get(including)).IsOpenAtEnd()) return false;
  for (uint32_t i = 0; i < sources.size(); ++i) {
    const source::FileId id(i);
    if (id == including) continue;
    const source::File& file = sources.Get(id);
    const std::optional<source::Offset> open = Braces(file).LastOpen();
    if (!open) continue;
    const auto end = static_cast<source::Offset>(file.base + file.text.find_last_not_of(" \t\r\n") + 1);
    std::erase_if(findings, [&](const Finding& finding) {
      return finding.range.begin != 0 && sources.FileAt(finding.range.begin) != id &&
             (finding.phase == Phase::kSyntax || finding.phase == Phase::kMeaning);
    });
    findings.push_back({.phase = Phase::kSyntax,
                        .row = diag::HncSyntax.row,
                        .range = {end, end},
                        .arguments = {"the end of '" + file.path + "'", "'}'"},
                        .notes = {{{*open, *open + 1}, "to match this"}},
                        .fixits = {}});
    return true;
  }
  return false;
}

}  // namespace

void MergeMissingHeader(const source::SourceManager& sources, std::vector<Finding>& findings) {
  const auto follows = [&](const Finding& finding) {
    return IsCode(finding, {&diag::HncUndeclared.row, &diag::HncUndefinedFunction.row, &diag::HncIncompatible.row,
                            &diag::HncPointerAsValue.row, &diag::HncNotAssignable.row}) &&
           finding.range.begin != 0 && NamesHeader(LineAt(sources, finding.range.begin));
  };
  const Finding* first = nullptr;
  for (const Finding& finding : findings) {
    if (!follows(finding) || finding.arguments.empty() || !IsNameOfSystemHeader(finding.arguments.front())) continue;
    if (first == nullptr || finding.range.begin < first->range.begin) first = &finding;
  }
  if (first == nullptr) return;
  constexpr const char* kRemedy = "it is a name of the system header: write #include \"plc.h\" at the beginning";
  const Finding cause{.phase = first->phase,
                      .row = diag::HncUndeclaredForeign.row,
                      .range = first->range,
                      .arguments = {first->arguments.front(), kRemedy},
                      .notes = {},
                      .fixits = {}};
  std::erase_if(findings, follows);
  findings.push_back(cause);
}

void MergeMissingBrace(const source::SourceManager& sources, std::vector<Finding>& findings) {
  if (MergeOpenHeader(sources, findings)) return;
  const auto first = std::ranges::min_element(findings, {}, [](const Finding& finding) {
    const bool counts = finding.phase == Phase::kSyntax || finding.row.key == diag::HncFunctionInside.row.key;
    return counts && finding.range.begin != 0 ? finding.range.begin : ~source::Offset{0};
  });
  if (first == findings.end() || first->range.begin == 0) return;
  const source::Offset place = first->range.begin;
  const source::FileId id = sources.FileAt(place);
  const Braces braces(sources.Get(id));
  const std::optional<source::Offset> surplus = braces.Surplus();
  const bool misses_opening = surplus && *surplus > place && braces.DepthBefore(place) == 0;
  const bool misses_closing = braces.IsOpenAtEnd() && first->row.key == diag::HncFunctionInside.row.key;
  if (!misses_opening && !misses_closing) return;
  std::erase_if(findings, [&](const Finding& finding) {
    const source::Offset at = finding.range.begin;
    if (at <= place || sources.FileAt(at) != id) return false;
    return misses_closing || (at <= *surplus && braces.DepthBefore(at) == 0);
  });
}

}  // namespace plcxx::hnc
