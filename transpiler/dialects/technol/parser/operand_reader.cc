#include "transpiler/dialects/technol/parser/operand_reader.h"

#include "transpiler/support/near_words.h"

namespace plcxx::technol {
namespace {

/// The type prefix that is spelled nearly so.
std::string_view NearPrefix(std::string_view word) {
  constexpr std::string_view kPrefixes[] = {"BYTE", "WORD", "DWRD", "CNST"};
  return support::NearestWord(Upper(word), kPrefixes);
}

}  // namespace

void OperandReader::Add(Operand operand, size_t first) {
  operand.range = instruction_.expansion.valid() ? instruction_.range : reader_.RangeFrom(first);
  context_.program.operands.push_back(operand);
}

std::string_view OperandReader::WrittenOperands() const {
  const Form form = Info(instruction_.op).form;
  if (form == Form::kFlag) return "0,BIT or 1,BIT";
  if (form == Form::kDelay) return "CELL,TIME, with '-' as the cell of an automatic timer";
  if (form == Form::kWaitLimit) return "CELL,TIME,LABEL, with '-' as the cell of an automatic timer";
  return "and its two operands, with a comma between them";
}

bool OperandReader::ExpectComma() {
  if (reader_.TakePunctuation(',')) return true;
  context_.Report(reader_.Here(), diag::TechnolCommaMissing, Shown(reader_.Peek()), mnemonic_, WrittenOperands());
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
    const Token* const behind = reader_.Peek(reader_.IsPunctuation(',') ? 1 : 0);
    if (IsReserved(Upper(token.text))) {
      context_.ReportReserved(token, behind == nullptr ? std::string_view() : behind->text);
    } else if (const std::string_view prefix = reader_.IsPunctuation('.') ? NearPrefix(token.text) : "";
               !prefix.empty()) {
      context_.Report(token.range, diag::TechnolUndefinedNear, token.text, prefix);
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
