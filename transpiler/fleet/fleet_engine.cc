#include "transpiler/fleet/fleet_engine.h"

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/fleet/fleet.h"
#include "transpiler/ir/zones.h"
#include "transpiler/support/check.h"

namespace plcxx::fleet {
namespace {

/// Those that a fleet has of them: the ends of words and vectors, where a wrong shift would show.
constexpr unsigned kCarriers[] = {0, 1, 63, 64, 255, 511};

class FleetEngine : public sim::Engine {
 public:
  explicit FleetEngine(std::shared_ptr<const Library> library)
      : fleet_(std::move(library)), program_(fleet_.program()), noise_lanes_(fleet_.AllLanes()) {
    for (const unsigned lane : kCarriers) {
      if (lane >= fleet_.lanes()) continue;
      carriers_.push_back(lane);
      noise_lanes_[lane / 64] &= ~(uint64_t{1} << (lane % 64));
    }
    events_.resize(carriers_.size());
    for (const ir::Space& space : program_.spaces) {
      shadow_.emplace_back(space.bytes, 0);
      shadow_forced_.emplace_back(space.bytes, 0);
    }
    FindNoisyPlanes();
    fleet_.AnswerHostCalls([this](const FleetCall& call) { Answer(call); });
  }

  std::string_view name() const override { return name_; }

  void PowerOn() override {
    for (uint32_t s = 0; s < shadow_.size(); ++s) {
      std::vector<uint8_t> fresh(shadow_[s].size(), 0);
      for (const ir::InitialByte& initial : program_.spaces[ir::SpaceId(s)].initial) {
        if (initial.offset < fresh.size()) fresh[initial.offset] = initial.value;
      }
      for (size_t i = 0; i < fresh.size(); ++i) {
        const int kept = shadow_forced_[s][i];
        shadow_[s][i] = static_cast<uint8_t>((shadow_[s][i] & kept) | (fresh[i] & ~kept));
      }
    }
    fleet_.PowerOn();
  }
  void RunPeriod(uint32_t now_ms) override { Run(Piece::kPeriod, now_ms); }
  void RunFastOnly(uint32_t now_ms) override { Run(Piece::kFastOnly, now_ms); }
  void RunElapse(uint32_t now_ms) override { Run(Piece::kElapse, now_ms); }

  void AnswerHostCalls(sim::HostAnswers answers) override { answers_ = std::move(answers); }

  uint64_t Read(const ir::Place& place) override {
    if (place.is_field()) return fleet_.Read(carriers_.front(), place);
    uint64_t value = 0;
    sim::ForEachBitOf(program_, place, [&](ir::SpaceId space, uint32_t offset, uint8_t bit, uint32_t at) {
      const bool one = fleet_.Holds(space, offset, bit) ? fleet_.Bit(carriers_.front(), space, offset, bit)
                                                        : (shadow_[space.index][offset] >> bit & 1) != 0;
      value |= uint64_t{one} << at;
    });
    return value;
  }

  void Write(const ir::Place& place, uint64_t value) override {
    for (const unsigned lane : carriers_) fleet_.Write(lane, place, value);
    if (place.is_field()) return;
    sim::ForEachBitOf(program_, place, [&](ir::SpaceId space, uint32_t offset, uint8_t bit, uint32_t at) {
      if ((shadow_forced_[space.index][offset] >> bit & 1) == 0) SetShadow(space, offset, bit, (value >> at & 1) != 0);
    });
  }

  void Force(const ir::Place& place, uint64_t value) override {
    SetForced(place, false);
    Write(place, value);
    SetForced(place, true);
  }
  void Release(const ir::Place& place) override { SetForced(place, false); }

  void SendText(std::string_view text) override {
    for (const unsigned lane : carriers_) fleet_.SendText(lane, text);
  }

  /// A fleet is made of what is executed: statements are switched off in the simulator.
  void EnableStatement(ir::StatementId, bool enabled) override { PLCXX_CHECK(enabled); }

  void StoreRetentive() override {
    fleet_.StoreRetentive();
    stored_shadow_ = shadow_;
  }

  std::vector<sim::HostEvent> TakeEvents() override {
    std::vector<std::vector<sim::HostEvent>> events(carriers_.size());
    std::swap(events, events_);
    for (size_t i = 1; i < carriers_.size(); ++i) {
      if (events[i] == events.front()) continue;
      NameLane(carriers_[i]);
      return events[i];
    }
    return events.front();
  }

  std::vector<uint8_t> Snapshot() override {
    std::vector<uint8_t> first = fleet_.Snapshot(carriers_.front(), shadow_);
    for (size_t i = 1; i < carriers_.size(); ++i) {
      std::vector<uint8_t> other = fleet_.Snapshot(carriers_[i], shadow_);
      if (other == first) continue;
      NameLane(carriers_[i]);
      return other;
    }
    return first;
  }

 private:
  void NameLane(unsigned lane) { name_ = "fleet, lane " + std::to_string(lane); }

  void Run(Piece piece, uint32_t now_ms) {
    MakeNoise();
    fleet_.Run(piece, now_ms);
  }

  /// What the control writes; every bit that the host sees where the program does not say which that is.
  void FindNoisyPlanes() {
    for (const bool inputs_only : {true, false}) {
      for (uint32_t s = 0; s < program_.spaces.size(); ++s) {
        const ir::Space& space = program_.spaces[ir::SpaceId(s)];
        if (!space.host_visible) continue;
        for (uint32_t offset = 0; offset < space.bytes; ++offset) {
          const uint8_t inputs = ir::BitsInZones(space, offset, ir::Direction::kInput);
          for (uint8_t bit = 0; bit < 8; ++bit) {
            if (inputs_only && (inputs >> bit & 1) == 0) continue;
            if (fleet_.Holds(ir::SpaceId(s), offset, bit)) noisy_.push_back({ir::SpaceId(s), offset, bit});
          }
        }
      }
      if (!noisy_.empty()) return;
    }
  }

