// Generated C++ to LLVM bitcode, by the Clang that has LLVM's own format.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/compile/toolchain.h"
#include "transpiler/emit/output_file.h"

namespace plcxx::prove::verify {

struct BitcodeRequest {
  const compile::Toolchain* toolchain = nullptr;         // a Clang
  const compile::Target* target = nullptr;               // none: the machine itself
  std::string level = "2";                               // as behind -O
  const std::vector<emit::OutputFile>* files = nullptr;  // those that end in .hpp and .cpp count
  std::vector<std::string> further_flags;
  /// Instead of the runtime that belongs to the tool, when not empty: its headers by name, "plcxx/bits.h".
  std::vector<emit::OutputFile> runtime;
};

struct Bitcode {
  std::vector<std::string> files;  // contents, one for each .cpp file
  std::vector<std::string> flags;  // that the compiler got, without names of files
};

struct BitcodeFailure {
  std::string message;  // the first line with a fault; lower case, no full stop
  std::string output;   // all that the compiler said
};

std::variant<Bitcode, BitcodeFailure> CompileToBitcode(const BitcodeRequest& request);

/// The Clang that plcxx verify takes when none is named.
inline constexpr const char* kVerifyCompiler = "clang++-19";

}  // namespace plcxx::prove::verify
