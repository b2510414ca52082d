#include "tests/reference/host50_reference.h"
namespace plcxx::reference {
RandomProgram RandomHost50(Random&, ProgramSize) { return {}; }
}  // namespace plcxx::reference
