#include "transpiler/prove/verify/llvm_ir/instruction_execution.h"

#include <llvm/IR/GetElementPtrTypeIterator.h>
#include <llvm/IR/Operator.h>

#include <utility>

#include "transpiler/prove/verify/llvm_ir/flow_execution.h"
#include "transpiler/prove/verify/llvm_ir/refusal.h"
#include "transpiler/symbolic/terms/floats.h"

namespace plcxx::prove::verify::llvm_ir {

bool InstructionExecution::Check(const llvm::Instruction& inst) {
  if (terms_.size() - now_.first_term > run_.most_terms)
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

void InstructionExecution::Execute(const llvm::Instruction& inst) {
  if (const auto* call = llvm::dyn_cast<llvm::CallInst>(&inst)) {
    if (llvm::isa<llvm::DbgInfoIntrinsic>(call) || !Check(inst)) return;
    CodeValue result = Call(*call);
    if (!inst.getType()->isVoidTy()) now_.values[&inst] = std::move(result);
    return;
  }
  if (!Check(inst)) return;
  if (const auto* store = llvm::dyn_cast<llvm::StoreInst>(&inst)) {
    Store(*store);
    return;
  }
  CodeValue value = Evaluate(inst);
  if (!refused()) now_.values[&inst] = std::move(value);
}

void InstructionExecution::Store(const llvm::StoreInst& store) {
  const llvm::Type& type = *store.getValueOperand()->getType();
  if (type.isPointerTy() || type.isStructTy()) {
    Refuse("instruction 'store' of a pointer or a structure");
    return;
  }
  const CodeValue stored = values_.ValueOf(store.getValueOperand()),
                  pointer = values_.ValueOf(store.getPointerOperand());
  poison_.RequireValue(stored, "a write of a number that C++ leaves undefined");
  poison_.RequireValue(pointer, kAddressUndefined);
  memory_.RequireAligned(pointer.targets, store.getAlign().value());
  const auto bytes = static_cast<uint32_t>(layout_.getTypeStoreSize(store.getValueOperand()->getType()));
  memory_.Store(pointer.targets, 0, terms_.Zext(stored.term, static_cast<uint8_t>(8 * bytes)));
}

/// An element of a table of addresses.
CodeValue InstructionExecution::LoadAddress(const CodeValue& pointer) {
  CodeValue value;
  for (const Target& target : pointer.targets) {
    if (objects_[target.object].kind != ObjectKind::kTable) {
      Refuse("instruction 'load' of a pointer in memory");
      return values_.PointerTo(0);
    }
    value.targets.push_back({target.when, objects_[target.object].elements, target.offset});
  }
  return value;
}

CodeValue InstructionExecution::Load(const llvm::LoadInst& load) {
  const llvm::Type& type = *load.getType();
  if (type.isPointerTy() && run_.language == CodeRun::Language::kSource)
    return LoadAddress(values_.ValueOf(load.getPointerOperand()));
  if (type.isPointerTy() || type.isStructTy()) {
    Refuse("instruction 'load' of a pointer or a structure");
    return values_.AnyOf(type);
  }
  const CodeValue pointer = values_.ValueOf(load.getPointerOperand());
  poison_.RequireValue(pointer, kAddressUndefined);
  memory_.RequireAligned(pointer.targets, load.getAlign().value());
  const auto bytes = static_cast<uint32_t>(layout_.getTypeStoreSize(load.getType()));
  CodeValue value{.term = terms_.Resize(memory_.Load(pointer.targets, 0, bytes), WidthOf(type))};
  value.poison = poison_.OfRange(load, value.term);
  if (load.hasMetadata(llvm::LLVMContext::MD_noundef))
    poison_.RequireValue(value, "a read of a number that its type does not have");
  return value;
}

CodeValue InstructionExecution::Freeze(const llvm::FreezeInst& inst) {
  CodeValue value = values_.ValueOf(inst.getOperand(0));
  if (!value.poison.valid()) return value;
  if (!value.term.valid()) {
    Refuse("instruction 'freeze' of a pointer");
    return value;
  }
  value.term = terms_.Ite(value.poison, Undefined(terms_.Width(value.term)), value.term);
  value.poison = {};
  return value;
}

CodeValue InstructionExecution::Evaluate(const llvm::Instruction& inst) {
  CodeValue value = Compute(inst);
  if (refused()) return value;
  if (const auto* binary = llvm::dyn_cast<llvm::BinaryOperator>(&inst)) {
    value.poison = Either(poison_.OfOperands(inst), poison_.OfBinary(*binary, value.term));
  } else if (llvm::isa<llvm::PtrToIntInst>(inst) || llvm::isa<llvm::IntToPtrInst>(inst)) {
    value.poison = poison_.OfOperands(inst);
  } else if (const auto* cast = llvm::dyn_cast<llvm::CastInst>(&inst)) {
    value.poison = Either(poison_.OfOperands(inst), poison_.OfConversion(*cast, value.term));
  } else if (llvm::isa<llvm::CmpInst>(inst) || llvm::isa<llvm::UnaryOperator>(inst)) {
    value.poison = poison_.OfOperands(inst);
  }
  return value;
}

CodeValue InstructionExecution::Compute(const llvm::Instruction& inst) {
  if (const auto* number = llvm::dyn_cast<llvm::PtrToIntInst>(&inst))
    return {.term = addresses_.NumberOf(values_.ValueOf(number->getPointerOperand()), WidthOf(*inst.getType()))};
  if (const auto* pointer = llvm::dyn_cast<llvm::IntToPtrInst>(&inst))
    return addresses_.PointerAt(values_.TermOf(pointer->getOperand(0)));
  if (const auto* binary = llvm::dyn_cast<llvm::BinaryOperator>(&inst)) return {.term = arithmetic_.Operate(*binary)};
  if (const auto* compare = llvm::dyn_cast<llvm::ICmpInst>(&inst)) return {.term = arithmetic_.Compare(*compare)};
  if (const auto* compare = llvm::dyn_cast<llvm::FCmpInst>(&inst)) return {.term = arithmetic_.CompareFloats(*compare)};
  if (const auto* cast = llvm::dyn_cast<llvm::CastInst>(&inst)) return {.term = arithmetic_.Convert(*cast)};
  if (const auto* element = llvm::dyn_cast<llvm::GetElementPtrInst>(&inst)) return ElementPointer(*element);
  if (const auto* select = llvm::dyn_cast<llvm::SelectInst>(&inst)) return Select(*select);
  if (const auto* freeze = llvm::dyn_cast<llvm::FreezeInst>(&inst)) return Freeze(*freeze);
  if (inst.getOpcode() == llvm::Instruction::FNeg)
    return {.term = terms::FloatNegate(terms_, values_.TermOf(inst.getOperand(0)))};
  if (const auto* load = llvm::dyn_cast<llvm::LoadInst>(&inst)) return Load(*load);
  if (const auto* local = llvm::dyn_cast<llvm::AllocaInst>(&inst)) return Allocate(*local);
  if (const auto* extract = llvm::dyn_cast<llvm::ExtractValueInst>(&inst)) return Extract(*extract);
  if (const auto* insert = llvm::dyn_cast<llvm::InsertValueInst>(&inst)) return Insert(*insert);
  Refuse(std::string("instruction '") + inst.getOpcodeName() + "'");
  return values_.AnyOf(*inst.getType());
}

CodeValue InstructionExecution::Select(const llvm::SelectInst& inst) {
  const CodeValue condition = values_.ValueOf(inst.getCondition());
  CodeValue value =
      values_.Choose(condition.term, values_.ValueOf(inst.getTrueValue()), values_.ValueOf(inst.getFalseValue()));
  value.poison = Either(value.poison, condition.poison);
  return value;
}

CodeValue InstructionExecution::Allocate(const llvm::AllocaInst& inst) {
  const auto* count = llvm::dyn_cast<llvm::ConstantInt>(inst.getArraySize());
  if (count != nullptr && count->getValue().getActiveBits() < 32)
    return values_.PointerTo(memory_.NewLocal(layout_.getTypeAllocSize(inst.getAllocatedType()) * count->getZExtValue(),
                                              inst.getAlign().value()));
  Refuse("instruction 'alloca' of a size that is not known");
  return values_.AnyOf(*inst.getType());
}

CodeValue InstructionExecution::Extract(const llvm::ExtractValueInst& inst) {
  CodeValue value = values_.ValueOf(inst.getAggregateOperand());
  for (const unsigned index : inst.indices()) {
    CodeValue part = value.parts[index];
    part.poison = Either(part.poison, value.poison);
    value = std::move(part);
  }
  return value;
}

CodeValue InstructionExecution::Insert(const llvm::InsertValueInst& inst) {
  CodeValue value = values_.ValueOf(inst.getAggregateOperand());
  CodeValue* part = &value;
  for (const unsigned index : inst.indices()) part = &part->parts[index];
  *part = values_.ValueOf(inst.getInsertedValueOperand());
  return value;
}

CodeValue InstructionExecution::ElementPointer(const llvm::GetElementPtrInst& inst) {
  const CodeValue base = values_.ValueOf(inst.getPointerOperand());
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
    const CodeValue by = values_.ValueOf(index);
    // Of 64 bits on every target: what would wrap on a smaller one is outside of the object here.
    const terms::TermId wide = terms_.Sext(by.term, 64);
    pointer.poison = Either(pointer.poison, Either(by.poison, poison_.OfIndex(inst, wide, scale.getZExtValue())));
    offset = terms_.Add(offset, terms_.Mul(wide, terms_.Const(scale.getZExtValue(), 64)));
  }
  for (Target& target : pointer.targets) target.offset = terms_.Add(target.offset, offset);
  pointer.poison = Either(pointer.poison, poison_.OfPointer(inst, base, pointer));
  return pointer;
}

/// Whether it says something about the stack that machine code has (refusal.h).
bool InstructionExecution::CallOfStack(const llvm::CallInst& call, llvm::StringRef name) {
  const auto number = [&](unsigned argument) { return values_.TermOf(call.getArgOperand(argument)); };
  if (name == kForgetBelow) {
    addresses_.ForgetBelow(number(0));
  } else if (name == kStackPointer) {
    addresses_.RequireWithin(number(0), number(1));
    memory_.RequireAligned(addresses_.PointerAt(number(0)).targets, terms_.Value(number(2)),
                           "a stack pointer that is not aligned");
  } else if (name == kNotBelow) {
    addresses_.RequireNotBelow(number(0), number(1));
  } else {
    return false;
  }
  return true;
}

CodeValue InstructionExecution::Call(const llvm::CallInst& call) {
  if (const auto* intrinsic = llvm::dyn_cast<llvm::IntrinsicInst>(&call)) return intrinsics_.Execute(*intrinsic);
  const llvm::Function* callee = call.getCalledFunction();
  if (callee == nullptr || call.isInlineAsm()) {
    Refuse(call.isInlineAsm() ? "inline assembler" : "a call by a pointer");
    return values_.AnyResult(*call.getType());
  }
  for (const llvm::Use& argument : call.args()) {
    const bool is_copied = call.isPassPointeeByValueArgument(call.getArgOperandNo(&argument));
    if (IsSupported(*argument->getType()) && !is_copied) continue;
    Refuse(is_copied ? "instruction 'call' that copies an argument's object"
                     : "instruction 'call' with an argument that is too wide");
    return values_.AnyResult(*call.getType());
  }
  const std::string& name = now_.flows.NameOf(*callee);
  // Of functions that only the file calls the compiler may choose another one.
  const llvm::CallingConv::ID convention = call.getCallingConv();
  const bool is_own = convention == llvm::CallingConv::Fast && callee->hasLocalLinkage();
  const bool keeps_other_registers =
      call.hasFnAttr("no_caller_saved_registers") || call.hasFnAttr("no_callee_saved_registers");
  if (convention != callee->getCallingConv() || (convention != llvm::CallingConv::C && !is_own) ||
      keeps_other_registers)
    Refuse("a call of " + name + " by another convention than C++ has");
  if (callee->getName().starts_with(kRefusal)) {
    Refuse(callee->getName().substr(std::char_traits<char>::length(kRefusal)).str());
    return {};
  }
  if (CallOfStack(call, callee->getName())) return {};
  if (callee->isDeclaration() || environment_.Replaces(name)) return host_calls_.Call(call, *callee, name);
  std::vector<CodeValue> arguments;
  for (const llvm::Use& argument : call.args()) {
    arguments.push_back(values_.ValueOf(argument));
    const unsigned number = call.getArgOperandNo(&argument);
    if (number < callee->arg_size()) poison_.RequireArgument(call, *callee->getArg(number), arguments.back());
  }
  return flow_.Call(*callee, std::move(arguments));
}

}  // namespace plcxx::prove::verify::llvm_ir
