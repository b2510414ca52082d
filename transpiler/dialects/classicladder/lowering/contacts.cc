#include "transpiler/dialects/classicladder/lowering/contacts.h"

namespace plcxx::classicladder {

using ir::OpKind;
using ir::ValueId;

void Contacts::Contact(uint32_t x, uint32_t y, const Element& element) {
  const bool edge = element.kind == ElementKind::kRising || element.kind == ElementKind::kFalling;
  const Signal left = grid_.Left(x, y);
  Signal state = Signal::Of(accesses_.ReadBit(element.variable));
  if (edge) {
    const OpKind step = element.kind == ElementKind::kRising ? OpKind::kRising : OpKind::kFalling;
    state = Signal::Of(builder_.Step(step, edges_.Of(element), {state.value}));
  } else if (element.kind == ElementKind::kContactNot) {
    state = logic_.Not(state);
  }
  grid_.Put(x, y, logic_.And(left, state));
}

void Contacts::Coil(uint32_t x, uint32_t y, const Element& element) {
  const Signal left = grid_.Left(x, y);
  if (element.kind == ElementKind::kCoil) return accesses_.WriteBit(element.variable, logic_.ToBit(left));
  if (element.kind == ElementKind::kCoilNot)
    return accesses_.WriteBit(element.variable, logic_.ToBit(logic_.Not(left)));
  const uint64_t value = element.kind == ElementKind::kSet ? 1 : 0;
  logic_.When(left, [&] { accesses_.WriteBit(element.variable, builder_.Bit(value)); });
}

}  // namespace plcxx::classicladder
