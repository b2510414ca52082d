#include "transpiler/soak/simulated_machines.h"

#include <utility>

#include "transpiler/scenarios/control.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/support/check.h"

namespace plcxx::soak {
namespace {

/// Instructions of one part. The largest programs have some hundred thousand; loops with a guard may multiply them.
constexpr uint64_t kMostOfPart = 20'000'000;

struct SimulatedMoment : Moment {
  SimulatedMoment(sim::Simulator::Saved saved, scenarios::ScenarioControl::Saved saved_control)
      : simulator(std::move(saved)), control(std::move(saved_control)) {}
  sim::Simulator::Saved simulator;
  scenarios::ScenarioControl::Saved control;
  std::vector<uint32_t> messages;
  uint64_t time_ms = 0;
};

class SimulatedMachine {
 public:
  SimulatedMachine(const compilation::Compilation& compilation,
                   const std::shared_ptr<const scenarios::BoundPlant>& plant)
      : simulator_(compilation.program),
        control_(compilation.program, *compilation.dialect, simulator_, scenarios::StubOf(compilation)),
        clock_(compilation.program, {&simulator_}) {
    if (plant) control_.Attach(plant);
    new_ = std::make_unique<SimulatedMoment>(simulator_.Save(), control_.Save());
    simulator_.StopWhen([this] { return simulator_.executed() > most_; });
    clock_.before_period = [this](uint32_t now_ms) {
      most_ = simulator_.executed() + kMostOfPart;
      control_.BeforePeriod(now_ms);
    };
    clock_.after_period = [this](uint32_t now_ms) {
      if (simulator_.stopped()) return;
      control_.AfterPeriod(now_ms);
      if (after_ != nullptr) (*after_)(number_, clock_.last_part());
    };
    clock_.interrupted = [this] { return simulator_.stopped(); };
  }

  void PowerOn() {
    Restore(*new_);
    most_ = simulator_.executed() + kMostOfPart;
    clock_.PowerOn();
    control_.PowerOn();
    simulator_.TakeEvents();
    control_.TakeMessages();
  }
  void PowerCycle() {
    most_ = simulator_.executed() + kMostOfPart;
    control_.PowerOff();
    clock_.PowerCycle();
    control_.PowerOn();
  }
  void Run(const Piece& piece, const Machines::AfterPart& after) {
    number_ = piece.machine;
    after_ = &after;
    const sim::Step step = clock_.RunFor(piece.slow, piece.fast, piece.ms);
    after_ = nullptr;
    end_ = simulator_.stopped() ? PieceEnd::kEndless : step == sim::Step::kStuck ? PieceEnd::kStuck : PieceEnd::kDone;
    control_.TakeMessages();  // only which are active is asked for
  }
  std::shared_ptr<const Moment> Save() const {
    auto moment = std::make_shared<SimulatedMoment>(simulator_.Save(), control_.Save());
    moment->messages = control_.active_messages();
    moment->time_ms = clock_.time_ms();
    return moment;
  }
  void Restore(const SimulatedMoment& moment) {
    simulator_.Restore(moment.simulator);
    control_.Restore(moment.control);
    control_.RestoreMessages(moment.messages);
    clock_.GoTo(moment.time_ms);
    end_ = PieceEnd::kDone;
  }

  sim::Simulator& simulator() { return simulator_; }
  const sim::Simulator& simulator() const { return simulator_; }
  scenarios::ScenarioControl& control() { return control_; }
  const scenarios::ScenarioControl& control() const { return control_; }
  uint64_t time_ms() const { return clock_.time_ms(); }
  PieceEnd end() const { return end_; }

 private:
  sim::Simulator simulator_;
  scenarios::ScenarioControl control_;
  sim::Clock clock_;
  std::unique_ptr<const SimulatedMoment> new_;
  uint64_t most_ = kMostOfPart;
  size_t number_ = 0;
  const Machines::AfterPart* after_ = nullptr;
  PieceEnd end_ = PieceEnd::kDone;
};

class OneByOne : public Machines {
 public:
  OneByOne(const compilation::Compilation& compilation, std::shared_ptr<const scenarios::BoundPlant> plant,
           size_t count)
      : compilation_(compilation), plant_(std::move(plant)), given_(count) {
    for (size_t i = 0; i < count; ++i) machines_.push_back(std::make_unique<SimulatedMachine>(compilation, plant_));
  }

  size_t count() const override { return machines_.size(); }
  void PowerOn(size_t machine) override {
    Renew(machine);
    machines_[machine]->PowerOn();
  }
  void PowerCycle(size_t machine) override { machines_[machine]->PowerCycle(); }
  void Set(size_t machine, const dialects::Location& location, uint64_t value) override {
    machines_[machine]->control().Set(location, value);
  }
  void SendText(size_t machine, std::string_view text) override { machines_[machine]->simulator().SendText(text); }
  void Run(std::span<const Piece> pieces, const AfterPart& after) override {
    for (const Piece& piece : pieces) machines_[piece.machine]->Run(piece, after);
  }
  PieceEnd EndOf(size_t machine) const override { return machines_[machine]->end(); }
  sim::Engine& EngineOf(size_t machine) override { return machines_[machine]->simulator(); }
  const std::vector<uint32_t>& ActiveMessages(size_t machine) const override {
    return machines_[machine]->control().active_messages();
  }
  uint64_t TimeMs(size_t machine) const override { return machines_[machine]->time_ms(); }
  void NoteGiven(size_t machine, std::span<uint8_t> given) override {
    given_[machine] = given;
    machines_[machine]->simulator().NoteGiven(given);
  }
  uint64_t Work(size_t machine) const override { return worked_ + machines_[machine]->simulator().executed(); }
  std::shared_ptr<const Moment> Save(size_t machine) override { return machines_[machine]->Save(); }
  void Restore(size_t machine, const Moment& moment) override {
    const auto* const own = dynamic_cast<const SimulatedMoment*>(&moment);
    PLCXX_CHECK(own != nullptr);
    Renew(machine);
    machines_[machine]->Restore(*own);
  }

 private:
  /// One that was stopped in the middle of a part executes nothing any more.
  void Renew(size_t machine) {
    if (!machines_[machine]->simulator().stopped()) return;
    worked_ += machines_[machine]->simulator().executed();
    machines_[machine] = std::make_unique<SimulatedMachine>(compilation_, plant_);
    machines_[machine]->simulator().NoteGiven(given_[machine]);
  }

  const compilation::Compilation& compilation_;
  std::shared_ptr<const scenarios::BoundPlant> plant_;
  std::vector<std::unique_ptr<SimulatedMachine>> machines_;
  std::vector<std::span<uint8_t>> given_;
  uint64_t worked_ = 0;
};

}  // namespace

MakeMachines SimulatedMachines(const compilation::Compilation& compilation,
                               std::shared_ptr<const scenarios::BoundPlant> plant) {
  return [&compilation, plant = std::move(plant)](size_t count) {
    return std::make_unique<OneByOne>(compilation, plant, count);
  };
}

}  // namespace plcxx::soak
