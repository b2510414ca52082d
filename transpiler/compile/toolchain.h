// The compiler of a target: which command, which flags, and whether it is there.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "transpiler/compile/target.h"

namespace plcxx::compile {

struct Toolchain {
  std::vector<std::string> command;  // the compiler; in front of it a launcher such as ccache
  std::string archiver;
  bool is_clang = false;
  std::string version;  // its first line of --version; for people only
};

struct MissingTool {
  std::string command;
  std::string package;  // of Debian
};

/// A compiler as users name it: the path of a file, or words separated by blanks, such as "ccache g++".
std::vector<std::string> CommandWords(const std::string& command);

/// `compiler`: as --compiler takes it, words separated by blanks; empty: the target's own GCC, on the host what CXX
/// names or the system has.
std::variant<Toolchain, MissingTool> FindToolchain(const Target& target, const std::string& compiler);

/// The processors that a GCC makes code for, as it says it ("x86_64-linux-gnu"), where these are others than the
/// target's; empty: they are not. Clang makes code for all of them.
std::string OtherMachineOf(const Toolchain& toolchain, const Target& target);

/// The command that compiles `source` to `object`, both relative to `directory`, in which it runs. `level` as after
/// -O. The object names no path outside of `directory`, and has line tables and frame descriptions (-g1), from which
/// stack and loops are measured; neither is loaded onto a target.
std::vector<std::string> CompileCommand(const Toolchain& toolchain, const Target& target, const std::string& level,
                                        const std::string& directory, const std::string& source,
                                        const std::string& object);

}  // namespace plcxx::compile
