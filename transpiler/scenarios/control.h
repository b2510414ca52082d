// The control that a scenario or a simulation has around the program: the dialect's simulated one if it has one, and
// the operator's eyes on the messages.
//
// In: a dialect's ControlStub and the engine; what the machine does where there is a plant. What a scenario sets wins
// over the stub, unless the stub takes it over as the new level of an input. Not its job: when a period runs
// (sim/clock.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/program.h"
#include "transpiler/plant/plant.h"
#include "transpiler/scenarios/bound_plant.h"
#include "transpiler/sim/active_messages.h"
#include "transpiler/sim/engine.h"
#include "transpiler/sim/trace.h"

namespace plcxx::scenarios {

/// A message that became active.
struct ShownMessage {
  uint32_t number = 0;
  std::string text;   // as the program declares it; empty: there is none
  std::string shown;  // as the operator reads it, with the numbers that the control writes into it
  bool operator==(const ShownMessage&) const = default;
};
/// Whether a scenario means it by its number or one of its texts.
bool Names(const std::string& expected, const ShownMessage& message);
/// "message 9" when it has no text.
std::string TextOf(const ShownMessage& message);

/// The simulated control of a program that compiled, as its options want it; none: its dialect has none, or they want
/// none.
std::unique_ptr<dialects::ControlStub> StubOf(const compilation::Compilation& compilation);

class ScenarioControl : private dialects::ImagePort {
 public:
  /// `stub` may be none: then host calls give 0, and nothing is written. The engine must not run when this is gone.
  ScenarioControl(const ir::Program& program, const dialects::Dialect& dialect, sim::Engine& engine,
                  std::unique_ptr<dialects::ControlStub> stub);

  /// From the next power-on, which delivers the machine, a plant moves around the program.
  void Attach(std::shared_ptr<const BoundPlant> plant);

  /// From now on nobody looks at the messages.
  void LookAway() { looks_ = false; }

  /// Before the init of a power cycle: forgets what the scenario has set.
  void PowerOff();
  /// After init.
  void PowerOn();
  void BeforePeriod(uint32_t now_ms);
  void AfterPeriod(uint32_t now_ms);

  /// The control at a moment, but for the messages that the operator has seen.
  struct Saved {
    std::unique_ptr<dialects::ControlStub> stub;
    std::vector<std::vector<uint8_t>> set_bits;
    std::optional<plant::Plant> plant = {};
    uint32_t plant_ms = 0;
    Saved Clone() const;
  };
  Saved Save() const {
    return {.stub = stub_ ? stub_->Clone() : nullptr, .set_bits = set_bits_, .plant = plant_, .plant_ms = plant_ms_};
  }
  /// Goes back to what this one has saved.
  void Restore(const Saved& saved) {
    Saved copy = saved.Clone();
    Exchange(copy);
  }

  /// The control at a moment, the operator's eyes included.
  struct Moment {
    Saved control;
    std::vector<uint32_t> active;
    std::vector<ShownMessage> shown;
    Moment Clone() const;
  };
  Moment Now() const { return {.control = Save(), .active = messages_.active(), .shown = shown_}; }
  /// Goes where `other` is, which becomes what this one was; of one program and scenario.
  void Exchange(Moment& other);
  /// Whether both go on alike.
  bool IsAt(const Moment& other) const;

  /// The scenario writes `value` into a location that is neither a text input nor absent.
  void Set(const dialects::Location& location, uint64_t value);
  /// What is at a location that is not absent: memory from the engine, a cell from the stub.
  uint64_t Read(const dialects::Location& location);
  uint64_t ReadCell(uint32_t cell) { return stub_ ? stub_->ReadCell(cell, *this) : 0; }
  /// Memory from the engine, cells from the stub.
  sim::ReadWatched Reader();
  const std::vector<uint32_t>& active_messages() const { return messages_.active(); }
  /// With Restore: those that were active at that moment.
  void RestoreMessages(std::vector<uint32_t> active) { messages_.Become(std::move(active)); }
  /// Those that became active since the last call, in order.
  std::vector<ShownMessage> TakeMessages();

 private:
  uint8_t Get(ir::SpaceId space, uint32_t offset) const override;
  void Set(ir::SpaceId space, uint32_t offset, uint8_t value) override;
  void SetAll(ir::SpaceId space, uint32_t offset, std::span<const uint8_t> values) override;
  void StoreRetentive() override { engine_.StoreRetentive(); }
  void LookAtMessages() override;

  void Exchange(Saved& other);
  void SetPlace(const ir::Place& place, uint64_t value);
  /// Lets the plant move up to now, and writes what it drives.
  void MovePlant(uint32_t now_ms);
  sim::HostAnswer Answer(ir::HostFunctionId function, std::span<const uint64_t> arguments);
  /// From now on the stub leaves this place alone.
  void NoteSet(const ir::Place& place);

  const ir::Program& program_;
  const dialects::Dialect& dialect_;
  sim::Engine& engine_;
  std::unique_ptr<dialects::ControlStub> stub_;
  std::vector<std::vector<uint8_t>> set_bits_;  // by SpaceId and byte: bits that the scenario has set
  ir::SpaceId only_space_;                      // of the host function that is answered
  bool is_setting_ = false;                     // what the scenario wants, by the stub
  bool looks_ = true;
  sim::MessageTracker messages_;
  std::vector<ShownMessage> shown_;
  std::shared_ptr<const BoundPlant> bound_;  // none: there is no plant
  std::optional<plant::Plant> plant_;
  uint32_t plant_ms_ = 0;  // up to then it has moved
  std::vector<int64_t> plant_reads_;
};

constexpr sim::Sign SignOf(const dialects::Location& location) {
  return location.has_sign ? sim::Sign::kTwosComplement : sim::Sign::kNone;
}

/// The places that a write to the location writes, and the value for each.
std::vector<std::pair<ir::Place, uint64_t>> WritesTo(const dialects::Location& location, uint64_t value);
/// `value` as memory gives it back: the low bits of a bit-field, and its sign above them.
uint64_t FittingField(const dialects::Location& location, uint64_t value);
/// What is there, for a location in memory.
uint64_t ReadLocation(sim::Engine& engine, const dialects::Location& location);

/// With the scope that the program suggests; a cell belongs to the control's ports.
sim::Watched WatchLocation(const ir::Program& program, std::string name, const dialects::Location& location);

}  // namespace plcxx::scenarios
