#include "transpiler/dialects/hnc/lowering/addresses.h"

#include <algorithm>

#include "transpiler/dialects/hnc/lowering/accesses.h"
#include "transpiler/dialects/hnc/lowering/calls.h"
#include "transpiler/dialects/hnc/lowering/conversions.h"
#include "transpiler/dialects/hnc/lowering/expressions.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/locals.h"
#include "transpiler/dialects/hnc/lowering/pointers.h"
#include "transpiler/dialects/hnc/lowering/records.h"
#include "transpiler/support/check.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

/// Whether the objects that two pointers refer to have to be compared as well.
bool MayBeOfSeveral(const Address& a, const Address& b) {
  return a.object.valid() || a.targets.objects != b.targets.objects;  // that of b has one only where that of a has, too
}

}  // namespace

Lvalue Addresses::EvaluateLvalue(ExprId id) {
  // Members and elements nest on their left side: the innermost object first.
  std::vector<ExprId> outer;
  Lvalue lvalue;
  for (ExprId at = id;;) {
    const Expr& expr = ExprAt(at);
    const bool through = (expr.kind == ExprKind::kIndex && TypeAt(ExprAt(expr.a).type).kind == TypeKind::kArray) ||
                         expr.kind == ExprKind::kMember;
    if (through) {
      outer.push_back(at);
      at = expr.a;
      continue;
    }
    lvalue.expr = at;
    lvalue.type = expr.type;
    switch (expr.kind) {
      case ExprKind::kVariable: {
        const Variable& variable = unit_.variables[expr.variable];
        if (placement_.locals[expr.variable.index].valid()) {
          lvalue.local = expr.variable;
        } else if (variable.view) {
          lvalue.address.targets.Add(objects_.OfArea(variable.view->area));
        } else if (objects_.OfVariable(expr.variable).valid()) {
          lvalue.address.targets.Add(objects_.OfVariable(expr.variable));
        }
        break;
      }
      case ExprKind::kString:
        lvalue.address.targets.Add(objects_.OfString(expr.string));
        break;
      case ExprKind::kDereference:
        lvalue.address = EvaluatePointer(expr.a);
        if (!pointers_.CheckTargets(lvalue.address, at)) lvalue.address = {};
        break;
      case ExprKind::kIndex: {  // of a pointer
        lvalue.address = EvaluatePointer(expr.a);
        const Value index = expressions_.Evaluate(expr.b);
        if (pointers_.CheckTargets(lvalue.address, at)) {
          pointers_.AddIndex(lvalue.address, index, TypeAt(expr.type).size, 1);
        } else {
          lvalue.address = {};
        }
        break;
      }
      case ExprKind::kPoison:
      case ExprKind::kConstant:
      case ExprKind::kFunction:
      case ExprKind::kLoad:
      case ExprKind::kDecay:
      case ExprKind::kConvert:
      case ExprKind::kCast:
      case ExprKind::kNull:
      case ExprKind::kUnary:
      case ExprKind::kBinary:
      case ExprKind::kAnd:
      case ExprKind::kOr:
      case ExprKind::kConditional:
      case ExprKind::kComma:
      case ExprKind::kAssign:
      case ExprKind::kCompoundAssign:
      case ExprKind::kIncrement:
      case ExprKind::kAddress:
      case ExprKind::kMember:
      case ExprKind::kCall:
        if (expr.type.valid() && TypeAt(expr.type).kind == TypeKind::kRecord) lvalue.address = RecordAddress(at);
        break;
    }
    break;
  }
  for (size_t i = outer.size(); i-- > 0;) {
    const Expr& expr = ExprAt(outer[i]);
    lvalue.expr = outer[i];
    if (expr.kind == ExprKind::kIndex) {
      pointers_.AddIndex(lvalue.address, expressions_.Evaluate(expr.b), TypeAt(expr.type).size, 1);
    } else {
      const Member& member = unit_.records[TypeAt(ExprAt(expr.a).type).record].members[expr.member];
      lvalue.address.base += member.offset;
      lvalue.bit_field = member.is_bit_field ? &member : nullptr;
    }
    lvalue.type = expr.type;
  }
  return lvalue;
}

bool Addresses::IsPointerToPointer(const Expr& expr) const {
  if (!expr.type.valid() || TypeAt(expr.type).kind != TypeKind::kPointer) return false;
  const TypeId element = TypeAt(expr.type).element;
  return element.valid() && TypeAt(element).kind == TypeKind::kPointer;
}

