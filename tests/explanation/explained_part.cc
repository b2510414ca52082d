#include "tests/explanation/explained_part.h"

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <utility>
#include <variant>

#include "transpiler/engines/lockstep.h"
#include "transpiler/ir/accesses.h"
#include "transpiler/ir/zones.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/run.h"
#include "transpiler/symbolic/execute/host_writes.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::explanation {
namespace {

std::optional<Machine> MachineOf(scenarios::ScenarioOrErrors read) {
  if (!std::holds_alternative<scenarios::Scenario>(read)) return std::nullopt;
  Machine machine;
  machine.scenario = std::move(std::get<scenarios::Scenario>(read));
  if (!machine.scenario.steps || machine.scenario.sources.empty()) return std::nullopt;
  machine.compilation = compilation::Compile(scenarios::RequestOf(machine.scenario, scenarios::ProgramOverrides()));
  if (!machine.compilation.ok() || !machine.compilation.has_program) return std::nullopt;
  return machine;
}

template <class Look>
void Run(const Machine& machine, std::optional<uint32_t> last, Look&& look) {
  const ir::Program& program = machine.compilation.program;
  auto plan = scenarios::PlanScenario(machine.scenario, *machine.compilation.dialect, program);
  if (!std::holds_alternative<scenarios::ScenarioPlan>(plan)) return;
  auto owned = std::make_unique<Recorder>(program);
  Recorder& recorder = *owned;
  if (last) recorder.EndAfterPart(*last);
  std::vector<std::unique_ptr<sim::Engine>> engines;
  engines.push_back(std::move(owned));
  engines::Lockstep lockstep(program, std::move(engines));
  const auto make_stub = machine.compilation.dialect->make_stub;
  static_cast<void>(scenarios::RunScenario(
      {.scenario = machine.scenario,
       .plan = std::get<scenarios::ScenarioPlan>(plan),
       .dialect = *machine.compilation.dialect,
       .program = program,
       .sources = *machine.compilation.sources,
       .engines = lockstep,
       .stub = make_stub == nullptr ? nullptr : make_stub(program, machine.compilation.options)}));
  look(recorder);
}

class Trials {
 public:
  Trials(const Subject& subject, const Frame& frame, const std::vector<execute::CellId>& cells,
         const Explanation& explanation, uint64_t seed)
      : subject_(subject),
        program_(subject.program),
        frame_(frame),
        cells_(cells),
        explanation_(explanation),
        random_(seed | 1),
        changes_(subject.cells.count) {
    // What a program only reads and no machine writes is its tables, and what is known of them holds always.
    for (const ir::Inst& inst : program_.insts) {
      ir::ForEachAccess(
          program_, inst,
          [&](ir::PlaceId id, ir::Access access) {
            const ir::Place& place = program_.places[id];
            if (access == ir::Access::kRead || (!place.is_field() && !place.space.valid())) return;
            for (const execute::CellId cell : execute::TouchedCells(program_, subject.cells, place)) {
              changes_[cell.index] = true;
            }
          },
          [&](ir::StateId state) {
            for (const execute::CellId cell : execute::CellsOfInstance(program_, subject.cells, state)) {
              changes_[cell.index] = true;
            }
          });
    }
    for (uint32_t i = 0; i < program_.spaces.size(); ++i) {
      const ir::Space& space = program_.spaces[ir::SpaceId(i)];
      for (uint32_t offset = 0; offset < space.bytes; ++offset) {
        const uint8_t inputs = ir::BitsInZones(space, offset, ir::Direction::kInput);
        for (uint8_t bit = 0; bit < 8; ++bit) {
          if ((inputs >> bit & 1) != 0) changes_[subject.cells.OfBit(ir::SpaceId(i), offset, bit).index] = true;
        }
      }
    }
    for (const LeafCell& leaf : explanation.leaves) leaves_[leaf.cell.index] = leaf.bits;
  }

  Judged Run() {
    Judged judged;
    const std::vector<uint64_t> expected = After(frame_.before, Answers::kAsRecorded);
    if (expected != ValuesOf(frame_.after)) {
      judged.refuted = "the part is not the same when it is executed again";
      return judged;
    }
    constexpr uint32_t kTrials = 6;
    for (uint32_t trial = 0; trial < kTrials; ++trial) {
      ++judged.tried;
      if (After(Changed(trial), Answers::kAny) == expected) continue;
      judged.refuted = "trial " + std::to_string(trial);
      return judged;
    }
    for (const auto& [cell, bits] : leaves_) {
      ++judged.leaves;
      sim::Simulator::Saved one = frame_.before;
      Set(one, execute::CellId(cell), ~Value(one, execute::CellId(cell)));
      if (After(one, Answers::kAsRecorded) != expected) ++judged.moved;
    }
    return judged;
  }

 private:
  enum class Answers : uint8_t { kAsRecorded, kAny };

  uint64_t Value(const sim::Simulator::Saved& saved, execute::CellId id) const {
    const execute::Cell cell = execute::CellAt(program_, subject_.cells, id);
    if (cell.kind == execute::CellKind::kField) return saved.instances.Read(cell.state.index, cell.field);
    return saved.spaces[cell.space.index][cell.offset] >> cell.bit & 1;
  }

  void Set(sim::Simulator::Saved& saved, execute::CellId id, uint64_t value) const {
    const execute::Cell cell = execute::CellAt(program_, subject_.cells, id);
    if (cell.kind == execute::CellKind::kField) {
      const ir::FieldInfo& field = ir::Info(program_.states[cell.state].kind).fields[cell.field];
      if (field.count != 1) return;
      const uint8_t width = execute::CellWidth(program_, cell);
      saved.instances.Write(cell.state.index, cell.field, width == 64 ? value : value & ((uint64_t{1} << width) - 1));
      return;
    }
    const auto mask = static_cast<uint8_t>(1u << cell.bit);
    saved.spaces[cell.space.index].Write(cell.offset, mask, (value & 1) != 0 ? mask : uint8_t{0});
  }

