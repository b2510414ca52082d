#include "transpiler/dialects/host50/control/editing.h"

#include <algorithm>

#include "transpiler/dialects/host50/machine/machine.h"
#include "transpiler/dialects/host50/machine/signals.h"
#include "transpiler/dialects/host50/parser/parser.h"
#include "transpiler/dialects/host50/source/lexer.h"

namespace plcxx::host50 {
namespace {

using dialects::Definition;
using dialects::DefinitionKind;
using dialects::EditorToken;
using dialects::TokenRole;

constexpr std::string_view kDirectives[] = {"NETWORK", "OPTION", "SLOWDIV", "CHANNELS", "COMMENT"};

TokenRole RoleOfWord(std::string_view text) {
  if (MnemonicByName(text)) return TokenRole::kMnemonic;
  const bool is_part = PartByName(text) || PartByEnd(text);
  const auto means = [text](std::string_view word) { return EqualIgnoringCase(text, word); };
  return is_part || std::ranges::any_of(kDirectives, means) ? TokenRole::kKeyword : TokenRole::kName;
}

TokenRole EditorRole(TokenKind kind, std::string_view text) {
  switch (kind) {
    case TokenKind::kWord:
      return RoleOfWord(text);
    case TokenKind::kQuotedSymbol:
      return TokenRole::kName;
    case TokenKind::kAddress:
      return TokenRole::kAddress;
    case TokenKind::kInteger:
    case TokenKind::kHex:
    case TokenKind::kFloat:
      return TokenRole::kNumber;
    case TokenKind::kString:
    case TokenKind::kText:
    case TokenKind::kOpenString:
    case TokenKind::kOpenQuotedSymbol:
      return TokenRole::kText;
    case TokenKind::kEnd:
    case TokenKind::kQuote:
    case TokenKind::kRow:
    case TokenKind::kComma:
    case TokenKind::kEquals:
    case TokenKind::kAssign:
    case TokenKind::kExclamation:
    case TokenKind::kOpenParenthesis:
    case TokenKind::kCloseParenthesis:
    case TokenKind::kPlus:
    case TokenKind::kMinus:
    case TokenKind::kStar:
    case TokenKind::kSlash:
    case TokenKind::kAmpersand:
    case TokenKind::kBar:
    case TokenKind::kLess:
    case TokenKind::kGreater:
    case TokenKind::kLessEqual:
    case TokenKind::kGreaterEqual:
    case TokenKind::kNotEqual:
    case TokenKind::kCharacter:
      return TokenRole::kOperator;
  }
  return TokenRole::kOperator;
}

char ClosingBracket(char opening) { return opening == '[' ? ']' : opening == '(' ? ')' : '}'; }

/// A row of a drawing: what stands in its brackets, and the comment after it.
void AddRowWords(const source::SourceManager& sources, source::Range row, std::vector<EditorToken>& tokens) {
  const source::File& file = sources.Get(sources.FileAt(row.begin));
  const std::string_view text = sources.Text(row);
  const auto at = [&row](size_t offset) { return row.begin + static_cast<source::Offset>(offset); };
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ';') {
      tokens.push_back({{at(i), row.end}, TokenRole::kComment});
      return;
    }
    if (std::string_view("[({").find(text[i]) == std::string_view::npos) continue;
    const size_t close = text.find(ClosingBracket(text[i]), i);
    if (close == std::string_view::npos) continue;
    const bool is_block = text[i] == '{';
    // The character after the bracket says what kind of contact it is; it is blank where it is a plain one.
    const size_t begin = is_block ? i + 1 : std::min(i + 2, close);
    const auto kind = is_block ? ElementKind::kBlock : ElementKind::kContactOrCoil;
    for (const Token& token : LexElement(file, {at(begin), at(close)}, kind)) {
      if (token.kind == TokenKind::kEnd || token.range.begin == token.range.end) continue;
      tokens.push_back({token.range, EditorRole(token.kind, sources.Text(token.range))});
    }
    i = close;
  }
}

std::vector<EditorToken> EditorTokens(dialects::Request& request, source::FileId file) {
  const source::SourceManager& sources = *request.sources;
  const LexedFile lexed = Lex(sources, file);
  std::vector<EditorToken> tokens;
  for (const Line& line : lexed.lines) {
    for (uint32_t i = 0; i < line.tokens.count; ++i) {
      const Token& token = lexed.tokens[line.tokens.first + i];
      if (token.kind == TokenKind::kRow) {
        AddRowWords(sources, token.range, tokens);
      } else if (token.range.begin != token.range.end) {
        tokens.push_back({token.range, EditorRole(token.kind, sources.Text(token.range))});
      }
    }
    if (line.comment.begin != line.comment.end) tokens.push_back({line.comment, TokenRole::kComment});
  }
  std::ranges::stable_sort(tokens, {}, [](const EditorToken& token) { return token.range.begin; });
  return tokens;
}

/// The word after the keyword of a line: "SR4" of "SUB SR4 "turret"", "L0003" of "NETWORK L0003".
source::Range SecondWord(const source::SourceManager& sources, source::Range line, source::Range keyword) {
  const source::Range rest{keyword.end, std::max(keyword.end, line.end)};
  const std::string_view text = sources.Text(rest);
  const size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos || text[begin] == '"' || text[begin] == ';') return keyword;
  const size_t end = std::min(text.find_first_of(" \t;\"", begin), text.size());
  return {rest.begin + static_cast<source::Offset>(begin), rest.begin + static_cast<source::Offset>(end)};
}

std::string SectionTitle(const Section& section) {
  switch (section.kind) {
    case SectionKind::kFast:
      return "FAST";
    case SectionKind::kSlow:
      return "SLOW";
    case SectionKind::kSubroutine:
      return SubroutineName(section.number);
    case SectionKind::kNone:
      return {};
  }
  return {};
}

