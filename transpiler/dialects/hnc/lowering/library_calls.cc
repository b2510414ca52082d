#include "transpiler/dialects/hnc/lowering/library_calls.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering/accesses.h"
#include "transpiler/dialects/hnc/lowering/addresses.h"
#include "transpiler/dialects/hnc/lowering/conversions.h"
#include "transpiler/dialects/hnc/lowering/expressions.h"
#include "transpiler/dialects/hnc/lowering/faults.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/locals.h"
#include "transpiler/dialects/hnc/lowering/pointers.h"
#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/support/check.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

CallResult LibraryCalls::Call(const Expr& expr) {
  const FunctionRow& row = RowOf(*unit_.functions[expr.function].system);
  const auto argument = [&](size_t i) { return expr.arguments[i]; };
  CallResult result;
  switch (row.form) {
    case FunctionForm::kControl:
      PLCXX_UNREACHABLE();  // system_calls.h
    case FunctionForm::kAbsolute: {
      const Value value = expressions_.Evaluate(argument(0));
      // With abs=long the parameter may be unsigned or double (headers.cc).
      const Value number = conversions_.Convert(value, *row.operation == OpKind::kAbs32 ? long_ : int_);
      Value absolute = conversions_.Make(Pure(*row.operation, {number.id}), number.type);
      absolute.bounds = AbsoluteOf(number.bounds, TypeAt(number.type));
      result.value = absolute;
      break;
    }
    case FunctionForm::kRotation: {
      const ValueId count = conversions_.AsIndex(expressions_.Evaluate(argument(1)));
      const Value value = expressions_.Evaluate(argument(0));
      const bool wide = *row.operation == OpKind::kRotateLeft32 || *row.operation == OpKind::kRotateRight32;
      const TypeId type = wide ? unsigned_long_ : unsigned_;
      result.value = conversions_.Make(Pure(*row.operation, {conversions_.Convert(value, type).id, count}), type);
      break;
    }
    case FunctionForm::kReal: {
      const Value value = conversions_.Convert(expressions_.Evaluate(argument(0)), double_);
      result.value = conversions_.Make(Pure(*row.operation, {value.id}), double_);
      break;
    }
    case FunctionForm::kMemory:
      return MemoryFunction(expr);
    case FunctionForm::kCritical:
      break;
  }
  return result;
}

/// The bytes that are left of the object after the address, 0 when it is outside; an i32.
ValueId LibraryCalls::RoomBehind(const Address& address) {
  const ValueId offset = pointers_.OffsetOf(address);
  const auto room_in = [&](ObjectId object) {
    const auto size = static_cast<uint32_t>(objects_[object].size);
    if (!address.index.valid() && !address.is_null) {
      const bool inside = address.base >= 0 && address.base <= size;
      return Long(inside ? size - static_cast<uint32_t>(address.base) : 0);
    }
    const ValueId outside = Pure(OpKind::kGreater32, {offset, Long(size)});
    return Pure(OpKind::kSelect32, {outside, Long(0), Pure(OpKind::kSub32, {Long(size), offset})});
  };
  if (address.targets.objects.size() == 1) return room_in(address.targets.objects.front());
  const ir::PlaceId room = locals_.Add("room", ir::Type::kI32);
  builder_.Store(room, Long(0));
  accesses_.ForEachTargetOf(address, IndexFault::kRecords,
                            [&](ObjectId object) { builder_.Store(room, room_in(object)); });
  return builder_.Load(room);
}

/// An address that moves with a counter known to stay inside.
Address LibraryCalls::At(const Address& address, ValueId counter) {
  Address moved = address;
  moved.base = 0;
  moved.stride = 1;
  const ValueId offset = pointers_.OffsetOf(address);
  moved.index = Pure(OpKind::kAdd32, {offset, counter});
  moved.index_bounds = {0, 0};
  return moved;
}

