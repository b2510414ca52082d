#include "transpiler/passes/fold_integers.h"

#include <algorithm>
#include <iterator>

#include "transpiler/ir/builder.h"

namespace plcxx::passes {
namespace {

using ir::OpKind;

/// Of constants without sign, as the IR keeps them.
using Meaning = uint64_t (*)(uint64_t, uint64_t);

struct FoldedOp {
  OpKind op;
  Meaning meaning;
};

constexpr uint64_t And(uint64_t a, uint64_t b) { return a & b; }
constexpr uint64_t Or(uint64_t a, uint64_t b) { return a | b; }
constexpr uint64_t Xor(uint64_t a, uint64_t b) { return a ^ b; }
constexpr uint64_t Equal(uint64_t a, uint64_t b) { return a == b ? 1 : 0; }
constexpr uint64_t NotEqual(uint64_t a, uint64_t b) { return a != b ? 1 : 0; }
constexpr uint64_t Less(uint64_t a, uint64_t b) { return a < b ? 1 : 0; }
constexpr uint64_t LessEqual(uint64_t a, uint64_t b) { return a <= b ? 1 : 0; }
constexpr uint64_t Greater(uint64_t a, uint64_t b) { return a > b ? 1 : 0; }
constexpr uint64_t GreaterEqual(uint64_t a, uint64_t b) { return a >= b ? 1 : 0; }
constexpr uint64_t Same(uint64_t a, uint64_t) { return a; }
constexpr uint64_t SignExtend16(uint64_t a, uint64_t) { return (a & 0x8000) != 0 ? a | 0xFFFF0000 : a; }

constexpr FoldedOp kFolded[] = {
    {OpKind::kAnd8, And},
    {OpKind::kAnd16, And},
    {OpKind::kAnd32, And},
    {OpKind::kOr8, Or},
    {OpKind::kOr16, Or},
    {OpKind::kOr32, Or},
    {OpKind::kXor8, Xor},
    {OpKind::kXor16, Xor},
    {OpKind::kXor32, Xor},
    {OpKind::kEqual8, Equal},
    {OpKind::kEqual16, Equal},
    {OpKind::kEqual32, Equal},
    {OpKind::kNotEqual8, NotEqual},
    {OpKind::kNotEqual16, NotEqual},
    {OpKind::kNotEqual32, NotEqual},
    {OpKind::kLess8, Less},
    {OpKind::kLess16, Less},
    {OpKind::kLess32, Less},
    {OpKind::kLessEqual16, LessEqual},
    {OpKind::kLessEqual32, LessEqual},
    {OpKind::kGreater8, Greater},
    {OpKind::kGreater16, Greater},
    {OpKind::kGreater32, Greater},
    {OpKind::kGreaterEqual16, GreaterEqual},
    {OpKind::kGreaterEqual32, GreaterEqual},
    {OpKind::kWiden1To16, Same},
    {OpKind::kWiden1To32, Same},
    {OpKind::kWiden8To16, Same},
    {OpKind::kWiden8To32, Same},
    {OpKind::kWiden16To32, Same},
    {OpKind::kSignExtend16To32, SignExtend16},
};

}  // namespace

std::optional<uint64_t> FoldedInteger(const ir::Program& program, const ir::Inst& inst) {
  const auto row = std::ranges::find(kFolded, inst.op, &FoldedOp::op);
  if (row == std::end(kFolded)) return std::nullopt;
  uint64_t operands[2] = {0, 0};
  size_t count = 0;
  for (const ir::ValueId value : ir::UsedValues(program, inst)) {
    if (program[value].op != OpKind::kConst) return std::nullopt;
    operands[count++] = ir::ConstantValue(program[value]);
  }
  return row->meaning(operands[0], operands[1]);
}

ir::ValueId WholeOfHalves(const ir::Program& program, const ir::Inst& inst) {
  if (inst.op != OpKind::kPair32) return {};
  const ir::Inst& low = program[ir::ValueId(inst.a)];
  const ir::Inst& high = program[ir::ValueId(inst.b)];
  const bool halves = low.op == OpKind::kLowHalf32 && high.op == OpKind::kHighHalf32 && low.a == high.a;
  return halves ? ir::ValueId(low.a) : ir::ValueId();
}

}  // namespace plcxx::passes
