#include "transpiler/dialects/technol/parser/parser.h"

#include <algorithm>

#include "transpiler/dialects/technol/parser/internal.h"
#include "transpiler/source/find_file.h"

namespace plcxx::technol {
namespace {

constexpr std::string_view kAllocations[] = {"DB", "DW", "DD", "DS", "DFM"};

/// DB?, DW?, DD?: typed without the blank.
bool IsGlued(std::string_view upper) { return upper == "DB?" || upper == "DW?" || upper == "DD?"; }

bool IsAllocation(std::string_view upper) {
  return std::ranges::find(kAllocations, upper) != std::end(kAllocations) || IsGlued(upper);
}

std::string UpperWord(std::span<const Token> words, size_t index) {
  return index < words.size() && words[index].kind == TokenKind::kWord ? Upper(words[index].text) : std::string();
}

/// MODULE_MAIN, MODULE_X ...; none when `upper` opens no module.
std::optional<ModuleKind> ModuleByKeyword(std::string_view upper) {
  for (const ModuleInfo& info : Modules()) {
    if (info.kind != ModuleKind::kOther && info.keyword == upper) return info.kind;
  }
  if (upper.starts_with("MODULE_") && upper.size() > Info(ModuleKind::kOther).keyword.size()) return ModuleKind::kOther;
  return std::nullopt;
}

/// Does the second word define the first one, whatever that is? DB and the like may be operands: MOV DS,CX.
bool NamesDefinition(std::span<const Token> words) {
  const std::string second = UpperWord(words, 1);
  return second == "EQU" || second == "STRUC" || second == "STRUCT" || second == "MACRO" ||
         (words.size() > 1 && words[1].text == "=");
}

}  // namespace

Program Parser::Run() {
  AddControlSymbols();
  AddControlStructures();
  AddSignalFile();
  TakeTables();
  Program& program = context_.program;
  program.tables_only = sources_.empty();
  last_source_ = program.tables_only ? request_.files.back() : sources_.back();
  for (const source::FileId file : sources_) TakeSource(file);
  if (!program.tables_only) CheckWhole();

  const auto base = static_cast<uint32_t>(code_.size());
  const UnitId area = program.units.Add({.kind = UnitKind::kSubprograms,
                                         .file = last_source_,
                                         .first = InstructionId(base),
                                         .end = InstructionId(base + static_cast<uint32_t>(subprograms_.size()))});
  for (Pending& pending : subprograms_) {
    pending.instruction.unit = area;
    code_.push_back(pending);
  }
  for (Label& label : program.labels) {
    if (label.unit.valid()) continue;
    label.unit = area;
    label.at.index += base;
  }
  program.instructions.Reserve(code_.size());
  for (const Pending& pending : code_) {
    program.instructions.Add(pending.instruction);
    program.statement_count += pending.mnemonic.count;
  }
  ReadOperands(code_, code_tokens_, context_);
  WarnOfUnused();
  return std::move(context_.program);
}

void Parser::TakeSource(source::FileId file) {
  file_has_items_ = false;
  stopped_ = false;
  including_ = {source::FileIdentity(context_.sources.Get(file).path)};
  TakeLines(file);
  EndOfSource(file);
}

void Parser::TakeLines(source::FileId file) {
  const source::FileId outer = file_;
  file_ = file;
  context_.program.files.push_back({.file = file});
  const uint32_t count = context_.sources.LineCount(file);
  context_.program.line_count += count;
  for (uint32_t i = 0; i < count; ++i) {
    const source::File& text = context_.sources.Get(file);
    TakeLine(context_.sources.Line(file, i + 1), {.begin = text.base + text.line_starts[i]});
  }
  file_ = outer;
}

void Parser::TakeLine(std::string_view text, const LinePlace& place) {
  std::vector<Token> tokens;
  LexLine(text, place, tokens);
  context_.BeginStatement(++statement_number_, context_.expansion);
  const bool in_file = place.call.begin == place.call.end;
  if (in_file && text.size() > kLineBytes) {
    // One byte a character in the encodings of DOS and Windows.
    const bool utf8 = context_.sources.Get(file_).encoding == source::Encoding::kUtf8;
    const auto starts = std::ranges::count_if(text, [](char c) { return (static_cast<uint8_t>(c) & 0xC0U) != 0x80U; });
    const auto length = utf8 ? static_cast<int64_t>(text.size()) : starts;
    if (length > kLineBytes) {
      context_.Report({place.begin, place.begin + static_cast<source::Offset>(text.size())}, diag::TechnolLongLine,
                      length);
    }
  }
  if (macro_) return TakeMacroLine(text, tokens, place);

  Statement statement{.line = text};
  std::span<const Token> words = tokens;
  if (!words.empty() && words.back().kind == TokenKind::kComment) {
    if (in_file) statement.comment = &words.back();
    words = words.first(words.size() - 1);
  }
  if (words.empty()) {
    if (!in_file) return;
    return tokens.empty() ? TakeBlankLine() : AddComment(*statement.comment, CommentPlace::kLeading);
  }
  const source::Range whole = {words.front().range.begin, words.back().range.end};
  if (stopped_) {
    if (!warned_behind_stop_) context_.Report(whole, diag::TechnolBehindStop, TrimBlanks(context_.sources.Text(whole)));
    warned_behind_stop_ = true;
    return;
  }
  if (!CheckTokens(words)) return KeepFaultyLine(statement, words);
  file_has_items_ = true;
  if (words.size() > 1 && words[0].kind == TokenKind::kWord && words[1].text == ":") {
    statement.label = words.data();
    words = words.subspan(2);
  }
  statement.words = words;
  statement.range =
      words.empty() ? statement.label->range : source::Range{words.front().range.begin, words.back().range.end};
  statement.upper = UpperWord(words, 0);
  TakeStatement(statement);
}

namespace {

/// What a character of other languages is in this one, as a remedy; empty: nobody knows.
std::string_view MeantByCharacter(std::string_view character) {
  if (character == "#") return "a constant is written CNST.5, a hexadecimal number 0FFh";
  if (character == "%") return "bits and cells have the names that DATA gives them, without '%'";
  if (character == "!" || character == "~") return "the negated bit is -NAME";
  if (character == "|") return "bits are combined by LO, data by OR";
  if (character == "{" || character == "}") return "a comment begins with ';'";
  return {};
}

}  // namespace

/// Characters and continuations; a statement that has them is not looked at.
bool Parser::CheckTokens(std::span<const Token> tokens) {
  for (const Token& token : tokens) {
    if (token.kind == TokenKind::kWord) context_.IsShort(token);
    if (token.kind == TokenKind::kInvalid || token.kind == TokenKind::kString || token.kind == TokenKind::kQuoted ||
        token.kind == TokenKind::kPath) {
      const auto bad = std::ranges::find_if(token.text, [](char c) {
        const auto byte = static_cast<uint8_t>(c);
        return byte >= 0x80U || byte < ' ' || byte == 0x7FU;
      });
      if (token.kind != TokenKind::kInvalid && bad == token.text.end()) continue;
      const std::string_view character =
          token.kind == TokenKind::kInvalid ? token.text : std::string_view(bad, token.text.end());
      const std::string_view shown = character.substr(0, CharacterBytes(character));
      const bool printable = static_cast<uint8_t>(shown.front()) >= ' ' && shown.front() != '\x7F';
      const std::string picture = printable ? "'" + std::string(shown) + "'" : "code";
      const std::string_view meant = MeantByCharacter(shown);
      if (meant.empty()) {
        context_.Report(token.range, diag::TechnolCharacter, picture, CodePointName(character));
      } else {
        context_.Report(token.range, diag::TechnolCharacterHint, picture, CodePointName(character), meant);
      }
      return false;
    }
  }
  const Token& last = tokens.back();
  if (last.kind == TokenKind::kPunctuation && (last.text == "\\" || last.text == "&")) {
    context_.Report(last.range, diag::TechnolContinuation, last.text);
    return false;
  }
  return true;
}

void Parser::TakeStatement(Statement& statement) {
  if (structure_) return TakeField(statement);
  if (statement.words.empty()) {
    if (IsCodePlace(statement)) DefineLabel(*statement.label);
    if (statement.comment != nullptr) AddComment(*statement.comment, CommentPlace::kLeading);
    return;
  }
  if (statement.upper.empty()) {
    if (statement.first().kind == TokenKind::kOpenString) {
      context_.Report(statement.first().range, diag::TechnolStringOpen, statement.first().text);
    } else {
      context_.Report(statement.first().range, diag::TechnolSyntax, Shown(&statement.first()), "an instruction");
    }
    return;
  }
  if (TakeDirective(statement)) return;
  const Op op = OpByMnemonic(statement.upper);
  if (op != Op::kUnknown && !NamesDefinition(statement.words)) return TakeInstruction(statement, op);
  if (TakeDefinition(statement)) return;
  UnknownLine(statement);
}

/// A statement whose first word tells what it is.
bool Parser::TakeDirective(const Statement& statement) {
  const std::string& word = statement.upper;
  if (word == "TITLE" || word == "PAGE" || word == "SUBTTL" || word == "NAME") {
    if (in_data_ || CurrentUnit().valid())
      context_.Report(statement.range, diag::TechnolStrayLine, word, "stands outside modules and data");
  } else if (word == "T_INCLUDE") {
    TakeInclude(statement);
  } else if (word == "INCLUDE") {
    TakeSystemHeader(statement);
  } else if (word == "DATA") {
    OpenData(statement);
  } else if (word == "DATA_END" || word == "START") {
    CloseData(statement);
  } else if (word == "STOP") {
    TakeStop(statement);
  } else if (word == "EQUI") {
    TakeEqui(statement);
  } else if (word == "MECH_BEGIN") {
    OpenMechanism(statement);
  } else if (word == "MECH_END") {
    CloseMechanism(statement);
  } else if (IsAllocation(word)) {
    TakeAllocation(statement, statement.label, 0);
  } else if (word == "ENDM" || word == "LOCAL") {
    context_.Report(statement.range, diag::TechnolStrayLine, word, "stands in a macro only");
  } else if (word.ends_with("_END") && ModuleByKeyword(word.substr(0, word.size() - 4))) {
    CloseModule(statement, std::string_view(word).substr(0, word.size() - 4));
  } else if (const auto kind = ModuleByKeyword(word)) {
    OpenModule(statement, *kind);
  } else {
    return false;
  }
  return true;
}

/// A statement whose second word tells what it is, a macro's call, or an instance of a structure.
bool Parser::TakeDefinition(const Statement& statement) {
  const std::string second = UpperWord(statement.words, 1);
  const bool assignment = statement.words.size() > 1 && statement.words[1].text == "=";
  const bool definition = assignment || second == "EQU" || second == "STRUC" || second == "STRUCT" ||
                          second == "ENDS" || second == "MACRO" || IsAllocation(second);
  if (definition && statement.label != nullptr) {
    context_.Report(statement.label->range, diag::TechnolSurplus, "label '" + std::string(statement.label->text) + "'",
                    statement.words[1].text);
    return true;
  }
  if (assignment) {
    AssignConstant(statement.first(), statement.words.subspan(2));
  } else if (second == "EQU") {
    WarnOfCompletion(statement.words[1]);
    DefineConstant(statement.first(), statement.words.subspan(2));
  } else if (second == "STRUC" || second == "STRUCT") {
    OpenStructure(statement);
  } else if (second == "ENDS") {
    CloseStructure(statement);
  } else if (second == "MACRO") {
    OpenMacro(statement);
  } else if (definition) {
    TakeAllocation(statement, &statement.first(), 1);
  } else {
    return false;
  }
  if (assignment || second == "EQU") {
    const SymbolId symbol = context_.names.Find(statement.first().text);
    if (symbol.valid() && context_.names[symbol].comments.count == 0) {
      context_.names[symbol].comments = TakeComments(statement);
    }
  }
  return true;
}

void Parser::UnknownLine(const Statement& statement) {
  const Token& first = statement.first();
  const SymbolId symbol = context_.names.Find(first.text);
  if (symbol.valid()) {
    if (const auto macro = macros_.find(symbol); macro != macros_.end())
      return CallMacro(statement, macro->second, first);
    if (structures_.contains(symbol)) return TakeInstance(statement, statement.label, 0);
  }
  const Token* second = statement.words.size() > 1 ? &statement.words[1] : nullptr;
  if (second != nullptr && second->kind == TokenKind::kWord) {
    const SymbolId structure = context_.names.Find(second->text);
    if (structure.valid() && structures_.contains(structure)) {
      if (statement.label == nullptr) return TakeInstance(statement, &first, 1);
      context_.Report(first.range, diag::TechnolSurplus, Shown(&first), statement.label->text);
      return;
    }
  }
  if (statement.upper == "EQU" || statement.upper == "STRUC" || statement.upper == "STRUCT" ||
      statement.upper == "ENDS" || statement.upper == "MACRO") {
    context_.Report(first.range, diag::TechnolStrayLine, first.text, "needs a name in front of it");
  } else if (statement.upper == "LEA") {
    context_.Report(first.range, diag::TechnolSegments, first.text);
    KeepUnknown(statement);
  } else if (IsForeignInstruction(statement.upper)) {
    const std::string_view meant = ForeignHint(statement.upper);
    if (meant.empty()) {
      context_.Report(first.range, diag::TechnolForeignInstruction, first.text);
    } else {
      context_.Report(first.range, diag::TechnolForeignInstructionHint, first.text, meant);
    }
    KeepUnknown(statement);
  } else if (symbol.valid() && context_.names[symbol].faulty) {
    context_.Forgive();
  } else if (IsReserved(statement.upper)) {
    context_.Report(first.range, diag::TechnolSyntax, Shown(&first), "an instruction");
  } else {
    const std::string_view meant = ForeignHint(statement.upper);
    const std::string_view near = NearMnemonic(statement.upper);
    const bool is_label = second != nullptr && second->kind == TokenKind::kWord && statement.label == nullptr &&
                          OpByMnemonic(UpperWord(statement.words, 1)) != Op::kUnknown;
    if (is_label) {
      context_.Report(first.range, diag::TechnolUnknownInstructionForeign, first.text,
                      "a label ends with ':': " + std::string(first.text) + ":");
    } else if (!meant.empty()) {
      context_.Report(first.range, diag::TechnolUnknownInstructionForeign, first.text, meant);
    } else if (near.empty()) {
      context_.Report(first.range, diag::TechnolUnknownInstruction, first.text);
    } else {
      context_.Report(first.range, diag::TechnolUnknownInstructionNear, first.text, near);
    }
    KeepUnknown(statement);
  }
}

/// A statement with a bad character: what it would load is not missed after it.
void Parser::KeepFaultyLine(Statement& statement, std::span<const Token> words) {
  if (words.size() > 2 && words[0].kind == TokenKind::kWord && words[1].text == ":") words = words.subspan(2);
  const std::string upper = UpperWord(words, 0);
  if (structure_ || OpByMnemonic(upper) == Op::kUnknown) return;
  statement.words = words;
  statement.range = {words.front().range.begin, words.back().range.end};
  statement.upper = upper;
  KeepUnknown(statement);
}

/// Something stands here: what it would load is not missed after it.
void Parser::KeepUnknown(const Statement& statement) {
  if (!in_data_ && including_.size() == 1) TakeInstruction(statement, Op::kUnknown);
}

source::Range Parser::LastLine(source::FileId file) const {
  const source::File& text = context_.sources.Get(file);
  for (uint32_t i = context_.sources.LineCount(file); i > 0; --i) {
    const std::string_view line = context_.sources.Line(file, i);
    const std::string_view words = TrimBlanks(line);
    if (words.empty()) continue;
    const auto begin = text.base + text.line_starts[i - 1] + static_cast<source::Offset>(words.data() - line.data());
    return {begin, begin + static_cast<source::Offset>(words.size())};
  }
  return {text.base, text.base};
}

void Parser::EndOfSource(source::FileId file) {
  const source::Range last = LastLine(file);
  context_.BeginStatement(++statement_number_, {});
  if (macro_) FinishMacro();
  if (structure_) {
    context_.Report(last, diag::TechnolEndsMissing, structure_->name);
    FinishStructure();
  }
  if (in_data_) {
    context_.Report(last, diag::TechnolDataNotClosed);
    in_data_ = false;
  }
  if (mechanism_.valid()) {
    context_.Report(last, diag::TechnolMechanismNotClosed, context_.program.units[mechanism_].name);
    LeaveMechanism({});
  }
  context_.faulty = false;
  if (module_.valid()) {
    if (!context_.program.units[module_].faulty) {
      context_.Report(last, diag::TechnolModuleNotClosed, context_.program.units[module_].name);
    }
    LeaveModule({});
  }
  EndStretch(last);
  abandoned_modules_.clear();
  abandoned_mechanisms_.clear();
  SourceFile& entry = *std::ranges::find(context_.program.files, file, &SourceFile::file);
  entry.rest = TakeComments();
}

void Parser::CheckWhole() {
  const source::Range last = LastLine(last_source_);
  const auto report = [&](const auto& message, auto... values) {
    context_.BeginStatement(++statement_number_, {});
    context_.Report(last, message, values...);
  };
  if (!has_data_) report(diag::TechnolNoData);
  if (!has_stop_) report(diag::TechnolNoStop);
  for (const ModuleInfo& info : Modules()) {
    if (!info.standard || FindModule(context_.program, info.kind).valid()) continue;
    if (context_.settings.strict) {
      report(diag::TechnolModuleMissingStrict, info.keyword);
    } else {
      report(diag::TechnolModuleMissing, info.keyword);
    }
  }
}

Program Parse(dialects::Request& request, const Settings& settings) {
  Program program = Parser(request, settings).Run();
  request.diagnostics->SortBySource();
  return program;
}

void AddNotes(diag::Diagnostic& diagnostic, const Program& program, ExpansionId expansion) {
  for (; expansion.valid(); expansion = program.expansions[expansion].outer) {
    const Expansion& line = program.expansions[expansion];
    diagnostic.notes.push_back({line.body, "in macro '" + line.macro + "'"});
  }
}

}  // namespace plcxx::technol
