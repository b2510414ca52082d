#include "transpiler/dialects/nc110/parser/help_file.h"

#include <algorithm>
#include <optional>

#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/dialects/nc110/parser/parser.h"
#include "transpiler/dialects/nc110/source/lexer.h"
#include "transpiler/dialects/nc110/source/tokens.h"

namespace plcxx::nc110 {
namespace {

constexpr uint32_t kMostLines = 17, kLongestLine = 54, kLongestSingleLine = 918;

std::string Key(Operand operand) {
  if (operand.kind == OperandKind::kInput) operand.kind = OperandKind::kOutput;
  return ToText(operand);
}

/// Reads line by line: '<', head, text, '#'. The head may stand after the '<', the '#' after the last line.
class HelpReader {
 public:
  HelpReader(HelpTexts& texts, diag::Engine& diagnostics) : texts_(texts), diagnostics_(diagnostics) {}

  void Line(std::string_view line, source::Range range);
  void Finish() {
    if (state_ != State::kOutside) Reject("'#' is missing");
  }

 private:
  enum class State : uint8_t { kOutside, kHead, kText };

  void Begin(source::Range range) {
    state_ = State::kHead;
    begin_ = range;
    operand_ = {};
    entry_ = {};
    lines_ = 0;
    fault_.clear();
  }
  void Head(std::string_view line);
  void Text(std::string_view line);
  void End();
  void Reject(const std::string& what) {
    diagnostics_.Report(begin_, diag::Nc110HelpMalformed, what);
    state_ = State::kOutside;
  }
  void Fault(std::string_view what) {
    if (fault_.empty()) fault_ = what;
  }

  HelpTexts& texts_;
  diag::Engine& diagnostics_;
  State state_ = State::kOutside;
  source::Range begin_;
  Operand operand_;
  HelpEntry entry_;
  uint32_t lines_ = 0;
  size_t longest_ = 0;
  std::string fault_;  // the first one of this entry
};

void HelpReader::Head(std::string_view line) {
  const size_t dash = line.find('-');
  operand_ = OperandFromText(Trim(line.substr(0, dash)));
  if (dash == std::string_view::npos || operand_.kind == OperandKind::kNone) Fault("the head is not ADDRESS-NAME");
  if (dash != std::string_view::npos) entry_.name = Trim(line.substr(dash + 1));
  longest_ = 0;
  state_ = State::kText;
}

void HelpReader::Text(std::string_view line) {
  if (lines_++ > 0) entry_.text.push_back('\n');
  entry_.text += line;
  longest_ = std::max(longest_, source::CountCodePoints(line));
}

void HelpReader::End() {
  if (state_ == State::kHead) Fault("the head is missing");
  if (lines_ > kMostLines) Fault("more than 17 lines");
  if (longest_ > (lines_ == 1 ? kLongestSingleLine : kLongestLine)) {
    Fault(lines_ == 1 ? "a line of more than 918 characters" : "a line of more than 54 characters");
  }
  if (!fault_.empty()) return Reject(fault_);
  texts_.Add(operand_, std::move(entry_));
  state_ = State::kOutside;
}

void HelpReader::Line(std::string_view line, source::Range range) {
  line = Trim(line);
  if (line.starts_with('<')) {
    Finish();
    Begin(range);
    line = Trim(line.substr(1));
    if (line.empty()) return;
  } else if (state_ == State::kOutside) {
    if (line.empty()) return;
    Begin(range);
    return Reject("text outside an entry");
  }
  const bool last = line.ends_with('#');
  if (last) line = Trim(line.substr(0, line.size() - 1));
  if (line.find('<') != std::string_view::npos) Fault("'<' in the text");
  if (state_ == State::kHead) {
    if (!line.empty()) Head(line);
  } else if (!line.empty() || !last) {
    Text(line);
  }
  if (last) End();
}

}  // namespace

const HelpEntry* HelpTexts::Find(const Operand& operand) const {
  const auto found = entries_.find(Key(operand));
  return found == entries_.end() ? nullptr : &found->second;
}

void HelpTexts::Add(const Operand& operand, HelpEntry entry) { entries_.emplace(Key(operand), std::move(entry)); }

HelpTexts ReadHelpFile(const source::SourceManager& sources, source::FileId file, diag::Engine& diagnostics) {
  HelpTexts texts;
  HelpReader reader(texts, diagnostics);
  const source::File& source = sources.Get(file);
  for (uint32_t number = 1; number <= sources.LineCount(file); ++number) {
    const std::string_view line = sources.Line(file, number);
    const auto begin = static_cast<source::Offset>(source.base + (line.data() - source.text.data()));
    reader.Line(line, {begin, begin + static_cast<source::Offset>(line.size())});
  }
  reader.Finish();
  return texts;
}

}  // namespace plcxx::nc110
