#include "transpiler/dialects/technol/parser/macro_reader.h"

#include "transpiler/dialects/technol/source/token_reader.h"

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

/// Does the line begin or end a part of the program? No macro does.
bool BeginsPart(std::string_view upper) {
  return upper == "DATA" || upper == "DATA_END" || upper == "STOP" || upper.starts_with("MODULE_") ||
         upper.starts_with("PRIPRAVNE_FUNKCE") || upper.starts_with("ZAVERECNE_FUNKCE");
}

}  // namespace

void MacroReader::OpenMacro(const Statement& statement) {
  const Token& name = statement.first();
  WarnOfCompletion(statement.words[1]);
  if (CurrentUnit().valid()) {
    context_.Report(statement.range, diag::TechnolStrayLine, context_.sources.Text(statement.range),
                    "stands outside modules and mechanisms");
  }
  open_.emplace();
  open_->name = name.text;
  open_->range = name.range;
  if (auto parameters = ReadNames(statement.words.subspan(2), context_)) open_->parameters = std::move(*parameters);
  const SymbolId known = context_.names.Find(name.text);
  if (known.valid() && context_.names[known].kind == SymbolKind::kMacro && context_.names[known].range == name.range) {
    open_->symbol = known;  // its file is included again
  } else {
    open_->symbol = context_.Define(name, {.kind = SymbolKind::kMacro});
  }
  open_->faulty = context_.faulty;
  comments_.TakeComments(statement);
}

void MacroReader::ReadLine(std::string_view text, std::span<const Token> tokens, const LinePlace& place) {
  if (!tokens.empty() && tokens.back().kind == TokenKind::kComment) tokens = tokens.first(tokens.size() - 1);
  if (tokens.empty()) return;
  const Token& first = tokens.front();
  if (Means(first.text, "ENDM")) {
    WarnOfCompletion(first);
    if (tokens.size() > 1) context_.Report(tokens[1].range, diag::TechnolSurplus, Shown(&tokens[1]), first.text);
    return Close();
  }
  if (Means(first.text, "LOCAL") && !open_->in_body) {
    WarnOfCompletion(first);
    const std::optional<std::vector<std::string>> names = ReadNames(tokens.subspan(1), context_);
    if (names && names->empty()) context_.Report(first.range, diag::TechnolOperandMissing, "LOCAL", "names");
    if (names) open_->locals.insert(open_->locals.end(), names->begin(), names->end());
    open_->faulty |= context_.faulty;
    return;
  }
  if (tokens.size() == 3 && tokens[1].text == ":" && Means(tokens[2].text, "ENDM")) {
    context_.Report(tokens[2].range, diag::TechnolStrayLineHint, tokens[2].text, "stands behind a label",
                    "end the line behind the label, and write ENDM on the next one");
    open_->faulty = true;
    return Close();
  }
  if (!open_->foreign && BeginsPart(Upper(first.text))) open_->foreign = first.range;
  if (tokens.size() > 1 && Means(tokens[1].text, "MACRO")) {
    context_.Report(first.range, diag::TechnolStrayLine,
                    context_.sources.Text({first.range.begin, tokens[1].range.end}),
                    "stands inside macro '" + open_->name + "'");
    open_->faulty = true;
    return;
  }
  open_->in_body = true;
  source::Range range = {first.range.begin, tokens.back().range.end};
  if (place.call.begin != place.call.end) range = place.call;
  open_->lines.push_back({.text = text, .range = range});
}

void MacroReader::Close() {
  Macro macro = std::move(*open_);
  open_.reset();
  const SymbolId symbol = macro.symbol;
  if (symbol.valid()) macros_.try_emplace(symbol, std::move(macro));  // included again: the same
}

void MacroReader::LeaveOpenMacro() {
  if (!open_) return;
  diag::Diagnostic& diagnostic =
      context_.Report(open_->foreign.value_or(open_->range), diag::TechnolStrayLineHint, open_->name + " MACRO",
                      "has no ENDM", "write ENDM behind the last line of the macro");
  if (open_->foreign) diagnostic.notes.push_back({open_->range, "it was opened here"});
  now_.lost_lines = open_->foreign.has_value();
  open_.reset();
}

const Macro* MacroReader::Find(SymbolId symbol) const {
  const auto found = macros_.find(symbol);
  return found == macros_.end() ? nullptr : &found->second;
}

std::optional<MacroCall> MacroReader::BeginCall(const Statement& statement, const Macro& called) {
  ++context_.names[called.symbol].uses;
  if (called.faulty || full_) {
    context_.Forgive();
    return std::nullopt;
  }
  const Token& name = statement.first();
  const char* behind = name.text.data() + name.text.size();
  const Token& last = statement.words.back();
  const std::string_view rest(behind, static_cast<size_t>(last.text.data() + last.text.size() - behind));
  MacroCall call{.macro = called, .arguments = SplitArguments(rest), .outer = context_.expansion};
  if (call.arguments.size() > called.parameters.size()) {
    context_.Report(statement.range, diag::TechnolTooManyArguments, name.text,
                    static_cast<int64_t>(call.arguments.size()), static_cast<int64_t>(called.parameters.size()));
    return std::nullopt;
  }
  if (depth_ >= kMacroDepth) {
    context_.Report(statement.range, diag::TechnolMacroDepth, name.text);
    return std::nullopt;
  }
  if (statement.label != nullptr) {
    if (!IsCodePlace(statement)) return std::nullopt;
    code_.DefineLabel(*statement.label);
  }
  comments_.AddComment(statement, CommentPlace::kTrailing);
  call.range = call.outer.valid() ? context_.program.expansions[call.outer].call : statement.range;
  call.number = ++call_count_;
  ++depth_;
  return call;
}

std::optional<std::string_view> MacroReader::ExpandNextLine(MacroCall& call) {
  context_.expansion = call.outer;
  if (full_ || call.next == call.macro.lines.size()) return std::nullopt;
  context_.BeginStatement(context_.statement, call.outer);
  const MacroLine& line = call.macro.lines[call.next++];
  texts_.push_back(Expand(line.text, call.macro, call.arguments, call.number,
                          [this](std::string_view word) { return context_.names.Fold(word); }));
  const std::string& text = texts_.back();
  if (++line_count_ > kExpandedLines || text.size() > kExpandedLineBytes) {
    context_.Report(call.range, diag::TechnolMacroSize, call.macro.name);
    full_ = true;
    return std::nullopt;
  }
  context_.expansion = context_.program.expansions.Add({.call = call.range,
                                                        .outer = call.outer,
                                                        .body = line.range,
                                                        .text = std::string(TrimBlanks(text)),
                                                        .macro = call.macro.name});
  return text;
}

void MacroReader::EndCall(const MacroCall& call) {
  --depth_;
  context_.BeginStatement(context_.statement, call.outer);
}

}  // namespace plcxx::technol
