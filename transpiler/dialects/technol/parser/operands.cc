#include "transpiler/dialects/technol/parser/operands_internal.h"

namespace plcxx::technol {

void OperandParser::Run() {
  if (instruction_.op == Op::kUnknown) return;
  Form form = Info(instruction_.op).form;
  if (AssemblerForm(instruction_.op) != instruction_.op) {
    // One operand or two tells TECHNOL's AND from the assembler's.
    uint32_t depth = 0;
    for (size_t i = 0; const Token* token = reader_.Peek(i); ++i) {
      if (token->kind != TokenKind::kPunctuation) continue;
      if (token->text == "(" || token->text == "[") ++depth;
      if (depth > 0 && (token->text == ")" || token->text == "]")) --depth;
      if (depth == 0 && token->text == ",") {
        instruction_.op = AssemblerForm(instruction_.op);
        break;
      }
    }
    form = Info(instruction_.op).form;
  }
  if (context_.settings.evidence == EvidenceRule::kStrict && Info(instruction_.op).evidence == Evidence::kCompletion) {
    context_.Report(instruction_.mnemonic, diag::TechnolCompletion, mnemonic_);
  }
  instruction_.operands.first = static_cast<uint32_t>(context_.program.operands.size());
  TakeForm(form);
  if (!context_.faulty) CheckEnd();
  instruction_.operands.count = static_cast<uint32_t>(context_.program.operands.size()) - instruction_.operands.first;
  instruction_.faulty |= context_.faulty;
}

void OperandParser::TakeForm(Form form) {
  switch (form) {
    case Form::kNone:
      return TakeNone();
    case Form::kBit:
      return TakeBit(Access::kRead);
    case Form::kWriteBit:
      return TakeBit(Access::kWrite);
    case Form::kFlag:
      return TakeFlag();
    case Form::kJump:
      return TakeJump();
    case Form::kCall:
      return TakeCall();
    case Form::kWaitLimit:
      TakeTimerCell();
      if (!context_.faulty && ExpectComma()) TakeTime();
      if (!context_.faulty && ExpectComma()) TakeJump();
      return;
    case Form::kDelay:
      TakeTimerCell();
      if (!context_.faulty && ExpectComma()) TakeTime();
      return;
    case Form::kMechanism:
      return TakeMechanism();
    case Form::kData:
    case Form::kNarrowData:
    case Form::kWideData:
      return TakeData(form);
    case Form::kStore:
      return TakeStore();
    case Form::kRotation:
      return TakeRotation();
    case Form::kError:
      return TakeError();
    case Form::kTwo:
      return TakeTwo();
    case Form::kOne:
    case Form::kMultiply:
      return TakeOne();
    case Form::kShift:
      return TakeShift();
    case Form::kExchange:
      return TakeExchange();
    case Form::kExtend:
      return TakeExtend();
    case Form::kStack:
      return TakeStack();
  }
}

void OperandParser::Add(Operand operand, size_t first) {
  operand.range = instruction_.expansion.valid() ? instruction_.range : reader_.RangeFrom(first);
  context_.program.operands.push_back(operand);
}

void OperandParser::CheckEnd() {
  if (reader_.AtEnd()) return;
  const std::string mnemonic(mnemonic_);
  if (reader_.IsPunctuation('.')) {
    context_.Report(reader_.Here(), diag::TechnolSurplusHint, Shown(reader_.Peek()), mnemonic,
                    "a bit has a name of its own in its DFM, no number; BYTE. and CNST. stand in front of a name");
  } else if (reader_.IsPunctuation(',')) {
    context_.Report(reader_.Here(), diag::TechnolSurplusHint, Shown(reader_.Peek()), mnemonic,
                    "'" + mnemonic + "' takes no further operand");
  } else if (reader_.IsWord("AND") || reader_.IsWord("OR") || reader_.IsWord("XOR")) {
    context_.Report(reader_.Here(), diag::TechnolSurplusHint, Shown(reader_.Peek()), mnemonic,
                    "bits are combined line by line: LA, LO");
  } else {
    context_.Report(reader_.Here(), diag::TechnolSurplus, Shown(reader_.Peek()), mnemonic);
  }
}

bool OperandParser::ExpectComma() {
  if (reader_.TakePunctuation(',')) return true;
  context_.Report(reader_.Here(), diag::TechnolSyntax, Shown(reader_.Peek()), "','");
  return false;
}

bool OperandParser::ExpectOperand(std::string_view what) {
  if (!reader_.AtEnd()) return true;
  context_.Report(instruction_.range, diag::TechnolOperandMissing, mnemonic_, what);
  return false;
}

void OperandParser::TakeNone() {
  if (instruction_.op != Op::kRet) return;
  const UnitId unit = instruction_.unit;
  if (context_.program.units[unit].kind == UnitKind::kSubprograms) return;
  context_.Report(instruction_.range, diag::TechnolRetOutside, UnitName(unit));
}

std::string OperandParser::UnitName(UnitId unit) const {
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

SymbolId OperandParser::TakeName(std::string_view what) {
  if (!ExpectOperand(what)) return {};
  const Token& token = *reader_.Peek();
  if (token.kind != TokenKind::kWord || token.text == "?") {
    context_.Report(token.range, diag::TechnolSyntax, Shown(&token), what);
    return {};
  }
  reader_.Take();
  const SymbolId symbol = context_.names.Find(token.text);
  if (!symbol.valid()) {
    if (IsReserved(Upper(token.text))) {
      context_.ReportReserved(token, reader_.AtEnd() ? std::string_view() : reader_.Peek()->text);
    } else {
      context_.ReportUndefined(token.text, token.range);
    }
    return {};
  }
  ++context_.names[symbol].uses;
  if (!context_.names[symbol].faulty) return symbol;
  context_.Forgive();
  return {};
}

void OperandParser::TakeJump() {
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
  const SymbolId symbol = TakeName("a label");
  if (!symbol.valid()) return;
  const Symbol& named = context_.names[symbol];
  if (named.kind != SymbolKind::kLabel) {
    context_.Report(token->range, diag::TechnolUndefinedAs, token->text, "a label", KindText(named));
    return;
  }
  Add({.kind = OperandKind::kLabel, .label = named.label, .symbol = symbol}, first);
  CheckJumpTarget(named.label, token->range);
}

void OperandParser::CheckJumpTarget(LabelId label, source::Range range) {
  const Label& target = context_.program.labels[label];
  if (target.unit == instruction_.unit) return;
  context_.Report(range, diag::TechnolJumpLeaves, target.name, UnitName(instruction_.unit), UnitName(target.unit))
      .notes.push_back({target.range, "the label is here"});
}

void OperandParser::TakeCall() {
  const size_t first = reader_.position();
  const Token* token = reader_.Peek();
  const SymbolId symbol = TakeName("the label of a subprogram");
  if (!symbol.valid()) return;
  const Symbol& named = context_.names[symbol];
  if (named.kind != SymbolKind::kLabel) {
    context_.Report(token->range, diag::TechnolNoSubprogram, token->text, KindText(named));
    return;
  }
  const Label& target = context_.program.labels[named.label];
  if (context_.program.units[target.unit].kind != UnitKind::kSubprograms) {
    context_.Report(token->range, diag::TechnolNotSubprogram, token->text, UnitName(target.unit))
        .notes.push_back({target.range, "the label is here"});
    return;
  }
  Add({.kind = OperandKind::kLabel, .label = named.label, .symbol = symbol}, first);
}

void OperandParser::TakeMechanism() {
  const size_t first = reader_.position();
  const Token* token = reader_.Peek();
  if (token != nullptr && token->kind == TokenKind::kWord && !context_.names.Find(token->text).valid() &&
      !IsReserved(Upper(token->text))) {
    context_.Report(token->range, diag::TechnolUndefinedMechanism, token->text);
    return;
  }
  const SymbolId symbol = TakeName("the name of a mechanism");
  if (!symbol.valid()) return;
  const Symbol& named = context_.names[symbol];
  if (named.kind != SymbolKind::kMechanism) {
    context_.Report(token->range, diag::TechnolNoMechanism, token->text, KindText(named));
    return;
  }
  Add({.kind = OperandKind::kMechanism, .mechanism = named.unit, .symbol = symbol}, first);
}

/// '-': an automatic timer; else a word of the program.
void OperandParser::TakeTimerCell() {
  if (!ExpectOperand("a timer cell or '-'")) return;
  const size_t first = reader_.position();
  if (reader_.IsPunctuation('-') && (reader_.IsPunctuation(',', 1) || reader_.Peek(1) == nullptr)) {
    reader_.Take();
    Unit& unit = context_.program.units[instruction_.unit];
    return Add({.kind = OperandKind::kAutomaticTimer, .timer = unit.timers++}, first);
  }
  const auto refuse = [&](std::string_view what) {
    context_.Report(reader_.RangeFrom(first), diag::TechnolTimerCell, reader_.TextFrom(first), what);
  };
  const Token& token = *reader_.Peek();
  if (reader_.IsWord("CNST") || token.kind == TokenKind::kNumber) {
    reader_.Take();
    return refuse("a constant");
  }
  if (token.kind == TokenKind::kWord) {
    const SymbolId symbol = context_.names.Find(token.text);
    if (symbol.valid() && context_.names[symbol].kind != SymbolKind::kCell && !context_.names[symbol].faulty) {
      reader_.Take();
      ++context_.names[symbol].uses;
      return refuse(KindText(context_.names[symbol]));
    }
  }
  std::optional<Operand> cell = ReadMemory(Prefixes::kTechnol);
  if (!cell) return;
  if (cell->width != 16) {
    refuse(cell->width == 0 ? "of no known width" : "of " + std::to_string(cell->width) + " bits");
    return;
  }
  Add(*cell, first);
}

/// A constant, CNST.constant or a word.
void OperandParser::TakeTime() {
  if (!ExpectOperand("a time in passes")) return;
  const size_t first = reader_.position();
  if (!reader_.IsWord("CNST") && IsAddressAhead()) {
    const std::optional<Operand> cell = ReadMemory(Prefixes::kTechnol);
    if (!cell) return;
    if (cell->width == 0) {
      CheckWidth(*cell);
    } else if (cell->width != 16) {
      context_.Report(reader_.RangeFrom(first), diag::TechnolTimerLimitWidth, reader_.TextFrom(first),
                      int64_t{cell->width});
    } else {
      Add(*cell, first);
    }
    return;
  }
  std::optional<Operand> constant = ReadCounted();
  if (!constant && !context_.faulty) {
    if (const std::optional<int64_t> value = ReadConstant(reader_, context_)) {
      constant = Operand{.kind = OperandKind::kConstant, .value = *value};
    }
  }
  if (!constant) return;
  if (constant->value < 0 || constant->value > kTimerLimit) {
    context_.Report(reader_.RangeFrom(first), diag::TechnolTimerLimit, constant->value);
    return;
  }
  constant->width = 16;
  Add(*constant, first);
}

/// main[,sub]
void OperandParser::TakeError() {
  if (!ExpectOperand("an error number")) return;
  constexpr int64_t kMost = 99;
  for (int64_t least = 1; least >= 0; --least) {
    const size_t first = reader_.position();
    const std::optional<int64_t> value = ReadConstant(reader_, context_);
    if (!value) return;
    if (*value < least || *value > kMost) {
      context_.Report(reader_.RangeFrom(first), diag::TechnolEsetRange, *value, least, kMost);
      return;
    }
    Add({.kind = OperandKind::kConstant, .width = 8, .value = *value}, first);
    if (least == 0 || !reader_.TakePunctuation(',')) return;
  }
}

void ReadOperands(const std::vector<Pending>& pending, const std::vector<Token>& tokens, ParsingContext& context) {
  context.program.operands.reserve(pending.size());
  for (uint32_t i = 0; i < pending.size(); ++i) {
    Instruction& instruction = context.program.instructions[InstructionId(i)];
    context.BeginStatement(pending[i].statement, instruction.expansion);
    if (pending[i].mnemonic.count == 0) continue;
    const std::span<const Token> operands(tokens.data() + pending[i].tokens.first, pending[i].tokens.count);
    const std::string_view mnemonic = tokens[pending[i].mnemonic.first].text;
    if (instruction.faulty) context.Forgive();
    OperandParser(context, instruction, mnemonic, TokenReader(operands)).Run();
  }
}

}  // namespace plcxx::technol
