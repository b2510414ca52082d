// Where the generated code of a scenario runs: this machine, or a processor in QEMU. What is the same for all programs
// (headers, the console of the harness, the first instructions) is written and compiled once, when a platform is made.
//
// In: a compiler's command, or the name of an emulated machine. Out: the commands that build and start one program.
// Not its job: the program and its harness (compiled_engine.h).
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/compile/child_process.h"

namespace plcxx::engines {

struct CompileFailure {
  std::string message;  // the compiler's own words after it
};

struct Platform {
  std::string name;                    // for messages: "compiled", "cortex-m"
  std::vector<std::string> compile;    // the compiler and its flags; the sources follow
  std::vector<std::string> link;       // after the sources
  std::vector<std::string> emulator;   // in front of the executable; empty: it runs by itself
  compile::TemporaryDirectory shared;  // what all programs of the platform use
};

using PlatformOrFailure = std::variant<std::shared_ptr<const Platform>, CompileFailure>;

/// This machine. `compiler` is a command ("g++").
PlatformOrFailure MakeHostPlatform(const std::string& compiler);

/// The names of the emulated machines, as --engine takes them.
std::vector<std::string_view> EmulatedMachines();

/// `name` is one of EmulatedMachines(). Fails with a message that names the package when a tool is not there.
PlatformOrFailure MakeEmulatedPlatform(std::string_view name);

/// $CXX, else the first of c++, g++, clang++ that is there; empty when none is.
std::string FindCompiler();

/// The beginning of what a compiler said, as a message shows it.
std::string FirstLines(const std::string& text);

}  // namespace plcxx::engines
