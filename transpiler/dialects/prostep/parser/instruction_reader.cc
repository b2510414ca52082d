#include "transpiler/dialects/prostep/parser/instruction_reader.h"

#include <algorithm>

namespace plcxx::prostep {
namespace {

/// More operand lines than any instruction takes.
constexpr uint32_t kAnyNumber = 255;

/// "A(" however it was spaced.
std::string MnemonicOf(std::string_view text) {
  std::string mnemonic = Upper(text);
  std::erase_if(mnemonic, IsBlank);
  return mnemonic;
}

const InstructionInfo* FirstMeaning(std::string_view mnemonic) {
  const auto meaning = std::ranges::find(Instructions(), mnemonic, &InstructionInfo::mnemonic);
  PLCXX_CHECK(meaning != Instructions().end());
  return &*meaning;
}

/// The meaning with an operand of this class on its own line; none when there is none.
const InstructionInfo* MeaningWith(std::string_view mnemonic, OperandClass operand_class) {
  for (const InstructionInfo& info : Instructions()) {
    if (info.mnemonic == mnemonic && Accepts(info.own, operand_class)) return &info;
  }
  for (const InstructionInfo& info : Instructions()) {
    if (info.mnemonic == mnemonic && info.lines == Lines::kOneOf && Accepts(info.next, operand_class)) return &info;
  }
  return nullptr;
}

const InstructionInfo* MeaningWithout(std::string_view mnemonic) {
  for (const InstructionInfo& info : Instructions()) {
    const bool alone = info.lines == Lines::kNone || info.lines == Lines::kOneOf;
    if (info.mnemonic == mnemonic && alone) return &info;
  }
  return nullptr;
}

bool MayHaveOperand(std::string_view mnemonic) {
  return std::ranges::any_of(Instructions(), [&](const InstructionInfo& info) {
    return info.mnemonic == mnemonic && info.lines != Lines::kNone;
  });
}

/// Operand lines that any meaning of a mnemonic could take.
uint32_t MostLines(std::string_view mnemonic) {
  uint32_t most = 0;
  for (const InstructionInfo& info : Instructions()) {
    if (info.mnemonic != mnemonic) continue;
    if ((info.own & kFunctions) != 0) most = kAnyNumber;
    if (info.lines == Lines::kOwnAndNext) most = std::max(most, 1u);
  }
  return most;
}

/// For a mnemonic without the blank behind it, and for a call without its jump.
std::string JoinedHint(std::string_view word) {
  if (word == "PM" || word == "FM") return "a module is called by JU, with a condition by JC: JU " + std::string(word);
  for (size_t length = word.empty() ? 0 : word.size() - 1; length > 0; --length) {
    const std::string_view mnemonic = word.substr(0, length), rest = word.substr(length);
    const bool jump = mnemonic == "JU" || mnemonic == "JC";
    if (!jump && (!MayHaveOperand(mnemonic) || ClassByName(rest) == OperandClass::kNone)) continue;
    return "a blank is behind the mnemonic: " + std::string(mnemonic) + " " + std::string(rest);
  }
  return {};
}

/// For a number that has neither a class nor K in front of it.
std::string BareNumberHint(std::string_view mnemonic, std::string_view number) {
  for (const InstructionInfo& info : Instructions()) {
    if (info.mnemonic == mnemonic && info.lines == Lines::kOneOf) {
      return "a constant is K and its number, on the next line: K " + std::string(number);
    }
  }
  return "write in front of it which memory is meant: I, O, F and the like";
}

}  // namespace

std::string Accepted(OperandSet set) {
  struct Name {
    OperandSet set;
    std::string_view text;
  };
  constexpr Name kNames[] = {{kBits, "a bit of I, O, F or P"},
                             {kBytes, "a byte (IB, OB, FB, PB, DB)"},
                             {kWords, "a word (IW, OW, FW, PW, DW)"},
                             {kConstants, "a constant (K)"},
                             {kCounterSet, "a counter (C)"},
                             {kTimerSet, "a timer (T)"},
                             {kLabels, "a label"},
                             {kModuleSet, "a module (PM)"},
                             {kFunctions, "a functional module (FM)"}};
  std::string text;
  for (const Name& name : kNames) {
    if ((set & name.set) != 0) text += (text.empty() ? "" : ", ") + std::string(name.text);
  }
  return text;
}

std::string Accepted(std::string_view mnemonic) {
  OperandSet set = kNothing;
  for (const InstructionInfo& info : Instructions()) {
    if (info.mnemonic == mnemonic) set |= info.own;
  }
  return set == kNothing ? "its operand on the next line" : Accepted(set);
}

void InstructionReader::TakeInstruction(const Statement& statement) {
  Instruction instruction{.range = statement.range,
                          .whole = statement.range,
                          .mnemonic = statement.tokens.front().range,
                          .comments = comments_.TakeComments()};
  comments_.AttachTrailing(instruction.comments, statement.comment);
  if (const Token* label = labels_.TheLabel(statement)) labels_.DefineLabel(*label);
  if (statement.tokens.front().kind == TokenKind::kUnknown) {
    UnknownInstruction(statement, instruction);
  } else {
    KnownInstruction(statement, instruction);
  }
  Attach(instruction);
}

void InstructionReader::UnknownInstruction(const Statement& statement, Instruction& instruction) {
  const Token& token = statement.tokens.front();
  instruction.faulty = true;
  now_.waiting = {.most = kAnyNumber, .reported = true};
  if (token.faulty) return;
  const std::string_view text = TextOf(token);
  const std::string mnemonic = MnemonicOf(text);
  now_.meant_end |= mnemonic == "BE";
  std::string hint(ForeignHint(mnemonic));
  if (hint.empty()) hint = JoinedHint(mnemonic);
  if (hint.empty()) {
    diagnostics_.Report(token.range, diag::ProstepUnknownInstruction, text);
  } else {
    diagnostics_.Report(token.range, diag::ProstepForeignInstruction, text, hint);
  }
}

void InstructionReader::KnownInstruction(const Statement& statement, Instruction& instruction) {
  const std::string mnemonic = MnemonicOf(TextOf(statement.tokens.front()));
  instruction.op = FirstMeaning(mnemonic)->op;
  const bool reported = std::ranges::any_of(statement.tokens, &Token::faulty);
  if (reported) {
    instruction.faulty = true;
  } else if (statement.tokens.size() == 1) {
    WithoutOperand(mnemonic, instruction);
  } else if (statement.tokens[1].kind == TokenKind::kTarget) {
    WithTarget(statement.tokens[1], mnemonic, instruction);
  } else {
    WithOperand(statement, mnemonic, instruction);
  }
  if (instruction.faulty && now_.waiting.most == 0) now_.waiting = {.most = MostLines(mnemonic), .reported = true};
  if (!instruction.faulty) WarnOfComment(statement, statement.tokens.size() == 1);
}

void InstructionReader::WithoutOperand(std::string_view mnemonic, Instruction& instruction) {
  const InstructionInfo* meaning = MeaningWithout(mnemonic);
  if (meaning == nullptr) {
    instruction.faulty = true;
    diagnostics_.Report(instruction.range, diag::ProstepOperandNone, mnemonic, Accepted(mnemonic));
    return;
  }
  instruction.op = meaning->op;
  if (meaning->lines == Lines::kOneOf) now_.waiting = {.fewest = 1, .most = 1};
}

void InstructionReader::WithTarget(const Token& target, std::string_view mnemonic, Instruction& instruction) {
  for (const InstructionInfo& info : Instructions()) {
    if (info.mnemonic == mnemonic && (info.own & kLabels) != 0) instruction.op = info.op;
  }
  if (!labels_.IsLabel(TextOf(target), target.range)) {
    instruction.faulty = true;
    return;
  }
  labels_.AddJump(
      {.instruction = InstructionId(program_.instructions.size()), .name = UpperOf(target), .range = target.range});
}

void InstructionReader::WithOperand(const Statement& statement, std::string_view mnemonic, Instruction& instruction) {
  const source::Range range = {statement.tokens[1].range.begin, statement.range.end};
  const OperandClass operand_class = operands_.ClassOf(statement.tokens, 1);
  const InstructionInfo* meaning =
      operand_class == OperandClass::kNone ? nullptr : MeaningWith(mnemonic, operand_class);
  if (meaning == nullptr) {
    instruction.faulty = true;
    const std::string text = operands_.OperandText(statement.tokens, 1);
    const std::string_view hint = ForeignOperandHint(UpperOf(statement.tokens[1]));
    if (operand_class == OperandClass::kNone && !hint.empty()) {
      diagnostics_.Report(range, diag::ProstepOperandForeign, text, hint);
    } else if (operand_class == OperandClass::kNone && IsDigit(text.front())) {
      diagnostics_.Report(range, diag::ProstepOperandForeign, text, BareNumberHint(mnemonic, text));
    } else if (operand_class == OperandClass::kNone) {
      diagnostics_.Report(range, diag::ProstepOperandUnknown, text, mnemonic, Accepted(mnemonic));
    } else if (ShapeOf(operand_class) == Shape::kDouble) {
      diagnostics_.Report(range, diag::ProstepOperandDouble, text);
    } else {
      diagnostics_.Report(range, diag::ProstepOperandNotAllowed, text, mnemonic, Accepted(mnemonic));
    }
    return;
  }
  instruction.op = meaning->op;
  instruction.operand = operands_.ReadOperand(statement.tokens, 1);
  if (meaning->lines == Lines::kOwnAndNext) now_.waiting = {.fewest = 1, .most = 1};
  if (!instruction.operand.exists() || !operands_.IsInRange(instruction.operand, meaning->access)) {
    instruction.faulty = true;
    return;
  }
  operands_.WarnOfBorder(instruction.operand);
  if (!Accepts(meaning->own, operand_class)) {
    diagnostics_.Report(range, diag::ProstepOperandOnLine, operands_.OperandText(statement.tokens, 1), mnemonic);
  }
  if (ShapeOf(operand_class) == Shape::kFunction) CallFunction(instruction);
}

void InstructionReader::CallFunction(Instruction& instruction) {
  instruction.function = FunctionByNumber(instruction.operand.number);
  if (!instruction.function) {
    instruction.faulty = true;
    diagnostics_.Report(instruction.operand.range, diag::ProstepFunctionUnknown, ToText(instruction.operand));
    return;
  }
  const FunctionInfo& info = Info(*instruction.function);
  now_.waiting = {.fewest = info.fewest, .most = info.count};
}

void InstructionReader::Attach(Instruction& instruction) {
  std::string text = instruction.faulty ? std::string(Info(instruction.op).mnemonic) : ToText(program_, instruction);
  if (const PendingJump* jump = labels_.JumpOfNextInstruction()) text += " " + jump->name;
  const bool is_unknown = instruction.op == Op::kUnknown;
  brackets_.Instruction(instruction.op, instruction.range,
                        is_unknown ? sources_.Text(instruction.mnemonic) : std::string_view(text));
  instruction.arguments.first = static_cast<uint32_t>(program_.arguments.size());
  now_.waiting.instruction = program_.instructions.Add(instruction);
}

void InstructionReader::WarnOfComment(const Statement& statement, bool without_operand) {
  if (!statement.has_comment()) return;
  const std::string_view text = TextOf(statement.comment);
  if (IsMarked(text)) return;
  const auto word_end = static_cast<size_t>(std::ranges::find_if_not(text, IsLetter) - text.begin());
  const std::string word = Upper(text.substr(0, word_end));
  const std::string mnemonic = MnemonicOf(TextOf(statement.tokens.front()));
  const bool may_have_one = without_operand && MayHaveOperand(mnemonic);
  if (may_have_one && word_end < text.size() && IsBlank(text[word_end]) && ClassByName(word) != OperandClass::kNone) {
    diagnostics_.Report(statement.comment.range, diag::ProstepCommentLikeOperand, text, mnemonic);
    return;
  }
  const bool instruction_like =
      !word.empty() && MostLines(word) == 0 && LooksLikeOperand(text.substr(word_end)) &&
      std::ranges::any_of(Instructions(), [&](const InstructionInfo& info) { return info.mnemonic == word; });
  if (text.starts_with(':') || LooksLikeOperand(text) || instruction_like) {
    if (now_.waiting.found < now_.waiting.fewest) return now_.waiting.operand_like.push_back(statement.comment.range);
    diagnostics_.Report(statement.comment.range, diag::ProstepCommentLikeInstruction, text);
  }
}

}  // namespace plcxx::prostep
