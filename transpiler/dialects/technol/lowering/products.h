// Inline assembler: products, quotients, decimal adjustment (specification 6.9).
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Faults;
class Flags;
class Operands;

class Products : Context {
 public:
  enum class Signedness : uint8_t { kUnsigned, kSigned };
  enum class Adjusted : uint8_t { kSum, kDifference };

  Products(const Context& context, Faults& faults, Operands& operands, Flags& flags)
      : Context(context), faults_(faults), operands_(operands), flags_(flags) {}

  /// AL, AX or EAX by the operand.
  void Multiply(const Instruction& instruction, Signedness signedness);
  /// AX, DX:AX or EDX:EAX by the operand. A quotient that does not fit, and a division by zero: all ones or 80...0h,
  /// the remainder is 0, and a fault.
  void Divide(const Instruction& instruction, Signedness signedness);
  /// DAA and DAS.
  void AdjustDecimal(Adjusted adjusted);
  /// AAM: AL becomes its decimal digits in AH and AL.
  void SplitDigits();
  /// AAD: the digits in AH and AL become AL.
  void JoinDigits();

 private:
  /// Both halves of a product.
  struct Pair {
    ir::ValueId low, high;
  };
  struct Quotient {
    ir::ValueId whole, remainder;
    ir::ValueId fits;  // in its register, and the divisor is not 0
  };
  Pair MultiplyWide(ir::ValueId right, Signedness signedness);
  Pair MultiplyNarrow(ir::ValueId right, uint32_t width, Signedness signedness);
  Quotient DivideWide(ir::ValueId divisor, Signedness signedness);
  Quotient DivideNarrow(ir::ValueId divisor, uint32_t width, Signedness signedness);

  Faults& faults_;
  Operands& operands_;
  Flags& flags_;
};

}  // namespace plcxx::technol
