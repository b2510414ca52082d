// Loads and stores: named locals, cells at constant places, indexed places with the fault of 6.9 beside them where the
// bounds of the index do not show that it stays inside.

#include <utility>

#include "transpiler/dialects/hnc/lowering_internal.h"
#include "transpiler/dialects/hnc/machine.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

void Lowering::ReportIndex(ObjectId object, int64_t offset, uint32_t bytes, ExprId at) {
  const source::Range range = at.valid() ? ExprAt(at).range : statement_range_;
  const Object& target = objects_[object];
  const std::string text(sources_.Text(range));
  static_cast<void>(offset);
  static_cast<void>(bytes);
  // As the program counts it: P[k] is a word.
  const bool words =
      target.kind == ObjectKind::kArea && RowOf(static_cast<Area>(target.index)).basic != "unsigned char";
  const bool variable = target.kind == ObjectKind::kVariable;
  const Type* type = variable ? &unit_.types[unit_.variables[VariableId(target.index)].type] : nullptr;
  const bool array = type != nullptr && type->kind == TypeKind::kArray && type->count != 0;
  diagnostics_.Report(range, diag::HncIndexOf,
                      text + " is outside of " + target.name + ", which has " +
                          std::to_string(array   ? type->count
                                         : words ? target.size / 2
                                                 : target.size) +
                          (array   ? " elements"
                           : words ? " words"
                                   : " bytes"));
}

std::optional<Lowering::Access> Lowering::AccessTo(ObjectId object, const Address& address, ir::Type type, ExprId at) {
  const auto size = static_cast<int64_t>(objects_[object].size);
  const auto bytes = static_cast<int64_t>(ir::Bytes(type));
  const int64_t stride = address.stride;
  if (!address.index.valid() && !address.is_null) {
    if (address.base >= 0 && address.base + bytes <= size) {
      return Access{PlaceAt(object, static_cast<uint32_t>(address.base), type), {}};
    }
    if (address.targets.objects.size() > 1) {  // one of several, and not this one then
      RecordFault(Fault::kIndex);
      return std::nullopt;
    }
    ReportIndex(object, address.base, static_cast<uint32_t>(bytes), at);
    return std::nullopt;
  }
  if (bytes > size || address.is_null) {
    RecordFault(Fault::kIndex);
    return std::nullopt;
  }
  // Whole strides of the constant part go into the index, so that index 0 is at the beginning of the object.
  int64_t base = address.base;
  ValueId index = address.index;
  Bounds bounds = address.index_bounds;
  if (base < 0 || base > size - bytes) {
    const int64_t strides = base >= 0 ? base / stride : -((-base + stride - 1) / stride);
    index = strides >= 0 ? Pure(OpKind::kAdd32, {index, Long(static_cast<uint32_t>(strides))})
                         : Pure(OpKind::kSub32, {index, Long(static_cast<uint32_t>(-strides))});
    bounds = {bounds.low + strides, bounds.high + strides};
    base -= strides * stride;
  }
  const int64_t first = -(base / stride), last = (size - bytes - base) / stride;
  const bool inside = bounds.Within({first, last});
  if (!inside || facts_stated_.on()) {
    const ValueId from_first = first == 0 ? index : Pure(OpKind::kAdd32, {index, Long(static_cast<uint32_t>(-first))});
    const ValueId most = Long(static_cast<uint32_t>(last - first));
    if (inside) {
      Check(ir::FactKind::kIndex, Pure(OpKind::kLessEqual32, {from_first, most}), index);
    } else {
      FaultWhen(Pure(OpKind::kGreater32, {from_first, most}), Fault::kIndex);
    }
  }
  return Access{IndexedPlaceAt(object, static_cast<uint32_t>(base), address.stride, type), index};
}

