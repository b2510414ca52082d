#include "transpiler/dialects/technol/lowering/statement_writer.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/common/statement_texts.h"
#include "transpiler/dialects/technol/lowering/cell_places.h"
#include "transpiler/dialects/technol/parser/parser.h"

namespace plcxx::technol {
namespace {

constexpr uint32_t kMaxRun = 16;  // assembler lines of one statement

/// What has been set since the statement began.
struct Sequence {
  bool rlo = false, dr = false, assembler = false;
  bool acted = false;  // stored something, or called
  bool faults = false;
  uint32_t length = 0;
};

/// Does the statement end here, whatever follows?
bool EndsStatement(Op op) {
  return IsJump(op) || IsWait(op) || op == Op::kCall || op == Op::kRet || op == Op::kMechInit || op == Op::kEset ||
         op == Op::kMechanismBegin || op == Op::kMechanismEnd || op == Op::kModuleEnd;
}

/// What may report a fault whatever its operands are.
bool DividesOrConverts(Op op) {
  return op == Op::kDivb || op == Op::kDivw || op == Op::kDiv || op == Op::kIdiv || op == Op::kBcd || op == Op::kBin;
}

bool BeginsStatement(const Instruction& instruction, const Sequence& sequence) {
  const Op op = instruction.op;
  if (ReadsRlo(op)) return !sequence.rlo;
  if (ReadsDr(op)) return !sequence.dr;
  if (!Info(op).assembler) return true;  // loads, and what stands for itself
  if (IsJump(op)) return !sequence.assembler || sequence.acted;
  const bool continues = sequence.assembler || (sequence.dr && !sequence.rlo);
  return !continues || sequence.acted || sequence.length >= kMaxRun;
}

}  // namespace

bool StatementWriter::CanFault(InstructionId id) const {
  const Instruction& instruction = tree_.instructions[id];
  for (uint32_t i = 0; i < instruction.operands.count; ++i) {
    const Operand& operand = OperandOf(instruction, i);
    if (operand.kind == OperandKind::kMemory && operand.address.index != Register::kNone) return true;
  }
  if (DividesOrConverts(instruction.op)) return true;
  bool back = false;
  flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) { back |= edge == Edge::kJump && to.index <= id.index; });
  return back;
}

/// Of all routines together: one that shares instructions with another is cut as the other one is.
void StatementWriter::FindTargets() {
  is_target_.assign(tree_.instructions.size(), false);
  for (const Routine& routine : routines_.all()) {
    for (const uint32_t k : routine.subprograms) is_target_[flow_.EntryOf(k).index] = true;
    for (const InstructionId id : routine.instructions) {
      flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
        if (edge == Edge::kJump) is_target_[to.index] = true;
      });
    }
  }
}

void StatementWriter::Cut(const std::vector<bool>& label_at) {
  const std::vector<InstructionId>& instructions = frame_.routine->instructions;
  begins_.assign(instructions.size(), false);
  bool after_end = true;
  Sequence sequence;
  for (size_t i = 0; i < instructions.size(); ++i) {
    const Instruction& instruction = InstructionAt(i);
    const bool follows = i > 0 && instructions[i].index == instructions[i - 1].index + 1;
    const bool other_source = i > 0 && InstructionAt(i - 1).expansion.valid() != instruction.expansion.valid();
    const bool faults = CanFault(instructions[i]);
    // So does each segment: it begins after a wait, at a label, or at what begins a condition.
    const bool begins = after_end || label_at[i] || is_target_[instructions[i].index] || !follows || other_source ||
                        (faults && sequence.faults) || BeginsStatement(instruction, sequence);
    if (begins) sequence = {};
    begins_[i] = begins;
    const Effects effects = EffectsOf(tree_, instruction, 16);
    sequence.rlo |= (effects.writes & kRlo) != 0;
    sequence.dr |= (effects.writes & PartsOfDr(32)) != 0;
    sequence.assembler |= Info(instruction.op).assembler;
    sequence.acted |= !IsPure(tree_, instruction);
    sequence.faults |= faults;
    ++sequence.length;
    after_end = EndsStatement(instruction.op);
  }
}

size_t StatementWriter::EndOf(size_t first) const {
  size_t end = first + 1;
  while (end < begins_.size() && !begins_[end]) ++end;
  return end;
}

