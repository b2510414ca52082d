#include "transpiler/dialects/host50/parser/instruction_reader.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace plcxx::host50 {

/// Mnemonics of other controls have their names here.
void InstructionReader::FaultOfUnknownInstruction(const Token& token) {
  struct OtherName {
    std::string_view word, meant;
  };
  constexpr OtherName kOtherNames[] = {
      {"LDN", "LDI"},
      {"ANDN", "ANDI"},
      {"ANI", "ANDI"},
      {"ORN", "ORI"},
      {"ST", "OUT"},
      {"S", "SET"},
      {"R", "RST"},
      {"RES", "RST"},
      {"=", "OUT"},
      {"NOT", "the inverted contact: LDI, ANDI or ORI"},
      {"END", "the END word of the part that is open, such as END_SLOW"},
      {"A", "AND"},
      {"AN", "ANDI"},
      {"O", "OR"},
      {"ON", "ORI"},
      {"U", "AND"},
      {"UN", "ANDI"},
      {"STN", "OUTI"},
      {"OUTN", "OUTI"},
      {"XOR", "an exclusive or by contacts: LD a, ANDI b, LDI a, AND b, ORB"},
      {"RESET", "RST"},
      {"JMP", "LBL and the target, such as LBL J3 for the network L0003"},
      {"JMPC", "LBL and the target, such as LBL J3 for the network L0003"},
      {"GOTO", "LBL and the target, such as LBL J3 for the network L0003"},
      {"JSR", "CALL and the subroutine, such as CALL SR4"},
      {"CAL", "CALL and the subroutine, such as CALL SR4"},
      {"RET", "END_SUB, which ends a subroutine; a jump LBL leads to its last network"},
      {"CTU", "CNUD, the counter that counts up and down"},
      {"CTD", "CNUD, the counter that counts up and down"},
      {"CTUD", "CNUD, the counter that counts up and down"},
      {"CNT", "CNUD, the counter that counts up and down"},
      {"TMR", "TONMS, TONS or TONM, the timers that switch on with a delay"},
      {"TIM", "TONMS, TONS or TONM, the timers that switch on with a delay"},
      {"INC", "ADDW and 1: ADDW %W1, 1, %W1"},
      {"DEC", "SUBW and 1: SUBW %W1, 1, %W1"},
      {"MOVE", "MOV"},
      {"ADD", "ADDW for integers, ADDF for floats"},
      {"MUL", "MULW for integers, MULF for floats"},
      {"DIV", "DIVW for integers, DIVF for floats"},
      {"CMP", "COMP and one comparison, such as COMP %W1 > 5"},
  };
  std::string word(TextOf(token));
  std::ranges::transform(word, word.begin(), Upper);
  const auto* const other = std::ranges::find(kOtherNames, word, &OtherName::word);
  if (const std::string narrowed = Narrowed(TextOf(token)); narrowed != TextOf(token) && MnemonicByName(narrowed)) {
    Fault(token.range, diag::Host50UnknownInstructionHint, TextOf(token), narrowed + " with narrow letters")
        .fixits.push_back({token.range, narrowed});
  } else if (other != std::end(kOtherNames)) {
    Fault(token.range, diag::Host50UnknownInstructionHint, TextOf(token), other->meant);
  } else if (const std::string_view near = NearMnemonic(word); !near.empty()) {
    Fault(token.range, diag::Host50UnknownInstructionNear, TextOf(token), near);
  } else {
    Fault(token.range, diag::Host50UnknownInstruction, TextOf(token));
  }
}

void InstructionReader::ReadStatement(Instruction& instruction) {
  const Token token = Peek();
  instruction.mnemonic = token.range;
  const auto mnemonic = token.kind == TokenKind::kWord ? MnemonicByName(TextOf(token)) : std::nullopt;
  if (!mnemonic) {
    instruction.unknown = true;
    if (!FaultOfBadToken()) FaultOfUnknownInstruction(token);
    return;
  }
  Take();
  instruction.op = mnemonic->op;
  instruction.unit = mnemonic->unit.value_or(TimerUnit::kHundredMs);
  ReadOperands(instruction, Setting::kList);
}

std::string_view InstructionReader::MnemonicOf(const Instruction& instruction, Setting setting) const {
  const InstructionInfo& info = Info(instruction.op);
  return setting == Setting::kDrawing && info.form == Form::kBasic ? info.name : TextOf(instruction.mnemonic);
}

