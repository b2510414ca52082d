// Lvalues and pointers (specification 5.3, 6.5): which object, which byte of it.

#include <cctype>

#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

void Lowering::AddIndex(Address& address, const Value& index, uint32_t size, int64_t sign) {
  if (const std::optional<int64_t> known = KnownInteger(index)) {
    address.base += sign * *known * size;
    return;
  }
  ValueId number = AsIndex(index);
  Bounds bounds = index.bounds;
  if (sign < 0) {
    number = Pure(OpKind::kMinus32, {number});
    bounds = {-bounds.high, -bounds.low};
  }
  if (!address.index.valid()) {
    address.index = number;
    address.stride = size;
    address.index_bounds = bounds;
    return;
  }
  if (address.stride != size) {
    const auto bytes = [&](ValueId value, uint32_t stride) {
      return stride == 1 ? value : Pure(OpKind::kMul32, {value, Long(stride)});
    };
    address.index = bytes(address.index, address.stride);
    address.index_bounds = {address.index_bounds.low * address.stride, address.index_bounds.high * address.stride};
    address.stride = 1;
    number = bytes(number, size);
    bounds = {bounds.low * size, bounds.high * size};
  }
  address.index = Pure(OpKind::kAdd32, {address.index, number});
  const Bounds sum{address.index_bounds.low + bounds.low, address.index_bounds.high + bounds.high};
  address.index_bounds = sum.Within(kAnyOffset) ? sum : kAnyOffset;
}

Lvalue Lowering::EvaluateLvalue(ExprId id) {
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
        if (local_places_[expr.variable.index].valid()) {
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
        if (!CheckTargets(lvalue.address, at)) lvalue.address = {};
        break;
      case ExprKind::kIndex: {  // of a pointer
        lvalue.address = EvaluatePointer(expr.a);
        const Value index = Evaluate(expr.b);
        if (CheckTargets(lvalue.address, at)) {
          AddIndex(lvalue.address, index, TypeAt(expr.type).size, 1);
        } else {
          lvalue.address = {};
        }
        break;
      }
      default:
        if (expr.type.valid() && TypeAt(expr.type).kind == TypeKind::kRecord) lvalue.address = RecordAddress(at);
        break;
    }
    break;
  }
  for (size_t i = outer.size(); i-- > 0;) {
    const Expr& expr = ExprAt(outer[i]);
    lvalue.expr = outer[i];
    if (expr.kind == ExprKind::kIndex) {
      AddIndex(lvalue.address, Evaluate(expr.b), TypeAt(expr.type).size, 1);
    } else {
      const Member& member = unit_.records[TypeAt(ExprAt(expr.a).type).record].members[expr.member];
      lvalue.address.base += member.offset;
      lvalue.bit_field = member.is_bit_field ? &member : nullptr;
    }
    lvalue.type = expr.type;
  }
  return lvalue;
}

/// An element of F_T or G_T: the address of a word, counted in words for every T (5.3).
Address Lowering::TableElement(const Expr& load) {
  const Expr& element = ExprAt(load.a);
  const Variable& table = unit_.variables[ExprAt(element.a).variable];
  Address address;
  const ObjectId object = objects_.OfArea(table.view->area);
  address.targets.Add(object);
  const Value index = Evaluate(element.b);
  const std::optional<int64_t> known = KnownInteger(index);
  if (known && (*known < 0 || *known >= table.view->count)) {
    diagnostics_.Report(element.range, diag::HncIndex, *known, table.name, table.view->count - 1);
    address.targets = {};
    address.reported = true;
    return address;
  }
  AddIndex(address, index, 2, 1);
  return address;
}

