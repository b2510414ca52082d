#include "transpiler/sim/core_operations.h"

#include "transpiler/sim/execution.h"
#include "transpiler/support/check.h"

namespace plcxx::sim::core {

using ir::Inst;
using ir::InstId;
using ir::RegionId;

namespace {

/// What an Exit means for the block or loop that it has come to.
Flow Leave(const Execution& execution, InstId block) { return execution.leaving == block ? Flow::kOn : Flow::kLeaving; }

HostAnswer CallHost(Execution& execution, const ir::Call& call) {
  std::vector<uint64_t> arguments;
  for (const ir::ValueId argument : call.arguments) arguments.push_back(execution.values[argument.index]);
  return execution.host.Answer(call, arguments, execution.time.now_ms, execution.memory);
}

}  // namespace

Flow Const(Execution&, InstId, const Inst&) { return Flow::kOn; }   // its value is there already
Flow Poison(Execution&, InstId, const Inst&) { return Flow::kOn; }  // 0, likewise

Flow Load(Execution& execution, InstId id, const Inst& inst) {
  const PlaceAccess& access = execution.code.places[inst.payload];
  execution.values[id.index] = execution.memory.Get(access, access.indexed ? execution.values[inst.a] : 0);
  return Flow::kOn;
}

Flow Store(Execution& execution, InstId, const Inst& inst) {
  const PlaceAccess& access = execution.code.places[inst.payload];
  Assign(execution, access, access.indexed ? execution.values[inst.b] : 0, execution.values[inst.a]);
  return Flow::kOn;
}

Flow UpdateText(Execution& execution, InstId, const Inst& inst) {
  plcxx::UpdateText(execution.memory.instances().Get<plcxx::TextFlag>(inst.payload),
                    execution.memory.instances().Get<plcxx::TextInbox>(inst.a),
                    execution.program.texts[ir::TextId(inst.b)].c_str());
  Stepped(execution, inst.payload);
  return Flow::kOn;
}

Flow Statement(Execution& execution, InstId, const Inst& inst) {
  const ir::StatementId id(inst.payload);
  if (!IsCareful(execution)) {
    execution.current = {.statement = id};
    return Flow::kOn;
  }
  const ir::Statement& statement = execution.program.statements[id];
  const bool off = execution.switched_off.Has(id);
  execution.current = {.statement = id,
                       .skipped = off && !statement.opens_block && !statement.closes_block,
                       .head_is_false = off && statement.opens_block};
  if (!execution.at_statement || !execution.at_statement(id)) return Flow::kOn;
  Stop(execution);
  return Flow::kLeaving;
}

Flow If(Execution& execution, InstId, const Inst& inst) {
  const bool condition = execution.values[inst.a] != 0 && !execution.current.head_is_false;
  return Execute(execution, RegionId(condition ? inst.b : inst.c));
}

Flow Switch(Execution& execution, InstId, const Inst& inst) {
  const std::vector<ir::SwitchCase>& cases = execution.program.switches[ir::SwitchId(inst.payload)].cases;
  const uint64_t selector = execution.values[inst.a];
  size_t chosen = cases.size();
  for (size_t i = 0; i < cases.size(); ++i) {
    // As in C, the default is taken when no other case is, wherever it stands.
    if (cases[i].values.empty()) chosen = i;
  }
  for (size_t i = 0; i < cases.size(); ++i) {
    for (const uint64_t value : cases[i].values) {
      if (value == selector) chosen = i;
    }
  }
  for (size_t i = chosen; i < cases.size(); ++i) {
    if (Execute(execution, cases[i].region) == Flow::kLeaving) return Flow::kLeaving;
    if (!cases[i].falls_through) break;
  }
  return Flow::kOn;
}

Flow Loop(Execution& execution, InstId id, const Inst& inst) {
  if (execution.current.head_is_false) return Flow::kOn;
  const ir::Loop& loop = execution.program.loops[ir::LoopId(inst.payload)];
  for (uint64_t round = 0;; ++round) {
    if (loop.condition.valid()) {
      if (Execute(execution, loop.condition) == Flow::kLeaving) return Leave(execution, id);
      if (execution.values[execution.program.regions[loop.condition].insts.back().index] == 0) return Flow::kOn;
    }
    bool exhausted = false;
    switch (loop.kind) {
      case ir::LoopBound::kProven:
        if (round >= loop.bound && execution.changes.is_changed()) {
          Stop(execution);
          return Flow::kLeaving;
        }
        PLCXX_CHECK(round < loop.bound);
        break;
      case ir::LoopBound::kGuard:
        exhausted = round >= loop.bound;
        break;
      case ir::LoopBound::kBudget:
        break;
    }
    execution.repeats = false;
    const Flow flow = Execute(execution, exhausted ? loop.exhausted : loop.body);
    if (flow == Flow::kLeaving) {
      if (execution.leaving != id || !execution.repeats) return Leave(execution, id);
      continue;
    }
    if (exhausted || loop.kind == ir::LoopBound::kBudget) return Flow::kOn;
    // When it has stopped: a step itself leaves nothing.
    if (Execute(execution, loop.step) == Flow::kLeaving) return Leave(execution, id);
  }
}

Flow Block(Execution& execution, InstId id, const Inst& inst) {
  return Execute(execution, RegionId(inst.a)) == Flow::kLeaving ? Leave(execution, id) : Flow::kOn;
}

Flow Exit(Execution& execution, InstId, const Inst& inst) {
  if (ir::ValueId(inst.a).valid() && execution.values[inst.a] == 0) return Flow::kOn;
  execution.leaving = InstId(inst.payload);
  execution.repeats = false;
  return Flow::kLeaving;
}

Flow Repeat(Execution& execution, InstId, const Inst& inst) {
  if (ir::ValueId(inst.a).valid() && execution.values[inst.a] == 0) return Flow::kOn;
  const ir::LoopId loop(execution.program[InstId(inst.payload)].payload);
  const PlaceAccess& budget = execution.code.places[execution.program.loops[loop].budget.index];
  const uint64_t left = execution.memory.Get(budget, 0);
  if (left == 0) return Execute(execution, RegionId(inst.b));
  Assign(execution, budget, 0, left - 1);
  execution.leaving = InstId(inst.payload);
  execution.repeats = true;
  return Flow::kLeaving;
}

Flow Call(Execution& execution, InstId id, const Inst& inst) {
  const ir::Call& call = execution.changes.CallOf(inst);
  const ir::Routine& routine = execution.program.routines[call.routine];
  const bool is_partition = routine.kind != ir::RoutineKind::kSubroutine;
  const LocalStretches& locals = execution.code.locals[call.routine.index];
  const size_t kept_from = execution.locals.kept();
  if (is_partition) {
    execution.locals.Keep(execution.memory, locals);
    execution.locals.Begin(execution.memory, locals);
  }
  for (size_t i = 0; i < call.arguments.size() && i < routine.parameter_places.size(); ++i) {
    Assign(execution, execution.code.places[routine.parameter_places[i].index], 0,
           execution.values[call.arguments[i].index]);
  }
  Run(execution, call.routine);
  if (routine.result_place.valid())
    execution.values[id.index] = execution.memory.Get(execution.code.places[routine.result_place.index], 0);
  if (is_partition) execution.locals.PutBack(execution.memory, locals, kept_from);
  return execution.stopped ? Flow::kLeaving : Flow::kOn;
}

Flow HostCall(Execution& execution, InstId id, const Inst& inst) {
  const ir::Call& call = execution.changes.CallOf(inst);
  const HostAnswer answer = CallHost(execution, call);
  execution.values[id.index] = answer.result;
  if (call.out.valid() && answer.out) Assign(execution, execution.code.places[call.out.index], 0, *answer.out);
  return Flow::kOn;
}

// Structuring has replaced both; the verifier refuses them in what comes here.
Flow Jump(Execution&, InstId, const Inst&) { PLCXX_UNREACHABLE(); }
Flow Label(Execution&, InstId, const Inst&) { PLCXX_UNREACHABLE(); }

}  // namespace plcxx::sim::core
