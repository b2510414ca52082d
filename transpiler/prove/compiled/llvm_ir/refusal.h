// How whoever makes LLVM's instructions of something else says that a place cannot be executed.
#pragma once

namespace plcxx::prove::compiled::llvm_ir {

/// A call of a declared function whose name begins like this ends the execution with the rest of the name as reason.
inline constexpr const char* kRefusal = "plcxx.refused: ";

}  // namespace plcxx::prove::compiled::llvm_ir
