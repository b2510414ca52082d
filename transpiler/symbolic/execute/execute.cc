#include "transpiler/symbolic/execute/execute.h"

#include <algorithm>
#include <utility>

#include "transpiler/symbolic/execute/executor.h"
#include "transpiler/symbolic/execute/host_writes.h"
#include "transpiler/symbolic/meaning/meaning.h"

namespace plcxx::execute {

Refusal Execute(Memory& memory, ir::RoutineId routine, std::span<const terms::TermId> arguments) {
  return Executor(memory).Run(routine, arguments);
}

Refusal ExecutePart(Memory& memory, const Stretch& part) { return Executor(memory).RunPart(part); }

Executor::Executor(Memory& memory)
    : memory_(memory),
      terms_(memory.terms()),
      program_(memory.program()),
      values_(memory.program().insts.size()),
      first_term_(memory.terms().size()),
      context_(terms_.Bit(true)) {}

void Executor::Refuse(std::string reason) {
  if (refusal_.empty()) refusal_ = std::move(reason);
  // Nothing is executed any more.
  flow_.active = terms_.Bit(false);
}

Refusal Executor::Run(ir::RoutineId id, std::span<const terms::TermId> arguments) {
  if (!id.valid()) return {};
  flow_ = {.active = terms_.Bit(true), .leaving = {}};
  ClearLocals();
  const ir::Routine& routine = program_.routines[id];
  for (size_t i = 0; i < arguments.size() && i < routine.parameter_places.size(); ++i) {
    WritePlace(program_.places[routine.parameter_places[i]], arguments[i]);
  }
  ExecuteRoutine(routine);
  return std::move(refusal_);
}

Refusal Executor::RunPart(const Stretch& part) {
  flow_ = {.active = terms_.Bit(true), .leaving = {}};
  if (!part.region.valid()) {
    ExecuteRoutine(program_.routines[part.routine]);
    return std::move(refusal_);
  }
  for (uint32_t i = part.begin; i < part.end && !terms_.IsFalse(flow_.active); ++i) {
    const ir::InstId id = program_.regions[part.region].insts[i];
    ExecuteInst(id, program_[id]);
  }
  return std::move(refusal_);
}

void Executor::ExecuteRoutine(const ir::Routine& routine) {
  for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) ExecuteRegion(region);
}

void Executor::ClearLocals() {
  for (uint32_t i = 0; i < program_.spaces.size(); ++i) {
    const ir::SpaceId space(i);
    if (program_.spaces[space].lifetime != ir::Lifetime::kRoutine) continue;
    for (uint32_t bit = 0; bit < 8 * memory_.cells().bytes[i]; ++bit) {
      WriteCell(memory_.cells().OfBit(space, bit / 8, static_cast<uint8_t>(bit % 8)), terms_.Bit(false));
    }
  }
}

void Executor::ExecuteRegion(ir::RegionId region) {
  if (!region.valid()) return;
  const std::vector<ir::InstId>& insts = program_.regions[region].insts;
  for (uint32_t at = 0; at < insts.size() && !terms_.IsFalse(flow_.active);) {
    if (IsReplaced(region, at)) continue;
    ExecuteInst(insts[at], program_[insts[at]]);
    ++at;
  }
}

bool Executor::IsReplaced(ir::RegionId region, uint32_t& at) {
  ReplacedParts* replaced = memory_.environment().replaced;
  if (replaced == nullptr) return false;
  const auto changes = replaced->Part(memory_, region, at, Absolute());
  if (!changes) return false;
  for (const CellChange& change : *changes) WriteCell(change.cell, change.value);
  return true;
}

void Executor::ExecuteInst(ir::InstId id, const ir::Inst& inst) {
  const auto operands = [&] {
    std::vector<terms::TermId> terms;
    for (const uint32_t operand : {inst.a, inst.b, inst.c}) {
      if (terms.size() < ir::Info(inst.op).operand_count) terms.push_back(ValueOf(operand));
    }
    return terms;
  };
  switch (inst.op) {
#define PLCXX_PURE(Kind, ...) case ir::OpKind::k##Kind:
#define PLCXX_STEP(...)
#define PLCXX_CORE(...)
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
    values_[id.index] = meaning::MeaningOf(terms_, inst.op, operands());
    break;
#define PLCXX_PURE(...)
#define PLCXX_STEP(Kind, ...) case ir::OpKind::k##Kind:
#define PLCXX_CORE(...)
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
    {
      std::vector<terms::TermId> fields = Fields(ir::StateId(inst.payload));
      values_[id.index] = meaning::StepMeaning(terms_, inst.op, fields, operands());
      StepInstance(ir::StateId(inst.payload), fields);
      break;
    }
#define PLCXX_PURE(...)
#define PLCXX_STEP(...)
#define PLCXX_CORE(Kind, ...) \
  case ir::OpKind::k##Kind:   \
    Execute##Kind(id, inst);  \
    break;
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
  }
}

