#include "transpiler/prove/verify/llvm_ir/poison.h"

#include <llvm/IR/Metadata.h>
#include <llvm/IR/Operator.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "transpiler/support/low_bits.h"
#include "transpiler/symbolic/terms/floats.h"

namespace plcxx::prove::verify::llvm_ir {
namespace {

using support::LowBits;

bool IsSignedDivision(const llvm::BinaryOperator& inst) { return inst.getOpcode() == llvm::Instruction::SDiv; }

}  // namespace

terms::TermId Poison::SignOf(terms::TermId a) {
  return terms_.Extract(a, static_cast<uint8_t>(terms_.Width(a) - 1), 1);
}

terms::TermId Poison::OfOperands(const llvm::User& inst) {
  terms::TermId poison;
  for (const llvm::Use& operand : inst.operands()) {
    if (!llvm::isa<llvm::BasicBlock>(operand) && !llvm::isa<llvm::Function>(operand))
      poison = Either(poison, values_.ValueOf(operand).poison);
  }
  return poison;
}

/// a * b does not fit into `width` bits.
terms::TermId Poison::ProductOverflows(terms::TermId a, terms::TermId b, bool has_sign) {
  const uint8_t width = terms_.Width(a);
  if (2 * width <= 64) {
    const auto wide = static_cast<uint8_t>(2 * width);
    const auto widen = [&](terms::TermId term) { return has_sign ? terms_.Sext(term, wide) : terms_.Zext(term, wide); };
    const terms::TermId exact = terms_.Mul(widen(a), widen(b));
    return terms_.Ne(exact, widen(terms_.Extract(exact, 0, width)));
  }
  // One operand is a constant nearly always: then the other one has bounds.
  if (terms_.IsConst(a)) std::swap(a, b);
  if (terms_.IsConst(b)) {
    const uint64_t factor = terms_.Value(b);
    if (factor == 0) return {};
    if (!has_sign) return terms_.Ult(terms_.Const(LowBits(width) / factor, width), a);
    if (factor <= LowBits(width) >> 1) {
      const uint64_t greatest = (LowBits(width) >> 1) / factor;
      const uint64_t least =
          terms::Masked(~(greatest + ((LowBits(width) >> 1) % factor == factor - 1 ? 1 : 0)) + 1, width);
      return terms_.Or(terms_.Slt(terms_.Const(greatest, width), a), terms_.Slt(a, terms_.Const(least, width)));
    }
  }
  const terms::TermId zero = terms_.Const(0, width), product = terms_.Mul(a, b);
  const terms::TermId back = has_sign ? terms_.Sdiv(product, a) : terms_.Udiv(product, a);
  terms::TermId overflow = terms_.And(terms_.Ne(a, zero), terms_.Ne(back, b));
  if (has_sign) {
    const terms::TermId least = terms_.Const(uint64_t{1} << (width - 1), width);
    const terms::TermId minus_one = terms_.Const(LowBits(width), width);
    overflow = terms_.Or(overflow, terms_.And(terms_.Eq(a, minus_one), terms_.Eq(b, least)));
  }
  return overflow;
}

terms::TermId Poison::SumOverflows(terms::TermId a, terms::TermId b, terms::TermId sum, bool has_sign) {
  if (!has_sign) return terms_.Ult(sum, a);
  return terms_.And(terms_.Xor(SignOf(a), SignOf(sum)), terms_.Xor(SignOf(b), SignOf(sum)));
}

terms::TermId Poison::DifferenceOverflows(terms::TermId a, terms::TermId b, terms::TermId difference, bool has_sign) {
  if (!has_sign) return terms_.Ult(a, b);
  return terms_.And(terms_.Xor(SignOf(a), SignOf(b)), terms_.Xor(SignOf(a), SignOf(difference)));
}

terms::TermId Poison::OfBinary(const llvm::BinaryOperator& inst, terms::TermId result) {
  const terms::TermId a = values_.TermOf(inst.getOperand(0)), b = values_.TermOf(inst.getOperand(1));
  const uint8_t width = terms_.Width(a);
  terms::TermId poison;
  const auto add = [&](terms::TermId condition) { poison = Either(poison, OrNone(condition)); };
  const bool wraps = llvm::isa<llvm::OverflowingBinaryOperator>(inst);
  const bool no_unsigned = wraps && inst.hasNoUnsignedWrap(), no_signed = wraps && inst.hasNoSignedWrap();
  // Most flags are the optimizer's own, of numbers that are small: their ranges say so at once.
  const ValueRange low = ranges_.Of(a), high = ranges_.Of(b);
  const uint64_t greatest = no_signed ? LowBits(width) >> 1 : LowBits(width);
  switch (inst.getOpcode()) {
    case llvm::Instruction::Add:
      if (low.high <= greatest && high.high <= greatest - low.high) break;
      if (no_unsigned) add(SumOverflows(a, b, result, false));
      if (no_signed) add(SumOverflows(a, b, result, true));
      break;
    case llvm::Instruction::Sub:
      if (no_unsigned && low.low < high.high) add(DifferenceOverflows(a, b, result, false));
      if (no_signed && (low.high > greatest || high.high > greatest)) add(DifferenceOverflows(a, b, result, true));
      break;
    case llvm::Instruction::Mul:
      if (low.high == 0 || high.high <= greatest / low.high) break;
      if (no_unsigned) add(ProductOverflows(a, b, false));
      if (no_signed) add(ProductOverflows(a, b, true));
      break;
    case llvm::Instruction::Shl:
      if (no_unsigned) add(terms_.Ne(terms_.Lshr(result, b), a));
      if (no_signed) add(terms_.Ne(terms_.Ashr(result, b), a));
      [[fallthrough]];
    case llvm::Instruction::LShr:
    case llvm::Instruction::AShr:
      if (high.high >= width) add(terms_.Not(terms_.Ult(b, terms_.Const(width, width))));
      if (inst.getOpcode() != llvm::Instruction::Shl && inst.isExact()) add(terms_.Ne(terms_.Shl(result, b), a));
      break;
    case llvm::Instruction::UDiv:
    case llvm::Instruction::SDiv:
      if (inst.isExact()) {
        const terms::TermId rest = IsSignedDivision(inst) ? terms_.Srem(a, b) : terms_.Urem(a, b);
        add(terms_.Ne(rest, terms_.Const(0, width)));
      }
      break;
    case llvm::Instruction::Or:
      if (llvm::cast<llvm::PossiblyDisjointInst>(inst).isDisjoint())
        add(terms_.Ne(terms_.And(a, b), terms_.Const(0, width)));
      break;
    default:
      break;
  }
  return poison;
}

/// Numbers that a conversion to an integer of `width` bits has no result for; NaN, too.
terms::TermId Poison::IsBeyondInteger(terms::TermId number, uint8_t width, bool has_sign) {
  const uint8_t format = terms_.Width(number);
  const int digits = format == 32 ? 24 : 53;
  const double above = std::ldexp(1.0, has_sign ? width - 1 : width);
  const terms::TermId below_top = terms::FloatLess(terms_, number, terms::FloatConst(terms_, above, format));
  // What is cut off goes toward zero: the least integer less one is the bound, where the format has that number.
  const bool exact = !has_sign || width - 1 < digits;
  const double low = has_sign ? (exact ? -above - 1.0 : -above) : -1.0;
  const terms::TermId bound = terms::FloatConst(terms_, low, format);
  const terms::TermId above_bottom =
      exact ? terms::FloatLess(terms_, bound, number) : terms::FloatLessEqual(terms_, bound, number);
  return terms_.Not(terms_.And(below_top, above_bottom));
}

terms::TermId Poison::OfConversion(const llvm::CastInst& inst, terms::TermId result) {
  const terms::TermId a = values_.TermOf(inst.getOperand(0));
  const uint8_t from = terms_.Width(a), to = terms_.Width(result);
  switch (inst.getOpcode()) {
    case llvm::Instruction::ZExt:
    case llvm::Instruction::UIToFP:
      if (!inst.hasNonNeg() || ranges_.Of(a).high <= LowBits(from) >> 1) return {};
      return OrNone(SignOf(a));
    case llvm::Instruction::Trunc: {
      const auto& cut = llvm::cast<llvm::TruncInst>(inst);
      terms::TermId poison;
      const uint64_t high = ranges_.Of(a).high;
      if (cut.hasNoUnsignedWrap() && high > LowBits(to)) poison = OrNone(terms_.Ne(terms_.Zext(result, from), a));
      if (cut.hasNoSignedWrap() && high > LowBits(to) >> 1)
        poison = Either(poison, OrNone(terms_.Ne(terms_.Sext(result, from), a)));
      return poison;
    }
    case llvm::Instruction::FPToSI:
      return OrNone(IsBeyondInteger(a, to, true));
    case llvm::Instruction::FPToUI:
      return OrNone(IsBeyondInteger(a, to, false));
    default:
      return {};
  }
}

/// The operand of which LLVM leaves the result open, where it does.
terms::TermId Poison::OfIntrinsic(const llvm::IntrinsicInst& call) {
  const bool may_be_open = call.getIntrinsicID() == llvm::Intrinsic::abs ||
                           call.getIntrinsicID() == llvm::Intrinsic::ctlz ||
                           call.getIntrinsicID() == llvm::Intrinsic::cttz;
  if (!may_be_open || !llvm::cast<llvm::ConstantInt>(call.getArgOperand(1))->isOne()) return {};
  const terms::TermId a = values_.TermOf(call.getArgOperand(0));
  const uint8_t width = terms_.Width(a);
  const bool is_abs = call.getIntrinsicID() == llvm::Intrinsic::abs;
  return OrNone(terms_.Eq(a, terms_.Const(is_abs ? uint64_t{1} << (width - 1) : 0, width)));
}

terms::TermId Poison::IsOutOf(const llvm::ConstantRange& range, terms::TermId value) {
  if (range.isFullSet() || !value.valid()) return {};
  const uint8_t width = terms_.Width(value);
  if (range.isEmptySet()) return terms_.Bit(true);
  const uint64_t low = range.getLower().getZExtValue();
  const uint64_t count = terms::Masked(range.getUpper().getZExtValue() - low, width);
  const terms::TermId above = low == 0 ? value : terms_.Sub(value, terms_.Const(low, width));
  return OrNone(terms_.Not(terms_.Ult(above, terms_.Const(count, width))));
}

terms::TermId Poison::OfRange(const llvm::Instruction& inst, terms::TermId value) {
  const llvm::MDNode* node = inst.getMetadata(llvm::LLVMContext::MD_range);
  return node == nullptr ? terms::TermId() : IsOutOf(llvm::getConstantRangeFromMetadata(*node), value);
}

terms::TermId Poison::OfIndex(const llvm::GetElementPtrInst& inst, terms::TermId index, uint64_t scale) {
  // Up to here no sum of a few products can wrap at 64 bits.
  constexpr uint64_t kFar = uint64_t{1} << 56;
  const ValueRange range = ranges_.Of(index);
  const bool is_small = range.high <= kFar / std::max<uint64_t>(scale, 1);
  if (is_small) return {};
  terms::TermId poison;
  if (inst.hasNoUnsignedWrap()) poison = OrNone(SignOf(index));
  if (!inst.hasNoUnsignedSignedWrap() || scale == 0) return poison;
  const uint64_t most = kFar / scale;
  const terms::TermId above = terms_.Slt(terms_.Const(most, 64), index);
  const terms::TermId below = terms_.Slt(index, terms_.Const(~most + 1, 64));
  return Either(poison, OrNone(terms_.Or(above, below)));
}

terms::TermId Poison::OfPointer(const llvm::GetElementPtrInst& inst, const CodeValue& base, const CodeValue& pointer) {
  if (!inst.isInBounds()) return {};
  terms::TermId poison;
  // Both the address that it starts from and the one that it comes to are in the object, or just after it.
  for (const CodeValue* value : {&base, &pointer}) {
    for (const Target& target : value->targets) {
      const Object& object = objects_[target.object];
      if (object.kind == ObjectKind::kHost || ranges_.Of(target.offset).high <= object.bytes) continue;
      const terms::TermId beyond = terms_.Ult(terms_.Const(object.bytes, 64), target.offset);
      poison = Either(poison, OrNone(terms_.And(target.when, beyond)));
    }
  }
  return poison;
}

void Poison::RequireValue(const CodeValue& value, const char* text) {
  if (value.poison.valid()) Require(value.poison, text);
  for (const CodeValue& part : value.parts) RequireValue(part, text);
}

void Poison::RequireResult(const llvm::Function& function, const CodeValue& value) {
  constexpr const char* kText = "a result that C++ leaves undefined";
  RequireValue(value, kText);
  // Callers that do not look into the function go by it.
  if (!function.hasRetAttribute(llvm::Attribute::Range)) return;
  const terms::TermId outside = IsOutOf(function.getRetAttribute(llvm::Attribute::Range).getRange(), value.term);
  if (outside.valid()) Require(outside, kText);
}

void Poison::RequireArgument(const llvm::CallInst& call, const llvm::Argument& parameter, const CodeValue& value) {
  constexpr const char* kText = "an argument that C++ leaves undefined";
  // For a parameter that the function does not use the optimizer gives anything, and takes the attribute away.
  const unsigned number = parameter.getArgNo();
  if (!parameter.hasAttribute(llvm::Attribute::NoUndef) && !call.paramHasAttr(number, llvm::Attribute::NoUndef)) return;
  RequireValue(value, kText);
  if (const auto range = parameter.getRange()) {
    const terms::TermId outside = IsOutOf(*range, value.term);
    if (outside.valid()) Require(outside, kText);
  }
  if (const llvm::MaybeAlign align = parameter.getParamAlign()) memory_.RequireAligned(value.targets, align->value());
}

}  // namespace plcxx::prove::verify::llvm_ir