Address Lowering::EvaluatePointer(ExprId id) {
  const Expr& expr = ExprAt(id);
  switch (expr.kind) {
    case ExprKind::kNull: {
      Address null;
      null.is_null = true;
      return null;
    }
    case ExprKind::kDecay:
    case ExprKind::kAddress:
      return EvaluateLvalue(expr.a).address;
    case ExprKind::kCast:
    case ExprKind::kConvert:
      if (TypeAt(ExprAt(expr.a).type).kind != TypeKind::kPointer) break;
      return EvaluatePointer(expr.a);
    case ExprKind::kBinary: {
      Address address = EvaluatePointer(expr.a);
      const Value index = Evaluate(expr.b);
      const uint32_t size = TypeAt(TypeAt(expr.type).element).size;
      AddIndex(address, index, size, expr.binary == BinaryOp::kPointerSubtract ? -1 : 1);
      return address;
    }
    case ExprKind::kComma:
      Execute(expr.a);
      return EvaluatePointer(expr.b);
    case ExprKind::kConditional:
      return ConditionalAddress(expr, &Lowering::EvaluatePointer);
    case ExprKind::kCall: {
      const CallResult result = Call(id);
      return result.address ? *result.address : Address{};
    }
    case ExprKind::kLoad: {
      const Expr& source = ExprAt(expr.a);
      if (source.kind == ExprKind::kVariable) {
        CheckAssigned(source.variable, expr.a);
        return PointerIn(source.variable);
      }
      if (source.kind != ExprKind::kIndex || ExprAt(source.a).kind != ExprKind::kVariable) break;
      const VariableId table = ExprAt(source.a).variable;
      if (unit_.variables[table].view) return TableElement(expr);
      // A table of string literals: its elements are the numbers of the strings.
      Address address;
      address.targets = facts_.TargetsOf(table);
      Lvalue element = EvaluateLvalue(expr.a);
      address.object = LoadAt(element.address, ir::Type::kI16, expr.a);
      return address;
    }
    case ExprKind::kAssign: {
      const Expr& target = ExprAt(expr.a);
      const Address value = EvaluatePointer(expr.b);
      if (target.kind != ExprKind::kVariable) break;
      StorePointer(target.variable, value);
      return PointerIn(target.variable);
    }
    case ExprKind::kCompoundAssign:
    case ExprKind::kIncrement: {
      const Expr& target = ExprAt(expr.a);
      if (target.kind != ExprKind::kVariable) break;
      const bool increments = expr.kind == ExprKind::kIncrement;
      CheckAssigned(target.variable, expr.a);
      const Value step = increments ? Number(1, int_) : Evaluate(expr.b);
      const Address before = PointerIn(target.variable);
      Address after = before;
      const bool down =
          increments ? expr.increment == IncrementOp::kPreDecrement || expr.increment == IncrementOp::kPostDecrement
                     : expr.binary == BinaryOp::kPointerSubtract || expr.binary == BinaryOp::kSubtract;
      const uint32_t size = TypeAt(TypeAt(expr.type).element).size;
      // In bytes, as the variable keeps it.
      Address moved = after;
      AddIndex(moved, step, size, down ? -1 : 1);
      after = moved;
      StorePointer(target.variable, after);
      const bool post = increments && (expr.increment == IncrementOp::kPostIncrement ||
                                       expr.increment == IncrementOp::kPostDecrement);
      return post ? before : after;
    }
    default:
      break;
  }
  return {};
}

Address Lowering::PointerIn(VariableId id) {
  Address address;
  address.targets = facts_.TargetsOf(id);
  const auto found = pointer_places_.find(id.index);
  if (found == pointer_places_.end()) return address;
  if (found->second.object.valid()) address.object = builder_.Load(found->second.object);
  address.index = builder_.Load(found->second.offset);
  address.index_bounds = kAnyOffset;
  const ObjectId object = objects_.OfVariable(id);
  if (!facts_.IsInMemory(id) && object.valid()) {
    if (const std::optional<Bounds> known = flow_.Find({object, 0, 4})) address.index_bounds = *known;
  }
  return address;
}

void Lowering::StorePointer(VariableId id, const Address& value) {
  const auto found = pointer_places_.find(id.index);
  if (found == pointer_places_.end()) return;
  const Variable& variable = unit_.variables[id];
  // Static memory outlives the function whose local it would refer to.
  if (variable.storage == Storage::kGlobal || variable.storage == Storage::kStaticLocal) {
    for (const ObjectId object : value.targets.objects) {
      const Object& target = objects_[object];
      if (target.kind != ObjectKind::kVariable) continue;
      const Variable& pointee = unit_.variables[VariableId(target.index)];
      if (pointee.storage != Storage::kAutomatic && pointee.storage != Storage::kParameter) continue;
      diagnostics_.Report(statement_range_, diag::HncLocalAddress, pointee.name);
    }
  }
  if (found->second.object.valid()) builder_.Store(found->second.object, ObjectOf(value));  // of null: 0, as all have
  builder_.Store(found->second.offset, OffsetOf(value));
  flow_.unassigned.erase(id);
  const Cell cell{objects_.OfVariable(id), 0, 4};
  flow_.Forget(cell);
  const bool constant = !value.index.valid();
  const Bounds bounds = constant ? Bounds{value.base, value.base}
                                 : Bounds{value.base + value.stride * value.index_bounds.low,
                                          value.base + value.stride * value.index_bounds.high};
  if (!value.is_null && bounds.Within(kAnyOffset)) flow_.Learn(cell, bounds, Origin::kTested);
}

