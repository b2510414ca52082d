#include "transpiler/dialects/technol/parser/macros.h"

#include <algorithm>
#include <iterator>

#include "transpiler/dialects/technol/source/lexer.h"

namespace plcxx::technol {
namespace {

constexpr std::string_view kLocalMark = "??";  // before the number of the expansion

/// The end of the quoted text that begins at `at`; the end of the line when it is not closed.
size_t QuoteEnd(std::string_view text, size_t at) {
  const size_t end = at + 2 < text.size() ? text.find(text[at], at + 2) : std::string_view::npos;
  return end == std::string_view::npos ? text.size() : end + 1;
}

}  // namespace

std::vector<std::string_view> SplitArguments(std::string_view text) {
  std::vector<std::string_view> arguments;
  if (TrimBlanks(text).empty()) return arguments;
  int depth = 0;
  size_t begin = 0;
  for (size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '\'' || c == '"') {
      at = QuoteEnd(text, at) - 1;
    } else if (c == '(' || c == '[') {
      ++depth;
    } else if (c == ')' || c == ']') {
      --depth;
    } else if (c == ',' && depth <= 0) {
      arguments.push_back(TrimBlanks(text.substr(begin, at - begin)));
      begin = at + 1;
    }
  }
  arguments.push_back(TrimBlanks(text.substr(begin)));
  return arguments;
}

std::string Expand(std::string_view line, const Macro& macro, const std::vector<std::string_view>& arguments,
                   uint32_t number, const std::function<std::string(std::string_view)>& fold) {
  std::string text;
  bool joins = false;  // a parameter ends here: a '&' after it joins
  for (size_t at = 0; at < line.size() && text.size() <= kExpandedLineBytes;) {
    const char c = line[at];
    if (c == ';') break;
    size_t end = at + 1;
    if (c == '\'' || c == '"') {
      end = QuoteEnd(line, at);
      text += line.substr(at, end - at);
      joins = false;
    } else if (IsNameCharacter(c)) {
      while (end < line.size() && IsNameCharacter(line[end])) ++end;
      const std::string word = fold(line.substr(at, end - at));
      const auto parameter = std::ranges::find(macro.parameters, word);
      joins = parameter != macro.parameters.end();
      if (joins) {
        if (text.ends_with('&')) text.pop_back();
        const auto index = static_cast<size_t>(parameter - macro.parameters.begin());
        if (index < arguments.size()) text += arguments[index];
      } else {
        text += line.substr(at, end - at);
        if (std::ranges::find(macro.locals, word) != macro.locals.end()) {
          text += std::string(kLocalMark) + std::to_string(number);
        }
      }
    } else {
      if (c != '&' || !joins) text += c;
      joins = false;
    }
    at = end;
  }
  return text;
}

std::string_view WrittenName(std::string_view name) {
  const size_t mark = name.rfind(kLocalMark);
  const bool local =
      mark != std::string_view::npos && mark > 0 && mark + kLocalMark.size() < name.size() &&
      std::all_of(name.begin() + static_cast<std::ptrdiff_t>(mark + kLocalMark.size()), name.end(), IsDigit);
  return local ? name.substr(0, mark) : name;
}

}  // namespace plcxx::technol
