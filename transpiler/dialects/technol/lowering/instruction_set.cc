#include "transpiler/dialects/technol/lowering/instruction_set.h"

#include "transpiler/dialects/technol/lowering/assembler.h"
#include "transpiler/dialects/technol/lowering/bits.h"
#include "transpiler/dialects/technol/lowering/cell_places.h"
#include "transpiler/dialects/technol/lowering/data.h"
#include "transpiler/dialects/technol/lowering/jumps.h"
#include "transpiler/dialects/technol/lowering/mechanisms.h"
#include "transpiler/dialects/technol/lowering/subprograms.h"
#include "transpiler/dialects/technol/lowering/waits.h"
#include "transpiler/support/check.h"

namespace plcxx::technol {

using ir::OpKind;

void InstructionSet::Lower(const Instruction& instruction) {
  if (Info(instruction.op).assembler) return assembler_.Lower(instruction);
  LowerOwn(instruction);
}

/// TECHNOL's own, and marks.
void InstructionSet::LowerOwn(const Instruction& instruction) {
  using dialects::Join;
  switch (instruction.op) {
    case Op::kLdr:
      return bits_.Load(instruction);
    case Op::kLa:
      return bits_.Combine(instruction, Join::kAnd);
    case Op::kLo:
      return bits_.Combine(instruction, Join::kOr);
    case Op::kLx:
      return bits_.Combine(instruction, Join::kXor);
    case Op::kWr:
      return bits_.WriteRlo(instruction);
    case Op::kFl:
      return bits_.SetFlag(instruction);
    case Op::kFl1:
      return bits_.SetFlagIfRlo(instruction, 1);
    case Op::kFl0:
      return bits_.SetFlagIfRlo(instruction, 0);
    case Op::kJum:
      return jumps_.Always(instruction);
    case Op::kJl1:
      return jumps_.IfRlo(instruction, 1);
    case Op::kJl0:
      return jumps_.IfRlo(instruction, 0);
    case Op::kCall:
      return subprograms_.Call(instruction);
    case Op::kRet:
      return subprograms_.Return();
    case Op::kEx:
      return waits_.OnePass();
    case Op::kEx0:
      return waits_.UntilRlo(1);
    case Op::kEx1:
      return waits_.UntilRlo(0);
    case Op::kTex0:
      return waits_.UntilRloAtMost(instruction, 1);
    case Op::kTex1:
      return waits_.UntilRloAtMost(instruction, 0);
    case Op::kTim:
      return waits_.Delay(instruction);
    case Op::kMechInit:
      return mechanisms_.Init(instruction);
    case Op::kLod:
      return data_.Load(instruction);
    case Op::kSto:
      return data_.Store(instruction);
    case Op::kAd:
      return data_.Combine(instruction, {OpKind::kAdd8, OpKind::kAdd16, OpKind::kAdd32});
    case Op::kSu:
      return data_.Combine(instruction, {OpKind::kSub8, OpKind::kSub16, OpKind::kSub32});
    case Op::kAnd:
      return data_.Combine(instruction, {OpKind::kAnd8, OpKind::kAnd16, OpKind::kAnd32});
    case Op::kOr:
      return data_.Combine(instruction, {OpKind::kOr8, OpKind::kOr16, OpKind::kOr32});
    case Op::kXor:
      return data_.Combine(instruction, {OpKind::kXor8, OpKind::kXor16, OpKind::kXor32});
    case Op::kMulb:
      return data_.Multiply(instruction, 8);
    case Op::kMulw:
      return data_.Multiply(instruction, 16);
    case Op::kDivb:
      return data_.Divide(instruction, 16);
    case Op::kDivw:
      return data_.Divide(instruction, 32);
    case Op::kRl:
      return data_.Rotate(instruction, Turn::kLeft);
    case Op::kRr:
      return data_.Rotate(instruction, Turn::kRight);
    case Op::kBcd:
      return data_.ToBcd();
    case Op::kBin:
      return data_.FromBcd();
    case Op::kEq:
      return data_.Compare(instruction, OpKind::kEqual32);
    case Op::kNe:
      return data_.Compare(instruction, OpKind::kNotEqual32);
    case Op::kLt:
      return data_.Compare(instruction, OpKind::kLess32);
    case Op::kLe:
      return data_.Compare(instruction, OpKind::kLessEqual32);
    case Op::kGt:
      return data_.Compare(instruction, OpKind::kGreater32);
    case Op::kGe:
      return data_.Compare(instruction, OpKind::kGreaterEqual32);
    case Op::kEset:
      return RaiseError(instruction);
    case Op::kMechanismBegin:
      mechanisms_.Enter(*routines_.OfUnit(instruction.mechanism));
      return registers_.Zero();
    case Op::kMechanismEnd:
      return mechanisms_.End(frame_.routine->unit);
    case Op::kModuleEnd:
      if (Info(tree_.units[frame_.routine->unit].module).waits) mechanisms_.End(frame_.routine->unit);
      return;
      // The marks of an area's end are after a RET.
#define TECHNOL_INSTRUCTION(...)
#define TECHNOL_ASSEMBLER(Key, ...) case Op::k##Key:
#include "transpiler/dialects/technol/machine/machine.def"
    case Op::kAreaEnd:
    case Op::kUnknown:
      PLCXX_UNREACHABLE();
  }
}

/// The numbers go to the cells that the control shows, and to the host.
void InstructionSet::RaiseError(const Instruction& instruction) {
  const auto number = [&](uint32_t index) {
    if (index >= instruction.operands.count) return uint64_t{0};
    return static_cast<uint64_t>(OperandOf(instruction, index).value);
  };
  const auto stored = [&](uint64_t value) {
    if (settings_.eset == EsetForm::kBinary) return builder_.Byte(value);
    return builder_.Constant(ir::Type::kI8, value / 10 * 16 + value % 10, 16);
  };
  const ir::ValueId main_number = stored(number(0));
  const ir::PlaceId main_cell = cells_.System("BZH11");
  builder_.Store(main_cell, main_number);
  const ir::ValueId sub_number = stored(number(1));
  const ir::PlaceId sub_cell = cells_.System("BZH22");
  builder_.Store(sub_cell, sub_number);
  host_(HostCall::kErrorRaised, {builder_.Byte(number(0)), builder_.Byte(number(1))});
}

}  // namespace plcxx::technol
