// Rows of a drawing to cells (specification 3.6, rules 1 to 3).
#include <string>

#include "transpiler/dialects/common/fault_reporter.h"
#include "transpiler/dialects/host50/parser/drawing.h"
#include "transpiler/source/characters.h"

namespace plcxx::host50 {
namespace {

char ClosingOf(char bracket) {
  switch (bracket) {
    case '[':
      return ']';
    case '(':
      return ')';
    case '{':
      return '}';
    default:
      return 0;
  }
}

class RowReader : private dialects::FaultReporter {
 public:
  RowReader(const source::File& file, source::Range row, Drawing& drawing, diag::Engine& diagnostics)
      : FaultReporter(diagnostics, failed_, &drawing.faulty),
        text_(std::string_view(file.text).substr(row.begin - file.base, row.end - row.begin)),
        base_(row.begin),
        replaced_(!file.replaced.empty()),
        drawing_(drawing) {}

  DrawnRow Run() {
    for (; at_ < text_.size() && text_[at_] != ';'; Step()) {
      if (text_[at_] == '\t') {
        Fault(at_, at_ + 1, diag::Host50LadderTab);
      } else if (text_[at_] != ' ' && !ReadCell()) {
        break;  // what is behind an open bracket belongs to it
      }
    }
    if (at_ < text_.size() && text_[at_] == ';') ReadComment();
    if (!row_.cells.empty() || strange_) CheckRow();
    return std::move(row_);
  }

 private:
  /// After the character at the cursor.
  void Step() {
    const source::CodePoint point = source::FirstCodePoint(text_.substr(at_));
    at_ += point.length;
    column_ += source::DisplayWidth(point.value);
  }

  source::Range RangeOf(size_t begin, size_t end) const {
    return {base_ + static_cast<source::Offset>(begin), base_ + static_cast<source::Offset>(end)};
  }

  /// E601, once for each row.
  template <class... Args>
  void Fault(size_t begin, size_t end, const diag::Message<Args...>& message, std::type_identity_t<Args>... args) {
    drawing_.readable = false;
    FaultReporter::Fault(RangeOf(begin, end), message, args...);
  }

  void AddCell(CellKind kind) {
    row_.cells.push_back({.kind = kind, .begin = column_, .end = column_ + 1, .range = RangeOf(at_, at_ + 1)});
  }

  /// The cursor stays on the last character of the cell. False at an element that does not end.
  bool ReadCell() {
    const bool first = row_.cells.empty() && !strange_;
    switch (text_[at_]) {
      case '|':
        AddCell(first ? CellKind::kRail : CellKind::kLink);
        return true;
      case '-':
        AddCell(CellKind::kWire);
        return true;
      case '+':
        AddCell(CellKind::kJunction);
        return true;
      case '[':
      case '(':
      case '{':
        return ReadElement();
      default:
        break;
    }
    strange_ = true;
    const source::CodePoint point = source::FirstCodePoint(text_.substr(at_));
    constexpr char32_t kReplacement = 0xFFFD;
    if (replaced_ && point.value == kReplacement) {
      drawing_.readable = false;  // a byte without a character: reported with its line
      drawing_.faulty = failed_ = true;
    } else {
      Fault(at_, at_ + point.length, diag::Host50LadderCharacter,
            point.value < ' ' ? "of a control" : "'" + std::string(text_.substr(at_, point.length)) + "'");
    }
    return true;
  }

  /// Where the element's closing bracket stands; npos when the row has none.
  size_t FindClosing(char closing) const {
    char quote = 0;
    for (size_t i = at_ + 1; i < text_.size(); ++i) {
      const char c = text_[i];
      if (quote == 0 && c == closing) return i;
      if (quote != 0 && c == quote) {
        quote = 0;
      } else if (quote == 0 && (c == '"' || c == '\'')) {
        quote = c;
      }
    }
    return std::string_view::npos;
  }

  bool ReadElement() {
    const char bracket = text_[at_];
    const size_t begin = at_;
    const size_t closing = FindClosing(ClosingOf(bracket));
    if (closing == std::string_view::npos) {
      drawing_.readable = false;
      strange_ = true;
      Report(RangeOf(begin, begin + 1), diag::Host50LadderBracket, std::string(1, bracket));
      return false;
    }
    DrawnCell cell{.kind = CellKind::kElement, .begin = column_, .range = RangeOf(begin, closing + 1)};
    while (at_ < closing) {
      if (text_[at_] == '\t') Fault(at_, at_ + 1, diag::Host50LadderTab);
      Step();
    }
    cell.end = column_ + 1;
    const std::string_view contents = text_.substr(begin + 1, closing - begin - 1);
    const size_t last = contents.find_last_not_of(" \t");
    const bool only_prefix = last != std::string_view::npos && contents.find_first_not_of(" \t") == last &&
                             contents[last] == '/' && bracket != '{';
    if (last == std::string_view::npos || only_prefix) {
      strange_ = true;
      Fault(begin, closing + 1, diag::Host50LadderEmpty);
      return true;
    }
    cell.element = static_cast<uint32_t>(drawing_.elements.size());
    drawing_.elements.push_back({.bracket = bracket,
                                 .row = static_cast<uint32_t>(drawing_.rows.size()),
                                 .range = cell.range,
                                 .contents = RangeOf(begin + 1, closing)});
    row_.cells.push_back(cell);
    if (++elements_ == kMostCells + 1) {
      Report(cell.range, diag::Host50LadderElements);
    }
    return true;
  }

  void ReadComment() {
    size_t end = text_.size();
    while (end > at_ + 1 && (text_[end - 1] == ' ' || text_[end - 1] == '\t')) --end;
    row_.comment = RangeOf(at_, end);
  }

  /// A row with cells: the rail, the number of rows.
  void CheckRow() {
    const bool has_rail = !row_.cells.empty() && row_.cells.front().kind == CellKind::kRail;
    if (has_rail && !drawing_.rail && (drawing_.rows_with_cells == 0 || !drawing_.readable)) {
      drawing_.rail = row_.cells.front().begin;
    } else if (!has_rail || row_.cells.front().begin != drawing_.rail) {
      const size_t begin = text_.find_first_not_of(" \t");
      Fault(begin, begin + source::FirstCodePoint(text_.substr(begin)).length, diag::Host50LadderRail);
    }
    if (++drawing_.rows_with_cells == kMostRows + 1) {
      Report(RangeOf(0, text_.size()), diag::Host50LadderRows);
    }
  }

  std::string_view text_;
  source::Offset base_;
  bool replaced_;
  Drawing& drawing_;
  DrawnRow row_;
  size_t at_ = 0;
  uint32_t column_ = 0;
  uint32_t elements_ = 0;
  bool failed_ = false;   // an E601 was reported
  bool strange_ = false;  // something stands there that is no cell
};

}  // namespace

void AddRow(const source::File& file, source::Range row, Drawing& drawing, diag::Engine& diagnostics) {
  DrawnRow read = RowReader(file, row, drawing, diagnostics).Run();
  drawing.rows.push_back(std::move(read));
}

}  // namespace plcxx::host50
