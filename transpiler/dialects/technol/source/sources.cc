#include "transpiler/dialects/technol/source/sources.h"

#include <algorithm>

#include "transpiler/dialects/technol/source/lexer.h"

namespace plcxx::technol {
namespace {

constexpr source::Encoding kEncodings[] = {source::Encoding::kUtf8, source::Encoding::kCp852,
                                           source::Encoding::kKamenicky, source::Encoding::kCp1250};

}  // namespace

const source::LoadOptions& SourceOptions() {
  static const source::LoadOptions options = {.encodings = kEncodings,
                                              .choice = source::Choice::kUnlessUtf8,
                                              .detection = source::Detection::kFallback,
                                              .fallback = source::Encoding::kCp852,
                                              .undecodable = source::Undecodable::kOneWarningPerFile,
                                              .line_ends = source::LineEnds::kLfCrLfOrCr,
                                              .end_marks = "\x1A"};
  return options;
}

bool IsTable(std::string_view path) { return path.size() > 4 && Means(path.substr(path.size() - 4), ".TCH"); }

void ReportLoadError(const std::string& path, const source::LoadError& error, diag::Engine& diagnostics) {
  if (IsTable(path)) {
    diagnostics.Report({}, diag::TechnolTableEmpty, path, error.detail.empty() ? "" : ": " + error.detail);
  } else {
    diagnostics.Report({}, diag::CannotReadSource, path, error.detail, source::RemedyOf(error.problem));
  }
}

bool Recognize(std::string_view text) {
  if (text.find("$TCH") != std::string_view::npos) return true;
  while (!text.empty()) {
    const size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::vector<Token> tokens;
    LexLine(text.substr(0, end), {.begin = 1}, tokens);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (tokens.empty() || tokens[0].kind != TokenKind::kWord) continue;
    const bool label = tokens.size() > 2 && tokens[1].text == ":";
    const std::string word = Upper(tokens[label ? 2 : 0].text);
    const size_t words = tokens.size() - (label ? 2 : 0) - (tokens.back().kind == TokenKind::kComment ? 1 : 0);
    if (word == "T_INCLUDE" || (word == "MECH_BEGIN" && words == 2)) return true;
    const bool alone = words == 1;
    if (alone && (word == "DATA_END" || word == "PRIPRAVNE_FUNKCE" || word == "ZAVERECNE_FUNKCE" ||
                  (word.starts_with("MODULE_") && word.size() > 7))) {
      return true;
    }
  }
  return false;
}

}  // namespace plcxx::technol
