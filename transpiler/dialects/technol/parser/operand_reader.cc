#include "transpiler/dialects/technol/parser/operand_reader.h"

namespace plcxx::technol {
namespace {

/// How the operands of instructions with a comma are written, as a remedy.
std::string_view OperandsOf(Form form) {
  if (form == Form::kFlag) return "0,BIT or 1,BIT";
  if (form == Form::kDelay) return "CELL,TIME, with '-' as the cell of an automatic timer";
  if (form == Form::kWaitLimit) return "CELL,TIME,LABEL, with '-' as the cell of an automatic timer";
  return "and its two operands, with a comma between them";
}

}  // namespace

void OperandReader::Add(Operand operand, size_t first) {
  operand.range = instruction_.expansion.valid() ? instruction_.range : reader_.RangeFrom(first);
  context_.program.operands.push_back(operand);
}

bool OperandReader::ExpectComma() {
  if (reader_.TakePunctuation(',')) return true;
  context_.Report(reader_.Here(), diag::TechnolCommaMissing, Shown(reader_.Peek()), mnemonic_,
                  OperandsOf(Info(instruction_.op).form));
  return false;
}

bool OperandReader::ExpectOperand(std::string_view what) {
  if (!reader_.AtEnd()) return true;
  context_.Report(instruction_.range, diag::TechnolOperandMissing, mnemonic_, what);
  return false;
}

SymbolId OperandReader::ReadName(std::string_view what) {
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

std::string NameOf(const Program& program, const Address& address) {
  if (address.base.valid()) return program.symbols[address.base].name;
  return std::string(Name(address.area));
}

}  // namespace plcxx::technol
