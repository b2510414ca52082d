// The generated C++ as an Engine: a compiled program, run as a child or in an emulator.
//
// The child is the generated program and a small main that obeys a byte protocol (harness.h); State is mirrored here
// after every command, and emit::layout::Layout says where each place is in it. Bytes that the program does not use
// live in a shadow memory, so that every place can be read, written and forced as in the simulator. Knows no dialect.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "transpiler/engines/compiled_program.h"
#include "transpiler/sim/engine.h"

namespace plcxx::engines {

/// Fails with a message when the process cannot be started. A child that dies later ends in EngineFault.
std::variant<std::unique_ptr<sim::Engine>, CompileFailure> StartCompiled(std::shared_ptr<CompiledProgram> program);

/// Thrown by an engine whose child died or hangs; the scenario runner turns it into a failed scenario.
struct EngineFault {
  std::string message;
};

}  // namespace plcxx::engines