/// An element of F_T or G_T: the address of a word, counted in words for every T (5.3).
Address Addresses::TableElement(const Expr& load) {
  const Expr& element = ExprAt(load.a);
  const Variable& table = unit_.variables[ExprAt(element.a).variable];
  Address address;
  const Value index = expressions_.Evaluate(element.b);
  const std::optional<int64_t> known = KnownInteger(index);
  if (known && (*known < 0 || *known >= table.view->count)) {
    diagnostics_.Report(element.range, diag::HncIndex, *known, table.name, table.view->count - 1);
    address.reported = true;
    return address;
  }
  address.targets.Add(objects_.OfArea(table.view->area));
  pointers_.AddIndex(address, index, 2, 1);
  return address;
}

/// No place is kept for it: what would be lowered loses what is assigned to it.
Address Addresses::RefusedPointer(const Expr& expr, std::string_view why) {
  diagnostics_.Report(expr.range, diag::HncPointerDeclaration,
                      "'" + std::string(sources_.Text(expr.range)) + "' " + std::string(why));
  Address refused;
  refused.reported = true;
  return refused;
}

/// What a variable or a table has; none: no pointer is kept there.
std::optional<Address> Addresses::LoadedPointer(const Expr& load) {
  const Expr& source = ExprAt(load.a);
  if (source.kind == ExprKind::kVariable) {
    accesses_.CheckAssigned(source.variable, load.a);
    return pointers_.PointerIn(source.variable);
  }
  if (source.kind != ExprKind::kIndex || ExprAt(source.a).kind != ExprKind::kVariable) return std::nullopt;
  const VariableId table = ExprAt(source.a).variable;
  if (unit_.variables[table].view) return TableElement(load);
  // A table of string literals: its elements are the numbers of the strings.
  Address address;
  address.targets = facts_.TargetsOf(table);
  address.reported = address.targets.objects.empty() && diagnostics_.HasErrors();  // no table of literals
  if (address.reported) return address;
  const Lvalue element = EvaluateLvalue(load.a);
  address.object = accesses_.LoadAt(element.address, ir::Type::kI16, load.a);
  return address;
}

/// An increment or a compound assignment of a variable.
Address Addresses::MovedPointer(const Expr& expr) {
  const Expr& target = ExprAt(expr.a);
  const bool increments = expr.kind == ExprKind::kIncrement;
  accesses_.CheckAssigned(target.variable, expr.a);
  const Value step = increments ? conversions_.Number(1, int_) : expressions_.Evaluate(expr.b);
  const Address before = pointers_.PointerIn(target.variable);
  const bool down = increments
                        ? expr.increment == IncrementOp::kPreDecrement || expr.increment == IncrementOp::kPostDecrement
                        : expr.binary == BinaryOp::kPointerSubtract || expr.binary == BinaryOp::kSubtract;
  // In bytes, as the variable keeps it.
  Address after = before;
  pointers_.AddIndex(after, step, TypeAt(TypeAt(expr.type).element).size, down ? -1 : 1);
  pointers_.StorePointer(target.variable, after);
  const bool post =  // which an assignment is not
      expr.increment == IncrementOp::kPostIncrement || expr.increment == IncrementOp::kPostDecrement;
  return post ? before : after;
}

