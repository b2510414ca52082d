#include "transpiler/dialects/host50/lowering/statement_writer.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/common/statement_texts.h"
#include "transpiler/dialects/host50/lowering/names.h"

namespace plcxx::host50 {
namespace {

bool IsLineEnd(char c) { return c == '\n' || c == '\r'; }

/// Of the tokens: blanks, line ends and comments do not count.
dialects::TextHash HashOfTokens(std::string_view text) {
  dialects::TextHash hash;
  char quote = 0;
  bool comment = false;
  for (const char c : text) {
    if (IsLineEnd(c)) {
      comment = false;
      quote = 0;
      continue;
    }
    if (comment) continue;
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == ';') {
      comment = true;
      continue;
    } else if (c == ' ' || c == '\t') {
      continue;
    }
    hash.Add(c);
  }
  return hash;
}

/// What an instruction is about, for the names of chunks: its result, or what it has a state of.
int32_t SubjectOperand(const Instruction& instruction) {
  const InstructionInfo& info = Info(instruction.op);
  for (uint32_t i = 0; i < info.operand_count; ++i) {
    const OperandRole role = info.operands[i];
    if (Writes(role) || role == OperandRole::kTimer || role == OperandRole::kCounter) return static_cast<int32_t>(i);
  }
  return -1;
}

}  // namespace

/// How comments begin is the language's matter, not the text's.
source::Range StatementWriter::TextOf(source::Range comment) const {
  while (comment.begin < comment.end && sources_.Text(comment).front() == ';') ++comment.begin;
  const std::string_view text = sources_.Text(comment);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') ++comment.begin, --comment.end;
  return comment;
}

void StatementWriter::AddComment(source::Range comment) { waiting_comments_.push_back(TextOf(comment)); }

void StatementWriter::AddComments(Span comments) {
  for (uint32_t i = 0; i < comments.count; ++i) {
    AddComment(tree_.comments[comments.first + i].range);
  }
}

source::Range StatementWriter::TakeLastComment() {
  PLCXX_CHECK(has_comments());
  const source::Range last = waiting_comments_.back();
  waiting_comments_.pop_back();
  return last;
}

/// From the first to the end of the last one's line: what stands there is a row comment. A drawing's rows are whole.
source::Range StatementWriter::LinesOf(source::Range first, source::Range last, bool is_drawing) const {
  const source::File& file = sources_.Get(sources_.FileAt(first.begin));
  size_t begin = first.begin - file.base, end = last.end - file.base;
  while (end < file.text.size() && !IsLineEnd(file.text[end])) ++end;
  while (end > begin && (file.text[end - 1] == ' ' || file.text[end - 1] == '\t')) --end;
  while (is_drawing && begin > 0 && !IsLineEnd(file.text[begin - 1])) --begin;
  return {file.base + static_cast<source::Offset>(begin), file.base + static_cast<source::Offset>(end)};
}

/// Of the first instruction that writes something or has a state; else "CALL" or the like.
std::string StatementWriter::SubjectOf(Span rung) const {
  std::string otherwise;
  for (uint32_t i = 0; i < rung.count; ++i) {
    const Instruction& instruction = tree_.instructions[InstructionId(rung.first + i)];
    if (instruction.op == Op::kCall) {
      return SubroutineName(tree_.sections[OperandOf(instruction, 0).section].number);
    }
    const int32_t operand = SubjectOperand(instruction);
    if (operand >= 0) return names_.InCode(OperandOf(instruction, static_cast<uint32_t>(operand)).address);
    if (otherwise.empty() && Info(instruction.op).form == Form::kBlock) otherwise = Info(instruction.op).name;
  }
  return otherwise;
}

uint32_t StatementWriter::Add(source::Range range, std::string subject) {
  const uint32_t number = statement_ids_.Next(HashOfTokens(sources_.Text(range)));
  const ir::StatementId id = program_.statements.Add(
      {.range = range, .comments = std::exchange(waiting_comments_, {}), .subject = std::move(subject), .id = number});
  builder_.SetRange(range);
  builder_.Statement(id);
  return number;
}

void StatementWriter::Begin(Span rung) {
  // A drawing is executed in another order than its rows.
  source::Range first = tree_.instructions[InstructionId(rung.first)].range, last = first;
  for (uint32_t i = 0; i < rung.count; ++i) {
    const Instruction& instruction = tree_.instructions[InstructionId(rung.first + i)];
    if (instruction.range.begin < first.begin) first = instruction.range;
    if (instruction.range.end > last.end) last = instruction.range;
    AddComments(instruction.comments);
  }
  const source::Range range = LinesOf(first, last, tree_.networks[now_.network].is_drawing);
  // Row comments, and comments between the lines, are part of the lines.
  std::erase_if(waiting_comments_, [&range](source::Range comment) { return comment.begin >= range.begin; });
  now_.statement_id = Add(range, SubjectOf(rung));
}

}  // namespace plcxx::host50
