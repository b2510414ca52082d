#include "transpiler/dialects/technol/parser/internal.h"

namespace plcxx::technol {

bool Parser::IsOutside(const Statement& statement) {
  const std::string_view text = statement.words.empty() ? statement.label->text : statement.first().text;
  if (including_.size() > 1) {
    context_.Report(statement.range, diag::TechnolCodeInInclude, text);
    return true;
  }
  return false;
}

/// Instructions and labels: not in an include file, not in data.
bool Parser::IsCodePlace(const Statement& statement) {
  if (IsOutside(statement)) return false;
  if (!in_data_) return true;
  const std::string_view text = statement.words.empty() ? statement.label->text : statement.first().text;
  context_.Report(statement.range, diag::TechnolCodeInData, text);
  return false;
}

/// Nothing may follow the first `words` words.
bool Parser::ExpectEnd(const Statement& statement, size_t words) {
  if (statement.words.size() <= words) return true;
  const Token& surplus = statement.words[words];
  context_.Report(surplus.range, diag::TechnolSurplus, Shown(&surplus), statement.first().text);
  return false;
}

void Parser::DefineLabel(const Token& token) {
  const SymbolId symbol = context_.Define(token, {.kind = SymbolKind::kLabel});
  if (!symbol.valid()) return;
  const LabelId label =
      context_.program.labels.Add({.symbol = symbol, .name = std::string(token.text), .range = token.range});
  context_.names[symbol].label = label;
  waiting_labels_.push_back(label);
  if (!CurrentUnit().valid()) stretch_open_ = true;
}

void Parser::TakeLabel(const Statement& statement) {
  if (statement.label != nullptr) DefineLabel(*statement.label);
}

Pending& Parser::AddPending(const Statement& statement, Op op) {
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
  instruction.comments = TakeComments(statement);
  list.push_back({.instruction = instruction, .statement = context_.statement});
  return list.back();
}

void Parser::TakeInstruction(const Statement& statement, Op op) {
  if (!IsCodePlace(statement)) return;
  TakeLabel(statement);
  if (!CurrentUnit().valid()) {
    const bool forgiven = !abandoned_modules_.empty() || !abandoned_mechanisms_.empty();
    if (!stretch_open_ && !forgiven) {
      context_.Report(statement.range, diag::TechnolStrayLine, statement.first().text,
                      "stands outside modules and has no label");
    }
    stretch_open_ = true;
  }
  Pending& pending = AddPending(statement, op);
  pending.mnemonic = {.first = static_cast<uint32_t>(code_tokens_.size()), .count = 1};
  pending.tokens = {.first = pending.mnemonic.first + 1, .count = static_cast<uint32_t>(statement.words.size() - 1)};
  pending.instruction.faulty = context_.faulty;
  code_tokens_.insert(code_tokens_.end(), statement.words.begin(), statement.words.end());
}

/// Subprograms end here: who runs on has lost its RET.
void Parser::EndStretch(source::Range range) {
  if (!stretch_open_) return;
  stretch_open_ = false;
  Statement mark{.range = range};
  AddPending(mark, Op::kAreaEnd);
}

void Parser::OpenModule(const Statement& statement, ModuleKind kind) {
  if (IsOutside(statement)) return;
  const std::string name(statement.first().text);
  if (in_data_) {
    context_.Report(statement.range, diag::TechnolCodeInData, name);
    in_data_ = false;  // one cause: the missing DATA_END
  }
  if (mechanism_.valid()) {
    Unit& open = context_.program.units[mechanism_];
    context_.Report(statement.range, diag::TechnolMechanismNotClosed, open.name);
    LeaveMechanism({});
  }
  if (module_.valid()) {
    const Unit& open = context_.program.units[module_];
    context_.Report(statement.range, diag::TechnolModuleInside, name, open.name)
        .notes.push_back({open.open, "it was opened here"});
    abandoned_modules_.insert(Upper(open.name));
    LeaveModule({});
  }
  TakeLabel(statement);
  EndStretch(statement.range);
  const auto [first, is_new] = modules_.emplace(Upper(name), statement.range);
  if (!is_new) {
    context_.Report(statement.range, diag::TechnolModuleTwice, name)
        .notes.push_back({first->second, "it is opened here"});
  }
  if (kind == ModuleKind::kOther) context_.Report(statement.first().range, diag::TechnolOtherModule, name);
  if (Info(kind).completion) WarnOfCompletion(statement.first());
  Unit unit{.kind = UnitKind::kModule, .module = kind, .name = name, .file = file_, .open = statement.range};
  unit.first = InstructionId(static_cast<uint32_t>(code_.size()));
  unit.comments = TakeComments(statement);
  ExpectEnd(statement, 1);
  module_ = context_.program.units.Add(std::move(unit));
  context_.program.units[module_].faulty = context_.faulty;
}

void Parser::LeaveModule(source::Range close) {
  Statement mark{.range = close};
  AddPending(mark, Op::kModuleEnd);
  Unit& unit = context_.program.units[module_];
  unit.end = InstructionId(static_cast<uint32_t>(code_.size() - 1));
  unit.close = close;
  module_ = {};
}

void Parser::CloseModule(const Statement& statement, std::string_view keyword) {
  if (IsOutside(statement)) return;
  if (in_data_) {
    context_.Report(statement.range, diag::TechnolCodeInData, statement.first().text);
    return;
  }
  if (mechanism_.valid()) {
    context_.Report(statement.range, diag::TechnolMechanismNotClosed, context_.program.units[mechanism_].name);
    LeaveMechanism({});
  }
  if (abandoned_modules_.erase(std::string(keyword)) > 0) return;
  if (!module_.valid()) {
    context_.Report(statement.range, diag::TechnolModuleNotOpen, statement.first().text);
    return;
  }
  Unit& open = context_.program.units[module_];
  if (Upper(open.name) != keyword) {
    open.faulty = true;
    context_.Report(statement.range, diag::TechnolModuleClosedByOther, open.name, statement.first().text)
        .notes.push_back({open.open, "it was opened here"});
  }
  ExpectEnd(statement, 1);
  TakeLabel(statement);
  if (statement.comment != nullptr) AddComment(*statement.comment, CommentPlace::kTrailing);
  LeaveModule(statement.range);
}

void Parser::OpenMechanism(const Statement& statement) {
  if (!IsCodePlace(statement)) return;
  if (statement.words.size() < 2 || statement.words[1].kind != TokenKind::kWord) {
    context_.Report(statement.range, diag::TechnolOperandMissing, "MECH_BEGIN", "the name of the mechanism");
    return;
  }
  const Token& name = statement.words[1];
  if (mechanism_.valid()) {
    Unit& open = context_.program.units[mechanism_];
    context_.Report(statement.range, diag::TechnolMechanismNested, name.text, open.name)
        .notes.push_back({open.open, "it was opened here"});
    abandoned_mechanisms_.insert(context_.names.Fold(open.name));
    LeaveMechanism({});
  }
  if (module_.valid() && !Info(context_.program.units[module_].module).mechanisms) {
    context_.Report(statement.range, diag::TechnolMechanismPlace, name.text, context_.program.units[module_].name);
  }
  ExpectEnd(statement, 2);
  TakeLabel(statement);
  if (!module_.valid()) EndStretch(statement.range);
  const SymbolId symbol = context_.Define(name, {.kind = SymbolKind::kMechanism, .width = 1});
  Unit unit{.kind = UnitKind::kMechanism,
            .faulty = context_.faulty,
            .name = std::string(name.text),
            .symbol = symbol,
            .parent = module_,
            .file = file_,
            .open = statement.range};
  unit.first = InstructionId(static_cast<uint32_t>(code_.size()));
  const UnitId mechanism = context_.program.units.Add(std::move(unit));
  if (symbol.valid()) {
    context_.names[symbol].unit = mechanism;
    context_.names[symbol].faulty = context_.faulty;
  }
  if (!module_.valid()) mechanism_ = mechanism;  // nothing is around it: its beginning is its own
  AddPending(statement, Op::kMechanismBegin).instruction.mechanism = mechanism;
  mechanism_ = mechanism;
}

void Parser::LeaveMechanism(source::Range close) {
  Statement mark{.range = close};
  AddPending(mark, Op::kMechanismEnd).instruction.mechanism = mechanism_;
  Unit& unit = context_.program.units[mechanism_];
  unit.end = InstructionId(static_cast<uint32_t>(code_.size() - 1));
  unit.close = close;
  unit.faulty |= close.begin == close.end;
  mechanism_ = {};
}

void Parser::CloseMechanism(const Statement& statement) {
  if (!IsCodePlace(statement)) return;
  if (statement.words.size() < 2 || statement.words[1].kind != TokenKind::kWord) {
    context_.Report(statement.range, diag::TechnolOperandMissing, "MECH_END", "the name of the mechanism");
    if (mechanism_.valid()) LeaveMechanism(statement.range);
    return;
  }
  const Token& name = statement.words[1];
  const std::string folded = context_.names.Fold(name.text);
  if (!mechanism_.valid() || folded != context_.names.Fold(context_.program.units[mechanism_].name)) {
    if (abandoned_mechanisms_.erase(folded) > 0) return;
    if (!mechanism_.valid()) {
      context_.Report(statement.range, diag::TechnolMechEndWithout, name.text);
      return;
    }
    Unit& open = context_.program.units[mechanism_];
    open.faulty = true;
    context_.Report(statement.range, diag::TechnolMechEndName, name.text, open.name)
        .notes.push_back({open.open, "it was opened here"});
  }
  ExpectEnd(statement, 2);
  TakeLabel(statement);
  if (statement.comment != nullptr) AddComment(*statement.comment, CommentPlace::kTrailing);
  LeaveMechanism(statement.range);
}

void Parser::OpenData(const Statement& statement) {
  if (IsOutside(statement)) return;
  if (in_data_) {
    context_.Report(statement.range, diag::TechnolCodeInData, "DATA");
    return;
  }
  if (mechanism_.valid()) {
    context_.Report(statement.range, diag::TechnolMechanismNotClosed, context_.program.units[mechanism_].name);
    LeaveMechanism({});
  }
  if (module_.valid()) {
    const Unit& open = context_.program.units[module_];
    context_.Report(statement.range, diag::TechnolModuleNotClosed, open.name)
        .notes.push_back({open.open, "it was opened here"});
    abandoned_modules_.insert(Upper(open.name));
    LeaveModule({});
  }
  ExpectEnd(statement, 1);
  TakeLabel(statement);
  in_data_ = has_data_ = true;
}

void Parser::CloseData(const Statement& statement) {
  if (IsOutside(statement)) return;
  if (!in_data_) {
    context_.Report(statement.range, diag::TechnolStrayLine, statement.first().text,
                    "closes a data block that is not open");
    return;
  }
  ExpectEnd(statement, 1);
  in_data_ = false;
  TakeLabel(statement);
}

void Parser::TakeStop(const Statement& statement) {
  if (IsOutside(statement)) return;
  ExpectEnd(statement, 1);
  if (in_data_) {
    context_.Report(statement.range, diag::TechnolDataNotClosed);
    in_data_ = false;
  }
  if (mechanism_.valid()) {
    context_.Report(statement.range, diag::TechnolMechanismNotClosed, context_.program.units[mechanism_].name);
    LeaveMechanism({});
  }
  if (module_.valid()) {
    context_.Report(statement.range, diag::TechnolModuleNotClosed, context_.program.units[module_].name);
    LeaveModule({});
  }
  TakeLabel(statement);
  EndStretch(statement.range);
  if (file_ != last_source_) context_.Report(statement.range, diag::TechnolStopNotLast);
  stopped_ = has_stop_ = true;
}

}  // namespace plcxx::technol