Address Addresses::EvaluatePointer(ExprId id) {
  const Expr& expr = ExprAt(id);
  switch (expr.kind) {
    case ExprKind::kNull: {
      Address null;
      null.is_null = true;
      return null;
    }
    case ExprKind::kAddress:
      if (IsPointerToPointer(expr)) return RefusedPointer(expr, "is a pointer to a pointer");
      return EvaluateLvalue(expr.a).address;
    case ExprKind::kDecay:
      return EvaluateLvalue(expr.a).address;
    case ExprKind::kCast:
    case ExprKind::kConvert:
      if (IsPointerToPointer(ExprAt(expr.a))) return RefusedPointer(ExprAt(expr.a), "is a pointer to a pointer");
      if (TypeAt(ExprAt(expr.a).type).kind != TypeKind::kPointer) break;
      return EvaluatePointer(expr.a);
    case ExprKind::kBinary: {
      Address address = EvaluatePointer(expr.a);
      const Value index = expressions_.Evaluate(expr.b);
      const uint32_t size = TypeAt(TypeAt(expr.type).element).size;
      pointers_.AddIndex(address, index, size, expr.binary == BinaryOp::kPointerSubtract ? -1 : 1);
      return address;
    }
    case ExprKind::kComma:
      expressions_.Execute(expr.a);
      return EvaluatePointer(expr.b);
    case ExprKind::kConditional:
      return ConditionalAddress(expr, &Addresses::EvaluatePointer);
    case ExprKind::kCall: {
      const CallResult result = calls_.Call(id);
      return result.address ? *result.address : Address{};
    }
    case ExprKind::kLoad:
      if (const std::optional<Address> loaded = LoadedPointer(expr)) return *loaded;
      break;
    case ExprKind::kAssign: {
      const Expr& target = ExprAt(expr.a);
      const Address value = EvaluatePointer(expr.b);
      if (target.kind != ExprKind::kVariable) break;
      pointers_.StorePointer(target.variable, value);
      return pointers_.PointerIn(target.variable);
    }
    case ExprKind::kCompoundAssign:
    case ExprKind::kIncrement:
      if (ExprAt(expr.a).kind == ExprKind::kVariable) return MovedPointer(expr);
      break;
    case ExprKind::kPoison:
    case ExprKind::kConstant:
    case ExprKind::kString:
    case ExprKind::kVariable:
    case ExprKind::kFunction:
    case ExprKind::kUnary:
    case ExprKind::kAnd:
    case ExprKind::kOr:
    case ExprKind::kDereference:
    case ExprKind::kIndex:
    case ExprKind::kMember:
      break;
  }
  // Of what has been refused an error is there; of a member or an element where it is declared, so that an access
  // through it gives none of its own.
  if (diagnostics_.HasErrors()) {
    Address refused;
    refused.reported = expr.kind == ExprKind::kLoad;
    return refused;
  }
  return RefusedPointer(expr, "is no variable of its own");
}

Value Addresses::ComparePointers(const Expr& expr) {
  const Address a = EvaluatePointer(expr.a), b = EvaluatePointer(expr.b);
  const bool equality = expr.binary == BinaryOp::kEqual || expr.binary == BinaryOp::kNotEqual;
  const auto outcome = [&](ValueId equal) {
    return conversions_.FromBit(expr.binary == BinaryOp::kNotEqual ? Pure(OpKind::kBitNot, {equal}) : equal);
  };
  const ValueId x = pointers_.OffsetOf(a), y = pointers_.OffsetOf(b);
  if (equality && (a.is_null || b.is_null)) return outcome(Pure(OpKind::kEqual32, {x, y}));
  bool apart = !a.targets.objects.empty() && !b.targets.objects.empty();
  for (const ObjectId object : a.targets.objects) apart = apart && !b.targets.Has(object);
  if (apart && !equality) {
    diagnostics_.Report(expr.range, diag::HncIncompatible, "pointers into different objects are compared");
    return conversions_.FromBit(builder_.Bit(0));
  }
  const auto is_null = [&](ValueId offset) {
    return Pure(OpKind::kEqual32, {offset, builder_.Constant(ir::Type::kI32, kNullOffset, 16)});
  };
  // Two null pointers are equal, whatever else they may refer to.
  const bool nulls = pointers_.MayBeNull(a) && pointers_.MayBeNull(b);
  if (apart) return outcome(nulls ? Pure(OpKind::kBitAnd, {is_null(x), is_null(y)}) : builder_.Bit(0));
  const bool several = MayBeOfSeveral(a, b);
  ValueId same;
  if (several) same = Pure(OpKind::kEqual16, {pointers_.ObjectOf(a), pointers_.ObjectOf(b)});
  const auto with_same = [&](ValueId bit) { return several ? Pure(OpKind::kBitAnd, {same, bit}) : bit; };
  switch (expr.binary) {
    case BinaryOp::kLess:
      return conversions_.FromBit(with_same(Pure(OpKind::kSignedLess32, {x, y})));
    case BinaryOp::kGreater:
      return conversions_.FromBit(with_same(Pure(OpKind::kSignedGreater32, {x, y})));
    case BinaryOp::kLessEqual:
      return conversions_.FromBit(with_same(Pure(OpKind::kSignedLessEqual32, {x, y})));
    case BinaryOp::kGreaterEqual:
      return conversions_.FromBit(with_same(Pure(OpKind::kSignedGreaterEqual32, {x, y})));
    case BinaryOp::kAdd:
    case BinaryOp::kSubtract:
    case BinaryOp::kMultiply:
    case BinaryOp::kDivide:
    case BinaryOp::kRemainder:
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight:
    case BinaryOp::kBitAnd:
    case BinaryOp::kBitXor:
    case BinaryOp::kBitOr:
    case BinaryOp::kEqual:
    case BinaryOp::kNotEqual:
    case BinaryOp::kPointerAdd:
    case BinaryOp::kPointerSubtract:
    case BinaryOp::kPointerDifference:
      if (several && nulls) same = Pure(OpKind::kBitOr, {same, is_null(x)});
      return outcome(with_same(Pure(OpKind::kEqual32, {x, y})));
  }
  PLCXX_UNREACHABLE();
}

