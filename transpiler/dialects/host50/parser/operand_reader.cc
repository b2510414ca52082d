#include "transpiler/dialects/host50/parser/operand_reader.h"

namespace plcxx::host50 {
namespace {

/// "the constant '5'", "bit '%I0'": what stands where something else is needed.
std::string Described(std::string_view what, std::string_view text) {
  return std::string(what) + " '" + std::string(text) + "'";
}

bool IsInstance(const Address& address) { return address.area == Area::kTm || address.area == Area::kC; }

/// Of a timer or counter a program writes the value of a counter only.
bool IsProtected(const Address& address) {
  if (!IsInstance(address) || address.attribute == Attribute::kNone) return false;
  return address.area == Area::kTm || address.attribute != Attribute::kV;
}

Type WantedBy(OperandRole role) {
  switch (role) {
    case OperandRole::kFloatSource:
    case OperandRole::kFloatDivisor:
    case OperandRole::kFloatResult:
      return Type::kFloat;
    case OperandRole::kNumberSource:
    case OperandRole::kNumberResult:
    case OperandRole::kNumberInPlace:
    case OperandRole::kPosition:
      return Type::kUnknown;  // any number
    case OperandRole::kIntSource:
    case OperandRole::kIntDivisor:
    case OperandRole::kIntResult:
    case OperandRole::kBit:
    case OperandRole::kBitOrConstant:
    case OperandRole::kCoil:
    case OperandRole::kFieldSource:
    case OperandRole::kFieldResult:
    case OperandRole::kBitCount:
    case OperandRole::kTimer:
    case OperandRole::kCounter:
    case OperandRole::kUnit:
    case OperandRole::kSubroutine:
    case OperandRole::kJumpTarget:
    case OperandRole::kAxisNumber:
    case OperandRole::kHomingMethod:
    case OperandRole::kComparison:
    case OperandRole::kAssignment:
    case OperandRole::kText:
      return Type::kInteger;
  }
  PLCXX_UNREACHABLE();
}

bool Suits(Type wanted, Type type) {
  return wanted == Type::kUnknown ? type == Type::kInteger || type == Type::kFloat : type == wanted;
}

bool IsFloat(const Operand& operand) { return operand.type == Type::kFloat; }

}  // namespace

/// E107. kUnknown: any number.
void OperandReader::FaultOfType(Type wanted, source::Range range, std::string_view found) {
  switch (wanted) {
    case Type::kUnknown:
      Fault(range, diag::Host50NumberExpected, found);
      return;
    case Type::kBit:
      Fault(range, diag::Host50BitExpected, found);
      return;
    case Type::kInteger:
      Fault(range, diag::Host50IntegerExpected, found);
      return;
    case Type::kFloat:
      Fault(range, diag::Host50FloatExpected, found);
      return;
    case Type::kTimer:
      Fault(range, diag::Host50TimerExpected, found);
      return;
    case Type::kCounter:
      Fault(range, diag::Host50CounterExpected, found);
      return;
  }
  PLCXX_UNREACHABLE();
}

Operand OperandReader::ReadOperand(OperandRole role) {
  Operand operand{.role = role, .range = Peek().range};
  number_tokens_.push_back(AtNumber() ? Peek() : Token{});
  switch (role) {
    case OperandRole::kBit:
    case OperandRole::kBitOrConstant:
      ReadBit(operand);
      break;
    case OperandRole::kCoil:
      ReadCoil(operand);
      break;
    case OperandRole::kIntSource:
    case OperandRole::kIntDivisor:
    case OperandRole::kFloatSource:
    case OperandRole::kFloatDivisor:
    case OperandRole::kNumberSource:
    case OperandRole::kPosition:
    case OperandRole::kAxisNumber:
    case OperandRole::kHomingMethod:
      ReadNumber(operand);
      break;
    case OperandRole::kIntResult:
    case OperandRole::kFloatResult:
    case OperandRole::kNumberResult:
    case OperandRole::kNumberInPlace:
      ReadResult(operand);
      break;
    case OperandRole::kFieldSource:
    case OperandRole::kFieldResult:
      ReadField(operand);
      break;
    case OperandRole::kBitCount:
      ReadBitCount(operand);
      break;
    case OperandRole::kTimer:
    case OperandRole::kCounter:
      ReadInstance(operand);
      break;
    case OperandRole::kSubroutine:
      ReadSubroutine(operand);
      break;
    case OperandRole::kJumpTarget:
      ReadJumpTarget(operand);
      break;
    case OperandRole::kText:
      ReadText(operand);
      break;
    case OperandRole::kUnit:
    case OperandRole::kComparison:
    case OperandRole::kAssignment:
      PLCXX_UNREACHABLE();  // no operands of their own
  }
  if (now_.failed) operand.kind = OperandKind::kError;
  return operand;
}

bool OperandReader::ReadPlace(Operand& operand, std::string_view what) {
  if (!At(TokenKind::kAddress) && !At(TokenKind::kWord) && !At(TokenKind::kQuotedSymbol)) {
    FaultOfMissing(what);
    return false;
  }
  const SymbolReader::Resolved resolved = symbols_.ReadAddress();
  if (!resolved.ok) return false;
  operand.kind = OperandKind::kAddress;
  operand.address = resolved.address;
  operand.symbol = resolved.symbol;
  operand.type = TypeOf(resolved.address);
  return true;
}

/// A bare timer or counter is its .Q here. No text of the constants 0 and 1 but these.
void OperandReader::ReadBit(Operand& operand) {
  const Token token = Peek();
  const std::string_view text = TextOf(token);
  if (AtNumber()) {
    Take();
    if (operand.role == OperandRole::kBitOrConstant && (text == "0" || text == "1")) {
      operand.kind = OperandKind::kConstant;
      operand.type = Type::kBit;
      operand.bits = text == "1";
      return;
    }
    return FaultOfType(Type::kBit, token.range, Described("the constant", text));
  }
  if (!ReadPlace(operand, Name(operand.role))) return;
  if (operand.type == Type::kTimer || operand.type == Type::kCounter) {
    operand.address.attribute = Attribute::kQ;
    operand.type = Type::kBit;
  }
  if (operand.type != Type::kBit) FaultOfType(Type::kBit, token.range, Described(Name(operand.type), text));
}

void OperandReader::ReadCoil(Operand& operand) {
  const Token token = Peek();
  const std::string_view text = TextOf(token);
  if (AtNumber()) {
    Take();
    Fault(token.range, diag::Host50DestinationConstant, text);
    return;
  }
  if (!ReadPlace(operand, Name(operand.role))) return;
  if (IsInstance(operand.address) || operand.address.area == Area::kI) {
    Fault(token.range, diag::Host50CannotWriteCoil, text);
  } else if (operand.type != Type::kBit) {
    FaultOfType(Type::kBit, token.range, Described(Name(operand.type), text));
  }
}

/// Of a number whose type is decided by another operand only the token is kept; SettleConstants does the rest.
void OperandReader::ReadNumber(Operand& operand) {
  const Token token = Peek();
  const Type wanted = WantedBy(operand.role);
  if (!AtNumber()) {
    if (!ReadPlace(operand, Name(operand.role))) return;
    if (!Suits(wanted, operand.type)) FaultOfType(wanted, token.range, Described(Name(operand.type), TextOf(token)));
    return;
  }
  Take();
  if (wanted == Type::kInteger) {
    if (token.kind == TokenKind::kFloat) return FaultOfType(wanted, token.range, Described("float", TextOf(token)));
    SetInteger(operand, token);
    if (operand.role == OperandRole::kAxisNumber) CheckAxisNumber(operand);
  } else if (operand.role == OperandRole::kNumberSource) {
    operand.kind = OperandKind::kConstant;
    operand.type = token.kind == TokenKind::kFloat ? Type::kFloat : Type::kInteger;
  } else {
    SetFloat(operand, token);
  }
}

void OperandReader::SetInteger(Operand& operand, const Token& token) {
  const Integer integer = IntegerOf(token, TextOf(token));
  if (!integer.fits) Fault(token.range, diag::Host50IntegerRange, TextOf(token));
  operand.kind = OperandKind::kConstant;
  operand.type = Type::kInteger;
  operand.bits = static_cast<uint32_t>(integer.value);
}

void OperandReader::SetFloat(Operand& operand, const Token& token) {
  const auto bits = FloatBitsOf(token, TextOf(token));
  if (!bits) Fault(token.range, diag::Host50FloatRange, TextOf(token));
  operand.kind = OperandKind::kConstant;
  operand.type = Type::kFloat;
  operand.bits = bits.value_or(0);
}

void OperandReader::CheckAxisNumber(const Operand& operand) {
  const int64_t first = program_.settings.axisbase == AxisBaseOption::kZero ? 0 : 1;
  const int64_t last = first + kAxes - 1;
  const auto number = static_cast<int32_t>(operand.bits);
  if (number < first || number > last) {
    Fault(operand.range, diag::Host50AxisRange, TextOf(operand.range), first, last);
  }
}

void OperandReader::ReadResult(Operand& operand) {
  const Token token = Peek();
  const std::string_view text = TextOf(token);
  const Type wanted = WantedBy(operand.role);
  if (AtNumber()) {
    Take();
    Fault(token.range, diag::Host50DestinationConstant, text);
    return;
  }
  if (!ReadPlace(operand, Name(operand.role))) return;
  if (IsProtected(operand.address)) {
    Fault(token.range, diag::Host50CannotWriteResult, text);
  } else if (!Suits(wanted, operand.type)) {
    FaultOfType(wanted, token.range, Described(Name(operand.type), text));
  }
}

void OperandReader::ReadField(Operand& operand) {
  const Token token = Peek();
  const std::string_view text = TextOf(token);
  const bool writes = Writes(operand.role);
  if (AtNumber()) {
    Take();
    if (!writes) return FaultOfType(Type::kBit, token.range, Described("the constant", text));
    Fault(token.range, diag::Host50DestinationConstant, text);
    return;
  }
  if (!ReadPlace(operand, Name(operand.role))) return;
  const Address& address = operand.address;
  const bool bare_instance = IsInstance(address) && address.attribute == Attribute::kNone;
  if (writes && (address.area == Area::kI || bare_instance || IsProtected(address))) {
    Fault(token.range, diag::Host50CannotWriteResult, text);
  } else if (operand.type != Type::kBit || IsInstance(address)) {
    FaultOfType(Type::kBit, token.range, Described(Name(operand.type), text));
  }
}

void OperandReader::ReadBitCount(Operand& operand) {
  const Token token = Peek();
  if (At(TokenKind::kEnd) || At(TokenKind::kComma) || IsBad(token.kind)) return FaultOfMissing(Name(operand.role));
  Take();
  const std::string_view text = TextOf(token);
  const bool plain = token.kind == TokenKind::kInteger && IsDigit(text.front());
  const int64_t count = plain ? IntegerOf(token, text).value : 0;
  if (count < 1 || count > kMostBits) {
    Fault(token.range, diag::Host50BitCount, text);
    return;
  }
  operand.kind = OperandKind::kCount;
  operand.bits = static_cast<uint32_t>(count);
}

/// A timer or counter itself.
void OperandReader::ReadInstance(Operand& operand) {
  const Token token = Peek();
  const std::string_view text = TextOf(token);
  const Type wanted = operand.role == OperandRole::kTimer ? Type::kTimer : Type::kCounter;
  if (AtNumber()) {
    Take();
    return FaultOfType(wanted, token.range, Described("the constant", text));
  }
  if (!ReadPlace(operand, Name(operand.role))) return;
  if (operand.type != wanted) FaultOfType(wanted, token.range, Described(Name(operand.type), text));
}

void OperandReader::ReadSubroutine(Operand& operand) {
  const Token token = Peek();
  if (At(TokenKind::kEnd) || IsBad(token.kind)) return FaultOfMissing(Name(operand.role));
  const std::string found = Found();
  Take();
  const std::string_view text = TextOf(token);
  const auto number = token.kind == TokenKind::kWord ? NumberBehind("SR", text) : std::nullopt;
  if (!number) {
    Fault(token.range, diag::Host50SubroutineNameExpected, found);
  } else if (*number > kGreatestLabel) {
    Fault(token.range, diag::Host50LabelRange, text);
  } else if (const auto section = parts_.subroutines.find(*number); section == parts_.subroutines.end()) {
    Fault(token.range, diag::Host50UndefinedSubroutine, text);
  } else {
    operand.kind = OperandKind::kSubroutine;
    operand.section = section->second;
  }
}

void OperandReader::ReadJumpTarget(Operand& operand) {
  const Token token = Peek();
  if (At(TokenKind::kEnd) || IsBad(token.kind)) return FaultOfMissing(Name(operand.role));
  const std::string found = Found();
  Take();
  const std::string_view text = TextOf(token);
  const auto number = token.kind == TokenKind::kWord ? NumberBehind("J", text) : std::nullopt;
  if (!number) {
    Fault(token.range, diag::Host50JumpTargetExpected, found);
  } else if (*number > kGreatestLabel) {
    Fault(token.range, diag::Host50LabelRange, text);
  } else if (const auto network = parts_.labels.find({now_.section, *number}); network != parts_.labels.end()) {
    operand.kind = OperandKind::kNetwork;
    operand.network = network->second;
  } else if (program_.sections[now_.section].kind != SectionKind::kNone) {
    Fault(token.range, diag::Host50UndefinedLabel, text);
  }
}

void OperandReader::ReadUnit(Instruction& instruction) {
  const Token token = Peek();
  if (At(TokenKind::kEnd) || At(TokenKind::kComma) || IsBad(token.kind)) {
    return FaultOfMissing(Name(OperandRole::kUnit));
  }
  const std::string found = Found();
  Take();
  const auto unit = token.kind == TokenKind::kWord ? UnitByName(TextOf(token)) : std::nullopt;
  if (!unit) Fault(token.range, diag::Host50UnitExpected, found);
  instruction.unit = unit.value_or(TimerUnit::kHundredMs);
}

/// The text of a REMARK may be empty.
void OperandReader::ReadText(Operand& operand) {
  operand.kind = OperandKind::kText;
  if (At(TokenKind::kText) || At(TokenKind::kString)) {
    Take();
  } else if (!At(TokenKind::kEnd)) {
    FaultOfMissing(Name(operand.role));
  }
}

void OperandReader::SettleConstants(Instruction& instruction) {
  Operand* operands = program_.operands.data() + instruction.operands.first;
  const uint32_t count = instruction.operands.count;
  const bool float_beside = std::any_of(operands, operands + count, IsFloat);
  for (uint32_t i = 0; i < count; ++i) {
    Operand& operand = operands[i];
    if (operand.role != OperandRole::kNumberSource || operand.kind != OperandKind::kConstant) continue;
    float_beside ? SetFloat(operand, number_tokens_[i]) : SetInteger(operand, number_tokens_[i]);
  }
  if (count == 0 || operands[count - 1].kind != OperandKind::kCount) return;
  const uint32_t bits = operands[count - 1].bits;
  const Operand* field = std::find_if(operands, operands + count, [](const Operand& operand) {
    return operand.role == OperandRole::kFieldSource || operand.role == OperandRole::kFieldResult;
  });
  for (uint32_t bit = 0; bit < bits; ++bit) {
    if (Exists(field->address.area, field->address.number + bit, program_.settings.channels)) continue;
    Fault(field->range, diag::Host50BitField, TextOf(field->range), bits);
    return;
  }
}

}  // namespace plcxx::host50
