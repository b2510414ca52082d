#include "transpiler/dialects/technol/parser/assembler_reader.h"

#include "transpiler/dialects/technol/parser/expressions.h"

namespace plcxx::technol {
namespace {

constexpr std::string_view kRegisterOrMemory = "a register or memory";

bool IsMemory(const Operand& operand) { return operand.kind == OperandKind::kMemory; }

}  // namespace

/// OFFSET, SEG, segment overrides, memory without a symbol, registers that do not exist. Reports.
bool AssemblerReader::IsForeignOperand() {
  const Token& token = *reader_.Peek();
  if (reader_.IsPunctuation('[')) {
    size_t end = 0;
    while (reader_.Peek(end) != nullptr && !reader_.IsPunctuation(']', end)) ++end;
    const size_t first = reader_.position();
    for (size_t i = 0; i <= end && !reader_.AtEnd(); ++i) reader_.Take();
    context_.Report(reader_.RangeFrom(first), diag::TechnolMemoryWithoutSymbol, reader_.TextFrom(first));
    return true;
  }
  if (token.kind != TokenKind::kWord) return false;
  const std::string upper = Upper(token.text);
  if (IsForeignRegister(upper) && reader_.IsPunctuation(':', 1)) {
    context_.Report(token.range, diag::TechnolSegments, std::string(token.text) + ":");
    return true;
  }
  if ((upper == "OFFSET" || upper == "SEG") && !context_.names.Find(token.text).valid()) {
    context_.Report(token.range, diag::TechnolSegments, token.text);
    return true;
  }
  if (IsForeignRegister(upper) && !context_.names.Find(token.text).valid()) {
    context_.Report(token.range, diag::TechnolForeignRegister, token.text);
    return true;
  }
  return false;
}

std::optional<Operand> AssemblerReader::ReadRegister() {
  if (!reader_.IsKind(TokenKind::kWord)) return std::nullopt;
  const Register reg = RegisterByName(Upper(reader_.Peek()->text));
  if (reg == Register::kNone) return std::nullopt;
  reader_.Take();
  return Operand{.kind = OperandKind::kRegister, .width = Info(reg).width, .reg = reg};
}

/// A register, memory (of width 0 where nothing tells it) or, when allowed, a constant. None when it is wrong
/// (reported).
std::optional<Operand> AssemblerReader::ReadOperand(Operands allowed) {
  if (!ExpectOperand(allowed == Operands::kAny ? "a register, memory or a constant" : kRegisterOrMemory))
    return std::nullopt;
  const Token& token = *reader_.Peek();
  if (auto reg = ReadRegister()) {
    if (!reader_.IsPunctuation(':')) return reg;
    context_.Report(token.range, diag::TechnolSegments, std::string(token.text) + ":");
    return std::nullopt;
  }
  if (IsForeignOperand()) return std::nullopt;
  if (reader_.IsWord("CNST") && reader_.IsPunctuation('.', 1)) {
    context_.Report(token.range, diag::TechnolAssemblerOperand, "CNST.", mnemonic_, "constants without CNST.");
    return std::nullopt;
  }
  if (memory_.IsAddressAhead()) {
    // BYTE PTR [BX], BYTE PTR ES:X
    const size_t ahead = reader_.IsPunctuation('.', 1) || reader_.IsWord("PTR", 1) ? 2 : 0;
    if (ahead > 0 && reader_.Peek(ahead) != nullptr) {
      const size_t first = reader_.position();
      reader_.Return(first + ahead);
      if (IsForeignOperand()) return std::nullopt;
      reader_.Return(first);
    }
    return memory_.ReadMemory(Prefixes::kAssembler);
  }
  const size_t first = reader_.position();
  const std::optional<int64_t> value = ReadConstant(reader_, context_);
  if (!value) return std::nullopt;
  if (allowed != Operands::kAny) {
    context_.Report(reader_.RangeFrom(first), diag::TechnolAssemblerOperand, reader_.TextFrom(first), mnemonic_,
                    kRegisterOrMemory);
    return std::nullopt;
  }
  return Operand{.kind = OperandKind::kConstant, .value = *value};
}

bool AssemblerReader::CheckSize(const Operand& operand) {
  if (operand.width != 0) return true;
  context_.Report(instruction_.range, diag::TechnolSizeUnknown, NameOf(context_.program, operand.address));
  return false;
}

bool AssemblerReader::CheckImmediate(Operand& constant, uint8_t width) {
  const int64_t values = int64_t{1} << width;
  constant.width = width;
  if (constant.value >= -values / 2 && constant.value < values) return true;
  context_.Report(instruction_.range, diag::TechnolImmediate, std::to_string(constant.value), int64_t{width});
  return false;
}

/// Two operands of one width; memory of unknown width takes that of a register.
void AssemblerReader::Match(Operand& left, Operand& right) {
  if (IsMemory(left) && IsMemory(right)) {
    context_.Report(instruction_.range, diag::TechnolTwoMemoryOperands, mnemonic_);
    return;
  }
  if (right.kind == OperandKind::kConstant) {
    if (CheckSize(left)) CheckImmediate(right, left.width);
    return;
  }
  for (auto [unknown, known] : {std::pair(&left, &right), std::pair(&right, &left)}) {
    if (unknown->width != 0) continue;
    unknown->width = known->width;
    memory_.CheckRange(*unknown);
  }
  if (left.width == right.width) return;
  context_.Report(instruction_.range, diag::TechnolOperandSizes, mnemonic_, int64_t{left.width}, int64_t{right.width});
}

void AssemblerReader::ReadPair(Operands second_operand) {
  const size_t first = reader_.position();
  std::optional<Operand> left = ReadOperand(Operands::kRegisterOrMemory);
  if (!left) return;
  const source::Range range = reader_.RangeFrom(first);
  if (!ExpectComma()) return;
  const size_t second = reader_.position();
  std::optional<Operand> right = ReadOperand(second_operand);
  if (!right) return;
  Match(*left, *right);
  Add(*left, first);
  if (!instruction_.expansion.valid()) context_.program.operands.back().range = range;
  Add(*right, second);
}

void AssemblerReader::ReadTwo() { ReadPair(Operands::kAny); }

void AssemblerReader::ReadExchange() { ReadPair(Operands::kRegisterOrMemory); }

void AssemblerReader::ReadOne() {
  const size_t first = reader_.position();
  const std::optional<Operand> operand = ReadOperand(Operands::kRegisterOrMemory);
  if (!operand || !CheckSize(*operand)) return;
  Add(*operand, first);
}

void AssemblerReader::ReadShift() {
  const size_t first = reader_.position();
  const std::optional<Operand> operand = ReadOperand(Operands::kRegisterOrMemory);
  if (!operand || !CheckSize(*operand)) return;
  Add(*operand, first);
  if (!ExpectComma()) return;
  if (!ExpectOperand("a constant or CL")) return;
  const size_t second = reader_.position();
  if (const std::optional<Operand> count = ReadShiftCount()) Add(*count, second);
}

std::optional<Operand> AssemblerReader::ReadShiftCount() {
  const Token& token = *reader_.Peek();
  const auto refuse = [&] {
    context_.Report(token.range, diag::TechnolAssemblerOperand, token.text, mnemonic_, "a constant or CL as its count");
    return std::nullopt;
  };
  if (const std::optional<Operand> count = ReadRegister()) {
    if (count->reg != Register::kCl) return refuse();
    return count;
  }
  if (IsForeignOperand()) return std::nullopt;
  if (memory_.IsAddressAhead()) return refuse();
  const std::optional<int64_t> value = ReadConstant(reader_, context_);
  if (!value) return std::nullopt;
  Operand count{.kind = OperandKind::kConstant, .value = *value};
  if (!CheckImmediate(count, 8)) return std::nullopt;
  return count;
}

void AssemblerReader::ReadExtend() {
  if (!ExpectOperand("a register")) return;
  const size_t first = reader_.position();
  if (IsForeignOperand()) return;
  const Token& token = *reader_.Peek();
  const std::optional<Operand> reg = ReadRegister();
  if (!reg) {
    context_.Report(token.range, diag::TechnolAssemblerOperand, token.text, mnemonic_, "a register first");
    return;
  }
  Add(*reg, first);
  if (!ExpectComma()) return;
  const size_t second = reader_.position();
  const std::optional<Operand> from = ReadOperand(Operands::kRegisterOrMemory);
  if (!from || !CheckSize(*from)) return;
  if (reg->width <= from->width) {
    context_.Report(instruction_.range, diag::TechnolNotWider, mnemonic_, int64_t{reg->width}, int64_t{from->width});
    return;
  }
  Add(*from, second);
}

void AssemblerReader::ReadStack() {
  if (!ExpectOperand("a register of 16 or 32 bits")) return;
  const size_t first = reader_.position();
  if (IsForeignOperand()) return;
  const Token& token = *reader_.Peek();
  const std::optional<Operand> reg = ReadRegister();
  if (!reg || reg->width == 8) {
    context_.Report(token.range, diag::TechnolAssemblerOperand, token.text, mnemonic_, "a register of 16 or 32 bits");
    return;
  }
  Add(*reg, first);
}

}  // namespace plcxx::technol
