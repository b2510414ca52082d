// One version in the simulator, with the dialect's simulated control around it, as a scenario has it.
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "transpiler/prove/diff/match.h"
#include "transpiler/review/diff/diff.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::review::diff {

struct Stimulus;

class DiffMachine {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// Powers on. Both outlive the machine. A step that is not done at `end` is left there.
  DiffMachine(const DiffSide& side, const prove::machine::Version& version, Time end = Time::max());

  void SetCell(execute::CellId cell, uint64_t value);
  /// As a scenario's `set`; what the version does not know is left out.
  void SetWord(const std::string& location, const std::string& value);
  /// Sets what the stimulus says, by the old or the new cells, and lets the time pass. false: the program got stuck, or
  /// it is late.
  bool Apply(const Stimulus& stimulus, execute::CellId prove::diff::SetCell::* cell);
  /// Takes a picture of all state.
  void Look();
  /// The same without the calls: these are those of the next Look().
  void LookAtMemory();
  /// The value of a cell in the picture; of calls a number that tells equal histories from others. What a picture does
  /// not show is 0.
  uint64_t Seen(execute::CellId cell) const;
  /// As Seen, and of memory that no picture shows, too; of calls 0.
  uint64_t ValueOf(execute::CellId cell) const;
  /// Of memory as a scenario names it; none: it is something else, or not there.
  std::optional<uint64_t> ValueOfWord(const std::string& location) const;
  uint64_t time_ms() const { return clock_.time_ms(); }
  /// The calls between the last two calls of Look().
  const std::vector<sim::HostEvent>& events() const { return events_; }

  /// The picture, and where it has a cell that is no calls: for who compares many.
  const std::vector<uint8_t>& picture() const { return picture_; }
  uint32_t ByteOf(execute::CellId cell) const { return byte_of_[cell.index]; }

  /// A moment between two steps; to be saved after Look().
  struct Saved {
    sim::Simulator::Saved simulator;
    scenarios::ScenarioControl::Saved control;
    uint64_t time_ms = 0;
    std::vector<uint64_t> calls;
  };
  Saved Save() const;
  /// Goes back to what this machine has saved.
  void Restore(const Saved& saved);
  void EndAt(Time end) { end_ = end; }
  const ir::NameIndex& names() const { return names_; }

 private:
  void SetPlace(const ir::Place& place, uint64_t value);
  bool Advance(const Stimulus& stimulus);

  const DiffSide& side_;
  const ir::Program& program_;
  const ir::NameIndex names_{program_};
  const prove::machine::Version& version_;
  sim::Simulator simulator_;
  scenarios::ScenarioControl control_;
  sim::Clock clock_;
  Time end_;
  std::vector<uint32_t> byte_of_;  // by cell: where the picture has it; kNowhere: nowhere
  std::vector<uint8_t> picture_;
  std::vector<sim::HostEvent> events_;
  std::vector<uint64_t> calls_;  // a hash of the calls so far: by host function, and of all that are ordered
};

}  // namespace plcxx::review::diff
