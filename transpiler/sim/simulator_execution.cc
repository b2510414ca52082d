// The simulator's inner part: regions and instructions.

#include <utility>

#include "transpiler/ir/uses.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/support/check.h"

namespace plcxx::sim {

using ir::Inst;
using ir::InstId;
using ir::RegionId;

void Simulator::Run(ir::RoutineId id) {
  if (!id.valid()) return;
  const ir::Routine& routine = program_.routines[id];
  // A switched-off head in the caller says nothing about the conditions of the called routine.
  const Current caller = std::exchange(current_, {.statement = current_.statement});
  for (const RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
    const Flow flow = Execute(region);
    if (stopped_) break;
    PLCXX_CHECK(flow == Flow::kOn);
  }
  current_ = caller;
}

void Simulator::RunPartition(ir::RoutineId routine) {
  if (!routine.valid()) return;
  BeginLocals(locals_[routine.index]);
  Run(routine);
}

void Simulator::BeginLocals(const LocalStretches& locals) {
  for (const auto& [space, begin, end] : locals) spaces_[space].Renew(begin, end - begin);
}

void Simulator::KeepLocals(const LocalStretches& locals) {
  for (const auto& [space, begin, end] : locals) {
    const size_t at = kept_locals_.size();
    kept_locals_.resize(at + size_t{ForcedBytes::kKeptForEach} * (end - begin));
    spaces_[space].Keep(begin, end - begin, &kept_locals_[at]);
  }
}

void Simulator::PutBackLocals(const LocalStretches& locals, size_t from) {
  size_t at = from;
  for (const auto& [space, begin, end] : locals) at += spaces_[space].PutBack(begin, end - begin, &kept_locals_[at]);
  kept_locals_.resize(from);
}

bool Simulator::Stops() {
  constexpr uint32_t kRegionsBetween = 4096;
  if (!stopped_ && stop_ && ++regions_ == kRegionsBetween) {
    regions_ = 0;
    stopped_ = stop_();
    if (stopped_) leaving_ = InstId();
  }
  return stopped_;
}

Flow Simulator::Execute(RegionId region) {
  if (!region.valid()) return Flow::kOn;
  if (Stops()) return Flow::kLeaving;
  const Current outer = current_;
  const Flow flow = is_careful()                ? ExecuteWithCare(region)
                    : region == changed_region_ ? ExecuteChangedRegion(decoded_regions_[region.index])
                    : given_.empty()            ? ExecuteAll<false>(decoded_regions_[region.index])
                                                : ExecuteAll<true>(decoded_regions_[region.index]);
  current_ = outer;
  return flow;
}

template <bool kNotes>
Flow Simulator::ExecuteAll(const DecodedRegion& region) {
  const uint32_t count = region.end - region.begin;
  executed_ += count;
  uint32_t done = count;
  Flow flow = Flow::kOn;
  const Decoded* const ready_end = ready_.data() + region.ready_end;
  for (const Decoded* inst = ready_.data() + region.ready_begin; inst != ready_end; ++inst) {
    flow = inst->execute(*this, *inst);
    if constexpr (kNotes) Note(inst->id);
    if (flow == Flow::kOn) continue;
    done = inst->order + 1;
    break;
  }
  executed_ -= count - done;
  if constexpr (kNotes) {
    for (const Decoded* inst = decoded_.data() + region.constants; inst != decoded_.data() + region.end; ++inst) {
      if (inst->order < done) Note(inst->id);
    }
  }
  return flow;
}

Flow Simulator::ExecuteWithCare(RegionId region) {
  Flow flow = Flow::kOn;
  for (const InstId id : program_.regions[region].insts) {
    const Inst& inst = program_[id];
    if (current_.skipped && inst.op != ir::OpKind::kStatement) {
      // The statement is switched off; what a jump of it made may hold others.
      if (ir::OwnsRegions(inst)) flow = ExecuteOthers(id, inst);
      if (flow == Flow::kLeaving) break;
      continue;
    }
    ++executed_;
    const Decoded& decoded = decoded_[decoded_at_[id.index]];
    flow = looks_for_differences_ ? ExecuteLookingForDifferences(decoded) : decoded.execute(*this, decoded);
    if (!given_.empty()) Note(id.index);
    if (flow == Flow::kLeaving) break;
  }
  return flow;
}

Flow Simulator::ExecuteConst(InstId, const Inst&) { return Flow::kOn; }   // its value is there already
Flow Simulator::ExecutePoison(InstId, const Inst&) { return Flow::kOn; }  // 0, likewise

Flow Simulator::ExecuteLoad(InstId id, const Inst& inst) {
  const PlaceAccess& access = places_[inst.payload];
  values_[id.index] = Get(access, access.indexed ? values_[inst.a] : 0);
  return Flow::kOn;
}

Flow Simulator::ExecuteStore(InstId, const Inst& inst) {
  const PlaceAccess& access = places_[inst.payload];
  Set(access, access.indexed ? values_[inst.b] : 0, values_[inst.a], Writer::kProgram);
  return Flow::kOn;
}

Flow Simulator::ExecuteUpdateText(InstId, const Inst& inst) {
  plcxx::UpdateText(instances_.Get<plcxx::TextFlag>(inst.payload), instances_.Get<plcxx::TextInbox>(inst.a),
                    program_.texts[ir::TextId(inst.b)].c_str());
  Stepped(inst.payload);
  return Flow::kOn;
}

Flow Simulator::ExecuteStatement(InstId, const Inst& inst) {
  const ir::StatementId id(inst.payload);
  if (!is_careful()) {
    current_ = {.statement = id};
    return Flow::kOn;
  }
  const ir::Statement& statement = program_.statements[id];
  const bool off = switched_off_[id.index];
  current_ = {.statement = id,
              .skipped = off && !statement.opens_block && !statement.closes_block,
              .head_is_false = off && statement.opens_block};
  if (!at_statement_ || !at_statement_(id)) return Flow::kOn;
  stopped_ = true;
  leaving_ = InstId();
  return Flow::kLeaving;
}

Flow Simulator::ExecuteIf(InstId, const Inst& inst) {
  const bool condition = values_[inst.a] != 0 && !current_.head_is_false;
  return Execute(RegionId(condition ? inst.b : inst.c));
}

/// Of a statement that is switched off: regions that jumps made, with the other statements in them.
Flow Simulator::ExecuteOthers(InstId id, const Inst& inst) {
  if (inst.op == ir::OpKind::kBlock) return ExecuteBlock(id, inst);
  if (inst.op == ir::OpKind::kLoop) {
    const bool of_jumps = program_.loops[ir::LoopId(inst.payload)].kind == ir::LoopBound::kBudget;
    return of_jumps ? ExecuteLoop(id, inst) : Flow::kOn;
  }
  if (inst.op != ir::OpKind::kIf) return Flow::kOn;
  switch (static_cast<ir::IfOrigin>(inst.payload)) {
    case ir::IfOrigin::kSource:
      return Flow::kOn;
    case ir::IfOrigin::kJumps:
      return Execute(RegionId(inst.c));
    case ir::IfOrigin::kStays:
      return Execute(RegionId(inst.b));
  }
  PLCXX_UNREACHABLE();
}

Flow Simulator::ExecuteSwitch(InstId, const Inst& inst) {
  const std::vector<ir::SwitchCase>& cases = program_.switches[ir::SwitchId(inst.payload)].cases;
  const uint64_t selector = values_[inst.a];
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
    if (Execute(cases[i].region) == Flow::kLeaving) return Flow::kLeaving;
    if (!cases[i].falls_through) break;
  }
  return Flow::kOn;
}

