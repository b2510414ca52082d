#include "transpiler/soak/inputs.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <set>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/plant/coding.h"
#include "transpiler/prove/machine/inputs.h"
#include "transpiler/prove/machine/requests.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/sim/value_text.h"
#include "transpiler/support/low_bits.h"

namespace plcxx::soak {
namespace {

using execute::CellId;

constexpr size_t kMostTouched = 256;  // cells of an array; of more it is not known which one is meant
constexpr size_t kMostLinks = 64;     // of a statement
constexpr int kMostStepsBack = 6;
constexpr uint64_t kLongestMs = 10 * 60'000;
constexpr uint64_t kHeadstartMs = 200;  // for what comes before a timer

void AddOnce(std::vector<uint32_t>& numbers, uint32_t number) {
  if (numbers.size() < kMostLinks && std::ranges::find(numbers, number) == numbers.end()) numbers.push_back(number);
}

/// What an input may get.
enum class Draw : uint8_t { kZero, kSmall, kConstant, kOneBit, kDecimal, kAny };
constexpr Draw kDraws[] = {Draw::kZero,   Draw::kSmall,   Draw::kConstant, Draw::kConstant,
                           Draw::kOneBit, Draw::kDecimal, Draw::kAny,      Draw::kAny};

}  // namespace

std::optional<Words::Write> Words::Find(const std::pair<std::string, std::string>& word) {
  const auto [at, is_new] = known_.try_emplace(word.first);
  if (is_new) at->second = compilation_.dialect->locate(names_, word.first);
  const std::optional<dialects::Location>& location = at->second;
  if (!location || location->absent) return std::nullopt;
  if (location->text_input) return Write{.location = &*location};
  const std::optional<uint64_t> value =
      scenarios::ParseScenarioValue(word.second, location->place.type, *compilation_.dialect);
  if (!value) return std::nullopt;
  return Write{.location = &*location, .value = *value};
}

void Words::Set(const std::pair<std::string, std::string>& word, Machines& machines, size_t machine) {
  const std::optional<Write> write = Find(word);
  if (!write) return;
  if (write->location->text_input) {
    machines.SendText(machine, word.second);
  } else {
    machines.Set(machine, *write->location, write->value);
  }
}

void LeaveToPlant(const scenarios::BoundPlant& plant, const compilation::Compilation& compilation,
                  std::vector<review::diff::Stimuli>& runs) {
  const ir::NameIndex names(compilation.program);
  const auto is_driven = [&](const std::pair<std::string, std::string>& word) {
    const std::optional<dialects::Location> location = compilation.dialect->locate(names, word.first);
    return location && plant.DriverOf(*location) != nullptr;
  };
  for (review::diff::Stimuli& run : runs) {
    for (review::diff::Stimulus& stimulus : run) std::erase_if(stimulus.words, is_driven);
  }
}

Inputs::Inputs(const scenarios::ProveMachine& machine, const scenarios::BoundPlant* plant) {
  FindInputs(machine, plant);
  FindConstants(machine.compilation.program);
  FindReads(machine);
}

void Inputs::FindInputs(const scenarios::ProveMachine& machine, const scenarios::BoundPlant* plant) {
  const ir::Program& program = machine.compilation.program;
  const std::vector<bool> is_input = prove::machine::InputsOf(machine.version);
  const std::vector<bool> is_request = prove::machine::RequestCells(machine.version);
  const prove::machine::Uses uses = prove::machine::UsesOf(machine.version);
  std::vector<CellId> cells;
  for (uint32_t i = 0; i < is_input.size(); ++i) {
    // What nobody reads changes nothing.
    if ((is_input[i] && uses.reads[i]) || is_request[i]) cells.emplace_back(i);
  }
  input_of_cell_.resize(machine.version.cells.count);
  const ir::NameIndex names(program);
  for (const scenarios::InputWord& word : scenarios::WordsOf(machine, cells)) {
    const std::optional<dialects::Location> location =
        word.name.empty() ? std::nullopt : machine.compilation.dialect->locate(names, word.name);
    if (!location || location->absent || location->text_input || word.cells.size() > 64) {
      ++nameless_;
      continue;
    }
    if (plant != nullptr && plant->DriverOf(*location) != nullptr) {
      ++driven_;
      continue;
    }
    Input input{.name = word.name, .location = *location};
    input.width = static_cast<uint8_t>(word.cells.size());
    input.is_float = sim::IsFloat(location->place.type);
    input.free = 0;
    for (size_t i = 0; i < word.cells.size(); ++i) {
      const CellId cell = word.cells[i];
      if (is_input[cell.index]) input.free |= uint64_t{1} << i;
      if (prove::machine::DirectionOf(machine.version, cell) == ir::Direction::kInput) input.is_of_machine = true;
      input_of_cell_[cell.index] = {static_cast<uint32_t>(inputs_.size())};
    }
    input.is_request = input.free == 0;
    inputs_.push_back(std::move(input));
  }
}

void Inputs::FindConstants(const ir::Program& program) {
  std::set<uint64_t> constants;
  for (const ir::Inst& inst : program.insts) {
    if (inst.op == ir::OpKind::kConst && inst.type != ir::Type::kBit) constants.insert(ir::ConstantValue(inst));
  }
  for (const ir::Switch& one : program.switches) {
    for (const ir::SwitchCase& of : one.cases) constants.insert(of.values.begin(), of.values.end());
  }
  constants_.assign(constants.begin(), constants.end());
  // A preset may be counted in periods, passes, hundredths, tenths or seconds; nobody says which it is.
  std::set<uint32_t> waits{100, 500, 1000, 3000, 10'000, 30'000};
  const uint64_t period = std::max(1U, program.schedule.period_ms);
  for (const uint64_t constant : constants_) {
    for (const uint64_t unit : {uint64_t{1}, uint64_t{10}, uint64_t{100}, uint64_t{1000}, period}) {
      if (constant == 0 || constant > kLongestMs / unit) continue;
      const uint64_t ms = constant * unit + kHeadstartMs;
      if (ms > 2 * kHeadstartMs) waits.insert(static_cast<uint32_t>((ms + period - 1) / period * period));
    }
  }
  waits_ms_.assign(waits.begin(), waits.end());
  for (uint32_t& ms : waits_ms_) ms = static_cast<uint32_t>((ms + period - 1) / period * period);
}

void Inputs::FindReads(const scenarios::ProveMachine& machine) {
  const ir::Program& program = machine.compilation.program;
  const execute::Cells& cells = machine.version.cells;
  std::vector<std::vector<uint32_t>> read(program.statements.size());
  writers_.resize(cells.count);
  const auto visit = [&](const auto& self, ir::RegionId region, ir::StatementId statement) -> void {
    if (!region.valid()) return;
    for (const ir::InstId id : program.regions[region].insts) {
      const ir::Inst& inst = program[id];
      if (inst.op == ir::OpKind::kStatement) statement = ir::StatementId(inst.payload);
      const auto note = [&](const std::vector<CellId>& touched, bool reads, bool writes) {
        if (!statement.valid() || touched.size() > kMostTouched) return;
        for (const CellId cell : touched) {
          if (reads) read[statement.index].push_back(cell.index);
          if (writes) AddOnce(writers_[cell.index], statement.index);
        }
      };
      ir::ForEachAccess(
          program, inst,
          [&](ir::PlaceId place, ir::Access access) {
            note(execute::TouchedCells(program, cells, program.places[place]), access != ir::Access::kWrite,
                 access != ir::Access::kRead);
          },
          [&](ir::StateId state) { note(execute::CellsOfInstance(program, cells, state), true, true); });
      if (ir::Info(inst.op).effect != ir::Effect::kControl) continue;
      for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) self(self, owned, statement);
    }
  };
  for (const ir::Routine& routine : program.routines) {
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) visit(visit, region, {});
  }
  reads_.resize(program.statements.size());
  for (uint32_t i = 0; i < reads_.size(); ++i) {
    std::vector<uint32_t> from;
    std::ranges::sort(read[i]);
    const auto repeated = std::ranges::unique(read[i]);
    read[i].erase(repeated.begin(), repeated.end());
    for (const uint32_t cell : read[i]) {
      for (const uint32_t input : input_of_cell_[cell]) AddOnce(reads_[i].inputs, input);
      if (input_of_cell_[cell].empty()) {
        for (const uint32_t writer : writers_[cell]) {
          if (writer != i) AddOnce(from, writer);
        }
      }
    }
    for (const uint32_t writer : from) reads_[i].writers.emplace_back(writer);
  }
}