Value Addresses::PointerDifference(const Expr& expr) {
  const Address a = EvaluatePointer(expr.a), b = EvaluatePointer(expr.b);
  const uint32_t size = std::max(1u, TypeAt(TypeAt(ExprAt(expr.a).type).element).size);
  bool apart = !a.targets.objects.empty() && !b.targets.objects.empty();
  for (const ObjectId object : a.targets.objects) apart = apart && !b.targets.Has(object);
  if (apart) {
    diagnostics_.Report(expr.range, diag::HncIncompatible, "pointers into different objects are subtracted");
    return conversions_.Zero(int_);
  }
  ValueId difference = Pure(OpKind::kSub32, {pointers_.OffsetOf(a), pointers_.OffsetOf(b)});
  if (size > 1) difference = Pure(OpKind::kSignedDiv32, {difference, Long(size)});
  ValueId number = Pure(OpKind::kLowHalf32, {difference});
  if (MayBeOfSeveral(a, b)) {
    const ValueId same = Pure(OpKind::kEqual16, {pointers_.ObjectOf(a), pointers_.ObjectOf(b)});
    number = Pure(OpKind::kSelect16, {same, number, Word(0)});
  }
  return conversions_.Make(number, int_);
}

Address Addresses::RecordAddress(ExprId id) {
  const Expr& expr = ExprAt(id);
  switch (expr.kind) {
    case ExprKind::kLoad:
      return RecordAddress(expr.a);
    case ExprKind::kAssign: {
      const Address from = RecordAddress(expr.b);
      // What chooses the target may change what is assigned: another call of the function that gave it, for instance.
      const bool keeps = HasEffects(expr.a);
      const std::vector<ValueId> pieces = keeps ? records_.Load(from, expr.type) : std::vector<ValueId>();
      const Address to = EvaluateLvalue(expr.a).address;
      if (keeps) {
        records_.Store(to, pieces, expr.type);
      } else {
        records_.Assign(to, from, expr.type);
      }
      for (const ObjectId object : to.targets.objects) flow_.Forget(object);
      return to;
    }
    case ExprKind::kComma:
      expressions_.Execute(expr.a);
      return RecordAddress(expr.b);
    case ExprKind::kCall: {
      const CallResult result = calls_.Call(id);
      return result.address ? *result.address : Address{};
    }
    case ExprKind::kConditional:
      return ConditionalAddress(expr, &Addresses::RecordAddress);
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

/// Of the arms only the one that is chosen is executed, where they do more than compute.
Address Addresses::ConditionalAddress(const Expr& expr, Address (Addresses::*evaluate)(ExprId)) {
  const ValueId condition = expressions_.Condition(expr.a);
  if (IsSimple(expr.b) && IsSimple(expr.c)) {
    const Address then = (this->*evaluate)(expr.b);
    return pointers_.SelectAddress(condition, then, (this->*evaluate)(expr.c));
  }
  const ir::PlaceId offset = locals_.Add("chosen", ir::Type::kI32),
                    object = locals_.Add("chosen_object", ir::Type::kI16);
  Address chosen;
  const auto keep = [&](ExprId arm) {
    const Address address = (this->*evaluate)(arm);
    chosen.targets.Add(address.targets);
    chosen.reported = chosen.reported || address.reported;
    builder_.Store(offset, pointers_.OffsetOf(address));
    builder_.Store(object, pointers_.ObjectOf(address));
  };
  const Flow before = flow_;
  Flow then;
  builder_.Choose(
      condition,
      [&] {
        intervals_.Refine(expr.a, true);
        keep(expr.b);
        then = flow_;
      },
      [&] {
        flow_ = before;
        intervals_.Refine(expr.a, false);
        keep(expr.c);
      });
  flow_.JoinWith(then);
  chosen.index = builder_.Load(offset);
  chosen.index_bounds = kAnyOffset;
  if (chosen.targets.objects.size() > 1) chosen.object = builder_.Load(object);
  return chosen;
}

}  // namespace plcxx::hnc
