// Comparisons of which compilers know the outcome, and say so in a warning: "m[V] > 255", "m[D] < 0", "m[W] < m[W]".
//
// Spelled by the name of their function, they are as quiet as they are useless; leaving them out is not the emitter's
// business.

#include <algorithm>
#include <iterator>
#include <string_view>

#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"
#include "transpiler/support/low_bits.h"

namespace plcxx::emit::legalize {
namespace {

struct Interval {
  uint64_t low = 0, high = 0;
};

/// What a value can be by its type and, where the spelling shows a narrower word, by that word's type.
Interval IntervalOf(const ir::Program& program, ir::ValueId value) {
  const ir::Inst& inst = program[value];
  constexpr ir::OpKind kWidenings[] = {ir::OpKind::kWiden1To16, ir::OpKind::kWiden1To32,  ir::OpKind::kWiden8To16,
                                       ir::OpKind::kWiden8To32, ir::OpKind::kWiden16To32, ir::OpKind::kWiden32To64};
  if (inst.op == ir::OpKind::kConst) return {ir::ConstantValue(inst), ir::ConstantValue(inst)};
  if (std::ranges::find(kWidenings, inst.op) != std::ranges::end(kWidenings))
    return IntervalOf(program, ir::ValueId(inst.a));
  if (inst.type == ir::Type::kBit) return {0, 1};
  return {0, support::LowBits(8 * ir::Bytes(inst.type))};
}

bool Apart(const Interval& a, const Interval& b) { return a.high < b.low || b.high < a.low; }
/// Whether `a < b` holds for all values, or for none.
bool OrderIsKnown(const Interval& a, const Interval& b) { return a.high < b.low || a.low >= b.high; }

/// Whether both are spelled the same: one value, or two reads of one place.
bool AreSame(const ir::Program& program, ir::ValueId left, ir::ValueId right) {
  if (left == right) return true;
  const ir::Inst& a = program[left];
  const ir::Inst& b = program[right];
  return ir::Info(a.op).shape == ir::Shape::kLoad && a.op == b.op && a.payload == b.payload && a.a == b.a && a.b == b.b;
}

bool IsComparison(const ir::OpInfo& info) {
  return info.precedence == ir::Precedence::kRelational || info.precedence == ir::Precedence::kEquality;
}

/// By how it is spelled, so that no operation is forgotten; what is compared with its sign is a call in it already.
bool IsForegone(const ir::Program& program, const ir::Inst& inst) {
  const ir::OpInfo& info = ir::Info(inst.op);
  if (!IsComparison(info)) return false;
  const ir::ValueId left(inst.a), right(inst.b);
  if (AreSame(program, left, right)) return true;
  const ir::Type type = program[left].type;
  if (type == ir::Type::kBit || type == ir::Type::kF32 || type == ir::Type::kF64) return false;
  const std::string_view spelling = info.spelling;
  if (spelling == "{0} == {1}" || spelling == "{0} != {1}")
    return Apart(IntervalOf(program, left), IntervalOf(program, right));
  if (spelling == "{0} < {1}" || spelling == "{0} >= {1}")
    return OrderIsKnown(IntervalOf(program, left), IntervalOf(program, right));
  if (spelling == "{0} > {1}" || spelling == "{0} <= {1}")
    return OrderIsKnown(IntervalOf(program, right), IntervalOf(program, left));
  return false;
}

}  // namespace

void FindForegoneComparisons(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.wordings.assign(program.insts.size(), Wording::kTable);
  for (const ir::InstId id : PrintedInsts(program, emittable.options))
    if (IsForegone(program, program[id])) emittable.wordings[id.index] = Wording::kFunction;
}

}  // namespace plcxx::emit::legalize
