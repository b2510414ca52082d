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

Calls::Arguments Calls::EvaluateArguments(const Expr& expr) {
  const Function& callee = unit_.functions[expr.function];
  const size_t count = expr.arguments.size();
  Arguments arguments{.numbers = std::vector<Value>(count),
                      .addresses = std::vector<Address>(count),
                      .records = std::vector<std::vector<ValueId>>(count)};
  for (size_t i = count; i-- > 0;) {
    if (i >= callee.parameters.size()) {
      expressions_.Execute(expr.arguments[i]);
      continue;
    }
    const TypeId type = unit_.variables[callee.parameters[i]].type;
    switch (TypeAt(type).kind) {
      case TypeKind::kPointer:
        arguments.addresses[i] = addresses_.EvaluatePointer(expr.arguments[i]);
        break;
      case TypeKind::kRecord:
        arguments.addresses[i] = addresses_.RecordAddress(expr.arguments[i]);
        if (std::any_of(expr.arguments.begin(), expr.arguments.begin() + i,
                        [this](ExprId later) { return HasEffects(later); })) {
          arguments.records[i] = records_.Load(arguments.addresses[i], type);
        }
        break;
      case TypeKind::kVoid:
      case TypeKind::kInteger:
      case TypeKind::kReal:
      case TypeKind::kArray:
      case TypeKind::kFunction:
        arguments.numbers[i] = conversions_.Convert(expressions_.Evaluate(expr.arguments[i]), type);
        break;
    }
  }
  return arguments;
}

std::vector<ValueId> Calls::Pass(const Function& callee, const Arguments& arguments) {
  std::vector<ValueId> passed;
  for (size_t i = 0; i < callee.parameters.size(); ++i) {
    const VariableId parameter = callee.parameters[i];
    const TypeId type = unit_.variables[parameter].type;
    const Address& address = arguments.addresses[i];
    switch (TypeAt(type).kind) {
      case TypeKind::kPointer:
        passed.push_back(pointers_.OffsetOf(address));
        if (placement_.pointers[parameter.index].object.valid()) passed.push_back(pointers_.ObjectOf(address));
        break;
      case TypeKind::kRecord: {
        Address to;
        to.targets.Add(objects_.OfVariable(parameter));
        if (arguments.records[i].empty()) {
          records_.Assign(to, address, type);
        } else {
          records_.Store(to, arguments.records[i], type);
        }
        break;
      }
      case TypeKind::kVoid:
      case TypeKind::kInteger:
      case TypeKind::kReal:
      case TypeKind::kArray:
      case TypeKind::kFunction:
        passed.push_back(arguments.numbers[i].id);
        break;
    }
  }
  return passed;
}

CallResult Calls::ResultOf(FunctionId function, ValueId called) {
  const TypeId type = unit_.functions[function].result;
  CallResult result;
  switch (TypeAt(type).kind) {
    case TypeKind::kInteger:
    case TypeKind::kReal:
      result.value = conversions_.Make(called, type);
      if (const std::optional<Bounds> bounds = intervals_.ResultOf(function)) result.value->bounds = *bounds;
      break;
    case TypeKind::kPointer: {
      Address address;
      address.targets = facts_.ResultTargets(function);
      address.index = called;
      address.index_bounds = {-0x80000000LL, 0x7FFFFFFF};
      const PointerPlaces& places = placement_.results[function.index];
      if (places.object.valid()) address.object = builder_.Load(places.object);
      result.address = address;
      break;
    }
    case TypeKind::kRecord: {
      Address address;
      address.targets.Add(objects_.OfResult(function));
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

CallResult Calls::CallFunction(const Expr& expr) {
  const Function& callee = unit_.functions[expr.function];
  const bool callable = callee.is_defined && placement_.routines[expr.function.index].valid();
  const Arguments arguments = EvaluateArguments(expr);
  if (!callable || expr.arguments.size() != callee.parameters.size()) return {};
  std::vector<ValueId> passed = Pass(callee, arguments);
  const ValueId called = builder_.CallRoutine(placement_.routines[expr.function.index], std::move(passed));
  intervals_.ForgetAfterCall(expr);
  return ResultOf(expr.function, called);
}

}  // namespace plcxx::hnc
