// The targets that generated code is compiled for, and the names of their tools.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plcxx::compile {

struct Target {
  std::string_view name;       // as --target takes it
  std::string_view prefix;     // of GCC's tools: "arm-none-eabi-"; empty: the machine's own
  std::string_view triple;     // for Clang; empty: the machine's own
  std::string_view flags;      // of code generation, for GCC and Clang alike, separated by blanks
  std::string_view processor;  // of LLVM's scheduling models
  std::string_view meaning;    // a few words for --help
};

/// All of them, the machine's own first.
const std::vector<Target>& Targets();

std::vector<std::string_view> TargetNames();

/// nullptr when there is none of this name.
const Target* FindTarget(std::string_view name);

/// The flags as arguments of a command.
std::vector<std::string> FlagsOf(const Target& target);

}  // namespace plcxx::compile
