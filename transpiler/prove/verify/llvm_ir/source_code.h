// Code that a compiler of the sources' own language made, unoptimized, as this module executes it.
//
// What the language of the control defines and C does not is written out: a shift by any count, variables that are 0
// when their function is entered, accesses at odd addresses, addresses outside of an object that nothing reads, sums
// that wrap. Variables of functions that lie in memory in the program become globals; others become values. In: the
// module as Clang gives it. Not its job: where globals are (CodeRun::globals).
#pragma once

#include <llvm/IR/Module.h>

#include "transpiler/prove/verify/compiled_code.h"

namespace plcxx::prove::verify::llvm_ir {

void AdaptSource(llvm::Module& module, const SourceCode& source);

}  // namespace plcxx::prove::verify::llvm_ir
