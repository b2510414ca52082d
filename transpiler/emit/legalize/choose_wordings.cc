// Chooses the text of operations that their row of the table would not spell well.
//
//   not.bit (eq.i8 a, b)   ->   a != b
//   store s, (load s)      ->   nothing but a use of s
//   add.i32 %0, 4294966796 ->   Sub32(..., 500)
//   4294967295             ->   Minus32(1)

#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit::legalize {
namespace {

/// A comparison of integers that is spelled with its operator; of floats one that does not hold may have no order.
bool HasComplement(const Emittable& emittable, ir::ValueId value) {
  const ir::Program& program = *emittable.program;
  const ir::Inst& inst = program[value];
  const ir::Precedence precedence = ir::Info(inst.op).precedence;
  if (precedence != ir::Precedence::kRelational && precedence != ir::Precedence::kEquality) return false;
  if (emittable.forms[value.index] == Form::kLocal || emittable.wordings[value.index] == Wording::kFunction)
    return false;
  const ir::Type type = program[ir::ValueId(inst.a)].type;
  return type != ir::Type::kF32 && type != ir::Type::kF64;
}

/// `i = i;` of a variable of its own is a warning of some compilers; a signal's is a call of an operator.
bool KeepsALocal(const Emittable& emittable, const ir::Inst& store) {
  const ir::Inst& value = (*emittable.program)[ir::ValueId(store.a)];
  return value.op == ir::OpKind::kLoad && value.payload == store.payload && emittable.forms[store.a] != Form::kLocal &&
         emittable.layout.places[store.payload].storage == layout::Storage::kLocal;
}

/// A number of 32 bits that nobody writes but as a negative one. One of 16 bits may well be a large one.
bool IsNegative(const ir::Inst& inst) {
  constexpr uint64_t kLeast = 0xFFFF8000;
  return inst.op == ir::OpKind::kConst && inst.type == ir::Type::kI32 && inst.c != 16 &&
         ir::ConstantValue(inst) >= kLeast;
}

}  // namespace

void ChooseWordings(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  for (const ir::InstId id : PrintedInsts(program, emittable.options)) {
    const ir::Inst& inst = program[id];
    Wording& wording = emittable.wordings[id.index];
    if (inst.op == ir::OpKind::kBitNot && HasComplement(emittable, ir::ValueId(inst.a))) wording = Wording::kComplement;
    if (inst.op == ir::OpKind::kStore && KeepsALocal(emittable, inst)) wording = Wording::kDiscard;
    if (IsNegative(inst)) wording = Wording::kNegative;
    if (inst.op == ir::OpKind::kAdd32 && IsNegative(program[ir::ValueId(inst.b)])) wording = Wording::kSubtract;
  }
}

}  // namespace plcxx::emit::legalize
