#include "transpiler/review/diff/statements.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string_view>

#include "transpiler/dialects/statement_text.h"

namespace plcxx::review::diff {
namespace {

constexpr size_t kMostLines = 500;  // of statements that are compared line by line

/// The statement without what does not count: spaces between words.
std::string Normalized(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!space) {
      result += c;
    } else if (!result.empty() && result.back() != ' ') {
      result += ' ';
    }
  }
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result;
}

std::vector<std::string_view> LinesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const size_t end = std::min(text.find_first_of("\r\n"), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size()));
  }
  return lines;
}

std::string ShownPath(const DiffSide& side, const std::string& path) {
  if (!side.file_name.empty() && path == side.request.sources.front()) return side.file_name;
  if (!side.hidden_prefix.empty() && path.starts_with(side.hidden_prefix)) {
    return path.substr(side.hidden_prefix.size());
  }
  return std::filesystem::path(path).lexically_normal().generic_string();
}

/// The text of a statement, then the lines that say elsewhere what it does.
std::vector<source::Range> RangesOf(const DiffSide& side, ir::StatementId id) {
  std::vector<source::Range> ranges = {side.whole.statements[id].range};
  if (id.index < side.elsewhere.size())
    ranges.insert(ranges.end(), side.elsewhere[id.index].begin(), side.elsewhere[id.index].end());
  return ranges;
}

/// `line` is a part of what the statement says.
void ShowLine(const DiffSide& side, ItemStatement& item, std::string_view line) {
  source::Range range = side.whole.statements[item.statement].range;
  std::string_view text = side.compilation.sources->Text(range);
  for (const source::Range other : RangesOf(side, item.statement)) {
    const std::string_view there = side.compilation.sources->Text(other);
    const std::less_equal<> is_before;
    if (!is_before(there.data(), line.data()) || !is_before(line.data() + line.size(), there.data() + there.size()))
      continue;
    range = other;
    text = there;
    break;
  }
  const source::Position at =
      side.compilation.sources->Locate(range.begin + static_cast<uint32_t>(line.data() - text.data()));
  item.file = at.file.valid() ? ShownPath(side, side.compilation.sources->Get(at.file).path) : std::string();
  item.line = at.line;
  item.column = at.column;
  item.text = dialects::StatementText(side.compilation.program.dialect, line);
}

std::vector<std::string_view> LinesOf(const DiffSide& side, ir::StatementId id) {
  std::vector<std::string_view> lines;
  for (const source::Range range : RangesOf(side, id)) {
    const std::vector<std::string_view> more = LinesOf(side.compilation.sources->Text(range));
    lines.insert(lines.end(), more.begin(), more.end());
  }
  return lines;
}

/// All that a statement says: two of one text with different expressions are different ones.
std::string WholeText(const DiffSide& side, ir::StatementId id) {
  std::string text;
  for (const source::Range range : RangesOf(side, id)) {
    if (!text.empty()) text += '\n';
    text += Normalized(side.compilation.sources->Text(range));
  }
  return text;
}

/// By line of `lines`: whether it belongs to the longest row of lines that stand in this order in both.
std::vector<bool> CommonLines(const std::vector<std::string_view>& lines, const std::vector<std::string_view>& other) {
  std::vector<std::string> one, two;
  for (const std::string_view line : lines) one.push_back(Normalized(line));
  for (const std::string_view line : other) two.push_back(Normalized(line));
  // From each pair of places to the end.
  std::vector<std::vector<size_t>> longest(one.size() + 1, std::vector<size_t>(two.size() + 1));
  for (size_t i = one.size(); i-- > 0;) {
    for (size_t k = two.size(); k-- > 0;) {
      longest[i][k] = one[i] == two[k] ? longest[i + 1][k + 1] + 1 : std::max(longest[i + 1][k], longest[i][k + 1]);
    }
  }
  std::vector<bool> common(one.size());
  for (size_t i = 0, k = 0; i < one.size() && k < two.size();) {
    if (one[i] == two[k]) {
      common[i] = true;
      ++i;
      ++k;
    } else if (longest[i + 1][k] >= longest[i][k + 1]) {
      ++i;
    } else {
      ++k;
    }
  }
  return common;
}

