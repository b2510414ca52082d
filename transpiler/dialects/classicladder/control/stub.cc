#include "transpiler/dialects/classicladder/control/stub.h"

#include <utility>

#include "transpiler/dialects/classicladder/machine/places.h"

namespace plcxx::classicladder {
namespace {

/// The pins of the engine: what a scenario sets is delivered in each period, also over what the program has written.
class PinStub final : public dialects::ControlStub {
 public:
  explicit PinStub(const ir::Program& program) {
    for (const Group group : {Group::kBits, Group::kWords, Group::kFloats}) {
      for (const ir::Zone& zone : program.spaces[SpaceOf(group)].zones) {
        if (zone.direction == ir::Direction::kInput) inputs_.push_back({SpaceOf(group), zone.begin / 8, zone.end / 8});
      }
    }
    for (const Stretch& stretch : inputs_) bytes_.emplace_back(stretch.end - stretch.begin);
  }

  std::unique_ptr<dialects::ControlStub> Clone() const override { return std::make_unique<PinStub>(*this); }
  bool IsAtMomentOf(const dialects::ControlStub& other) const override {
    return bytes_ == static_cast<const PinStub&>(other).bytes_;
  }

  uint64_t Call(const ir::HostFunction& function, std::span<const uint64_t> /*arguments*/, dialects::ImagePort& image,
                std::optional<uint64_t>& /*out*/) override {
    if (function.access != ir::HostAccess::kWritesState) return 0;
    for (size_t i = 0; i < inputs_.size(); ++i) {
      for (uint32_t k = 0; k < bytes_[i].size(); ++k) {
        const uint32_t offset = inputs_[i].begin + k;
        if (image.Get(inputs_[i].space, offset) != bytes_[i][k]) image.Set(inputs_[i].space, offset, bytes_[i][k]);
      }
    }
    return 0;
  }

  bool Written(const ir::Place& place, uint64_t value, dialects::ImagePort& /*image*/) override {
    for (size_t i = 0; i < inputs_.size(); ++i) {
      const Stretch& stretch = inputs_[i];
      if (place.is_field() || place.space != stretch.space) continue;
      if (place.offset < stretch.begin || place.offset >= stretch.end) continue;
      const uint32_t first = place.offset - stretch.begin;
      if (place.type == ir::Type::kBit) {
        // One bit of a word: the others stay as they are.
        const auto mask = static_cast<uint8_t>(1u << place.bit);
        bytes_[i][first] = static_cast<uint8_t>((bytes_[i][first] & ~mask) | ((value & 1) != 0 ? mask : 0));
        return true;
      }
      for (uint32_t k = 0; k < ir::Bytes(place.type); ++k)
        bytes_[i][first + k] = static_cast<uint8_t>(value >> (8 * k));
      return true;
    }
    return false;
  }

 private:
  struct Stretch {
    ir::SpaceId space;
    uint32_t begin = 0, end = 0;
  };
  std::vector<Stretch> inputs_;
  std::vector<std::vector<uint8_t>> bytes_;  // of each, what the pins hold
};

}  // namespace

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& program,
                                                const std::map<std::string, std::string>& /*options*/) {
  return std::make_unique<PinStub>(program);
}

}  // namespace plcxx::classicladder
