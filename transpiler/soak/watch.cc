#include "transpiler/soak/watch.h"

#include <algorithm>
#include <utility>

#include "transpiler/engines/lockstep.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/facts.h"
#include "transpiler/ir/host_functions.h"
#include "transpiler/ir/zones.h"
#include "transpiler/prove/machine/version.h"

namespace plcxx::soak {
namespace {

bool ContainsCallOf(const ir::Program& program, ir::RegionId region, const std::vector<bool>& functions) {
  bool found = false;
  ir::ForEachInst(program, region, [&](ir::InstId id) {
    if (ir::Info(program[id].op).shape != ir::Shape::kHostCall) return;
    found = found || functions[program.calls[ir::CallId(program[id].payload)].host.index];
  });
  return found;
}

}  // namespace

WatchPlan::WatchPlan(const scenarios::ProveMachine& machine, std::vector<prove::properties::Property> properties)
    : machine_(machine), properties_(std::move(properties)) {
  for (const ir::HostFunction& function : program().host_functions) is_fault_.push_back(ir::ReportsFault(function));
  if (const ir::HostFunctionId id = ir::FalseFactOf(program()); id.valid()) is_fault_[id.index] = true;
  for (uint32_t i = 0; i < program().statements.size(); ++i) {
    statement_of_id_.emplace(program().statements[ir::StatementId(i)].id, ir::StatementId(i));
  }
  FindGuards();
  FindOutputs();
}

std::string WatchPlan::PlaceOf(ir::StatementId statement) const {
  const source::SourceManager& sources = *machine_.compilation.sources;
  if (!statement.valid() || sources.size() == 0) return "the control's schedule";
  const source::Position position = sources.Locate(program().statements[statement].range.begin);
  if (position.line == 0) return "the program";
  return sources.Get(position.file).path + ":" + std::to_string(position.line);
}

std::optional<Cause> WatchPlan::FaultOf(const sim::HostEvent& event) const {
  if (!is_fault_[event.function.index]) return std::nullopt;
  const ir::HostFunction& function = program().host_functions[event.function];
  Cause cause{.kind = CauseKind::kFault, .key = function.name, .text = function.name, .function = function.name};
  std::string where, numbers;
  const bool is_named = std::ranges::any_of(
      function.parameters, [](const ir::Parameter& parameter) { return !parameter.enumerators.empty(); });
  for (size_t i = 0; i < function.parameters.size() && i < event.arguments.size(); ++i) {
    const ir::Parameter& parameter = function.parameters[i];
    const uint64_t value = event.arguments[i];
    if (parameter.is_statement) {
      const auto statement = statement_of_id_.find(static_cast<uint32_t>(value));
      if (statement != statement_of_id_.end()) where = PlaceOf(statement->second);
      cause.key += "\n" + std::to_string(value);
    } else if (value < parameter.enumerators.size()) {
      cause.text += " " + parameter.enumerators[value];
      cause.key += "\n" + parameter.enumerators[value];
    } else {
      // How far an index was out is no other cause; where kinds have no names, the first number is one.
      if (!is_named && i == 0) cause.key += "\n" + std::to_string(value);
      numbers += (numbers.empty() ? "" : ", ") + parameter.name + " " + engines::ArgumentText(parameter.type, value);
    }
  }
  if (!where.empty()) cause.text += " at " + where;
  if (!numbers.empty()) cause.text += " (" + numbers + ")";
  return cause;
}

Cause WatchPlan::PropertyCause(uint32_t number) const {
  const std::string& text = properties_[number].text;
  return {.kind = CauseKind::kProperty,
          .number = number,
          .key = "property\n" + text,
          .text = "property '" + text + "' does not hold",
          .function = {}};
}

Cause WatchPlan::MessageCause(uint32_t number, const std::string& text) {
  return {.kind = CauseKind::kMessage,
          .number = number,
          .key = "message\n" + std::to_string(number),
          .text = "message " + std::to_string(number) + (text.empty() ? "" : " '" + text + "'") + " never goes",
          .function = {}};
}

Cause WatchPlan::StuckCause(PieceEnd end) {
  const bool is_stuck = end == PieceEnd::kStuck;
  return {.kind = is_stuck ? CauseKind::kStuck : CauseKind::kEndless,
          .number = 0,
          .key = is_stuck ? "stuck" : "endless",
          .text = is_stuck ? "a part of the program is not completed in the time that it may take"
                           : "one scan executes more than 20 million instructions",
          .function = {}};
}

void WatchPlan::FindGuards() {
  for (uint32_t i = 0; i < program().insts.size(); ++i) {
    const ir::Inst& inst = program()[ir::InstId(i)];
    ir::RegionId region;
    if (inst.op == ir::OpKind::kLoop) {
      const ir::Loop& loop = program().loops[ir::LoopId(inst.payload)];
      if (loop.kind == ir::LoopBound::kGuard) region = loop.exhausted;
    } else if (inst.op == ir::OpKind::kRepeat) {
      region = ir::RegionId(inst.b);
    }
    if (!region.valid() || program().regions[region].insts.empty()) continue;
    // A fault that is reported there tells more.
    if (ContainsCallOf(program(), region, is_fault_)) continue;
    Cause cause{
        .kind = CauseKind::kLoopGuard, .number = i, .key = "loop\n" + std::to_string(i), .text = {}, .function = {}};
    const source::Position position = machine_.compilation.sources->Locate(inst.range.begin);
    const std::string place = position.line == 0 ? "of the program"
                                                 : "at " + machine_.compilation.sources->Get(position.file).path + ":" +
                                                       std::to_string(position.line);
    cause.text = "the loop " + place + " was ended by its guard";
    guards_.push_back({program().regions[region].insts.front(), std::move(cause)});
  }
}

void WatchPlan::FindOutputs() {
  const prove::machine::Version& version = machine_.version;
  const prove::machine::Uses uses = prove::machine::UsesOf(version);
  for (uint32_t i = 0; i < program().spaces.size(); ++i) {
    const ir::Space& space = program().spaces[ir::SpaceId(i)];
    if (!space.host_visible) continue;
    for (uint32_t offset = 0; offset < space.bytes && offset < version.cells.bytes[i]; ++offset) {
      const uint8_t outputs = ir::BitsInZones(space, offset, ir::Direction::kOutput);
      OutputByte byte{.space = ir::SpaceId(i), .offset = offset};
      for (uint8_t bit = 0; outputs != 0 && bit < 8; ++bit) {
        if ((outputs >> bit & 1) == 0 || !uses.writes[version.cells.OfBit(byte.space, offset, bit).index]) continue;
        byte.mask = static_cast<uint8_t>(byte.mask | 1U << bit);
      }
      if (byte.mask != 0) outputs_.push_back(byte);
    }
  }
}

void MessageLife::Add(const MessageLife& other) {
  came += other.came;
  went += other.went;
  stood_ms += other.stood_ms;
  steps += other.steps;
}

void OutputLife::Add(const OutputLife& other) {
  for (size_t i = 0; i < ones.size(); ++i) {
    ones[i] = static_cast<uint8_t>(ones[i] | other.ones[i]);
    zeros[i] = static_cast<uint8_t>(zeros[i] | other.zeros[i]);
  }
}

Watch::Watch(const WatchPlan& plan) : plan_(plan) {
  for (const prove::properties::Property& property : plan.properties()) {
    monitors_.push_back(std::make_unique<scenarios::PropertyMonitor>(
        plan.program(), plan.cells(), std::vector<prove::properties::Property>{property}));
  }
  outputs_.ones.resize(plan.outputs().size());
  outputs_.zeros.resize(plan.outputs().size());
}

void Watch::BeginFrom(Machines& machines, size_t machine) {
  sim::Engine& engine = machines.EngineOf(machine);
  for (const auto& monitor : monitors_) monitor->BeginAt(engine);
  // Faults of init are seen after the first part.
  active_ = machines.ActiveMessages(machine);
  time_ms_ = machines.TimeMs(machine);
}

void Watch::LookAtOutputs(sim::Engine& engine) {
  size_t i = 0;
  ir::SpaceId space;
  std::span<const uint8_t> memory;
  for (const WatchPlan::OutputByte& byte : plan_.outputs()) {
    if (byte.space != space) memory = engine.Memory(space = byte.space);
    uint8_t value = 0;
    if (byte.offset < memory.size()) {
      value = memory[byte.offset];
    } else {
      ir::Place place{.type = ir::Type::kI8, .space = byte.space};
      place.offset = byte.offset;
      value = static_cast<uint8_t>(engine.Read(place));
    }
    outputs_.ones[i] = static_cast<uint8_t>(outputs_.ones[i] | value);
    outputs_.zeros[i] = static_cast<uint8_t>(outputs_.zeros[i] | ~value);
    ++i;
  }
}

void Watch::AfterPart(Machines& machines, size_t machine, sim::Clock::Part part, std::span<const uint8_t> given) {
  ++parts_;
  sim::Engine& engine = machines.EngineOf(machine);
  for (uint32_t i = 0; i < monitors_.size(); ++i) {
    monitors_[i]->AfterPart(engine, part);
    if (!monitors_[i]->violation()) continue;
    causes_.push_back(plan_.PropertyCause(i));
    monitors_[i]->GoOn();
  }
  for (const sim::HostEvent& event : engine.TakeEvents()) {
    if (event.exchange) continue;
    if (std::optional<Cause> fault = plan_.FaultOf(event)) causes_.push_back(std::move(*fault));
  }
  for (const WatchPlan::Guard& guard : plan_.guards()) {
    if (given[guard.executed.index] != 0) causes_.push_back(guard.cause);
  }
  LookAtOutputs(engine);
  const std::vector<uint32_t>& now = machines.ActiveMessages(machine);
  const uint64_t time_ms = machines.TimeMs(machine);
  if (now != active_) {
    for (const uint32_t number : now) {
      if (std::ranges::binary_search(active_, number)) continue;
      ++messages_[number].came;
      came_.insert(number);
    }
    for (const uint32_t number : active_) {
      if (!std::ranges::binary_search(now, number)) ++messages_[number].went;
    }
    active_ = now;
  }
  for (const uint32_t number : active_) messages_[number].stood_ms += time_ms - std::min(time_ms, time_ms_);
  time_ms_ = time_ms;
}

void Watch::AfterStep(Machines& machines, size_t machine) {
  came_.clear();
  for (const uint32_t number : active_) ++messages_[number].steps;
  if (machines.EndOf(machine) != PieceEnd::kDone) causes_.push_back(WatchPlan::StuckCause(machines.EndOf(machine)));
}

std::vector<Cause> Watch::TakeCauses() { return std::exchange(causes_, {}); }

}  // namespace plcxx::soak
