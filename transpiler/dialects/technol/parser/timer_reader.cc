#include "transpiler/dialects/technol/parser/timer_reader.h"

#include "transpiler/dialects/technol/parser/expressions.h"

namespace plcxx::technol {

void TimerReader::RefuseCell(size_t first, std::string_view what) {
  context_.Report(reader_.RangeFrom(first), diag::TechnolTimerCell, reader_.TextFrom(first), what);
}

/// Fewer commas than the instruction has: its first operand may be another one.
bool TimerReader::LacksOperands() const {
  const ptrdiff_t commas = Info(instruction_.op).form == Form::kWaitLimit ? 2 : 1;
  ptrdiff_t found = 0;
  for (size_t i = 0; reader_.Peek(i) != nullptr; ++i) found += reader_.IsPunctuation(',', i) ? 1 : 0;
  return found < commas;
}

bool TimerReader::RefuseOther(size_t first) {
  const Token& token = *reader_.Peek();
  if (reader_.IsWord("CNST") || token.kind == TokenKind::kNumber) {
    reader_.Take();
    RefuseCell(first, "a constant");
    return true;
  }
  if (token.kind != TokenKind::kWord) return false;
  const SymbolId symbol = context_.names.Find(token.text);
  if (!symbol.valid() || context_.names[symbol].kind == SymbolKind::kCell || context_.names[symbol].faulty)
    return false;
  reader_.Take();
  ++context_.names[symbol].uses;
  RefuseCell(first, KindText(context_.names[symbol]));
  return true;
}

void TimerReader::ReadCell() {
  if (!ExpectOperand("a timer cell or '-'")) return;
  const size_t first = reader_.position();
  if (reader_.IsPunctuation('-') && (reader_.IsPunctuation(',', 1) || reader_.Peek(1) == nullptr)) {
    reader_.Take();
    Unit& unit = context_.program.units[instruction_.unit];
    return Add({.kind = OperandKind::kAutomaticTimer, .timer = unit.timers++}, first);
  }
  if (LacksOperands()) {
    context_.Report(instruction_.range, diag::TechnolOperandMissing, mnemonic_, WrittenOperands());
    return;
  }
  if (RefuseOther(first)) return;
  const std::optional<Operand> cell = memory_.ReadMemory(Prefixes::kTechnol);
  if (!cell) return;
  if (cell->width != 16) {
    RefuseCell(first, cell->width == 0 ? "of no known width" : "of " + std::to_string(cell->width) + " bits");
    return;
  }
  Add(*cell, first);
}

void TimerReader::ReadTime() {
  if (!ExpectComma() || !ExpectOperand("a time in passes")) return;
  const size_t first = reader_.position();
  if (!reader_.IsWord("CNST") && memory_.IsAddressAhead()) return ReadTimeCell(first);
  std::optional<Operand> constant = data_.ReadCounted();
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

void TimerReader::ReadTimeCell(size_t first) {
  const std::optional<Operand> cell = memory_.ReadMemory(Prefixes::kTechnol);
  if (!cell) return;
  if (cell->width == 0) {
    memory_.CheckWidth(*cell);
  } else if (cell->width != 16) {
    context_.Report(reader_.RangeFrom(first), diag::TechnolTimerLimitWidth, reader_.TextFrom(first),
                    int64_t{cell->width});
  } else {
    Add(*cell, first);
  }
}

}  // namespace plcxx::technol
