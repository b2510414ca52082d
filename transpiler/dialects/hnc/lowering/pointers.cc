#include "transpiler/dialects/hnc/lowering/pointers.h"

#include <algorithm>
#include <cctype>

#include "transpiler/dialects/hnc/lowering/conversions.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

/// Whether a line of the source has the name with something behind it that `fits`, blanks left out.
template <class Fits>
bool HasBehind(std::string_view line, std::string_view name, Fits&& fits) {
  const auto is_part = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (size_t at = line.find(name); at != std::string_view::npos; at = line.find(name, at + 1)) {
    std::string_view behind = line.substr(at + name.size());
    if ((at > 0 && is_part(line[at - 1])) || (!behind.empty() && is_part(behind.front()))) continue;
    behind.remove_prefix(std::min(behind.find_first_not_of(' '), behind.size()));
    if (fits(behind)) return true;
  }
  return false;
}

bool AssignsTo(std::string_view line, std::string_view name) {
  return HasBehind(line, name,
                   [](std::string_view behind) { return behind.starts_with('=') && !behind.starts_with("=="); });
}

bool HasCallOf(std::string_view line, std::string_view name) {
  return HasBehind(line, name, [](std::string_view behind) { return behind.starts_with('('); });
}

}  // namespace

void Pointers::AddIndex(Address& address, const Value& index, uint32_t size, int64_t sign) {
  if (const std::optional<int64_t> known = KnownInteger(index)) {
    address.base += sign * *known * size;
    return;
  }
  ValueId number = conversions_.AsIndex(index);
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

Address Pointers::PointerIn(VariableId id) {
  Address address;
  address.targets = facts_.TargetsOf(id);
  const auto found = placement_.pointers.find(id.index);
  if (found == placement_.pointers.end()) return address;
  if (found->second.object.valid()) address.object = builder_.Load(found->second.object);
  address.index = builder_.Load(found->second.offset);
  address.index_bounds = kAnyOffset;
  const ObjectId object = objects_.OfVariable(id);
  if (!facts_.IsInMemory(id)) {
    if (const std::optional<Bounds> known = flow_.Find({object, 0, 4})) address.index_bounds = *known;
  }
  return address;
}

void Pointers::StorePointer(VariableId id, const Address& value) {
  const auto found = placement_.pointers.find(id.index);
  if (found == placement_.pointers.end()) return;
  const Variable& variable = unit_.variables[id];
  // Static memory outlives the function whose local it would refer to.
  if (variable.storage == Storage::kGlobal || variable.storage == Storage::kStaticLocal) {
    for (const ObjectId object : value.targets.objects) {
      const Object& target = objects_[object];
      if (target.kind != ObjectKind::kVariable) continue;
      const Variable& pointee = unit_.variables[VariableId(target.index)];
      if (pointee.storage != Storage::kAutomatic && pointee.storage != Storage::kParameter) continue;
      diagnostics_.Report(statement_.range, diag::HncLocalAddress, pointee.name);
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

ValueId Pointers::OffsetOf(const Address& address) {
  if (address.is_null) return builder_.Constant(ir::Type::kI32, kNullOffset, 16);
  if (!address.index.valid()) return Long(static_cast<uint32_t>(address.base));
  ValueId offset = address.index;
  if (address.stride != 1) offset = Pure(OpKind::kMul32, {offset, Long(address.stride)});
  if (address.base > 0) offset = Pure(OpKind::kAdd32, {offset, Long(static_cast<uint32_t>(address.base))});
  if (address.base < 0) offset = Pure(OpKind::kSub32, {offset, Long(static_cast<uint32_t>(-address.base))});
  return offset;
}

ValueId Pointers::ObjectOf(const Address& address) {
  if (address.object.valid()) return address.object;
  return Word(address.targets.objects.empty() ? 0 : NumberOf(address.targets.objects.front()));
}

ValueId Pointers::IsNotNull(const Address& address, ExprId id) {
  const Expr& expr = ExprAt(id);
  if (address.is_null) return builder_.Bit(0);
  if (!address.index.valid() || expr.kind == ExprKind::kDecay || expr.kind == ExprKind::kAddress ||
      (expr.kind == ExprKind::kLoad && ExprAt(expr.a).kind == ExprKind::kIndex)) {
    diagnostics_.Report(expr.range, diag::HncPointerAlwaysTrue, sources_.Text(expr.range));
    return builder_.Bit(1);
  }
  return Pure(OpKind::kNotEqual32, {OffsetOf(address), builder_.Constant(ir::Type::kI32, kNullOffset, 16)});
}

bool Pointers::MayBeNull(const Address& address) {
  return address.index.valid() && address.base == 0 && address.stride == 1 &&
         address.index_bounds.Holds(kAnyOffset.low);
}

bool Pointers::CheckTargets(const Address& address, ExprId at) {
  if (!address.targets.objects.empty() && address.targets.objects.size() <= kMostTargets) return true;
  if (address.reported) return false;
  ExprId source = ExprAt(at).a;
  VariableId variable;
  if (source.valid()) {
    ForEachExpr(unit_, source, [&](ExprId part) {
      const Expr& expr = ExprAt(part);
      // Of what is no variable none.
      if (!variable.valid() && unit_.types[expr.type].kind == TypeKind::kPointer) variable = expr.variable;
      if (expr.kind == ExprKind::kPoison) source = {};
    });
  }
  if (!source.valid()) return false;
  if (variable.valid() && !refused_.insert(variable.index).second) return false;
  std::vector<VariableId> seen;
  if (variable.valid() && HasPoisonedSource(variable, seen)) return false;
  const std::string name =
      variable.valid() ? unit_.variables[variable].name : std::string(sources_.Text(ExprAt(at).range));
  diagnostics_.Report(ExprAt(at).range, diag::HncPointerObject, "'" + name + "' " + std::string(WhyRefused(address)));
  return false;
}

std::string_view Pointers::WhyRefused(const Address& address) {
  if (address.targets.objects.size() > kMostTargets) return "may refer to more than 16 objects";
  return address.is_null ? "is 0" : "is never assigned the address of one";
}

bool Pointers::HasPoison(ExprId id) const {
  bool poison = false;
  ForEachExpr(unit_, id, [&](ExprId part) { poison = poison || ExprAt(part).kind == ExprKind::kPoison; });
  return poison;
}

/// Whether a call hands something to the parameter that was refused already, or what another such parameter has.
bool Pointers::IsHandedPoison(const Expr& call, VariableId parameter, std::vector<VariableId>& seen) const {
  // With such an argument it is refused as a whole.
  if (call.kind == ExprKind::kPoison)
    return std::ranges::any_of(call.arguments, [&](ExprId id) { return HasPoison(id); });
  const std::vector<VariableId>& parameters = unit_.functions[call.function].parameters;
  const auto number = static_cast<size_t>(std::ranges::find(parameters, parameter) - parameters.begin());
  if (call.kind != ExprKind::kCall || number >= call.arguments.size()) return false;
  bool poison = false;
  ForEachExpr(unit_, call.arguments[number], [&](ExprId part) {
    const VariableId other = ExprAt(part).variable;
    const bool is_pointer = other.valid() && unit_.types[ExprAt(part).type].kind == TypeKind::kPointer;
    poison = poison ||
             (is_pointer && unit_.variables[other].storage == Storage::kParameter && HasPoisonedSource(other, seen));
  });
  return poison;
}

/// Whether something that was refused already is assigned to the pointer. `seen`: of which that has been asked.
bool Pointers::HasPoisonedSource(VariableId variable, std::vector<VariableId>& seen) const {
  if (std::ranges::find(seen, variable) != seen.end()) return false;
  seen.push_back(variable);
  const Variable& pointer = unit_.variables[variable];
  for (const InitialValue& initial : pointer.initial) {
    if (HasPoison(initial.value)) return true;
  }
  const bool is_parameter = pointer.storage == Storage::kParameter && pointer.function.valid();
  for (const Expr& expr : unit_.expressions) {
    if (is_parameter && expr.function == pointer.function && IsHandedPoison(expr, variable, seen)) return true;
    if (expr.kind != ExprKind::kAssign || ExprAt(expr.a).kind != ExprKind::kVariable) continue;
    if (ExprAt(expr.a).variable == variable && HasPoison(expr.b)) return true;
  }
  // What Clang refuses as a whole is not in the tree: then an error stands in a line that assigns to this name, or
  // calls the function.
  for (const diag::Diagnostic& diagnostic : diagnostics_.all()) {
    const source::Position at = sources_.Locate(diagnostic.range.begin);
    if (diagnostic.severity != diag::Severity::kError || !at.file.valid()) continue;
    const std::string_view line = sources_.Line(at.file, at.line);
    if (AssignsTo(line, pointer.name)) return true;
    if (is_parameter && HasCallOf(line, unit_.functions[pointer.function].name)) return true;
  }
  return false;
}

Address Pointers::SelectAddress(ValueId condition, const Address& a, const Address& b) {
  Address chosen;
  chosen.targets = a.targets;
  chosen.targets.Add(b.targets);
  chosen.index = Pure(OpKind::kSelect32, {condition, OffsetOf(a), OffsetOf(b)});
  chosen.index_bounds = kAnyOffset;
  if (chosen.targets.objects.size() > 1) chosen.object = Pure(OpKind::kSelect16, {condition, ObjectOf(a), ObjectOf(b)});
  return chosen;
}

}  // namespace plcxx::hnc
