#include "transpiler/dialects/nc110/lowering/statement_writer.h"

#include <string>
#include <string_view>
#include <utility>

#include "transpiler/dialects/common/statement_texts.h"

namespace plcxx::nc110 {
namespace {

/// Of the tokens: blanks, line ends and comments do not count.
dialects::TextHash HashOfTokens(std::string_view text) {
  dialects::TextHash hash;
  bool quoted = false, comment = false;
  for (const char c : text) {
    if (comment) {
      comment = c != '\n' && c != '\r';
      continue;
    }
    if (c == '"') quoted = !quoted;
    if (!quoted) {
      if (c == ';') comment = true;
      if (c == ';' || c == ' ' || c == '\t' || c == '\f' || c == '\n' || c == '\r') continue;
    }
    hash.Add(c);
  }
  return hash;
}

std::string SubjectOf(const Operand& operand) {
  std::string text = ToText(operand);
  // T5I and T5A are both about timer 5.
  if (operand.kind != OperandKind::kOneShot && operand.kind != OperandKind::kNone && !IsMemory(operand))
    text.pop_back();
  return text;
}

}  // namespace

/// The comment without its ';': how a comment begins is the language's matter, not the text's.
source::Range StatementWriter::TextOf(const Comment& comment) const {
  source::Range range = comment.range;
  while (range.begin < range.end && sources_.Text(range).front() == ';') ++range.begin;
  return range;
}

void StatementWriter::AddComments(const Item& item) {
  for (uint32_t i = 0; i < item.comment_count; ++i) {
    waiting_comments_.push_back(TextOf(tree_.comments[item.first_comment + i]));
  }
}

void StatementWriter::AddFileComments(ItemId next) {
  const auto add = [this](const Span& span) {
    for (uint32_t i = 0; i < span.count; ++i) waiting_comments_.push_back(TextOf(tree_.comments[span.first + i]));
  };
  // Heads of the files that begin here, and what stands after the last item of the files before.
  while (next_file_ < tree_.files.size() && tree_.files[next_file_].items.first <= next.index) {
    if (next_file_ > 0 && !tree_.files[next_file_ - 1].is_symbol_file) add(tree_.files[next_file_ - 1].rest);
    if (!tree_.files[next_file_].is_symbol_file) add(tree_.files[next_file_].header);
    ++next_file_;
  }
}

ir::StatementId StatementWriter::Begin(ItemId id) {
  const Item& item = tree_.items[id];
  AddComments(item);
  ir::Statement statement{.range = item.range,
                          .comments = std::exchange(waiting_comments_, {}),
                          .subject = {},
                          .id = statement_ids_.Next(HashOfTokens(sources_.Text(item.range)))};
  switch (item.kind) {
    case ItemKind::kAssignment:
      statement.subject = SubjectOf(tree_.assignments[item.assignment()].target.operand);
      break;
    case ItemKind::kBlockHead: {
      const Block& block = tree_.blocks[item.block()];
      const bool named = block.name.begin != block.name.end;
      statement.subject = named ? std::string(sources_.Text(block.name)) : std::string("block");
      statement.opens_block = true;
      break;
    }
    case ItemKind::kBlockEnd:
      statement.closes_block = true;
      break;
    case ItemKind::kError:
    case ItemKind::kCycleMark:
    case ItemKind::kMessage:
      break;
  }
  const ir::StatementId added = program_.statements.Add(std::move(statement));
  builder_.SetRange(item.range);
  builder_.Statement(added);
  return added;
}

}  // namespace plcxx::nc110
