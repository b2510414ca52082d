// What each language offers to editors.
#pragma once

#include "transpiler/dialects/common/editing.h"
#include "transpiler/dialects/dialect.h"

namespace plcxx::dialects {

/// Every dialect has one.
const Editing& EditingOf(const Dialect& dialect);

}  // namespace plcxx::dialects
