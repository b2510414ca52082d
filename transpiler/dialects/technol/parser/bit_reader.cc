#include "transpiler/dialects/technol/parser/bit_reader.h"

#include <algorithm>

#include "transpiler/dialects/technol/parser/expressions.h"

namespace plcxx::technol {

int64_t BitReader::CountOperands() const {
  int64_t operands = reader_.AtEnd() ? 0 : 1;
  for (size_t i = 0; reader_.Peek(i) != nullptr; ++i) operands += reader_.IsPunctuation(',', i) ? 1 : 0;
  return operands;
}

/// Is there exactly one operand?
bool BitReader::IsSingleBit() {
  const int64_t operands = CountOperands();
  if (operands == 1) return true;
  context_.Report(instruction_.range, diag::TechnolOneBit, mnemonic_, operands);
  return false;
}

/// IN0.1 for the second bit of a byte: what that bit is called, or how it gets a name. Empty: the cell is no byte.
std::string BitReader::BitOfByte(SymbolId cell) const {
  const auto is_bit_of = [&](const Symbol& symbol) { return symbol.kind == SymbolKind::kBit && symbol.byte == cell; };
  const std::string name = context_.names[cell].name;
  if (std::ranges::none_of(context_.program.symbols, is_bit_of)) {
    if (context_.names[cell].width != 8) return {};
    if (context_.names[cell].origin == SymbolOrigin::kSource) {
      return "'" + name + "' is a byte: bits get their names where it is declared, by DFM: " + name +
             ": DFM FIRST,SECOND";
    }
    return "'" + name + "' is a byte of the control: DFM gives its bits names, in DATA: " + name + ": DFM FIRST,SECOND";
  }
  const Token* digits = reader_.IsPunctuation('.') ? reader_.Peek(1) : nullptr;
  const Number number = digits == nullptr ? Number{} : ReadNumber(digits->text);
  if (digits == nullptr || number.fault != NumberFault::kNone || number.value > 7) {
    return "'" + name + "' is a byte: its bits have the names that its DFM gives them";
  }
  const std::string bit = "bit " + std::to_string(number.value) + " of '" + name + "'";
  for (const Symbol& symbol : context_.program.symbols) {
    if (is_bit_of(symbol) && symbol.bit == number.value) return bit + " has the name " + symbol.name;
  }
  return bit + " has no name: give it one in its DFM";
}

/// The name of a bit or a mechanism.
std::optional<Operand> BitReader::ReadBitName() {
  const Token& token = *reader_.Peek();
  const auto refuse = [&](std::string_view what) {
    reader_.TakeRest();
    context_.Report(token.range, diag::TechnolBitExpected, mnemonic_, token.text, what);
    return std::nullopt;
  };
  if (token.kind == TokenKind::kNumber) return refuse("a number");
  if (token.kind != TokenKind::kWord || token.text == "?") {
    if (token.text == "/" || token.text == "!") {
      context_.Report(token.range, diag::TechnolSyntaxHint, Shown(&token), "the name of a bit",
                      "the negation of a bit is '-': " + std::string(mnemonic_) + " -I1");
    } else {
      context_.Report(token.range, diag::TechnolSyntax, Shown(&token), "the name of a bit");
    }
    return std::nullopt;
  }
  const std::string upper = Upper(token.text);
  if (reader_.IsPunctuation('.', 1) && (upper == "BYTE" || upper == "WORD" || upper == "DWRD" || upper == "CNST")) {
    return refuse(upper == "CNST" ? "a constant" : "data");
  }
  if (RegisterByName(upper) != Register::kNone) {
    if (context_.IsReportedAsName(upper)) context_.Forgive();
    return refuse("a register");
  }
  const SymbolId symbol = ReadName("the name of a bit");
  if (!symbol.valid()) return std::nullopt;
  const Symbol& named = context_.names[symbol];
  if (named.kind == SymbolKind::kMechanism) {
    return Operand{.kind = OperandKind::kBit, .width = 1, .mechanism = named.unit, .symbol = symbol};
  }
  if (named.kind == SymbolKind::kCell) {
    if (const std::string remedy = BitOfByte(symbol); !remedy.empty()) {
      reader_.TakeRest();
      context_.Report(token.range, diag::TechnolBitOfByte, mnemonic_, token.text, remedy);
      return std::nullopt;
    }
  }
  if (named.kind != SymbolKind::kBit) return refuse(KindText(named));
  return Operand{.kind = OperandKind::kBit,
                 .bit = named.bit,
                 .width = 1,
                 .address = {.area = named.area, .offset = named.offset, .base = named.byte},
                 .symbol = symbol};
}

void BitReader::ReadBit(Access access) {
  if (!IsSingleBit()) return;
  const size_t first = reader_.position();
  const bool negated = reader_.TakePunctuation('-');
  if (negated && access == Access::kWrite) {
    context_.Report(instruction_.range, diag::TechnolNegatedWrite, mnemonic_);
    return;
  }
  if (!ExpectOperand("the name of a bit")) return;
  std::optional<Operand> bit = ReadBitName();
  if (!bit) return;
  bit->negated = negated;
  Add(*bit, first);
}

bool BitReader::ReadFlagValue(int64_t& flag) {
  const int64_t operands = CountOperands();
  const size_t first = reader_.position();
  const Token* value = reader_.Peek();
  if (operands == 2 && value->kind != TokenKind::kNumber) {
    while (!reader_.IsPunctuation(',')) reader_.Take();
    context_.Report(reader_.RangeFrom(first), diag::TechnolFlagValue, mnemonic_, reader_.TextFrom(first));
    return false;
  }
  const Token* bit_behind = reader_.Peek(1);
  if (operands == 1 && value->kind == TokenKind::kNumber && bit_behind != nullptr) {
    context_.Report(instruction_.range, diag::TechnolFlagComma, mnemonic_,
                    std::string(value->text) + "," + std::string(bit_behind->text));
    return false;
  }
  if (operands == 1) {
    const bool is_value = value->kind == TokenKind::kNumber;
    while (!reader_.AtEnd()) reader_.Take();
    const std::string half = reader_.TextFrom(first);
    context_.Report(instruction_.range, diag::TechnolFlagHalf, mnemonic_, half,
                    is_value ? half + ",NAME" : "1," + half.substr(half.starts_with('-') ? 1 : 0));
    return false;
  }
  if (operands != 2) {
    context_.Report(instruction_.range, diag::TechnolOneBit, std::string(mnemonic_) + " with its 0 or 1", operands);
    return false;
  }
  reader_.Take();
  const Number number = ReadNumber(value->text);
  if (number.fault != NumberFault::kNone || number.value > 1) {
    context_.Report(value->range, diag::TechnolFlagValue, mnemonic_, value->text);
    return false;
  }
  Add({.kind = OperandKind::kConstant, .width = 1, .value = number.value}, first);
  flag = number.value;
  return ExpectComma();
}

void BitReader::ReadFlag() {
  int64_t flag = 0;
  if (!ReadFlagValue(flag)) return;
  const size_t first = reader_.position();
  if (reader_.TakePunctuation('-')) {
    context_.Report(instruction_.range, diag::TechnolNegatedWrite, mnemonic_);
    return;
  }
  if (!ExpectOperand("the name of a bit")) return;
  const std::optional<Operand> bit = ReadBitName();
  if (!bit) return;
  Add(*bit, first);
  CheckRequest(*bit, flag);
}

/// TW013: the program takes back what the control has begun.
void BitReader::CheckRequest(const Operand& bit, int64_t value) {
  if (value != 0 || instruction_.op == Op::kWr || !bit.symbol.valid()) return;
  const Symbol& symbol = context_.names[bit.symbol];
  if (symbol.origin == SymbolOrigin::kSource || !symbol.name.starts_with("REQ_")) return;
  context_.Report(instruction_.range, diag::TechnolRequestCleared, symbol.name);
}

}  // namespace plcxx::technol
