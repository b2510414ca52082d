#include <algorithm>

#include "transpiler/dialects/technol/parser/internal.h"

namespace plcxx::technol {
namespace {

/// The names after MACRO or LOCAL, separated by commas; none when one is no name (reported).
std::optional<std::vector<std::string>> ReadNames(std::span<const Token> words, ParsingContext& context) {
  std::vector<std::string> names;
  TokenReader reader(words);
  if (reader.AtEnd()) return names;
  do {
    if (!reader.IsKind(TokenKind::kWord)) {
      context.Report(reader.Here(), diag::TechnolSyntax, Shown(reader.Peek()), "a name");
      return std::nullopt;
    }
    const Token& name = reader.Take();
    if (!context.IsName(name)) return std::nullopt;
    names.push_back(context.names.Fold(name.text));
  } while (reader.TakePunctuation(','));
  if (reader.AtEnd()) return names;
  context.Report(reader.Here(), diag::TechnolSyntax, Shown(reader.Peek()), "','");
  return std::nullopt;
}

}  // namespace

void Parser::WarnOfCompletion(const Token& word) {
  if (context_.settings.evidence != EvidenceRule::kStrict) return;
  context_.Report(word.range, diag::TechnolCompletion, word.text);
}

/// name MACRO [parameters]
void Parser::OpenMacro(const Statement& statement) {
  const Token& name = statement.first();
  WarnOfCompletion(statement.words[1]);
  if (CurrentUnit().valid()) {
    context_.Report(statement.range, diag::TechnolStrayLine, context_.sources.Text(statement.range),
                    "stands outside modules and mechanisms");
  }
  macro_.emplace();
  macro_->name = name.text;
  macro_->range = name.range;
  if (auto parameters = ReadNames(statement.words.subspan(2), context_)) macro_->parameters = std::move(*parameters);
  const SymbolId known = context_.names.Find(name.text);
  if (known.valid() && context_.names[known].kind == SymbolKind::kMacro && context_.names[known].range == name.range) {
    macro_->symbol = known;  // its file is included again
  } else {
    macro_->symbol = context_.Define(name, {.kind = SymbolKind::kMacro});
  }
  macro_->faulty = context_.faulty;
  TakeComments(statement);
}

/// A line between MACRO and ENDM: kept as it is.
void Parser::TakeMacroLine(std::string_view text, std::span<const Token> tokens, const LinePlace& place) {
  if (!tokens.empty() && tokens.back().kind == TokenKind::kComment) tokens = tokens.first(tokens.size() - 1);
  if (tokens.empty()) return;
  const Token& first = tokens.front();
  if (Means(first.text, "ENDM")) {
    WarnOfCompletion(first);
    if (tokens.size() > 1) context_.Report(tokens[1].range, diag::TechnolSurplus, Shown(&tokens[1]), first.text);
    Macro macro = std::move(*macro_);
    macro_.reset();
    const SymbolId symbol = macro.symbol;
    if (symbol.valid()) macros_.try_emplace(symbol, std::move(macro));  // included again: the same
    return;
  }
  if (Means(first.text, "LOCAL") && !macro_->in_body) {
    WarnOfCompletion(first);
    const std::optional<std::vector<std::string>> names = ReadNames(tokens.subspan(1), context_);
    if (names && names->empty()) context_.Report(first.range, diag::TechnolOperandMissing, "LOCAL", "names");
    if (names) macro_->locals.insert(macro_->locals.end(), names->begin(), names->end());
    macro_->faulty |= context_.faulty;
    return;
  }
  if (tokens.size() > 1 && Means(tokens[1].text, "MACRO")) {
    context_.Report(first.range, diag::TechnolStrayLine,
                    context_.sources.Text({first.range.begin, tokens[1].range.end}),
                    "stands inside macro '" + macro_->name + "'");
    macro_->faulty = true;
    return;
  }
  macro_->in_body = true;
  source::Range range = {first.range.begin, tokens.back().range.end};
  if (place.call.begin != place.call.end) range = place.call;
  macro_->lines.push_back({.text = text, .range = range});
}

/// The file ends inside of a macro.
void Parser::FinishMacro() {
  context_.Report(macro_->range, diag::TechnolStrayLine, macro_->name + " MACRO", "has no ENDM");
  macro_.reset();
}

void Parser::CallMacro(const Statement& statement, const Macro& called, const Token& name) {
  ++context_.names[called.symbol].uses;
  if (called.faulty || expansion_full_) return context_.Forgive();
  const char* behind = name.text.data() + name.text.size();
  const Token& last = statement.words.back();
  const std::string_view rest(behind, static_cast<size_t>(last.text.data() + last.text.size() - behind));
  const std::vector<std::string_view> arguments = SplitArguments(rest);
  if (arguments.size() > called.parameters.size()) {
    context_.Report(statement.range, diag::TechnolTooManyArguments, name.text, static_cast<int64_t>(arguments.size()),
                    static_cast<int64_t>(called.parameters.size()));
    return;
  }
  if (macro_depth_ >= kMacroDepth) {
    context_.Report(statement.range, diag::TechnolMacroDepth, name.text);
    return;
  }
  if (statement.label != nullptr) {
    if (!IsCodePlace(statement)) return;
    DefineLabel(*statement.label);
  }
  if (statement.comment != nullptr) AddComment(*statement.comment, CommentPlace::kTrailing);

  const ExpansionId outer = context_.expansion;
  const source::Range call = outer.valid() ? context_.program.expansions[outer].call : statement.range;
  const uint32_t number = ++expansion_count_;
  ++macro_depth_;
  for (const MacroLine& line : called.lines) {
    context_.BeginStatement(statement_number_, outer);
    expanded_texts_.push_back(Expand(line.text, called, arguments, number,
                                     [this](std::string_view word) { return context_.names.Fold(word); }));
    const std::string& text = expanded_texts_.back();
    if (++expanded_lines_ > kExpandedLines || text.size() > kExpandedLineBytes) {
      if (!expansion_full_) context_.Report(call, diag::TechnolMacroSize, called.name);
      expansion_full_ = true;
      break;
    }
    context_.expansion = context_.program.expansions.Add({.call = call,
                                                          .outer = outer,
                                                          .body = line.range,
                                                          .text = std::string(TrimBlanks(text)),
                                                          .macro = called.name});
    TakeLine(text, {.call = call});
    context_.expansion = outer;
    if (expansion_full_) break;
  }
  --macro_depth_;
  context_.BeginStatement(statement_number_, outer);
}

}  // namespace plcxx::technol
