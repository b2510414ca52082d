// The bodies of networks: instructions, their operands and pins (specification 3.3 to 3.5, 6).
#include <algorithm>
#include <iterator>
#include <string>

#include "transpiler/dialects/host50/parser/internal.h"
#include "transpiler/dialects/host50/parser/rung_machine.h"

namespace plcxx::host50 {
namespace {

bool IsFloat(const Operand& operand) { return operand.type == Type::kFloat; }

}  // namespace

void Parser::ReadBodies() {
  for (const Body& body : bodies_) {
    file_ = body.file;
    EnterFile(files_[file_]);
    section_ = program_.networks[body.network].section;
    ReadBody(body);
  }
}

void Parser::ReadBody(const Body& body) {
  Network& network = program_.networks[body.network];
  network.instructions.first = program_.instructions.size();
  std::vector<source::Range> comments;  // above the next instruction
  bool mixed = false;                   // E607: once for each network
  const auto fault_of_mixing = [&](Line& line, std::string_view word) {
    if (std::exchange(mixed, true)) return;
    Begin(line);
    Fault(line.range, diag::Host50LadderMixed, word);
    line.faulty = true;
  };
  bool listed = false;
  for (uint32_t i = body.first; i < body.last;) {
    Line& line = files_[body.file].lines[i++];
    if (line.kind == LineKind::kComment) comments.push_back(line.comment);
    if (line.kind == LineKind::kBlank || line.kind == LineKind::kComment || line.consumed) continue;
    const std::string_view word = WordOf(line);
    if (PartByEnd(word) == PartKind::kLadder) continue;
    if (PartByName(word) == PartKind::kLadder) {
      Begin(line);
      if (network.is_drawing) {
        Fault(line.range, diag::Host50LadderTwice);
      } else if (listed) {
        fault_of_mixing(line, "instructions");
      } else {
        Take();
        ExpectEnd();
      }
      network.is_drawing = true;
      if (line.comment.end > line.comment.begin) comments.push_back(line.comment);
      i = ReadDrawing(body, i, comments);
      continue;
    }
    const auto mnemonic = MnemonicByName(word);
    const bool is_remark = mnemonic && Info(mnemonic->op).effect == RungEffect::kNothing;
    if (!is_remark && network.is_drawing && mnemonic) fault_of_mixing(line, "an instruction");
    listed = listed || !is_remark;
    ReadInstruction(line, body.network, comments);
  }
  network.instructions.count = program_.instructions.size() - network.instructions.first;
  if (!network.is_drawing) EvaluateRungs(program_, body.network, sources_, diagnostics_);
}

Span Parser::AddComments(std::vector<source::Range>& above, source::Range row) {
  Span span{.first = static_cast<uint32_t>(program_.comments.size())};
  for (const source::Range range : above) program_.comments.push_back({range, CommentPlace::kAbove});
  above.clear();
  if (row.end > row.begin) program_.comments.push_back({row, CommentPlace::kRow});
  span.count = static_cast<uint32_t>(program_.comments.size()) - span.first;
  return span;
}

void Parser::ReadInstruction(const Line& line, NetworkId network, std::vector<source::Range>& comments) {
  Instruction instruction{.network = network, .range = line.range};
  instruction.comments = AddComments(comments, line.comment);
  Begin(line);
  failed_ = line.faulty;
  ReadStatement(instruction);
  instruction.faulty = failed_;
  program_.instructions.Add(instruction);
  ++program_.statement_count;
}

/// Mnemonics of other controls have their names here.
void Parser::FaultOfUnknownInstruction(const Token& token) {
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
      {"CAL", "CALL and the subroutine, such as CALL SR4"},
      {"RET", "END_SUB, which ends a subroutine; a jump LBL leads to its last network"},
      {"CTU", "CNUD, the counter that counts up and down"},
      {"CTD", "CNUD, the counter that counts up and down"},
      {"CTUD", "CNUD, the counter that counts up and down"},
      {"CNT", "CNUD, the counter that counts up and down"},
      {"MOVE", "MOV"},
      {"ADD", "ADDW for integers, ADDF for floats"},
      {"MUL", "MULW for integers, MULF for floats"},
      {"DIV", "DIVW for integers, DIVF for floats"},
      {"CMP", "COMP and one comparison, such as COMP %W1 > 5"},
  };
  std::string word(TextOf(token));
  std::ranges::transform(word, word.begin(), Upper);
  const auto* const other = std::ranges::find(kOtherNames, word, &OtherName::word);
  if (other == std::end(kOtherNames)) {
    Fault(token.range, diag::Host50UnknownInstruction, TextOf(token));
  } else {
    Fault(token.range, diag::Host50UnknownInstructionHint, TextOf(token), other->meant);
  }
}

