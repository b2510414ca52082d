// The simulated control that a scenario may ask for, driven around each period; what the scenario sets wins over it.
//
// In: a dialect's ControlStub and the engine. Not its job: when a period runs (sim/clock.h).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/program.h"
#include "transpiler/sim/engine.h"

namespace plcxx::driver {

class ScenarioControl : private dialects::ImagePort {
 public:
  /// `stub` may be none: then nothing happens.
  ScenarioControl(const ir::Program& program, sim::Engine& engine, std::unique_ptr<dialects::ControlStub> stub);

  /// Forgets what the scenario has set.
  void PowerOn();
  void BeforePeriod(uint32_t now_ms);
  void AfterPeriod(uint32_t now_ms);
  /// From now on the stub leaves this place alone.
  void NoteSet(const ir::Place& place);

 private:
  uint8_t Get(ir::SpaceId space, uint32_t offset) const override;
  void Set(ir::SpaceId space, uint32_t offset, uint8_t value) override;
  void StoreRetentive() override { engine_.StoreRetentive(); }
  void LookAtMessages() override {}

  const ir::Program& program_;
  sim::Engine& engine_;
  std::unique_ptr<dialects::ControlStub> stub_;
  std::vector<std::vector<uint8_t>> set_bits_;  // by SpaceId and byte: bits that the scenario has set
};

}  // namespace plcxx::driver
