// Which instructions are one statement, and what generated code says above it.
//
// A statement is what a reader sees as one: a logic sequence with all that uses its RLO, a load with what is computed
// and stored, a run of assembler lines that form expressions. Its text is lines of the source as they stand.

#include <algorithm>
#include <utility>

#include "transpiler/dialects/technol/lowering/internal.h"
#include "transpiler/dialects/technol/parser.h"

namespace plcxx::technol {
namespace {

constexpr uint32_t kLongestRun = 16;  // assembler lines of one statement

/// What has been set since the statement began.
struct Sequence {
  bool rlo = false, dr = false, assembler = false;
  bool acted = false;  // stored something, or called
  bool faults = false;
  uint32_t length = 0;
};

/// Does the statement end here, whatever follows?
bool EndsStatement(Op op) {
  if (IsJump(op) || IsWait(op)) return true;
  switch (op) {
    case Op::kCall:
    case Op::kRet:
    case Op::kMechInit:
    case Op::kEset:
    case Op::kMechanismBegin:
    case Op::kMechanismEnd:
    case Op::kModuleEnd:
      return true;
    default:
      return false;
  }
}

bool BeginsStatement(const Instruction& instruction, const Sequence& sequence) {
  const Op op = instruction.op;
  if (ReadsRlo(op)) return !sequence.rlo;
  if (ReadsDr(op)) return !sequence.dr;
  if (!Info(op).assembler) return true;  // loads, and what stands for itself
  if (IsJump(op)) return !sequence.assembler || sequence.acted;
  const bool continues = sequence.assembler || (sequence.dr && !sequence.rlo);
  return !continues || sequence.acted || sequence.length >= kLongestRun;
}

}  // namespace

bool Lowering::CanFault(InstructionId id) const {
  const Instruction& instruction = tree_.instructions[id];
  for (uint32_t i = 0; i < instruction.operands.count; ++i) {
    const Operand& operand = tree_.OperandOf(instruction, i);
    if (operand.kind == OperandKind::kMemory && operand.address.index != Register::kNone) return true;
  }
  switch (instruction.op) {
    case Op::kDivb:
    case Op::kDivw:
    case Op::kDiv:
    case Op::kIdiv:
    case Op::kBcd:
    case Op::kBin:
      return true;
    default:
      break;
  }
  bool back = false;
  flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) { back |= edge == Edge::kJump && to.index <= id.index; });
  return back;
}

/// Of all routines together: one that shares instructions with another is cut as the other one is.
void Lowering::FindTargets() {
  is_target_.assign(tree_.instructions.size(), false);
  for (const Body& body : bodies_) {
    for (const uint32_t k : body.subprograms) is_target_[flow_.EntryOf(k).index] = true;
    for (const InstructionId id : body.instructions) {
      flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
        if (edge == Edge::kJump) is_target_[to.index] = true;
      });
    }
  }
}

void Lowering::CutStatements(const Body& body) {
  begins_statement_.assign(body.instructions.size(), false);
  bool behind_end = true;
  Sequence sequence;
  for (size_t i = 0; i < body.instructions.size(); ++i) {
    const Instruction& instruction = tree_.instructions[body.instructions[i]];
    const bool follows = i > 0 && body.instructions[i].index == body.instructions[i - 1].index + 1;
    const bool other_source =
        i > 0 && tree_.instructions[body.instructions[i - 1]].expansion.valid() != instruction.expansion.valid();
    const bool faults = CanFault(body.instructions[i]);
    const bool begins = behind_end || label_at_[i] || is_target_[body.instructions[i].index] ||
                        stretches_.contains(body.instructions[i]) || !follows || other_source ||
                        (faults && sequence.faults) || BeginsStatement(instruction, sequence);
    if (begins) sequence = {};
    begins_statement_[i] = begins;
    const Effects effects = EffectsOf(tree_, instruction, 16);
    sequence.rlo |= (effects.writes & kRlo) != 0;
    sequence.dr |= (effects.writes & PartsOfDr(32)) != 0;
    sequence.assembler |= Info(instruction.op).assembler;
    sequence.acted |= !IsPure(tree_, instruction);
    sequence.faults |= faults;
    ++sequence.length;
    behind_end = EndsStatement(instruction.op);
  }
}

