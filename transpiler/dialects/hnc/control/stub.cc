#include "transpiler/dialects/hnc/control/stub.h"

#include <array>
#include <cstdlib>
#include <span>
#include <vector>

#include "transpiler/dialects/hnc/control/locate.h"
#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/machine/options.h"

namespace plcxx::hnc {
namespace {

constexpr uint32_t kInputs = 100;  // of X; after them is the copy

class Stub final : public dialects::ControlStub {
 public:
  Stub(const ir::Program& program, const Settings& settings) : program_(program), settings_(settings) {
    for (uint32_t i = 0; i < program.spaces.size(); ++i) {
      const ir::Space& space = program.spaces[ir::SpaceId(i)];
      for (const AreaRow& row : Areas()) {
        if (space.name == row.name) spaces_[static_cast<size_t>(row.area)] = ir::SpaceId(i);
      }
      if (space.name == "system") system_ = ir::SpaceId(i);
    }
    for (const AreaRow& row : Areas()) host_[static_cast<size_t>(row.area)].resize(row.bytes);
    for (const ir::Place& place : program.places) {
      if (place.name == "fault_statement" && place.space == system_) fault_ = place.offset;
      if (place.name == "handwheel_0" && place.space == system_) handwheels_ = place.offset;
    }
  }

  std::unique_ptr<dialects::ControlStub> Clone() const override { return std::make_unique<Stub>(*this); }
  bool IsAtMomentOf(const dialects::ControlStub& other) const override {
    return host_ == static_cast<const Stub&>(other).host_;
  }

  uint64_t Call(const ir::HostFunction& function, std::span<const uint64_t> arguments, dialects::ImagePort& image,
                std::optional<uint64_t>&) override {
    if (function.name == "parameters") {
      HandOver(Area::kP, Bytes(Area::kP), image);
    } else if (function.name == "inputs") {
      HandOver(Area::kX, kInputs, image);
      HandOver(Area::kF, Bytes(Area::kF), image);
      HandOver(Area::kP, Bytes(Area::kP), image);
    } else if (!arguments.empty() && (function.name.starts_with("axis_") || function.name.starts_with("handwheel"))) {
      return AxisCall(function.name, arguments, image);
    }
    return 0;
  }

  bool Takes(const ir::Place& place, uint64_t value) override {
    if (place.is_field()) return false;
    if (place.space == SpaceOf(Area::kX) && place.offset < kInputs) {
      Keep(Area::kX, place, value);
      return true;
    }
    if (place.space == SpaceOf(Area::kF)) {
      Keep(Area::kF, place, value);
      return true;
    }
    // P is set on both sides.
    if (place.space == SpaceOf(Area::kP)) Keep(Area::kP, place, value);
    return false;
  }

  /// What is set in memory is the program's from then on.
  bool Written(const ir::Place&, uint64_t, dialects::ImagePort&) override { return true; }

  uint64_t ReadCell(uint32_t cell, const dialects::ImagePort& image) override {
    if (cell != kFaultLineCell) return 0;
    uint32_t id = 0;
    for (uint32_t i = 0; i < 4; ++i) id |= uint32_t{image.Get(system_, fault_ + i)} << (8 * i);
    if (id == 0) return 0;
    for (const ir::Statement& statement : program_.statements) {
      if (statement.id == id) return statement.line;
    }
    return 0;
  }

 private:
  ir::SpaceId SpaceOf(Area area) const { return spaces_[static_cast<size_t>(area)]; }
  uint32_t Bytes(Area area) const { return static_cast<uint32_t>(host_[static_cast<size_t>(area)].size()); }

  void HandOver(Area area, uint32_t bytes, dialects::ImagePort& image) {
    image.SetAll(SpaceOf(area), 0, std::span(host_[static_cast<size_t>(area)]).first(bytes));
  }

  void Keep(Area area, const ir::Place& place, uint64_t value) {
    std::vector<uint8_t>& held = host_[static_cast<size_t>(area)];
    if (place.type == ir::Type::kBit) {
      const auto mask = static_cast<uint8_t>(1u << place.bit);
      uint8_t& byte = held[place.offset];
      byte = static_cast<uint8_t>(value != 0 ? byte | mask : byte & ~mask);
      return;
    }
    for (uint32_t i = 0; i < ir::Bytes(place.type) && place.offset + i < held.size(); ++i) {
      held[place.offset + i] = static_cast<uint8_t>(value >> (8 * i));
    }
  }

  // With sysfunc=host: what 6.10 says, on the image.
  uint32_t Get(Area area, uint32_t word, uint32_t bytes, dialects::ImagePort& image) const {
    uint32_t value = 0;
    for (uint32_t i = 0; i < bytes; ++i) value |= uint32_t{image.Get(SpaceOf(area), 2 * word + i)} << (8 * i);
    return value;
  }
  void Set(uint32_t word, uint32_t bytes, uint32_t value, dialects::ImagePort& image) {
    for (uint32_t i = 0; i < bytes; ++i) {
      image.Set(SpaceOf(Area::kG), 2 * word + i, static_cast<uint8_t>(value >> (8 * i)));
    }
  }
  static int32_t Signed16(uint64_t value) { return static_cast<int16_t>(static_cast<uint16_t>(value)); }
  static int32_t Signed32(uint64_t value) { return static_cast<int32_t>(static_cast<uint32_t>(value)); }
  static uint32_t Magnitude(int32_t value) {
    return value < 0 ? 0U - static_cast<uint32_t>(value) : static_cast<uint32_t>(value);
  }

