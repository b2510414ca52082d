#include "transpiler/dialects/prostep/control/editing.h"

#include <algorithm>

#include "transpiler/dialects/prostep/machine/machine.h"
#include "transpiler/dialects/prostep/machine/signals.h"
#include "transpiler/dialects/prostep/parser/parser.h"
#include "transpiler/dialects/prostep/source/lexer.h"

namespace plcxx::prostep {
namespace {

using dialects::Definition;
using dialects::DefinitionKind;
using dialects::EditorToken;
using dialects::TokenRole;

TokenRole EditorRole(TokenKind kind) {
  switch (kind) {
    case TokenKind::kHeader:
    case TokenKind::kDeclaration:
    case TokenKind::kSwitch:
    case TokenKind::kModuleMark:
      return TokenRole::kKeyword;
    case TokenKind::kComment:
      return TokenRole::kComment;
    case TokenKind::kText:
      return TokenRole::kText;
    case TokenKind::kLabel:
    case TokenKind::kTarget:
      return TokenRole::kName;
    case TokenKind::kMnemonic:
      return TokenRole::kMnemonic;
    case TokenKind::kClass:
      return TokenRole::kAddress;
    case TokenKind::kNumber:
      return TokenRole::kNumber;
    case TokenKind::kColon:
    case TokenKind::kUnknown:
    case TokenKind::kJunk:
      return TokenRole::kOperator;
  }
  return TokenRole::kOperator;
}

/// Of a class with its number: modules are names, constants are numbers.
TokenRole RoleOfOperand(OperandClass operand_class) {
  if (operand_class == OperandClass::kPM) return TokenRole::kName;
  if (operand_class == OperandClass::kFM) return TokenRole::kFunction;
  return operand_class == OperandClass::kK ? TokenRole::kNumber : TokenRole::kAddress;
}

std::vector<EditorToken> EditorTokens(dialects::Request& request, source::FileId file) {
  const LexedFile lexed = Lex(*request.sources, file, *request.diagnostics);
  std::vector<EditorToken> tokens;
  for (const Line& line : lexed.lines) {
    bool after_class = false;
    for (uint32_t i = 0; i < line.tokens.count; ++i) {
      const Token& token = lexed.tokens[line.tokens.first + i];
      if (token.range.begin == token.range.end) continue;
      if (token.kind == TokenKind::kNumber && after_class) {
        EditorToken& operand = tokens.back();
        operand.role = RoleOfOperand(ClassByName(Upper(request.sources->Text(operand.range))));
        operand.range.end = token.range.end;
      } else {
        tokens.push_back({token.range, EditorRole(token.kind)});
      }
      after_class = token.kind == TokenKind::kClass;
    }
  }
  std::ranges::stable_sort(tokens, {}, [](const EditorToken& token) { return token.range.begin; });
  return tokens;
}

std::string EditorComment(const Program& tree, const source::SourceManager& sources, Span comments) {
  std::string text;
  for (uint32_t i = 0; i < comments.count; ++i) {
    std::string_view line = sources.Text(tree.comments[comments.first + i].range);
    while (line.starts_with(';') || line.starts_with('*') || line.starts_with('=')) line.remove_prefix(1);
    line = TrimBlanks(line);
    if (!line.empty()) text += (text.empty() ? "" : "\n") + std::string(line);
  }
  return text;
}

std::vector<Definition> EditorDefinitions(dialects::Request& request) {
  const source::SourceManager& sources = *request.sources;
  const Program tree = Parse(sources, request.files, *request.diagnostics);
  std::vector<Definition> definitions;
  for (const Module& module : tree.modules) {
    const source::Range range{module.open.begin, std::max(module.open.end, module.close.end)};
    source::Range name = module.open;
    const std::string_view opening = sources.Text(module.open);
    const size_t at = std::min(opening.find_first_of("Pp"), opening.size());
    name.begin += static_cast<source::Offset>(at);
    definitions.push_back({.name = "PM " + std::to_string(module.number),
                           .kind = DefinitionKind::kRoutine,
                           .name_range = name,
                           .range = range,
                           .scope = {},
                           .address = {},
                           .detail = "module",
                           .comment = EditorComment(tree, sources, module.comments)});
    for (uint32_t i = 0; i < module.labels.count; ++i) {
      const Label& label = tree.labels[LabelId(module.labels.first + i)];
      definitions.push_back({.name = label.name,
                             .kind = DefinitionKind::kLabel,
                             .name_range = label.range,
                             .range = label.range,
                             .scope = range,
                             .address = {},
                             .detail = "label of PM " + std::to_string(module.number),
                             .comment = {}});
    }
  }
  return definitions;
}

std::string NameKey(std::string_view spelling) {
  std::string key;
  for (const char c : Upper(spelling)) {
    if (!IsBlank(c)) key += c;
  }
  return key;
}

source::Range NamePart(source::Range range, std::string_view) { return range; }

std::string OperandsText(OperandSet set) {
  std::string text;
  const auto add = [&](OperandSet one, std::string_view name) {
    if ((set & one) != 0) text += (text.empty() ? "" : " or ") + std::string(name);
  };
  add(kBits, "bit");
  add(kBytes, "byte");
  add(kWords, "word");
  add(kCounterSet, "counter");
  add(kTimerSet, "timer");
  add(kConstants, "constant");
  add(kLabels, "label");
  add(kModuleSet, "module PM");
  add(kFunctions, "functional module FM");
  return text;
}

std::vector<dialects::Word> EditorWords() {
  std::vector<dialects::Word> words;
  for (const InstructionInfo& info : Instructions()) {
    if (info.mnemonic.empty()) continue;
    dialects::Word word{
        .name = std::string(info.mnemonic), .role = TokenRole::kMnemonic, .meaning = {}, .parameters = {}};
    if (info.own != kNothing) word.parameters.push_back(OperandsText(info.own));
    if (info.next != kNothing) word.parameters.push_back("next line: " + OperandsText(info.next));
    words.push_back(std::move(word));
  }
  const auto add = [&words](uint32_t number, Function function) {
    const FunctionInfo& info = Info(function);
    dialects::Word word{.name = "FM " + std::to_string(number),
                        .role = TokenRole::kFunction,
                        .meaning = std::string(info.name),
                        .parameters = {}};
    for (uint32_t i = 0; i < info.count; ++i) {
      const ShapeInfo& shape = Info(info.arguments[i]);
      const bool is_written = shape.access == Access::kWrite || shape.access == Access::kReadWrite;
      word.parameters.push_back("next line " + std::to_string(i + 1) + ": " + (is_written ? "result" : "value"));
    }
    words.push_back(std::move(word));
  };
#define PROSTEP_FUNCTION_NUMBER(number, Key) add(number, Function::k##Key);
#include "transpiler/dialects/prostep/machine/machine.def"
  for (const char* word : {"MOD PM", "END PM", "DDB", "DDW", "DDD", "DMF", "DM", "DT"}) {
    words.push_back({.name = word, .role = TokenRole::kKeyword, .meaning = {}, .parameters = {}});
  }
  return words;
}

std::string_view LettersOf(uint8_t width) { return width == 8 ? "B" : width == 16 ? "W" : width == 32 ? "D" : ""; }

std::vector<dialects::ControlSignal> EditorSignals(const dialects::Request&) {
  std::vector<dialects::ControlSignal> signals;
  for (const Signal& signal : Signals()) {
    if (signal.space == Space::kNone) continue;
    std::string address =
        std::string(Name(signal.space)) + std::string(LettersOf(signal.width)) + " " + std::to_string(signal.byte);
    if (signal.width < 8) address += "." + std::to_string(signal.bit);
    signals.push_back({.address = std::move(address), .name = signal.name, .meaning = signal.meaning});
  }
  return signals;
}

}  // namespace

const dialects::Editing kEditing = {.tokens = EditorTokens,
                                    .definitions = EditorDefinitions,
                                    .key = NameKey,
                                    .name_part = NamePart,
                                    .words = EditorWords,
                                    .signals = EditorSignals};

}  // namespace plcxx::prostep
