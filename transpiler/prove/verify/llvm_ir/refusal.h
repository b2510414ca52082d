// How whoever makes LLVM's instructions of something else says that a place cannot be executed, and what LLVM has no
// instruction for.
#pragma once

namespace plcxx::prove::verify::llvm_ir {

/// A call of a declared function whose name begins like this ends the execution with the rest of the name as reason.
inline constexpr const char* kRefusal = "plcxx.refused: ";

/// A call of this declared function, with a number that is an address in a local: what the local holds below it is not
/// known any more.
inline constexpr const char* kForgetBelow = "plcxx.forget_below";

/// A call of this declared function, with a number, another one and a power of two: both must be addresses in one local
/// (its end is one, too), the first aligned so.
inline constexpr const char* kStackPointer = "plcxx.stack_pointer";

/// A call of this declared function, with two numbers: where both are addresses in one local, the first must not be
/// below the second.
inline constexpr const char* kNotBelow = "plcxx.not_below";

}  // namespace plcxx::prove::verify::llvm_ir