CallResult LibraryCalls::MemoryFunction(const Expr& expr) {
  const SystemFunction function = *unit_.functions[expr.function].system;
  const bool compares = function == SystemFunction::kMemcmp, sets = function == SystemFunction::kMemset;
  const ExprId own = {};
  const ValueId wanted =
      conversions_.AsIndex(conversions_.Convert(expressions_.Evaluate(expr.arguments[2]), unsigned_));
  Address from;
  ValueId byte;
  if (sets) {
    byte = conversions_.Narrow8(
        conversions_.ConvertInteger(conversions_.Convert(expressions_.Evaluate(expr.arguments[1]), int_), int_).id);
  } else {
    from = addresses_.EvaluatePointer(expr.arguments[1]);
  }
  const Address to = addresses_.EvaluatePointer(expr.arguments[0]);
  CallResult result;
  result.address = to;
  if (compares) result = {.value = conversions_.Zero(int_), .address = {}};
  for (const Address* address : {&to, sets ? &to : &from}) {
    if (!address->targets.objects.empty() && address->targets.objects.size() <= kMostTargets) continue;
    const ExprId named = expr.arguments[address == &to ? 0 : 1];
    diagnostics_.Report(
        ExprAt(named).range, diag::HncPointerObject,
        "'" + std::string(sources_.Text(ExprAt(named).range)) + "' " + std::string(Pointers::WhyRefused(*address)));
    return result;
  }
  // Kept in locals: what follows has regions of its own.
  const auto keep = [&](std::string name, ValueId value) {
    const ir::PlaceId place = locals_.Add(std::move(name), program_[value].type);
    builder_.Store(place, value);
    return place;
  };
  const auto is_constant = [this](ValueId value) { return program_[value].op == OpKind::kConst; };
  const auto shorter = [&](ValueId a, ValueId b) {
    if (is_constant(a) && is_constant(b)) return program_[a].a <= program_[b].a ? a : b;
    return Pure(OpKind::kSelect32, {Pure(OpKind::kGreater32, {a, b}), b, a});
  };
  ValueId length = shorter(wanted, RoomBehind(to));
  if (!sets) length = shorter(length, RoomBehind(from));
  if (is_constant(length) && is_constant(wanted)) {
    if (program_[length].a != program_[wanted].a) faults_.Record(Fault::kIndex);
  } else {
    faults_.RecordWhen(Pure(OpKind::kNotEqual32, {length, wanted}), Fault::kIndex);
  }
  const ir::PlaceId count = keep("length", length), at = locals_.Add("at", ir::Type::kI32);
  const auto kept = [&](const Address& address, std::string name) {
    const ir::PlaceId offset = keep(std::move(name), pointers_.OffsetOf(address));
    const ir::PlaceId object = address.object.valid() ? keep("object", address.object) : ir::PlaceId();
    return [this, address, offset, object] {
      Address again;
      again.targets = address.targets;
      again.index = builder_.Load(offset);
      if (object.valid()) again.object = builder_.Load(object);
      return again;
    };
  };
  const auto target = kept(to, "to"), source = kept(sets ? to : from, "from");
  const ir::PlaceId value = sets ? keep("byte", byte) : ir::PlaceId();
  const ir::PlaceId difference = compares ? locals_.Add("difference", ir::Type::kI16) : ir::PlaceId();
  if (compares) builder_.Store(difference, Word(0));
  // memmove: from the end when the target lies after the source.
  const bool moves = function == SystemFunction::kMemmove;
  const ir::PlaceId backward = moves ? locals_.Add("backward", ir::Type::kBit) : ir::PlaceId();
  if (moves)
    builder_.Store(backward, Pure(OpKind::kGreater32, {pointers_.OffsetOf(target()), pointers_.OffsetOf(source())}));
  builder_.Store(at, Long(0));
  ir::Loop loop{.kind = ir::LoopBound::kProven,
                .bound = 65535,
                .budget = {},
                .condition = builder_.NewRegion(),
                .body = builder_.NewRegion(),
                .step = builder_.NewRegion(),
                .exhausted = {}};
  const ir::RegionId behind = builder_.region();
  builder_.SetRegion(loop.condition);
  ValueId more = Pure(OpKind::kLess32, {builder_.Load(at), builder_.Load(count)});
  if (compares) more = Pure(OpKind::kBitAnd, {more, Pure(OpKind::kEqual16, {builder_.Load(difference), Word(0)})});
  builder_.SetRegion(loop.body);
  const auto position = [&] {
    const ValueId forward = builder_.Load(at);
    if (!moves) return forward;
    const ValueId last = Pure(OpKind::kSub32, {builder_.Load(count), Long(1)});
    return Pure(OpKind::kSelect32, {builder_.Load(backward), Pure(OpKind::kSub32, {last, forward}), forward});
  };
  const auto at_position = [&](const auto& pointer) {
    const ValueId counter = position();
    return At(pointer(), counter);
  };
  if (compares) {
    const ValueId a = accesses_.LoadAt(at_position(target), ir::Type::kI8, own);
    const ir::PlaceId first = keep("first", a);
    const ValueId b = accesses_.LoadAt(at_position(source), ir::Type::kI8, own);
    builder_.Store(difference, Pure(OpKind::kSub16, {Pure(OpKind::kWiden8To16, {builder_.Load(first)}),
                                                     Pure(OpKind::kWiden8To16, {b})}));
  } else {
    const ValueId moved = sets ? builder_.Load(value) : accesses_.LoadAt(at_position(source), ir::Type::kI8, own);
    accesses_.StoreAt(at_position(target), ir::Type::kI8, moved, own);
  }
  builder_.SetRegion(loop.step);
  builder_.Store(at, Pure(OpKind::kAdd32, {builder_.Load(at), Long(1)}));
  builder_.SetRegion(behind);
  builder_.LoopWith(loop);
  intervals_.ForgetAfterCall(expr);
  if (compares) result.value = conversions_.Make(builder_.Load(difference), int_);
  if (!compares) {
    Address again = target();
    again.index_bounds = {-0x80000000LL, 0x7FFFFFFF};
    result.address = again;
  }
  return result;
}

}  // namespace plcxx::hnc