source::Offset EndOfNetworks(const Program& tree, Span networks, source::Offset end) {
  for (uint32_t i = 0; i < networks.count; ++i) {
    const Network& network = tree.networks[NetworkId(networks.first + i)];
    end = std::max(end, network.range.end);
    for (uint32_t k = 0; k < network.instructions.count; ++k) {
      end = std::max(end, tree.instructions[InstructionId(network.instructions.first + k)].range.end);
    }
  }
  return end;
}

std::vector<Definition> EditorDefinitions(dialects::Request& request) {
  const source::SourceManager& sources = *request.sources;
  const Program tree = Parse(sources, request.files, request.options, *request.diagnostics);
  std::vector<Definition> definitions;
  for (const Symbol& symbol : tree.symbols) {
    if (symbol.predefined || symbol.name.empty()) continue;
    definitions.push_back({.name = symbol.name,
                           .kind = DefinitionKind::kSignal,
                           .name_range = symbol.name_range,
                           .range = symbol.range,
                           .scope = {},
                           .address = ToText(symbol.address),
                           .detail = ToText(symbol.address),
                           .comment = symbol.comment});
  }
  for (const Section& section : tree.sections) {
    if (section.kind == SectionKind::kNone) continue;
    const bool is_subroutine = section.kind == SectionKind::kSubroutine;
    const source::Range range{section.range.begin, EndOfNetworks(tree, section.networks, section.range.end)};
    definitions.push_back(
        {.name = SectionTitle(section),
         .kind = DefinitionKind::kRoutine,
         .name_range = is_subroutine ? SecondWord(sources, section.range, section.keyword) : section.keyword,
         .range = range,
         .scope = {},
         .address = {},
         .detail = section.name,
         .comment = {}});
    for (uint32_t i = 0; i < section.networks.count; ++i) {
      const Network& network = tree.networks[NetworkId(section.networks.first + i)];
      if (network.is_stray) continue;
      const source::Range name = SecondWord(sources, network.range, network.keyword);
      definitions.push_back(
          {.name = std::string(sources.Text(name)),
           .kind = DefinitionKind::kLabel,
           .name_range = name,
           .range = {network.range.begin, EndOfNetworks(tree, {section.networks.first + i, 1}, network.range.end)},
           .scope = range,
           .address = {},
           .detail = network.comment,
           .comment = {}});
    }
  }
  return definitions;
}

std::vector<dialects::Word> EditorWords() {
  std::vector<dialects::Word> words;
  const auto add = [&words](std::string_view name, Op op, std::string_view meaning) {
    const InstructionInfo& info = Info(op);
    dialects::Word word{
        .name = std::string(name), .role = TokenRole::kMnemonic, .meaning = std::string(meaning), .parameters = {}};
    for (size_t i = 0; i < info.operand_count; ++i) {
      if (info.operands[i] == OperandRole::kUnit && !meaning.empty()) continue;
      word.parameters.emplace_back(Name(info.operands[i]));
    }
    words.push_back(std::move(word));
  };
#define HOST50_INSTRUCTION(Key, Text, ...) add(Text, Op::k##Key, "");
#define HOST50_SPELLING(Text, Key) add(Text, Op::k##Key, "");
#define HOST50_TIMER_SPELLING(Text, Key, Unit) add(Text, Op::k##Key, "timer with its unit");
#include "transpiler/dialects/host50/machine/machine.def"
  for (const std::string_view word : kDirectives) {
    words.push_back({.name = std::string(word), .role = TokenRole::kKeyword, .meaning = {}, .parameters = {}});
  }
  for (const PartKind part : {PartKind::kTitle, PartKind::kSymbols, PartKind::kAlarms, PartKind::kMCodes,
                              PartKind::kFast, PartKind::kSlow, PartKind::kSub, PartKind::kLadder}) {
    words.push_back({.name = std::string(Name(part)), .role = TokenRole::kKeyword, .meaning = {}, .parameters = {}});
    words.push_back(
        {.name = "END_" + std::string(Name(part)), .role = TokenRole::kKeyword, .meaning = {}, .parameters = {}});
  }
  return words;
}

std::vector<dialects::ControlSignal> EditorSignals(const dialects::Request& request) {
  const auto predefined = request.options.find("PREDEFINED");
  const bool named = predefined != request.options.end() && EqualIgnoringCase(predefined->second, "ON");
  std::vector<dialects::ControlSignal> signals;
  for (const Signal& signal : Signals()) {
    signals.push_back({.address = ToText(signal.address),
                       .name = signal.name,
                       .meaning = signal.meaning,
                       .has_name_in_programs = named});
  }
  return signals;
}

/// Apostrophes around a symbol and the attribute after it are no part of the name.
source::Range NamePart(source::Range range, std::string_view spelling) {
  if (!spelling.starts_with('\'')) {
    const size_t dot = spelling.find('.');
    return {range.begin, dot == std::string_view::npos ? range.end : range.begin + static_cast<source::Offset>(dot)};
  }
  const size_t close = spelling.find('\'', 1);
  const auto end = close == std::string_view::npos ? range.end : range.begin + static_cast<source::Offset>(close);
  return {range.begin + 1, end};
}

std::string NameKey(std::string_view spelling) {
  const source::Range part = NamePart({1, 1 + static_cast<source::Offset>(spelling.size())}, spelling);
  return std::string(spelling.substr(part.begin - 1, part.end - part.begin));
}

}  // namespace

const dialects::Editing kEditing = {.tokens = EditorTokens,
                                    .definitions = EditorDefinitions,
                                    .key = NameKey,
                                    .name_part = NamePart,
                                    .words = EditorWords,
                                    .signals = EditorSignals};

}  // namespace plcxx::host50
