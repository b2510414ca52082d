#include "transpiler/dialects/hnc/analysis/facts.h"

#include <algorithm>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/syntax/walk.h"

namespace plcxx::hnc {

Facts::Facts(const Unit& unit, const Objects& objects) : unit_(unit), objects_(objects), effects_(unit) {
  targets_.resize(unit.variables.size());
  result_targets_.resize(unit.functions.size());
  writes_.resize(unit.functions.size());
  stores_.resize(unit.functions.size());
  callees_.resize(unit.functions.size());
  parts_.resize(unit.functions.size());
  in_memory_.resize(unit.variables.size());
  FindRegistrations();
  FindCallees();
  if (unit.init.valid()) Reach(unit.init, kPartInit);
  if (unit.plc1.valid()) Reach(unit.plc1, kPartFast);
  if (unit.plc2.valid()) Reach(unit.plc2, kPartSlow);
  for (const Registration& registration : registrations_) {
    if (registration.function.valid()) Reach(registration.function, kPartFast);
  }
  FindMemory();
  FindTargets();
  FindWrites();
  FindStores();
}

std::optional<int64_t> Facts::ConstantOf(ExprId id) const {
  if (!id.valid()) return std::nullopt;
  const Expr& expr = unit_.expressions[id];
  if (!expr.constant || !expr.type.valid() || !IsInteger(unit_.types[expr.type])) return std::nullopt;
  return expr.constant->integer;
}

/// A cast or implicit conversion of an argument hides what the program wrote.
static ExprId Unconverted(const Unit& unit, ExprId id) {
  while (id.valid() &&
         (unit.expressions[id].kind == ExprKind::kConvert || unit.expressions[id].kind == ExprKind::kCast)) {
    id = unit.expressions[id].a;
  }
  return id;
}

void Facts::FindRegistrations() {
  for (const ExprId id : effects_.flows()) {
    const Expr& expr = unit_.expressions[id];
    if (expr.kind != ExprKind::kCall || !expr.function.valid() || expr.arguments.size() != 3) continue;
    if (unit_.functions[expr.function].system != SystemFunction::kSetMstFunc) continue;
    const std::optional<int64_t> channel = ConstantOf(expr.arguments[0]), kind = ConstantOf(expr.arguments[1]);
    if (!channel || !kind || *channel < 0 || *channel > 3 || *kind <= 0 || *kind > 127) continue;
    const size_t letter = kHandlerKinds.find(static_cast<char>(*kind));
    if (letter == std::string_view::npos) continue;
    Registration registration{
        .call = id, .channel = static_cast<uint32_t>(*channel), .kind = static_cast<uint32_t>(letter), .function = {}};
    const ExprId handler = Unconverted(unit_, expr.arguments[2]);
    if (!handler.valid()) continue;
    const Expr& named = unit_.expressions[handler];
    if (named.kind == ExprKind::kFunction) {
      registration.function = named.function;
    } else if (named.kind != ExprKind::kNull) {
      continue;
    }
    registrations_.push_back(registration);
  }
}

void Facts::FindCallees() {
  for (const FunctionId id : unit_.definitions) {
    std::vector<FunctionId>& callees = callees_[id.index];
    std::unordered_set<uint32_t> known;
    for (const FunctionId callee : callees) known.insert(callee.index);
    for (const ExprId part : effects_.Of(id)) {
      const Expr& expr = unit_.expressions[part];
      if (expr.kind != ExprKind::kCall || !expr.function.valid()) continue;
      if (known.insert(expr.function.index).second) callees.push_back(expr.function);
    }
  }
  // Of a system function: those that the program has in the place of others (D13).
  const auto calls = [this](uint32_t function, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
      for (const FunctionId id : unit_.definitions) {
        if (unit_.functions[id].name == name) callees_[function].push_back(id);
      }
    }
  };
  for (uint32_t i = 0; i < unit_.functions.size(); ++i) {
    const std::optional<SystemFunction>& system = unit_.functions[FunctionId(i)].system;
    if (system == SystemFunction::kSetAxisMoveto) calls(i, {"set_axis_move", "get_axis_pos"});
    if (system == SystemFunction::kSetAxisStop) calls(i, {"set_axis_jog", "set_axis_home"});
    if (system == SystemFunction::kHandwheel) calls(i, {"set_axis_step"});
  }
}

