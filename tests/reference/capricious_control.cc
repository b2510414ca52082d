#include "tests/reference/capricious_control.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/reference/random_program.h"
#include "transpiler/symbolic/execute/host_writes.h"

namespace plcxx::reference {
namespace {

constexpr std::string_view kLineBegin = "name: a capricious control, ";
constexpr uint32_t kMostWrites = 3;  // of a call

struct WritableByte {
  ir::SpaceId space;
  uint32_t offset;
  execute::ControlBits bits;
};

class CapriciousControl final : public dialects::ControlStub {
 public:
  CapriciousControl(const ir::Program& program, uint64_t seed, std::unique_ptr<dialects::ControlStub> control)
      : program_(&program), random_(seed), control_(std::move(control)) {}
  CapriciousControl(const CapriciousControl& other)
      : program_(other.program_),
        random_(other.random_),
        control_(other.control_ ? other.control_->Clone() : nullptr) {}
  CapriciousControl& operator=(const CapriciousControl&) = delete;

  std::unique_ptr<dialects::ControlStub> Clone() const override { return std::make_unique<CapriciousControl>(*this); }
  void PowerOff() override {
    if (control_) control_->PowerOff();
  }
  void PowerOn(dialects::ImagePort& image) override {
    if (control_) control_->PowerOn(image);
  }
  void BeforePeriod(uint32_t now_ms, dialects::ImagePort& image) override {
    if (control_) control_->BeforePeriod(now_ms, image);
  }
  void AfterPeriod(uint32_t now_ms, uint32_t slow_cycles, dialects::ImagePort& image) override {
    if (control_) control_->AfterPeriod(now_ms, slow_cycles, image);
  }
  bool Takes(const ir::Place& place, uint64_t value) override { return control_ && control_->Takes(place, value); }
  bool Written(const ir::Place& place, uint64_t value, dialects::ImagePort& image) override {
    return control_ && control_->Written(place, value, image);
  }
  uint64_t ReadCell(uint32_t cell, const dialects::ImagePort& image) override {
    return control_ ? control_->ReadCell(cell, image) : 0;
  }
  void WriteCell(uint32_t cell, uint64_t value, dialects::ImagePort& image) override {
    if (control_) control_->WriteCell(cell, value, image);
  }

  uint64_t Call(const ir::HostFunction& function, std::span<const uint64_t> arguments, dialects::ImagePort& image,
                std::optional<uint64_t>& out) override {
    const uint64_t obliging = control_ ? control_->Call(function, arguments, image, out) : 0;
    if (function.access == ir::HostAccess::kWritesState && random_.OneIn(3)) Write(function, image);
    // Also where it refuses: then nobody may take it.
    if (function.out.type != ir::Type::kNone && random_.OneIn(3)) out = random_.Next();
    if (!random_.OneIn(3)) return obliging;
    return random_.OneIn(4) ? random_.Next() : random_.Below(3);
  }

 private:
  /// Bytes that the program has places in: what else the control writes nobody sees.
  const std::vector<WritableByte>& WritableBy(const ir::HostFunction& function) {
    const auto [found, is_new] = writable_.try_emplace(function.name);
    if (!is_new) return found->second;
    for (uint32_t i = 0; i < program_->places.size(); ++i) {
      const ir::Place& place = program_->places[ir::PlaceId(i)];
      if (place.is_field() || !place.space.valid() || !program_->spaces[place.space].host_visible) continue;
      const ir::Space& space = program_->spaces[place.space];
      const uint32_t end = std::min(space.bytes, place.offset + ir::Bytes(place.type));
      for (uint32_t offset = place.offset; offset < end; ++offset) {
        const uint8_t may = execute::BitsMayWrite(*program_, function, place.space, offset);
        const execute::ControlBits control = execute::BitsControlWrites(space, offset);
        const execute::ControlBits bits = {.values = static_cast<uint8_t>(control.values & may),
                                           .clears = static_cast<uint8_t>(control.clears & may)};
        if ((bits.values | bits.clears) != 0) found->second.push_back({place.space, offset, bits});
      }
    }
    return found->second;
  }
  void Write(const ir::HostFunction& function, dialects::ImagePort& image) {
    const std::vector<WritableByte>& writable = WritableBy(function);
    if (writable.empty()) return;
    for (uint32_t i = random_.Between(1, kMostWrites); i > 0; --i) {
      const WritableByte& byte = random_.Pick(writable);
      const auto changed = static_cast<uint8_t>(random_.OneIn(2) ? 1u << random_.Below(8) : random_.Below(256));
      const uint8_t before = image.Get(byte.space, byte.offset);
      image.Set(byte.space, byte.offset,
                static_cast<uint8_t>((before ^ (changed & byte.bits.values)) & ~(changed & byte.bits.clears)));
    }
  }

  const ir::Program* program_;
  Random random_;
  std::unique_ptr<dialects::ControlStub> control_;
  std::map<std::string, std::vector<WritableByte>> writable_;  // by function
};

}  // namespace

std::unique_ptr<dialects::ControlStub> MakeCapricious(const ir::Program& program, uint64_t seed,
                                                      std::unique_ptr<dialects::ControlStub> control) {
  return std::make_unique<CapriciousControl>(program, seed, std::move(control));
}

std::string CapriciousLine(uint64_t seed) { return std::string(kLineBegin) + std::to_string(seed) + "\n"; }

std::optional<uint64_t> CapriciousSeed(const std::string& scenario_path) {
  std::ifstream file(scenario_path);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(kLineBegin)) return std::stoull(line.substr(kLineBegin.size()));
  }
  return std::nullopt;
}

}  // namespace plcxx::reference
