// A search for runs that violate a property, in many lanes at once.
//
// Each lane is a machine with inputs of its own, from power-on. The property is computed in all lanes after each
// period, with counts for what is held and what is waited for (condition.h). Now and then whole groups of lanes become
// copies of one that is worth more: one in which most of what the violation needs is so, or in which a bit or a number
// has a value that it seldom had, as that of a late step of a sequence.
//
//   never A and B      lanes with A alone are copied, and go on in 64 ways each; in one of them B comes
//
// What is found is a candidate: the host answers nothing here, and the control does nothing by itself but take back
// requests. In: a program as terms, a property. Out: a run. Not its job: repeating the run, making it short.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/prove/invariants/invariants.h"
#include "transpiler/prove/properties/result.h"
#include "transpiler/prove/wide/history.h"
#include "transpiler/prove/wide/inputs.h"
#include "transpiler/prove/wide/machine.h"

namespace plcxx::prove::properties {

class WideSearch {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `relation` must have no refusal, and outlives the search with `terms`. `numbers`: of the program, as cells. Not
  /// for kNeverStuck. When it is not ready at `end`, it finds nothing.
  WideSearch(terms::Terms& terms, machine::Relation& relation, const RunSearch& search,
             const std::vector<std::vector<execute::CellId>>& numbers, Time end);

  /// The next one that is found before `end`.
  std::optional<PropertyRun> Find(Time end);
  /// Some states to which the last runs came.
  void ForEachState(const std::function<void(const invariants::CellValues& state, uint64_t now_ms)>& visit) const;

 private:
  static constexpr uint32_t kWords = terms::Plane::kWords;

  /// How often a bit had each value in a lane when lanes were chosen.
  struct Seen {
    uint64_t zeros = 0, ones = 0;
  };
  struct StateBit {
    execute::CellId cell;
    uint8_t number = 0;
    Seen seen = {};
  };

  /// A number of the state, its lowest bit first, and in how many lanes it had each value when lanes were chosen.
  struct Number {
    std::vector<std::pair<execute::CellId, uint8_t>> bits;
    std::unordered_map<uint64_t, uint64_t> seen;  // looked up only; by the value, or what is kept of a great one
  };

  void AddNumbers(const std::vector<std::vector<execute::CellId>>& numbers);
  void AddProperty(const Property& property);
  void AddInputs(const RunSearch& search, const std::vector<execute::CellId>& cells);
  void PowerOn();
  /// One period, and what the property says after it; the lanes in which it is violated.
  terms::Plane Advance(const wide::Period& period);
  static void AddRareLanes(const terms::Plane& bit, Seen& seen, wide::Scores& scores);
  void AddRareLanes(Number& number, wide::Scores& scores) const;
  /// Copies lanes that are worth more than others.
  void Select(wide::Period& period);
  std::optional<PropertyRun> Episode(Time end);
  PropertyRun RunOf(uint32_t lane) const;

  terms::Terms& terms_;
  machine::Relation& relation_;
  std::optional<wide::WideMachine> machine_;
  std::optional<wide::WideInputs> inputs_;
  std::vector<execute::CellId> requests_;
  std::vector<bool> handshakes_;  // by cell
  std::vector<StateBit> near_;    // that the property depends on
  std::vector<Number> numbers_;   // likewise
  // The property: planes of the cells that it names, then those of its counts.
  std::vector<execute::CellId> named_;
  std::vector<uint8_t> count_widths_;
  size_t first_count_ = 0;
  std::vector<Seen> seen_counts_;  // by plane of a count
  std::vector<terms::Plane> looked_at_;
  std::optional<terms::LaneProgram> property_;  // roots: the counts, that it is violated, what that is a conjunction of
  size_t conjuncts_ = 0;
  std::vector<wide::Period> history_;  // of the episode
  size_t set_ = 0;                     // in it
  wide::Times now_ms_{};
  uint32_t episodes_ = 0;
  terms::Random random_{0x9FB21C651E98DF25};
};

}  // namespace plcxx::prove::properties
