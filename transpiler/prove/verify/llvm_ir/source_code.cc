#include "transpiler/prove/verify/llvm_ir/source_code.h"

#include <llvm/Analysis/AssumptionCache.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Operator.h>
#include <llvm/Transforms/Utils/Local.h>
#include <llvm/Transforms/Utils/PromoteMemToReg.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace plcxx::prove::verify::llvm_ir {
namespace {

constexpr unsigned kCountMask = 0xFF, kNarrowCountMask = 31, kMostCount = 63;

/// Clang's name for a variable: with digits after it where the function has several of that name.
bool IsNameOf(std::string_view name, std::string_view variable) {
  if (!name.starts_with(variable)) return false;
  name.remove_prefix(variable.size());
  return std::ranges::all_of(name, [](unsigned char c) { return std::isdigit(c) != 0; });
}

class Adapter {
 public:
  Adapter(llvm::Module& module, const SourceCode& source) : module_(module), source_(source) {}

  void Run() {
    for (llvm::Function& function : module_) {
      if (function.isIntrinsic()) continue;
      if (!function.isDeclaration()) Adapt(function);
    }
    for (llvm::Function& function : module_) {
      if (function.isIntrinsic()) continue;
      function.setName(source_.prefix + function.getName());
      // Callers copy now.
      for (unsigned i = 0; i < function.arg_size(); ++i) function.removeParamAttr(i, llvm::Attribute::ByVal);
    }
  }

 private:
  void Adapt(llvm::Function& function) {
    llvm::removeUnreachableBlocks(function);
    std::vector<llvm::Instruction*> shifts, conversions, to_float, sums;
    std::vector<llvm::CallInst*> calls;
    for (llvm::Instruction& inst : llvm::instructions(function)) {
      inst.dropPoisonGeneratingFlags();
      if (auto* load = llvm::dyn_cast<llvm::LoadInst>(&inst)) {
        load->setVolatile(false);
        load->setAlignment(llvm::Align(1));
      } else if (auto* store = llvm::dyn_cast<llvm::StoreInst>(&inst)) {
        store->setVolatile(false);
        store->setAlignment(llvm::Align(1));
      } else if (auto* transfer = llvm::dyn_cast<llvm::MemIntrinsic>(&inst)) {
        transfer->setDestAlignment(llvm::Align(1));
        if (auto* copy = llvm::dyn_cast<llvm::MemTransferInst>(transfer)) copy->setSourceAlignment(llvm::Align(1));
      } else if (inst.isShift() && !IsShiftInside(inst)) {
        shifts.push_back(&inst);
      } else if (inst.getType()->isFloatTy() &&
                 (llvm::isa<llvm::SIToFPInst>(inst) || llvm::isa<llvm::UIToFPInst>(inst))) {
        to_float.push_back(&inst);
      } else if (inst.getType()->isFloatTy() && llvm::isa<llvm::BinaryOperator>(inst)) {
        sums.push_back(&inst);
      } else if (llvm::isa<llvm::FPToSIInst>(inst) || llvm::isa<llvm::FPToUIInst>(inst)) {
        conversions.push_back(&inst);
      } else if (auto* call = llvm::dyn_cast<llvm::CallInst>(&inst)) {
        calls.push_back(call);
      }
    }
    for (llvm::Instruction* shift : shifts) DefineShift(*shift);
    for (llvm::Instruction* conversion : conversions) DefineConversion(*conversion);
    for (llvm::Instruction* conversion : to_float) ConvertByDouble(*conversion);
    for (llvm::Instruction* sum : sums) ComputeInDouble(*sum);
    for (llvm::CallInst* call : calls) {
      if (!ReplaceEffect(*call)) ReplaceTransfer(*call);
    }
    DefineVariables(function);
    CopyArguments(function);
    // Parameters are known by their order; those of the program may have got other names.
    for (llvm::Argument& parameter : function.args()) parameter.setName("");
  }

  /// A structure that is passed is the function's own: Clang leaves the copy to what it makes of the call.
  void CopyArguments(llvm::Function& function) {
    std::vector<llvm::CallInst*> calls;
    for (llvm::Instruction& inst : llvm::instructions(function)) {
      if (auto* call = llvm::dyn_cast<llvm::CallInst>(&inst)) calls.push_back(call);
    }
    for (llvm::CallInst* call : calls) {
      for (unsigned i = 0; i < call->arg_size(); ++i) {
        if (!call->isByValArgument(i)) continue;
        llvm::Type* type = call->getParamByValType(i);
        llvm::IRBuilder<> entry(&*function.getEntryBlock().getFirstNonPHIOrDbgOrAlloca());
        llvm::AllocaInst* copy = entry.CreateAlloca(type);
        llvm::IRBuilder<> builder(call);
        builder.CreateMemMove(copy, llvm::Align(1), call->getArgOperand(i), llvm::Align(1),
                              module_.getDataLayout().getTypeAllocSize(type).getFixedValue());
        call->setArgOperand(i, copy);
        call->removeParamAttr(i, llvm::Attribute::ByVal);
      }
    }
  }

