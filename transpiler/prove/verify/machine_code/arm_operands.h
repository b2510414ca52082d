// Operands, conditions and flags of ARM's instructions.
#pragma once

#include <llvm/BinaryFormat/ELF.h>

#include <cstdint>
#include <vector>

#include "transpiler/prove/verify/machine_code/lifter.h"

namespace plcxx::prove::verify::machine_code {

enum class ArmOperation : uint8_t {
  kAdd,
  kSub,
  kReverseSub,
  kAddCarry,
  kSubCarry,
  kAnd,
  kOr,
  kXor,
  kAndNot,
  kOrNot,
  kMove,     // the second operand
  kMoveNot,  // its complement
  kNegate
};

enum class ArmShift : uint8_t { kLeft, kRight, kRightSigned, kRotate };

inline constexpr unsigned kNegative = 0, kZero = 1, kCarry = 2, kOverflow = 3;  // flags
inline constexpr unsigned kStackPointer = 13, kCounter = 15;

/// A second operand, and what a shift of it leaves for the carry flag.
struct Shifted {
  llvm::Value* value = nullptr;
  llvm::Value* carry = nullptr;  // none: the flag stays
};

class ArmOperands {
 public:
  explicit ArmOperands(FunctionLifter& lifter);

  /// Whether it is executed under a condition (IT), or branches under one.
  bool is_conditional() const { return condition_ != kAlways; }
  llvm::Value* Condition();

 protected:
  static constexpr int64_t kAlways = 14;

  bool sets_flags() const { return sets_flags_; }
  unsigned operand_count() const { return static_cast<unsigned>(operands_.size()); }
  bool IsRegister(unsigned operand) const { return operands_[operand].isReg(); }
  unsigned RegisterAt(unsigned operand) const {
    return lifter_.program().machine().registers().getEncodingValue(operands_[operand].getReg());
  }
  int64_t NumberAt(unsigned operand) const { return operands_[operand].getImm(); }
  llvm::Value* Get(unsigned operand);
  /// A register, shifted by what follows it, or a number times `scale`.
  Shifted SecondOperand(unsigned operand, unsigned scale);
  /// Of an address: the same, but that what follows a register is a plain count.
  llvm::Value* Offset(unsigned operand, unsigned scale);
  Shifted ShiftBy(llvm::Value* value, ArmShift shift, unsigned count);
  Shifted ShiftBy(llvm::Value* value, ArmShift shift, llvm::Value* count);
  llvm::Value* Combine(ArmOperation operation, llvm::Value* a, const Shifted& b, bool sets_flags);
  void SetSignAndZero(llvm::Value* result);

  FunctionLifter& lifter_;
  Builder& build_;

 private:
  llvm::Value* AddWithCarry(llvm::Value* a, llvm::Value* b, llvm::Value* carry, bool sets_flags);

  std::vector<llvm::MCOperand> operands_;  // without condition and flags
  int64_t condition_ = kAlways;
  bool sets_flags_ = false;
};

}  // namespace plcxx::prove::verify::machine_code
