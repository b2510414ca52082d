#include "transpiler/dialects/prostep/lowering/statement_writer.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/common/statement_ids.h"
#include "transpiler/dialects/common/statement_texts.h"
#include "transpiler/dialects/prostep/lowering/registers.h"

namespace plcxx::prostep {

namespace {

/// Texts end: "A", "N" is not "AN".
void Add(dialects::TextHash& hash, std::string_view text) {
  for (const char c : text) hash.Add(c);
  hash.Add('\xFF');
}

/// What an instruction that ends a sequence takes from what stands before it.
enum class Takes : uint8_t { kS, kAx, kNothing };

Takes TakesOf(const Instruction& instruction) {
  const InstructionInfo& info = Info(instruction.op);
  if (info.s_use != SUse::kNone) return Takes::kS;
  return info.ax_use == AxUse::kReads ? Takes::kAx : Takes::kNothing;
}

bool EndsStatement(Op op) {
  return op == Op::kJump || op == Op::kJumpIf || op == Op::kEndModule || op == Op::kEndModuleIf;
}

/// What the instruction is about, when its statement is named by it.
std::string_view SubjectSpace(const Instruction& instruction) {
  return Info(instruction.op).role == Role::kEnds ? Name(instruction.operand.kind) : std::string_view();
}

}  // namespace

void StatementWriter::BeginModule(const std::vector<bool>& label_at) {
  Cut(label_at);
  if (BeginsFile()) {
    const Span header = std::ranges::find(tree_.files, module().file, &SourceFile::file)->header;
    dialects::AddComments(tree_.comments, header.first, header.count, CommentPlace::kLeading, waiting_comments_);
  }
  dialects::AddComments(tree_.comments, module().comments.first, module().comments.count, CommentPlace::kLeading,
                        waiting_comments_);
  waiting_comments_.push_back(dialects::LinesOf(sources_, module().open.begin, module().open.end));
}

/// Is it the first module in its file, where the comments at the head of the file are shown?
bool StatementWriter::BeginsFile() const {
  return std::ranges::none_of(tree_.modules, [this](const Module& other) {
    return other.file == module().file && other.open.begin < module().open.begin;
  });
}

void StatementWriter::Cut(const std::vector<bool>& label_at) {
  begins_.assign(module().instructions.count, false);
  bool after_end = false, after_border = true, sets_ax = false;
  for (uint32_t i = 0; i < module().instructions.count; ++i) {
    const Instruction& instruction = tree_.instructions[InstructionId(module().instructions.first + i)];
    const Role role = Info(instruction.op).role;
    bool begins = after_border || label_at[i];
    if (after_end) {
      const bool uses = role == Role::kEnds || role == Role::kJump;
      switch (uses ? TakesOf(instruction) : Takes::kNothing) {
        case Takes::kS:
          break;
        case Takes::kAx:
          begins |= !sets_ax;
          break;
        case Takes::kNothing:
          begins = true;
          break;
      }
    }
    if (begins) sets_ax = false;
    begins_[i] = begins;
    sets_ax |= Info(instruction.op).ax_use == AxUse::kLoadsWord;
    after_end = role == Role::kEnds;
    after_border = EndsStatement(instruction.op);
  }
}

std::string StatementWriter::SubjectOf(InstructionId first, InstructionId end) const {
  for (uint32_t i = first.index; i < end.index; ++i) {
    const Instruction& instruction = tree_.instructions[InstructionId(i)];
    if (SubjectSpace(instruction).empty()) continue;
    const Operand& operand = instruction.operand;
    return std::string(Name(operand.kind)) + std::to_string(operand.number) +
           (operand.shape() == Shape::kBit ? "_" + std::to_string(operand.bit) : "");
  }
  return module().number == 0 ? "init" : "PM" + std::to_string(module().number);
}

uint32_t StatementWriter::NumberOf(InstructionId first, InstructionId end) {
  dialects::TextHash text;
  for (uint32_t i = first.index; i < end.index; ++i) {
    const Instruction& instruction = tree_.instructions[InstructionId(i)];
    Add(text, Info(instruction.op).mnemonic);
    if (instruction.operand.exists()) Add(text, ToText(instruction.operand));
    if (instruction.target.valid()) Add(text, tree_.labels[instruction.target].name);
    for (uint32_t k = 0; k < instruction.arguments.count; ++k) {
      Add(text, ToText(Argument(instruction, k)));
    }
  }
  // The first of equal texts keeps the text's own hash; 0 is no number.
  for (uint32_t count = equal_texts_[text.value()]++;; ++count) {
    dialects::TextHash number = text;
    if (count > 0) Add(number, std::to_string(count));
    if (number.value() != 0 && used_numbers_.insert(number.value()).second) return number.value();
  }
}

source::Range StatementWriter::LinesOf(InstructionId first, InstructionId end) const {
  source::Offset begin = tree_.instructions[first].range.begin;
  for (uint32_t i = 0; i < module().labels.count; ++i) {
    const Label& label = tree_.labels[LabelId(module().labels.first + i)];
    if (label.at == first) begin = std::min(begin, label.range.begin);
  }
  return dialects::LinesOf(sources_, begin, tree_.instructions[InstructionId(end.index - 1)].whole.end);
}

void StatementWriter::Begin(uint32_t index) {
  uint32_t after = index + 1;
  while (after < begins_.size() && !begins_[after]) ++after;
  const InstructionId first(module().begin_of().index + index), end(module().begin_of().index + after);
  const Instruction& head = tree_.instructions[first];
  const source::Range lines = LinesOf(first, end);
  std::vector<source::Range> comments = std::exchange(waiting_comments_, {});
  dialects::AddComments(tree_.comments, head.comments.first, head.comments.count, CommentPlace::kLeading, comments);
  dialects::RemoveCommentsIn(lines, comments);
  const ir::StatementId id = program_.statements.Add(
      {.range = lines, .comments = std::move(comments), .subject = SubjectOf(first, end), .id = NumberOf(first, end)});
  builder_.SetRange(head.range);
  builder_.Statement(id);
}

void StatementWriter::EndModule() {
  std::vector<source::Range> comments = std::exchange(waiting_comments_, {});
  dialects::AddComments(tree_.comments, module().end_comments.first, module().end_comments.count,
                        CommentPlace::kLeading, comments);
  dialects::AddComments(tree_.comments, module().end_comments.first, module().end_comments.count,
                        CommentPlace::kTrailing, comments);
  const auto is_later = [this](const Module& other) {
    return other.file == module().file && other.open.begin > module().open.begin;
  };
  if (std::ranges::none_of(tree_.modules, is_later)) {
    const Span rest = std::ranges::find(tree_.files, module().file, &SourceFile::file)->rest;
    dialects::AddComments(tree_.comments, rest.first, rest.count, CommentPlace::kLeading, comments);
  }
  if (comments.empty()) return;
  registers_.EndStatement();
  const source::Range place{module().close.begin, module().close.begin};
  ir::Statement statement{.range = place, .comments = std::move(comments), .subject = {}, .id = 0};
  statement.id = NumberOf(module().end_of(), module().end_of());
  builder_.Statement(program_.statements.Add(std::move(statement)));
}

}  // namespace plcxx::prostep
