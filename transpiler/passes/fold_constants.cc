#include "transpiler/passes/fold_constants.h"

#include <optional>
#include <vector>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"
#include "transpiler/passes/fold_integers.h"

namespace plcxx::passes {
namespace {

using ir::Inst;
using ir::InstId;
using ir::OpKind;

struct Folder {
  ir::Program& program;
  std::vector<uint32_t> same;  // by InstId: the value to use in its place

  void Visit(ir::RegionId region);
  void Fold(InstId id);
  std::optional<bool> Constant(uint32_t value) const;
};

std::optional<bool> Folder::Constant(uint32_t value) const {
  const Inst& inst = program[InstId(value)];
  if (inst.op != OpKind::kConst) return std::nullopt;
  return ir::ConstantValue(inst) != 0;
}

void MakeConstant(Inst& inst, uint64_t value) {
  inst = {.op = OpKind::kConst,
          .type = inst.type,
          .range = inst.range,
          .a = static_cast<uint32_t>(value),
          .b = static_cast<uint32_t>(value >> 32),
          .c = 10};
}

void Folder::Fold(InstId id) {
  Inst& inst = program[id];
  if (inst.op == OpKind::kBitNot) {
    if (const std::optional<bool> operand = Constant(inst.a)) MakeConstant(inst, *operand ? 0 : 1);
    return;
  }
  if (const std::optional<uint64_t> value = FoldedInteger(program, inst)) return MakeConstant(inst, *value);
  if (const ir::ValueId whole = WholeOfHalves(program, inst); whole.valid()) same[id.index] = whole.index;
  if (inst.op != OpKind::kBitAnd && inst.op != OpKind::kBitOr) return;
  const bool neutral = inst.op == OpKind::kBitAnd;  // x & 1 is x, x & 0 is 0; x | 0 is x, x | 1 is 1
  for (const auto& [operand, other] : {std::pair(inst.a, inst.b), std::pair(inst.b, inst.a)}) {
    const std::optional<bool> value = Constant(operand);
    if (!value) continue;
    if (*value == neutral) {
      same[id.index] = other;
    } else {
      MakeConstant(inst, neutral ? 0 : 1);
    }
    return;
  }
}

void Folder::Visit(ir::RegionId region) {
  for (const InstId id : program.regions[region].insts) {
    Inst& inst = program[id];
    ir::ForEachUse(program, inst, [this](uint32_t& word) { word = same[word]; });
    Fold(id);
    for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) Visit(owned);
  }
}

}  // namespace

void FoldConstants(ir::Program& program) {
  Folder folder{.program = program, .same = std::vector<uint32_t>(program.insts.size())};
  for (uint32_t i = 0; i < folder.same.size(); ++i) folder.same[i] = i;
  for (const ir::Routine& routine : program.routines) {
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) folder.Visit(region);
    }
  }
}

}  // namespace plcxx::passes
