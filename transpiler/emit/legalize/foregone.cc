// Comparisons of which compilers know the outcome, and say so in a warning: "m[V] > 255", "m[D] < 0", "m[W] < m[W]".
//
// Spelled by the name of their function, they are as quiet as they are useless; leaving them out is not the emitter's
// business.

#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit::legalize {
namespace {

struct Interval {
  uint64_t low = 0, high = 0;
};

/// What a value can be by its type and, where the spelling shows a narrower word, by that word's type.
Interval IntervalOf(const ir::Program& program, ir::ValueId value) {
  const ir::Inst& inst = program[value];
  switch (inst.op) {
    case ir::OpKind::kConst:
      return {ir::ConstantValue(inst), ir::ConstantValue(inst)};
    case ir::OpKind::kWiden1To16:
    case ir::OpKind::kWiden1To32:
    case ir::OpKind::kWiden8To16:
    case ir::OpKind::kWiden8To32:
    case ir::OpKind::kWiden16To32:
    case ir::OpKind::kWiden32To64:
      return IntervalOf(program, ir::ValueId(inst.a));
    default:
      break;
  }
  if (inst.type == ir::Type::kBit) return {0, 1};
  const uint32_t bits = 8 * ir::Bytes(inst.type);
  return {0, bits >= 64 ? ~uint64_t{0} : (uint64_t{1} << bits) - 1};
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

bool IsForegone(const ir::Program& program, const ir::Inst& inst) {
  if (IsComparison(ir::Info(inst.op)) && AreSame(program, ir::ValueId(inst.a), ir::ValueId(inst.b))) return true;
  const auto a = [&] { return IntervalOf(program, ir::ValueId(inst.a)); };
  const auto b = [&] { return IntervalOf(program, ir::ValueId(inst.b)); };
  switch (inst.op) {
    case ir::OpKind::kEqual8:
    case ir::OpKind::kNotEqual8:
    case ir::OpKind::kEqual16:
    case ir::OpKind::kNotEqual16:
    case ir::OpKind::kEqual32:
    case ir::OpKind::kNotEqual32:
      return Apart(a(), b());
    case ir::OpKind::kLess8:
    case ir::OpKind::kLess16:
    case ir::OpKind::kGreaterEqual16:
    case ir::OpKind::kLess32:
    case ir::OpKind::kGreaterEqual32:
      return OrderIsKnown(a(), b());
    case ir::OpKind::kGreater8:
    case ir::OpKind::kLessEqual16:
    case ir::OpKind::kGreater32:
    case ir::OpKind::kLessEqual32:
      return OrderIsKnown(b(), a());
    default:
      return false;
  }
}

}  // namespace

void FindForegoneComparisons(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.wordings.assign(program.insts.size(), Wording::kTable);
  for (const ir::InstId id : PrintedInsts(program, emittable.options))
    if (IsForegone(program, program[id])) emittable.wordings[id.index] = Wording::kFunction;
}

}  // namespace plcxx::emit::legalize