void Parser::ReadStatement(Instruction& instruction) {
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

std::string_view Parser::MnemonicOf(const Instruction& instruction, Setting setting) const {
  const InstructionInfo& info = Info(instruction.op);
  return setting == Setting::kDrawing && info.form == Form::kBasic ? info.name : TextOf(instruction.mnemonic);
}

/// What stands after the mnemonic, to the end of the statement.
void Parser::ReadOperands(Instruction& instruction, Setting setting) {
  const InstructionInfo& info = Info(instruction.op);
  const bool leaves_section = info.operand_count == 1 && (info.operands[0] == OperandRole::kSubroutine ||
                                                          info.operands[0] == OperandRole::kJumpTarget);
  if (leaves_section && program_.sections[section_].kind == SectionKind::kFast) {
    Fault(instruction.mnemonic, diag::Host50NotInFast, MnemonicOf(instruction, setting));
  }
  const bool has_unit = info.operand_count > 1 && info.operands[1] == OperandRole::kUnit && UnitIsNamed(instruction);
  number_tokens_.clear();
  std::vector<Operand> operands;
  for (uint8_t i = 0; i < info.operand_count && !failed_; ++i) {
    const OperandRole role = info.operands[i];
    if (role == OperandRole::kUnit && has_unit) continue;
    if (i > 0 && !TakeIf(TokenKind::kComma)) {
      if (At(TokenKind::kEnd) || IsBad(Peek().kind)) {
        FaultOfMissing(Name(role));
      } else {
        Fault(Peek().range, diag::Host50CommaExpected, Found());
      }
    } else if (role == OperandRole::kComparison) {
      operands.push_back(ReadComparison());
    } else if (role == OperandRole::kAssignment) {
      ReadAssignment(operands);
    } else if (Peek().kind == TokenKind::kWord && Peek(1).kind == TokenKind::kEquals) {
      Fault(Peek().range, diag::Host50OperandExpected, Name(role), "pin " + Found());
    } else if (role == OperandRole::kUnit) {
      ReadUnit(instruction);
    } else {
      operands.push_back(ReadOperand(role));
    }
  }
  instruction.operands = {static_cast<uint32_t>(program_.operands.size()), static_cast<uint32_t>(operands.size())};
  program_.operands.insert(program_.operands.end(), operands.begin(), operands.end());
  ReadPins(instruction, setting);
  if (!failed_) ExpectEnd();
  if (!failed_) SettleConstants(instruction);
  const bool has_timer = !operands.empty() && operands.front().role == OperandRole::kTimer;
  if (has_timer && (!failed_ || UnitIsNamed(instruction))) CheckTimer(instruction);
}

/// TONS and the like have their unit in their name.
bool Parser::UnitIsNamed(const Instruction& instruction) const {
  const auto mnemonic = MnemonicByName(TextOf(instruction.mnemonic));
  return mnemonic && mnemonic->unit.has_value();
}

void Parser::ReadPins(Instruction& instruction, Setting setting) {
  const InstructionInfo& info = Info(instruction.op);
  std::vector<Pin> pins;
  for (const char name : info.pins) pins.push_back({.name = name, .from_stack = true});
  while (!failed_ && info.form == Form::kBlock && TakeIf(TokenKind::kComma)) ReadPin(instruction, pins);
  if (!failed_ && setting == Setting::kDrawing && At(TokenKind::kEnd)) {
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
void Parser::ReadPin(const Instruction& instruction, std::vector<Pin>& pins) {
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
  pin->operand = ReadOperand(inverted ? OperandRole::kBit : OperandRole::kBitOrConstant);
  pin->operand.inverted = inverted;
  pin->range = {name.range.begin, pin->operand.range.end};
}

/// The constants of MOV and of compares: a float opposite a float, else an int32. The field of BTOW and WTOB.
void Parser::SettleConstants(Instruction& instruction) {
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

/// E501: a timer belongs to one kind and one unit.
void Parser::CheckTimer(const Instruction& instruction) {
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
