#include "transpiler/dialects/nc110/control/editing.h"

#include <algorithm>

#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/dialects/nc110/machine/signals.h"
#include "transpiler/dialects/nc110/parser/parser.h"
#include "transpiler/dialects/nc110/source/lexer.h"

namespace plcxx::nc110 {
namespace {

using dialects::Definition;
using dialects::DefinitionKind;
using dialects::EditorToken;
using dialects::TokenRole;

TokenRole EditorRole(TokenKind kind) {
  constexpr TokenRole kRoles[] = {
#define NC110_TOKEN(Key, Printed, Role) TokenRole::k##Role,
#include "transpiler/dialects/nc110/source/tokens.def"
  };
  return kRoles[static_cast<size_t>(kind)];
}

std::vector<EditorToken> EditorTokens(dialects::Request& request, source::FileId file) {
  const Settings settings = ReadSettings(request);
  const LexedFile lexed =
      Lex(*request.sources, file, settings.parse.accept_homoglyphs ? Homoglyphs::kAccept : Homoglyphs::kReject,
          *request.diagnostics);
  std::vector<EditorToken> tokens;
  tokens.reserve(lexed.tokens.size() + lexed.comments.size());
  const source::File& text = request.sources->Get(file);
  source::Offset begin = text.base;
  if (text.text.starts_with('*')) {  // a symbol file; what stands after the '*' is a remark
    begin += static_cast<source::Offset>(request.sources->Line(file, 1).size());
    tokens.push_back({{text.base, begin}, TokenRole::kComment});
  }
  for (const Token& token : lexed.tokens) {
    if (token.kind == TokenKind::kEndOfFile || token.range.begin < begin) continue;
    tokens.push_back({token.range, EditorRole(token.kind)});
  }
  for (const Comment& comment : lexed.comments) {
    if (comment.range.begin >= begin) tokens.push_back({comment.range, TokenRole::kComment});
  }
  std::ranges::stable_sort(tokens, {}, [](const EditorToken& token) { return token.range.begin; });
  return tokens;
}

std::string EditorComment(const source::SourceManager& sources, source::Range range) {
  std::string_view text = sources.Text(range);
  if (text.starts_with(';')) text.remove_prefix(1);
  return std::string(Trim(text));
}

std::vector<Definition> EditorDefinitions(dialects::Request& request) {
  const source::SourceManager& sources = *request.sources;
  const Program tree = Parse(sources, request.files, ReadSettings(request).parse, *request.diagnostics);
  std::vector<Definition> definitions;
  for (const Symbol& symbol : tree.symbols) {
    definitions.push_back({.name = symbol.name,
                           .kind = DefinitionKind::kSignal,
                           .name_range = symbol.range,
                           .range = symbol.range,
                           .scope = {},
                           .address = ToText(symbol.operand),
                           .detail = ToText(symbol.operand),
                           .comment = EditorComment(sources, symbol.comment)});
  }
  for (const Block& block : tree.blocks) {
    if (!block.head.valid() || !block.end.valid()) continue;
    const source::Range head = tree.items[block.head].range, end = tree.items[block.end].range;
    definitions.push_back({.name = std::string(sources.Text({head.begin, head.end})),
                           .kind = DefinitionKind::kBlock,
                           .name_range = block.keyword,
                           .range = {head.begin, end.end},
                           .scope = {},
                           .address = {},
                           .detail = {},
                           .comment = {}});
  }
  return definitions;
}

/// The first ten characters tell symbols apart.
std::string NameKey(std::string_view spelling) {
  if (spelling.starts_with('!')) spelling.remove_prefix(1);
  return std::string(spelling.substr(0, kSignificant));
}

source::Range NamePart(source::Range range, std::string_view spelling) {
  return {range.begin + (spelling.starts_with('!') ? 1 : 0), range.end};
}

std::vector<dialects::Word> EditorWords() {
  std::vector<dialects::Word> words = {
      {.name = "DOF",
       .role = TokenRole::kKeyword,
       .meaning = "executes a block while a condition is 1",
       .parameters = {}},
      {.name = "DOE", .role = TokenRole::kKeyword, .meaning = "the other case of a DOF", .parameters = {}},
      {.name = "ENDF", .role = TokenRole::kKeyword, .meaning = "ends a DOF", .parameters = {}},
      {.name = "ENDE", .role = TokenRole::kKeyword, .meaning = "ends a DOE", .parameters = {}},
      {.name = "MSG", .role = TokenRole::kKeyword, .meaning = "declares the text of a message", .parameters = {}},
      {.name = "SGN", .role = TokenRole::kFunction, .meaning = "1 when any bit is 1", .parameters = {"word"}},
      {.name = "MUX",
       .role = TokenRole::kFunction,
       .meaning = "the word whose signal is 1",
       .parameters = {"word, signal", "word, signal"}}};
  const auto add = [&words](std::string_view name, std::string_view operation) {
    words.push_back({.name = std::string(name),
                     .role = TokenRole::kFunction,
                     .meaning = "word function: " + std::string(operation),
                     .parameters = {"word"}});
  };
#define PLCXX_WORD_FUNCTION(Kind, Name, Operation, Greatest) add(Name, #Operation);
#include "transpiler/dialects/nc110/machine/functions.def"
  return words;
}

std::vector<dialects::ControlSignal> EditorSignals(const dialects::Request&) {
  std::vector<dialects::ControlSignal> signals;
  for (const Signal& signal : AllSignals()) {
    signals.push_back({.address = ToText(signal.operand), .name = std::string(signal.name), .meaning = signal.meaning});
  }
  return signals;
}

}  // namespace

const dialects::Editing kEditing = {.tokens = EditorTokens,
                                    .definitions = EditorDefinitions,
                                    .key = NameKey,
                                    .name_part = NamePart,
                                    .words = EditorWords,
                                    .signals = EditorSignals,
                                    .name_mark = "!",
                                    .opening = "([",
                                    .separators = ","};

}  // namespace plcxx::nc110