  uint32_t TakeHandwheel(uint64_t wheel, dialects::ImagePort& image) {
    const auto at = handwheels_ + 2 * static_cast<uint32_t>(wheel & 3);
    const uint32_t counts = image.Get(system_, at) | uint32_t{image.Get(system_, at + 1)} << 8;
    image.Set(system_, at, 0);
    image.Set(system_, at + 1, 0);
    return counts;
  }

  void Step(uint32_t axis, int32_t way, dialects::ImagePort& image) {
    if (way == 0) return;
    const uint32_t l = Get(Area::kG, 10 * axis + 1, 4, image) + static_cast<uint32_t>(way);
    const uint32_t parts = Magnitude(Signed32(l));
    const int32_t quotient = Signed32(parts) / 200;
    int32_t v = Signed32(static_cast<uint32_t>(quotient) * Get(Area::kF, 251, 2, image));
    const int32_t vmax = Signed16(Get(Area::kF, 10 * axis + 7, 2, image));
    if (v > vmax) v = vmax;
    if (v < 2) v = 2;
    Set(10 * axis + 1, 4, l, image);
    Set(10 * axis + 3, 2, static_cast<uint32_t>(v), image);
  }

  void Move(uint32_t axis, int32_t way, int32_t speed, dialects::ImagePort& image) {
    if (way == 0) return;
    const uint32_t pic = Get(Area::kG, 10 * axis + 1, 4, image);
    const uint32_t l1 = Magnitude(Signed32(pic)), l2 = Magnitude(way);
    const auto magnitude16 = [](int32_t value) { return static_cast<uint32_t>(Signed16(Magnitude(value))); };
    const uint32_t v1 = magnitude16(Signed16(Get(Area::kG, 10 * axis + 3, 2, image))), v2 = magnitude16(speed);
    const int32_t sum = Signed32(l1 + l2), product = Signed32(l1 * v1 + l2 * v2);
    const int32_t mean = sum == 0 ? 0 : sum == -1 ? Signed32(0U - static_cast<uint32_t>(product)) : product / sum;
    Set(10 * axis + 3, 2, static_cast<uint32_t>(mean), image);
    Set(10 * axis + 1, 4, pic + static_cast<uint32_t>(way), image);
  }

  void StopAxis(uint32_t axis, dialects::ImagePort& image) {
    int32_t l = Signed32(Get(Area::kG, 10 * axis + 1, 4, image));
    const uint32_t speed = static_cast<uint32_t>(Signed16(Get(Area::kG, 10 * axis + 3, 2, image)));
    const int32_t b = Signed32(speed * Get(Area::kF, 251, 2, image)) / 200;
    const int32_t rest = Signed32(0U - static_cast<uint32_t>(l));
    if (l > 0) {
      if (l > b) l = b;
    } else if (rest > b) {
      l = settings_.stop == StopOption::kPrinted ? rest : Signed32(0U - static_cast<uint32_t>(b));
    }
    Set(10 * axis + 1, 4, static_cast<uint32_t>(l), image);
    Set(10 * axis + 4, 2, 0, image);
    Home(axis, false, image);
  }

  void Home(uint32_t axis, bool on, dialects::ImagePort& image) {
    const uint32_t word = Get(Area::kG, 10 * axis, 2, image);
    Set(10 * axis, 2, on ? word | 0x40U : word & ~0x40U, image);
  }

  uint64_t AxisCall(std::string_view name, std::span<const uint64_t> arguments, dialects::ImagePort& image) {
    const auto a = static_cast<uint32_t>(arguments[0] & 15);
    const auto position = [&] { return Get(Area::kF, 10 * a + 1, 4, image) + Get(Area::kG, 10 * a + 1, 4, image); };
    if (name == "axis_home") Home(a, arguments[1] != 0, image);
    if (name == "axis_jog") Set(10 * a + 4, 2, static_cast<uint32_t>(arguments[1]), image);
    if (name == "axis_step") Step(a, Signed32(arguments[1]), image);
    if (name == "axis_move") Move(a, Signed32(arguments[1]), Signed16(arguments[2]), image);
    if (name == "axis_moveto") {
      Move(a, Signed32(static_cast<uint32_t>(arguments[1]) - position()), Signed16(arguments[2]), image);
    }
    if (name == "axis_stop") StopAxis(a, image);
    if (name == "axis_pos") return position();
    if (name == "axis_done") {
      return Get(Area::kG, 10 * a + 1, 4, image) == 0 && Get(Area::kG, 10 * a + 4, 2, image) == 0 ? 1 : 0;
    }
    if (name == "handwheel_take") return TakeHandwheel(arguments[0], image);
    if (name == "handwheel") {
      const auto axis = static_cast<uint32_t>(arguments[1] & 15);
      const int32_t counts = Signed16(TakeHandwheel(arguments[0], image));
      Step(axis, Signed32(static_cast<uint32_t>(counts) * static_cast<uint32_t>(Signed16(arguments[2]))), image);
    }
    return 0;
  }

  const ir::Program& program_;
  const Settings settings_;
  std::array<ir::SpaceId, 7> spaces_;
  ir::SpaceId system_;
  std::array<std::vector<uint8_t>, 7> host_;  // by Area; of those that the host writes
  uint32_t fault_ = 0, handwheels_ = 0;
};

}  // namespace

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& program,
                                                const std::map<std::string, std::string>& options) {
  return std::make_unique<Stub>(program, ReadSettings(options));
}

}  // namespace plcxx::hnc
