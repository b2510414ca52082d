#include "transpiler/dialects/technol/parser/code_reader.h"

namespace plcxx::technol {

void CodeReader::DefineLabel(const Token& token) {
  const SymbolId symbol = context_.Define(token, {.kind = SymbolKind::kLabel});
  if (!symbol.valid()) return;
  const LabelId label =
      context_.program.labels.Add({.symbol = symbol, .name = std::string(token.text), .range = token.range});
  context_.names[symbol].label = label;
  waiting_labels_.push_back(label);
  if (!CurrentUnit().valid()) in_subprograms_ = true;
}

void CodeReader::ReadLabel(const Statement& statement) {
  if (statement.label != nullptr) DefineLabel(*statement.label);
}

Pending& CodeReader::AddPending(const Statement& statement, Op op) {
  const UnitId unit = CurrentUnit();
  std::vector<Pending>& list = unit.valid() ? code_ : subprograms_;
  Program& program = context_.program;
  Instruction instruction{.op = op, .range = statement.range, .unit = unit, .expansion = context_.expansion};
  if (!statement.words.empty()) instruction.mnemonic = statement.first().range;
  if (context_.expansion.valid()) instruction.range = program.expansions[context_.expansion].call;
  instruction.labels = {.first = 0, .count = static_cast<uint32_t>(waiting_labels_.size())};
  if (!waiting_labels_.empty()) instruction.labels.first = waiting_labels_.front().index;
  for (const LabelId label : waiting_labels_) {
    program.labels[label].unit = unit;
    program.labels[label].at = InstructionId(static_cast<uint32_t>(list.size()));
  }
  waiting_labels_.clear();
  instruction.comments = comments_.TakeComments(statement);
  list.push_back({.instruction = instruction, .statement = context_.statement});
  return list.back();
}

void CodeReader::AddInstruction(const Statement& statement, Op op) {
  if (!CurrentUnit().valid()) in_subprograms_ = true;
  Pending& pending = AddPending(statement, op);
  pending.mnemonic = {.first = static_cast<uint32_t>(tokens_.size()), .count = 1};
  pending.tokens = {.first = pending.mnemonic.first + 1, .count = static_cast<uint32_t>(statement.words.size() - 1)};
  pending.instruction.faulty = context_.faulty;
  tokens_.insert(tokens_.end(), statement.words.begin(), statement.words.end());
}

Instruction& CodeReader::AddMark(Op op, const Statement& place) { return AddPending(place, op).instruction; }

void CodeReader::EndSubprograms(source::Range range) {
  if (!in_subprograms_) return;
  in_subprograms_ = false;
  AddMark(Op::kAreaEnd, {.range = range});
}

void CodeReader::AddSubprograms(source::FileId file) {
  Program& program = context_.program;
  const auto base = static_cast<uint32_t>(code_.size());
  const UnitId area = program.units.Add({.kind = UnitKind::kSubprograms,
                                         .file = file,
                                         .first = InstructionId(base),
                                         .end = InstructionId(base + static_cast<uint32_t>(subprograms_.size()))});
  for (Pending& pending : subprograms_) {
    pending.instruction.unit = area;
    code_.push_back(pending);
  }
  for (Label& label : program.labels) {
    if (label.unit.valid()) continue;
    label.unit = area;
    label.at.index += base;
  }
}

void CodeReader::Finish(source::FileId file) {
  AddSubprograms(file);
  Program& program = context_.program;
  program.instructions.Reserve(code_.size());
  for (const Pending& pending : code_) {
    program.instructions.Add(pending.instruction);
    program.statement_count += pending.mnemonic.count;
  }
  ReadOperands(code_, tokens_, context_);
}

}  // namespace plcxx::technol
