// The inputs of a machine by the names that scenarios have for them, and what they may be set to.
//
// In: a program as a machine. Out: a table that does not change. Inputs are what nothing of the program's side writes
// (prove/machine/inputs.h), and requests, which the control takes back. Not its job: which are set when (trial.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/review/diff/stimulus.h"
#include "transpiler/scenarios/bound_plant.h"
#include "transpiler/scenarios/property_machine.h"
#include "transpiler/soak/machines.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::soak {

struct Input {
  std::string name;
  dialects::Location location;
  uint8_t width = 1;  // bits
  uint64_t free = 1;  // bits of the value that are inputs; the others keep what they are
  bool is_float = false;
  bool is_request = false;     // taken back, never made
  bool is_of_machine = false;  // in a zone of inputs; else memory that a host may write
};

/// Words of scenarios as locations; one for each thread, for it remembers what was asked.
class Words {
 public:
  explicit Words(const compilation::Compilation& compilation)
      : compilation_(compilation), names_(compilation.program) {}
  /// What a scenario's `set` of the word writes; none: the program does not know it.
  struct Write {
    const dialects::Location* location;  // lives as long as this object
    uint64_t value = 0;                  // of a location that is no text input
  };
  std::optional<Write> Find(const std::pair<std::string, std::string>& word);
  /// As a scenario's `set`; what the program does not know is left out.
  void Set(const std::pair<std::string, std::string>& word, Machines& machines, size_t machine);

 private:
  const compilation::Compilation& compilation_;
  const ir::NameIndex names_;
  std::unordered_map<std::string, std::optional<dialects::Location>> known_;  // looked up only
};

/// Runs of elsewhere for machines with a plant: without what it drives.
void LeaveToPlant(const scenarios::BoundPlant& plant, const compilation::Compilation& compilation,
                  std::vector<review::diff::Stimuli>& runs);

class Inputs {
 public:
  /// `machine`: the program as it runs, with its slices. What the plant drives, or some of it, is left to the plant,
  /// which may be none.
  explicit Inputs(const scenarios::ProveMachine& machine, const scenarios::BoundPlant* plant = nullptr);

  const std::vector<Input>& all() const { return inputs_; }
  /// Inputs that no scenario can name: they stay as they are at power-on.
  size_t nameless() const { return nameless_; }
  size_t driven() const { return driven_; }
  /// Waits worth while, ascending: up to presets of timers, and beyond.
  const std::vector<uint32_t>& waits_ms() const { return waits_ms_; }

  /// Some value for an input that is `now`.
  uint64_t ValueFor(const Input& input, uint64_t now, terms::Random& random) const;
  /// As a scenario writes it.
  static std::string TextOf(const Input& input, uint64_t value);

  /// An input that the statement depends on: read by it, or by what wrote what it reads, and so on, some steps back by
  /// chance. None: chance led nowhere.
  std::optional<uint32_t> Towards(ir::StatementId statement, terms::Random& random) const;
  /// Statements that write the cell, by number.
  const std::vector<uint32_t>& WritersOf(execute::CellId cell) const { return writers_[cell.index]; }

 private:
  void FindInputs(const scenarios::ProveMachine& machine, const scenarios::BoundPlant* plant);
  void FindConstants(const ir::Program& program);
  void FindReads(const scenarios::ProveMachine& machine);

  std::vector<Input> inputs_;
  std::vector<uint64_t> constants_;  // ascending, each once
  std::vector<uint32_t> waits_ms_;
  size_t nameless_ = 0, driven_ = 0;
  std::vector<std::vector<uint32_t>> input_of_cell_;  // by CellId: at most one
  std::vector<std::vector<uint32_t>> writers_;        // by CellId
  /// What a statement reads, by StatementId: inputs, and statements that write the rest.
  struct Read {
    std::vector<uint32_t> inputs;
    std::vector<ir::StatementId> writers;
  };
  std::vector<Read> reads_;
};

}  // namespace plcxx::soak
