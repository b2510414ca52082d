// Run-time faults (specification 6.9): a record in memory and a call of the host, as one routine.

#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

ir::HostFunctionId Lowering::Host(std::string name, std::vector<ir::Parameter> parameters, ir::Type result,
                                  std::string comment, ir::HostAccess access) {
  const auto found = host_.find(name);
  if (found != host_.end()) return found->second;
  const bool exchange = access != ir::HostAccess::kNone;
  const ir::HostFunctionId id = program_.host_functions.Add({.name = name,
                                                             .parameters = std::move(parameters),
                                                             .result = result,
                                                             .out = {},
                                                             .access = access,
                                                             .routine_exchange = exchange,
                                                             .comment = std::move(comment)});
  host_.emplace(std::move(name), id);
  return id;
}

void Lowering::CallCritical(const std::string& name) {
  const bool enters = name == "critical_enter";
  builder_.CallHost(Host(name, {}, ir::Type::kNone,
                         enters ? "asm cli: nothing may interrupt from here on."
                                : "asm sti, or the end of a part that has not executed one."),
                    {});
}

/// Set from `asm cli` to `asm sti`, or to the end of the part (6.8).
ir::PlaceId Lowering::CriticalFlag() {
  if (!critical_flag_.valid()) critical_flag_ = AddScalar("critical", ir::Type::kBit);
  return critical_flag_;
}

void Lowering::EndCritical() {
  if (!critical_flag_.valid()) return;
  builder_.When(builder_.Load(critical_flag_), [&] {
    builder_.Store(critical_flag_, builder_.Bit(0));
    CallCritical("critical_leave");
  });
}

void Lowering::AddFaultRoutine() {
  fault_code_ = AddScalar("fault_code", ir::Type::kI8);
  fault_statement_ = AddScalar("fault_statement", ir::Type::kI32);
  fault_count_ = AddScalar("fault_count", ir::Type::kI32);
  if (settings_.faults == FaultsOption::kStop) {
    stop_ = AddScalar("stop", ir::Type::kBit);
    stopped_ = AddScalar("stopped", ir::Type::kBit);
  }
  fault_ =
      builder_.AddRoutine("record_fault", ir::RoutineKind::kSubroutine,
                          "A run-time fault: 1 division, 2 index, 3 loop; the statement by its number in the map.");
  const ir::SpaceId space = program_.spaces.Add(
      {.name = "record_fault", .title = "", .bytes = 16, .lifetime = ir::Lifetime::kRoutine, .own = true});
  const auto parameter = [&](std::string name, ir::Type type, uint32_t offset) {
    const ir::PlaceId place =
        program_.places.Add({.name = name, .address = {}, .type = type, .space = space, .offset = offset});
    program_.routines[fault_].parameters.push_back({.name = std::move(name), .type = type, .enumerators = {}});
    program_.routines[fault_].parameter_places.push_back(place);
    return place;
  };
  const ir::PlaceId code = parameter("code", ir::Type::kI8, 0), statement = parameter("statement", ir::Type::kI32, 8);
  builder_.SetRegion(program_.routines[fault_].body);
  builder_.SetRange({});
  builder_.Store(fault_code_, builder_.Load(code));
  builder_.Store(fault_statement_, builder_.Load(statement));
  builder_.Store(fault_count_, Pure(OpKind::kAdd32, {builder_.Load(fault_count_), Long(1)}));
  if (stop_.valid()) builder_.Store(stop_, builder_.Bit(1));
  ir::Parameter number{.name = "statement", .type = ir::Type::kI32, .enumerators = {}};
  number.is_statement = true;
  const ir::HostFunctionId host =
      Host("fault", {{.name = "code", .type = ir::Type::kI8, .enumerators = {}}, number}, ir::Type::kNone,
           "A run-time fault: 1 division, 2 index, 3 loop, in the statement of the map with this number.");
  builder_.CallHost(host, {builder_.Load(code), builder_.Load(statement)});
}

void Lowering::RecordFault(Fault fault) {
  if (index_is_checked_) return;
  builder_.CallRoutine(fault_, {builder_.Constant(ir::Type::kI8, static_cast<uint64_t>(fault)),
                                builder_.Constant(ir::Type::kI32, statement_id_, 16)});
}

void Lowering::FaultWhen(ValueId condition, Fault fault) {
  if (index_is_checked_) return;
  const ir::Inst& inst = program_[condition];
  if (inst.op == ir::OpKind::kConst && inst.a == 0) return;
  builder_.When(condition, [&] { RecordFault(fault); });
}

}  // namespace plcxx::hnc
