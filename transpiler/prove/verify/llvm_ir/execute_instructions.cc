// Executor: instructions that compute, and loads, stores and calls.
#include <llvm/IR/GetElementPtrTypeIterator.h>
#include <llvm/IR/Operator.h>

#include <utility>

#include "transpiler/prove/verify/llvm_ir/executor.h"
#include "transpiler/prove/verify/llvm_ir/refusal.h"
#include "transpiler/symbolic/terms/floats.h"

namespace plcxx::prove::verify::llvm_ir {
bool Executor::Check(const llvm::Instruction& inst) {
  if (terms_.size() - first_term_ > run_.most_terms)
    Refuse("the program takes more than " + std::to_string(run_.most_terms) + " terms");
  const std::string name = std::string("instruction '") + inst.getOpcodeName() + "'";
  const auto check = [&](const llvm::Type& type) {
    if (type.isVoidTy() || type.isLabelTy() || type.isMetadataTy() || IsSupported(type)) return;
    Refuse(name + (type.isVectorTy() ? " of vectors" : " of a type that is too wide"));
  };
  check(*inst.getType());
  if (!llvm::isa<llvm::CallBase>(inst)) {
    for (const llvm::Use& operand : inst.operands()) check(*operand->getType());
  }
  if (inst.isVolatile() || inst.isAtomic()) Refuse(name + " that is volatile or atomic");
  if (const auto* floats = llvm::dyn_cast<llvm::FPMathOperator>(&inst)) {
    // Freedoms that the compiler gave itself: what the processor computes is not known.
    if (floats->getFastMathFlags().any()) Refuse(name + " of floating point that need not be exact (-ffast-math)");
  }
  return !refused();
}

void Executor::Require(terms::TermId never, const char* text) {
  const terms::TermId condition = terms_.And(context_, never);
  if (!terms_.IsFalse(condition)) outcome_.obligations.push_back({condition, text, environment_.Given()});
}

void Executor::ExecuteInst(const llvm::Instruction& inst) {
  if (const auto* call = llvm::dyn_cast<llvm::CallInst>(&inst)) {
    if (llvm::isa<llvm::DbgInfoIntrinsic>(call) || !Check(inst)) return;
    CodeValue result = ExecuteCall(*call);
    if (!inst.getType()->isVoidTy()) values_[&inst] = std::move(result);
    return;
  }
  if (!Check(inst)) return;
  if (const auto* store = llvm::dyn_cast<llvm::StoreInst>(&inst)) {
    ExecuteStore(*store);
    return;
  }
  CodeValue value = Evaluate(inst);
  if (!refused()) values_[&inst] = std::move(value);
}

void Executor::ExecuteStore(const llvm::StoreInst& store) {
  const llvm::Type& type = *store.getValueOperand()->getType();
  if (type.isPointerTy() || type.isStructTy()) {
    Refuse("instruction 'store' of a pointer or a structure");
    return;
  }
  const CodeValue stored = ValueOf(store.getValueOperand()), pointer = ValueOf(store.getPointerOperand());
  RequireValue(stored, "a write of a number that C++ leaves undefined");
  RequireValue(pointer, kAddressUndefined);
  RequireAligned(pointer.targets, store.getAlign().value());
  const auto bytes = static_cast<uint32_t>(layout_.getTypeStoreSize(store.getValueOperand()->getType()));
  Store(pointer.targets, 0, terms_.Zext(stored.term, static_cast<uint8_t>(8 * bytes)));
}

/// An element of a table of addresses.
CodeValue Executor::LoadAddress(const CodeValue& pointer) {
  CodeValue value;
  for (const Target& target : pointer.targets) {
    if (objects_[target.object].kind != ObjectKind::kTable) {
      Refuse("instruction 'load' of a pointer in memory");
      return PointerTo(0);
    }
    value.targets.push_back({target.when, objects_[target.object].elements, target.offset});
  }
  return value;
}

CodeValue Executor::ExecuteLoad(const llvm::LoadInst& load) {
  const llvm::Type& type = *load.getType();
  if (type.isPointerTy() && run_.language == CodeRun::Language::kSource)
    return LoadAddress(ValueOf(load.getPointerOperand()));
  if (type.isPointerTy() || type.isStructTy()) {
    Refuse("instruction 'load' of a pointer or a structure");
    return AnyOf(type);
  }
  const CodeValue pointer = ValueOf(load.getPointerOperand());
  RequireValue(pointer, kAddressUndefined);
  RequireAligned(pointer.targets, load.getAlign().value());
  const auto bytes = static_cast<uint32_t>(layout_.getTypeStoreSize(load.getType()));
  CodeValue value{.term = terms_.Resize(Load(pointer.targets, 0, bytes), WidthOf(type))};
  value.poison = PoisonOfRange(load, value.term);
  if (load.hasMetadata(llvm::LLVMContext::MD_noundef))
    RequireValue(value, "a read of a number that its type does not have");
  return value;
}

CodeValue Executor::Freeze(const llvm::FreezeInst& inst) {
  CodeValue value = ValueOf(inst.getOperand(0));
  if (!value.poison.valid()) return value;
  if (!value.term.valid()) {
    Refuse("instruction 'freeze' of a pointer");
    return value;
  }
  value.term = terms_.Ite(value.poison, Undefined(terms_.Width(value.term)), value.term);
  value.poison = {};
  return value;
}

CodeValue Executor::Evaluate(const llvm::Instruction& inst) {
  CodeValue value = Compute(inst);
  if (refused()) return value;
  if (const auto* binary = llvm::dyn_cast<llvm::BinaryOperator>(&inst)) {
    value.poison = Either(PoisonOfOperands(inst), PoisonOfBinary(*binary, value.term));
  } else if (llvm::isa<llvm::PtrToIntInst>(inst) || llvm::isa<llvm::IntToPtrInst>(inst)) {
    value.poison = PoisonOfOperands(inst);
  } else if (const auto* cast = llvm::dyn_cast<llvm::CastInst>(&inst)) {
    value.poison = Either(PoisonOfOperands(inst), PoisonOfConversion(*cast, value.term));
  } else if (llvm::isa<llvm::CmpInst>(inst) || llvm::isa<llvm::UnaryOperator>(inst)) {
    value.poison = PoisonOfOperands(inst);
  }
  return value;
}

CodeValue Executor::Compute(const llvm::Instruction& inst) {
  if (const auto* number = llvm::dyn_cast<llvm::PtrToIntInst>(&inst))
    return {.term = NumberOf(ValueOf(number->getPointerOperand()), WidthOf(*inst.getType()))};
  if (const auto* pointer = llvm::dyn_cast<llvm::IntToPtrInst>(&inst)) return PointerAt(TermOf(pointer->getOperand(0)));
  if (const auto* binary = llvm::dyn_cast<llvm::BinaryOperator>(&inst))
    return {.term = EvaluateBinaryOperator(*binary)};
  if (const auto* compare = llvm::dyn_cast<llvm::ICmpInst>(&inst)) return {.term = Compare(*compare)};
  if (const auto* compare = llvm::dyn_cast<llvm::FCmpInst>(&inst)) return {.term = CompareFloats(*compare)};
  if (const auto* cast = llvm::dyn_cast<llvm::CastInst>(&inst)) return {.term = Convert(*cast)};
  if (const auto* element = llvm::dyn_cast<llvm::GetElementPtrInst>(&inst)) return ElementPointer(*element);
  if (const auto* select = llvm::dyn_cast<llvm::SelectInst>(&inst)) {
    const CodeValue condition = ValueOf(select->getCondition());
    CodeValue value = Choose(condition.term, ValueOf(select->getTrueValue()), ValueOf(select->getFalseValue()));
    value.poison = Either(value.poison, condition.poison);
    return value;
  }
  if (const auto* freeze = llvm::dyn_cast<llvm::FreezeInst>(&inst)) return Freeze(*freeze);
  if (inst.getOpcode() == llvm::Instruction::FNeg)
    return {.term = terms::FloatNegate(terms_, TermOf(inst.getOperand(0)))};
  if (const auto* load = llvm::dyn_cast<llvm::LoadInst>(&inst)) return ExecuteLoad(*load);
  if (const auto* local = llvm::dyn_cast<llvm::AllocaInst>(&inst)) {
    const auto* count = llvm::dyn_cast<llvm::ConstantInt>(local->getArraySize());
    if (count != nullptr && count->getValue().getActiveBits() < 32)
      return PointerTo(NewLocal(layout_.getTypeAllocSize(local->getAllocatedType()) * count->getZExtValue(),
                                local->getAlign().value()));
    Refuse("instruction 'alloca' of a size that is not known");
    return AnyOf(*inst.getType());
  }
  if (const auto* extract = llvm::dyn_cast<llvm::ExtractValueInst>(&inst)) {
    CodeValue value = ValueOf(extract->getAggregateOperand());
    for (const unsigned index : extract->indices()) {
      CodeValue part = value.parts[index];
      part.poison = Either(part.poison, value.poison);
      value = std::move(part);
    }
    return value;
  }
  if (const auto* insert = llvm::dyn_cast<llvm::InsertValueInst>(&inst)) {
    CodeValue value = ValueOf(insert->getAggregateOperand());
    CodeValue* part = &value;
    for (const unsigned index : insert->indices()) part = &part->parts[index];
    *part = ValueOf(insert->getInsertedValueOperand());
    return value;
  }
  Refuse(std::string("instruction '") + inst.getOpcodeName() + "'");
  return AnyOf(*inst.getType());
}

terms::TermId Executor::Divide(const llvm::BinaryOperator& inst, terms::TermId a, terms::TermId b) {
  const uint8_t width = terms_.Width(a);
  Require(terms_.Eq(b, terms_.Const(0, width)), "a division by zero");
  RequireValue(ValueOf(inst.getOperand(1)), "a division by a number that C++ leaves undefined");
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
      return terms_.Sdiv(a, b);
    default:
      return terms_.Srem(a, b);
  }
}

