#include "transpiler/prove/verify/llvm_ir/arithmetic.h"

#include <string>

#include "transpiler/symbolic/terms/floats.h"
#include "transpiler/symbolic/terms/sign_extended.h"

namespace plcxx::prove::verify::llvm_ir {

terms::TermId Arithmetic::WithoutSign(terms::TermId divisor) {
  const terms::TermId narrow = terms::SignExtended(terms_, divisor);
  if (terms_.IsConst(divisor) || !narrow.valid()) return divisor;
  const terms::TermId is_negative = terms_.Extract(narrow, static_cast<uint8_t>(terms_.Width(narrow) - 1), 1);
  if (!environment_.NeverHolds(terms_.And(context_, is_negative))) return divisor;
  return terms_.Zext(narrow, terms_.Width(divisor));
}

terms::TermId Arithmetic::Divide(const llvm::BinaryOperator& inst, terms::TermId a, terms::TermId b) {
  const uint8_t width = terms_.Width(a);
  Require(terms_.Eq(b, terms_.Const(0, width)), "a division by zero");
  poison_.RequireValue(values_.ValueOf(inst.getOperand(1)), "a division by a number that C++ leaves undefined");
  const bool has_sign = inst.getOpcode() == llvm::Instruction::SDiv || inst.getOpcode() == llvm::Instruction::SRem;
  // 8086 and control stop at it for an int only.
  const bool wraps = run_.language == CodeRun::Language::kSource && width > 16;
  if (has_sign && !wraps) {
    const terms::TermId least = terms_.Eq(a, terms_.Const(uint64_t{1} << (width - 1), width));
    const terms::TermId minus_one = terms_.Eq(b, terms_.Const(terms::Masked(~uint64_t{0}, width), width));
    Require(terms_.And(least, minus_one), "a division that overflows");
  }
  switch (inst.getOpcode()) {
    case llvm::Instruction::UDiv:
      return terms_.Udiv(a, b);
    case llvm::Instruction::URem:
      return terms_.Urem(a, b);
    case llvm::Instruction::SDiv:
      return terms_.Sdiv(a, WithoutSign(b));
    default:
      return terms_.Srem(a, WithoutSign(b));
  }
}

terms::TermId Arithmetic::Operate(const llvm::BinaryOperator& inst) {
  const terms::TermId a = values_.TermOf(inst.getOperand(0)), b = values_.TermOf(inst.getOperand(1));
  const uint8_t width = terms_.Width(a);
  switch (inst.getOpcode()) {
    case llvm::Instruction::Add:
      return terms_.Add(a, b);
    case llvm::Instruction::Sub:
      return terms_.Sub(a, b);
    case llvm::Instruction::Mul:
      return terms_.Mul(a, b);
    case llvm::Instruction::UDiv:
    case llvm::Instruction::SDiv:
    case llvm::Instruction::URem:
    case llvm::Instruction::SRem:
      return Divide(inst, a, b);
    case llvm::Instruction::And:
      return terms_.And(a, b);
    case llvm::Instruction::Or:
      return terms_.Or(a, b);
    case llvm::Instruction::Xor:
      return terms_.Xor(a, b);
    case llvm::Instruction::Shl:
      return terms_.Shl(a, b);
    case llvm::Instruction::LShr:
      return terms_.Lshr(a, b);
    case llvm::Instruction::AShr:
      return terms_.Ashr(a, b);
    case llvm::Instruction::FAdd:
      return terms::FloatAdd(terms_, a, b);
    case llvm::Instruction::FSub:
      return terms::FloatSub(terms_, a, b);
    case llvm::Instruction::FMul:
      return terms::FloatMul(terms_, a, b);
    case llvm::Instruction::FDiv:
      return terms::FloatDiv(terms_, a, b);
    default:
      Refuse(std::string("instruction '") + inst.getOpcodeName() + "'");
      return Undefined(width);
  }
}

terms::TermId Arithmetic::ComparePointers(const llvm::ICmpInst& inst) {
  const CodeValue a = values_.ValueOf(inst.getOperand(0)), b = values_.ValueOf(inst.getOperand(1));
  if (!inst.isEquality()) {
    Refuse("instruction 'icmp' of pointers by their order");
    return terms_.Bit(false);
  }
  terms::TermId equal = terms_.Bit(false);
  for (const Target& one : a.targets) {
    for (const Target& other : b.targets) {
      if (one.object != other.object) {
        RequireTold(one, other);
        continue;
      }
      equal = terms_.Or(equal, terms_.And(terms_.And(one.when, other.when), terms_.Eq(one.offset, other.offset)));
    }
  }
  return inst.getPredicate() == llvm::CmpInst::ICMP_EQ ? equal : terms_.Not(equal);
}

/// Addresses in two objects are not equal; one behind an object may be another one's.
void Arithmetic::RequireTold(const Target& one, const Target& other) {
  if (run_.language != CodeRun::Language::kCpp) return;
  const auto is_inside = [this](const Target& target) {
    const Object& object = objects_[target.object];
    if (object.kind == ObjectKind::kNull) return terms_.Eq(target.offset, terms_.Const(0, 64));
    const uint64_t bytes = object.kind == ObjectKind::kHost ? 1 : object.bytes;  // nobody knows how many the host has
    return terms_.Ult(target.offset, terms_.Const(bytes, 64));
  };
  const terms::TermId both = terms_.And(one.when, other.when);
  Require(terms_.And(both, terms_.Not(terms_.And(is_inside(one), is_inside(other)))),
          "a comparison of an address that is behind its object");
}

terms::TermId Arithmetic::Compare(const llvm::ICmpInst& inst) {
  if (inst.getOperand(0)->getType()->isPointerTy()) return ComparePointers(inst);
  const terms::TermId a = values_.TermOf(inst.getOperand(0)), b = values_.TermOf(inst.getOperand(1));
  switch (inst.getPredicate()) {
    case llvm::CmpInst::ICMP_EQ:
      return terms_.Eq(a, b);
    case llvm::CmpInst::ICMP_NE:
      return terms_.Ne(a, b);
    case llvm::CmpInst::ICMP_UGT:
      return terms_.Ult(b, a);
    case llvm::CmpInst::ICMP_UGE:
      return terms_.Ule(b, a);
    case llvm::CmpInst::ICMP_ULT:
      return terms_.Ult(a, b);
    case llvm::CmpInst::ICMP_ULE:
      return terms_.Ule(a, b);
    case llvm::CmpInst::ICMP_SGT:
      return terms_.Slt(b, a);
    case llvm::CmpInst::ICMP_SGE:
      return terms_.Sle(b, a);
    case llvm::CmpInst::ICMP_SLT:
      return terms_.Slt(a, b);
    case llvm::CmpInst::ICMP_SLE:
      return terms_.Sle(a, b);
    default:
      Refuse("instruction 'icmp' with an unknown predicate");
      return terms_.Bit(false);
  }
}

terms::TermId Arithmetic::CompareFloats(const llvm::FCmpInst& inst) {
  const terms::TermId a = values_.TermOf(inst.getOperand(0)), b = values_.TermOf(inst.getOperand(1));
  const auto unordered = [&] { return terms_.Or(terms::FloatIsNan(terms_, a), terms::FloatIsNan(terms_, b)); };
  switch (inst.getPredicate()) {
    case llvm::CmpInst::FCMP_FALSE:
      return terms_.Bit(false);
    case llvm::CmpInst::FCMP_OEQ:
      return terms::FloatEqual(terms_, a, b);
    case llvm::CmpInst::FCMP_OGT:
      return terms::FloatLess(terms_, b, a);
    case llvm::CmpInst::FCMP_OGE:
      return terms::FloatLessEqual(terms_, b, a);
    case llvm::CmpInst::FCMP_OLT:
      return terms::FloatLess(terms_, a, b);
    case llvm::CmpInst::FCMP_OLE:
      return terms::FloatLessEqual(terms_, a, b);
    case llvm::CmpInst::FCMP_ONE:
      return terms_.And(terms_.Not(terms::FloatEqual(terms_, a, b)), terms_.Not(unordered()));
    case llvm::CmpInst::FCMP_ORD:
      return terms_.Not(unordered());
    case llvm::CmpInst::FCMP_UNO:
      return unordered();
    case llvm::CmpInst::FCMP_UEQ:
      return terms_.Or(terms::FloatEqual(terms_, a, b), unordered());
    case llvm::CmpInst::FCMP_UGT:
      return terms_.Not(terms::FloatLessEqual(terms_, a, b));
    case llvm::CmpInst::FCMP_UGE:
      return terms_.Not(terms::FloatLess(terms_, a, b));
    case llvm::CmpInst::FCMP_ULT:
      return terms_.Not(terms::FloatLessEqual(terms_, b, a));
    case llvm::CmpInst::FCMP_ULE:
      return terms_.Not(terms::FloatLess(terms_, b, a));
    case llvm::CmpInst::FCMP_UNE:
      return terms_.Not(terms::FloatEqual(terms_, a, b));
    case llvm::CmpInst::FCMP_TRUE:
      return terms_.Bit(true);
    default:
      Refuse("instruction 'fcmp' with an unknown predicate");
      return terms_.Bit(false);
  }
}

terms::TermId Arithmetic::Convert(const llvm::CastInst& inst) {
  const uint8_t width = WidthOf(*inst.getType());
  const terms::TermId a = values_.TermOf(inst.getOperand(0));
  switch (inst.getOpcode()) {
    case llvm::Instruction::Trunc:
      return terms_.Extract(a, 0, width);
    case llvm::Instruction::ZExt:
      return terms_.Zext(a, width);
    case llvm::Instruction::SExt:
      return terms_.Sext(a, width);
    case llvm::Instruction::BitCast:
      return a;
    case llvm::Instruction::SIToFP:
      return terms::FloatFromSigned(terms_, a, width);
    case llvm::Instruction::UIToFP:
      return terms::FloatFromUnsigned(terms_, a, width);
    case llvm::Instruction::FPToSI:
      return terms::FloatToSigned(terms_, a, width);
    case llvm::Instruction::FPToUI:
      return terms::FloatToUnsigned(terms_, a, width);
    case llvm::Instruction::FPExt:
      return terms::FloatWiden(terms_, a);
    case llvm::Instruction::FPTrunc:
      return terms::FloatNarrow(terms_, a);
    default:
      Refuse(std::string("instruction '") + inst.getOpcodeName() + "'");
      return Undefined(width);
  }
}

}  // namespace plcxx::prove::verify::llvm_ir
