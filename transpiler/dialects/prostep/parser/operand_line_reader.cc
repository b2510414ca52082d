#include "transpiler/dialects/prostep/parser/operand_line_reader.h"

#include <algorithm>
#include <utility>

namespace plcxx::prostep {
namespace {

/// The sixteen bits as the digits that they are read as: "2050".
std::string DigitsOf(uint16_t bits) {
  std::string digits;
  for (int shift = 12; shift >= 0; shift -= 4) {
    const int digit = bits >> shift & 15;
    if (digit != 0 || !digits.empty() || shift == 0) digits += static_cast<char>('0' + digit);
  }
  return digits;
}

/// Operand lines are recognised by these classes too, but no instruction takes them there.
bool IsMemoryOrConstant(OperandClass operand_class) {
  return operand_class != OperandClass::kNone && Accepts(kData | kConstants, operand_class);
}

}  // namespace

void OperandLineReader::TakeOperandLine(const Statement& statement) {
  if (const Token* label = labels_.TheLabel(statement)) {
    diagnostics_.Report(label->range, diag::ProstepLabelOnOperand, TextOf(*label));
  }
  const bool waits = now_.waiting.found < now_.waiting.most;
  const std::string text = operands_.OperandText(statement.tokens, 0);
  if (!waits) {
    const bool reported = IsReported(statement) || std::exchange(now_.waiting.surplus, true);
    if (!reported) diagnostics_.Report(statement.range, diag::ProstepStrayOperand, text);
    if (statement.has_comment()) comments_.AddComment(statement.comment.range, CommentPlace::kLeading);
    return;
  }
  ++now_.waiting.found;
  Instruction& instruction = Current();
  instruction.whole.end = statement.range.end;
  comments_.AttachInside(instruction, statement.comment);
  // The operands of an instruction that was not understood are part of its fault.
  if (instruction.faulty && now_.waiting.fewest == 0) return;
  const bool faulty_before = instruction.faulty;
  if (IsReported(statement)) {
    instruction.faulty = true;
  } else if (instruction.function) {
    TakeArgument(statement, instruction, *instruction.function);
  } else {
    TakeNextOperand(statement, instruction);
  }
  if (instruction.faulty == faulty_before && !instruction.faulty) instructions_.WarnOfComment(statement, false);
}

void OperandLineReader::TakeNextOperand(const Statement& statement, Instruction& instruction) {
  const InstructionInfo& info = Info(instruction.op);
  const OperandClass operand_class = operands_.ClassOf(statement.tokens, 0);
  if (!Accepts(info.next, operand_class)) {
    instruction.faulty = true;
    const std::string text = operands_.OperandText(statement.tokens, 0);
    diagnostics_.Report(statement.range, diag::ProstepOperandNotAllowed, text, info.mnemonic, Accepted(info.next));
    return;
  }
  const Operand operand = operands_.ReadOperand(statement.tokens, 0);
  if (!operand.exists() || !operands_.IsInRange(operand, Access::kRead)) {
    instruction.faulty = true;
    return;
  }
  operands_.WarnOfBorder(operand);
  if (info.lines == Lines::kOneOf) {
    instruction.operand = operand;
    return;
  }
  if (operand.shape() == Shape::kConstant) {
    CheckBcd(operand, (info.own & kTimerSet) != 0 ? BcdUse::kTime : BcdUse::kPreset);
  }
  program_.arguments.push_back(operand);
  ++instruction.arguments.count;
}

void OperandLineReader::CheckBcd(const Operand& operand, BcdUse use) {
  const std::string_view text = sources_.Text(operand.range);
  const std::string name = "K " + std::string(TrimBlanks(text.substr(1)));
  if (!IsBcd(operand.value, use)) {
    const bool time = use == BcdUse::kTime;
    constexpr uint32_t kMostPreset = 999, kMostTime = 3999;
    const bool digits = operand.form == NumberForm::kDecimal && operand.value <= (time ? kMostTime : kMostPreset);
    const std::string with_d = "its bits are no decimal digits: write the digits with D, " + name + "D";
    diagnostics_.Report(operand.range, diag::ProstepBcdRange, name, time ? "a time" : "a preset",
                        digits ? std::string_view(with_d)
                        : time ? "a time has a scale digit 0 to 3 and three digits: 2050D is 50 times 100 ms"
                               : "a preset has three digits: 0D to 999D");
  } else if (operand.form == NumberForm::kDecimal && operand.value > 9) {
    diagnostics_.Report(operand.range, diag::ProstepDecimalAsBcd, name, DigitsOf(operand.value));
  }
}

void OperandLineReader::TakeArgument(const Statement& statement, Instruction& instruction, Function function) {
  const FunctionInfo& info = Info(function);
  const ShapeInfo& shape = Info(info.arguments[instruction.arguments.count]);
  const std::string call = ToText(program_, instruction);
  const OperandClass operand_class = operands_.ClassOf(statement.tokens, 0);
  const uint32_t errors = diagnostics_.error_count();
  Operand operand;
  if (!IsMemoryOrConstant(operand_class)) {
    const std::string text = operands_.OperandText(statement.tokens, 0);
    diagnostics_.Report(statement.range, diag::ProstepOperandNotAllowed, text, call, Accepted(kData | kConstants));
  } else {
    operand = operands_.ReadOperand(statement.tokens, 0);
    if (operand.exists()) CheckArgument(operand, shape, call);
  }
  instruction.faulty |= diagnostics_.error_count() != errors;
  program_.arguments.push_back(operand);
  ++instruction.arguments.count;
  if (!instruction.faulty && now_.waiting.found == info.count) CheckVariable(instruction, function);
}

void OperandLineReader::CheckArgument(Operand& operand, const ShapeInfo& shape, std::string_view call) {
  if (operand.shape() == Shape::kConstant) {
    const std::string text = "K " + std::string(TrimBlanks(sources_.Text(operand.range).substr(1)));
    if (shape.constant == Constant::kRefused) {
      diagnostics_.Report(operand.range, diag::ProstepConstantRefused, text, call);
    } else if (shape.constant == Constant::kDisables) {
      diagnostics_.Report(operand.range, diag::ProstepConstantDisables, text, call);
    }
    return;
  }
  if (shape.field_bytes != 0) return CheckField(operand, shape, call);
  if (!operands_.IsInRange(operand, shape.access)) return;
  operands_.WarnOfBorder(operand);
  if (shape.constant == Constant::kExpected) {
    diagnostics_.Report(operand.range, diag::ProstepIndexVariable, ToText(operand), call);
  }
}

/// Only the operand's space and number count: FB 100 and FW 100 begin the same field.
void OperandLineReader::CheckField(const Operand& operand, const ShapeInfo& shape, std::string_view call) {
  if (operand.space() == Space::kP) {
    diagnostics_.Report(operand.range, diag::ProstepPortAsField, ToText(operand), call);
    return;
  }
  const uint32_t end = operand.number + uint32_t{shape.field_bytes};
  const bool crosses = operand.space() == Space::kD && operand.number < kFirstKeptByte && end > kFirstKeptByte;
  if (crosses || end > BytesOf(operand.space())) {
    diagnostics_.Report(operand.range, diag::ProstepFieldRange, ToText(operand), shape.field_bytes);
  }
}

/// Index, width and direction of FM 41 to 54 against the manual's table.
void OperandLineReader::CheckVariable(const Instruction& instruction, Function function) {
  const FunctionInfo& info = Info(function);
  const Operand* index = nullptr;
  const ShapeInfo* field = nullptr;
  for (uint32_t i = 0; i < info.count; ++i) {
    const bool is_index = info.arguments[i] == ArgumentShape::kIndex;
    if (is_index && index == nullptr) index = &program_.Argument(instruction, i);
    if (!is_index) field = &Info(info.arguments[i]);
  }
  if (index == nullptr || field == nullptr || index->shape() != Shape::kConstant) return;
  const std::string call = ToText(program_, instruction);
  const std::string_view name = VariableName(index->value);
  const VariableUse use = field->access == Access::kWrite ? VariableUse::kRead : VariableUse::kWritten;
  if (name.empty()) {
    diagnostics_.Report(index->range, diag::ProstepVariableUnknown, index->value, call);
  } else if (!IsVariable(index->value, field->field_bytes, use)) {
    diagnostics_.Report(index->range, diag::ProstepVariableAccess, index->value, name, call);
  }
}

bool OperandLineReader::IsWrongOperand(const Statement& statement) {
  const Token& token = statement.tokens.front();
  if (now_.waiting.reported || now_.waiting.found >= now_.waiting.fewest || token.faulty || !statement.labels.empty())
    return false;
  const std::string_view text = TextOf(token);
  const std::string word =
      Upper(text.substr(0, static_cast<size_t>(std::ranges::find_if_not(text, IsLetter) - text.begin())));
  const bool timer_form = word == "KT" || word == "KZ" || word == "KC" || word == "KM" || word == "KY";
  const bool typed = text.find('#') != std::string_view::npos;
  const bool number = IsDigit(text.front()) || (text.front() == '-' && text.size() > 1 && IsDigit(text[1]));
  if (!number && !typed && !timer_form && ForeignOperandHint(word).empty()) return false;
  Instruction& instruction = Current();
  const OperandSet own = Info(instruction.op).own;
  std::string remedy = "a constant is K and its number: K 5, K 0FFH";
  if (!instruction.function && Info(instruction.op).lines == Lines::kOwnAndNext) {
    remedy = (own & kTimerSet) != 0
                 ? "a time is K, a scale digit and three digits: K 2030D is 30 times 100 ms (scale 0: 1 ms, 1: 10 ms, "
                   "2: 100 ms, 3: 1 s)"
                 : "a preset is K and up to three digits: K 30D";
  } else if (!number && !typed && !timer_form) {
    remedy = ForeignOperandHint(word);
  }
  instruction.faulty = true;
  diagnostics_.Report(instruction.range, diag::ProstepOperandLineForm, ToText(program_, instruction), text, remedy);
  now_.waiting.reported = true;
  now_.waiting.most = 255;  // what follows belongs to the fault
  return true;
}

void OperandLineReader::FinishWaiting() {
  const Waiting waiting = std::exchange(now_.waiting, {});
  if (waiting.found >= waiting.fewest) {
    for (const source::Range comment : waiting.operand_like) {
      diagnostics_.Report(comment, diag::ProstepCommentLikeInstruction, sources_.Text(comment));
    }
  }
  if (waiting.reported || waiting.most == 0) return;
  Instruction& instruction = program_.instructions[waiting.instruction];
  if (waiting.found < waiting.fewest) {
    const std::string text = ToText(program_, instruction);
    instruction.faulty = true;
    if (waiting.fewest == 1) {
      diagnostics_.Report(instruction.range, diag::ProstepOperandLineMissing, text);
    } else {
      diagnostics_.Report(instruction.range, diag::ProstepOperandLinesMissing, text, waiting.fewest, waiting.found);
    }
  } else if (waiting.found < waiting.most && !instruction.faulty) {
    diagnostics_.Report(instruction.range, diag::ProstepTwoOperands, ToText(program_, instruction));
    program_.arguments.push_back(program_.arguments.back());
    ++instruction.arguments.count;
  }
}

}  // namespace plcxx::prostep
