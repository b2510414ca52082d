// Reads a technology table: its header, then row by row (specification 9.8.1, 9.8.5).
#include <algorithm>

#include "transpiler/dialects/technol/machine/machine.h"
#include "transpiler/dialects/technol/machine/technology_table.h"
#include "transpiler/dialects/technol/source/lexer.h"
#include "transpiler/dialects/technol/source/sources.h"
#include "transpiler/dialects/technol/source/technology_items.h"
#include "transpiler/source/read_bytes.h"

namespace plcxx::technol {
namespace {

constexpr std::string_view kKeyword = "$TCH";

struct Word {
  std::string_view text;
  source::Range range;
};

bool IsNumber(std::string_view text) { return !text.empty() && std::ranges::all_of(text, IsDigit); }

/// Digits with the ':' that ends them.
bool IsRowNumber(std::string_view text) {
  constexpr size_t kMostDigits = 3;
  return text.size() >= 2 && text.size() <= kMostDigits + 1 && text.back() == ':' &&
         IsNumber(text.substr(0, text.size() - 1));
}

uint32_t ValueOf(std::string_view digits) {
  constexpr uint32_t kTooLarge = 100'000;  // above every limit
  uint32_t value = 0;
  for (const char digit : digits) value = std::min(value * 10 + static_cast<uint32_t>(digit - '0'), kTooLarge);
  return value;
}

class TableReader {
 public:
  TableReader(const source::SourceManager& sources, source::FileId file, const Settings& settings,
              diag::Engine& diagnostics)
      : sources_(sources), file_(sources.Get(file)), settings_(settings), diagnostics_(diagnostics) {
    table_.file = file;
  }

  std::optional<TechnologyTable> Run() {
    const uint32_t before = diagnostics_.error_count();
    TakeName();
    const std::string_view text = file_.text;
    const size_t keyword = text.find(kKeyword);
    if (TrimBlanks(text).empty()) {
      Report(FirstLine(), diag::TechnolTableEmpty, file_.path, "");
    } else if (keyword == std::string_view::npos) {
      Report(FirstLine(), diag::TechnolTableKeyword);
    } else {
      TakePreamble(keyword);
      SplitWords(keyword + kKeyword.size());
      if (TakeHeader(keyword)) TakeRows();
    }
    if (diagnostics_.error_count() > before) return std::nullopt;
    return std::move(table_);
  }

 private:
  template <class... Args, class... Values>
  void Report(source::Range range, const diag::Message<Args...>& message, Values&&... values) {
    diagnostics_.Report(range, message, std::forward<Values>(values)...);
  }

  source::Range RangeOf(size_t begin, size_t end) const {
    return {file_.base + static_cast<source::Offset>(begin), file_.base + static_cast<source::Offset>(end)};
  }
  source::Range FirstLine() const { return RangeOf(0, std::min(file_.text.find_first_of("\r\n"), file_.text.size())); }

  /// The end of the last line that is not blank: after everything else that is wrong in it.
  source::Range LastPlace() const {
    const std::string_view text = file_.text;
    size_t end = text.size();
    while (end > 0 && IsBlank(text[end - 1])) --end;
    return RangeOf(end == 0 ? 0 : end - 1, end);
  }

  void TakeName() {
    const size_t slash = file_.path.find_last_of("/\\");
    table_.name = Upper(slash == std::string::npos ? file_.path : file_.path.substr(slash + 1));
    if (table_.name.size() >= kTableNameBytes) {
      Report(FirstLine(), diag::TechnolTableName, table_.name, static_cast<int64_t>(table_.name.size()));
    }
    if (!table_.name.starts_with("TAB") || !IsTable(table_.name))
      Report(FirstLine(), diag::TechnolTableFilter, table_.name);
  }

  /// Byte for byte: what was decoded is read from the file once more.
  void TakePreamble(size_t keyword) {
    table_.preamble = file_.text.substr(0, keyword);
    const bool as_read = file_.encoding == source::Encoding::kUtf8 && file_.replaced.empty() && !file_.had_bom;
    if (as_read || keyword == 0) return;
    constexpr size_t kMostBytes = 64U << 20;
    const auto bytes = source::ReadBytes(file_.path, kMostBytes);
    const size_t end = sources_.OriginalByte(file_.base + static_cast<source::Offset>(keyword));
    const auto* read = std::get_if<std::string>(&bytes);
    if (read != nullptr && read->size() >= end) table_.preamble = read->substr(0, end);
  }