void Executor::ExecuteConst(ir::InstId id, const ir::Inst& inst) {
  values_[id.index] = terms_.Const(ir::ConstantValue(inst), meaning::WidthOf(inst.type));
}

void Executor::ExecutePoison(ir::InstId id, const ir::Inst& inst) {
  if (inst.type != ir::Type::kNone) values_[id.index] = terms_.Const(0, meaning::WidthOf(inst.type));
}

void Executor::ExecuteStatement(ir::InstId, const ir::Inst&) {
  // Calls that double each other make no new terms, and would not end.
  constexpr uint64_t kMostStatements = 10'000'000;
  if (++statements_ > kMostStatements) {
    Refuse("the program executes more than " + std::to_string(kMostStatements) + " statements at a time");
  }
  if (terms_.size() - first_term_ > memory_.environment().most_terms) {
    Refuse("the program takes more than " + std::to_string(memory_.environment().most_terms) + " terms");
  }
  if (memory_.environment().is_late && memory_.environment().is_late()) Refuse("the time was not enough");
}

void Executor::ExecuteLoad(ir::InstId id, const ir::Inst& inst) {
  const ir::Place& place = program_.places[ir::PlaceId(inst.payload)];
  values_[id.index] = place.indexed ? ReadAt(place, ValueOf(inst.a)) : ReadPlace(place);
}

void Executor::ExecuteStore(ir::InstId, const ir::Inst& inst) {
  const ir::Place& place = program_.places[ir::PlaceId(inst.payload)];
  if (place.indexed) {
    WriteAt(place, ValueOf(inst.b), ValueOf(inst.a));
  } else {
    WritePlace(place, ValueOf(inst.a));
    // What was stored is not loaded again where it is known: it is the location's value there, too.
    const bool is_cut = memory_.environment().cut && terms_.IsTrue(flow_.active) && IsInside(program_, place);
    if (is_cut) values_[inst.a] = ReadPlace(place);
  }
}

void Executor::ExecuteUpdateText(ir::InstId, const ir::Inst& inst) {
  const ir::StateId flag_id(inst.payload), inbox_id(inst.a);
  std::vector<terms::TermId> flag = Fields(flag_id), inbox = Fields(inbox_id);
  meaning::UpdateTextMeaning(terms_, flag, inbox, program_.texts[ir::TextId(inst.b)]);
  StepInstance(flag_id, flag);
  StepInstance(inbox_id, inbox);
}

void Executor::ExecuteCall(ir::InstId id, const ir::Inst& inst) {
  const ir::Call& call = program_.calls[ir::CallId(inst.payload)];
  const ir::Routine& routine = program_.routines[call.routine];
  // A partition has named locals of its own; those of its caller come back after it.
  std::vector<std::pair<CellId, terms::TermId>> callers;
  if (routine.kind != ir::RoutineKind::kSubroutine) {
    for (uint32_t i = 0; i < program_.spaces.size(); ++i) {
      const ir::Space& space = program_.spaces[ir::SpaceId(i)];
      if (space.lifetime != ir::Lifetime::kRoutine) continue;
      for (uint32_t bit = 0; bit < 8 * memory_.cells().bytes[i]; ++bit) {
        const CellId cell(memory_.cells().spaces[i] + bit);
        callers.emplace_back(cell, memory_.Read(cell));
      }
    }
    ClearLocals();
  }
  for (size_t i = 0; i < call.arguments.size() && i < routine.parameter_places.size(); ++i) {
    WritePlace(program_.places[routine.parameter_places[i]], ValueOf(call.arguments[i].index));
  }
  ReplacedParts* replaced = memory_.environment().replaced;
  const auto changes = replaced == nullptr ? std::nullopt : replaced->Call(memory_, call.routine, Absolute());
  if (changes) {
    for (const CellChange& change : *changes) WriteCell(change.cell, change.value);
  } else {
    ExecuteRoutine(routine);
  }
  if (routine.result_place.valid()) values_[id.index] = ReadPlace(program_.places[routine.result_place]);
  for (const auto& [cell, value] : callers) WriteCell(cell, value);
}

/// What stood in a place before the execution.
terms::TermId Executor::InitialOf(const ir::Place& place) {
  terms::TermId value;
  for (const CellId cell : CellsOf(program_, memory_.cells(), place)) {
    const terms::TermId part = memory_.environment().initial(cell);
    value = value.valid() ? terms_.Concat(part, value) : part;
  }
  return value;
}

