#include "transpiler/review/diff/machine.h"

#include "transpiler/review/diff/runs.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/support/mixed.h"

namespace plcxx::review::diff {
namespace {

constexpr uint32_t kNowhere = 0xFFFFFFFF;

/// Memory from period to period that no engine shows but the simulator: how a program does something, as the steps of a
/// sequential page.
bool IsHiddenState(const ir::Space& space) { return !space.host_visible && space.lifetime != ir::Lifetime::kRoutine; }

/// Where the picture has each cell: as in Engine::Snapshot host-visible spaces in order, then all fields of all
/// instances; then hidden memory.
std::vector<uint32_t> MakeBytesOf(const prove::machine::Version& version) {
  const ir::Program& program = *version.program;
  std::vector<uint32_t> bytes(version.cells.count, kNowhere);
  uint32_t at = 0;
  const auto add_space = [&](ir::SpaceId id) {
    for (uint32_t offset = 0; offset < program.spaces[id].bytes; ++offset, ++at) {
      for (uint8_t bit = 0; bit < 8; ++bit) bytes[version.cells.OfBit(id, offset, bit).index] = at;
    }
  };
  for (uint32_t i = 0; i < program.spaces.size(); ++i) {
    if (program.spaces[ir::SpaceId(i)].host_visible) add_space(ir::SpaceId(i));
  }
  for (uint32_t i = 0; i < program.states.size(); ++i) {
    uint32_t cell = version.cells.states[i];
    for (const ir::FieldInfo& field : ir::Info(program.states[ir::StateId(i)].kind).fields) {
      for (uint32_t element = 0; element < field.count; ++element, ++cell) {
        bytes[cell] = at;
        at += ir::Bytes(field.type);
      }
    }
  }
  for (uint32_t i = 0; i < program.spaces.size(); ++i) {
    if (IsHiddenState(program.spaces[ir::SpaceId(i)])) add_space(ir::SpaceId(i));
  }
  return bytes;
}

}  // namespace

DiffMachine::DiffMachine(const DiffSide& side, const prove::machine::Version& version, Time end)
    : side_(side),
      program_(side.compilation.program),
      version_(version),
      simulator_(side.compilation.program),
      control_(side.compilation.program, *side.compilation.dialect, simulator_, scenarios::StubOf(side.compilation)),
      clock_(side.compilation.program, {&simulator_}),
      end_(end),
      byte_of_(MakeBytesOf(version)),
      calls_(version.cells.CallCells()) {
  clock_.before_period = [this](uint32_t now_ms) { control_.BeforePeriod(now_ms); };
  clock_.after_period = [this](uint32_t now_ms) { control_.AfterPeriod(now_ms); };
  if (end != Time::max()) clock_.interrupted = [this] { return std::chrono::steady_clock::now() >= end_; };
  clock_.PowerOn();
  control_.PowerOn();
}

void DiffMachine::SetCell(execute::CellId id, uint64_t value) {
  const execute::Cell cell = execute::CellAt(*version_.program, version_.cells, id);
  ir::Place place;
  switch (cell.kind) {
    case execute::CellKind::kCalls:
      return;
    case execute::CellKind::kField: {
      const ir::FieldInfo& field = ir::Info(version_.program->states[cell.state].kind).fields[cell.field];
      if (field.hidden || field.count != 1) return;  // no scenario can
      place.type = field.type;
      place.state = cell.state;
      place.field = cell.field;
      break;
    }
    case execute::CellKind::kBit:
      place.type = ir::Type::kBit;
      place.space = cell.space;
      place.offset = cell.offset;
      place.bit = cell.bit;
      break;
  }
  SetPlace(place, value);
}

void DiffMachine::SetPlace(const ir::Place& place, uint64_t value) {
  dialects::Location location;
  location.place = place;
  control_.Set(location, value);
}

void DiffMachine::SetWord(const std::string& text, const std::string& value) {
  const std::optional<dialects::Location> location = side_.compilation.dialect->locate(names_, text);
  if (!location || location->absent) return;
  if (location->text_input) {
    simulator_.SendText(value);
    return;
  }
  const std::optional<uint64_t> bits =
      scenarios::ParseScenarioValue(value, location->place.type, *side_.compilation.dialect);
  if (bits) control_.Set(*location, *bits);
}

std::optional<uint64_t> DiffMachine::ValueOfWord(const std::string& text) const {
  const std::optional<dialects::Location> location = side_.compilation.dialect->locate(names_, text);
  if (!location || location->absent || location->cell || location->text_input || !location->bits.empty() ||
      !execute::IsInside(program_, location->place))
    return std::nullopt;
  const std::vector<execute::CellId> cells = execute::CellsOf(program_, version_.cells, location->place);
  if (cells.size() == 1) return ValueOf(cells.front());
  uint64_t value = 0;
  for (size_t i = 0; i < cells.size() && i < 64; ++i) value |= ValueOf(cells[i]) << i;
  return value;
}

bool DiffMachine::Apply(const Stimulus& stimulus, execute::CellId prove::diff::SetCell::* cell) {
  for (uint32_t i = 0; !stimulus.repeated.empty() && i < stimulus.times; ++i) {
    for (const Stimulus& one : stimulus.repeated) {
      if (!Apply(one, cell)) return false;
    }
  }
  if (stimulus.power_cycle) {
    for (const prove::diff::SetCell& kept : stimulus.kept) {
      if ((kept.*cell).valid()) SetCell(kept.*cell, kept.value);
    }
    // Some controls keep the memory only when the program has asked for it.
    const ir::PlaceId asked = program_.schedule.retain_at_power_off;
    if (!stimulus.kept.empty() && asked.valid()) SetPlace(program_.places[asked], 1);
    control_.PowerOff();
    clock_.PowerCycle();
    control_.PowerOn();
  }
  for (const prove::diff::SetCell& input : stimulus.inputs) {
    if ((input.*cell).valid()) SetCell(input.*cell, input.value);
  }
  for (const auto& [location, value] : stimulus.words) SetWord(location, value);
  return Advance(stimulus);
}

bool DiffMachine::Advance(const Stimulus& stimulus) {
  return clock_.RunFor(stimulus.slow, stimulus.fast, stimulus.ms) == sim::Step::kDone;
}

DiffMachine::Saved DiffMachine::Save() const {
  return {.simulator = simulator_.Save(), .control = control_.Save(), .time_ms = clock_.time_ms(), .calls = calls_};
}

void DiffMachine::Restore(const Saved& saved) {
  simulator_.Restore(saved.simulator);
  control_.Restore(saved.control);
  clock_.GoTo(saved.time_ms);
  calls_ = saved.calls;
  Look();
}

void DiffMachine::LookAtMemory() {
  picture_ = simulator_.Snapshot();
  for (uint32_t i = 0; i < program_.spaces.size(); ++i) {
    const ir::SpaceId id(i);
    if (!IsHiddenState(program_.spaces[id])) continue;
    const std::span<const uint8_t> bytes = simulator_.Memory(id);
    picture_.insert(picture_.end(), bytes.begin(), bytes.end());
  }
}

void DiffMachine::Look() {
  LookAtMemory();
  events_ = simulator_.TakeEvents();
  for (const sim::HostEvent& event : events_) {
    for (const execute::CellId chain : version_.cells.ChainsOf(event.function, event.exchange)) {
      uint64_t& calls = calls_[chain.index - version_.cells.calls];
      // By its name: two versions number their functions differently.
      for (const char c : program_.host_functions[event.function].name)
        calls = support::Mixed(calls, static_cast<unsigned char>(c));
      for (const uint64_t argument : event.arguments) calls = support::Mixed(calls, argument);
      ++calls;
    }
  }
}

uint64_t DiffMachine::Seen(execute::CellId id) const {
  if (id.index >= version_.cells.calls) return calls_[id.index - version_.cells.calls];
  const uint32_t at = byte_of_[id.index];
  if (at == kNowhere || at >= picture_.size()) return 0;
  const bool is_bit = version_.cells.states.empty() || id.index < version_.cells.states.front();
  if (is_bit) return picture_[at] >> ((id.index - version_.cells.spaces.front()) % 8) & 1;
  const execute::Cell cell = execute::CellAt(*version_.program, version_.cells, id);
  uint64_t value = 0;
  for (uint32_t i = 0; i < (execute::CellWidth(*version_.program, cell) + 7U) / 8; ++i)
    value |= uint64_t{picture_[at + i]} << (8 * i);
  return value;
}

uint64_t DiffMachine::ValueOf(execute::CellId id) const {
  if (id.index >= version_.cells.calls) return 0;
  if (byte_of_[id.index] != kNowhere) return Seen(id);
  const execute::Cell cell = execute::CellAt(*version_.program, version_.cells, id);
  const std::span<const uint8_t> bytes = simulator_.Memory(cell.space);
  return cell.offset < bytes.size() ? bytes[cell.offset] >> cell.bit & 1 : 0;
}

}  // namespace plcxx::review::diff
