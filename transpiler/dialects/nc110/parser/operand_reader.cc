#include "transpiler/dialects/nc110/parser/operand_reader.h"

#include <vector>

#include "transpiler/support/near_words.h"

namespace plcxx::nc110 {

constexpr uint32_t kMaxOperands = 1024;

OperandUse OperandReader::TakeOperand() {
  const Token& token = Take();
  const std::string_view text = TextOf(token);
  OperandUse use;
  use.range = token.range;
  if (token.kind != TokenKind::kSymbol) {
    if (token.kind == TokenKind::kOperand) {
      CheckCase(token);
    }
    use.operand = ReadOperand(text, token.range);
    return use;
  }
  if (token.faulty) {
    return use;
  }
  const std::string_view name = text.substr(1);
  use.symbol = FindSymbol(name);
  if (use.symbol.valid()) {
    use.operand = program_.symbols[use.symbol].operand;
    now_.failed = now_.failed || use.operand.kind == OperandKind::kNone;  // its definition was reported
  } else if (undefined_.insert(std::string(name)).second) {
    if (Decode(name).fault == OperandFault::kNone) {
      Fault(token.range, diag::Nc110SymbolIsAddress, name);
    } else {
      FaultOfUndefined(token, name);
    }
  } else {
    now_.failed = true;
  }
  return use;
}

/// Only so many are compared with all symbols.
void OperandReader::FaultOfUndefined(const Token& token, std::string_view name) {
  constexpr size_t kMostSearches = 50;
  std::vector<std::string_view> names;
  if (undefined_.size() <= kMostSearches) {
    for (const Symbol& symbol : program_.symbols) names.push_back(symbol.name);
  }
  const std::string_view near = support::NearestName(name, names);
  if (near.empty()) {
    Fault(token.range, diag::Nc110SymbolUndefined, name);
  } else {
    Fault(token.range, diag::Nc110SymbolNear, name, near);
  }
}

/// Says what is meant where that is plain: words of other languages, numbers without their first digit, timers and
/// counters without their field.
void OperandReader::FaultOfUnknown(std::string_view run, source::Range range) {
  if (open_blocks_.IsMeantEnd(run, range)) {
    now_.failed = true;
    return;
  }
  const std::string cause =
      FindSymbol(run).valid() ? "it is a symbol: write !" + std::string(run) : CauseOfUnknown(run);
  if (cause.empty()) {
    Fault(range, diag::Nc110UnknownIdentifier, run);
  } else {
    Fault(range, diag::Nc110UnknownIdentifierCause, run, cause);
  }
}

Operand OperandReader::ReadOperand(std::string_view run, source::Range range) {
  const Decoded decoded = Decode(run);
  const auto number = static_cast<diag::Number>(decoded.found);
  const Package package = decoded.operand.package;
  switch (decoded.fault) {
    case OperandFault::kNone:
      return decoded.operand;
    case OperandFault::kUnknown: {
      const std::string hint = LookAlike(run);
      if (hint.empty()) {
        FaultOfUnknown(run, range);
      } else {
        Fault(range, diag::Nc110UnknownIdentifierHint, run, hint).fixits.push_back({range, hint});
      }
      break;
    }
    case OperandFault::kConnector: {
      const char letter = PackageLetter(package);
      Fault(range, diag::Nc110ConnectorRange, run, number, std::string_view(&letter, 1), ConnectorLimit(package));
      break;
    }
    case OperandFault::kBit:
      Fault(range, diag::Nc110BitRange, run, number);
      break;
    case OperandFault::kBitMissing:
      Fault(range, diag::Nc110BitMissing, run);
      break;
    case OperandFault::kWordIndex:
      Fault(range, diag::Nc110WordIndexRange, run, number);
      break;
    case OperandFault::kWordIndexMissing:
      Fault(range, diag::Nc110WordIndexMissing, run);
      break;
    case OperandFault::kTimer:
      Fault(range, diag::Nc110TimerRange, run, number);
      break;
    case OperandFault::kCounter:
      Fault(range, diag::Nc110CounterRange, run, number);
      break;
    case OperandFault::kOneShot:
      Fault(range, diag::Nc110OneShotRange, run, number);
      break;
  }
  return {};
}

ConstantUse OperandReader::TakeConstant() {
  const Token& token = Take();
  ConstantUse use;
  use.range = token.range;
  use.text = TextOf(token);
  const Number number = Evaluate(use.text);
  use.value = number.value;
  use.well_formed = number.well_formed;
  if (number.well_formed) {
    CheckCase(token);
  } else {
    ReportMalformedNumber(token);
  }
  return use;
}

void OperandReader::ReportMalformedNumber(const Token& token) {
  const std::string_view text = TextOf(token);
  const std::string hint = LookAlike(text);
  if (hint.empty()) {
    Fault(token.range, diag::Nc110MalformedNumber, text);
  } else {
    Fault(token.range, diag::Nc110MalformedNumberHint, text, hint).fixits.push_back({token.range, hint});
  }
}

void OperandReader::ReportMalformedTarget(const Token& token) {
  const std::string_view text = TextOf(token);
  std::string hint = LookAlike(text);
  if (!hint.starts_with('I')) {
    ReportMalformedNumber(token);
    return;
  }
  hint.front() = 'U';  // no input is assigned to
  Fault(token.range, diag::Nc110MalformedNumberHint, text, hint).fixits.push_back({token.range, hint});
}

void OperandReader::CountOperand() {
  if (++now_.operands == kMaxOperands + 1) {
    HardFault(Peek().range, diag::Nc110TooComplex);
  }
}

SymbolId OperandReader::FindSymbol(std::string_view name) const {
  const auto found = symbols_.find(name.substr(0, kSignificant));
  return found == symbols_.end() ? SymbolId() : found->second;
}

/// A name is also defined where its operand or the table's size is at fault: its uses are no second fault.
void OperandReader::DefineSymbol(Symbol symbol) {
  const std::string key = symbol.name.substr(0, kSignificant);
  const auto known = symbols_.find(key);
  if (known != symbols_.end()) {
    Fault(symbol.range, diag::Nc110SymbolTwice, symbol.name)
        .notes.push_back({program_.symbols[known->second].range, "the first definition"});
    return;
  }
  // It is no consequence of what is wrong with the line itself.
  if (symbols_.size() >= options_.max_symbols && !std::exchange(table_full_reported_, true)) {
    Report(symbol.range, diag::Nc110SymbolTable, options_.max_symbols);
  }
  symbols_.emplace(key, program_.symbols.Add(std::move(symbol)));
}

}  // namespace plcxx::nc110
