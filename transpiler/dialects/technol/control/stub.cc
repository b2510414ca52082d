#include "transpiler/dialects/technol/control/stub.h"

#include <array>

#include "transpiler/dialects/technol/machine/memory.h"
#include "transpiler/dialects/technol/machine/options.h"
#include "transpiler/dialects/technol/parser/names.h"

namespace plcxx::technol {
namespace {

constexpr uint32_t kConstantBytes = 400;  // of BUKON00 to BUKON99

class Stub final : public dialects::ControlStub {
 public:
  Stub(const ir::Program& program, Retain retain)
      : memory_(program), retain_(retain), backup_(*FindName(ir::NameIndex(program), "REQ_BACKUP_MEM")) {}

  std::unique_ptr<dialects::ControlStub> Clone() const override { return std::make_unique<Stub>(*this); }
  bool IsAtMomentOf(const dialects::ControlStub& other) const override {
    const auto& stub = static_cast<const Stub&>(other);
    return was_pending_ == stub.was_pending_ && constants_ == stub.constants_;
  }
  void PowerOn(dialects::ImagePort& image) override {
    was_pending_ = false;
    GiveConstants(image);
  }

  void AfterPeriod(uint32_t /*now_ms*/, uint32_t /*slow_cycles*/, dialects::ImagePort& image) override {
    was_pending_ = IsPending(image);
  }

  /// Every request stays busy: the scenario ends it.
  uint64_t Call(const ir::HostFunction& function, std::span<const uint64_t> /*arguments*/, dialects::ImagePort& image,
                std::optional<uint64_t>& /*out*/) override {
    if (function.name == "machine_constants") GiveConstants(image);
    return 0;
  }

  bool Written(const ir::Place& place, uint64_t /*value*/, dialects::ImagePort& image) override {
    if (place.is_field()) return false;
    if (place.space == memory_[Area::kBukon]) {
      for (uint32_t i = 0; i < kConstantBytes; ++i) constants_[i] = image.Get(place.space, i);
    }
    if (place.space != memory_[backup_.area]) return false;
    const bool pending = IsPending(image);
    if (retain_ == Retain::kDual && was_pending_ && !pending) image.StoreRetentive();
    was_pending_ = pending;
    return false;
  }

 private:
  bool IsPending(const dialects::ImagePort& image) const {
    return (image.Get(memory_[backup_.area], static_cast<uint32_t>(backup_.offset)) >> backup_.bit & 1) != 0;
  }
  void GiveConstants(dialects::ImagePort& image) const {
    const ir::SpaceId space = memory_[Area::kBukon];
    for (uint32_t i = 0; i < kConstantBytes; ++i) {
      if (image.Get(space, i) != constants_[i]) image.Set(space, i, constants_[i]);
    }
  }

  Memory memory_;
  Retain retain_;
  NamedThing backup_;
  bool was_pending_ = false;
  std::array<uint8_t, kConstantBytes> constants_{};
};

}  // namespace

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& program,
                                                const std::map<std::string, std::string>& options) {
  return std::make_unique<Stub>(program, ReadSettings(options).retain);
}

}  // namespace plcxx::technol
