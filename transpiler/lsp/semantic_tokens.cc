// The words of a file for colours, and what can be folded away.
#include <algorithm>
#include <array>

#include "transpiler/lsp/features.h"

namespace plcxx::lsp {
namespace {

using dialects::Definition;
using dialects::DefinitionKind;
using dialects::EditorToken;
using dialects::TokenRole;

/// Of the protocol's standard names; the order is the legend.
enum class TokenType : uint8_t {
  kComment,
  kKeyword,
  kFunction,
  kVariable,
  kParameter,
  kProperty,
  kEnumMember,
  kType,
  kMacro,
  kLabel,
  kNumber,
  kString,
  kOperator,
};
constexpr std::array<std::string_view, 13> kLegend = {"comment",  "keyword",    "function", "variable", "parameter",
                                                      "property", "enumMember", "type",     "macro",    "label",
                                                      "number",   "string",     "operator"};
static_assert(kLegend.size() == static_cast<size_t>(TokenType::kOperator) + 1);

TokenType TypeOf(DefinitionKind kind) {
  switch (kind) {
    case DefinitionKind::kSignal:
    case DefinitionKind::kVariable:
      return TokenType::kVariable;
    case DefinitionKind::kConstant:
      return TokenType::kEnumMember;
    case DefinitionKind::kParameter:
      return TokenType::kParameter;
    case DefinitionKind::kLabel:
      return TokenType::kLabel;
    case DefinitionKind::kRoutine:
    case DefinitionKind::kBlock:
      return TokenType::kFunction;
    case DefinitionKind::kMacro:
      return TokenType::kMacro;
    case DefinitionKind::kType:
      return TokenType::kType;
    case DefinitionKind::kField:
      return TokenType::kProperty;
  }
  return TokenType::kVariable;
}

TokenType TypeOf(const Names& names, const EditorToken& token) {
  switch (token.role) {
    case TokenRole::kComment:
      return TokenType::kComment;
    case TokenRole::kKeyword:
    case TokenRole::kMnemonic:
      return TokenType::kKeyword;
    case TokenRole::kFunction:
      return TokenType::kFunction;
    case TokenRole::kAddress:
      return TokenType::kVariable;
    case TokenRole::kName:
    case TokenRole::kMember: {
      const Target target = names.TargetOf(token);
      if (target.definition != kNoDefinition) return TypeOf(names.definitions()[target.definition].kind);
      return token.role == TokenRole::kMember ? TokenType::kProperty : TokenType::kVariable;
    }
    case TokenRole::kNumber:
      return TokenType::kNumber;
    case TokenRole::kText:
      return TokenType::kString;
    case TokenRole::kOperator:
      return TokenType::kOperator;
  }
  return TokenType::kOperator;
}

class TokenData {
 public:
  void Add(Position begin, int64_t length, TokenType type) {
    if (length <= 0) return;
    data_.push_back(begin.line - last_.line);
    data_.push_back(begin.line == last_.line ? begin.character - last_.character : begin.character);
    data_.push_back(length);
    data_.push_back(static_cast<int>(type));
    data_.push_back(0);
    last_ = begin;
  }
  Json Take() { return std::move(data_); }

 private:
  Position last_;
  Json data_ = Json::array();
};

/// Lines that hold nothing but comments.
void AddCommentBlocks(const FeatureContext& context, Json& foldings) {
  int64_t first = -2, last = -2, line_of_code = -1;
  const auto close = [&] {
    if (last > first) foldings.push_back({{"startLine", first}, {"endLine", last}, {"kind", "comment"}});
  };
  for (const EditorToken& token : context.names.TokensOf(context.file)) {
    const FileRange at = context.analysis.Locate(token.range);
    if (token.role != TokenRole::kComment) {
      line_of_code = at.end.line;
      continue;
    }
    if (at.begin.line == line_of_code) continue;
    if (at.begin.line != last + 1 || line_of_code > last) {
      close();
      first = at.begin.line;
    }
    last = at.end.line;
  }
  close();
}

}  // namespace

Json SemanticTokensLegend() {
  Json types = Json::array();
  for (const std::string_view name : kLegend) types.push_back(name);
  return {{"tokenTypes", types}, {"tokenModifiers", Json::array()}};
}

Json SemanticTokens(const FeatureContext& context, const Json&) {
  TokenData data;
  for (const EditorToken& token : context.names.TokensOf(context.file)) {
    const FileRange at = context.analysis.Locate(token.range);
    const TokenType type = TypeOf(context.names, token);
    if (at.begin.line == at.end.line) {
      data.Add(at.begin, at.end.character - at.begin.character, type);
      continue;
    }
    // A comment of several lines is one token a line, as most clients want it.
    const Lines& lines = context.analysis.LinesOf(context.file);
    constexpr int64_t kEndOfLine = INT32_MAX;
    for (int64_t line = at.begin.line; line <= at.end.line; ++line) {
      const Position begin = line == at.begin.line ? at.begin : Position{line, 0};
      const Position end = line == at.end.line ? at.end : lines.At(lines.Offset({line, kEndOfLine}));
      data.Add(begin, end.character - begin.character, type);
    }
  }
  return {{"data", data.Take()}};
}

Json FoldingRanges(const FeatureContext& context, const Json&) {
  Json foldings = Json::array();
  for (const Definition& definition : context.names.definitions()) {
    if (definition.range.begin == 0 || context.analysis.sources().FileAt(definition.range.begin) != context.file)
      continue;
    const FileRange at = context.analysis.Locate(definition.range);
    if (at.end.line > at.begin.line) foldings.push_back({{"startLine", at.begin.line}, {"endLine", at.end.line}});
  }
  AddCommentBlocks(context, foldings);
  return foldings;
}

}  // namespace plcxx::lsp