void Facts::Reach(FunctionId from, uint8_t part) {
  std::vector<FunctionId> open = {from};
  while (!open.empty()) {
    const FunctionId id = open.back();
    open.pop_back();
    if ((parts_[id.index] & part) != 0) continue;
    parts_[id.index] |= part;
    open.insert(open.end(), callees_[id.index].begin(), callees_[id.index].end());
  }
}

void Facts::FindMemory() {
  for (uint32_t i = 0; i < unit_.variables.size(); ++i) {
    const Variable& variable = unit_.variables[VariableId(i)];
    const bool scalar = variable.type.valid() && IsScalar(unit_.types[variable.type]);
    const bool automatic = variable.storage == Storage::kAutomatic || variable.storage == Storage::kParameter;
    in_memory_[i] = !automatic || !scalar;
  }
  for (const ExprId id : effects_.addresses()) {
    const Expr& expr = unit_.expressions[id];
    if (!expr.a.valid()) continue;
    const Expr& operand = unit_.expressions[expr.a];
    if (operand.kind == ExprKind::kVariable) in_memory_[operand.variable.index] = true;
  }
}

ObjectSet Facts::ObjectsOf(ExprId lvalue) const {
  ObjectSet set;
  for (ExprId id = lvalue; id.valid();) {
    const Expr& expr = unit_.expressions[id];
    switch (expr.kind) {
      case ExprKind::kVariable: {
        const Variable& variable = unit_.variables[expr.variable];
        if (variable.view) {
          set.Add(objects_.OfArea(variable.view->area));
        } else if (objects_.OfVariable(expr.variable).valid()) {
          set.Add(objects_.OfVariable(expr.variable));
        }
        return set;
      }
      case ExprKind::kString:
        set.Add(objects_.OfString(expr.string));
        return set;
      case ExprKind::kCall:  // a record
        set.Add(objects_.OfResult(expr.function));
        return set;
      case ExprKind::kIndex:
        if (unit_.types[unit_.expressions[expr.a].type].kind == TypeKind::kPointer) return TargetsOf(expr.a);
        id = expr.a;
        break;
      case ExprKind::kDereference:
        return TargetsOf(expr.a);
      case ExprKind::kMember:
      case ExprKind::kLoad:  // of a record
        id = expr.a;
        break;
      case ExprKind::kConditional: {
        set = ObjectsOf(expr.b);
        set.Add(ObjectsOf(expr.c));
        return set;
      }
      case ExprKind::kAssign:
        id = expr.a;
        break;
      case ExprKind::kComma:
        id = expr.b;
        break;
      case ExprKind::kPoison:
      case ExprKind::kConstant:
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
      case ExprKind::kAddress:
        return set;
    }
  }
  return set;
}

ObjectSet Facts::TargetsOf(ExprId pointer) const {
  ObjectSet set;
  for (ExprId id = pointer; id.valid();) {
    const Expr& expr = unit_.expressions[id];
    switch (expr.kind) {
      case ExprKind::kDecay:
      case ExprKind::kAddress:
        set.Add(ObjectsOf(expr.a));
        return set;
      case ExprKind::kLoad: {
        const Expr& source = unit_.expressions[expr.a];
        if (source.kind == ExprKind::kVariable) {
          set.Add(targets_[source.variable.index]);
        } else if (source.kind == ExprKind::kIndex && source.a.valid() &&
                   unit_.expressions[source.a].kind == ExprKind::kVariable) {
          const VariableId table = unit_.expressions[source.a].variable;
          if (unit_.variables[table].view) {
            set.Add(objects_.OfArea(unit_.variables[table].view->area));
          } else {
            set.Add(targets_[table.index]);
          }
        }
        return set;
      }
      case ExprKind::kAssign:
      case ExprKind::kCompoundAssign:
      case ExprKind::kIncrement: {
        const Expr& target = unit_.expressions[expr.a];
        if (target.kind == ExprKind::kVariable) set.Add(targets_[target.variable.index]);
        return set;
      }
      case ExprKind::kCast:
      case ExprKind::kConvert:
        id = expr.a;
        break;
      case ExprKind::kBinary:
        id = expr.a;
        break;
      case ExprKind::kComma:
        id = expr.b;
        break;
      case ExprKind::kConditional: {
        set = TargetsOf(expr.b);
        set.Add(TargetsOf(expr.c));
        return set;
      }
      case ExprKind::kCall: {
        const Function& callee = unit_.functions[expr.function];
        const bool copies = callee.system && !expr.arguments.empty() && unit_.TypeOf(id).kind == TypeKind::kPointer;
        if (!copies) {
          set.Add(result_targets_[expr.function.index]);
          return set;
        }
        id = expr.arguments[0];  // memset and relatives give their first argument
        break;
      }
      case ExprKind::kPoison:
      case ExprKind::kConstant:
      case ExprKind::kString:
      case ExprKind::kVariable:
      case ExprKind::kFunction:
      case ExprKind::kNull:
      case ExprKind::kUnary:
      case ExprKind::kAnd:
      case ExprKind::kOr:
      case ExprKind::kDereference:
      case ExprKind::kIndex:
      case ExprKind::kMember:
        return set;
    }
  }
  return set;
}

