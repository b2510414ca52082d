#include "transpiler/scenarios/control.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "transpiler/support/check.h"
#include "transpiler/support/low_bits.h"
#include "transpiler/symbolic/execute/host_writes.h"

namespace plcxx::scenarios {
namespace {

ir::Place ByteOf(ir::SpaceId space, uint32_t offset) {
  ir::Place place;
  place.type = ir::Type::kI8;
  place.space = space;
  place.offset = offset;
  return place;
}

/// How many bytes at the beginning of both are the same. A control hands over kilobytes in every period of which few
/// change; `std::ranges::mismatch` goes byte by byte.
size_t CountSame(std::span<const uint8_t> left, std::span<const uint8_t> right) {
  constexpr size_t kBlock = 128;
  const size_t size = std::min(left.size(), right.size());
  size_t same = 0;
  while (size - same >= kBlock && std::memcmp(left.data() + same, right.data() + same, kBlock) == 0) same += kBlock;
  while (same < size && left[same] == right[same]) ++same;
  return same;
}

/// What a value of the type can hold.
uint64_t Fitting(ir::Type type, uint64_t value) {
  if (type == ir::Type::kNone) return 0;
  if (type == ir::Type::kBit) return value != 0 ? 1 : 0;
  return value & support::LowBits(8 * ir::Bytes(type));
}

/// Proofs take it that the control writes nothing but what the zones of memory say.
void CheckWrite(const ir::Space& space, uint32_t offset, uint8_t before, uint8_t value) {
  if (value == before) return;
  const execute::ControlBits bits = execute::BitsControlWrites(space, offset);
  const int changed = value ^ before;
  PLCXX_CHECK((changed & ~(bits.values | bits.clears)) == 0);
  PLCXX_CHECK((changed & bits.clears & value) == 0);
}

std::string DeclaredText(const ir::Program& program, uint32_t number) {
  for (const ir::MessageText& message : program.messages) {
    if (message.number == number) return message.text;
  }
  return {};
}

}  // namespace

bool Names(const std::string& expected, const ShownMessage& message) {
  return expected == std::to_string(message.number) || expected == TextOf(message) || expected == message.shown;
}

std::string TextOf(const ShownMessage& message) {
  return message.text.empty() ? "message " + std::to_string(message.number) : message.text;
}

std::unique_ptr<dialects::ControlStub> StubOf(const compilation::Compilation& compilation) {
  if (compilation.dialect->make_stub == nullptr) return nullptr;
  return compilation.dialect->make_stub(compilation.program, compilation.options);
}

ScenarioControl::ScenarioControl(const ir::Program& program, const dialects::Dialect& dialect, sim::Engine& engine,
                                 std::unique_ptr<dialects::ControlStub> stub)
    : program_(program), dialect_(dialect), engine_(engine), stub_(std::move(stub)), messages_(program) {
  for (const ir::Space& space : program.spaces) set_bits_.emplace_back(space.bytes, uint8_t{0});
  if (!stub_) return;
  engine_.AnswerHostCalls(
      [this](ir::HostFunctionId function, std::span<const uint64_t> arguments) { return Answer(function, arguments); });
}

sim::HostAnswer ScenarioControl::Answer(ir::HostFunctionId id, std::span<const uint64_t> arguments) {
  const ir::HostFunction& function = program_.host_functions[id];
  sim::HostAnswer answer;
  only_space_ = function.only_space;
  answer.result = Fitting(function.result, stub_->Call(function, arguments, *this, answer.out));
  only_space_ = {};
  if (answer.out) answer.out = Fitting(function.out.type, *answer.out);
  return answer;
}

void ScenarioControl::PowerOff() {
  for (std::vector<uint8_t>& bits : set_bits_) std::fill(bits.begin(), bits.end(), uint8_t{0});
  if (stub_) stub_->PowerOff();
  plant_ms_ = 0;  // time begins anew; the machine stays where it is
}

void ScenarioControl::PowerOn() {
  messages_.PowerOn();
  MovePlant(0);
  if (stub_) stub_->PowerOn(*this);
}

ScenarioControl::Saved ScenarioControl::Saved::Clone() const {
  return {.stub = stub ? stub->Clone() : nullptr, .set_bits = set_bits, .plant = plant, .plant_ms = plant_ms};
}

ScenarioControl::Moment ScenarioControl::Moment::Clone() const {
  return {.control = control.Clone(), .active = active, .shown = shown};
}

void ScenarioControl::Exchange(Saved& other) {
  std::swap(stub_, other.stub);
  std::swap(set_bits_, other.set_bits);
  std::swap(plant_, other.plant);
  std::swap(plant_ms_, other.plant_ms);
}

void ScenarioControl::Exchange(Moment& other) {
  Exchange(other.control);
  std::vector<uint32_t> active = messages_.active();
  messages_.Become(std::move(other.active));
  other.active = std::move(active);
  std::swap(shown_, other.shown);
}

bool ScenarioControl::IsAt(const Moment& other) const {
  const Saved& control = other.control;
  return (stub_ == nullptr || stub_->IsAtMomentOf(*control.stub)) && set_bits_ == control.set_bits &&
         (!plant_ || plant_->IsAtMomentOf(*control.plant)) && plant_ms_ == control.plant_ms &&
         messages_.active() == other.active && shown_ == other.shown;
}

void ScenarioControl::Attach(std::shared_ptr<const BoundPlant> plant) {
  bound_ = std::move(plant);
  plant_.emplace(bound_->shared_model());
  plant_ms_ = 0;
}

void ScenarioControl::MovePlant(uint32_t now_ms) {
  if (!plant_) return;
  plant_reads_.clear();
  for (const dialects::Location& location : bound_->reads()) {
    plant_reads_.push_back(PlantNumber(location, Read(location)));
  }
  const std::span<const int64_t> drives = plant_->Advance(now_ms - plant_ms_, plant_reads_);
  plant_ms_ = now_ms;
  for (size_t i = 0; i < drives.size(); ++i) {
    const dialects::Location& location = bound_->drives()[i];
    const uint64_t value = PlantBits(location, drives[i]);
    if (ReadLocation(engine_, location) != value) Set(location, value);
  }
}

void ScenarioControl::BeforePeriod(uint32_t now_ms) {
  MovePlant(now_ms);
  if (stub_) stub_->BeforePeriod(now_ms, *this);
}

void ScenarioControl::AfterPeriod(uint32_t now_ms) {
  LookAtMessages();
  if (!stub_) return;
  const ir::PlaceId slow_done = program_.schedule.slow_done;
  const uint64_t cycles = slow_done.valid() ? engine_.Read(program_.places[slow_done]) : 0;
  stub_->AfterPeriod(now_ms, static_cast<uint32_t>(cycles), *this);
}

void ScenarioControl::Set(const dialects::Location& location, uint64_t value) {
  if (location.cell) {
    is_setting_ = true;
    if (stub_) stub_->WriteCell(*location.cell, value, *this);
    is_setting_ = false;
    return;
  }
  // Most are one place: a search sets millions of them.
  if (location.bits.empty()) {
    SetPlace(location.place, value);
    return;
  }
  for (const auto& [place, part] : WritesTo(location, value)) SetPlace(place, part);
}

void ScenarioControl::SetPlace(const ir::Place& place, uint64_t value) {
  if (stub_ && stub_->Takes(place, value)) return;
  engine_.Write(place, value);
  if (stub_ && stub_->Written(place, value, *this)) return;
  NoteSet(place);
}

void ScenarioControl::NoteSet(const ir::Place& place) {
  if (place.is_field() || !place.space.valid()) return;
  std::vector<uint8_t>& bits = set_bits_[place.space.index];
  for (uint32_t i = 0; i < ir::Bytes(place.type) && place.offset + i < bits.size(); ++i) {
    uint8_t& mask = bits[place.offset + i];
    mask = place.type == ir::Type::kBit ? static_cast<uint8_t>(mask | 1u << place.bit) : uint8_t{0xFF};
  }
}

uint64_t ScenarioControl::Read(const dialects::Location& location) {
  return location.cell ? ReadCell(*location.cell) : ReadLocation(engine_, location);
}

sim::ReadWatched ScenarioControl::Reader() {
  return [this](const sim::Watched& watched) {
    if (watched.cell) return ReadCell(*watched.cell);
    dialects::Location location;
    location.place = watched.place;
    location.bits = watched.bits;
    location.has_sign = watched.sign == sim::Sign::kTwosComplement;
    return ReadLocation(engine_, location);
  };
}

void ScenarioControl::LookAtMessages() {
  if (!looks_) return;
  messages_.Observe(engine_);
  for (const uint32_t number : messages_.TakeEntered()) {
    const std::string declared = DeclaredText(program_, number);
    const std::string shown =
        dialect_.message_text != nullptr ? dialect_.message_text(program_, number, *this) : declared;
    shown_.push_back({number, declared.empty() ? shown : declared, shown});
  }
}

std::vector<ShownMessage> ScenarioControl::TakeMessages() { return std::exchange(shown_, {}); }

uint8_t ScenarioControl::Get(ir::SpaceId space, uint32_t offset) const {
  if (const std::span<const uint8_t> bytes = engine_.MemoryFrom(space, offset); !bytes.empty()) return bytes.front();
  return static_cast<uint8_t>(engine_.Read(ByteOf(space, offset)));
}

void ScenarioControl::Set(ir::SpaceId space, uint32_t offset, uint8_t value) {
  const uint8_t before = Get(space, offset);
  PLCXX_CHECK(!only_space_.valid() || only_space_ == space || value == before);
  if (!is_setting_) CheckWrite(program_.spaces[space], offset, before, value);
  const uint8_t kept = set_bits_[space.index][offset];
  const auto after = static_cast<uint8_t>((before & kept) | (value & ~kept));
  if (after != before) engine_.Write(ByteOf(space, offset), after);
}

void ScenarioControl::SetAll(ir::SpaceId space, uint32_t offset, std::span<const uint8_t> values) {
  for (size_t i = 0; i < values.size(); ++i) {
    // What is there already needs no writing. An engine that does not show its memory is asked byte by byte.
    i += CountSame(values.subspan(i), engine_.MemoryFrom(space, offset + static_cast<uint32_t>(i)));
    if (i < values.size()) Set(space, offset + static_cast<uint32_t>(i), values[i]);
  }
}

std::vector<std::pair<ir::Place, uint64_t>> WritesTo(const dialects::Location& location, uint64_t value) {
  if (location.bits.empty()) return {{location.place, value}};
  std::vector<std::pair<ir::Place, uint64_t>> writes;
  for (size_t i = 0; i < location.bits.size(); ++i) writes.emplace_back(location.bits[i], (value >> i) & 1);
  return writes;
}

uint64_t FittingField(const dialects::Location& location, uint64_t value) {
  if (location.bits.empty()) return value;
  const uint64_t high = ~uint64_t{0} << location.bits.size();
  const bool negative = location.has_sign && ((value >> (location.bits.size() - 1)) & 1) != 0;
  return Fitting(location.place.type, negative ? value | high : value & ~high);
}

uint64_t ReadLocation(sim::Engine& engine, const dialects::Location& location) {
  if (location.bits.empty()) return engine.Read(location.place);
  uint64_t value = 0;
  for (size_t i = 0; i < location.bits.size(); ++i) value |= engine.Read(location.bits[i]) << i;
  return FittingField(location, value);
}

sim::Watched WatchLocation(const ir::Program& program, std::string name, const dialects::Location& location) {
  sim::Watched watched;
  if (location.cell) {
    watched = {.name = std::move(name), .scope = "ports", .place = location.place, .cell = location.cell};
  } else {
    watched = sim::Watch(program, std::move(name), location.place);
  }
  watched.sign = SignOf(location);
  watched.bits = location.bits;
  return watched;
}

}  // namespace plcxx::scenarios
