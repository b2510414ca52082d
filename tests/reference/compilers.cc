#include "tests/reference/compilers.h"

#include <sstream>
#include <string_view>

#include "transpiler/compile/runtime_files.h"
#include "transpiler/engines/embedded_consoles.h"
#include "transpiler/support/check.h"

namespace plcxx::reference {

std::shared_ptr<const engines::Platform> MakeCompiler(const std::string& command) {
  auto platform = std::make_shared<engines::Platform>();
  platform->name = command;
  std::istringstream words(command);
  for (std::string word; words >> word;) platform->compile.push_back(word);
  const compile::TemporaryDirectory& shared = platform->shared;
  PLCXX_CHECK(shared.valid() && compile::WriteRuntime(shared.path()));
  for (unsigned i = 0; i < engines::kConsoleFilesCount; ++i) {
    if (std::string_view(engines::kConsoleFiles[i].name) != "host.h") continue;
    PLCXX_CHECK(shared.Write("console.h", {engines::kConsoleFiles[i].text, engines::kConsoleFiles[i].size}));
  }
  for (const char* flag : {"-std=c++17", "-ffp-contract=off", "-w", "-I"}) platform->compile.emplace_back(flag);
  platform->compile.push_back(shared.path());
  return platform;
}

}  // namespace plcxx::reference