  /// Everything else than the leaves is something else: all, a tenth, or what random numbers say.
  sim::Simulator::Saved Changed(uint32_t trial) {
    sim::Simulator::Saved saved = frame_.before;
    for (uint32_t i = 0; i < subject_.cells.calls; ++i) {
      const execute::CellId id(i);
      const execute::Cell cell = execute::CellAt(program_, subject_.cells, id);
      if (!changes_[i] || (cell.kind == execute::CellKind::kField && cell.element != 0)) continue;
      if (cell.kind == execute::CellKind::kBit && program_.spaces[cell.space].lifetime == ir::Lifetime::kRoutine) {
        continue;
      }
      if (trial % 3 == 1 && !random_.OneIn(10)) continue;
      const uint64_t now = Value(saved, id);
      const uint64_t other = trial % 3 == 0 ? ~now : random_.Next();
      const auto leaf = leaves_.find(i);
      const uint64_t kept = leaf == leaves_.end() ? 0 : leaf->second;
      Set(saved, id, (now & kept) | (other & ~kept));
    }
    return saved;
  }

  std::vector<uint64_t> ValuesOf(const sim::Simulator::Saved& saved) const {
    std::vector<uint64_t> values;
    for (const execute::CellId cell : cells_) values.push_back(Value(saved, cell));
    return values;
  }

  std::vector<uint64_t> After(const sim::Simulator::Saved& before, Answers answers) {
    // A call is known by its arguments: another state may call in another order, or more often.
    std::map<std::pair<uint32_t, std::vector<uint64_t>>, std::deque<const RecordedCall*>> recorded;
    for (const RecordedCall& call : frame_.calls) recorded[{call.function.index, call.arguments}].push_back(&call);
    sim::Simulator simulator(program_);
    simulator.AnswerHostCalls([&](ir::HostFunctionId function, std::span<const uint64_t> arguments) {
      const bool counts =
          std::ranges::find(explanation_.answers, program_.host_functions[function].name) != explanation_.answers.end();
      std::deque<const RecordedCall*>& known = recorded[{function.index, {arguments.begin(), arguments.end()}}];
      const RecordedCall* call = known.empty() ? nullptr : known.front();
      if (known.size() > 1) known.pop_front();
      // What the host writes in the middle of the part it writes again.
      if (call != nullptr && !call->memory.empty()) WriteAgain(simulator, *call);
      if (answers == Answers::kAny && !counts) {
        sim::HostAnswer any;
        any.result = random_.Next() & Mask(program_.host_functions[function].result);
        return any;
      }
      return call == nullptr ? sim::HostAnswer{} : call->answer;
    });
    simulator.Restore(before);
    switch (frame_.kind) {
      case PartKind::kPeriod:
        simulator.RunPeriod(frame_.now_ms);
        break;
      case PartKind::kFast:
        simulator.RunFastOnly(frame_.now_ms);
        break;
      case PartKind::kElapse:
        simulator.RunElapse(frame_.now_ms);
        break;
    }
    return ValuesOf(simulator.Save());
  }

  void WriteAgain(sim::Simulator& simulator, const RecordedCall& call) const {
    const ir::HostAccess access = program_.host_functions[call.function].access;
    for (uint32_t i = 0; i < program_.spaces.size(); ++i) {
      for (uint32_t offset = 0; offset < program_.spaces[ir::SpaceId(i)].bytes; ++offset) {
        const uint8_t written = execute::BitsHostWrites(program_, access, ir::SpaceId(i), offset);
        if (written == 0) continue;
        ir::Place byte;
        byte.type = ir::Type::kI8;
        byte.space = ir::SpaceId(i);
        byte.offset = offset;
        simulator.Write(byte, (call.memory[i][offset] & written) | (simulator.Read(byte) & ~uint64_t{written}));
      }
    }
  }

  static uint64_t Mask(ir::Type type) {
    if (type == ir::Type::kBit) return 1;
    const uint32_t bytes = ir::Bytes(type);
    return bytes >= 8 ? ~uint64_t{0} : (uint64_t{1} << (8 * bytes)) - 1;
  }

  const Subject& subject_;
  const ir::Program& program_;
  const Frame& frame_;
  const std::vector<execute::CellId>& cells_;
  const Explanation& explanation_;
  terms::Random random_;
  std::vector<bool> changes_;  // by cell: a machine may find it with another value
  std::map<uint32_t, uint64_t> leaves_;
};

}  // namespace

std::optional<Machine> LoadMachine(const std::string& path) { return MachineOf(scenarios::ReadScenario(path)); }

std::optional<Machine> ReadMachine(const std::string& path, const std::string& yaml) {
  return MachineOf(scenarios::ParseScenario(path, yaml));
}

uint32_t PartsOf(const Machine& machine) {
  uint32_t parts = 0;
  Run(machine, {}, [&](const Recorder& recorder) { parts = static_cast<uint32_t>(recorder.parts().size()); });
  return parts;
}

std::optional<Frame> FrameOf(const Machine& machine, uint32_t part) {
  std::optional<Frame> frame;
  Run(machine, part, [&](Recorder& recorder) { frame = std::move(recorder.frame()); });
  return frame;
}

Judged Judge(const Subject& subject, const Frame& frame, const std::vector<execute::CellId>& cells,
             const Explanation& explanation, uint64_t seed) {
  return Trials(subject, frame, cells, explanation, seed).Run();
}

}  // namespace plcxx::explanation