/// All assignments until nothing grows: sets are small and flows short, so that a few rounds are enough.
void Facts::FindTargets() {
  struct Assignment {
    ObjectSet* to;
    ExprId from;
  };
  std::vector<Assignment> flows;
  const auto is_pointer = [this](TypeId type) { return type.valid() && unit_.types[type].kind == TypeKind::kPointer; };
  const auto flow = [&](ObjectSet& to, TypeId type, ExprId from) {
    if (from.valid() && is_pointer(type)) flows.push_back({&to, from});
  };
  for (uint32_t i = 0; i < unit_.variables.size(); ++i) {
    for (const InitialValue& initial : unit_.variables[VariableId(i)].initial) {
      flow(targets_[i], initial.type, initial.value);
    }
  }
  for (const ExprId id : effects_.flows()) {
    const Expr& expr = unit_.expressions[id];
    if (expr.kind == ExprKind::kAssign && unit_.expressions[expr.a].kind == ExprKind::kVariable) {
      flow(targets_[unit_.expressions[expr.a].variable.index], unit_.expressions[expr.a].type, expr.b);
    } else if (expr.kind == ExprKind::kCall && expr.function.valid()) {
      const Function& callee = unit_.functions[expr.function];
      for (size_t i = 0; i < expr.arguments.size() && i < callee.parameters.size(); ++i) {
        const VariableId parameter = callee.parameters[i];
        flow(targets_[parameter.index], unit_.variables[parameter].type, expr.arguments[i]);
      }
    }
  }
  for (const FunctionId id : unit_.definitions) {
    if (!is_pointer(unit_.functions[id].result)) continue;
    ForEachStatement(unit_, unit_.functions[id].body, [&](StatementId statement) {
      if (unit_.statements[statement].kind != StatementKind::kReturn) return;
      flow(result_targets_[id.index], unit_.functions[id].result, unit_.statements[statement].expression);
    });
  }
  for (bool grown = true; grown;) {
    grown = false;
    for (const Assignment& each : flows) grown = each.to->Add(TargetsOf(each.from)) || grown;
  }
}

ObjectSet Facts::SystemWrites(const Expr& call) const {
  ObjectSet set;
  switch (RowOf(*unit_.functions[call.function].system).writes) {
    case FunctionWrites::kNothing:
      break;
    case FunctionWrites::kAxisRegisters:
      set.Add(objects_.OfArea(Area::kG));
      break;
    case FunctionWrites::kTarget:
      if (!call.arguments.empty()) set.Add(TargetsOf(call.arguments[0]));
      break;
  }
  return set;
}

ObjectSet Facts::WritesOf(const Expr& expr) const {
  switch (expr.kind) {
    case ExprKind::kAssign:
    case ExprKind::kCompoundAssign:
    case ExprKind::kIncrement:
      return ObjectsOf(expr.a);
    case ExprKind::kCall:
      if (!expr.function.valid()) return {};
      if (unit_.functions[expr.function].system) {
        ObjectSet set = SystemWrites(expr);
        set.Add(writes_[expr.function.index]);
        return set;
      }
      return writes_[expr.function.index];
    case ExprKind::kPoison:
    case ExprKind::kConstant:
    case ExprKind::kString:
    case ExprKind::kVariable:
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
    case ExprKind::kAddress:
    case ExprKind::kDereference:
    case ExprKind::kIndex:
    case ExprKind::kMember:
      break;
  }
  return {};
}

