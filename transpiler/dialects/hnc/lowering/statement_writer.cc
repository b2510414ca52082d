#include "transpiler/dialects/hnc/lowering/statement_writer.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/syntax/characters.h"

namespace plcxx::hnc {

void AddCommentLines(std::string_view text, source::Offset begin, std::vector<source::Range>& to) {
  const bool block = text.starts_with("/*");
  size_t at = 2;
  const size_t stop = block && text.size() >= 4 ? text.size() - 2 : text.size();
  while (at < stop) {
    size_t end = text.find_first_of("\r\n", at);
    if (end == std::string_view::npos) end = stop;
    size_t first = at, last = end;
    while (first < last && (IsBlank(text[first]) || (block && text[first] == '*'))) ++first;
    while (last > first && (IsBlank(text[last - 1]) || (block && text[last - 1] == '*'))) --last;
    if (first < last) {
      to.push_back({begin + static_cast<source::Offset>(first), begin + static_cast<source::Offset>(last)});
    }
    at = end + 1;
  }
}

/// Comments in front of `until` that no statement has taken yet.
void StatementWriter::TakeComments(source::Offset until, std::vector<source::Range>& to) {
  while (next_comment_ < unit_.comments.size() && unit_.comments[next_comment_].range.begin < until) {
    const Comment& comment = unit_.comments[next_comment_++];
    AddCommentLines(sources_.Text(comment.range), comment.range.begin, to);
  }
}

std::string StatementWriter::SubjectOf(const Statement& statement) const {
  ExprId id = statement.expression;
  for (int depth = 0; id.valid() && depth < 16; ++depth) {
    const Expr& expr = ExprAt(id);
    switch (expr.kind) {
      case ExprKind::kVariable:
        return unit_.variables[expr.variable].name;
      case ExprKind::kCall:
        if (expr.function.valid()) return unit_.functions[expr.function].name;
        return frame_.function->name;
      case ExprKind::kPoison:
      case ExprKind::kConstant:
      case ExprKind::kString:
      case ExprKind::kFunction:
      case ExprKind::kLoad:
      case ExprKind::kDecay:
      case ExprKind::kConvert:
      case ExprKind::kCast:
      case ExprKind::kNull:
      case ExprKind::kUnary:
      case ExprKind::kBinary:
      case ExprKind::kAnd:
      case ExprKind::kOr:
      case ExprKind::kConditional:
      case ExprKind::kComma:
      case ExprKind::kAssign:
      case ExprKind::kCompoundAssign:
      case ExprKind::kIncrement:
      case ExprKind::kAddress:
      case ExprKind::kDereference:
      case ExprKind::kIndex:
      case ExprKind::kMember:
        if (!expr.a.valid()) return frame_.function->name;
        id = expr.a;
    }
  }
  return frame_.function->name;
}

void StatementWriter::MarkText(source::Range range, const std::string& subject, bool opens_block) {
  dialects::TextHash hash;
  for (const char c : frame_.function->name) hash.Add(c);
  hash.Add(' ');
  for (const char c : sources_.Text(range)) {
    if (!IsBlank(c)) hash.Add(c);
  }
  const source::Position position = sources_.Locate(range.begin);
  const source::Position end = sources_.Locate(range.end);
  const source::File& file = sources_.Get(end.file);
  const std::string_view rest = sources_.Line(end.file, end.line);
  const source::Offset line_end = file.base + file.line_starts[end.line - 1] + static_cast<source::Offset>(rest.size());
  ir::Statement statement{.range = range,
                          .comments = {},
                          .subject = subject,
                          .id = statement_ids_.Next(hash),
                          .line = position.line,
                          .opens_block = opens_block};
  TakeComments(std::max(range.end, line_end), statement.comments);
  statement_ = {.id = statement.id, .range = range};
  builder_.SetRange(range);
  builder_.Statement(program_.statements.Add(std::move(statement)));
}

void StatementWriter::Mark(StatementId id, source::Range range, bool opens_block) {
  // What one use of a macro makes has one text: the statement around it has shown it.
  const MacroUseId macro = unit_.statements[id].macro;
  if (macro.valid() && macro == marked_macro_) return;
  marked_macro_ = macro;
  MarkText(range, SubjectOf(unit_.statements[id]), opens_block);
}

void StatementWriter::CommentsAtEnd(source::Range close) {
  if (next_comment_ >= unit_.comments.size() || unit_.comments[next_comment_].range.begin >= close.begin) return;
  MarkText({close.begin, close.begin}, "", false);
}

void StatementWriter::BeginFunction(const Function& function) {
  const source::Offset begin = unit_.statements[function.body].range.begin;
  next_comment_ = static_cast<size_t>(
      std::ranges::lower_bound(unit_.comments, begin, {}, [](const Comment& c) { return c.range.begin; }) -
      unit_.comments.begin());
}

}  // namespace plcxx::hnc
