// The program as Clang itself compiles it, and where its variables are in the program that lowering makes
// (ir/reference.h).
#pragma once

#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/reference.h"

namespace plcxx::hnc {

ir::Reference MakeReference(dialects::Request& request);

}  // namespace plcxx::hnc