void Facts::FindWrites() {
  for (const FunctionId id : unit_.definitions) {
    ObjectSet& writes = writes_[id.index];
    for (const ExprId part : effects_.Of(id)) {
      const Expr& expr = unit_.expressions[part];
      const bool calls = expr.kind == ExprKind::kCall;
      if (!calls || (expr.function.valid() && unit_.functions[expr.function].system)) writes.Add(WritesOf(expr));
    }
  }
  for (bool grown = true; grown;) {
    grown = false;
    for (const FunctionId id : unit_.definitions) {
      for (const FunctionId callee : callees_[id.index]) grown = writes_[id.index].Add(writes_[callee.index]) || grown;
    }
    // A system function that the program replaces is called by other system functions, too.
    for (uint32_t i = 0; i < unit_.functions.size(); ++i) {
      if (!unit_.functions[FunctionId(i)].system) continue;
      for (const FunctionId callee : callees_[i]) grown = writes_[i].Add(writes_[callee.index]) || grown;
    }
  }
}

/// Functions that store into more places than this are looked at by objects only.
constexpr size_t kMaxCells = 64;

bool Facts::Stores::Add(const Stores& other) {
  const size_t before = cells.size();
  bool grown = objects.Add(other.objects);
  for (const Cell& cell : other.cells) {
    if (!objects.Has(cell.object)) cells.insert(cell);
  }
  grown = grown || cells.size() > before;
  if (cells.size() > kMaxCells) {
    for (const Cell& cell : cells) objects.Add(cell.object);
    cells.clear();
  }
  return grown;
}

std::optional<Cell> Facts::CellOfStore(const Expr& store) const {
  if (!IsStore(store)) return std::nullopt;
  const std::optional<StaticAddress> at = AddressOf(store.a);
  const Type& type = unit_.TypeOf(store.a);
  if (!at || type.kind == TypeKind::kPointer) return std::nullopt;  // what a pointer takes is the lowering's matter
  return Cell{at->object, at->offset, std::max(1u, type.size)};
}

void Facts::FindStores() {
  for (const FunctionId id : unit_.definitions) {
    Stores& stores = stores_[id.index];
    for (const ExprId part : effects_.Of(id)) {
      const Expr& expr = unit_.expressions[part];
      if (const std::optional<Cell> cell = CellOfStore(expr)) {
        stores.Add({.cells = {*cell}, .objects = {}});
      } else if (expr.kind != ExprKind::kCall) {
        stores.objects.Add(WritesOf(expr));
      } else if (expr.function.valid() && unit_.functions[expr.function].system) {
        stores.objects.Add(SystemWrites(expr));
      }
    }
  }
  for (bool grown = true; grown;) {
    grown = false;
    for (uint32_t i = 0; i < unit_.functions.size(); ++i) {
      for (const FunctionId callee : callees_[i]) grown = stores_[i].Add(stores_[callee.index]) || grown;
    }
  }
}

bool Facts::MayChange(const Expr& expr, const Cell& cell) const {
  if (const std::optional<Cell> stored = CellOfStore(expr)) return stored->Overlaps(cell);
  if (expr.kind != ExprKind::kCall) return WritesOf(expr).Has(cell.object);
  if (!expr.function.valid()) return false;
  if (unit_.functions[expr.function].system && SystemWrites(expr).Has(cell.object)) return true;
  const Stores& stores = stores_[expr.function.index];
  return stores.objects.Has(cell.object) ||
         std::ranges::any_of(stores.cells, [&cell](const Cell& stored) { return stored.Overlaps(cell); });
}

std::optional<StaticAddress> Facts::Moved(const std::optional<StaticAddress>& base, ExprId index, TypeId element,
                                          int64_t sign) const {
  const std::optional<int64_t> number = ConstantOf(index);
  if (!base || !number) return std::nullopt;
  return StaticAddress{base->object, base->offset + sign * *number * unit_.types[element].size};
}

