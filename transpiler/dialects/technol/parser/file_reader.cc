#include "transpiler/dialects/technol/parser/file_reader.h"

#include <algorithm>

#include "transpiler/dialects/technol/parser/check_tokens.h"
#include "transpiler/source/find_file.h"

namespace plcxx::technol {
namespace {

constexpr std::string_view kAllocations[] = {"DB", "DW", "DD", "DS", "DFM"};

/// DB?, DW?, DD?: typed without the blank.
bool IsGlued(std::string_view upper) { return upper == "DB?" || upper == "DW?" || upper == "DD?"; }

bool IsAllocation(std::string_view upper) {
  return std::ranges::find(kAllocations, upper) != std::end(kAllocations) || IsGlued(upper);
}

/// MODULE_MAIN, MODULE_X ...; none when `upper` opens no module.
std::optional<ModuleKind> ModuleByKeyword(std::string_view upper) {
  for (const ModuleInfo& info : Modules()) {
    if (info.kind != ModuleKind::kOther && info.keyword == upper) return info.kind;
  }
  if (upper.starts_with("MODULE_") && upper.size() > Info(ModuleKind::kOther).keyword.size()) return ModuleKind::kOther;
  return std::nullopt;
}

/// Does the second word define the first one, whatever that is? DB and the like may be operands: MOV DS,CX. So may be a
/// word that is no name and was declared as one: LDR MACRO.
bool NamesDefinition(std::span<const Token> words, const ParsingContext& context) {
  const std::string second = UpperWord(words, 1);
  if (context.IsReportedAsName(second)) return false;
  return second == "EQU" || second == "STRUC" || second == "STRUCT" || second == "MACRO" ||
         (words.size() > 1 && words[1].text == "=");
}

/// The text of the words behind `words[index]`, with single blanks.
std::string TextBehind(std::span<const Token> words, size_t index) {
  std::string text;
  for (const Token& word : words.subspan(index + 1)) text += (text.empty() ? "" : " ") + std::string(word.text);
  return text;
}

}  // namespace

FileReader::FileReader(Parsing& parsing)
    : StatementReader(parsing),
      parsing_(parsing),
      comments_(parsing),
      code_(parsing, comments_),
      units_(parsing, comments_, code_),
      constants_(parsing, comments_),
      structures_(parsing, comments_),
      data_(parsing, comments_, structures_),
      macros_(parsing, comments_, code_),
      includes_(parsing, code_) {
  structures_.AddControlStructures();
}

void FileReader::ReadSource(source::FileId file) {
  comments_.BeginSource();
  units_.BeginSource();
  now_.including = {source::FileIdentity(context_.sources.Get(file).path)};
  ReadLines(file);
  context_.NextStatement({});
  LeaveOpenDefinitions(file);
  units_.EndOfSource(LastLine(file));
  std::ranges::find(context_.program.files, file, &SourceFile::file)->rest = comments_.TakeComments();
}

void FileReader::EndOfProgram() {
  if (!context_.program.tables_only) units_.CheckWhole(LastLine(parsing_.last_source));
  code_.Finish(parsing_.last_source);
}

void FileReader::ReadLines(source::FileId file) {
  const source::FileId outer = now_.file;
  now_.file = file;
  context_.program.files.push_back({.file = file});
  const uint32_t count = context_.sources.LineCount(file);
  context_.program.line_count += count;
  for (uint32_t i = 0; i < count; ++i) {
    const source::File& text = context_.sources.Get(file);
    ReadLine(context_.sources.Line(file, i + 1), {.begin = text.base + text.line_starts[i]});
  }
  now_.file = outer;
}

void FileReader::CheckLength(std::string_view line, source::Offset begin) {
  if (line.size() <= kLineBytes) return;
  // One byte a character in the encodings of DOS and Windows.
  const bool utf8 = context_.sources.Get(now_.file).encoding == source::Encoding::kUtf8;
  const auto starts = std::ranges::count_if(line, [](char c) { return (static_cast<uint8_t>(c) & 0xC0U) != 0x80U; });
  const auto length = utf8 ? static_cast<int64_t>(line.size()) : starts;
  if (length <= kLineBytes) return;
  context_.Report({begin, begin + static_cast<source::Offset>(line.size())}, diag::TechnolLongLine, length);
}

void FileReader::ReadLine(std::string_view text, const LinePlace& place) {
  std::vector<Token> tokens;
  LexLine(text, place, tokens);
  context_.NextStatement(context_.expansion);
  const bool in_file = place.call.begin == place.call.end;
  if (in_file) CheckLength(text, place.begin);
  if (macros_.IsOpen()) return macros_.ReadLine(text, tokens, place);

  Statement statement;
  std::span<const Token> words = tokens;
  if (!words.empty() && words.back().kind == TokenKind::kComment) {
    if (in_file) statement.comment = &words.back();
    words = words.first(words.size() - 1);
  }
  if (!words.empty()) return ReadWords(statement, words);
  if (!in_file) return;
  if (tokens.empty()) {
    comments_.ReadBlankLine();
  } else {
    comments_.AddComment(statement, CommentPlace::kLeading);
  }
}

void FileReader::ReadWords(Statement& statement, std::span<const Token> words) {
  if (units_.IsAfterStop({words.front().range.begin, words.back().range.end})) return;
  if (!CheckTokens(words, context_)) return KeepFaultyLine(statement, words);
  comments_.BeginStatement();
  if (words.size() > 1 && words[0].kind == TokenKind::kWord && words[1].text == ":") {
    statement.label = words.data();
    words = words.subspan(2);
  }
  statement.words = words;
  statement.range =
      words.empty() ? statement.label->range : source::Range{words.front().range.begin, words.back().range.end};
  statement.upper = UpperWord(words, 0);
  ReadStatement(statement);
  if (context_.faulty && OpByMnemonic(statement.upper) == Op::kUnknown) ExcuseNames(statement);
}

void FileReader::ExcuseNames(const Statement& statement) {
  if (statement.label != nullptr) context_.Excuse(statement.label->text);
  for (const Token& token : statement.words) {
    if (token.kind == TokenKind::kWord && !IsReserved(Upper(token.text))) context_.Excuse(token.text);
  }
}

void FileReader::ReadStatement(const Statement& statement) {
  if (structures_.IsOpen() && structures_.ReadLine(statement)) return;
  if (statement.words.empty()) {
    if (IsCodePlace(statement)) code_.DefineLabel(*statement.label);
    comments_.AddComment(statement, CommentPlace::kLeading);
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
  if (ReadDirective(statement)) return;
  const Op op = OpByMnemonic(statement.upper);
  if (op != Op::kUnknown && !NamesDefinition(statement.words, context_)) return units_.ReadInstruction(statement, op);
  if (ReadDefinition(statement) || ReadUse(statement)) return;
  if (ReportUnknown(statement, CurrentPlace(), context_) && !ReadMeant(statement)) KeepUnknown(statement);
}

CodePlace FileReader::CurrentPlace() const {
  if (now_.in_data) return CodePlace::kData;
  return CurrentUnit().valid() || code_.InSubprograms() ? CodePlace::kCode : CodePlace::kOutside;
}

bool FileReader::ReadMeant(const Statement& statement) {
  std::string meant(NearMnemonic(statement.upper));
  if (statement.upper == "END") {
    meant = now_.module.valid() ? Upper(context_.program.units[now_.module].name) + "_END" : "STOP";
  }
  if (meant.empty() || OpByMnemonic(meant) != Op::kUnknown) return false;
  std::vector<Token> words(statement.words.begin(), statement.words.end());
  words.front().text = meant;
  Statement as_meant = statement;
  as_meant.words = words;
  as_meant.upper = meant;
  return ReadDirective(as_meant);
}

bool FileReader::ReadDirective(const Statement& statement) {
  const std::string& word = statement.upper;
  if (word == "TITLE" || word == "PAGE" || word == "SUBTTL" || word == "NAME") {
    if (now_.in_data || CurrentUnit().valid())
      context_.Report(statement.range, diag::TechnolStrayLine, word, "stands outside modules and data");
  } else if (word == "T_INCLUDE") {
    ReadInclude(statement);
  } else if (word == "INCLUDE") {
    includes_.ReadSystemHeader(statement);
  } else if (word == "DATA") {
    units_.OpenData(statement);
  } else if (word == "DATA_END" || word == "START") {
    units_.CloseData(statement);
  } else if (word == "STOP") {
    units_.ReadStop(statement);
  } else if (word == "EQUI") {
    constants_.ReadEqui(statement);
  } else if (word == "MECH_BEGIN") {
    units_.OpenMechanism(statement);
  } else if (word == "MECH_END") {
    units_.CloseMechanism(statement);
  } else if (IsAllocation(word)) {
    data_.ReadAllocation(statement, statement.label, 0);
  } else if (word == "ENDM" || word == "LOCAL") {
    context_.Report(statement.range, diag::TechnolStrayLine, word, "stands in a macro only");
  } else if (word.ends_with("_END") && ModuleByKeyword(word.substr(0, word.size() - 4))) {
    units_.CloseModule(statement, std::string_view(word).substr(0, word.size() - 4));
  } else if (const auto kind = ModuleByKeyword(word)) {
    units_.OpenModule(statement, *kind);
  } else {
    return false;
  }
  return true;
}

bool FileReader::ReadDefinition(const Statement& statement) {
  const std::string second = UpperWord(statement.words, 1);
  if (second == "EQUI") {
    context_.Report(statement.first().range, diag::TechnolUnknownInstructionForeign, statement.first().text,
                    "write EQUI " + std::string(statement.first().text) + "," + TextBehind(statement.words, 1));
    return true;
  }
  const bool assignment = statement.words.size() > 1 && statement.words[1].text == "=";
  const bool definition = assignment || second == "EQU" || second == "STRUC" || second == "STRUCT" ||
                          second == "ENDS" || second == "MACRO" || IsAllocation(second);
  if (definition && statement.label != nullptr) {
    context_.Report(statement.label->range, diag::TechnolSurplus, "label '" + std::string(statement.label->text) + "'",
                    statement.words[1].text);
    return true;
  }
  if (assignment) {
    constants_.ReadAssignment(statement);
  } else if (second == "EQU") {
    constants_.ReadEqu(statement);
  } else if (second == "STRUC" || second == "STRUCT") {
    structures_.OpenStructure(statement);
  } else if (second == "ENDS") {
    structures_.CloseStructure(statement);
  } else if (second == "MACRO") {
    macros_.OpenMacro(statement);
  } else if (definition) {
    data_.ReadAllocation(statement, &statement.first(), 1);
  } else {
    return false;
  }
  return true;
}

bool FileReader::ReadUse(const Statement& statement) {
  const Token& first = statement.first();
  const SymbolId symbol = context_.names.Find(first.text);
  if (const Macro* macro = macros_.Find(symbol)) {
    ReadCall(statement, *macro);
    return true;
  }
  if (structures_.Find(symbol) != nullptr) {
    data_.ReadInstance(statement, statement.label, 0);
    return true;
  }
  const Token* second = statement.words.size() > 1 ? &statement.words[1] : nullptr;
  if (second == nullptr || second->kind != TokenKind::kWord) return false;
  if (structures_.Find(context_.names.Find(second->text)) == nullptr) return false;
  if (statement.label == nullptr) {
    data_.ReadInstance(statement, &first, 1);
  } else {
    context_.Report(first.range, diag::TechnolSurplus, Shown(&first), statement.label->text);
  }
  return true;
}

void FileReader::ReadInclude(const Statement& statement) {
  const std::optional<IncludedFile> included = includes_.ReadInclude(statement);
  if (!included) return;
  comments_.TakeComments(statement);
  const ExpansionId expansion = context_.expansion;
  context_.expansion = {};
  now_.including.push_back(included->identity);
  ReadLines(included->file);
  context_.NextStatement({});
  LeaveOpenDefinitions(included->file);
  comments_.Forget();
  now_.including.pop_back();
  context_.expansion = expansion;
}

void FileReader::ReadCall(const Statement& statement, const Macro& macro) {
  std::optional<MacroCall> call = macros_.BeginCall(statement, macro);
  if (!call) return;
  while (const std::optional<std::string_view> line = macros_.ExpandNextLine(*call)) {
    ReadLine(*line, {.call = call->range});
  }
  macros_.EndCall(*call);
}

void FileReader::LeaveOpenDefinitions(source::FileId file) {
  macros_.LeaveOpenMacro();
  if (structures_.IsOpen()) structures_.LeaveOpenStructure(LastLine(file));
}

void FileReader::KeepFaultyLine(Statement& statement, std::span<const Token> words) {
  if (words.size() > 2 && words[0].kind == TokenKind::kWord && words[1].text == ":") words = words.subspan(2);
  const std::string upper = UpperWord(words, 0);
  statement.words = words;
  statement.range = {words.front().range.begin, words.back().range.end};
  statement.upper = upper;
  if (OpByMnemonic(upper) == Op::kUnknown) return ExcuseNames(statement);
  if (!structures_.IsOpen()) KeepUnknown(statement);
}

void FileReader::KeepUnknown(const Statement& statement) {
  if (!now_.in_data && now_.including.size() == 1) units_.ReadInstruction(statement, Op::kUnknown);
}

source::Range FileReader::LastLine(source::FileId file) const {
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

}  // namespace plcxx::technol