void Lowering::ForEachTargetOf(const Address& address, const std::function<void(ObjectId)>& body) {
  if (address.targets.objects.size() == 1) {
    body(address.targets.objects.front());
    return;
  }
  ir::Switch arms;
  for (const ObjectId object : address.targets.objects) {
    builder_.AddArm(arms, {NumberOf(object)}, [&] { body(object); });
  }
  builder_.AddArm(arms, {}, [&] { RecordFault(Fault::kIndex); });
  builder_.SwitchOn(ObjectOf(address), std::move(arms));
}

ValueId Lowering::LoadAt(const Address& address, ir::Type type, ExprId at) {
  if (address.targets.objects.empty()) return builder_.Constant(type, 0);
  if (address.targets.objects.size() == 1) {
    const std::optional<Access> access = AccessTo(address.targets.objects.front(), address, type, at);
    if (!access) return builder_.Constant(type, 0);
    return builder_.Load(access->place, access->index);
  }
  const ir::PlaceId kept = AddLocal("found", type);
  builder_.Store(kept, builder_.Constant(type, 0));
  ForEachTargetOf(address, [&](ObjectId object) {
    const std::optional<Access> access = AccessTo(object, address, type, at);
    if (access) builder_.Store(kept, builder_.Load(access->place, access->index));
  });
  return builder_.Load(kept);
}

void Lowering::StoreAt(const Address& address, ir::Type type, ValueId value, ExprId at) {
  if (address.targets.objects.empty()) return;
  ForEachTargetOf(address, [&](ObjectId object) {
    const std::optional<Access> access = AccessTo(object, address, type, at);
    if (access) builder_.Store(access->place, value, access->index);
  });
}

std::optional<Cell> Lowering::CellOf(const Lvalue& lvalue) const {
  if (lvalue.bit_field != nullptr) return std::nullopt;
  if (lvalue.local.valid()) return Cell{objects_.OfVariable(lvalue.local), 0, TypeAt(lvalue.type).size};
  if (lvalue.address.targets.objects.size() != 1 || lvalue.address.index.valid()) return std::nullopt;
  return Cell{lvalue.address.targets.objects.front(), lvalue.address.base, TypeAt(lvalue.type).size};
}

Value Lowering::LoadBitField(const Lvalue& lvalue) {
  const Member& field = *lvalue.bit_field;
  const Type& type = TypeAt(field.type);
  const TypeId wide = unsigned_;  // its unit has 8 or 16 bits (5.6)
  Value unit = ConvertInteger(
      Make(LoadAt(lvalue.address, IrType(field.type), lvalue.expr), IntegerType(type.bits, false)), wide);
  if (field.bit_offset != 0) {
    unit = BinaryInteger(BinaryOp::kShiftRight, unit, Number(field.bit_offset, wide), Expr{});
  }
  return InBitField(unit, lvalue);
}

Value Lowering::InBitField(const Value& digits, const Lvalue& lvalue) {
  const Member& field = *lvalue.bit_field;
  const Type& type = TypeAt(field.type);
  const TypeId wide = unsigned_;  // its unit has 8 or 16 bits (5.6)
  const Expr nowhere;
  const int64_t mask = (int64_t{1} << field.bit_width) - 1;
  Value result = BinaryInteger(BinaryOp::kBitAnd, Convert(digits, wide), Number(mask, wide, 16), nowhere);
  if (type.is_signed) {
    // Its highest bit is the sign: (u ^ s) - s.
    const Value sign = Number(int64_t{1} << (field.bit_width - 1), wide, 16);
    result = BinaryInteger(BinaryOp::kSubtract, BinaryInteger(BinaryOp::kBitXor, result, sign, nowhere), sign, nowhere);
    result.type = int_;
    result.bounds = {-(int64_t{1} << (field.bit_width - 1)), (int64_t{1} << (field.bit_width - 1)) - 1};
  }
  return Convert(result, lvalue.type);
}

