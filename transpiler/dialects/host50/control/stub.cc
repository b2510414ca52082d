#include "transpiler/dialects/host50/control/stub.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "transpiler/dialects/host50/machine/places.h"

namespace plcxx::host50 {
namespace {

/// What the machine holds of one byte of the image.
struct InputByte {
  ir::SpaceId space;
  uint32_t offset = 0;
  uint8_t mask = 0;  // bits that have been set, or that the program looks at or writes
  uint8_t value = 0;
  bool operator==(const InputByte&) const = default;
};

bool IsInput(ir::SpaceId space) {
  for (const Area area : {Area::kI, Area::kIw, Area::kIf}) {
    if (SpaceOf({.area = area}) == space) return true;
  }
  return false;
}

class MachineStub final : public dialects::ControlStub {
 public:
  /// Inputs that the program only reads are delivered too: one that was forced has its own level again when it is let
  /// go.
  explicit MachineStub(const ir::Program& program) {
    for (const ir::Inst& inst : program.insts) {
      if (inst.op != ir::OpKind::kStore && inst.op != ir::OpKind::kLoad) continue;
      const ir::Place& place = program.places[ir::PlaceId(inst.payload)];
      if (!place.is_field() && IsInput(place.space)) Hold(place, 0);
    }
  }

  uint64_t Call(const ir::HostFunction& function, std::span<const uint64_t> /*arguments*/, dialects::ImagePort& image,
                std::optional<uint64_t>& /*out*/) override {
    if (function.access == ir::HostAccess::kWritesState) Deliver(image);
    return 0;
  }

  std::unique_ptr<dialects::ControlStub> Clone() const override { return std::make_unique<MachineStub>(*this); }
  bool IsAtMomentOf(const dialects::ControlStub& other) const override {
    return bytes_ == static_cast<const MachineStub&>(other).bytes_;
  }

  bool Written(const ir::Place& place, uint64_t value, dialects::ImagePort&) override {
    if (place.is_field() || !IsInput(place.space)) return false;
    Hold(place, value);
    return true;
  }

 private:
  void Hold(const ir::Place& place, uint64_t value) {
    if (place.type == ir::Type::kBit) {
      const auto mask = static_cast<uint8_t>(1u << place.bit);
      InputByte& held = Held(place.space, place.offset);
      held.mask |= mask;
      held.value = static_cast<uint8_t>((held.value & ~mask) | ((value & 1) != 0 ? mask : 0));
      return;
    }
    for (uint32_t i = 0; i < ir::Bytes(place.type); ++i) {
      InputByte& held = Held(place.space, place.offset + i);
      held.mask = 0xFF;
      held.value = static_cast<uint8_t>(value >> (8 * i));
    }
  }

  InputByte& Held(ir::SpaceId space, uint32_t offset) {
    const auto at = std::ranges::lower_bound(bytes_, std::pair(space, offset), {},
                                             [](const InputByte& byte) { return std::pair(byte.space, byte.offset); });
    if (at != bytes_.end() && at->space == space && at->offset == offset) return *at;
    return *bytes_.insert(at, {.space = space, .offset = offset});
  }

  void Deliver(dialects::ImagePort& image) {
    for (const InputByte& held : bytes_) {
      const uint8_t before = image.Get(held.space, held.offset);
      const auto after = static_cast<uint8_t>((before & ~held.mask) | held.value);
      if (after != before) image.Set(held.space, held.offset, after);
    }
  }

  std::vector<InputByte> bytes_;  // ascending
};

}  // namespace

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& program,
                                                const std::map<std::string, std::string>& /*options*/) {
  return std::make_unique<MachineStub>(program);
}

}  // namespace plcxx::host50