  static std::string TextOf(const llvm::Value& argument) {
    if (const auto* number = llvm::dyn_cast<llvm::ConstantInt>(&argument))
      return std::to_string(number->getSExtValue());
    return llvm::isa<llvm::ConstantPointerNull>(argument) ? "0" : argument.getName().str();
  }

  bool ReplaceEffect(llvm::CallInst& call) {
    const llvm::Function* callee = call.getCalledFunction();
    if (callee == nullptr || !callee->isDeclaration()) return false;
    std::vector<std::string> arguments;
    for (const llvm::Use& argument : call.args()) arguments.push_back(TextOf(*argument));
    const auto effect = std::ranges::find_if(source_.effects, [&](const SourceCode::Effect& one) {
      return callee->getName() == one.function && one.arguments == arguments;
    });
    if (effect == source_.effects.end()) return false;
    llvm::IRBuilder<> builder(&call);
    if (!effect->global.empty()) {
      llvm::Value* place = module_.getOrInsertGlobal(effect->global, builder.getInt8Ty());
      llvm::Value* kept = builder.CreateAnd(builder.CreateAlignedLoad(builder.getInt8Ty(), place, llvm::Align(1)),
                                            static_cast<uint8_t>(~effect->mask));
      builder.CreateAlignedStore(builder.CreateOr(kept, effect->value & effect->mask), place, llvm::Align(1));
    }
    if (!effect->calls.empty()) builder.CreateCall(module_.getOrInsertFunction(effect->calls, builder.getVoidTy()));
    call.eraseFromParent();
    return true;
  }

  /// memset and its like, where it is known how much they move.
  void ReplaceTransfer(llvm::CallInst& call) {
    const llvm::Function* callee = call.getCalledFunction();
    if (callee == nullptr || !callee->isDeclaration() || call.arg_size() != 3) return;
    const llvm::StringRef name = callee->getName();
    llvm::Value* to = call.getArgOperand(0);
    llvm::Value* from = call.getArgOperand(1);
    auto* length = llvm::dyn_cast<llvm::ConstantInt>(call.getArgOperand(2));
    if (length == nullptr) return;
    llvm::IRBuilder<> builder(&call);
    if (name == "memset") {
      builder.CreateMemSet(to, builder.CreateTrunc(from, builder.getInt8Ty()), length, llvm::Align(1));
    } else if (name == "memmove" || name == "memcpy") {
      builder.CreateMemMove(to, llvm::Align(1), from, llvm::Align(1), length);
    } else {
      return;
    }
    call.replaceAllUsesWith(to);
    call.eraseFromParent();
  }

  static bool IsShiftInside(const llvm::Instruction& shift) {
    const auto* count = llvm::dyn_cast<llvm::ConstantInt>(shift.getOperand(1));
    return count != nullptr && count->getValue().ult(shift.getType()->getIntegerBitWidth());
  }

  /// Toward zero to 64 bits, of which the low ones are kept; of what has no place there, 0.
  static void DefineConversion(llvm::Instruction& conversion) {
    llvm::IRBuilder<> builder(&conversion);
    llvm::Value* number = builder.CreateFPExt(conversion.getOperand(0), builder.getDoubleTy());
    llvm::Value* limit = llvm::ConstantFP::get(number->getType(), 0x1p63);
    llvm::Value* below = builder.CreateFCmpOLT(number, limit);
    llvm::Value* above = builder.CreateFCmpOLT(builder.CreateFNeg(limit), number);
    llvm::Value* inside =
        builder.CreateSelect(builder.CreateAnd(below, above), number, llvm::Constant::getNullValue(number->getType()));
    llvm::Value* whole = builder.CreateFPToSI(inside, builder.getInt64Ty());
    conversion.replaceAllUsesWith(builder.CreateTrunc(whole, conversion.getType()));
    conversion.eraseFromParent();
  }

