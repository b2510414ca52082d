#include "transpiler/prove/verify/llvm_ir/intrinsics.h"

#include <llvm/IR/Intrinsics.h>

#include <algorithm>
#include <string>
#include <utility>

#include "transpiler/symbolic/terms/floats.h"

namespace plcxx::prove::verify::llvm_ir {
namespace {

constexpr uint64_t kLongestTransfer = 1 << 16;

}  // namespace

CodeValue Intrinsics::Execute(const llvm::IntrinsicInst& call) {
  switch (call.getIntrinsicID()) {
    case llvm::Intrinsic::lifetime_start:
    case llvm::Intrinsic::lifetime_end:
      memory_.ForgetLocals(values_.ValueOf(call.getArgOperand(1)).targets);
      return {};
    case llvm::Intrinsic::experimental_noalias_scope_decl:
      return {};
    case llvm::Intrinsic::assume:
      Assume(llvm::cast<llvm::AssumeInst>(call));
      return {};
    case llvm::Intrinsic::expect:
      return values_.ValueOf(call.getArgOperand(0));
    case llvm::Intrinsic::memcpy:
    case llvm::Intrinsic::memmove:
    case llvm::Intrinsic::memset:
      Transfer(llvm::cast<llvm::MemIntrinsic>(call));
      return {};
    default:
      break;
  }
  // Others begin with a number: what asks the machine about itself has none, or a pointer.
  const auto is_number = [this](const llvm::Type& type) {
    return (type.isIntegerTy() || type.isFloatTy() || type.isDoubleTy()) && IsSupported(type);
  };
  const auto is_known = [&](const llvm::Use& argument) { return is_number(*argument->getType()); };
  if (call.arg_size() == 0 || !std::all_of(call.arg_begin(), call.arg_end(), is_known)) {
    Refuse("function '" + call.getCalledFunction()->getName().str() + "'");
    return values_.AnyResult(*call.getType());
  }
  const terms::TermId poison = poison_.OfOperands(call);
  if (const auto* overflow = llvm::dyn_cast<llvm::WithOverflowInst>(&call)) {
    CodeValue value = WithOverflow(*overflow);
    value.poison = poison;
    return value;
  }
  if (const auto* saturating = llvm::dyn_cast<llvm::SaturatingInst>(&call))
    return {.term = Saturated(*saturating), .poison = poison};
  if (call.getType()->isFloatTy() || call.getType()->isDoubleTy()) return {.term = OfFloat(call), .poison = poison};
  if (call.getType()->isIntegerTy()) {
    CodeValue value{.term = OfInteger(call), .poison = poison};
    value.poison = Either(value.poison, poison_.OfIntrinsic(call));
    value.poison = Either(value.poison, poison_.OfRange(call, value.term));
    if (const auto range = call.getRange()) value.poison = Either(value.poison, poison_.IsOutOf(*range, value.term));
    return value;
  }
  Refuse("function '" + call.getCalledFunction()->getName().str() + "'");
  return values_.AnyResult(*call.getType());
}

void Intrinsics::Assume(const llvm::AssumeInst& assumption) {
  constexpr const char* kText = "an assumption of the compiler that does not hold";
  const CodeValue condition = values_.ValueOf(assumption.getArgOperand(0));
  Require(terms_.Not(condition.term), kText);
  poison_.RequireValue(condition, kText);
  if (assumption.hasOperandBundles()) Refuse("an assumption about a pointer");
}

void Intrinsics::Transfer(const llvm::MemIntrinsic& call) {
  const terms::TermId length = values_.TermOf(call.getLength());
  const std::string name = call.getCalledFunction()->getName().str();
  if (!terms_.IsConst(length) || terms_.Value(length) > kLongestTransfer || call.isVolatile()) {
    Refuse("function '" + name + "' of a length that is not known, too great, or volatile");
    return;
  }
  const uint64_t bytes = terms_.Value(length);
  const CodeValue destination = values_.ValueOf(call.getRawDest());
  poison_.RequireValue(destination, kAddressUndefined);
  const std::vector<Target>& to = destination.targets;
  memory_.RequireAligned(to, call.getDestAlign().valueOrOne().value());
  if (const auto* set = llvm::dyn_cast<llvm::MemSetInst>(&call)) {
    const terms::TermId value = values_.TermOf(set->getValue());
    poison_.RequireValue(values_.ValueOf(set->getValue()), "a write of a number that C++ leaves undefined");
    for (uint64_t i = 0; i < bytes && !refused(); ++i) memory_.Store(to, i, value);
    return;
  }
  const auto& transfer = llvm::cast<llvm::MemTransferInst>(call);
  const CodeValue source = values_.ValueOf(transfer.getRawSource());
  poison_.RequireValue(source, kAddressUndefined);
  const std::vector<Target>& from = source.targets;
  memory_.RequireAligned(from, transfer.getSourceAlign().valueOrOne().value());
  if (llvm::isa<llvm::MemCpyInst>(transfer)) memory_.RequireApart(to, from, bytes);
  // All is read before anything is written, so that the two may overlap.
  std::vector<terms::TermId> values;
  for (uint64_t i = 0; i < bytes && !refused(); ++i) values.push_back(memory_.Load(from, i, 1));
  for (uint64_t i = 0; i < values.size() && !refused(); ++i) memory_.Store(to, i, values[i]);
}

CodeValue Intrinsics::WithOverflow(const llvm::WithOverflowInst& call) {
  const terms::TermId a = values_.TermOf(call.getLHS()), b = values_.TermOf(call.getRHS());
  const uint8_t width = terms_.Width(a);
  const auto wide_width = static_cast<uint8_t>(call.getBinaryOp() == llvm::Instruction::Mul ? 2 * width : width + 1);
  if (wide_width > 64) {
    Refuse("function '" + call.getCalledFunction()->getName().str() + "'");
    return values_.AnyOf(*call.getType());
  }
  const auto widen = [&](terms::TermId term) {
    return call.isSigned() ? terms_.Sext(term, wide_width) : terms_.Zext(term, wide_width);
  };
  const auto compute = [&](terms::TermId x, terms::TermId y) {
    switch (call.getBinaryOp()) {
      case llvm::Instruction::Add:
        return terms_.Add(x, y);
      case llvm::Instruction::Sub:
        return terms_.Sub(x, y);
      default:
        return terms_.Mul(x, y);
    }
  };
  const terms::TermId result = compute(a, b);
  const terms::TermId exact = compute(widen(a), widen(b));
  return {.parts = {{.term = result}, {.term = terms_.Ne(exact, widen(result))}}};
}

terms::TermId Intrinsics::Saturated(const llvm::SaturatingInst& call) {
  const terms::TermId a = values_.TermOf(call.getLHS()), b = values_.TermOf(call.getRHS());
  const uint8_t width = terms_.Width(a);
  const bool adds = call.getBinaryOp() == llvm::Instruction::Add;
  const bool known = adds || call.getBinaryOp() == llvm::Instruction::Sub;
  if (!known) {
    Refuse("function '" + call.getCalledFunction()->getName().str() + "'");
    return Undefined(width);
  }
  const terms::TermId result = adds ? terms_.Add(a, b) : terms_.Sub(a, b);
  if (!call.isSigned()) {
    return adds ? terms_.Ite(terms_.Ult(result, a), terms_.Const(terms::Masked(~uint64_t{0}, width), width), result)
                : terms_.Ite(terms_.Ult(a, b), terms_.Const(0, width), result);
  }
  const auto sign = [&](terms::TermId term) { return terms_.Extract(term, static_cast<uint8_t>(width - 1), 1); };
  const terms::TermId apart = terms_.Xor(sign(a), sign(b));
  const terms::TermId overflow = terms_.And(adds ? terms_.Not(apart) : apart, terms_.Xor(sign(a), sign(result)));
  const terms::TermId least = terms_.Const(uint64_t{1} << (width - 1), width);
  return terms_.Ite(overflow, terms_.Ite(sign(a), least, terms_.Not(least)), result);
}

terms::TermId Intrinsics::CountBits(const llvm::IntrinsicInst& call, terms::TermId a) {
  const uint8_t width = terms_.Width(a);
  const auto bit = [&](uint8_t number) { return terms_.Extract(a, number, 1); };
  if (call.getIntrinsicID() == llvm::Intrinsic::ctpop) {
    terms::TermId sum = terms_.Const(0, width);
    for (uint8_t i = 0; i < width; ++i) sum = terms_.Add(sum, terms_.Zext(bit(i), width));
    return sum;
  }
  const bool leading = call.getIntrinsicID() == llvm::Intrinsic::ctlz;
  terms::TermId count = terms_.Const(width, width);
  for (uint8_t i = 0; i < width; ++i) {
    // The last one asked about counts: the bit that stands nearest to where counting begins.
    const auto number = static_cast<uint8_t>(leading ? i : width - 1 - i);
    count = terms_.Ite(bit(number), terms_.Const(leading ? width - 1U - number : number, width), count);
  }
  return count;
}

terms::TermId Intrinsics::OfInteger(const llvm::IntrinsicInst& call) {
  const terms::TermId a = values_.TermOf(call.getArgOperand(0));
  const uint8_t width = terms_.Width(a);
  const auto b = [&] { return values_.TermOf(call.getArgOperand(1)); };
  const uint8_t result_width = WidthOf(*call.getType());
  const auto three_way = [&](terms::TermId less, terms::TermId greater) {
    return terms_.Ite(less, terms_.Const(terms::Masked(~uint64_t{0}, result_width), result_width),
                      terms_.Zext(greater, result_width));
  };
  switch (call.getIntrinsicID()) {
    case llvm::Intrinsic::abs: {
      const terms::TermId negative = terms_.Extract(a, static_cast<uint8_t>(width - 1), 1);
      return terms_.Ite(negative, terms_.Neg(a), a);
    }
    case llvm::Intrinsic::smax:
      return terms_.Ite(terms_.Slt(b(), a), a, b());
    case llvm::Intrinsic::smin:
      return terms_.Ite(terms_.Slt(a, b()), a, b());
    case llvm::Intrinsic::umax:
      return terms_.Ite(terms_.Ult(b(), a), a, b());
    case llvm::Intrinsic::umin:
      return terms_.Ite(terms_.Ult(a, b()), a, b());
    case llvm::Intrinsic::scmp:
      return three_way(terms_.Slt(a, b()), terms_.Slt(b(), a));
    case llvm::Intrinsic::ucmp:
      return three_way(terms_.Ult(a, b()), terms_.Ult(b(), a));
    case llvm::Intrinsic::ctpop:
    case llvm::Intrinsic::ctlz:
    case llvm::Intrinsic::cttz:
      return CountBits(call, a);
    case llvm::Intrinsic::bswap: {
      terms::TermId swapped = terms_.Extract(a, 0, 8);
      for (uint8_t i = 8; i < width; i = static_cast<uint8_t>(i + 8))
        swapped = terms_.Concat(swapped, terms_.Extract(a, i, 8));
      return swapped;
    }
    case llvm::Intrinsic::bitreverse: {
      terms::TermId reversed = terms_.Extract(a, 0, 1);
      for (uint8_t i = 1; i < width; ++i) reversed = terms_.Concat(reversed, terms_.Extract(a, i, 1));
      return reversed;
    }
    case llvm::Intrinsic::fshl:
    case llvm::Intrinsic::fshr: {
      const bool left = call.getIntrinsicID() == llvm::Intrinsic::fshl;
      const terms::TermId all = terms_.Const(width, width);
      const terms::TermId by = terms_.Urem(values_.TermOf(call.getArgOperand(2)), all);
      const terms::TermId rest = terms_.Sub(all, by);
      // A shift by the whole width gives 0 here, as it has to.
      return left ? terms_.Or(terms_.Shl(a, by), terms_.Lshr(b(), rest))
                  : terms_.Or(terms_.Shl(a, rest), terms_.Lshr(b(), by));
    }
    default:
      Refuse("function '" + call.getCalledFunction()->getName().str() + "'");
      return Undefined(result_width);
  }
}

terms::TermId Intrinsics::OfFloat(const llvm::IntrinsicInst& call) {
  const terms::TermId a = values_.TermOf(call.getArgOperand(0));
  switch (call.getIntrinsicID()) {
    case llvm::Intrinsic::fabs:
      return terms::FloatAbs(terms_, a);
    case llvm::Intrinsic::copysign:
      return terms::FloatCopySign(terms_, a, values_.TermOf(call.getArgOperand(1)));
    case llvm::Intrinsic::sqrt:
      return terms::FloatSqrt(terms_, a);
    case llvm::Intrinsic::floor:
      return terms::FloatFloor(terms_, a);
    case llvm::Intrinsic::ceil:
      return terms::FloatCeil(terms_, a);
    case llvm::Intrinsic::trunc:
      return terms::FloatTrunc(terms_, a);
    case llvm::Intrinsic::rint:
    case llvm::Intrinsic::nearbyint:
    case llvm::Intrinsic::roundeven:
      return terms::FloatRint(terms_, a);
    default:
      Refuse("function '" + call.getCalledFunction()->getName().str() + "'");
      return Undefined(WidthOf(*call.getType()));
  }
}

}  // namespace plcxx::prove::verify::llvm_ir