ValueId Lowering::OffsetOf(const Address& address) {
  if (address.is_null) return builder_.Constant(ir::Type::kI32, kNullOffset, 16);
  if (!address.index.valid()) return Long(static_cast<uint32_t>(address.base));
  ValueId offset = address.index;
  if (address.stride != 1) offset = Pure(OpKind::kMul32, {offset, Long(address.stride)});
  if (address.base > 0) offset = Pure(OpKind::kAdd32, {offset, Long(static_cast<uint32_t>(address.base))});
  if (address.base < 0) offset = Pure(OpKind::kSub32, {offset, Long(static_cast<uint32_t>(-address.base))});
  return offset;
}

ValueId Lowering::ObjectOf(const Address& address) {
  if (address.object.valid()) return address.object;
  return Word(address.targets.objects.empty() ? 0 : NumberOf(address.targets.objects.front()));
}

ValueId Lowering::IsNotNull(const Address& address, ExprId id) {
  const Expr& expr = ExprAt(id);
  if (address.is_null) return builder_.Bit(0);
  if (!address.index.valid() || expr.kind == ExprKind::kDecay || expr.kind == ExprKind::kAddress ||
      (expr.kind == ExprKind::kLoad && ExprAt(expr.a).kind == ExprKind::kIndex)) {
    diagnostics_.Report(expr.range, diag::HncPointerAlwaysTrue, sources_.Text(expr.range));
    return builder_.Bit(1);
  }
  return Pure(OpKind::kNotEqual32, {OffsetOf(address), builder_.Constant(ir::Type::kI32, kNullOffset, 16)});
}

bool Lowering::MayBeNull(const Address& address) {
  return address.index.valid() && address.base == 0 && address.stride == 1 &&
         address.index_bounds.Holds(kAnyOffset.low);
}

Value Lowering::ComparePointers(const Expr& expr) {
  const Address a = EvaluatePointer(expr.a), b = EvaluatePointer(expr.b);
  const bool equality = expr.binary == BinaryOp::kEqual || expr.binary == BinaryOp::kNotEqual;
  const auto outcome = [&](ValueId equal) {
    return FromBit(expr.binary == BinaryOp::kNotEqual ? Pure(OpKind::kBitNot, {equal}) : equal);
  };
  const ValueId x = OffsetOf(a), y = OffsetOf(b);
  if (equality && (a.is_null || b.is_null)) return outcome(Pure(OpKind::kEqual32, {x, y}));
  bool apart = !a.targets.objects.empty() && !b.targets.objects.empty();
  for (const ObjectId object : a.targets.objects) apart = apart && !b.targets.Has(object);
  if (apart && !equality) {
    diagnostics_.Report(expr.range, diag::HncIncompatible, "pointers into different objects are compared");
    return FromBit(builder_.Bit(0));
  }
  const auto is_null = [&](ValueId offset) {
    return Pure(OpKind::kEqual32, {offset, builder_.Constant(ir::Type::kI32, kNullOffset, 16)});
  };
  // Two null pointers are equal, whatever else they may refer to.
  const bool nulls = MayBeNull(a) && MayBeNull(b);
  if (apart) return outcome(nulls ? Pure(OpKind::kBitAnd, {is_null(x), is_null(y)}) : builder_.Bit(0));
  const bool several = a.object.valid() || b.object.valid() || a.targets.objects != b.targets.objects;
  ValueId same;
  if (several) same = Pure(OpKind::kEqual16, {ObjectOf(a), ObjectOf(b)});
  const auto with_same = [&](ValueId bit) { return several ? Pure(OpKind::kBitAnd, {same, bit}) : bit; };
  switch (expr.binary) {
    case BinaryOp::kLess:
      return FromBit(with_same(Pure(OpKind::kSignedLess32, {x, y})));
    case BinaryOp::kGreater:
      return FromBit(with_same(Pure(OpKind::kSignedGreater32, {x, y})));
    case BinaryOp::kLessEqual:
      return FromBit(with_same(Pure(OpKind::kSignedLessEqual32, {x, y})));
    case BinaryOp::kGreaterEqual:
      return FromBit(with_same(Pure(OpKind::kSignedGreaterEqual32, {x, y})));
    default:
      if (several && nulls) same = Pure(OpKind::kBitOr, {same, is_null(x)});
      return outcome(with_same(Pure(OpKind::kEqual32, {x, y})));
  }
}

