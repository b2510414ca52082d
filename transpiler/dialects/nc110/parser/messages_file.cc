#include "transpiler/dialects/nc110/parser/messages_file.h"

#include <algorithm>

#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/dialects/nc110/source/lexer.h"
#include "transpiler/dialects/nc110/source/tokens.h"

namespace plcxx::nc110 {
namespace {

constexpr uint32_t kDefaultColour = 15;

/// 0..15 in decimal, without blanks; none otherwise.
std::optional<uint32_t> ColourOf(std::string_view text) {
  if (text.empty() || text.size() > 2 || !std::all_of(text.begin(), text.end(), IsDigit)) return std::nullopt;
  uint32_t colour = 0;
  for (const char c : text) colour = colour * 10 + static_cast<uint32_t>(c - '0');
  if (colour > kDefaultColour) return std::nullopt;
  return colour;
}

}  // namespace

TextTable ReadTextFile(const source::SourceManager& sources, source::FileId file, TextFileKind kind,
                       diag::Engine& diagnostics) {
  TextTable table;
  table.given = true;
  const source::File& source = sources.Get(file);
  const uint32_t longest = kind == TextFileKind::kMessages ? kLongestMessage : kLongestMenuText;
  const uint32_t lines = sources.LineCount(file);
  for (uint32_t number = 1; number <= lines; ++number) {
    std::string_view line = sources.Line(file, number);
    const auto begin = static_cast<source::Offset>(source.base + (line.data() - source.text.data()));
    const source::Range range{begin, begin + static_cast<source::Offset>(line.size())};
    if (number > kMostTexts) {
      if (Trim(sources.Text({range.begin, sources.WholeFile(file).end})).empty()) break;  // blank lines at the end
      diagnostics.Report(range, diag::Nc110MessageCount, lines);
      break;
    }
    if (line.empty()) continue;  // a number without a text
    uint32_t colour = kDefaultColour;
    const size_t hash = line.find('#');
    if (hash == std::string_view::npos) {
      diagnostics.Report(range, diag::Nc110MessageWithoutColour);
    } else {
      const auto written = ColourOf(line.substr(0, hash));
      const bool blank_behind = hash + 1 < line.size() && line[hash + 1] == ' ';
      if (!written || blank_behind) {
        diagnostics.Report(range, diag::Nc110MessageFormat, line);
        continue;
      }
      colour = *written;
      line.remove_prefix(hash + 1);
    }
    const auto length = static_cast<uint32_t>(source::CountCodePoints(line));
    if (length > longest) {
      diagnostics.Report(range, diag::Nc110MessageTooLong, length, longest);
      continue;
    }
    if (kind == TextFileKind::kMessages && length == kLongestMessage) {
      diagnostics.Report(range, diag::Nc110MessageLength43);
    }
    table.texts.push_back({.number = number, .colour = colour, .text = std::string(line)});
    table.defined.set(number);
  }
  return table;
}

void AddDeclaredMessages(const Program& tree, const source::SourceManager& sources, TextTable& table,
                         diag::Engine& diagnostics) {
  const size_t from_file = table.texts.size();
  for (const Item& item : tree.items) {
    if (item.kind != ItemKind::kMessage) continue;
    const Message& message = tree.messages[item.message()];
    table.given = true;
    if (item.faulty || message.number == 0) continue;
    if (table.defined[message.number]) {
      // Declared twice by MSG is the parser's to report; here the file has the number already.
      const auto in_file = std::any_of(table.texts.begin(), table.texts.begin() + static_cast<ptrdiff_t>(from_file),
                                       [&](const ir::MessageText& text) { return text.number == message.number; });
      if (in_file) diagnostics.Report(item.range, diag::Nc110MsgTwice, message.number);
      continue;
    }
    table.defined.set(message.number);
    table.texts.push_back(
        {.number = message.number, .colour = kDefaultColour, .text = std::string(sources.Text(message.text))});
  }
  std::stable_sort(table.texts.begin(), table.texts.end(),
                   [](const ir::MessageText& a, const ir::MessageText& b) { return a.number < b.number; });
}

}  // namespace plcxx::nc110
