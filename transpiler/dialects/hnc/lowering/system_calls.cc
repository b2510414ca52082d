#include "transpiler/dialects/hnc/lowering/system_calls.h"

#include <string>
#include <utility>
#include <vector>

#include "transpiler/dialects/hnc/lowering/conversions.h"
#include "transpiler/dialects/hnc/lowering/expressions.h"
#include "transpiler/dialects/hnc/lowering/faults.h"
#include "transpiler/dialects/hnc/lowering/handlers.h"
#include "transpiler/dialects/hnc/lowering/host_calls.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/library_calls.h"
#include "transpiler/dialects/hnc/lowering/locals.h"
#include "transpiler/dialects/hnc/lowering/stated_facts.h"
#include "transpiler/dialects/hnc/lowering/system_functions.h"
#include "transpiler/dialects/hnc/lowering/system_routines.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

/// The condition under which a number of an axis or handwheel is none; none: it is one, or that has been reported.
ValueId SystemCalls::NumberIsOutside(const Value& number, uint32_t count, const Expr& call, size_t argument,
                                     bool& bad) {
  const bool axis = count == kAxes;
  const std::optional<int64_t> known = KnownInteger(number);
  if (known) {
    if (*known >= 0 && *known < count) return {};
    const source::Range range = ExprAt(call.arguments[argument]).range;
    if (axis) {
      diagnostics_.Report(range, diag::HncAxisNumber, *known);
    } else {
      diagnostics_.Report(range, diag::HncIndexOf, "handwheel number " + std::to_string(*known) + " is outside 0 to 3");
    }
    bad = true;
    return {};
  }
  if (number.bounds.Within({0, static_cast<int64_t>(count) - 1})) {
    stated_.CheckBounds(ir::FactKind::kIndex, number);
    return {};
  }
  return Pure(OpKind::kGreater16, {number.id, Word(count - 1)});
}

CallResult SystemCalls::Call(const Expr& expr) {
  const SystemFunction function = *unit_.functions[expr.function].system;
  if (function == SystemFunction::kSetMstFunc) {
    handlers_.Register(expr);
    return {};
  }
  const SystemSignature* const signature = SignatureOf(function);
  if (signature == nullptr) return library_.Call(expr);
  const size_t count = signature->count();
  if (expr.arguments.size() != count) return {};
  std::vector<Value> values(count);
  for (size_t i = count; i-- > 0;) {
    const TypeId type = signature->parameters[i].type == ir::Type::kI32 ? long_ : int_;
    values[i] = conversions_.Convert(expressions_.Evaluate(expr.arguments[i]), type);
  }
  bool bad = false;
  ValueId outside;
  for (size_t i = 0; i < count; ++i) {
    if (signature->parameters[i].count == 0) continue;
    const ValueId is_none = NumberIsOutside(values[i], signature->parameters[i].count, expr, i, bad);
    if (is_none.valid()) outside = outside.valid() ? Pure(OpKind::kBitOr, {outside, is_none}) : is_none;
  }
  if (bad) return {};
  const ir::Type type = signature->result_type();
  ir::PlaceId kept;
  const auto call = [&] {
    std::vector<ValueId> arguments;
    for (const Value& value : values) arguments.push_back(value.id);
    ValueId called;
    if (settings_.sysfunc == SysfuncOption::kHost) {
      std::vector<ir::Parameter> of_host;
      for (size_t i = 0; i < count; ++i) {
        const SystemParameter& parameter = signature->parameters[i];
        of_host.push_back({.name = std::string(parameter.name), .type = parameter.type, .enumerators = {}});
      }
      const ir::HostFunctionId host =
          host_calls_.Function(std::string(signature->host_name), std::move(of_host), type,
                               std::string(signature->comment), ir::HostAccess::kWritesState);
      program_.host_functions[host].routine_exchange = false;
      called = builder_.CallHost(host, std::move(arguments));
    } else {
      const ValueId by_zero = system_routines_.DividesByZero(function, arguments);
      if (by_zero.valid()) faults_.RecordWhen(by_zero, Fault::kDivision);
      called = builder_.CallRoutine(system_routines_.Routine(function), std::move(arguments));
    }
    if (kept.valid()) builder_.Store(kept, called);
    return called;
  };
  ValueId called;
  if (outside.valid()) {
    if (type != ir::Type::kNone) {
      kept = locals_.Add("answer", type);
      builder_.Store(kept, builder_.Constant(type, signature->outside));
    }
    builder_.Choose(outside, [&] { faults_.Record(Fault::kIndex); }, call);
    if (kept.valid()) called = builder_.Load(kept);
  } else {
    called = call();
  }
  intervals_.ForgetAfterCall(expr);
  CallResult result;
  if (type != ir::Type::kNone) result.value = conversions_.Make(called, type == ir::Type::kI32 ? long_ : int_);
  if (signature->result == SystemResult::kTruth) result.value->bounds = {0, 1};
  return result;
}

}  // namespace plcxx::hnc
