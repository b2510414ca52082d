#include "transpiler/dialects/hnc/lowering/calls.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering/addresses.h"
#include "transpiler/dialects/hnc/lowering/conversions.h"
#include "transpiler/dialects/hnc/lowering/expressions.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/pointers.h"
#include "transpiler/dialects/hnc/lowering/records.h"
#include "transpiler/dialects/hnc/lowering/system_calls.h"

namespace plcxx::hnc {

using ir::ValueId;

CallResult Calls::Call(ExprId id) {
  const Expr& expr = ExprAt(id);
  const Function& callee = unit_.functions[expr.function];
  if (callee.system) return system_calls_.Call(expr);
  return CallFunction(expr);
}

CallResult Calls::CallFunction(const Expr& expr) {
  const Function& callee = unit_.functions[expr.function];
  const bool callable = callee.is_defined && placement_.routines[expr.function.index].valid();
  std::vector<Value> numbers(expr.arguments.size());
  std::vector<Address> addresses(expr.arguments.size());
  std::vector<std::vector<ValueId>> records(expr.arguments.size());  // those that what is evaluated later may change
  for (size_t i = expr.arguments.size(); i-- > 0;) {
    if (i >= callee.parameters.size()) {
      expressions_.Execute(expr.arguments[i]);
      continue;
    }
    const TypeId type = unit_.variables[callee.parameters[i]].type;
    switch (TypeAt(type).kind) {
      case TypeKind::kPointer:
        addresses[i] = addresses_.EvaluatePointer(expr.arguments[i]);
        break;
      case TypeKind::kRecord:
        addresses[i] = addresses_.RecordAddress(expr.arguments[i]);
        if (std::any_of(expr.arguments.begin(), expr.arguments.begin() + i,
                        [this](ExprId later) { return HasEffects(later); })) {
          records[i] = records_.Load(addresses[i], type);
        }
        break;
      case TypeKind::kVoid:
      case TypeKind::kInteger:
      case TypeKind::kReal:
      case TypeKind::kArray:
      case TypeKind::kFunction:
        numbers[i] = conversions_.Convert(expressions_.Evaluate(expr.arguments[i]), type);
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
        arguments.push_back(pointers_.OffsetOf(addresses[i]));
        if (placement_.pointers[parameter.index].object.valid()) arguments.push_back(pointers_.ObjectOf(addresses[i]));
        break;
      case TypeKind::kRecord: {
        Address to;
        to.targets.Add(objects_.OfVariable(parameter));
        if (records[i].empty()) {
          records_.Assign(to, addresses[i], type);
        } else {
          records_.Store(to, records[i], type);
        }
        break;
      }
      case TypeKind::kVoid:
      case TypeKind::kInteger:
      case TypeKind::kReal:
      case TypeKind::kArray:
      case TypeKind::kFunction:
        arguments.push_back(numbers[i].id);
        break;
    }
  }
  const ValueId called = builder_.CallRoutine(placement_.routines[expr.function.index], std::move(arguments));
  intervals_.ForgetAfterCall(expr);
  CallResult result;
  switch (TypeAt(callee.result).kind) {
    case TypeKind::kInteger:
    case TypeKind::kReal: {
      result.value = conversions_.Make(called, callee.result);
      if (const std::optional<Bounds> bounds = intervals_.ResultOf(expr.function)) result.value->bounds = *bounds;
      break;
    }
    case TypeKind::kPointer: {
      Address address;
      address.targets = facts_.ResultTargets(expr.function);
      address.index = called;
      address.index_bounds = {-0x80000000LL, 0x7FFFFFFF};
      const PointerPlaces& places = placement_.results[expr.function.index];
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
    case TypeKind::kVoid:
    case TypeKind::kArray:
    case TypeKind::kFunction:
      break;
  }
  return result;
}

}  // namespace plcxx::hnc
