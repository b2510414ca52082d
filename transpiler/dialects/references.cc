#include "transpiler/dialects/references.h"

#include "transpiler/dialects/hnc/hnc.h"
#include "transpiler/dialects/hnc/lowering/reference.h"

namespace plcxx::dialects {

MakeReference ReferenceOf(const Dialect& dialect) { return &dialect == &hnc::kHnc ? hnc::MakeReference : nullptr; }

}  // namespace plcxx::dialects
