#include "transpiler/fleet/evaluate.h"

#include "plcxx/arith.h"
#include "plcxx/bcd.h"
#include "plcxx/c_integers.h"
#include "plcxx/doubles.h"
#include "plcxx/floats.h"
#include "plcxx/logic.h"
#include "plcxx/position_counters.h"
#include "plcxx/registers.h"
#include "plcxx/rings.h"
#include "transpiler/sim/evaluate.h"
#include "transpiler/support/check.h"

namespace plcxx::fleet {

uint64_t ValueOf(ir::OpKind op, const std::array<uint64_t, 3>& operands) {
  using namespace sim::operand_types;
  const auto raw = [&operands](size_t i) { return operands[i]; };
  switch (op) {
#define PLCXX_PURE(Kind, Text, Operands, Result, Spelling, Precedence, Function, Cost) \
  case ir::OpKind::k##Kind:                                                            \
    return sim::Apply(std::type_identity<Result Operands>{}, raw,                      \
                      [](auto... value) { return plcxx::Function(value...); });
#define PLCXX_STEP(Kind, ...) case ir::OpKind::k##Kind:
#define PLCXX_CORE(Kind, ...) case ir::OpKind::k##Kind:
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
    break;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::fleet
