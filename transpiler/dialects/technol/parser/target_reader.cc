#include "transpiler/dialects/technol/parser/target_reader.h"

namespace plcxx::technol {

void TargetReader::CheckReturn() {
  const UnitId unit = instruction_.unit;
  if (context_.program.units[unit].kind == UnitKind::kSubprograms || HasTakenTheRest(unit)) return;
  context_.Report(instruction_.range, diag::TechnolRetOutside, UnitName(unit));
}

/// A module that is not closed (reported): the subprograms behind it seem to be in it.
bool TargetReader::HasTakenTheRest(UnitId unit) const {
  const Unit& module = context_.program.units[unit];
  return module.kind == UnitKind::kModule && module.close.begin == module.close.end;
}

std::string TargetReader::UnitName(UnitId unit) const {
  const Unit& named = context_.program.units[unit];
  switch (named.kind) {
    case UnitKind::kModule:
      return named.name;
    case UnitKind::kMechanism:
      return "mechanism '" + named.name + "'";
    case UnitKind::kSubprograms:
      return "the subprogram area";
  }
  return {};
}

void TargetReader::ReadJump() {
  if (Info(instruction_.op).assembler) {
    reader_.TakeWord("SHORT");
    for (const std::string_view far : {"FAR", "NEAR"}) {
      if (!reader_.IsWord(far) || context_.names.Find(far).valid()) continue;
      context_.Report(instruction_.range, diag::TechnolForeignInstruction,
                      std::string(mnemonic_) + " " + std::string(far));
      return;
    }
  }
  const size_t first = reader_.position();
  const Token* token = reader_.Peek();
  const SymbolId symbol = ReadName("a label");
  if (!symbol.valid()) return;
  const Symbol& named = context_.names[symbol];
  if (named.kind != SymbolKind::kLabel) {
    context_.Report(token->range, diag::TechnolUndefinedAs, token->text, "a label", KindText(named));
    return;
  }
  Add({.kind = OperandKind::kLabel, .label = named.label, .symbol = symbol}, first);
  CheckJumpTarget(named.label, token->range);
}

void TargetReader::CheckJumpTarget(LabelId label, source::Range range) {
  const Label& target = context_.program.labels[label];
  if (target.unit == instruction_.unit) return;
  context_.Report(range, diag::TechnolJumpLeaves, target.name, UnitName(instruction_.unit), UnitName(target.unit))
      .notes.push_back({target.range, "the label is here"});
}

void TargetReader::ReadCall() {
  const size_t first = reader_.position();
  const Token* token = reader_.Peek();
  const SymbolId symbol = ReadName("the label of a subprogram");
  if (!symbol.valid()) return;
  const Symbol& named = context_.names[symbol];
  if (named.kind != SymbolKind::kLabel) {
    context_.Report(token->range, diag::TechnolNoSubprogram, token->text, KindText(named));
    return;
  }
  const Label& target = context_.program.labels[named.label];
  if (HasTakenTheRest(target.unit)) return;
  if (context_.program.units[target.unit].kind != UnitKind::kSubprograms) {
    context_.Report(token->range, diag::TechnolNotSubprogram, token->text, UnitName(target.unit))
        .notes.push_back({target.range, "the label is here"});
    return;
  }
  Add({.kind = OperandKind::kLabel, .label = named.label, .symbol = symbol}, first);
}

void TargetReader::ReadMechanism() {
  const size_t first = reader_.position();
  const Token* token = reader_.Peek();
  if (token != nullptr && token->kind == TokenKind::kWord && !context_.names.Find(token->text).valid() &&
      !IsReserved(Upper(token->text))) {
    if (context_.IsExcused(token->text)) {
      context_.Forgive();
    } else {
      context_.Report(token->range, diag::TechnolUndefinedMechanism, token->text);
    }
    return;
  }
  const SymbolId symbol = ReadName("the name of a mechanism");
  if (!symbol.valid()) return;
  const Symbol& named = context_.names[symbol];
  if (named.kind != SymbolKind::kMechanism) {
    context_.Report(token->range, diag::TechnolNoMechanism, token->text, KindText(named));
    return;
  }
  Add({.kind = OperandKind::kMechanism, .mechanism = named.unit, .symbol = symbol}, first);
}

}  // namespace plcxx::technol
