#include "transpiler/dialects/technol/lowering/bits.h"

#include <optional>

#include "transpiler/dialects/technol/lowering/mechanisms.h"
#include "transpiler/dialects/technol/lowering/operands.h"

namespace plcxx::technol {

using ir::ValueId;

ValueId Bits::Read(const Operand& operand) {
  const ValueId value = builder_.Load(operands_.PlaceOf(operand));
  return operand.negated ? builder_.Not(value) : value;
}

/// With mech-clear=abort a cleared mechanism is as after MECH_INIT, and one that clears itself is left.
void Bits::Write(const Operand& operand, ValueId value) {
  builder_.Store(operands_.PlaceOf(operand), value);
  if (!operand.is_activation_bit() || settings_.mech_clear != MechClear::kAbort) return;
  const auto stop = [&] { mechanisms_.Stop(operand.mechanism); };
  const std::optional<uint64_t> known = builder_.KnownValue(value);
  if (known) {
    if (*known == 0) builder_.When(builder_.Bit(1), stop);
    return;
  }
  builder_.When(builder_.Not(value), stop);
}

void Bits::Load(const Instruction& instruction) { registers_.rlo().Set(Read(OperandOf(instruction, 0))); }

void Bits::Combine(const Instruction& instruction, dialects::Join join) {
  const ValueId operand = Read(OperandOf(instruction, 0));
  registers_.rlo().Set(dialects::Joined(builder_, join, registers_.rlo().Get(), operand));
}

void Bits::WriteRlo(const Instruction& instruction) { Write(OperandOf(instruction, 0), registers_.rlo().Get()); }

void Bits::SetFlag(const Instruction& instruction) {
  const auto value = static_cast<uint64_t>(OperandOf(instruction, 0).value);
  Write(OperandOf(instruction, 1), builder_.Bit(value));
}

void Bits::SetFlagIfRlo(const Instruction& instruction, uint64_t rlo) {
  const ValueId value = registers_.rlo().Get();
  builder_.When(rlo == 1 ? value : builder_.Not(value), [&] { SetFlag(instruction); });
}

}  // namespace plcxx::technol