  /// A few inputs of the lanes that carry no scenario change.
  void MakeNoise() {
    constexpr uint32_t kOneIn = 8;
    for (const auto& [space, offset, bit] : noisy_) {
      if (random_() % kOneIn != 0) continue;
      const std::span<uint64_t> words = fleet_.PlaneOf(space, offset, bit);
      for (size_t w = 0; w < words.size(); ++w) words[w] ^= random_() & random_() & noise_lanes_[w];
      if (!words.empty()) continue;
      const auto lane = static_cast<unsigned>(random_() % fleet_.lanes());
      if ((noise_lanes_[lane / 64] >> (lane % 64) & 1) != 0)
        fleet_.SetBit(lane, space, offset, bit, (random_() & 1) != 0);
    }
  }

  void Answer(const FleetCall& call) {
    const ir::Schedule& schedule = program_.schedule;
    const ir::HostFunction& function = program_.host_functions[call.function];
    const bool is_store = call.function == schedule.retentive_load || call.function == schedule.retentive_store;
    std::optional<sim::HostAnswer> answer;
    for (size_t i = 0; i < carriers_.size(); ++i) {
      const unsigned lane = carriers_[i];
      if (!call.calls(lane)) continue;
      std::vector<uint64_t> arguments;
      for (size_t a = 0; a < function.parameters.size(); ++a)
        arguments.push_back(call.arguments[a * call.lanes + lane]);
      if (!function.routine_exchange) events_[i].push_back({call.function, arguments});
      if (is_store) continue;
      // All carriers are the same machine: what the control does about the call is done in each of them.
      if (!answer) answer = answers_ ? answers_(call.function, arguments) : sim::HostAnswer{};
      if (call.results != nullptr) call.results[lane] = answer->result;
      if (call.seconds != nullptr) call.seconds[lane] = answer->out.value_or(0);
      if (answer->out) call.has_second[lane / 64] |= uint64_t{1} << (lane % 64);
    }
    if (call.calls(carriers_.front())) MoveRetentive(call.function);
    if (is_store || (function.result == ir::Type::kNone && function.out.name.empty())) return;
    for (unsigned lane = 0; lane < call.lanes; ++lane) {
      if ((noise_lanes_[lane / 64] >> (lane % 64) & 1) == 0) continue;
      if (call.results != nullptr) call.results[lane] = random_();
      if (call.seconds != nullptr) call.seconds[lane] = random_();
      call.has_second[lane / 64] |= (random_() & 1) << (lane % 64);
    }
  }

  /// What the host keeps of retentive bytes that the fleet does not hold.
  void MoveRetentive(ir::HostFunctionId function) {
    if (function == program_.schedule.retentive_store) stored_shadow_ = shadow_;
    if (function != program_.schedule.retentive_load || stored_shadow_.empty()) return;
    for (uint32_t s = 0; s < shadow_.size(); ++s) {
      if (program_.spaces[ir::SpaceId(s)].lifetime != ir::Lifetime::kRetentive) continue;
      for (size_t i = 0; i < shadow_[s].size(); ++i) {
        const int kept = shadow_forced_[s][i];
        shadow_[s][i] = static_cast<uint8_t>((shadow_[s][i] & kept) | (stored_shadow_[s][i] & ~kept));
      }
    }
  }

  void SetShadow(ir::SpaceId space, uint32_t offset, uint8_t bit, bool one) {
    uint8_t& byte = shadow_[space.index][offset];
    byte = static_cast<uint8_t>(one ? byte | (1u << bit) : byte & ~(1u << bit));
  }

  void SetForced(const ir::Place& place, bool forced) {
    if (place.is_field()) {
      for (const unsigned lane : carriers_) fleet_.ForceField(lane, place.state, place.field, forced);
      return;
    }
    sim::ForEachBitOf(program_, place, [&](ir::SpaceId space, uint32_t offset, uint8_t bit, uint32_t) {
      for (const unsigned lane : carriers_) fleet_.ForceBit(lane, space, offset, bit, forced);
      uint8_t& byte = shadow_forced_[space.index][offset];
      byte = static_cast<uint8_t>(forced ? byte | (1u << bit) : byte & ~(1u << bit));
    });
  }

  struct NoisyBit {
    ir::SpaceId space;
    uint32_t offset;
    uint8_t bit;
  };

  Fleet fleet_;
  const ir::Program& program_;
  std::string name_ = "fleet";
  std::vector<unsigned> carriers_;
  LaneSet noise_lanes_;
  std::vector<NoisyBit> noisy_;
  std::vector<std::vector<uint8_t>> shadow_, shadow_forced_;  // by SpaceId: bits that the fleet does not hold
  std::vector<std::vector<uint8_t>> stored_shadow_;           // empty: nothing was stored
  std::vector<std::vector<sim::HostEvent>> events_;           // of each carrier
  sim::HostAnswers answers_;
  std::mt19937_64 random_{20'000};  // the same in each run
};

}  // namespace

std::unique_ptr<sim::Engine> StartFleet(std::shared_ptr<const Library> library) {
  return std::make_unique<FleetEngine>(std::move(library));
}

}  // namespace plcxx::fleet
