#include "transpiler/dialects/technol/parser/instruction_reader.h"

#include "transpiler/dialects/technol/parser/expressions.h"
#include "transpiler/dialects/technol/parser/pending.h"

namespace plcxx::technol {

/// A comma outside of brackets.
bool InstructionReader::HasTwoOperands() const {
  uint32_t depth = 0;
  for (size_t i = 0; const Token* token = reader_.Peek(i); ++i) {
    if (token->kind != TokenKind::kPunctuation) continue;
    if (token->text == "(" || token->text == "[") ++depth;
    if (depth > 0 && (token->text == ")" || token->text == "]")) --depth;
    if (depth == 0 && token->text == ",") return true;
  }
  return false;
}

void InstructionReader::ReadInstruction() {
  if (instruction_.op == Op::kUnknown) return;
  // One operand or two tells TECHNOL's AND from the assembler's.
  if (AssemblerForm(instruction_.op) != instruction_.op && HasTwoOperands()) {
    instruction_.op = AssemblerForm(instruction_.op);
  }
  if (context_.settings.evidence == EvidenceRule::kStrict && Info(instruction_.op).evidence == Evidence::kCompletion) {
    context_.Report(instruction_.mnemonic, diag::TechnolCompletion, mnemonic_);
  }
  instruction_.operands.first = static_cast<uint32_t>(context_.program.operands.size());
  ReadForm(Info(instruction_.op).form);
  if (!context_.faulty) CheckEnd();
  instruction_.operands.count = static_cast<uint32_t>(context_.program.operands.size()) - instruction_.operands.first;
  instruction_.faulty |= context_.faulty;
}

void InstructionReader::ReadForm(Form form) {
  switch (form) {
    case Form::kNone:
      if (instruction_.op == Op::kRet) targets_.CheckReturn();
      return;
    case Form::kBit:
      return bits_.ReadBit(Access::kRead);
    case Form::kWriteBit:
      return bits_.ReadBit(Access::kWrite);
    case Form::kFlag:
      return bits_.ReadFlag();
    case Form::kJump:
      return targets_.ReadJump();
    case Form::kCall:
      return targets_.ReadCall();
    case Form::kWaitLimit:
      timers_.ReadCell();
      if (!context_.faulty) timers_.ReadTime();
      if (!context_.faulty && ExpectComma()) targets_.ReadJump();
      return;
    case Form::kDelay:
      timers_.ReadCell();
      if (!context_.faulty) timers_.ReadTime();
      return;
    case Form::kMechanism:
      return targets_.ReadMechanism();
    case Form::kData:
    case Form::kNarrowData:
    case Form::kWideData:
      return data_.ReadData(form);
    case Form::kStore:
      return data_.ReadStore();
    case Form::kRotation:
      return data_.ReadRotation();
    case Form::kError:
      return ReadError();
    case Form::kTwo:
      return assembler_.ReadTwo();
    case Form::kOne:
    case Form::kMultiply:
      return assembler_.ReadOne();
    case Form::kShift:
      return assembler_.ReadShift();
    case Form::kExchange:
      return assembler_.ReadExchange();
    case Form::kExtend:
      return assembler_.ReadExtend();
    case Form::kStack:
      return assembler_.ReadStack();
  }
}

void InstructionReader::CheckEnd() {
  if (reader_.AtEnd()) return;
  const std::string mnemonic(mnemonic_);
  if (reader_.IsPunctuation('.') && Info(instruction_.op).form == Form::kError) {
    context_.Report(reader_.Here(), diag::TechnolSurplusHint, Shown(reader_.Peek()), mnemonic,
                    "a comma is between the number and the sub-number: " + mnemonic + " 10,1");
  } else if (reader_.IsPunctuation(':')) {
    context_.Report(reader_.Here(), diag::TechnolSurplusHint, Shown(reader_.Peek()), mnemonic,
                    "a label has its colon where it is defined, not where it is named");
  } else if (reader_.IsPunctuation('(')) {
    context_.Report(reader_.Here(), diag::TechnolSurplusHint, Shown(reader_.Peek()), mnemonic,
                    "an index register stands in brackets: [BX]");
  } else if (reader_.IsPunctuation('.')) {
    context_.Report(reader_.Here(), diag::TechnolSurplusHint, Shown(reader_.Peek()), mnemonic,
                    "a bit has a name of its own in its DFM, no number; BYTE. and CNST. stand in front of a name");
  } else if (reader_.IsPunctuation(',')) {
    context_.Report(reader_.Here(), diag::TechnolSurplusHint, Shown(reader_.Peek()), mnemonic,
                    "'" + mnemonic + "' takes no further operand");
  } else if (reader_.IsWord("AND") || reader_.IsWord("OR") || reader_.IsWord("XOR")) {
    context_.Report(reader_.Here(), diag::TechnolSurplusHint, Shown(reader_.Peek()), mnemonic,
                    "bits are combined line by line: LA, LO");
  } else {
    context_.Report(reader_.Here(), diag::TechnolSurplus, Shown(reader_.Peek()), mnemonic);
  }
}

void InstructionReader::ReadError() {
  if (!ExpectOperand("an error number")) return;
  constexpr int64_t kMost = 99;
  for (int64_t least = 1; least >= 0; --least) {
    const size_t first = reader_.position();
    const std::optional<int64_t> value = ReadConstant(reader_, context_);
    if (!value) return;
    if (*value < least || *value > kMost) {
      context_.Report(reader_.RangeFrom(first), diag::TechnolEsetRange, *value, least, kMost);
      return;
    }
    Add({.kind = OperandKind::kConstant, .width = 8, .value = *value}, first);
    if (least == 0 || !reader_.TakePunctuation(',')) return;
  }
}

void ReadOperands(const std::vector<Pending>& pending, const std::vector<Token>& tokens, ParsingContext& context) {
  context.program.operands.reserve(pending.size());
  for (uint32_t i = 0; i < pending.size(); ++i) {
    Instruction& instruction = context.program.instructions[InstructionId(i)];
    context.BeginStatement(pending[i].statement, instruction.expansion);
    if (pending[i].mnemonic.count == 0) continue;
    const std::span<const Token> operands(tokens.data() + pending[i].tokens.first, pending[i].tokens.count);
    const std::string_view mnemonic = tokens[pending[i].mnemonic.first].text;
    if (instruction.faulty) context.Forgive();
    OperandReading reading{context, instruction, mnemonic, TokenReader(operands)};
    InstructionReader(reading).ReadInstruction();
  }
}

}  // namespace plcxx::technol
