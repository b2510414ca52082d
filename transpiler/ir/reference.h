// The sources once more, as another compiler of the same language compiles them: what the front end of plcxx is held
// against (prove/verify/front_end).
//
// In: LLVM's bitcode, and which of its functions and variables are which routines and bytes of the program. What a
// function has in another form than its routine is named with it. Not its job: comparing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

/// Bytes of a space that a variable of the sources is.
struct ReferenceBytes {
  SpaceId space;
  uint32_t offset = 0, bytes = 0;
};

struct ReferenceVariable {
  std::string name;  // of the global in the bitcode
  ReferenceBytes at;
  bool is_constant = false;  // the sources say that nothing writes it
  bool is_table = false;     // its elements are the addresses of the words of `at`, one after the other
};

/// A variable of a function that lies in memory in the program.
struct ReferenceLocal {
  std::string name;  // as the source writes it
  ReferenceBytes at;
  bool is_parameter = false;
};

struct ReferenceFunction {
  std::string name;  // in the bitcode
  RoutineId routine;
  std::vector<ReferenceLocal> locals;    // in the order of their declarations
  std::optional<ReferenceBytes> result;  // where the program has a result that is no number
  /// Why its parameters or its result are not those of the routine: "a structure as a parameter". It is compared in
  /// each of its calls, and not by itself.
  std::string in_callers;
  /// What the other compiler reads in another way than the language: then the function's code there is no measure of
  /// it. Empty: nothing.
  std::string read_otherwise;
};

/// A function that the sources only call, for the control has it: in the program it is a routine or a host function.
struct ReferenceCallee {
  std::string name;
  RoutineId routine;
  HostFunctionId host;
};

/// A call that, with these constant arguments, stores a constant, calls the host, or does nothing: a handler in its
/// slot, `asm cli`.
struct ReferenceEffect {
  std::string function;                // "set_mst_func"
  std::vector<std::string> arguments;  // numbers, and names of functions: "0", "77", "on_m"
  std::optional<ReferenceBytes> stores_at;
  uint8_t mask = 0xFF;  // bits of the byte that are stored
  uint8_t value = 0;
  HostFunctionId host;
};

struct Reference {
  std::string reason;  // why there is none; empty: there is one
  std::string bitcode;
  std::string compiler;  // "Clang 19.1.7 for msp430"
  std::vector<ReferenceFunction> functions;
  std::vector<ReferenceVariable> variables;
  std::vector<ReferenceCallee> callees;
  std::vector<ReferenceEffect> effects;
  RoutineId fault;  // what the program calls where the language says more than C does, with a number
  std::vector<uint64_t> undefined_faults;  // numbers of faults that C has, too: what it leaves undefined
};

}  // namespace plcxx::ir