  /// The step of ++ and --; in all other expressions Clang has widened its operands.
  static void ComputeInDouble(llvm::Instruction& sum) {
    llvm::IRBuilder<> builder(&sum);
    llvm::Value* a = builder.CreateFPExt(sum.getOperand(0), builder.getDoubleTy());
    llvm::Value* b = builder.CreateFPExt(sum.getOperand(1), builder.getDoubleTy());
    llvm::Value* wide = builder.CreateBinOp(llvm::cast<llvm::BinaryOperator>(sum).getOpcode(), a, b);
    sum.replaceAllUsesWith(builder.CreateFPTrunc(wide, sum.getType()));
    sum.eraseFromParent();
  }

  /// A double has a place for each integer of the language, so the float is the same.
  static void ConvertByDouble(llvm::Instruction& conversion) {
    llvm::IRBuilder<> builder(&conversion);
    llvm::Value* integer = conversion.getOperand(0);
    llvm::Value* number = llvm::isa<llvm::SIToFPInst>(conversion)
                              ? builder.CreateSIToFP(integer, builder.getDoubleTy())
                              : builder.CreateUIToFP(integer, builder.getDoubleTy());
    conversion.replaceAllUsesWith(builder.CreateFPTrunc(number, conversion.getType()));
    conversion.eraseFromParent();
  }

  /// The low 8 bits of the count; of 16 bits they count modulo 32, and what is shifted out is gone.
  static void DefineShift(llvm::Instruction& shift) {
    llvm::IRBuilder<> builder(&shift);
    llvm::Type* type = shift.getType();
    const unsigned width = type->getIntegerBitWidth();
    llvm::Type* wide = builder.getIntNTy(2 * width);
    const bool has_sign = shift.getOpcode() == llvm::Instruction::AShr;
    llvm::Value* number =
        has_sign ? builder.CreateSExt(shift.getOperand(0), wide) : builder.CreateZExt(shift.getOperand(0), wide);
    llvm::Value* count = builder.CreateAnd(builder.CreateZExt(shift.getOperand(1), wide), kCountMask);
    if (width == 16) {
      count = builder.CreateAnd(count, kNarrowCountMask);
    } else {
      llvm::Value* most = llvm::ConstantInt::get(wide, kMostCount);
      count = builder.CreateSelect(builder.CreateICmpUGT(count, most), most, count);
    }
    llvm::Value* shifted = builder.CreateBinOp(llvm::cast<llvm::BinaryOperator>(shift).getOpcode(), number, count);
    shift.replaceAllUsesWith(builder.CreateTrunc(shifted, type));
    shift.eraseFromParent();
  }

  void DefineVariables(llvm::Function& function) {
    std::vector<llvm::AllocaInst*> variables;
    for (llvm::Instruction& inst : function.getEntryBlock()) {
      if (auto* variable = llvm::dyn_cast<llvm::AllocaInst>(&inst)) variables.push_back(variable);
    }
    const llvm::DataLayout& layout = module_.getDataLayout();
    llvm::IRBuilder<> builder(&*function.getEntryBlock().getFirstNonPHIOrDbgOrAlloca());
    std::vector<llvm::AllocaInst*> values;
    std::vector<bool> taken(source_.locals.size());
    for (llvm::AllocaInst* variable : variables) {
      llvm::Type* type = variable->getAllocatedType();
      const uint64_t bytes = layout.getTypeAllocSize(type);
      llvm::Value* place = variable;
      for (size_t i = 0; i < source_.locals.size(); ++i) {
        const SourceCode::Local& local = source_.locals[i];
        if (taken[i] || local.bytes != bytes || local.function != function.getName().str() ||
            !IsNameOf(variable->getName(), local.name)) {
          continue;
        }
        taken[i] = true;
        place =
            new llvm::GlobalVariable(module_, type, false, llvm::GlobalValue::ExternalLinkage, nullptr, local.global);
        variable->replaceAllUsesWith(place);
        break;
      }
      if (place == variable && llvm::isAllocaPromotable(variable)) {
        values.push_back(variable);
        builder.CreateStore(llvm::Constant::getNullValue(type), variable);
      } else {
        builder.CreateMemSet(place, builder.getInt8(0), bytes, llvm::Align(1));
      }
      if (place != variable) variable->eraseFromParent();
    }
    llvm::DominatorTree dominators(function);
    llvm::PromoteMemToReg(values, dominators);
  }

  llvm::Module& module_;
  const SourceCode& source_;
};

}  // namespace

void AdaptSource(llvm::Module& module, const SourceCode& source) { Adapter(module, source).Run(); }

}  // namespace plcxx::prove::verify::llvm_ir