void Lowering::StoreBitField(const Lvalue& lvalue, const Value& value) {
  const Member& field = *lvalue.bit_field;
  const Type& type = TypeAt(field.type);
  const TypeId narrow = IntegerType(type.bits, false), wide = unsigned_;
  const Expr nowhere;
  const int64_t mask = ((int64_t{1} << field.bit_width) - 1) << field.bit_offset;
  const Value unit = ConvertInteger(Make(LoadAt(lvalue.address, IrType(field.type), lvalue.expr), narrow), wide);
  Value bits = Convert(Convert(value, lvalue.type), wide);
  if (field.bit_offset != 0) bits = BinaryInteger(BinaryOp::kShiftLeft, bits, Number(field.bit_offset, wide), nowhere);
  bits = BinaryInteger(BinaryOp::kBitAnd, bits, Number(mask, wide, 16), nowhere);
  const Value others = BinaryInteger(BinaryOp::kBitAnd, unit, Number(~mask, wide, 16), nowhere);
  const Value all = BinaryInteger(BinaryOp::kBitOr, others, bits, nowhere);
  // The load has said whether the unit is inside of its object; an assignment has one fault, not two.
  const bool was_checked = std::exchange(index_is_checked_, true);
  StoreAt(lvalue.address, IrType(field.type), ConvertInteger(all, narrow).id, lvalue.expr);
  index_is_checked_ = was_checked;
}

/// W4, once for each variable.
void Lowering::CheckAssigned(VariableId id, ExprId at) {
  if (!flow_.unassigned.contains(id) || !read_unassigned_.insert(id.index).second) return;
  diagnostics_.Report(ExprAt(at).range, diag::HncReadBeforeWrite, unit_.variables[id].name);
}

Value Lowering::Load(const Lvalue& lvalue) {
  if (lvalue.bit_field != nullptr) return LoadBitField(lvalue);
  const Type& type = TypeAt(lvalue.type);
  if (!IsArithmetic(type)) return Zero(int_);
  if (lvalue.local.valid()) {
    CheckAssigned(lvalue.local, lvalue.expr);
    Value value = Make(builder_.Load(local_places_[lvalue.local.index]), lvalue.type);
    if (IsInteger(type)) {
      const std::optional<Bounds> known = flow_.Find(*CellOf(lvalue));
      if (known && known->Within(value.bounds)) value.bounds = *known;
      CheckBounds(ir::FactKind::kVariable, value);
    }
    return value;
  }
  Value value = Make(LoadAt(lvalue.address, IrType(lvalue.type), lvalue.expr), lvalue.type);
  const std::optional<Cell> cell = CellOf(lvalue);
  if (cell && IsInteger(type)) {
    const std::optional<Bounds> known = flow_.FindTested(*cell);
    if (known && known->Within(value.bounds)) value.bounds = *known;
    CheckBounds(ir::FactKind::kVariable, value);
  }
  return value;
}

/// What was known of the bytes is no longer; what is known of the value is.
void Lowering::NoteStore(const Lvalue& lvalue, const Value& value) {
  if (lvalue.local.valid()) flow_.unassigned.erase(lvalue.local);
  const std::optional<Cell> cell = CellOf(lvalue);
  if (!cell) {
    for (const ObjectId object : lvalue.address.targets.objects) flow_.Forget(object);
    return;
  }
  flow_.Forget(*cell);
  const Type& type = TypeAt(lvalue.type);
  if (!IsInteger(type) || value.bounds == BoundsOf(type)) return;
  flow_.Learn(*cell, value.bounds, lvalue.local.valid() ? Origin::kTested : Origin::kStored);
}

void Lowering::Store(const Lvalue& lvalue, const Value& value) {
  if (!IsArithmetic(TypeAt(lvalue.type))) return;
  if (lvalue.bit_field != nullptr) {
    StoreBitField(lvalue, value);
  } else if (lvalue.local.valid()) {
    builder_.Store(local_places_[lvalue.local.index], value.id);
  } else {
    StoreAt(lvalue.address, IrType(lvalue.type), value.id, lvalue.expr);
  }
  NoteStore(lvalue, value);
}

}  // namespace plcxx::hnc