std::optional<uint32_t> Inputs::Towards(ir::StatementId statement, terms::Random& random) const {
  for (int step = 0; step < kMostStepsBack; ++step) {
    const Read& read = reads_[statement.index];
    const bool goes_back = read.inputs.empty() || (!read.writers.empty() && random.OneIn(3));
    if (!goes_back) return read.inputs[random.Next() % read.inputs.size()];
    if (read.writers.empty()) return std::nullopt;
    statement = read.writers[random.Next() % read.writers.size()];
  }
  return std::nullopt;
}

uint64_t Inputs::ValueFor(const Input& input, uint64_t now, terms::Random& random) const {
  if (input.is_request) return 0;
  const uint64_t all = support::LowBits(input.width);
  if (input.width == 1) return random.OneIn(8) ? random.Next() >> 7 & 1 : now ^ 1;
  uint64_t value = 0;
  switch (kDraws[random.Next() % std::size(kDraws)]) {
    case Draw::kZero:
      break;
    case Draw::kSmall:
      value = random.Next() % 5;
      break;
    case Draw::kConstant:
      if (!constants_.empty()) value = constants_[random.Next() % constants_.size()] + random.Next() % 3 - 1;
      break;
    case Draw::kOneBit:
      value = now ^ uint64_t { 1 } << random.Next() % input.width;
      break;
    case Draw::kDecimal:
      // Numbers of tools and M functions are small, and many controls write them in decimal digits.
      value = random.Next() % 100;
      if (random.OneIn(2)) value = plant::CodeOf(plant::Coding::kBcd, value, 0);
      break;
    case Draw::kAny:
      value = random.Next();
      break;
  }
  if (input.is_float) {
    const double number = static_cast<double>(static_cast<int64_t>(value % 20'001)) / (random.OneIn(2) ? 1 : 10);
    return input.width == 64 ? std::bit_cast<uint64_t>(number) : std::bit_cast<uint32_t>(static_cast<float>(number));
  }
  return ((value & input.free) | (now & ~input.free)) & all;
}

std::string Inputs::TextOf(const Input& input, uint64_t value) {
  return sim::ValueDigits(input.location.place.type, value, scenarios::SignOf(input.location));
}

}  // namespace plcxx::soak