Value Lowering::PointerDifference(const Expr& expr) {
  const Address a = EvaluatePointer(expr.a), b = EvaluatePointer(expr.b);
  const uint32_t size = std::max(1u, TypeAt(TypeAt(ExprAt(expr.a).type).element).size);
  bool apart = !a.targets.objects.empty() && !b.targets.objects.empty();
  for (const ObjectId object : a.targets.objects) apart = apart && !b.targets.Has(object);
  if (apart) {
    diagnostics_.Report(expr.range, diag::HncIncompatible, "pointers into different objects are subtracted");
    return Zero(int_);
  }
  ValueId difference = Pure(OpKind::kSub32, {OffsetOf(a), OffsetOf(b)});
  if (size > 1) difference = Pure(OpKind::kSignedDiv32, {difference, Long(size)});
  ValueId number = Pure(OpKind::kLowHalf32, {difference});
  if (a.object.valid() || b.object.valid() || a.targets.objects != b.targets.objects) {
    const ValueId same = Pure(OpKind::kEqual16, {ObjectOf(a), ObjectOf(b)});
    number = Pure(OpKind::kSelect16, {same, number, Word(0)});
  }
  return Make(number, int_);
}

/// Whether an access through the pointer can be lowered; else it is refused, once for each variable.
bool Lowering::CheckTargets(const Address& address, ExprId at) {
  if (!address.targets.objects.empty() && address.targets.objects.size() <= kMostTargets) return true;
  if (address.reported) return false;
  ExprId source = ExprAt(at).a;
  VariableId variable;
  if (source.valid()) {
    ForEachExpr(unit_, source, [&](ExprId part) {
      const Expr& expr = ExprAt(part);
      if (expr.kind == ExprKind::kVariable && !variable.valid() && unit_.types[expr.type].kind == TypeKind::kPointer) {
        variable = expr.variable;
      }
      if (expr.kind == ExprKind::kPoison) source = {};
    });
  }
  if (!source.valid()) return false;
  if (variable.valid() && !refused_pointers_.insert(variable.index).second) return false;
  if (variable.valid() && HasPoisonedSource(variable)) return false;
  const std::string name =
      variable.valid() ? unit_.variables[variable].name : std::string(sources_.Text(ExprAt(at).range));
  const bool many = address.targets.objects.size() > kMostTargets;
  diagnostics_.Report(ExprAt(at).range, diag::HncPointerObject,
                      "'" + name + "' " +
                          (many              ? "may refer to more than 16 objects"
                           : address.is_null ? "is 0"
                                             : "is never assigned the address of one"));
  return false;
}

/// Does a line of the source assign to the name?
static bool AssignsTo(std::string_view line, std::string_view name) {
  const auto is_part = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (size_t at = line.find(name); at != std::string_view::npos; at = line.find(name, at + 1)) {
    size_t behind = at + name.size();
    if ((at > 0 && is_part(line[at - 1])) || (behind < line.size() && is_part(line[behind]))) continue;
    while (behind < line.size() && line[behind] == ' ') ++behind;
    if (behind < line.size() && line[behind] == '=' && line.substr(behind, 2) != "==") return true;
  }
  return false;
}

/// Whether something that was refused already is assigned to the pointer.
bool Lowering::HasPoisonedSource(VariableId variable) const {
  const auto is_poison = [this](ExprId id) {
    bool poison = false;
    ForEachExpr(unit_, id, [&](ExprId part) { poison = poison || ExprAt(part).kind == ExprKind::kPoison; });
    return poison;
  };
  for (const InitialValue& initial : unit_.variables[variable].initial) {
    if (is_poison(initial.value)) return true;
  }
  for (const Expr& expr : unit_.expressions) {
    if (expr.kind != ExprKind::kAssign || ExprAt(expr.a).kind != ExprKind::kVariable) continue;
    if (ExprAt(expr.a).variable == variable && is_poison(expr.b)) return true;
  }
  // What Clang refuses as a whole is not in the tree: then an error stands in a line that assigns to this name.
  for (const diag::Diagnostic& diagnostic : diagnostics_.all()) {
    const source::Position at = sources_.Locate(diagnostic.range.begin);
    if (diagnostic.severity != diag::Severity::kError || !at.file.valid()) continue;
    if (AssignsTo(sources_.Line(at.file, at.line), unit_.variables[variable].name)) return true;
  }
  return false;
}

}  // namespace plcxx::hnc
