#include "transpiler/dialects/technol/parser/data_operand_reader.h"

#include "transpiler/dialects/technol/parser/expressions.h"

namespace plcxx::technol {
namespace {

constexpr int64_t kLeastWord = -0x8000;
constexpr int64_t kGreatestWord = 0xFFFF;

bool BeginsNumber(const Token& token) { return token.kind == TokenKind::kNumber || token.kind == TokenKind::kString; }

}  // namespace

std::optional<Operand> DataOperandReader::ReadCounted() {
  if (!reader_.IsWord("CNST") || !reader_.IsPunctuation('.', 1)) return std::nullopt;
  reader_.Take();
  reader_.Take();
  const std::optional<int64_t> value = ReadConstant(reader_, context_);
  if (!value) return std::nullopt;
  const bool word = *value >= kLeastWord && *value <= kGreatestWord;
  return Operand{.kind = OperandKind::kConstant, .width = static_cast<uint8_t>(word ? 16 : 32), .value = *value};
}

/// CNST.constant or memory of known width.
std::optional<Operand> DataOperandReader::ReadDataOperand() {
  if (!ExpectOperand("memory or CNST. and a constant")) return std::nullopt;
  if (reader_.IsWord("CNST") && reader_.IsPunctuation('.', 1)) return ReadCounted();
  const Token& token = *reader_.Peek();
  const bool sign = token.kind == TokenKind::kPunctuation && (token.text == "-" || token.text == "+");
  const Token* number = sign ? reader_.Peek(1) : &token;
  if (number != nullptr && BeginsNumber(*number)) {
    reader_.TakeRest();
    context_.Report(token.range, diag::TechnolBareNumber, reader_.TextFrom(0));
    return std::nullopt;
  }
  std::optional<Operand> memory = memory_.ReadMemory(Prefixes::kTechnol);
  if (memory && !memory_.CheckWidth(*memory)) return std::nullopt;
  return memory;
}

void DataOperandReader::ReadData(Form form) {
  const size_t first = reader_.position();
  const std::optional<Operand> operand = ReadDataOperand();
  if (!operand) return;
  if (form != Form::kData) CheckNarrow(*operand, form);
  Add(*operand, first);
}

/// MULB, DIVB: 8 bits; MULW, DIVW: 16 at most.
void DataOperandReader::CheckNarrow(const Operand& operand, Form form) {
  const bool narrow = form == Form::kNarrowData;
  const std::string_view takes = narrow ? "8 bits" : "8 or 16 bits";
  if (operand.kind == OperandKind::kMemory && operand.width > (narrow ? 8 : 16)) {
    context_.Report(instruction_.range, diag::TechnolOperandWidth, mnemonic_, reader_.TextFrom(0),
                    int64_t{operand.width}, takes);
  } else if (operand.kind == OperandKind::kConstant &&
             (operand.value < 0 || operand.value > (narrow ? 0xFF : kGreatestWord))) {
    context_.Report(instruction_.range, diag::TechnolOperandConstant, mnemonic_, reader_.TextFrom(0),
                    narrow ? "CNST.0 to CNST.255" : "CNST.0 to CNST.65535");
  }
}

void DataOperandReader::ReadStore() {
  if (!ExpectOperand("the memory to write")) return;
  const size_t first = reader_.position();
  const Token& token = *reader_.Peek();
  const SymbolId symbol = token.kind == TokenKind::kWord ? context_.names.Find(token.text) : SymbolId();
  const SymbolKind kind = symbol.valid() ? context_.names[symbol].kind : SymbolKind::kCell;
  const bool faulty = symbol.valid() && context_.names[symbol].faulty;
  if (BeginsNumber(token) || reader_.IsWord("CNST")) {
    reader_.TakeRest();
    context_.Report(instruction_.range, diag::TechnolStoreConstant, reader_.TextFrom(0));
    return;
  }
  if (!faulty && (kind == SymbolKind::kBit || kind == SymbolKind::kMechanism)) {
    ++context_.names[symbol].uses;
    reader_.TakeRest();
    context_.Report(instruction_.range, diag::TechnolStoreBit, token.text);
    return;
  }
  const std::optional<Operand> memory = memory_.ReadMemory(Prefixes::kTechnol);
  if (memory && memory_.CheckWidth(*memory)) Add(*memory, first);
}

void DataOperandReader::ReadRotation() {
  const size_t first = reader_.position();
  const std::optional<Operand> operand = ReadDataOperand();
  if (!operand) return;
  if (operand->kind == OperandKind::kMemory && operand->width != 8) {
    context_.Report(instruction_.range, diag::TechnolOperandWidth, mnemonic_, reader_.TextFrom(first),
                    int64_t{operand->width}, "CNST. or 8 bits");
    return;
  }
  Add(*operand, first);
}

}  // namespace plcxx::technol
