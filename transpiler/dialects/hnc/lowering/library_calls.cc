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

/// From the last argument to the first.
LibraryCalls::MemoryOperands LibraryCalls::EvaluateOperands(const Expr& expr) {
  MemoryOperands operands{.function = *unit_.functions[expr.function].system};
  operands.wanted = conversions_.AsIndex(conversions_.Convert(expressions_.Evaluate(expr.arguments[2]), unsigned_));
  if (operands.sets()) {
    operands.byte = conversions_.Narrow8(
        conversions_.ConvertInteger(conversions_.Convert(expressions_.Evaluate(expr.arguments[1]), int_), int_).id);
  } else {
    operands.from = addresses_.EvaluatePointer(expr.arguments[1]);
  }
  operands.to = addresses_.EvaluatePointer(expr.arguments[0]);
  return operands;
}

bool LibraryCalls::CheckTargets(const Expr& expr, const MemoryOperands& operands) {
  const auto check = [&](const Address& address, ExprId named) {
    if (!address.targets.objects.empty() && address.targets.objects.size() <= kMostTargets) return true;
    diagnostics_.Report(
        ExprAt(named).range, diag::HncPointerObject,
        "'" + std::string(sources_.Text(ExprAt(named).range)) + "' " + std::string(Pointers::WhyRefused(address)));
    return false;
  };
  return check(operands.to, expr.arguments[0]) && (operands.sets() || check(operands.from, expr.arguments[1]));
}

/// The length that is asked for, clipped to the objects (6.11); a fault where it is.
ValueId LibraryCalls::ClippedLength(const MemoryOperands& operands) {
  const auto is_constant = [this](ValueId value) { return program_[value].op == OpKind::kConst; };
  const auto shorter = [&](ValueId a, ValueId b) {
    if (is_constant(a) && is_constant(b)) return program_[a].a <= program_[b].a ? a : b;
    return Pure(OpKind::kSelect32, {Pure(OpKind::kGreater32, {a, b}), b, a});
  };
  const ValueId wanted = operands.wanted;
  ValueId length = shorter(wanted, RoomBehind(operands.to));
  if (!operands.sets()) length = shorter(length, RoomBehind(operands.from));
  if (is_constant(length) && is_constant(wanted)) {
    if (program_[length].a != program_[wanted].a) faults_.Record(Fault::kIndex);
  } else {
    faults_.RecordWhen(Pure(OpKind::kNotEqual32, {length, wanted}), Fault::kIndex);
  }
  return length;
}

ir::PlaceId LibraryCalls::Keep(std::string name, ValueId value) {
  const ir::PlaceId place = locals_.Add(std::move(name), program_[value].type);
  builder_.Store(place, value);
  return place;
}

std::function<Address()> LibraryCalls::KeepAddress(std::string name, const Address& address) {
  const ir::PlaceId offset = Keep(std::move(name), pointers_.OffsetOf(address));
  const ir::PlaceId object = address.object.valid() ? Keep("object", address.object) : ir::PlaceId();
  return [this, targets = address.targets, offset, object] {
    Address again;
    again.targets = targets;
    again.index = builder_.Load(offset);
    if (object.valid()) again.object = builder_.Load(object);
    return again;
  };
}

LibraryCalls::KeptOperands LibraryCalls::KeepOperands(const MemoryOperands& operands) {
  KeptOperands kept;
  kept.count = Keep("length", ClippedLength(operands));
  kept.at = locals_.Add("at", ir::Type::kI32);
  kept.target = KeepAddress("to", operands.to);
  kept.source = KeepAddress("from", operands.sets() ? operands.to : operands.from);
  if (operands.sets()) kept.byte = Keep("byte", operands.byte);
  if (operands.compares()) {
    kept.difference = locals_.Add("difference", ir::Type::kI16);
    builder_.Store(kept.difference, Word(0));
  }
  // From the end when the target lies after the source.
  if (operands.moves()) {
    kept.backward = locals_.Add("backward", ir::Type::kBit);
    builder_.Store(kept.backward,
                   Pure(OpKind::kGreater32, {pointers_.OffsetOf(kept.target()), pointers_.OffsetOf(kept.source())}));
  }
  return kept;
}

/// Which byte it is this time.
ValueId LibraryCalls::Position(const KeptOperands& kept) {
  const ValueId forward = builder_.Load(kept.at);
  if (!kept.backward.valid()) return forward;
  const ValueId last = Pure(OpKind::kSub32, {builder_.Load(kept.count), Long(1)});
  return Pure(OpKind::kSelect32, {builder_.Load(kept.backward), Pure(OpKind::kSub32, {last, forward}), forward});
}

void LibraryCalls::DoOneByte(const KeptOperands& kept) {
  const ExprId own = {};
  const auto at_position = [&](const std::function<Address()>& pointer) {
    const ValueId counter = Position(kept);
    return At(pointer(), counter);
  };
  if (kept.difference.valid()) {
    const ValueId a = accesses_.LoadAt(at_position(kept.target), ir::Type::kI8, own);
    const ir::PlaceId first = Keep("first", a);
    const ValueId b = accesses_.LoadAt(at_position(kept.source), ir::Type::kI8, own);
    builder_.Store(kept.difference, Pure(OpKind::kSub16, {Pure(OpKind::kWiden8To16, {builder_.Load(first)}),
                                                          Pure(OpKind::kWiden8To16, {b})}));
  } else {
    const ValueId moved =
        kept.byte.valid() ? builder_.Load(kept.byte) : accesses_.LoadAt(at_position(kept.source), ir::Type::kI8, own);
    accesses_.StoreAt(at_position(kept.target), ir::Type::kI8, moved, own);
  }
}

void LibraryCalls::DoEachByte(const KeptOperands& kept) {
  builder_.Store(kept.at, Long(0));
  const ir::Loop loop{.kind = ir::LoopBound::kProven,
                      .bound = 65535,
                      .budget = {},
                      .condition = builder_.NewRegion(),
                      .body = builder_.NewRegion(),
                      .step = builder_.NewRegion(),
                      .exhausted = {}};
  const ir::RegionId after = builder_.region();
  builder_.SetRegion(loop.condition);
  const ValueId more = Pure(OpKind::kLess32, {builder_.Load(kept.at), builder_.Load(kept.count)});
  if (kept.difference.valid())
    Pure(OpKind::kBitAnd, {more, Pure(OpKind::kEqual16, {builder_.Load(kept.difference), Word(0)})});
  builder_.SetRegion(loop.body);
  DoOneByte(kept);
  builder_.SetRegion(loop.step);
  builder_.Store(kept.at, Pure(OpKind::kAdd32, {builder_.Load(kept.at), Long(1)}));
  builder_.SetRegion(after);
  builder_.LoopWith(loop);
}

CallResult LibraryCalls::MemoryFunction(const Expr& expr) {
  const MemoryOperands operands = EvaluateOperands(expr);
  CallResult result;
  result.address = operands.to;
  if (operands.compares()) result = {.value = conversions_.Zero(int_), .address = {}};
  if (!CheckTargets(expr, operands)) return result;
  // Kept in locals: what follows has regions of its own.
  const KeptOperands kept = KeepOperands(operands);
  DoEachByte(kept);
  intervals_.ForgetAfterCall(expr);
  if (operands.compares()) {
    result.value = conversions_.Make(builder_.Load(kept.difference), int_);
    return result;
  }
  Address again = kept.target();
  again.index_bounds = {-0x80000000LL, 0x7FFFFFFF};
  result.address = again;
  return result;
}

}  // namespace plcxx::hnc
