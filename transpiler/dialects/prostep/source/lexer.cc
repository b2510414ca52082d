#include "transpiler/dialects/prostep/source/lexer.h"

#include <algorithm>
#include <iterator>

#include "transpiler/dialects/prostep/source/lexer_internal.h"

namespace plcxx::prostep {
namespace {

constexpr std::string_view kDeclarations[] = {"DDB", "DDW", "DDD", "DMF", "DM", "DT"};  // the longest first

/// The declaration that begins in column 1, or after the blanks that the caller has taken away; empty when none does.
std::string_view DeclarationWord(std::string_view text) {
  const std::string upper = Upper(text.substr(0, 3));
  const auto word = std::ranges::find_if(kDeclarations, [&](std::string_view w) { return upper.starts_with(w); });
  return word == std::end(kDeclarations) ? std::string_view() : *word;
}

/// A mnemonic, a blank or a digit directly after it, and a number that no colon follows (rule 3 of 2.1).
bool IsDeclaration(std::string_view text) {
  const size_t word = DeclarationWord(text).size();
  if (word == 0 || word >= text.size() || (!IsBlank(text[word]) && !IsDigit(text[word]))) return false;
  const size_t digits = text.find_first_not_of(" \t", word);
  if (digits == std::string_view::npos || !IsDigit(text[digits])) return false;
  const size_t behind = std::min(text.find_first_not_of("0123456789", digits), text.size());
  const size_t next = text.find_first_not_of(" \t", behind);
  return next == std::string_view::npos || text[next] != ':';
}

bool IsStatement(std::string_view text) {
  const size_t first = text.find_first_of(":;*");
  return first != std::string_view::npos && text[first] == ':';
}

LineKind Classify(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return LineKind::kBlank;
  if (text[first] == '%') return LineKind::kHeader;
  if (text[first] == ';' || text[first] == '*') return LineKind::kComment;
  if (IsDeclaration(text)) return LineKind::kDeclaration;
  return IsStatement(text) ? LineKind::kStatement : LineKind::kComment;
}

class FileLexer {
 public:
  FileLexer(const source::SourceManager& sources, source::FileId file, diag::Engine& diagnostics)
      : sources_(sources), file_(file), diagnostics_(diagnostics) {}

  LexedFile Run() {
    const source::File& file = sources_.Get(file_);
    for (const uint32_t at : file.replaced) {
      constexpr source::Offset kReplacementBytes = 3;  // U+FFFD
      const source::Offset begin = file.base + at;
      diagnostics_.Report({begin, begin + kReplacementBytes}, diag::ProstepUndecodable, source::Name(file.encoding));
    }
    const uint32_t count = sources_.LineCount(file_);
    lexed_.lines.reserve(count);
    lexed_.tokens.reserve(count * size_t{4});
    for (uint32_t i = 0; i < count; ++i) {
      TakeLine(sources_.Line(file_, i + 1), file.base + file.line_starts[i]);
    }
    return std::move(lexed_);
  }

 private:
  void TakeLine(std::string_view text, source::Offset begin) {
    Line line{.kind = Classify(text),
              .range = {begin, begin + static_cast<source::Offset>(text.size())},
              .tokens = {.first = static_cast<uint32_t>(lexed_.tokens.size())}};
    LineLexer lexer(text, begin, sources_.Get(file_), lexed_.tokens, diagnostics_);
    switch (line.kind) {
      case LineKind::kBlank:
        break;
      case LineKind::kHeader:
        lexer.Whole(TokenKind::kHeader);
        if (!at_beginning_) {
          const Token& header = lexed_.tokens.back();
          diagnostics_.Report(header.range, diag::ProstepHeader, sources_.Text(header.range));
        }
        break;
      case LineKind::kComment:
        lexer.Whole(TokenKind::kComment);
        at_beginning_ &= IsMarked(TrimBlanks(text));
        WarnOfDeclaration(text);
        break;
      case LineKind::kDeclaration:
        lexer.Declaration(DeclarationWord(text));
        at_beginning_ = false;
        break;
      case LineKind::kStatement:
        lexer.Statement();
        at_beginning_ = false;
        break;
    }
    line.tokens.count = static_cast<uint32_t>(lexed_.tokens.size()) - line.tokens.first;
    lexed_.lines.push_back(line);
  }

  /// A comment that would be a declaration in column 1, or with a number; an instruction with a colon.
  void WarnOfDeclaration(std::string_view text) {
    const std::string_view trimmed = TrimBlanks(text);
    const source::Range range = lexed_.tokens.back().range;
    if (IsBlank(text.front()) && IsDeclaration(trimmed)) {
      diagnostics_.Report(range, diag::ProstepDeclarationIndented, trimmed);
      return;
    }
    if (!IsMarked(trimmed) && LooksLikeInstruction(trimmed)) {
      diagnostics_.Report(range, diag::ProstepColonForgotten, trimmed);
      return;
    }
    if (IsBlank(text.front())) return;
    const size_t word = DeclarationWord(text).size();
    if (word != 0 && (text.size() == word || IsBlank(text[word]))) {
      diagnostics_.Report(range, diag::ProstepDeclarationWithoutNumber, trimmed);
    }
  }

  const source::SourceManager& sources_;
  source::FileId file_;
  diag::Engine& diagnostics_;
  LexedFile lexed_;
  bool at_beginning_ = true;  // only blank lines, marked comments and headers so far
};

/// ':MOD PM n' in any case and spacing; what stands after the number is free.
bool OpensModule(std::string_view text) {
  const std::string upper = Upper(TrimBlanks(text));
  std::string_view rest = upper;
  const auto take = [&rest](std::string_view word) {
    rest = TrimBlanks(rest);
    if (!rest.starts_with(word)) return false;
    rest.remove_prefix(word.size());
    return true;
  };
  if (!take(":") || !take("MOD") || rest.empty() || !IsBlank(rest.front())) return false;
  if (!take("PM")) return false;
  rest = TrimBlanks(rest);
  return !rest.empty() && IsDigit(rest.front());
}

}  // namespace

std::string_view Name(TokenKind kind) {
  switch (kind) {
    case TokenKind::kHeader:
      return "header";
    case TokenKind::kComment:
      return "comment";
    case TokenKind::kDeclaration:
      return "declaration";
    case TokenKind::kSwitch:
      return "switch";
    case TokenKind::kText:
      return "text";
    case TokenKind::kLabel:
      return "label";
    case TokenKind::kColon:
      return "colon";
    case TokenKind::kMnemonic:
      return "mnemonic";
    case TokenKind::kModuleMark:
      return "module";
    case TokenKind::kUnknown:
      return "unknown";
    case TokenKind::kClass:
      return "operand";
    case TokenKind::kNumber:
      return "number";
    case TokenKind::kTarget:
      return "target";
    case TokenKind::kJunk:
      return "junk";
  }
  PLCXX_UNREACHABLE();
}

LexedFile Lex(const source::SourceManager& sources, source::FileId file, diag::Engine& diagnostics) {
  return FileLexer(sources, file, diagnostics).Run();
}

bool Recognize(std::string_view text) {
  text = text.substr(0, text.find_first_of("\x03\x1A"));
  while (!text.empty()) {
    const size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    if (Classify(line) == LineKind::kStatement) return OpensModule(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

}  // namespace plcxx::prostep
