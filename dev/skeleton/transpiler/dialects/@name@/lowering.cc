#include "transpiler/dialects/@name@/lowering.h"

#include <utility>

#include "transpiler/ir/builder.h"

namespace plcxx::@name@ {
namespace {

class Lowering {
 public:
  Lowering(const Program& tree, const Settings& settings) : tree_(tree), settings_(settings) {}

  ir::Program Run() {
    program_.dialect = "@name@";
    AddMemory();
    AddHostFunctions();
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

  void AddHostFunctions() {
    read_inputs_ = program_.host_functions.Add({.name = "read_inputs",
                                                .access = ir::HostAccess::kWritesState,
                                                .routine_exchange = true,
                                                .comment = "At the start of each period: fill the inputs."});
    write_outputs_ = program_.host_functions.Add({.name = "write_outputs",
                                                  .access = ir::HostAccess::kReadsState,
                                                  .routine_exchange = true,
                                                  .comment = "At the end of each period: deliver the outputs."});
  }

  ir::RoutineId AddRoutine(std::string name, ir::RoutineKind kind, std::string comment) {
    ir::Routine routine{.name = std::move(name), .kind = kind, .comment = std::move(comment)};
    routine.body = builder_.NewRegion();
    return program_.routines.Add(std::move(routine));
  }

  void AddRoutines() {
    init_ = AddRoutine("init", ir::RoutineKind::kInit, "Power-on: everything is 0.");
    fast_ = AddRoutine("fast", ir::RoutineKind::kFast, "The program, in every period.");
    period_ = AddRoutine("period", ir::RoutineKind::kSchedule, "One period of the control.");
  }

  void Period() {
    builder_.SetRange({});
    builder_.SetRegion(program_.routines[period_].body);
    builder_.CallHost(read_inputs_, {});
    builder_.CallRoutine(fast_, {});
    builder_.CallHost(write_outputs_, {});
    const ir::ValueId one = builder_.Constant(ir::Type::kI32, 1);
    builder_.Store(periods_, builder_.Pure(ir::OpKind::kAdd32, {builder_.Load(periods_), one}));
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
  ir::Builder builder_{program_};
  ir::PlaceId periods_;
  ir::HostFunctionId read_inputs_, write_outputs_;
  ir::RoutineId init_, fast_, period_;
};

}  // namespace

ir::Program Lower(const Program& tree, const Settings& settings) { return Lowering(tree, settings).Run(); }

}  // namespace plcxx::@name@