/// The first thing that is written, or the mechanism that is entered.
std::string StatementWriter::SubjectOf(size_t first, size_t end) const {
  for (size_t i = first; i < end; ++i) {
    const Instruction& instruction = InstructionAt(i);
    for (uint32_t k = 0; k < instruction.labels.count; ++k) {
      return tree_.labels[LabelId(instruction.labels.first + k)].name;
    }
    if (instruction.mechanism.valid()) return tree_.units[instruction.mechanism].name;
    const InstructionInfo& info = Info(instruction.op);
    const uint32_t target = info.form == Form::kFlag ? 1 : 0;
    if (info.first == Access::kRead || info.first == Access::kNone || target >= instruction.operands.count) continue;
    const Operand& operand = OperandOf(instruction, target);
    if (operand.symbol.valid()) return tree_.symbols[operand.symbol].name;
    if (operand.kind == OperandKind::kMemory) return cells_.NameOf(operand);
  }
  return frame_.routine->unit.valid() ? tree_.units[frame_.routine->unit].name : "subprogram";
}

/// From the name of the unit and the tokens alone (8.1). Instructions that several routines have are one statement,
/// with one number: a host that counts faults sees the place in the source.
uint32_t StatementWriter::NumberOf(size_t first, size_t end) {
  numbers_.resize(tree_.instructions.size());
  uint32_t& number = numbers_[frame_.routine->instructions[first].index];
  if (number != 0) return number;
  dialects::TextHash hash;
  const auto add = [&hash](std::string_view text) {
    for (const char c : text) hash.Add(c);
    hash.Add('\n');
  };
  add(program_.routines[frame_.routine->id].name);
  for (size_t i = first; i < end; ++i) add(ToText(tree_, InstructionAt(i)));
  return number = ids_.Next(hash);
}

source::Range StatementWriter::LinesOf(size_t first, size_t end) const {
  const Instruction& head = InstructionAt(first);
  source::Offset begin = head.range.begin;
  for (uint32_t i = 0; i < head.labels.count; ++i) {
    const Label& label = tree_.labels[LabelId(head.labels.first + i)];
    if (sources_.FileAt(label.range.begin) == sources_.FileAt(begin)) begin = std::min(begin, label.range.begin);
  }
  return dialects::LinesOf(sources_, begin, InstructionAt(end - 1).range.end);
}

uint32_t StatementWriter::LineOf(size_t first, size_t end) const {
  size_t at = first;
  while (at < end && !CanFault(frame_.routine->instructions[at])) ++at;
  return sources_.Locate(InstructionAt(at < end ? at : first).range.begin).line;
}

void StatementWriter::Begin(size_t first) {
  const size_t end = EndOf(first);
  const Instruction& head = InstructionAt(first);
  source::Range lines = LinesOf(first, end);
  // The line of a macro's call is above the first of its statements only.
  const bool is_shown = lines.begin == last_lines_.begin;
  if (is_shown) lines.end = lines.begin;
  last_lines_ = lines;
  AddComments(head.comments);
  std::vector<source::Range> comments = std::exchange(waiting_comments_, {});
  dialects::RemoveCommentsIn(lines, comments);
  frame_.statement = program_.statements.Add({.range = lines,
                                              .comments = std::move(comments),
                                              .subject = is_shown ? "" : SubjectOf(first, end),
                                              .id = NumberOf(first, end),
                                              .line = LineOf(first, end)});
  builder_.SetRange(head.range);
  builder_.Statement(frame_.statement);
}

void StatementWriter::AddComments(const Span& comments) {
  dialects::AddComments(tree_.comments, comments.first, comments.count, CommentPlace::kLeading, waiting_comments_);
}

void StatementWriter::AddTrailingComments(const Span& comments) {
  dialects::AddComments(tree_.comments, comments.first, comments.count, CommentPlace::kTrailing, waiting_comments_);
}

void StatementWriter::AddLines(source::Range range) {
  waiting_comments_.push_back(dialects::LinesOf(sources_, range.begin, range.end));
}

void StatementWriter::End() {
  if (waiting_comments_.empty()) return;
  registers_.EndStatement();
  const source::Range place{waiting_comments_.front().begin, waiting_comments_.front().begin};
  ir::Statement statement{.range = place, .comments = std::exchange(waiting_comments_, {}), .subject = {}, .id = 0};
  dialects::TextHash hash;
  for (const char c : program_.routines[frame_.routine->id].name) hash.Add(c);
  statement.id = ids_.Next(hash);
  builder_.Statement(program_.statements.Add(std::move(statement)));
}

}  // namespace plcxx::technol
