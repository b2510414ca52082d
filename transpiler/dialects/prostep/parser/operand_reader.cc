#include "transpiler/dialects/prostep/parser/operand_reader.h"

namespace plcxx::prostep {
namespace {

std::string RangeText(const Operand& operand, Access access) {
  const std::string_view name = Name(operand.kind);
  switch (operand.shape()) {
    case Shape::kTimer:
      return "timers are T 0 to T 63";
    case Shape::kCounter:
      return "counters are C 0 to C 63";
    case Shape::kModule:
      return "modules are PM 0 to PM 99";
    case Shape::kBit:
    case Shape::kByte:
    case Shape::kWord:
    case Shape::kDouble:
    case Shape::kConstant:
    case Shape::kFunction:
      break;
  }
  if (operand.space() == Space::kP) {
    const bool bit = operand.shape() == Shape::kBit, word = operand.shape() == Shape::kWord;
    const uint32_t last = (access == Access::kWrite ? 11u : 23u) - (word ? 1u : 0u);
    std::string text = "direct ";
    text += access == Access::kWrite ? "outputs are " : "inputs are ";
    text += std::string(name) + " 0 to " + std::to_string(last);
    if (!bit) text += word ? " and 100 to 130" : " and 100 to 131";
    return text;
  }
  const uint32_t last = BytesOf(operand.space()) - (operand.shape() == Shape::kWord ? 2 : 1);
  return "numbers are " + std::string(name) + " 0 to " + std::to_string(last);
}

/// Does a number of this shape exist at all in `uint32_t`?
bool Fits(uint32_t number) { return number <= 0xFFFF; }

}  // namespace

OperandClass OperandReader::ClassOf(const std::vector<Token>& tokens, size_t first) const {
  if (first >= tokens.size() || tokens[first].kind != TokenKind::kClass) return OperandClass::kNone;
  return ClassByName(UpperOf(tokens[first]));
}

std::string OperandReader::OperandText(const std::vector<Token>& tokens, size_t first) const {
  std::string text;
  for (size_t i = first; i < tokens.size(); ++i) {
    const bool attached = tokens[i].kind == TokenKind::kJunk && i > first;
    if (!text.empty() && !attached) text += " ";
    text += tokens[i].kind == TokenKind::kClass ? UpperOf(tokens[i]) : std::string(TextOf(tokens[i]));
  }
  return text;
}

/// I0,0 is a slip of those who know decimal commas.
void OperandReader::ReportMalformed(const Token& number) {
  const std::string_view text = TextOf(number);
  if (text.find(',') != std::string_view::npos) {
    diagnostics_.Report(number.range, diag::ProstepNumberComma, text);
  } else {
    diagnostics_.Report(number.range, diag::ProstepMalformedNumber, text);
  }
}

Operand OperandReader::ReadOperand(const std::vector<Token>& tokens, size_t first) {
  const Token& class_token = tokens[first];
  const Token* number = first + 1 < tokens.size() ? &tokens[first + 1] : nullptr;
  const OperandClass operand_class = ClassOf(tokens, first);
  if (operand_class == OperandClass::kK) return ReadConstantOperand(class_token, number);
  const std::string text = OperandText(tokens, first);
  if (number == nullptr) {
    diagnostics_.Report(class_token.range, diag::ProstepOperandWithoutNumber, text);
    return {};
  }
  if (number->kind == TokenKind::kJunk) {
    ReportMalformed(*number);
    return {};
  }
  const AddressNumber address = ReadAddress(TextOf(*number));
  Operand operand{.kind = operand_class, .range = {class_token.range.begin, number->range.end}};
  const bool wants_bit = operand.shape() == Shape::kBit;
  if (address.malformed) {
    ReportMalformed(*number);
    return {};
  }
  if (wants_bit && !address.has_bit) {
    diagnostics_.Report(operand.range, diag::ProstepBitMissing, text);
    return {};
  }
  if (!wants_bit && address.has_bit) {
    diagnostics_.Report(operand.range, diag::ProstepBitSuperfluous, text, Name(operand_class));
    return {};
  }
  if (address.bit > 7) {
    diagnostics_.Report(operand.range, diag::ProstepAddressRange, text, "bits are 0 to 7");
    return {};
  }
  if (!Fits(address.number)) {
    if (operand.shape() == Shape::kFunction) {
      diagnostics_.Report(operand.range, diag::ProstepFunctionUnknown, text);
    } else {
      diagnostics_.Report(operand.range, diag::ProstepAddressRange, text, RangeText(operand, Access::kRead));
    }
    return {};
  }
  operand.number = static_cast<uint16_t>(address.number);
  operand.bit = static_cast<uint8_t>(address.bit);
  if (operand.shape() == Shape::kModule && !IsInRange(operand, Access::kNone)) return {};
  return operand;
}

Operand OperandReader::ReadConstantOperand(const Token& class_token, const Token* number) {
  if (number == nullptr) {
    diagnostics_.Report(class_token.range, diag::ProstepNumberMissing, "K");
    return {};
  }
  const ConstantNumber constant = ReadConstant(TextOf(*number), 2);
  const std::string text = "K " + std::string(TextOf(*number));
  const source::Range range = {class_token.range.begin, number->range.end};
  if (constant.fault == NumberFault::kMalformed) {
    ReportMalformed(*number);
    return {};
  }
  if (constant.fault == NumberFault::kRange) {
    diagnostics_.Report(range, diag::ProstepConstantRange, text,
                        "a constant has two bytes: -32768 to 65535, 0FFFFH, four BCD digits");
    return {};
  }
  return {.kind = OperandClass::kK,
          .value = static_cast<uint16_t>(constant.value),
          .form = constant.form,
          .has_minus = TextOf(*number).starts_with('-'),
          .range = range};
}

bool OperandReader::IsInRange(const Operand& operand, Access access) {
  bool exists = true;
  switch (operand.shape()) {
    case Shape::kBit:
    case Shape::kByte:
    case Shape::kWord: {
      const uint32_t last = operand.shape() == Shape::kWord ? operand.number + 1u : operand.number;
      exists = operand.space() == Space::kP ? IsPort(access, operand.shape(), operand.number)
                                            : last < BytesOf(operand.space());
      break;
    }
    case Shape::kTimer:
      exists = operand.number < kTimers;
      break;
    case Shape::kCounter:
      exists = operand.number < kCounters;
      break;
    case Shape::kModule:
      exists = operand.number < kModules;
      break;
    case Shape::kConstant:
    case Shape::kFunction:
    case Shape::kDouble:
      break;
  }
  if (!exists) {
    diagnostics_.Report(operand.range, diag::ProstepAddressRange, ToText(operand), RangeText(operand, access));
  }
  return exists;
}

void OperandReader::WarnOfBorder(const Operand& operand) {
  if (operand.kind == OperandClass::kDW && operand.number + 1u == kFirstKeptByte) {
    diagnostics_.Report(operand.range, diag::ProstepWordAcrossBorder, ToText(operand));
  }
}

}  // namespace plcxx::prostep