void InstructionReader::ReadOperands(Instruction& instruction, Setting setting) {
  const InstructionInfo& info = Info(instruction.op);
  const bool leaves_section = info.operand_count == 1 && (info.operands[0] == OperandRole::kSubroutine ||
                                                          info.operands[0] == OperandRole::kJumpTarget);
  if (leaves_section && program_.sections[now_.section].kind == SectionKind::kFast) {
    Fault(instruction.mnemonic, diag::Host50NotInFast, MnemonicOf(instruction, setting));
  }
  const bool has_unit = info.operand_count > 1 && info.operands[1] == OperandRole::kUnit && UnitIsNamed(instruction);
  operands_.BeginOperands();
  std::vector<Operand> operands;
  for (uint8_t i = 0; i < info.operand_count && !now_.failed; ++i) {
    const OperandRole role = info.operands[i];
    if (role == OperandRole::kUnit && has_unit) continue;
    if (i > 0 && !TakeIf(TokenKind::kComma)) {
      if (At(TokenKind::kEnd) || IsBad(Peek().kind)) {
        FaultOfMissing(Name(role));
      } else {
        Fault(Peek().range, diag::Host50CommaExpected, Found());
      }
    } else if (role == OperandRole::kComparison) {
      operands.push_back(expressions_.ReadComparison());
    } else if (role == OperandRole::kAssignment) {
      expressions_.ReadAssignment(operands);
    } else if (Peek().kind == TokenKind::kWord && Peek(1).kind == TokenKind::kEquals) {
      Fault(Peek().range, diag::Host50OperandExpected, Name(role), "pin " + Found());
    } else if (role == OperandRole::kUnit) {
      operands_.ReadUnit(instruction);
    } else {
      operands.push_back(operands_.ReadOperand(role));
    }
  }
  instruction.operands = {static_cast<uint32_t>(program_.operands.size()), static_cast<uint32_t>(operands.size())};
  program_.operands.insert(program_.operands.end(), operands.begin(), operands.end());
  ReadPins(instruction, setting);
  if (!now_.failed) ExpectEnd();
  if (!now_.failed) operands_.SettleConstants(instruction);
  const bool has_timer = !operands.empty() && operands.front().role == OperandRole::kTimer;
  if (has_timer && (!now_.failed || UnitIsNamed(instruction))) CheckTimer(instruction);
}

bool InstructionReader::UnitIsNamed(const Instruction& instruction) const {
  const auto mnemonic = MnemonicByName(TextOf(instruction.mnemonic));
  return mnemonic && mnemonic->unit.has_value();
}

void InstructionReader::ReadPins(Instruction& instruction, Setting setting) {
  const InstructionInfo& info = Info(instruction.op);
  std::vector<Pin> pins;
  for (const char name : info.pins) pins.push_back({.name = name, .from_stack = true});
  while (!now_.failed && info.form == Form::kBlock && TakeIf(TokenKind::kComma)) ReadPin(instruction, pins);
  if (!now_.failed && setting == Setting::kDrawing && At(TokenKind::kEnd)) {
    const auto missing = std::ranges::find(pins, true, &Pin::from_stack);
    if (missing != pins.end()) {
      Fault(instruction.range, diag::Host50MissingDrawnPin, std::string(1, missing->name),
            MnemonicOf(instruction, setting));
    }
  }
  instruction.pins = {static_cast<uint32_t>(program_.pins.size()), static_cast<uint32_t>(pins.size())};
  program_.pins.insert(program_.pins.end(), pins.begin(), pins.end());
}

/// name "=" ( "0" | "1" | [ "!" ] bit )
void InstructionReader::ReadPin(const Instruction& instruction, std::vector<Pin>& pins) {
  const Token name = Peek();
  if (name.kind != TokenKind::kWord || Peek(1).kind != TokenKind::kEquals) {
    if (At(TokenKind::kEnd) || IsBad(name.kind)) return FaultOfMissing("a pin");
    return ExpectEnd();
  }
  const std::string_view word = TextOf(name);
  const auto pin = word.size() == 1 ? std::ranges::find(pins, Upper(word.front()), &Pin::name) : pins.end();
  if (pin == pins.end()) {
    std::string remedy = "the block has no pins but its main input, which is never named";
    for (const Pin& known : pins) {
      remedy = &known == pins.data() ? "its pins are " : remedy + ", ";
      remedy += known.name;
    }
    Fault(name.range, diag::Host50UnknownPin, word, TextOf(instruction.mnemonic), remedy);
    return;
  }
  if (!pin->from_stack) {
    Fault(name.range, diag::Host50RepeatedPin, word);
    return;
  }
  Take(), Take();
  const bool inverted = TakeIf(TokenKind::kExclamation);
  pin->from_stack = false;
  pin->operand = operands_.ReadOperand(inverted ? OperandRole::kBit : OperandRole::kBitOrConstant);
  pin->operand.inverted = inverted;
  pin->range = {name.range.begin, pin->operand.range.end};
}

void InstructionReader::CheckTimer(const Instruction& instruction) {
  const Operand& timer = program_.operands[instruction.operands.first];
  if (timer.kind != OperandKind::kAddress) return;
  const auto [use, is_new] =
      timers_.emplace(timer.address.number, TimerUse{instruction.op, instruction.unit, instruction.range});
  const TimerUse& first = use->second;
  if (is_new || (first.op == instruction.op && first.unit == instruction.unit)) return;
  Fault(timer.range, diag::Host50TimerKinds, ToText(timer.address), TimerName(first.op, first.unit),
        TimerName(instruction.op, instruction.unit))
      .notes.push_back({first.range, "it is used here"});
}

}  // namespace plcxx::host50
