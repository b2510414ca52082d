#include "transpiler/support/check.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "transpiler/support/exit_code.h"
#include "transpiler/support/fault_guard.h"

namespace plcxx::support {
namespace {

thread_local int guards = 0;

}  // namespace

FaultGuard::FaultGuard() { ++guards; }
FaultGuard::~FaultGuard() { --guards; }
bool FaultGuard::IsActive() { return guards > 0; }

void InternalFault(const char* condition, const char* file, int line) {
  // The path of the build machine says nothing to the user; the file's name does.
  const char* name = std::strrchr(file, '/');
  if (FaultGuard::IsActive()) {
    throw FaultError("check '" + std::string(condition) + "' failed (" + (name != nullptr ? name + 1 : file) + ":" +
                     std::to_string(line) + ")");
  }
  std::fprintf(stderr,
               "plcxx: internal fault: check '%s' failed (%s:%d)\n"
               "plcxx: this is a fault of plcxx, not of your program; please report it with the sources that show it\n",
               condition, name != nullptr ? name + 1 : file, line);
  std::fflush(stderr);
  std::_Exit(kInternalFaultExit);
}

}  // namespace plcxx::support
