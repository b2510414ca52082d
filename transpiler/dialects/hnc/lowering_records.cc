// Structures as values (specification 5.5, 6.8), addresses that a condition chooses, and the result of a function that
// gives none.

#include "transpiler/dialects/hnc/lowering_internal.h"
#include "transpiler/support/check.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

/// Bytes of a record, as far as possible in double words.
template <class Visit>
void ForEachPiece(uint32_t size, const Visit& visit) {
  for (uint32_t at = 0; at < size;) {
    const ir::Type width = size - at >= 4 ? ir::Type::kI32 : size - at >= 2 ? ir::Type::kI16 : ir::Type::kI8;
    visit(at, width);
    at += ir::Bytes(width);
  }
}

Address Behind(const Address& address, uint32_t bytes) {
  Address part = address;
  part.base += bytes;
  return part;
}

}  // namespace

void Lowering::AssignRecord(const Address& to, const Address& from, TypeId type) {
  ForEachPiece(TypeAt(type).size, [&](uint32_t at, ir::Type width) {
    StoreAt(Behind(to, at), width, LoadAt(Behind(from, at), width, {}), {});
  });
}

std::vector<ValueId> Lowering::LoadRecord(const Address& from, TypeId type) {
  std::vector<ValueId> pieces;
  ForEachPiece(TypeAt(type).size,
               [&](uint32_t at, ir::Type width) { pieces.push_back(LoadAt(Behind(from, at), width, {})); });
  return pieces;
}

void Lowering::StoreRecord(const Address& to, const std::vector<ValueId>& pieces, TypeId type) {
  size_t next = 0;
  ForEachPiece(TypeAt(type).size,
               [&](uint32_t at, ir::Type width) { StoreAt(Behind(to, at), width, pieces[next++], {}); });
}

Address Lowering::RecordAddress(ExprId id) {
  const Expr& expr = ExprAt(id);
  switch (expr.kind) {
    case ExprKind::kLoad:
      return RecordAddress(expr.a);
    case ExprKind::kAssign: {
      const Address from = RecordAddress(expr.b);
      // What chooses the target may change what is assigned: another call of the function that gave it, for instance.
      const bool keeps = HasEffects(expr.a);
      const std::vector<ValueId> pieces = keeps ? LoadRecord(from, expr.type) : std::vector<ValueId>();
      const Address to = EvaluateLvalue(expr.a).address;
      if (keeps) {
        StoreRecord(to, pieces, expr.type);
      } else {
        AssignRecord(to, from, expr.type);
      }
      for (const ObjectId object : to.targets.objects) flow_.Forget(object);
      return to;
    }
    case ExprKind::kComma:
      Execute(expr.a);
      return RecordAddress(expr.b);
    case ExprKind::kCall: {
      const CallResult result = Call(id);
      return result.address ? *result.address : Address{};
    }
    case ExprKind::kConditional:
      return ConditionalAddress(expr, &Lowering::RecordAddress);
    case ExprKind::kVariable:
    case ExprKind::kIndex:
    case ExprKind::kDereference:
    case ExprKind::kMember:
      return EvaluateLvalue(id).address;
    case ExprKind::kPoison:
    case ExprKind::kConstant:
    case ExprKind::kString:
    case ExprKind::kFunction:
    case ExprKind::kDecay:
    case ExprKind::kConvert:
    case ExprKind::kCast:
    case ExprKind::kNull:
    case ExprKind::kUnary:
    case ExprKind::kBinary:
    case ExprKind::kAnd:
    case ExprKind::kOr:
    case ExprKind::kCompoundAssign:
    case ExprKind::kIncrement:
    case ExprKind::kAddress: {
      Address refused;
      refused.reported = true;
      return refused;
    }
  }
  PLCXX_UNREACHABLE();
}

Address Lowering::SelectAddress(ValueId condition, const Address& a, const Address& b) {
  Address chosen;
  chosen.targets = a.targets;
  chosen.targets.Add(b.targets);
  chosen.index = Pure(OpKind::kSelect32, {condition, OffsetOf(a), OffsetOf(b)});
  chosen.index_bounds = kAnyOffset;
  if (chosen.targets.objects.size() > 1) chosen.object = Pure(OpKind::kSelect16, {condition, ObjectOf(a), ObjectOf(b)});
  return chosen;
}

/// Of the arms only the one that is chosen is executed, where they do more than compute.
Address Lowering::ConditionalAddress(const Expr& expr, Address (Lowering::*evaluate)(ExprId)) {
  const ValueId condition = Condition(expr.a);
  if (IsSimple(expr.b) && IsSimple(expr.c)) {
    const Address then = (this->*evaluate)(expr.b);
    return SelectAddress(condition, then, (this->*evaluate)(expr.c));
  }
  const ir::PlaceId offset = AddLocal("chosen", ir::Type::kI32), object = AddLocal("chosen_object", ir::Type::kI16);
  Address chosen;
  const auto keep = [&](ExprId arm) {
    const Address address = (this->*evaluate)(arm);
    chosen.targets.Add(address.targets);
    chosen.reported = chosen.reported || address.reported;
    builder_.Store(offset, OffsetOf(address));
    builder_.Store(object, ObjectOf(address));
  };
  const Flow before = flow_;
  Flow then;
  builder_.Choose(
      condition,
      [&] {
        Refine(expr.a, true);
        keep(expr.b);
        then = flow_;
      },
      [&] {
        flow_ = before;
        Refine(expr.a, false);
        keep(expr.c);
      });
  flow_.JoinWith(then);
  chosen.index = builder_.Load(offset);
  chosen.index_bounds = kAnyOffset;
  if (chosen.targets.objects.size() > 1) chosen.object = builder_.Load(object);
  return chosen;
}

/// What a caller gets of a function that is left without a value: 0 (6.8), which of a pointer is the null pointer.
void Lowering::StoreNoResult() {
  switch (TypeAt(function_->result).kind) {
    case TypeKind::kPointer: {
      const PointerPlaces& places = result_pointers_[function_id_.index];
      builder_.Store(places.offset, builder_.Constant(ir::Type::kI32, kNullOffset, 16));
      if (places.object.valid()) builder_.Store(places.object, Word(0));
      break;
    }
    case TypeKind::kRecord:
      ClearObject(objects_.OfResult(function_id_));
      break;
    case TypeKind::kVoid:
    case TypeKind::kInteger:
    case TypeKind::kReal:
    case TypeKind::kArray:
    case TypeKind::kFunction:
      if (result_.valid()) builder_.Store(result_, builder_.Constant(program_.places[result_].type, 0));
      break;
  }
}

}  // namespace plcxx::hnc
