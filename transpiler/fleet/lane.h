// One machine of a fleet as an Engine, for who reads and writes it: a control, a plant, who chooses inputs.
//
// In: a fleet that outlives it. Its time is that of the fleet, which is run by others. What the program has no place
// for is kept here until power-on, and a copy of what only the host writes, for a control reads it again and again. Not
// its job: events, forces, snapshots; they are asked of who executes the machine alone.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "transpiler/fleet/fleet.h"
#include "transpiler/sim/engine.h"

namespace plcxx::fleet {

/// Bytes that the program never writes, and that begin anew with power: by SpaceId and byte where a stretch of them
/// ends; the byte itself where it is none.
using HostOnlyBytes = std::vector<std::vector<uint32_t>>;
HostOnlyBytes FindHostOnly(const ir::Program& program);

class Lane : public sim::Engine {
 public:
  /// `host_only`: of the fleet's program; outlives it.
  Lane(Fleet& fleet, unsigned lane, const HostOnlyBytes& host_only)
      : fleet_(fleet), lane_(lane), host_only_(host_only), kept_(host_only.size()) {}

  std::string_view name() const override { return "lane"; }
  void AnswerHostCalls(sim::HostAnswers answers) override { answers_ = std::move(answers); }
  /// What the control answers to a call of this machine.
  sim::HostAnswer Answer(ir::HostFunctionId function, std::span<const uint64_t> arguments) const {
    return answers_ ? answers_(function, arguments) : sim::HostAnswer{};
  }
  /// The fleet gets power: what is kept here begins anew.
  void PowerOn() override;
  /// The fleet's machine has become another one: so has what is kept here.
  void BecomeLike(const Lane& other) { kept_ = other.kept_; }

  uint64_t Read(const ir::Place& place) override;
  void Write(const ir::Place& place, uint64_t value) override;
  std::span<const uint8_t> MemoryFrom(ir::SpaceId space, uint32_t offset) const override;
  void SendText(std::string_view text) override { fleet_.SendText(lane_, text); }
  void StoreRetentive() override { fleet_.StoreRetentive(lane_); }

  void RunPeriod(uint32_t now_ms) override;
  void RunFastOnly(uint32_t now_ms) override;
  void RunElapse(uint32_t now_ms) override;
  void Force(const ir::Place& place, uint64_t value) override;
  void Release(const ir::Place& place) override;
  void EnableStatement(ir::StatementId statement, bool enabled) override;
  std::vector<sim::HostEvent> TakeEvents() override { return {}; }
  std::vector<uint8_t> Snapshot() override;

 private:
  Fleet& fleet_;
  unsigned lane_;
  sim::HostAnswers answers_;
  const HostOnlyBytes& host_only_;
  /// By SpaceId: bytes that only the host writes, and bits that the fleet does not hold.
  std::vector<std::vector<uint8_t>> kept_;
};

}  // namespace plcxx::fleet
