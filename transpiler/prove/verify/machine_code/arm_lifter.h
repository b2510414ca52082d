// One instruction of ARM's Thumb: what arm.cc and arm_memory.cc share.
#pragma once

#include <llvm/IR/Intrinsics.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "transpiler/prove/verify/machine_code/arm_operands.h"

namespace plcxx::prove::verify::machine_code {

enum class ArmForm : uint8_t {
  kCompute,
  kMoveTo,
  kCompare,
  kShift,
  kLoad,
  kStore,
  kLoadPre,
  kLoadPost,
  kStorePre,
  kStorePost,
  kLoadPair,
  kLoadPairPre,
  kLoadPairPost,
  kStorePair,
  kStorePairPre,
  kStorePairPost,
  kPush,
  kPop,
  kStoreDown,
  kLoadUp,
  kStoreUp,
  kStoreFrom,
  kLoadFrom,
  kLoadUpNarrow,
  kLoadConstant,
  kMoveTop,
  kBits,
  kInsert,
  kClear,
  kExtend,
  kAddExtended,
  kLeadingZeros,
  kReverse,
  kMul,
  kMulAdd,
  kMulSub,
  kMulLong,
  kMulHalves,
  kDiv,
  kDivSigned,
  kJump,
  kBranch,
  kBranchZero,
  kBranchNotZero,
  kCall,
  kReturn,
  kHint,
  kNothing
};

struct ArmRow {
  std::string_view name;
  ArmForm form{};
  ArmOperation operation{};
  ArmShift shift{};
  unsigned bits = 32;
  bool has_sign = false;
  unsigned scale = 1;
};

class ArmLifter : public ArmOperands {
 public:
  ArmLifter(FunctionLifter& lifter, const ArmRow& row) : ArmOperands(lifter), row_(row) {}

  void Run();

 private:
  void Compute();
  void Move();
  void Shift();
  /// Of one number in memory: ARMv6-M takes no others, ARMv7-M takes any.
  unsigned LeastAlign();
  void Access();
  void AccessPair();
  void AccessMany();
  void RefuseBelowStack(unsigned base, unsigned offset);
  void LoadConstant();
  void Insert(llvm::Value* bits);
  void TakeBits();
  /// The register's lowest bits as a word, by the row's sign.
  llvm::Value* Extended(unsigned operand);
  static std::optional<Place> PlaceOf(const Link& link, int64_t addend);
  void MoveTopOf(const Link& link);
  void MultiplyLong();
  void MultiplyHalves();
  void MoveTop();
  void Apply(llvm::Intrinsic::ID id, std::vector<llvm::Value*> more);
  llvm::Value* Widened(llvm::Value* value, llvm::Type* type);
  /// Where the note leads to, from its first instruction on; none: it is refused.
  const Link* Callee(const Link* link);
  void Jump();
  void Branch(llvm::Value* condition);
  void SetRegister(unsigned number, llvm::Value* value);

  const ArmRow& row_;
};

}  // namespace plcxx::prove::verify::machine_code