std::optional<StaticAddress> Facts::AddressOf(ExprId lvalue) const {
  if (!lvalue.valid()) return std::nullopt;
  const Expr& expr = unit_.expressions[lvalue];
  switch (expr.kind) {
    case ExprKind::kVariable: {
      const Variable& variable = unit_.variables[expr.variable];
      if (variable.view) return StaticAddress{objects_.OfArea(variable.view->area), 0};
      const ObjectId object = objects_.OfVariable(expr.variable);
      if (!object.valid()) return std::nullopt;
      return StaticAddress{object, 0};
    }
    case ExprKind::kString:
      return StaticAddress{objects_.OfString(expr.string), 0};
    case ExprKind::kIndex: {
      const bool pointer = unit_.types[unit_.expressions[expr.a].type].kind == TypeKind::kPointer;
      return Moved(pointer ? PointeeOf(expr.a) : AddressOf(expr.a), expr.b, expr.type, 1);
    }
    case ExprKind::kDereference:
      return PointeeOf(expr.a);
    case ExprKind::kMember: {
      std::optional<StaticAddress> base = AddressOf(expr.a);
      const TypeId record = unit_.expressions[expr.a].type;
      if (base) base->offset += unit_.records[unit_.types[record].record].members[expr.member].offset;
      return base;
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
    case ExprKind::kCall:
      break;
  }
  return std::nullopt;
}

const Member* Facts::BitFieldOf(ExprId lvalue) const {
  const Expr& expr = unit_.expressions[lvalue];
  if (expr.kind != ExprKind::kMember) return nullptr;
  const Member& member = unit_.records[unit_.TypeOf(expr.a).record].members[expr.member];
  return member.is_bit_field ? &member : nullptr;
}

std::optional<Cell> Facts::IntegerCellOf(ExprId lvalue) const {
  const std::optional<StaticAddress> at = AddressOf(lvalue);
  if (!at || !IsInteger(unit_.TypeOf(lvalue)) || BitFieldOf(lvalue) != nullptr) return std::nullopt;
  return Cell{at->object, at->offset, unit_.TypeOf(lvalue).size};
}

std::optional<StaticAddress> Facts::PointeeOf(ExprId pointer) const {
  if (!pointer.valid()) return std::nullopt;
  const Expr& expr = unit_.expressions[pointer];
  switch (expr.kind) {
    case ExprKind::kDecay:
    case ExprKind::kAddress:
      return AddressOf(expr.a);
    case ExprKind::kCast:
      return PointeeOf(expr.a);
    case ExprKind::kBinary: {
      const bool adds = expr.binary == BinaryOp::kPointerAdd;
      if (!adds && expr.binary != BinaryOp::kPointerSubtract) return std::nullopt;
      return Moved(PointeeOf(expr.a), expr.b, unit_.types[expr.type].element, adds ? 1 : -1);
    }
    case ExprKind::kLoad: {
      const Expr& source = unit_.expressions[expr.a];
      if (source.kind != ExprKind::kIndex || unit_.expressions[source.a].kind != ExprKind::kVariable) {
        return std::nullopt;
      }
      const Variable& table = unit_.variables[unit_.expressions[source.a].variable];
      const std::optional<int64_t> number = ConstantOf(source.b);
      if (!table.view || !table.view->table || !number) return std::nullopt;
      return StaticAddress{objects_.OfArea(table.view->area), 2 * *number};  // word numbers for every type, 5.3
    }
    case ExprKind::kPoison:
    case ExprKind::kConstant:
    case ExprKind::kString:
    case ExprKind::kVariable:
    case ExprKind::kFunction:
    case ExprKind::kConvert:
    case ExprKind::kNull:
    case ExprKind::kUnary:
    case ExprKind::kAnd:
    case ExprKind::kOr:
    case ExprKind::kConditional:
    case ExprKind::kComma:
    case ExprKind::kAssign:
    case ExprKind::kCompoundAssign:
    case ExprKind::kIncrement:
    case ExprKind::kDereference:
    case ExprKind::kIndex:
    case ExprKind::kMember:
    case ExprKind::kCall:
      break;
  }
  return std::nullopt;
}

}  // namespace plcxx::hnc