void Executor::ExecuteHostCall(ir::InstId id, const ir::Inst& inst) {
  const ir::Call& call = program_.calls[ir::CallId(inst.payload)];
  const ir::HostFunction& host = program_.host_functions[call.host];
  if (call.host == program_.schedule.now) {
    values_[id.index] = memory_.environment().now;
    return;
  }
  std::vector<terms::TermId> arguments;
  for (const ir::ValueId argument : call.arguments) arguments.push_back(ValueOf(argument.index));
  const auto& tell = memory_.environment().tell;
  if (tell && tell(id, arguments, Absolute())) return;
  terms::TermId calls, told;
  for (const CellId chain : memory_.cells().ChainsOf(call.host, call.exchange)) {
    told = CallsAfter(terms_, host.name, memory_.Read(chain), arguments);
    if (!calls.valid()) calls = told;
    WriteCell(chain, told);
  }
  const bool answers = memory_.environment().host_answers;
  if (host.result != ir::Type::kNone) {
    values_[id.index] = answers ? AnswerOf(terms_, host.name, told, meaning::WidthOf(host.result))
                                : terms_.Const(0, meaning::WidthOf(host.result));
    const ir::Place* const input = memory_.environment().fetched ? memory_.environment().fetched(id) : nullptr;
    if (input != nullptr) values_[id.index] = InitialOf(*input);
  }
  if (call.out.valid() && answers) {
    const ir::Place& out = program_.places[call.out];
    WritePlace(out, terms_.Ite(GivesSecond(terms_, host.name, told),
                               SecondAnswerOf(terms_, host.name, told, meaning::WidthOf(out.type)), ReadPlace(out)));
  }
  // Who writes the state is given it, and may have looked at it before.
  const bool only_reads = host.access == ir::HostAccess::kReadsState || host.access == ir::HostAccess::kReadsRetentive;
  const bool may_read = only_reads || host.access == ir::HostAccess::kWritesState;
  if (may_read && memory_.environment().observe) memory_.environment().observe(memory_, call.host, flow_.active);
  const bool restores = host.access == ir::HostAccess::kWritesRetentive && memory_.environment().stored;
  const bool has_copy = restores && memory_.environment().has_copy;
  if (only_reads || host.access == ir::HostAccess::kNone || !(answers || has_copy)) return;
  const bool exchanges_state = host.routine_exchange && host.access == ir::HostAccess::kWritesState;
  const auto is_exchanged = exchanges_state ? memory_.environment().is_exchanged : nullptr;
  for (uint32_t i = 0; i < program_.spaces.size(); ++i) {
    const ir::SpaceId space(i);
    for (uint32_t offset = 0; offset < program_.spaces[space].bytes; ++offset) {
      const uint8_t may_write = BitsMayWrite(program_, host, space, offset);
      if (may_write == 0) continue;
      const uint8_t clears = host.access == ir::HostAccess::kWritesState
                                 ? BitsControlWrites(program_.spaces[space], offset).clears
                                 : uint8_t{0};
      for (uint8_t bit = 0; bit < 8; ++bit) {
        if ((may_write >> bit & 1) == 0) continue;
        const bool only_clears = (clears >> bit & 1) != 0;
        const CellId cell = memory_.cells().OfBit(space, offset, bit);
        if (is_exchanged && !is_exchanged(cell)) continue;
        if (restores) {
          const terms::TermId copied = memory_.environment().stored(cell);
          WriteCell(cell,
                    has_copy ? copied : terms_.Ite(HasCopy(terms_, host.name, calls), copied, memory_.Read(cell)));
          continue;
        }
        const auto& host_bit = memory_.environment().host_bit;
        const Environment::HostBit known =
            host_bit ? host_bit(cell) : Environment::HostBit{program_.spaces[space].name, offset, bit};
        const terms::TermId byte = ByteFromHost(terms_, host.name, told, known.space, known.offset);
        terms::TermId value = terms_.Extract(byte, known.bit, 1);
        if (only_clears) {
          value = terms_.And(value, memory_.Read(cell));
        } else if (memory_.environment().may_be_left && memory_.environment().may_be_left(cell)) {
          const terms::TermId written = BitsWrittenByHost(terms_, host.name, told, known.space, known.offset);
          value = terms_.Ite(terms_.Extract(written, known.bit, 1), value, memory_.Read(cell));
        }
        WriteCell(cell, value);
      }
    }
  }
}

// Structuring has replaced both; the verifier refuses them in what comes here.
void Executor::ExecuteJump(ir::InstId, const ir::Inst&) { PLCXX_UNREACHABLE(); }
void Executor::ExecuteLabel(ir::InstId, const ir::Inst&) { PLCXX_UNREACHABLE(); }

}  // namespace plcxx::execute
