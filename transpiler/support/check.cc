#include "transpiler/support/check.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "transpiler/support/exit_code.h"

namespace plcxx::support {

void InternalFault(const char* condition, const char* file, int line) {
  // The path of the build machine says nothing to the user; the file's name does.
  const char* name = std::strrchr(file, '/');
  std::fprintf(stderr,
               "plcxx: internal fault: check '%s' failed (%s:%d)\n"
               "plcxx: this is a fault of plcxx, not of your program; please report it with the sources that show it\n",
               condition, name != nullptr ? name + 1 : file, line);
  std::fflush(stderr);
  std::_Exit(kInternalFaultExit);
}

}  // namespace plcxx::support