terms::TermId Executor::EvaluateBinaryOperator(const llvm::BinaryOperator& inst) {
  const terms::TermId a = TermOf(inst.getOperand(0)), b = TermOf(inst.getOperand(1));
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

terms::TermId Executor::ComparePointers(const llvm::ICmpInst& inst) {
  const CodeValue a = ValueOf(inst.getOperand(0)), b = ValueOf(inst.getOperand(1));
  if (!inst.isEquality()) {
    Refuse("instruction 'icmp' of pointers by their order");
    return terms_.Bit(false);
  }
  terms::TermId equal = terms_.Bit(false);
  for (const Target& one : a.targets) {
    for (const Target& other : b.targets) {
      if (one.object != other.object) continue;
      equal = terms_.Or(equal, terms_.And(terms_.And(one.when, other.when), terms_.Eq(one.offset, other.offset)));
    }
  }
  return inst.getPredicate() == llvm::CmpInst::ICMP_EQ ? equal : terms_.Not(equal);
}

terms::TermId Executor::Compare(const llvm::ICmpInst& inst) {
  if (inst.getOperand(0)->getType()->isPointerTy()) return ComparePointers(inst);
  const terms::TermId a = TermOf(inst.getOperand(0)), b = TermOf(inst.getOperand(1));
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

terms::TermId Executor::CompareFloats(const llvm::FCmpInst& inst) {
  const terms::TermId a = TermOf(inst.getOperand(0)), b = TermOf(inst.getOperand(1));
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

terms::TermId Executor::Convert(const llvm::CastInst& inst) {
  const uint8_t width = WidthOf(*inst.getType());
  const terms::TermId a = TermOf(inst.getOperand(0));
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

CodeValue Executor::ElementPointer(const llvm::GetElementPtrInst& inst) {
  const CodeValue base = ValueOf(inst.getPointerOperand());
  CodeValue pointer = base;
  llvm::MapVector<llvm::Value*, llvm::APInt> indices;
  const unsigned bits = layout_.getIndexTypeSizeInBits(inst.getType());
  llvm::APInt constant(bits, 0);
  if (!llvm::cast<llvm::GEPOperator>(inst).collectOffset(layout_, bits, indices, constant)) {
    Refuse("instruction 'getelementptr' of a type whose size is not known");
    return pointer;
  }
  terms::TermId offset = terms_.Const(static_cast<uint64_t>(constant.getSExtValue()), 64);
  for (const auto& [index, scale] : indices) {
    const CodeValue by = ValueOf(index);
    // Of 64 bits on every target: what would wrap on a smaller one is outside of the object here.
    const terms::TermId wide = terms_.Sext(by.term, 64);
    pointer.poison = Either(pointer.poison, Either(by.poison, PoisonOfIndex(inst, wide, scale.getZExtValue())));
    offset = terms_.Add(offset, terms_.Mul(wide, terms_.Const(scale.getZExtValue(), 64)));
  }
  for (Target& target : pointer.targets) target.offset = terms_.Add(target.offset, offset);
  pointer.poison = Either(pointer.poison, PoisonOfPointer(inst, base, pointer));
  return pointer;
}

CodeValue Executor::ExecuteCall(const llvm::CallInst& call) {
  if (const auto* intrinsic = llvm::dyn_cast<llvm::IntrinsicInst>(&call)) return ExecuteIntrinsic(*intrinsic);
  const llvm::Function* callee = call.getCalledFunction();
  if (callee == nullptr || call.isInlineAsm()) {
    Refuse(call.isInlineAsm() ? "inline assembler" : "a call by a pointer");
    return call.getType()->isVoidTy() ? CodeValue{} : AnyOf(*call.getType());
  }
  for (const llvm::Use& argument : call.args()) {
    if (IsSupported(*argument->getType())) continue;
    Refuse("instruction 'call' with an argument that is too wide");
    return call.getType()->isVoidTy() ? CodeValue{} : AnyOf(*call.getType());
  }
  const std::string& name = flows_.NameOf(*callee);
  if (callee->getName().starts_with(kRefusal)) {
    Refuse(callee->getName().substr(std::char_traits<char>::length(kRefusal)).str());
    return {};
  }
  if (callee->getName() == kForgetBelow) {
    ForgetBelow(TermOf(call.getArgOperand(0)));
    return {};
  }
  if (callee->isDeclaration() || environment_.Replaces(name)) return ExecuteHostCall(call, *callee, name);
  std::vector<CodeValue> arguments;
  for (const llvm::Use& argument : call.args()) {
    arguments.push_back(ValueOf(argument));
    const unsigned number = call.getArgOperandNo(&argument);
    if (number < callee->arg_size()) RequireArgument(call, *callee->getArg(number), arguments.back());
  }
  return Call(*callee, std::move(arguments));
}

}  // namespace plcxx::prove::verify::llvm_ir
