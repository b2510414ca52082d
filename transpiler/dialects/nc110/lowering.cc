#include "transpiler/dialects/nc110/lowering.h"

#include <utility>

#include "transpiler/dialects/nc110/lowering_internal.h"

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

Lowering::Lowering(const Program& tree, const Settings& settings, const source::SourceManager& sources)
    : tree_(tree), settings_(settings), sources_(sources) {}

void Lowering::Reserve() {
  const size_t statements = tree_.statement_count, exprs = tree_.exprs.size();
  program_.statements.Reserve(statements);
  program_.insts.Reserve(exprs + 4 * statements + 64);
  program_.regions.Reserve(2 * size_t{tree_.blocks.size()} + tree_.mux_inputs.size() + 16);
  flags_.resize(tree_.literals.size());
}

/// The comment without its ';': how a comment begins is the language's matter, not the text's.
source::Range Lowering::TextOf(const Comment& comment) const {
  source::Range range = comment.range;
  while (range.begin < range.end && sources_.Text(range).front() == ';') ++range.begin;
  return range;
}

void Lowering::AddComments(const Item& item) {
  for (uint32_t i = 0; i < item.comment_count; ++i) {
    waiting_comments_.push_back(TextOf(tree_.comments[item.first_comment + i]));
  }
}

void Lowering::CollectFileComments(ItemId next) {
  const auto add = [this](const Span& span) {
    for (uint32_t i = 0; i < span.count; ++i) waiting_comments_.push_back(TextOf(tree_.comments[span.first + i]));
  };
  // Heads of the files that begin here, and what stands behind the last item of the files before.
  while (next_file_ < tree_.files.size() && tree_.files[next_file_].items.first <= next.index) {
    if (next_file_ > 0 && !tree_.files[next_file_ - 1].is_symbol_file) add(tree_.files[next_file_ - 1].rest);
    if (!tree_.files[next_file_].is_symbol_file) add(tree_.files[next_file_].header);
    ++next_file_;
  }
}

ir::StatementId Lowering::Begin(ItemId id) {
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

void Lowering::EnterPart(Part part) {
  CloseAll();
  part_ = part;
  builder_.SetRegion(part == Part::kFast ? fast_body_ : slow_body_);
}

void Lowering::Assign(const Item& item) {
  const Assignment& assignment = tree_.assignments[item.assignment()];
  const Operand& target = assignment.target.operand;
  if (item.faulty || target.kind == OperandKind::kNone) return;
  const bool word = TypeOf(target.kind) == Type::kWord;
  if (assignment.mux.valid()) {
    if (word) AssignMux(target, tree_.muxes[assignment.mux]);
    return;
  }
  ir::ValueId value = Evaluate(assignment.value, word ? ir::Type::kI8 : ir::Type::kBit);
  builder_.SetRange(item.range);
  if (assignment.inverted && !word) value = builder_.Pure(ir::OpKind::kBitNot, {value});
  switch (target.kind) {
    case OperandKind::kOutput:
    case OperandKind::kWord:
    case OperandKind::kTimerHold:
    case OperandKind::kCounterDown:
    case OperandKind::kCounterValue:
      return AssignMemory(target, value);
    case OperandKind::kTimerInput:
      return StepTimer(assignment, value);
    case OperandKind::kCounterInput:
      return StepCounter(assignment, value);
    case OperandKind::kCounterReset:
      builder_.Step(ir::OpKind::kResetCounter, InstanceOf(target), {value});
      return;
    case OperandKind::kOneShot:
      return StepOneShot(target, value);
    case OperandKind::kNone:
    case OperandKind::kInput:
    case OperandKind::kTimerElapsed:
    case OperandKind::kTimerRunning:
    case OperandKind::kCounterCarry:
      return;  // no targets: reported by the parser
  }
}

void Lowering::Items() {
  EnterPart(Part::kFast);
  for (uint32_t i = 0; i < tree_.items.size(); ++i) {
    const ItemId id(i);
    const Item& item = tree_.items[id];
    CollectFileComments(id);
    if (item.kind != ItemKind::kBlockHead) LeaveChain();
    switch (item.kind) {
      case ItemKind::kCycleMark:
        AddComments(item);
        if (part_ == Part::kFast) EnterPart(Part::kSlow);
        break;
      case ItemKind::kMessage:
        AddComments(item);
        break;
      case ItemKind::kAssignment:
        Begin(id);
        Assign(item);
        break;
      case ItemKind::kBlockHead:
        Head(id);
        break;
      case ItemKind::kBlockEnd:
        End(id);
        break;
      case ItemKind::kError:
        break;
    }
  }
  CloseAll();
}

ir::Program Lowering::Run() {
  program_.dialect = "nc110";
  Reserve();
  AddSpaces(program_, settings_.processes, settings_.t_initial);
  CollectSymbols();
  AddRoutines();
  Items();
  FastFrame();
  SlowFrame();
  Init();
  Period();
  FastOnly();
  MessagePlaces();
  return std::move(program_);
}

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources) {
  return Lowering(tree, settings, sources).Run();
}

}  // namespace plcxx::nc110
