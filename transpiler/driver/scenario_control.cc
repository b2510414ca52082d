#include "transpiler/driver/scenario_control.h"

#include <algorithm>
#include <utility>

namespace plcxx::driver {
namespace {

ir::Place ByteOf(ir::SpaceId space, uint32_t offset) {
  ir::Place place;
  place.type = ir::Type::kI8;
  place.space = space;
  place.offset = offset;
  return place;
}

}  // namespace

ScenarioControl::ScenarioControl(const ir::Program& program, sim::Engine& engine,
                                 std::unique_ptr<dialects::ControlStub> stub)
    : program_(program), engine_(engine), stub_(std::move(stub)) {
  for (const ir::Space& space : program.spaces) set_bits_.emplace_back(space.bytes, uint8_t{0});
}

void ScenarioControl::PowerOn() {
  for (std::vector<uint8_t>& bits : set_bits_) std::fill(bits.begin(), bits.end(), uint8_t{0});
  if (stub_) stub_->PowerOn(*this);
}

void ScenarioControl::BeforePeriod(uint32_t now_ms) {
  if (stub_) stub_->BeforePeriod(now_ms, *this);
}

void ScenarioControl::AfterPeriod(uint32_t now_ms) {
  if (!stub_) return;
  const ir::PlaceId slow_done = program_.schedule.slow_done;
  const uint64_t cycles = slow_done.valid() ? engine_.Read(program_.places[slow_done]) : 0;
  stub_->AfterPeriod(now_ms, static_cast<uint32_t>(cycles), *this);
}

void ScenarioControl::NoteSet(const ir::Place& place) {
  if (place.is_field() || !place.space.valid()) return;
  std::vector<uint8_t>& bits = set_bits_[place.space.index];
  for (uint32_t i = 0; i < ir::Bytes(place.type) && place.offset + i < bits.size(); ++i) {
    uint8_t& mask = bits[place.offset + i];
    mask = place.type == ir::Type::kBit ? static_cast<uint8_t>(mask | 1u << place.bit) : uint8_t{0xFF};
  }
}

uint8_t ScenarioControl::Get(ir::SpaceId space, uint32_t offset) const {
  return static_cast<uint8_t>(engine_.Read(ByteOf(space, offset)));
}

void ScenarioControl::Set(ir::SpaceId space, uint32_t offset, uint8_t value) {
  const uint8_t before = Get(space, offset);
  const uint8_t kept = set_bits_[space.index][offset];
  const auto after = static_cast<uint8_t>((before & kept) | (value & ~kept));
  if (after != before) engine_.Write(ByteOf(space, offset), after);
}

}  // namespace plcxx::driver
