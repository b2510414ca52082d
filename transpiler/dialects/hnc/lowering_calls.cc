// Calls of the program's own functions (specification 6.4): arguments from right to left, structures by copies.

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

using ir::ValueId;

void Lowering::ForgetAfterCall(const Expr& expr) {
  for (const ObjectId object : facts_.WritesOf(expr).objects) flow_.Forget(object);
}

Lowering::CallResult Lowering::Call(ExprId id) {
  const Expr& expr = ExprAt(id);
  if (!expr.function.valid()) {
    for (size_t i = expr.arguments.size(); i-- > 0;) Execute(expr.arguments[i]);
    return {};
  }
  const Function& callee = unit_.functions[expr.function];
  if (callee.system) return CallSystem(expr);
  return CallFunction(expr);
}

Lowering::CallResult Lowering::CallFunction(const Expr& expr) {
  const Function& callee = unit_.functions[expr.function];
  const bool callable = callee.is_defined && routines_[expr.function.index].valid();
  std::vector<Value> numbers(expr.arguments.size());
  std::vector<Address> addresses(expr.arguments.size());
  std::vector<std::vector<ValueId>> records(expr.arguments.size());  // those that what is evaluated later may change
  for (size_t i = expr.arguments.size(); i-- > 0;) {
    if (i >= callee.parameters.size()) {
      Execute(expr.arguments[i]);
      continue;
    }
    const TypeId type = unit_.variables[callee.parameters[i]].type;
    switch (TypeAt(type).kind) {
      case TypeKind::kPointer:
        addresses[i] = EvaluatePointer(expr.arguments[i]);
        break;
      case TypeKind::kRecord:
        addresses[i] = RecordAddress(expr.arguments[i]);
        if (std::any_of(expr.arguments.begin(), expr.arguments.begin() + static_cast<std::ptrdiff_t>(i),
                        [this](ExprId later) { return HasEffects(later); })) {
          records[i] = LoadRecord(addresses[i], type);
        }
        break;
      default:
        numbers[i] = Convert(Evaluate(expr.arguments[i]), type);
        break;
    }
  }
  if (!callable || expr.arguments.size() != callee.parameters.size()) return {};
  std::vector<ValueId> arguments;
  for (size_t i = 0; i < callee.parameters.size(); ++i) {
    const VariableId parameter = callee.parameters[i];
    const TypeId type = unit_.variables[parameter].type;
    switch (TypeAt(type).kind) {
      case TypeKind::kPointer:
        arguments.push_back(OffsetOf(addresses[i]));
        if (pointer_places_[parameter.index].object.valid()) arguments.push_back(ObjectOf(addresses[i]));
        break;
      case TypeKind::kRecord: {
        Address to;
        to.targets.Add(objects_.OfVariable(parameter));
        if (records[i].empty()) {
          AssignRecord(to, addresses[i], type);
        } else {
          StoreRecord(to, records[i], type);
        }
        break;
      }
      default:
        arguments.push_back(numbers[i].id);
        break;
    }
  }
  const ValueId called = builder_.CallRoutine(routines_[expr.function.index], std::move(arguments));
  ForgetAfterCall(expr);
  CallResult result;
  switch (TypeAt(callee.result).kind) {
    case TypeKind::kInteger:
    case TypeKind::kReal: {
      result.value = Make(called, callee.result);
      const auto bounds = bounds_of_results_.find(expr.function.index);
      if (bounds != bounds_of_results_.end()) result.value->bounds = bounds->second;
      break;
    }
    case TypeKind::kPointer: {
      Address address;
      address.targets = facts_.ResultTargets(expr.function);
      address.index = called;
      address.index_bounds = {-0x80000000LL, 0x7FFFFFFF};
      const PointerPlaces& places = result_pointers_[expr.function.index];
      if (places.object.valid()) address.object = builder_.Load(places.object);
      result.address = address;
      break;
    }
    case TypeKind::kRecord: {
      Address address;
      address.targets.Add(objects_.OfResult(expr.function));
      result.address = address;
      break;
    }
    default:
      break;
  }
  return result;
}

}  // namespace plcxx::hnc