/// The first thing that is written, or the mechanism that is entered.
std::string Lowering::SubjectOf(size_t first, size_t end) const {
  for (size_t i = first; i < end; ++i) {
    const Instruction& instruction = tree_.instructions[body_->instructions[i]];
    for (uint32_t k = 0; k < instruction.labels.count; ++k) {
      return tree_.labels[LabelId(instruction.labels.first + k)].name;
    }
    if (instruction.mechanism.valid()) return tree_.units[instruction.mechanism].name;
    const InstructionInfo& info = Info(instruction.op);
    const uint32_t target = info.form == Form::kFlag ? 1 : 0;
    if (info.first == Access::kRead || info.first == Access::kNone || target >= instruction.operands.count) continue;
    const Operand& operand = tree_.OperandOf(instruction, target);
    if (operand.symbol.valid()) return tree_.symbols[operand.symbol].name;
    if (operand.kind == OperandKind::kMemory) return NameOf(operand);
  }
  return body_->unit.valid() ? tree_.units[body_->unit].name : "subprogram";
}

/// From the name of the unit and the tokens alone (8.1). Instructions that several routines have are one statement,
/// with one number: a host that counts faults sees the place in the source.
uint32_t Lowering::StatementNumber(size_t first, size_t end) {
  statement_numbers_.resize(tree_.instructions.size());
  uint32_t& number = statement_numbers_[body_->instructions[first].index];
  if (number != 0) return number;
  dialects::TextHash hash;
  const auto add = [&hash](std::string_view text) {
    for (const char c : text) hash.Add(c);
    hash.Add('\n');
  };
  add(program_.routines[body_->routine].name);
  for (size_t i = first; i < end; ++i) add(ToText(tree_, tree_.instructions[body_->instructions[i]]));
  return number = statement_ids_.Next(hash);
}

void Lowering::BeginStatement(size_t first, size_t end) {
  const Instruction& head = tree_.instructions[body_->instructions[first]];
  const Instruction& last = tree_.instructions[body_->instructions[end - 1]];
  source::Offset begin = head.range.begin;
  for (uint32_t i = 0; i < head.labels.count; ++i) {
    const Label& label = tree_.labels[LabelId(head.labels.first + i)];
    if (sources_.FileAt(label.range.begin) == sources_.FileAt(begin)) begin = std::min(begin, label.range.begin);
  }
  source::Range lines = dialects::LinesOf(sources_, begin, last.range.end);
  // The line of a macro's call stands above the first of its statements only.
  const bool is_told = lines.begin == last_lines_.begin;
  if (is_told) lines.end = lines.begin;
  last_lines_ = lines;
  std::vector<source::Range> comments = std::exchange(waiting_comments_, {});
  dialects::AddComments(tree_.comments, head.comments.first, head.comments.count, CommentPlace::kLeading, comments);
  dialects::RemoveCommentsIn(lines, comments);
  uint32_t line = sources_.Locate(head.range.begin).line;
  for (size_t i = first; i < end; ++i) {
    if (!CanFault(body_->instructions[i])) continue;
    line = sources_.Locate(tree_.instructions[body_->instructions[i]].range.begin).line;
    break;
  }
  statement_ = program_.statements.Add({.range = lines,
                                        .comments = std::move(comments),
                                        .subject = is_told ? "" : SubjectOf(first, end),
                                        .id = StatementNumber(first, end),
                                        .line = line});
  builder_.SetRange(head.range);
  builder_.Statement(statement_);
}

/// What stands in front of the end of a module belongs to no instruction.
void Lowering::EndComments(const Body& /*body*/) {
  if (waiting_comments_.empty()) return;
  registers_.EndStatement();
  const source::Range place{waiting_comments_.front().begin, waiting_comments_.front().begin};
  ir::Statement statement{.range = place, .comments = std::exchange(waiting_comments_, {}), .subject = {}, .id = 0};
  dialects::TextHash hash;
  for (const char c : program_.routines[body_->routine].name) hash.Add(c);
  statement.id = statement_ids_.Next(hash);
  builder_.Statement(program_.statements.Add(std::move(statement)));
}

}  // namespace plcxx::technol
