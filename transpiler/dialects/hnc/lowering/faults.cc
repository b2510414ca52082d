#include "transpiler/dialects/hnc/lowering/faults.h"

#include <utility>

#include "transpiler/dialects/hnc/lowering/host_calls.h"
#include "transpiler/dialects/hnc/lowering/memory.h"
#include "transpiler/ir/host_functions.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

void Faults::AddRoutine() {
  const ir::PlaceId kept_code = memory_.AddScalar("fault_code", ir::Type::kI8);
  const ir::PlaceId kept_statement = memory_.AddScalar("fault_statement", ir::Type::kI32);
  const ir::PlaceId count = memory_.AddScalar("fault_count", ir::Type::kI32);
  if (settings_.faults == FaultsOption::kStop) {
    stop_ = memory_.AddScalar("stop", ir::Type::kBit);
    stopped_ = memory_.AddScalar("stopped", ir::Type::kBit);
  }
  routine_ =
      builder_.AddRoutine("record_fault", ir::RoutineKind::kSubroutine,
                          "A run-time fault: 1 division, 2 index, 3 loop; the statement by its number in the map.");
  const ir::SpaceId space = program_.spaces.Add(
      {.name = "record_fault", .title = "", .bytes = 16, .lifetime = ir::Lifetime::kRoutine, .own = true});
  const auto parameter = [&](std::string name, ir::Type type, uint32_t offset) {
    const ir::PlaceId place =
        program_.places.Add({.name = name, .address = {}, .type = type, .space = space, .offset = offset});
    program_.routines[routine_].parameters.push_back({.name = std::move(name), .type = type, .enumerators = {}});
    program_.routines[routine_].parameter_places.push_back(place);
    return place;
  };
  const ir::PlaceId code = parameter("code", ir::Type::kI8, 0), statement = parameter("statement", ir::Type::kI32, 8);
  builder_.SetRegion(program_.routines[routine_].body);
  builder_.SetRange({});
  builder_.Store(kept_code, builder_.Load(code));
  builder_.Store(kept_statement, builder_.Load(statement));
  builder_.Store(count, Pure(OpKind::kAdd32, {builder_.Load(count), Long(1)}));
  if (stop_.valid()) builder_.Store(stop_, builder_.Bit(1));
  ir::Parameter number{.name = "statement", .type = ir::Type::kI32, .enumerators = {}};
  number.is_statement = true;
  const ir::HostFunctionId host = host_calls_.Function(
      std::string(ir::kFaultFunction), {{.name = "code", .type = ir::Type::kI8, .enumerators = {}}, number},
      ir::Type::kNone, "A run-time fault: 1 division, 2 index, 3 loop, in the statement of the map with this number.");
  builder_.CallHost(host, {builder_.Load(code), builder_.Load(statement)});
}

void Faults::Record(Fault fault) {
  builder_.CallRoutine(routine_, {builder_.Constant(ir::Type::kI8, static_cast<uint64_t>(fault)),
                                  builder_.Constant(ir::Type::kI32, statement_.id, 16)});
}

void Faults::RecordWhen(ValueId condition, Fault fault) {
  builder_.When(condition, [&] { Record(fault); });
}

}  // namespace plcxx::hnc
