// Machine code as the tool sees it: objects of a target, and what their functions are in C++. The border to the module
// that reads them (machine_code/, lib/plcxx_verify.so).
//
// Objects do not say what a function takes and gives; the program that they were printed from does. Its functions and
// the host's are called by the target's calling convention; all others, of the runtime or split off by the compiler,
// are executed register by register where they are called.
// Not its job: what the bytes mean (verify.h).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/prove/verify/compiled_code.h"

namespace plcxx::prove::verify {

struct SignatureParameter {
  std::string name;
  uint8_t width = 0;  // in bits, of a number without sign; 0: an address
};

/// A function as its declaration says.
struct Signature {
  std::string function;  // "lathe::fast"
  std::vector<SignatureParameter> parameters;
  uint8_t result_width = 0;  // 0: none
};

/// Of the generated functions and of the host's.
std::vector<Signature> SignaturesOf(const emit::Emittable& emittable);

struct ObjectCodeRequest {
  std::span<const std::string> objects;  // contents of ELF files, all of one target
  std::span<const Signature> signatures;
  std::string processor;  // as LLVM names it
};

/// What the executor cannot follow is a refusal of the function's execution, with the instruction's name.
LoadedCode LoadObjectCode(const ObjectCodeRequest& request);

/// The function of the module; the reason is empty where it gives code.
using ReadObjectsFunction = CompiledCode*(const ObjectCodeRequest& request, std::string& reason);
inline constexpr const char* kReadObjects = "plcxx_read_objects";

}  // namespace plcxx::prove::verify