  void SplitWords(size_t at) {
    const std::string_view text = file_.text;
    first_word_glued_ = at < text.size() && !IsBlank(text[at]) && text[at] != ';' && text[at] != '"';
    while (at < text.size()) {
      const char c = text[at];
      if (IsBlank(c)) {
        ++at;
      } else if (c == ';') {
        at = std::min(text.find_first_of("\r\n", at), text.size());
      } else if (c == '"') {
        const size_t end = std::min(text.find_first_of("\"\r\n", at + 1), text.size());
        const bool closed = end < text.size() && text[end] == '"';
        if (!closed) Report(RangeOf(at, end), diag::TechnolTableComment);
        at = closed ? end + 1 : end;
      } else {
        size_t end = at;
        while (end < text.size() && !IsBlank(text[end]) && text[end] != ';' && text[end] != '"') {
          if (text[end++] == ':') break;
        }
        AddWord(at, end);
        at = end;
      }
    }
  }

  void AddWord(size_t begin, size_t end) {
    const std::string_view text = std::string_view(file_.text).substr(begin, end - begin);
    if (settings_.glued_items == GluedItems::kRefuse) {
      words_.push_back({text, RangeOf(begin, end)});
      return;
    }
    for (const std::string_view part : SplitGlued(text)) {
      words_.push_back({part, RangeOf(begin, begin + part.size())});
      begin += part.size();
    }
  }

  bool TakeHeader(size_t keyword) {
    const source::Range place = RangeOf(keyword, keyword + kKeyword.size());
    const auto missing = [](const char* what) { return std::string("it is missing behind ") + what; };
    const auto shown = [](const Word& word) { return "'" + std::string(word.text) + "'"; };
    if (first_word_glued_ || words_.empty()) {
      Report(words_.empty() ? place : words_[0].range, diag::TechnolTableVersion,
             words_.empty() ? missing("$TCH") : shown(words_[0]) + " is not separated from $TCH");
      return false;
    }
    const uint32_t version = IsNumber(words_[0].text) ? ValueOf(words_[0].text) : 0;
    const bool known = settings_.table_version == TableVersion::kAny ? version <= 0xFFFF : version == 1;
    if (!IsNumber(words_[0].text) || !known) Report(words_[0].range, diag::TechnolTableVersion, shown(words_[0]));
    table_.version = static_cast<uint16_t>(version);
    if (words_.size() < 2) {
      Report(words_[0].range, diag::TechnolTableColumns, missing("the version"));
      return false;
    }
    const uint32_t columns = IsNumber(words_[1].text) ? ValueOf(words_[1].text) : 0;
    if (columns < 1 || columns > kTableColumns) Report(words_[1].range, diag::TechnolTableColumns, shown(words_[1]));
    if (words_.size() < 3) {
      Report(words_[1].range, diag::TechnolTableRows, missing("the columns"));
      return false;
    }
    const uint32_t rows = IsNumber(words_[2].text) ? ValueOf(words_[2].text) : 0;
    if (rows < 1 || rows > kTableRows) Report(words_[2].range, diag::TechnolTableRows, shown(words_[2]));
    next_ = 3;
    if (columns < 1 || columns > kTableColumns || rows < 1 || rows > kTableRows) return false;
    if (columns * rows > kTableItems) {
      Report(place, diag::TechnolTableSize, int64_t{columns}, int64_t{rows});
      return false;
    }
    table_.columns = static_cast<uint16_t>(columns);
    table_.rows = static_cast<uint16_t>(rows);
    return true;
  }

  bool AtEnd() const { return next_ >= words_.size(); }
  /// Digits and a ':' after white space: a row number that is torn, wherever it stands.
  bool IsTorn(size_t at) const {
    return at + 1 < words_.size() && IsNumber(words_[at].text) && words_[at + 1].text == ":";
  }
  /// A ':' with anything but digits directly before it.
  bool IsStrayColon(size_t at) const { return words_[at].text.back() == ':' && !IsRowNumber(words_[at].text); }

  void SkipToRow() {
    while (!AtEnd() && !IsRowNumber(words_[next_].text)) ++next_;
  }

