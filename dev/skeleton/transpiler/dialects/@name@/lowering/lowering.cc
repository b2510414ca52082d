#include "transpiler/dialects/@name@/lowering/lowering.h"

#include <utility>

#include "transpiler/dialects/common/builder.h"
#include "transpiler/dialects/common/host_calls.h"

namespace plcxx::@name@ {
namespace {

enum class HostCall : uint8_t { kReadInputs, kWriteOutputs, kCount };

const std::vector<dialects::HostRow<HostCall>>& HostRows() {
  static const std::vector<dialects::HostRow<HostCall>> rows = {
      {.call = HostCall::kReadInputs,
       .name = "read_inputs",
       .access = ir::HostAccess::kWritesState,
       .routine_exchange = true,
       .comment = "At the start of each period: fill the inputs."},
      {.call = HostCall::kWriteOutputs,
       .name = "write_outputs",
       .access = ir::HostAccess::kReadsState,
       .routine_exchange = true,
       .comment = "At the end of each period: deliver the outputs."},
  };
  return rows;
}

class Lowering {
 public:
  Lowering(const Program& tree, const Settings& settings) : tree_(tree), settings_(settings) {}

  ir::Program Run() {
    program_.dialect = "@name@";
    AddMemory();
    host_.Add(HostRows());
    AddRoutines();
    builder_.SetRegion(program_.routines[fast_].body);
    for (const Statement& statement : tree_.statements) Execute(statement);
    Period();
    FillSchedule();
    return std::move(program_);
  }

 private:
  void Execute(const Statement& statement) {
    builder_.SetRange(statement.range);
    switch (statement.instruction) {
      case Instruction::kUnsupported:
        return;  // reported
    }
  }

  void AddMemory() {
    const ir::SpaceId system =
        program_.spaces.Add({.name = "system", .title = "memory of the scheduler", .bytes = 4, .zones = {}, .initial = {}});
    periods_ = program_.places.Add({.name = "periods", .address = {}, .type = ir::Type::kI32, .space = system});
  }

  void AddRoutines() {
    init_ = builder_.AddRoutine("init", ir::RoutineKind::kInit, "Power-on: everything is 0.");
    fast_ = builder_.AddRoutine("fast", ir::RoutineKind::kFast, "The program, in every period.");
    period_ = builder_.AddRoutine("period", ir::RoutineKind::kSchedule, "One period of the control.");
  }

  void Period() {
    builder_.SetRange({});
    builder_.SetRegion(program_.routines[period_].body);
    host_(HostCall::kReadInputs);
    builder_.CallRoutine(fast_, {});
    host_(HostCall::kWriteOutputs);
    builder_.Increment(periods_);
  }

  void FillSchedule() {
    ir::Schedule& schedule = program_.schedule;
    schedule.init = init_;
    schedule.period = period_;
    schedule.fast_only = period_;
    schedule.period_ms = settings_.period_ms;
    schedule.slot_ms = settings_.period_ms;
    schedule.slow_done = periods_;
  }

  const Program& tree_;
  const Settings& settings_;
  ir::Program program_;
  dialects::Builder builder_{program_};
  dialects::HostCalls<HostCall> host_{builder_};
  ir::PlaceId periods_;
  ir::RoutineId init_, fast_, period_;
};

}  // namespace

ir::Program Lower(const Program& tree, const Settings& settings) { return Lowering(tree, settings).Run(); }

}  // namespace plcxx::@name@
