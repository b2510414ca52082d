// What an instruction's flags promise, and what becomes of a value for which the promise is broken.
//
// LLVM calls such a value poison. It may be computed and thrown away; it must not decide a branch, be written, be an
// address, or be given to somebody else. A value carries the condition under which it is poison from where it is made
// to where it is used, and there the condition must never hold.
#pragma once

#include <llvm/IR/ConstantRange.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>

#include <cstdint>

#include "transpiler/prove/verify/llvm_ir/code_values.h"
#include "transpiler/prove/verify/llvm_ir/execution.h"
#include "transpiler/prove/verify/llvm_ir/object_memory.h"

namespace plcxx::prove::verify::llvm_ir {

class Poison : private ExecutionPart {
 public:
  Poison(Execution& execution, CodeValues& values, ObjectMemory& memory)
      : ExecutionPart(execution), values_(values), memory_(memory) {}

  // Conditions that may be none.
  terms::TermId OfOperands(const llvm::User& inst);
  terms::TermId OfBinary(const llvm::BinaryOperator& inst, terms::TermId result);
  terms::TermId OfConversion(const llvm::CastInst& inst, terms::TermId result);
  terms::TermId OfIntrinsic(const llvm::IntrinsicInst& call);
  /// By what is said of the instruction, and of the result of a call.
  terms::TermId OfRange(const llvm::Instruction& inst, terms::TermId value);
  terms::TermId OfIndex(const llvm::GetElementPtrInst& inst, terms::TermId index, uint64_t scale);
  terms::TermId OfPointer(const llvm::GetElementPtrInst& inst, const CodeValue& base, const CodeValue& pointer);
  terms::TermId IsOutOf(const llvm::ConstantRange& range, terms::TermId value);

  void RequireValue(const CodeValue& value, const char* text);
  /// What a function returns.
  void RequireResult(const llvm::Function& function, const CodeValue& value);
  void RequireArgument(const llvm::CallInst& call, const llvm::Argument& parameter, const CodeValue& value);

 private:
  terms::TermId SignOf(terms::TermId a);
  terms::TermId SumOverflows(terms::TermId a, terms::TermId b, terms::TermId sum, bool has_sign);
  terms::TermId DifferenceOverflows(terms::TermId a, terms::TermId b, terms::TermId difference, bool has_sign);
  terms::TermId ProductOverflows(terms::TermId a, terms::TermId b, bool has_sign);
  terms::TermId IsBeyondInteger(terms::TermId number, uint8_t width, bool has_sign);

  CodeValues& values_;
  ObjectMemory& memory_;
};

}  // namespace plcxx::prove::verify::llvm_ir