  void ReportRowNumber(const Word& word) {
    Report(word.range, diag::TechnolTableRowNumber, word.text,
           seen_ < table_.rows ? "row " + std::to_string(expected_) : std::string("or the end of the table"));
  }

  void TakeRows() {
    while (seen_ < table_.rows && expected_ < table_.rows) {
      if (AtEnd()) {
        Report(LastPlace(), diag::TechnolTableFewerRows, int64_t{seen_}, int64_t{table_.rows});
        return;
      }
      const Word& word = words_[next_];
      if (!IsRowNumber(word.text)) {
        ReportRowNumber(word);
        SkipToRow();
        // The number of one row was unreadable or missing: what follows is that row or the next one.
        const bool next = AtEnd() || NumberOf(words_[next_]) == expected_ + 1;
        if (next) ++expected_, ++seen_;
        continue;
      }
      const uint32_t number = NumberOf(word);
      if (number != expected_) {
        Report(word.range, diag::TechnolTableSequence, int64_t{expected_}, int64_t{number});
        if (number < table_.rows) expected_ = number;
      }
      ++next_;
      if (!TakeItems()) SkipToRow();
      const uint32_t rows = torn_ ? 2 : 1;  // what followed a torn number has been skipped, too
      torn_ = false;
      expected_ += rows;
      seen_ += rows;
    }
    if (AtEnd()) return;
    const Word& word = words_[next_];
    if (IsTorn(next_) || IsStrayColon(next_)) return ReportRowNumber(word);
    Report(word.range, diag::TechnolTableBehindLast, word.text);
  }

  static uint32_t NumberOf(const Word& word) { return ValueOf(word.text.substr(0, word.text.size() - 1)); }

  /// The items of one row; false when something is wrong in it (reported).
  bool TakeItems() {
    for (uint32_t column = 0; column < table_.columns; ++column) {
      if (AtEnd() || IsRowNumber(words_[next_].text)) {
        Report(AtEnd() ? LastPlace() : words_[next_].range, diag::TechnolTableTooFew, int64_t{expected_},
               int64_t{column}, int64_t{table_.columns});
        return true;  // nothing has to be skipped
      }
      const Word& word = words_[next_];
      if (IsTorn(next_) || IsStrayColon(next_)) {
        ReportRowNumber(word);
        torn_ = IsTorn(next_);
        return false;
      }
      if (!TakeItem(word)) return false;
      ++next_;
    }
    if (AtEnd() || IsRowNumber(words_[next_].text)) return true;
    if (IsTorn(next_)) return true;  // the next row's, and its fault
    const Word& word = words_[next_];
    const bool last = seen_ + 1 >= table_.rows || expected_ + 1 >= table_.rows;
    if (IsStrayColon(next_)) {
      ReportRowNumber(word);
    } else if (IsItem(word.text)) {
      Report(word.range, diag::TechnolTableTooMany, int64_t{expected_}, word.text, int64_t{table_.columns});
    } else if (last) {
      Report(word.range, diag::TechnolTableBehindLast, word.text);
    } else {
      ReportRowNumber(word);
    }
    return false;
  }

  bool TakeItem(const Word& word) {
    const Item item = ReadItem(word.text);
    switch (item.fault) {
      case ItemFault::kNone:
        table_.items.push_back(item.value);
        return true;
      case ItemFault::kMalformed:
        Report(word.range, diag::TechnolTableNumber, word.text);
        return false;
      case ItemFault::kNotSeparated:
        Report(word.range, diag::TechnolTableSeparated, word.text);
        return false;
      case ItemFault::kRange:
        Report(word.range, diag::TechnolTableRange, word.text);
        return false;
    }
    return false;
  }

  const source::SourceManager& sources_;
  const source::File& file_;
  const Settings& settings_;
  diag::Engine& diagnostics_;
  TechnologyTable table_;
  std::vector<Word> words_;
  bool first_word_glued_ = false;
  size_t next_ = 0;
  uint32_t expected_ = 0;  // the number of the next row
  uint32_t seen_ = 0;      // rows so far
  bool torn_ = false;      // the number of the next row, in the middle of this one: reported
};

}  // namespace

std::optional<TechnologyTable> ReadTable(const source::SourceManager& sources, source::FileId file,
                                         const Settings& settings, diag::Engine& diagnostics) {
  return TableReader(sources, file, settings, diagnostics).Run();
}

}  // namespace plcxx::technol
