// Which languages have another compiler that a front end can be held against (ir/reference.h).
#pragma once

#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/reference.h"

namespace plcxx::dialects {

/// To be asked for a program that Dialect::lower has given without errors; nothing is reported.
using MakeReference = ir::Reference (*)(Request& request);

/// None: the dialect has no other compiler.
MakeReference ReferenceOf(const Dialect& dialect);

}  // namespace plcxx::dialects
