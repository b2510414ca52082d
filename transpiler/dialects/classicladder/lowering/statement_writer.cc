#include "transpiler/dialects/classicladder/lowering/statement_writer.h"

#include <utility>
#include <vector>

#include "transpiler/dialects/common/statement_texts.h"

namespace plcxx::classicladder {

std::string StatementWriter::SubjectOf(const Rung& rung) const {
  for (const auto& row : rung.rows) {
    for (const Element& element : row) {
      switch (element.kind) {
        case ElementKind::kCoil:
        case ElementKind::kCoilNot:
        case ElementKind::kSet:
        case ElementKind::kReset:
          return names_.Of(element.variable.address);
        case ElementKind::kTimer:
          return "T" + std::to_string(element.number);
        case ElementKind::kMonostable:
          return "M" + std::to_string(element.number);
        case ElementKind::kCounter:
          return "C" + std::to_string(element.number);
        case ElementKind::kTimerIec:
          return "TM" + std::to_string(element.number);
        case ElementKind::kOperate: {
          const Expression& operation = tree_.operations.at(element.number);
          if (!operation.empty) return names_.Of(operation.target.address);
          break;
        }
        case ElementKind::kCall:
          return "SR" + std::to_string(element.number);
        case ElementKind::kFree:
        case ElementKind::kContact:
        case ElementKind::kContactNot:
        case ElementKind::kRising:
        case ElementKind::kFalling:
        case ElementKind::kWire:
        case ElementKind::kCompare:
        case ElementKind::kJump:
        case ElementKind::kPart:
          break;
      }
    }
  }
  return "rung" + std::to_string(rung.number);
}

void StatementWriter::Begin(const Rung& rung) {
  size_t rows = 0;
  for (size_t y = 0; y < rung.lines.size(); ++y) {
    for (const Element& element : rung.rows[y]) {
      if (element.kind != ElementKind::kFree) rows = y + 1;
    }
  }
  const source::Range range = rows == 0 ? rung.range : source::Range{rung.lines[0].begin, rung.lines[rows - 1].end};
  dialects::TextHash hash;
  for (const char c : sources_.Text(range)) {
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') hash.Add(c);
  }
  std::vector<source::Range> comments;
  if (rung.label_range.end > rung.label_range.begin) comments.push_back(rung.label_range);
  if (rung.comment_range.end > rung.comment_range.begin) comments.push_back(rung.comment_range);
  const ir::StatementId statement = program_.statements.Add(
      {.range = range, .comments = std::move(comments), .subject = SubjectOf(rung), .id = ids_.Next(hash)});
  builder_.SetRange(range);
  builder_.Statement(statement);
}

void StatementWriter::Begin(const Section& page) {
  dialects::TextHash hash;
  for (const char c : sources_.Text(page.range)) hash.Add(c);
  builder_.SetRange(page.range);
  builder_.Statement(program_.statements.Add(
      {.range = page.range, .comments = {}, .subject = "page" + std::to_string(page.page), .id = ids_.Next(hash)}));
}

}  // namespace plcxx::classicladder
