#include "transpiler/dialects/prostep/lowering/instruction_set.h"

#include "transpiler/dialects/common/logic_stack.h"
#include "transpiler/dialects/prostep/lowering/bits.h"
#include "transpiler/dialects/prostep/lowering/control.h"
#include "transpiler/dialects/prostep/lowering/functions.h"
#include "transpiler/dialects/prostep/lowering/logic.h"
#include "transpiler/dialects/prostep/lowering/operands.h"
#include "transpiler/dialects/prostep/lowering/registers.h"
#include "transpiler/dialects/prostep/lowering/timing.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

void InstructionSet::Lower(InstructionId id) {
  using dialects::Join;
  const Instruction& instruction = tree_.instructions[id];
  dialects::Register& ax = registers_.ax();
  switch (instruction.op) {
    case Op::kAnd:
      return logic_.Operate(Join::kAnd, bits_.Read(instruction.operand));
    case Op::kAndNot:
      return logic_.Operate(Join::kAnd, dialects::Inverted(builder_, bits_.Read(instruction.operand)));
    case Op::kOr:
      return logic_.Operate(Join::kOr, bits_.Read(instruction.operand));
    case Op::kOrNot:
      return logic_.Operate(Join::kOr, dialects::Inverted(builder_, bits_.Read(instruction.operand)));
    case Op::kOrString:
      return logic_.BeginString();
    case Op::kOpenAnd:
      return logic_.Open(Join::kAnd);
    case Op::kOpenOr:
      return logic_.Open(Join::kOr);
    case Op::kClose:
      return logic_.Close();
    case Op::kAssign:
      return bits_.Assign(instruction.operand);
    case Op::kSet:
      return bits_.Set(instruction.operand);
    case Op::kReset:
      return bits_.Reset(instruction.operand);
    case Op::kCountUp:
      return timing_.Count(instruction, OpKind::kCountUp);
    case Op::kCountDown:
      return timing_.Count(instruction, OpKind::kCountDown);
    case Op::kSetCounter:
      return timing_.SetCounter(instruction);
    case Op::kResetCounter:
      return timing_.ResetCounter(instruction);
    case Op::kPulse:
      return timing_.StartTimer(instruction, OpKind::kStartPulse);
    case Op::kExtendedPulse:
      return timing_.StartTimer(instruction, OpKind::kStartExtended);
    case Op::kOnDelay:
      return timing_.StartTimer(instruction, OpKind::kStartOnDelay);
    case Op::kLatchedOnDelay:
      return timing_.StartTimer(instruction, OpKind::kStartLatchedDelay);
    case Op::kOffDelay:
      return timing_.StartTimer(instruction, OpKind::kStartOffDelay);
    case Op::kResetTimer:
      return timing_.ResetTimer(instruction);
    case Op::kEqual:
      return Compare(instruction, OpKind::kEqual8, OpKind::kEqual16);
    case Op::kNotEqual:
      return Compare(instruction, OpKind::kNotEqual8, OpKind::kNotEqual16);
    case Op::kLess:
      return Compare(instruction, OpKind::kSignedLess8, OpKind::kSignedLess16);
    case Op::kLessEqual:
      return Compare(instruction, OpKind::kSignedLessEqual8, OpKind::kSignedLessEqual16);
    case Op::kGreater:
      return Compare(instruction, OpKind::kSignedGreater8, OpKind::kSignedGreater16);
    case Op::kGreaterEqual:
      return Compare(instruction, OpKind::kSignedGreaterEqual8, OpKind::kSignedGreaterEqual16);
    case Op::kLoad:
      return Load(instruction);
    case Op::kLoadCounter:
      return ax.Set(timing_.CounterValue(instruction));
    case Op::kLoadCounterBcd:
      return ax.Set(Pure(OpKind::kToBcd16, {timing_.CounterValue(instruction)}));
    case Op::kLoadTimer:
      return ax.Set(timing_.TimeLeft(instruction, OpKind::kTimeLeft));
    case Op::kLoadTimerBcd:
      return ax.Set(timing_.TimeLeft(instruction, OpKind::kTimeLeftCoded));
    case Op::kTransfer:
      return Transfer(instruction.operand);
    case Op::kJump:
      return control_.Jump(id);
    case Op::kJumpIf:
      return control_.JumpIf(id);
    case Op::kCall:
      return control_.Call(instruction);
    case Op::kCallIf:
      return control_.CallIf(instruction);
    case Op::kPerform:
      return functions_.Perform(instruction);
    case Op::kPerformIf:
      return functions_.PerformIf(instruction);
    case Op::kEndModule:
      return control_.EndModule(id);
    case Op::kEndModuleIf:
      return control_.EndModuleIf(id);
    case Op::kNop:
    case Op::kUnknown:
      return;
  }
}

void InstructionSet::Load(const Instruction& instruction) {
  const ValueId value = operands_.Read(instruction.operand);
  builder_.SetRange(instruction.whole);
  if (instruction.operand.shape() == Shape::kByte) return registers_.SetLowByte(value);
  registers_.ax().Set(value);
}

void InstructionSet::Transfer(const Operand& target) {
  operands_.Write(target, target.shape() == Shape::kByte ? registers_.LowByte() : registers_.ax().Get());
}

void InstructionSet::Compare(const Instruction& instruction, OpKind bytes, OpKind words) {
  const bool byte = instruction.operand.shape() == Shape::kByte;
  const ValueId left = byte ? registers_.LowByte() : registers_.ax().Get();
  const ValueId right = operands_.Read(instruction.operand);
  builder_.SetRange(instruction.whole);
  logic_.Compare(Pure(byte ? bytes : words, {left, right}));
}

}  // namespace plcxx::prostep