Flow Simulator::ExecuteLoop(InstId id, const Inst& inst) {
  if (current_.head_is_false) return Flow::kOn;
  const ir::Loop& loop = program_.loops[ir::LoopId(inst.payload)];
  for (uint64_t round = 0;; ++round) {
    if (loop.condition.valid()) {
      if (Execute(loop.condition) == Flow::kLeaving) return Leave(id);
      if (values_[program_.regions[loop.condition].insts.back().index] == 0) return Flow::kOn;
    }
    bool exhausted = false;
    switch (loop.kind) {
      case ir::LoopBound::kProven:
        if (round >= loop.bound && changed_) {
          stopped_ = true;
          leaving_ = InstId();
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
    repeats_ = false;
    const Flow flow = Execute(exhausted ? loop.exhausted : loop.body);
    if (flow == Flow::kLeaving) {
      if (leaving_ != id || !repeats_) return Leave(id);
      continue;
    }
    if (exhausted || loop.kind == ir::LoopBound::kBudget) return Flow::kOn;
    if (Execute(loop.step) == Flow::kLeaving) return Leave(id);  // when it has stopped: a step itself leaves nothing
  }
}

Flow Simulator::ExecuteBlock(InstId id, const Inst& inst) {
  return Execute(RegionId(inst.a)) == Flow::kLeaving ? Leave(id) : Flow::kOn;
}

Flow Simulator::Leave(InstId block) { return leaving_ == block ? Flow::kOn : Flow::kLeaving; }

Flow Simulator::ExecuteExit(InstId, const Inst& inst) {
  if (ir::ValueId(inst.a).valid() && values_[inst.a] == 0) return Flow::kOn;
  leaving_ = InstId(inst.payload);
  repeats_ = false;
  return Flow::kLeaving;
}

Flow Simulator::ExecuteRepeat(InstId, const Inst& inst) {
  if (ir::ValueId(inst.a).valid() && values_[inst.a] == 0) return Flow::kOn;
  const ir::LoopId loop(program_[InstId(inst.payload)].payload);
  const PlaceAccess& budget = places_[program_.loops[loop].budget.index];
  const uint64_t left = Get(budget, 0);
  if (left == 0) return Execute(RegionId(inst.b));
  Set(budget, 0, left - 1, Writer::kProgram);
  leaving_ = InstId(inst.payload);
  repeats_ = true;
  return Flow::kLeaving;
}

Flow Simulator::ExecuteCall(InstId id, const Inst& inst) {
  const ir::Call& call = CallOf(inst);
  const ir::Routine& routine = program_.routines[call.routine];
  const bool is_partition = routine.kind != ir::RoutineKind::kSubroutine;
  const LocalStretches& locals = locals_[call.routine.index];
  const size_t kept_from = kept_locals_.size();
  if (is_partition) {
    KeepLocals(locals);
    BeginLocals(locals);
  }
  for (size_t i = 0; i < call.arguments.size() && i < routine.parameter_places.size(); ++i) {
    Set(places_[routine.parameter_places[i].index], 0, values_[call.arguments[i].index], Writer::kProgram);
  }
  Run(call.routine);
  if (routine.result_place.valid()) values_[id.index] = Get(places_[routine.result_place.index], 0);
  if (is_partition) PutBackLocals(locals, kept_from);
  return stopped_ ? Flow::kLeaving : Flow::kOn;
}

Flow Simulator::ExecuteHostCall(InstId id, const Inst& inst) {
  const ir::Call& call = CallOf(inst);
  const HostAnswer answer = CallHost(call);
  values_[id.index] = answer.result;
  if (call.out.valid() && answer.out) Set(places_[call.out.index], 0, *answer.out, Writer::kProgram);
  return Flow::kOn;
}

HostAnswer Simulator::CallHost(const ir::Call& call) {
  const ir::Schedule& schedule = program_.schedule;
  if (call.host == schedule.now) return {.result = now_ms_, .out = {}};
  std::vector<uint64_t> arguments;
  for (const ir::ValueId argument : call.arguments) arguments.push_back(values_[argument.index]);
  if (!program_.host_functions[call.host].routine_exchange) events_.push_back({call.host, arguments, call.exchange});
  if (call.host == schedule.retentive_load) {
    LoadRetentive();
    return {};
  }
  if (call.host == schedule.retentive_store) {
    StoreRetentive();
    return {};
  }
  return answers_ ? answers_(call.host, arguments) : HostAnswer{};
}

// Structuring has replaced both; the verifier refuses them in what comes here.
Flow Simulator::ExecuteJump(InstId, const Inst&) { PLCXX_UNREACHABLE(); }
Flow Simulator::ExecuteLabel(InstId, const Inst&) { PLCXX_UNREACHABLE(); }

}  // namespace plcxx::sim