void ShowChangedLine(const DiffSide& side, ItemStatement& item, const DiffSide& other_side,
                     const std::vector<ItemStatement>& others) {
  const std::vector<std::string_view> lines = LinesOf(side, item.statement);
  if (!item.changed || lines.size() < 2 || lines.size() > kMostLines) return;
  std::vector<bool> common;  // with the one that is most like it
  size_t most = 0;
  for (const ItemStatement& other : others) {
    const std::vector<std::string_view> other_lines = LinesOf(other_side, other.statement);
    if (!other.changed || other_lines.size() > kMostLines) continue;
    std::vector<bool> shared = CommonLines(lines, other_lines);
    const auto count = static_cast<size_t>(std::ranges::count(shared, true));
    if (count <= most) continue;
    most = count;
    common = std::move(shared);
  }
  const auto own = std::ranges::find(common, false);
  if (own == common.end()) return;
  const std::string_view line = lines[static_cast<size_t>(own - common.begin())];
  const size_t first = line.find_first_not_of(" \t");
  if (first != std::string_view::npos) ShowLine(side, item, line.substr(first));
}

}  // namespace

StatementTexts TextsOf(const DiffSide& side) {
  StatementTexts texts;
  for (uint32_t i = 0; i < side.whole.statements.size(); ++i) {
    texts.statements.insert(WholeText(side, ir::StatementId(i)));
    for (const std::string_view line : LinesOf(side, ir::StatementId(i))) texts.lines.insert(Normalized(line));
  }
  return texts;
}

/// A statement of several lines is shown by the first one that the other version does not have.
ItemStatement StatementOf(const DiffSide& side, ir::StatementId id, const StatementTexts& other_texts) {
  const ir::Statement& statement = side.whole.statements[id];
  const std::string_view text = side.compilation.sources->Text(statement.range);
  const bool changed = !other_texts.statements.contains(WholeText(side, id));
  std::string_view shown = text.substr(0, text.find_first_of("\r\n"));
  for (const std::string_view line : LinesOf(side, id)) {
    if (!changed || other_texts.lines.contains(Normalized(line))) continue;
    if (line.find_first_not_of(" \t") != std::string_view::npos) shown = line;
    break;
  }
  shown.remove_prefix(std::min(shown.find_first_not_of(" \t"), shown.size()));
  ItemStatement item{.statement = id, .file = {}, .text = {}, .changed = changed};
  ShowLine(side, item, shown);
  return item;
}

std::vector<ItemStatement> ChangedStatements(const DiffSide& side, const DiffSide& other) {
  const StatementTexts texts = TextsOf(other);
  std::vector<ItemStatement> changed;
  for (uint32_t i = 0; i < side.whole.statements.size(); ++i) {
    const std::string_view text = side.compilation.sources->Text(side.whole.statements[ir::StatementId(i)].range);
    if (text.empty() || texts.statements.contains(WholeText(side, ir::StatementId(i)))) continue;
    changed.push_back(StatementOf(side, ir::StatementId(i), texts));
  }
  return changed;
}

void ShowChangedLines(const DiffSide& old_side, const DiffSide& new_side, DiffItem& item) {
  for (ItemStatement& statement : item.old_statements)
    ShowChangedLine(old_side, statement, new_side, item.new_statements);
  for (ItemStatement& statement : item.new_statements)
    ShowChangedLine(new_side, statement, old_side, item.old_statements);
}

std::string FileOfProgram(const DiffSide& side) {
  const source::SourceManager& sources = *side.compilation.sources;
  for (const ir::Statement& statement : side.whole.statements) {
    if (statement.range != source::Range{})
      return ShownPath(side, sources.Get(sources.FileAt(statement.range.begin)).path);
  }
  return sources.size() == 0 ? "" : ShownPath(side, sources.Get(source::FileId(0)).path);
}

}  // namespace plcxx::review::diff
