#include "transpiler/dialects/hnc/lowering/accesses.h"

#include <utility>

#include "transpiler/dialects/hnc/lowering/cell_places.h"
#include "transpiler/dialects/hnc/lowering/conversions.h"
#include "transpiler/dialects/hnc/lowering/faults.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/locals.h"
#include "transpiler/dialects/hnc/lowering/operators.h"
#include "transpiler/dialects/hnc/lowering/pointers.h"
#include "transpiler/dialects/hnc/lowering/stated_facts.h"
#include "transpiler/dialects/hnc/machine/machine.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

void Accesses::ReportIndex(ObjectId object, ExprId at) {
  const source::Range range = at.valid() ? ExprAt(at).range : statement_.range;
  const Object& target = objects_[object];
  if (target.size == 0) return;  // its declaration has been refused
  const std::string text(sources_.Text(range));
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

/// Whole strides of the constant part go into the index, so that index 0 is at the beginning of the object.
Accesses::Scaled Accesses::ScaledIn(int64_t size, const Address& address, int64_t bytes) {
  const int64_t stride = address.stride;
  Scaled scaled{.base = address.base, .strides = 0, .first = 0, .last = 0, .inside = false};
  if (scaled.base < 0 || scaled.base > size - bytes) {
    scaled.strides = scaled.base >= 0 ? scaled.base / stride : -((-scaled.base + stride - 1) / stride);
    scaled.base -= scaled.strides * stride;
  }
  scaled.first = -(scaled.base / stride);
  scaled.last = (size - bytes - scaled.base) / stride;
  const Bounds bounds{address.index_bounds.low + scaled.strides, address.index_bounds.high + scaled.strides};
  scaled.inside = bounds.Within({scaled.first, scaled.last});
  return scaled;
}

bool Accesses::IsInside(const Address& address, uint32_t bytes) const {
  if (address.targets.objects.empty() || bytes == 0 || address.stride == 0) return true;  // refused
  if (address.targets.objects.size() > 1 || address.is_null) return false;
  const auto size = static_cast<int64_t>(objects_[address.targets.objects.front()].size);
  if (!address.index.valid()) return address.base >= 0 && address.base + bytes <= size;
  return bytes <= size && ScaledIn(size, address, bytes).inside;
}

std::optional<Accesses::Reach> Accesses::ReachOf(ObjectId object, const Address& address, int64_t bytes, ExprId at) {
  const auto size = static_cast<int64_t>(objects_[object].size);
  if (!address.index.valid() && !address.is_null) {
    if (address.base >= 0 && address.base + bytes <= size)
      return Reach{.base = address.base, .index = {}, .outside = {}};
    // One of several is not this one then.
    if (address.targets.objects.size() == 1) ReportIndex(object, at);
    return std::nullopt;
  }
  if (bytes > size || address.is_null) return std::nullopt;
  const Scaled scaled = ScaledIn(size, address, bytes);
  Reach reach{.base = scaled.base, .index = address.index, .outside = {}};
  if (scaled.strides > 0)
    reach.index = Pure(OpKind::kAdd32, {reach.index, Long(static_cast<uint32_t>(scaled.strides))});
  if (scaled.strides < 0)
    reach.index = Pure(OpKind::kSub32, {reach.index, Long(static_cast<uint32_t>(-scaled.strides))});
  if (scaled.inside && !stated_.on()) return reach;
  const ValueId from_first =
      scaled.first == 0 ? reach.index : Pure(OpKind::kAdd32, {reach.index, Long(static_cast<uint32_t>(-scaled.first))});
  const ValueId most = Long(static_cast<uint32_t>(scaled.last - scaled.first));
  if (scaled.inside) {
    stated_.Check(ir::FactKind::kIndex, Pure(OpKind::kLessEqual32, {from_first, most}), reach.index);
  } else {
    reach.outside = Pure(OpKind::kGreater32, {from_first, most});
  }
  return reach;
}

void Accesses::RecordMiss(const Address& address) {
  const bool refused = !address.index.valid() && !address.is_null && address.targets.objects.size() == 1;
  if (!refused) faults_.Record(Fault::kIndex);
}

std::optional<Accesses::Access> Accesses::AccessTo(ObjectId object, const Address& address, ir::Type type, ExprId at,
                                                   IndexFault fault) {
  const std::optional<Reach> reach = ReachOf(object, address, ir::Bytes(type), at);
  if (!reach) {
    if (fault == IndexFault::kRecords) RecordMiss(address);
    return std::nullopt;
  }
  if (reach->outside.valid() && fault == IndexFault::kRecords) faults_.RecordWhen(reach->outside, Fault::kIndex);
  const auto base = static_cast<uint32_t>(reach->base);
  if (!reach->index.valid()) return Access{places_.At(object, base, type), {}};
  return Access{places_.IndexedAt(object, base, address.stride, type), reach->index};
}

void Accesses::InOne(const Address& address, uint32_t bytes, const std::function<void(const Address&)>& body) {
  ForEachTargetOf(address, IndexFault::kRecords, [&](ObjectId object) {
    Address one = address;
    one.targets.objects = {object};
    const std::optional<Reach> reach = ReachOf(object, address, bytes, {});
    if (!reach) {
      RecordMiss(address);
    } else if (!reach->outside.valid()) {
      body(one);
    } else {
      const ir::RegionId faulty = builder_.NewRegion(), inside = builder_.NewRegion();
      builder_.If(reach->outside, faulty, inside);
      builder_.Into(faulty, [&] { faults_.Record(Fault::kIndex); });
      builder_.Into(inside, [&] { body(one); });
    }
  });
}

void Accesses::ForEachTargetOf(const Address& address, IndexFault fault, const std::function<void(ObjectId)>& body) {
  if (address.targets.objects.size() == 1) {
    body(address.targets.objects.front());
    return;
  }
  ir::Switch arms;
  for (const ObjectId object : address.targets.objects) {
    builder_.AddArm(arms, {NumberOf(object)}, [&] { body(object); });
  }
  builder_.AddArm(arms, {}, [&] {
    if (fault == IndexFault::kRecords) faults_.Record(Fault::kIndex);
  });
  builder_.SwitchOn(pointers_.ObjectOf(address), std::move(arms));
}

ValueId Accesses::LoadAt(const Address& address, ir::Type type, ExprId at, IndexFault fault) {
  if (address.targets.objects.empty()) return builder_.Constant(type, 0);
  if (address.targets.objects.size() == 1) {
    const std::optional<Access> access = AccessTo(address.targets.objects.front(), address, type, at, fault);
    if (!access) return builder_.Constant(type, 0);
    return builder_.Load(access->place, access->index);
  }
  const ir::PlaceId kept = locals_.Add("found", type);
  builder_.Store(kept, builder_.Constant(type, 0));
  ForEachTargetOf(address, fault, [&](ObjectId object) {
    const std::optional<Access> access = AccessTo(object, address, type, at, fault);
    if (access) builder_.Store(kept, builder_.Load(access->place, access->index));
  });
  return builder_.Load(kept);
}

void Accesses::StoreAt(const Address& address, ir::Type type, ValueId value, ExprId at, IndexFault fault) {
  if (address.targets.objects.empty()) return;
  ForEachTargetOf(address, fault, [&](ObjectId object) {
    const std::optional<Access> access = AccessTo(object, address, type, at, fault);
    if (access) builder_.Store(access->place, value, access->index);
  });
}

Value Accesses::LoadBitField(const Lvalue& lvalue) {
  const Member& field = *lvalue.bit_field;
  const Type& type = TypeAt(field.type);
  const TypeId wide = unsigned_;  // its unit has 8 or 16 bits (5.6)
  const TypeId narrow = IntegerType(type.bits, false);
  const ValueId loaded = LoadAt(lvalue.address, IrType(field.type), lvalue.expr);
  Value unit = conversions_.ConvertInteger(conversions_.Make(loaded, narrow), wide);
  if (field.bit_offset != 0) {
    unit = operators_.BinaryInteger(BinaryOp::kShiftRight, unit, conversions_.Number(field.bit_offset, wide), Expr{});
  }
  return InBitField(unit, lvalue);
}

Value Accesses::InBitField(const Value& digits, const Lvalue& lvalue) {
  const Member& field = *lvalue.bit_field;
  const Type& type = TypeAt(field.type);
  const TypeId wide = unsigned_;  // its unit has 8 or 16 bits (5.6)
  const Expr nowhere;
  const int64_t mask = (int64_t{1} << field.bit_width) - 1;
  const Value all_ones = conversions_.Number(mask, wide, 16);
  const Value widened = conversions_.Convert(digits, wide);
  Value result = operators_.BinaryInteger(BinaryOp::kBitAnd, widened, all_ones, nowhere);
  if (type.is_signed) {
    // Its highest bit is the sign: (u ^ s) - s.
    const Value sign = conversions_.Number(int64_t{1} << (field.bit_width - 1), wide, 16);
    result = operators_.BinaryInteger(
        BinaryOp::kSubtract, operators_.BinaryInteger(BinaryOp::kBitXor, result, sign, nowhere), sign, nowhere);
    result.type = int_;
    result.bounds = BoundsOf(field.bit_width, true);
  }
  return conversions_.Convert(result, lvalue.type);
}

void Accesses::StoreBitField(const Lvalue& lvalue, const Value& value, IndexFault fault) {
  const Member& field = *lvalue.bit_field;
  const Type& type = TypeAt(field.type);
  const TypeId narrow = IntegerType(type.bits, false), wide = unsigned_;
  const Expr nowhere;
  const int64_t mask = ((int64_t{1} << field.bit_width) - 1) << field.bit_offset;
  const ValueId loaded = LoadAt(lvalue.address, IrType(field.type), lvalue.expr, fault);
  const Value unit = conversions_.ConvertInteger(conversions_.Make(loaded, narrow), wide);
  Value bits = conversions_.Convert(conversions_.Convert(value, lvalue.type), wide);
  if (field.bit_offset != 0)
    bits = operators_.BinaryInteger(BinaryOp::kShiftLeft, bits, conversions_.Number(field.bit_offset, wide), nowhere);
  bits = operators_.BinaryInteger(BinaryOp::kBitAnd, bits, conversions_.Number(mask, wide, 16), nowhere);
  const Value others = operators_.BinaryInteger(BinaryOp::kBitAnd, unit, conversions_.Number(~mask, wide, 16), nowhere);
  const Value all = operators_.BinaryInteger(BinaryOp::kBitOr, others, bits, nowhere);
  // The load has said whether the unit is inside of its object; an assignment has one fault, not two.
  StoreAt(lvalue.address, IrType(field.type), conversions_.ConvertInteger(all, narrow).id, lvalue.expr,
          IndexFault::kRecorded);
}

void Accesses::CheckAssigned(VariableId id, ExprId at) {
  if (unit_.faulty || !flow_.unassigned.contains(id) || !read_unassigned_.insert(id.index).second) return;
  diagnostics_.Report(ExprAt(at).range, diag::HncReadBeforeWrite, unit_.variables[id].name);
}

Value Accesses::Load(const Lvalue& lvalue) {
  if (lvalue.bit_field != nullptr) return LoadBitField(lvalue);
  const Type& type = TypeAt(lvalue.type);
  if (!IsArithmetic(type)) return conversions_.Zero(int_);
  if (lvalue.local.valid()) {
    CheckAssigned(lvalue.local, lvalue.expr);
    Value value = conversions_.Make(builder_.Load(placement_.locals[lvalue.local.index]), lvalue.type);
    if (IsInteger(type)) {
      const std::optional<Bounds> known = flow_.Find(*intervals_.CellOf(lvalue));
      if (known && known->Within(value.bounds)) value.bounds = *known;
      stated_.CheckBounds(ir::FactKind::kVariable, value);
    }
    return value;
  }
  Value value = conversions_.Make(LoadAt(lvalue.address, IrType(lvalue.type), lvalue.expr), lvalue.type);
  const std::optional<Cell> cell = intervals_.CellOf(lvalue);
  if (cell && IsInteger(type)) {
    const std::optional<Bounds> known = flow_.FindTested(*cell);
    if (known && known->Within(value.bounds)) value.bounds = *known;
    stated_.CheckBounds(ir::FactKind::kVariable, value);
  }
  return value;
}

void Accesses::Store(const Lvalue& lvalue, const Value& value, IndexFault fault) {
  if (!IsArithmetic(TypeAt(lvalue.type))) return;
  if (lvalue.bit_field != nullptr) {
    StoreBitField(lvalue, value, fault);
  } else if (lvalue.local.valid()) {
    builder_.Store(placement_.locals[lvalue.local.index], value.id);
  } else {
    StoreAt(lvalue.address, IrType(lvalue.type), value.id, lvalue.expr, fault);
  }
  intervals_.NoteStore(lvalue, value);
}

}  // namespace plcxx::hnc
