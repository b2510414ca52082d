#include "transpiler/dialects/prostep/control/stub.h"

#include <array>

#include "transpiler/dialects/prostep/control/locate.h"
#include "transpiler/dialects/prostep/control/stub_axes.h"
#include "transpiler/dialects/prostep/machine/memory.h"
#include "transpiler/dialects/prostep/machine/options.h"

namespace plcxx::prostep {
namespace {

constexpr uint32_t kPortCount = 133;  // a word of ports may begin at the last one

class Stub final : public dialects::ControlStub {
 public:
  Stub(const ir::Program& program, uint32_t axes) : memory_(program), axes_(memory_, axes) {}

  std::unique_ptr<dialects::ControlStub> Clone() const override { return std::make_unique<Stub>(*this); }
  bool IsAtMomentOf(const dialects::ControlStub& other) const override;
  void PowerOff() override;
  void PowerOn(dialects::ImagePort&) override;
  void BeforePeriod(uint32_t now_ms, dialects::ImagePort&) override;
  uint64_t Call(const ir::HostFunction& function, std::span<const uint64_t> arguments, dialects::ImagePort& image,
                std::optional<uint64_t>& out) override;
  bool Written(const ir::Place& place, uint64_t value, dialects::ImagePort& image) override;
  uint64_t ReadCell(uint32_t cell, const dialects::ImagePort& image) override;
  void WriteCell(uint32_t cell, uint64_t value, dialects::ImagePort& image) override;

 private:
  Memory memory_;
  std::array<uint8_t, kPortCount> inputs_{}, outputs_{};
  std::map<std::pair<uint16_t, uint16_t>, uint32_t> variables_;  // by index and offset
  PlcAxes axes_;
  uint32_t last_tick_ms_ = 0, now_ms_ = 0;
};

bool Stub::IsAtMomentOf(const dialects::ControlStub& other) const {
  const auto& stub = static_cast<const Stub&>(other);
  return inputs_ == stub.inputs_ && outputs_ == stub.outputs_ && variables_ == stub.variables_ &&
         axes_.IsAtMomentOf(stub.axes_) && last_tick_ms_ == stub.last_tick_ms_ && now_ms_ == stub.now_ms_;
}

/// What the machine holds stays: inputs, and what the extra cards were told last. The latches are cleared before PM 0
/// runs, which may write them (4.3).
void Stub::PowerOff() {
  for (uint32_t port = 0; port < kMostOutputBytes; ++port) outputs_[port] = 0;
}

void Stub::PowerOn(dialects::ImagePort&) {
  last_tick_ms_ = now_ms_ = 0;
  axes_.PowerOn();
}

void Stub::BeforePeriod(uint32_t now_ms, dialects::ImagePort&) { now_ms_ = now_ms; }

uint32_t OfWidth(uint64_t value, uint64_t bytes) {
  return static_cast<uint32_t>(bytes >= 4 ? value : value & ((uint64_t{1} << 8 * bytes) - 1));
}

uint64_t Stub::Call(const ir::HostFunction& function, std::span<const uint64_t> arguments, dialects::ImagePort& image,
                    std::optional<uint64_t>& out) {
  const auto variable = [&]() -> uint32_t& {
    return variables_[{static_cast<uint16_t>(arguments[1]), static_cast<uint16_t>(arguments[2])}];
  };
  if (function.name == "read_port") return arguments[0] < kPortCount ? inputs_[arguments[0]] : 0;
  if (function.name == "write_port") {
    if (arguments[0] < kPortCount) outputs_[arguments[0]] = static_cast<uint8_t>(arguments[1]);
  } else if (function.name == "nc_read") {
    out = OfWidth(variable(), arguments[0]);
    return 1;
  } else if (function.name == "nc_write") {
    variable() = OfWidth(arguments[3], arguments[0]);
    return 1;
  } else if (function.name == "plc_to_nc") {
    axes_.Move(now_ms_ - last_tick_ms_, image);
    last_tick_ms_ = now_ms_;
    image.LookAtMessages();
  }
  return 0;
}

/// An input of the machine: the level stays until the scenario changes it, whatever the refresh copies. It is the value
/// that was set, which the image does not show while the input is forced.
bool Stub::Written(const ir::Place& place, uint64_t value, dialects::ImagePort&) {
  if (place.is_field() || place.space != memory_[SpaceKey::kI]) return true;
  for (uint32_t port = 0; port < kMostInputBytes; ++port) {
    const uint32_t byte = InputByteOfPort(port);
    if (byte < place.offset || byte >= place.offset + ir::Bytes(place.type)) continue;
    if (place.type == ir::Type::kBit) {
      const auto mask = static_cast<uint8_t>(1u << place.bit);
      inputs_[port] = static_cast<uint8_t>(value != 0 ? inputs_[port] | mask : inputs_[port] & ~mask);
    } else {
      inputs_[port] = static_cast<uint8_t>(value >> 8 * (byte - place.offset));
    }
  }
  return true;
}

uint64_t Stub::ReadCell(uint32_t cell, const dialects::ImagePort& image) {
  const ControlCell named = CellOf(cell);
  if (named.is_data) {
    uint64_t value = 0;
    for (uint32_t i = 0; i < named.bytes; ++i) {
      const Cell byte = memory_.At(Space::kD, named.number + i);
      value |= uint64_t{image.Get(byte.space, byte.offset)} << 8 * i;
    }
    return value;
  }
  if (named.bit != ir::kNoBit) return outputs_[named.number] >> named.bit & 1;
  return named.bytes == 1 ? outputs_[named.number] : outputs_[named.number] | outputs_[named.number + 1] << 8;
}

void Stub::WriteCell(uint32_t cell, uint64_t value, dialects::ImagePort& image) {
  const ControlCell named = CellOf(cell);
  if (named.is_data) {
    for (uint32_t i = 0; i < named.bytes; ++i) {
      const Cell byte = memory_.At(Space::kD, named.number + i);
      image.Set(byte.space, byte.offset, static_cast<uint8_t>(value >> 8 * i));
    }
    return;
  }
  uint8_t& low = inputs_[named.number];
  if (named.bit != ir::kNoBit) {
    const auto mask = static_cast<uint8_t>(1u << named.bit);
    low = static_cast<uint8_t>(value != 0 ? low | mask : low & ~mask);
    return;
  }
  low = static_cast<uint8_t>(value);
  if (named.bytes == 2) inputs_[named.number + 1] = static_cast<uint8_t>(value >> 8);
}

}  // namespace

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& program,
                                                const std::map<std::string, std::string>& options) {
  return std::make_unique<Stub>(program, ReadSettings(options).plc_axes);
}

}  // namespace plcxx::prostep
