#include "transpiler/dialects/technol/parser/unit_reader.h"

namespace plcxx::technol {

void UnitReader::ReadInstruction(const Statement& statement, Op op) {
  if (!IsCodePlace(statement)) return;
  code_.ReadLabel(statement);
  const bool forgiven = !abandoned_modules_.empty() || !abandoned_mechanisms_.empty();
  if (!CurrentUnit().valid() && !code_.InSubprograms() && !forgiven) {
    context_.Report(statement.range, diag::TechnolStrayLine, statement.first().text,
                    "stands outside modules and has no label");
  }
  code_.AddInstruction(statement, op);
}

bool UnitReader::IsAfterStop(source::Range line) {
  if (!stopped_) return false;
  if (!warned_after_stop_) {
    context_.Report(line, diag::TechnolBehindStop, TrimBlanks(context_.sources.Text(line)));
  }
  warned_after_stop_ = true;
  return true;
}

void UnitReader::OpenModule(const Statement& statement, ModuleKind kind) {
  if (IsOutside(statement)) return;
  const std::string name(statement.first().text);
  if (now_.in_data) {
    context_.Report(statement.range, diag::TechnolCodeInData, name);
    now_.in_data = false;  // one cause: the missing DATA_END
  }
  LeaveOpenMechanism(statement.range);
  if (now_.module.valid()) {
    const Unit& open = context_.program.units[now_.module];
    context_.Report(statement.range, diag::TechnolModuleInside, name, open.name)
        .notes.push_back({open.open, "it was opened here"});
    abandoned_modules_.insert(Upper(open.name));
    LeaveModule({});
  }
  code_.ReadLabel(statement);
  code_.EndSubprograms(statement.range);
  const auto [first, is_new] = modules_.emplace(Upper(name), statement.range);
  if (!is_new) {
    context_.Report(statement.range, diag::TechnolModuleTwice, name)
        .notes.push_back({first->second, "it is opened here"});
  }
  if (kind == ModuleKind::kOther) context_.Report(statement.first().range, diag::TechnolOtherModule, name);
  if (Info(kind).completion) WarnOfCompletion(statement.first());
  Unit unit{.kind = UnitKind::kModule, .module = kind, .name = name, .file = now_.file, .open = statement.range};
  unit.first = code_.next();
  unit.comments = comments_.TakeComments(statement);
  ExpectEnd(statement, 1);
  now_.module = context_.program.units.Add(std::move(unit));
  context_.program.units[now_.module].faulty = context_.faulty;
}

void UnitReader::LeaveModule(source::Range close) {
  code_.AddMark(Op::kModuleEnd, {.range = close});
  Unit& unit = context_.program.units[now_.module];
  unit.end = InstructionId(code_.next().index - 1);
  unit.close = close;
  now_.module = {};
}

void UnitReader::CloseModule(const Statement& statement, std::string_view keyword) {
  if (IsOutside(statement)) return;
  if (now_.in_data) {
    context_.Report(statement.range, diag::TechnolCodeInData, statement.first().text);
    return;
  }
  LeaveOpenMechanism(statement.range);
  if (abandoned_modules_.erase(std::string(keyword)) > 0) return;
  if (!now_.module.valid()) {
    context_.Report(statement.range, diag::TechnolModuleNotOpen, statement.first().text);
    return;
  }
  Unit& open = context_.program.units[now_.module];
  if (Upper(open.name) != keyword) {
    open.faulty = true;
    context_.Report(statement.range, diag::TechnolModuleClosedByOther, open.name, statement.first().text)
        .notes.push_back({open.open, "it was opened here"});
  }
  ExpectEnd(statement, 1);
  code_.ReadLabel(statement);
  comments_.AddComment(statement, CommentPlace::kTrailing);
  LeaveModule(statement.range);
}

void UnitReader::OpenMechanism(const Statement& statement) {
  if (!IsCodePlace(statement)) return;
  if (statement.words.size() < 2 || statement.words[1].kind != TokenKind::kWord) {
    context_.Report(statement.range, diag::TechnolOperandMissing, "MECH_BEGIN", "the name of the mechanism");
    if (!now_.mechanism.valid()) BeginMechanism(statement, nullptr);
    return;
  }
  const Token& name = statement.words[1];
  if (now_.mechanism.valid()) {
    Unit& open = context_.program.units[now_.mechanism];
    context_.Report(statement.range, diag::TechnolMechanismNested, name.text, open.name)
        .notes.push_back({open.open, "it was opened here"});
    abandoned_mechanisms_.insert(context_.names.Fold(open.name));
    LeaveMechanism({});
  }
  if (now_.module.valid() && !Info(context_.program.units[now_.module].module).mechanisms) {
    context_.Report(statement.range, diag::TechnolMechanismPlace, name.text, context_.program.units[now_.module].name);
  }
  ExpectEnd(statement, 2);
  BeginMechanism(statement, &name);
}

/// `name`: null where it lacks, so that the mechanism's end names it.
void UnitReader::BeginMechanism(const Statement& statement, const Token* name) {
  code_.ReadLabel(statement);
  if (!now_.module.valid()) code_.EndSubprograms(statement.range);
  const SymbolId symbol =
      name == nullptr ? SymbolId() : context_.Define(*name, {.kind = SymbolKind::kMechanism, .width = 1});
  Unit unit{.kind = UnitKind::kMechanism,
            .faulty = context_.faulty,
            .name = std::string(name == nullptr ? std::string_view() : name->text),
            .symbol = symbol,
            .parent = now_.module,
            .file = now_.file,
            .open = statement.range};
  unit.first = code_.next();
  const UnitId mechanism = context_.program.units.Add(std::move(unit));
  if (symbol.valid()) {
    context_.names[symbol].unit = mechanism;
    context_.names[symbol].faulty = context_.faulty;
  }
  if (!now_.module.valid()) now_.mechanism = mechanism;  // nothing is around it: its beginning is its own
  code_.AddMark(Op::kMechanismBegin, statement).mechanism = mechanism;
  now_.mechanism = mechanism;
}

void UnitReader::LeaveMechanism(source::Range close) {
  code_.AddMark(Op::kMechanismEnd, {.range = close}).mechanism = now_.mechanism;
  Unit& unit = context_.program.units[now_.mechanism];
  unit.end = InstructionId(code_.next().index - 1);
  unit.close = close;
  unit.faulty |= close.begin == close.end;
  now_.mechanism = {};
}

void UnitReader::LeaveOpenMechanism(source::Range place) {
  if (!now_.mechanism.valid()) return;
  context_.Report(place, diag::TechnolMechanismNotClosed, context_.program.units[now_.mechanism].name);
  LeaveMechanism({});
}

void UnitReader::CloseMechanism(const Statement& statement) {
  if (!IsCodePlace(statement)) return;
  if (statement.words.size() < 2 || statement.words[1].kind != TokenKind::kWord) {
    context_.Report(statement.range, diag::TechnolOperandMissing, "MECH_END", "the name of the mechanism");
    if (now_.mechanism.valid()) LeaveMechanism(statement.range);
    return;
  }
  const Token& name = statement.words[1];
  const std::string folded = context_.names.Fold(name.text);
  if (!now_.mechanism.valid() || folded != context_.names.Fold(context_.program.units[now_.mechanism].name)) {
    if (abandoned_mechanisms_.erase(folded) > 0) return;
    if (!now_.mechanism.valid()) {
      context_.Report(statement.range, diag::TechnolMechEndWithout, name.text);
      return;
    }
    Unit& open = context_.program.units[now_.mechanism];
    open.faulty = true;
    if (open.name.empty()) context_.Forgive();  // what its MECH_BEGIN lacks
    context_.Report(statement.range, diag::TechnolMechEndName, name.text, open.name)
        .notes.push_back({open.open, "it was opened here"});
  }
  ExpectEnd(statement, 2);
  code_.ReadLabel(statement);
  comments_.AddComment(statement, CommentPlace::kTrailing);
  LeaveMechanism(statement.range);
}

void UnitReader::OpenData(const Statement& statement) {
  if (IsOutside(statement)) return;
  if (now_.in_data) {
    context_.Report(statement.range, diag::TechnolCodeInData, "DATA");
    return;
  }
  LeaveOpenMechanism(statement.range);
  if (now_.module.valid()) {
    const Unit& open = context_.program.units[now_.module];
    context_.Report(statement.range, diag::TechnolModuleNotClosed, open.name)
        .notes.push_back({open.open, "it was opened here"});
    abandoned_modules_.insert(Upper(open.name));
    LeaveModule({});
  }
  ExpectEnd(statement, 1);
  code_.ReadLabel(statement);
  now_.in_data = has_data_ = true;
}

void UnitReader::CloseData(const Statement& statement) {
  if (IsOutside(statement)) return;
  if (!now_.in_data) {
    context_.Report(statement.range, diag::TechnolStrayLine, statement.first().text,
                    "closes a data block that is not open");
    return;
  }
  ExpectEnd(statement, 1);
  now_.in_data = false;
  code_.ReadLabel(statement);
}

void UnitReader::ReadStop(const Statement& statement) {
  if (IsOutside(statement)) return;
  ExpectEnd(statement, 1);
  if (now_.in_data) {
    context_.Report(statement.range, diag::TechnolDataNotClosed);
    now_.in_data = false;
  }
  LeaveOpenMechanism(statement.range);
  if (now_.module.valid()) {
    context_.Report(statement.range, diag::TechnolModuleNotClosed, context_.program.units[now_.module].name);
    LeaveModule({});
  }
  code_.ReadLabel(statement);
  code_.EndSubprograms(statement.range);
  if (now_.file != last_source_) context_.Report(statement.range, diag::TechnolStopNotLast);
  stopped_ = has_stop_ = true;
}

void UnitReader::EndOfSource(source::Range last) {
  if (now_.in_data) {
    context_.Report(last, diag::TechnolDataNotClosed);
    now_.in_data = false;
  }
  LeaveOpenMechanism(last);
  context_.faulty = false;
  if (now_.module.valid()) {
    if (!context_.program.units[now_.module].faulty) {
      context_.Report(last, diag::TechnolModuleNotClosed, context_.program.units[now_.module].name);
    }
    LeaveModule({});
  }
  code_.EndSubprograms(last);
  abandoned_modules_.clear();
  abandoned_mechanisms_.clear();
}

void UnitReader::CheckWhole(source::Range last) {
  const auto report = [&](const auto& message, auto... values) {
    context_.NextStatement({});
    context_.Report(last, message, values...);
  };
  if (!has_data_ && !now_.lost_lines) report(diag::TechnolNoData);
  if (!has_stop_ && !now_.lost_lines) report(diag::TechnolNoStop);
  if (context_.diagnostics.HasErrors() && !context_.settings.strict) return;  // one of them may be what is missing
  for (const ModuleInfo& info : Modules()) {
    if (!info.standard || FindModule(context_.program, info.kind).valid()) continue;
    if (context_.settings.strict) {
      report(diag::TechnolModuleMissingStrict, info.keyword);
    } else {
      report(diag::TechnolModuleMissing, info.keyword);
    }
  }
}

}  // namespace plcxx::technol
