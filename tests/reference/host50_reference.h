// The second reading of dialect host50, and random programs of it.
#pragma once

#include <memory>

#include "tests/reference/random_program.h"
#include "tests/reference/reference.h"
#include "transpiler/dialects/dialect.h"

namespace plcxx::reference {

std::unique_ptr<Reference> MakeHost50(dialects::Request& request, HostCalls host);
RandomProgram RandomHost50(Random& random, ProgramSize size, Spelling spelling);

}  // namespace plcxx::reference
