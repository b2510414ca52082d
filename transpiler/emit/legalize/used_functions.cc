// Which functions of the host and of runtime_support the texts call.

#include <algorithm>

#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit::legalize {

void FindUsedHostFunctions(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.host_used.assign(program.host_functions.size(), false);
  for (const ir::InstId id : PrintedInsts(program, emittable.options.flavour)) {
    const ir::Inst& inst = program[id];
    if (inst.op == ir::OpKind::kHostCall) {
      emittable.host_used[program.calls[ir::CallId(inst.payload)].host.index] = true;
    }
  }
}

void FindUsedFunctions(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  const std::vector<ir::InstId> insts = PrintedInsts(program, emittable.options.flavour);
  std::vector<bool> used(ir::OpCount(), false);
  for (const ir::InstId id : insts) used[static_cast<size_t>(program[id].op)] = true;
  for (uint32_t i = 0; i < used.size(); ++i) {
    const auto op = static_cast<ir::OpKind>(i);
    const ir::OpInfo& info = ir::Info(op);
    if (!used[i] || info.shape != ir::Shape::kPure) continue;
    const size_t bracket = info.spelling.find('(');
    if (bracket != std::string_view::npos && bracket > 0) {
      emittable.functions.emplace_back(info.spelling.substr(0, bracket));
    }
    // Comparisons that may never hold are called by name, see by_function.
    if (op == ir::OpKind::kLess8) emittable.functions.emplace_back("Less8");
    if (op == ir::OpKind::kGreater8) emittable.functions.emplace_back("Greater8");
  }
  for (const ir::InstId id : insts) {
    const ir::Inst& inst = program[id];
    if (emittable.by_function[id.index]) emittable.functions.emplace_back(ir::Info(inst.op).function);
    const bool number = inst.op == ir::OpKind::kConst && inst.type == ir::Type::kF32;
    if (number && !HasLiteral(inst.type, ir::ConstantValue(inst))) {
      emittable.functions.emplace_back("F32OfBits");
    }
    const bool wide = inst.op == ir::OpKind::kConst && inst.type == ir::Type::kF64;
    if (wide && !HasLiteral(inst.type, ir::ConstantValue(inst))) {
      emittable.functions.emplace_back("F64OfBits");
    }
  }
  std::sort(emittable.functions.begin(), emittable.functions.end());
  emittable.functions.erase(std::unique(emittable.functions.begin(), emittable.functions.end()),
                            emittable.functions.end());
}

}  // namespace plcxx::emit::legalize
