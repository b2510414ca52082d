#include "transpiler/prove/verify/bitcode.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "transpiler/compile/child_process.h"
#include "transpiler/compile/runtime_files.h"
#include "transpiler/compile/target.h"
#include "transpiler/support/read_file.h"

namespace plcxx::prove::verify {
namespace {

constexpr int kCompilerSeconds = 600;

/// What plcxx build does, but for what would make many instructions of one, or have rounds of a loop begin elsewhere
/// than in the source. The generated functions stay functions (those of the runtime are inline) with the parameters
/// that the source says, also where only the file itself calls them, so that each can be proved by itself.
constexpr std::string_view kFlags[] = {"-emit-llvm",
                                       "-g0",
                                       "-fno-vectorize",
                                       "-fno-slp-vectorize",
                                       "-fno-unroll-loops",
                                       "-mllvm",
                                       "-rotation-max-header-size=0",
                                       "-finline-hint-functions",
                                       "-fno-discard-value-names",
                                       "-Dstatic=__attribute__((used)) static"};

std::string FirstFault(const std::string& output) {
  size_t at = output.find("error:");
  if (at == std::string::npos) at = 0;
  const size_t line = output.rfind('\n', at);
  const size_t begin = line == std::string::npos ? 0 : line + 1;
  return output.substr(begin, output.find('\n', at) - begin);
}

/// A line that asks the preprocessor for more than other files: with `static` defined, as here, it may choose another
/// text than in the build. Empty: there is none.
std::string_view FindDirective(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::string_view begins = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    const bool is_directive = begins.starts_with('#') || begins.starts_with("%:");
    if (is_directive && !begins.starts_with("#include ") && begins != "#pragma once") return begins;
  }
  return {};
}

bool WriteFiles(const BitcodeRequest& request, const compile::TemporaryDirectory& directory) {
  bool written = directory.valid() && compile::WriteRuntime(directory.path());
  for (const emit::OutputFile& file : request.runtime) written = written && directory.Write(file.name, file.text);
  for (const emit::OutputFile& file : *request.files) {
    if (file.name.ends_with(".hpp") || file.name.ends_with(".cpp"))
      written = written && directory.Write(file.name, file.text);
  }
  return written;
}

}  // namespace

std::variant<Bitcode, BitcodeFailure> CompileToBitcode(const BitcodeRequest& request) {
  for (const emit::OutputFile& file : *request.files) {
    const bool is_compiled = file.name.ends_with(".hpp") || file.name.ends_with(".cpp");
    if (const std::string_view line = is_compiled ? FindDirective(file.text) : ""; !line.empty())
      return BitcodeFailure{file.name + " has a line for the preprocessor: " + std::string(line), ""};
  }
  const compile::TemporaryDirectory directory;
  if (!WriteFiles(request, directory)) return BitcodeFailure{directory.WhyNot(), ""};
  Bitcode bitcode;
  for (const emit::OutputFile& file : *request.files) {
    if (!file.name.ends_with(".cpp")) continue;
    const std::string object = file.name + ".bc";
    const compile::Target& target = request.target != nullptr ? *request.target : compile::Targets().front();
    std::vector<std::string> command =
        compile::CompileCommand(*request.toolchain, target, request.level, directory.path(), file.name, object);
    command.insert(command.end(), std::begin(kFlags), std::end(kFlags));
    command.insert(command.end(), request.further_flags.begin(), request.further_flags.end());
    const compile::ProcessResult result = compile::RunProcess(command, kCompilerSeconds, directory.path());
    if (result.exit_code != 0) return BitcodeFailure{FirstFault(result.output), result.output};
    bitcode.files.push_back(support::ReadFile(directory.path() + "/" + object).value_or(""));
    if (!bitcode.flags.empty()) continue;
    for (const std::string& word : command) {
      const bool names_file = word == file.name || word == object || word.find(directory.path()) != std::string::npos;
      if (word.starts_with("-") && word != "-o" && word != "-c" && word != "-I" && !names_file)
        bitcode.flags.push_back(word);
    }
  }
  return bitcode;
}

}  // namespace plcxx::prove::verify
