#include "transpiler/dialects/technol/control/editing.h"

#include <algorithm>
#include <map>
#include <set>

#include "transpiler/dialects/technol/machine/machine.h"
#include "transpiler/dialects/technol/machine/options.h"
#include "transpiler/dialects/technol/machine/signals.h"
#include "transpiler/dialects/technol/parser/names.h"
#include "transpiler/dialects/technol/parser/parser.h"
#include "transpiler/dialects/technol/source/lexer.h"

namespace plcxx::technol {
namespace {

using dialects::Definition;
using dialects::DefinitionKind;
using dialects::EditorToken;
using dialects::TokenRole;

TokenRole RoleOfWord(std::string_view text) {
  const std::string upper = Upper(text);
  if (OpByMnemonic(upper) != Op::kUnknown) return TokenRole::kMnemonic;
  if (RegisterByName(upper) != Register::kNone) return TokenRole::kKeyword;
  return IsReserved(upper) ? TokenRole::kKeyword : TokenRole::kName;
}

TokenRole EditorRole(const Token& token) {
  switch (token.kind) {
    case TokenKind::kWord:
      return RoleOfWord(token.text);
    case TokenKind::kNumber:
      return TokenRole::kNumber;
    case TokenKind::kString:
    case TokenKind::kQuoted:
    case TokenKind::kOpenString:
    case TokenKind::kPath:
    case TokenKind::kText:
      return TokenRole::kText;
    case TokenKind::kPunctuation:
    case TokenKind::kInvalid:
      return TokenRole::kOperator;
    case TokenKind::kComment:
      return TokenRole::kComment;
  }
  return TokenRole::kOperator;
}

std::vector<EditorToken> EditorTokens(dialects::Request& request, source::FileId file) {
  const source::File& text = request.sources->Get(file);
  std::vector<EditorToken> result;
  std::vector<Token> tokens;
  for (uint32_t i = 0; i < request.sources->LineCount(file); ++i) {
    tokens.clear();
    LexLine(request.sources->Line(file, i + 1), {.begin = text.base + text.line_starts[i], .call = {}}, tokens);
    for (const Token& token : tokens) result.push_back({token.range, EditorRole(token)});
  }
  return result;
}

DefinitionKind KindOf(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::kCell:
    case SymbolKind::kBit:
      return DefinitionKind::kSignal;
    case SymbolKind::kMechanism:
      return DefinitionKind::kRoutine;
    case SymbolKind::kConstant:
      return DefinitionKind::kConstant;
    case SymbolKind::kField:
      return DefinitionKind::kField;
    case SymbolKind::kStructure:
      return DefinitionKind::kType;
    case SymbolKind::kLabel:
      return DefinitionKind::kLabel;
    case SymbolKind::kMacro:
      return DefinitionKind::kMacro;
  }
  return DefinitionKind::kSignal;
}

std::string DetailOf(const Symbol& symbol) {
  switch (symbol.kind) {
    case SymbolKind::kCell:
      return symbol.width == 0 ? std::to_string(symbol.bytes) + " bytes" : std::to_string(symbol.width) + " bits";
    case SymbolKind::kBit:
      return "bit";
    case SymbolKind::kMechanism:
      return "mechanism";
    case SymbolKind::kConstant:
      return "= " + std::to_string(symbol.value);
    case SymbolKind::kField:
      return "field at " + std::to_string(symbol.value);
    case SymbolKind::kStructure:
      return "structure of " + std::to_string(symbol.bytes) + " bytes";
    case SymbolKind::kLabel:
      return "label";
    case SymbolKind::kMacro:
      return "macro";
  }
  return {};
}

std::string EditorComment(const Program& tree, const source::SourceManager& sources, Span comments) {
  std::string text;
  for (uint32_t i = 0; i < comments.count; ++i) {
    std::string_view line = sources.Text(tree.comments[comments.first + i].range);
    while (line.starts_with(';')) line.remove_prefix(1);
    line = TrimBlanks(line);
    if (!line.empty()) text += (text.empty() ? "" : "\n") + std::string(line);
  }
  return text;
}

/// Where each subprogram ends: labels that a CALL names are its beginnings, up to the next one or the end of its unit.
std::map<uint32_t, source::Offset> SubprogramEnds(const Program& tree) {
  std::set<uint32_t> called;  // labels
  for (const Instruction& instruction : tree.instructions) {
    if (Info(instruction.op).form != Form::kCall || instruction.operands.count == 0) continue;
    const Operand& operand = tree.OperandOf(instruction, 0);
    if (operand.label.valid()) called.insert(operand.label.index);
  }
  std::map<uint32_t, source::Offset> ends;
  uint32_t open = LabelId().index;
  for (uint32_t i = 0; i < tree.instructions.size(); ++i) {
    const Instruction& instruction = tree.instructions[InstructionId(i)];
    for (uint32_t k = 0; k < instruction.labels.count; ++k) {
      if (called.contains(instruction.labels.first + k)) open = instruction.labels.first + k;
    }
    if (instruction.op == Op::kAreaEnd || instruction.op == Op::kModuleEnd) open = LabelId().index;
    if (open != LabelId().index) ends[open] = std::max(ends[open], instruction.range.end);
  }
  return ends;
}

std::vector<Definition> EditorDefinitions(dialects::Request& request) {
  const Program tree = Parse(request, ReadSettings(request.options));
  const source::SourceManager& sources = *request.sources;
  const std::map<uint32_t, source::Offset> ends = SubprogramEnds(tree);
  std::vector<Definition> definitions;
  for (const Symbol& symbol : tree.symbols) {
    if (symbol.origin != SymbolOrigin::kSource || symbol.range.begin == symbol.range.end) continue;
    Definition definition{.name = symbol.name,
                          .kind = KindOf(symbol.kind),
                          .name_range = symbol.range,
                          .range = symbol.range,
                          .scope = {},
                          .address = {},
                          .detail = DetailOf(symbol),
                          .comment = EditorComment(tree, sources, symbol.comments)};
    const bool is_memory =
        symbol.kind == SymbolKind::kCell || symbol.kind == SymbolKind::kBit || symbol.kind == SymbolKind::kMechanism;
    if (is_memory) definition.address = AddressOfSymbol(symbol);
    if (symbol.kind == SymbolKind::kMechanism && symbol.unit.valid()) {
      const Unit& unit = tree.units[symbol.unit];
      definition.range = {unit.open.begin, std::max(unit.close.end, unit.open.end)};
    }
    if (symbol.kind == SymbolKind::kLabel && symbol.label.valid()) {
      const auto end = ends.find(symbol.label.index);
      if (end != ends.end() && end->second > symbol.range.begin) {
        definition.kind = DefinitionKind::kRoutine;
        definition.range.end = end->second;
        definition.detail = "subprogram";
      }
    }
    definitions.push_back(std::move(definition));
  }
  for (const Unit& unit : tree.units) {
    if (unit.kind != UnitKind::kModule) continue;
    definitions.push_back({.name = unit.name,
                           .kind = DefinitionKind::kRoutine,
                           .name_range = unit.open,
                           .range = {unit.open.begin, std::max(unit.close.end, unit.open.end)},
                           .scope = {},
                           .address = {},
                           .detail = "module",
                           .comment = EditorComment(tree, sources, unit.comments)});
  }
  return definitions;
}

/// The operands of an instruction, as the specification's section 3 names them.
std::vector<std::string> ParametersOf(Form form) {
  switch (form) {
    case Form::kNone:
      return {};
    case Form::kBit:
      return {"[-] bit"};
    case Form::kWriteBit:
      return {"bit"};
    case Form::kFlag:
      return {"0 or 1", "bit"};
    case Form::kJump:
    case Form::kCall:
      return {"label"};
    case Form::kWaitLimit:
      return {"timer cell", "time", "label"};
    case Form::kDelay:
      return {"timer cell", "time"};
    case Form::kMechanism:
      return {"mechanism"};
    case Form::kData:
      return {"memory or CNST.number"};
    case Form::kNarrowData:
      return {"byte or CNST.number"};
    case Form::kWideData:
      return {"byte, word or CNST.number"};
    case Form::kStore:
      return {"memory"};
    case Form::kRotation:
      return {"CNST.number or a byte"};
    case Form::kError:
      return {"number", "[second number]"};
    case Form::kTwo:
      return {"register or memory", "register, memory or constant"};
    case Form::kOne:
    case Form::kMultiply:
      return {"register or memory"};
    case Form::kShift:
      return {"register or memory", "constant or CL"};
    case Form::kExchange:
      return {"register or memory", "register or memory"};
    case Form::kExtend:
      return {"register", "narrower register or memory"};
    case Form::kStack:
      return {"register"};
  }
  return {};
}

std::vector<dialects::Word> EditorWords() {
  std::vector<dialects::Word> words;
  for (const InstructionInfo& info : Instructions()) {
    if (info.mnemonic.empty()) continue;
    words.push_back({.name = std::string(info.mnemonic),
                     .role = TokenRole::kMnemonic,
                     .meaning = info.assembler ? "assembler instruction" : "",
                     .parameters = ParametersOf(info.form)});
  }
  const auto add_synonym = [&words](std::string_view name, Op op) {
    words.push_back({.name = std::string(name),
                     .role = TokenRole::kMnemonic,
                     .meaning = "as " + std::string(Info(op).mnemonic),
                     .parameters = ParametersOf(Info(op).form)});
  };
  const auto add_keyword = [&words](std::string name, const char* meaning) {
    words.push_back({.name = std::move(name), .role = TokenRole::kKeyword, .meaning = meaning, .parameters = {}});
  };
  for (const ModuleInfo& module : Modules()) {
    if (module.keyword.empty()) continue;
    add_keyword(std::string(module.keyword), "module");
    add_keyword(std::string(module.keyword) + "_END", "ends a module");
  }
#define TECHNOL_SYNONYM(Text, Key) add_synonym(Text, Op::k##Key);
#define TECHNOL_REGISTER(Key, Text, ...) add_keyword(Text, "register");
#define TECHNOL_RESERVED(Text) add_keyword(Text, "");
#include "transpiler/dialects/technol/machine/machine.def"
  return words;
}

std::vector<dialects::ControlSignal> EditorSignals(const dialects::Request&) {
  std::vector<dialects::ControlSignal> signals;
  for (const Signal& signal : Signals()) {
    if (IsField(signal)) continue;
    signals.push_back(
        {.address = signal.name, .name = signal.name, .meaning = signal.meaning, .has_name_in_programs = true});
  }
  return signals;
}

std::string NameKey(std::string_view spelling) { return Upper(spelling); }
source::Range NamePart(source::Range range, std::string_view) { return range; }

}  // namespace

const dialects::Editing kEditing = {.tokens = EditorTokens,
                                    .definitions = EditorDefinitions,
                                    .key = NameKey,
                                    .name_part = NamePart,
                                    .words = EditorWords,
                                    .signals = EditorSignals};

}  // namespace plcxx::technol
