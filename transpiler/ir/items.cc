#include "transpiler/ir/items.h"

namespace plcxx::ir {

std::vector<Item> Items(const Program& program, RegionId region) {
  std::vector<Item> items;
  const std::vector<InstId>& insts = program.regions[region].insts;
  for (uint32_t i = 0; i < insts.size(); ++i) {
    const Inst& inst = program[insts[i]];
    const bool marker = inst.op == OpKind::kStatement;
    const StatementId statement = marker ? StatementId(inst.payload) : StatementId();
    if (items.empty() || (marker && !program.statements[statement].closes_block)) {
      items.push_back({i, i + 1, statement});
    } else {
      items.back().end = i + 1;
    }
  }
  return items;
}

}  // namespace plcxx::ir
