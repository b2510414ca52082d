// A program in many lanes: each lane is a machine with a state of its own.
//
// In: the parts of its period as terms (machine/relation.h), which cells are wanted. Out: their planes, part by part.
// Cells that the wanted ones do not depend on, and calls, are not there. Host functions answer 0, as in a simulation
// without a stub; what a loop of unknown length does is made up: what is seen here is a candidate, not a fact.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "transpiler/prove/machine/relation.h"
#include "transpiler/symbolic/terms/lanes.h"

namespace plcxx::prove::wide {

inline constexpr uint32_t kNoLane = 0xFFFFFFFF;
/// By word of a plane: the lane of which its lanes become copies; kNoLane: they stay.
using CopyOf = std::array<uint32_t, terms::Plane::kWords>;
inline CopyOf NoCopies() {
  CopyOf copy_of;
  copy_of.fill(kNoLane);
  return copy_of;
}

/// Memory as it is after power-on with nothing stored and a host that answers nothing; refused when `is_late`, too.
machine::Transition PowerOnAlone(terms::Terms& terms, const machine::Version& version,
                                 const std::function<bool()>& is_late);

/// A time for the lanes of each word of a plane.
using Times = std::array<uint64_t, terms::Plane::kWords>;

void SpreadLanes(std::span<terms::Plane> planes, const CopyOf& copy_of);
void SpreadTimes(Times& times, const CopyOf& copy_of);

class WideMachine {
 public:
  /// `cells`: of the relation's version, all that the wanted ones depend on (DependedOn), ascending. `init`: the state
  /// after power-on, by cell. All but `cells` and `init` outlive the machine.
  WideMachine(const terms::Terms& terms, machine::Relation& relation, const std::vector<execute::CellId>& cells,
              const machine::Transition& init);

  void PowerOn();
  /// The lanes of one word begin with the values that `value` gives.
  void Load(uint32_t word, const std::function<uint64_t(execute::CellId)>& value);
  /// The parts of one period, which takes `period_ms`. Where fast and slow part have no times of their own, the period
  /// is all.
  void RunPeriod(const Times& begin_ms, uint32_t period_ms);

  bool Has(execute::CellId cell) const { return cell.valid() && first_plane_[cell.index] != kNowhere; }
  /// As many as the cell is wide; of a cell that it has.
  std::span<terms::Plane> Planes(execute::CellId cell);
  std::span<const terms::Plane> Planes(execute::CellId cell) const;
  /// In the lanes of `where` the bit gets the value that it has in `value`; of what it has not nothing.
  void Store(execute::CellId bit, const terms::Plane& where, const terms::Plane& value);
  void Spread(const CopyOf& copy_of) { SpreadLanes(state_, copy_of); }

 private:
  static constexpr uint32_t kNowhere = 0xFFFFFFFF;
  struct PartProgram {
    terms::LaneProgram program;
    std::vector<execute::CellId> written;  // by root
  };

  void Run(machine::Part part, const Times& now_ms);

  const ir::Schedule& schedule_;
  std::vector<execute::CellId> cells_;
  std::vector<uint32_t> first_plane_;  // by cell
  std::vector<uint8_t> width_;         // by cell
  std::vector<terms::Plane> state_, at_power_on_, next_;
  uint32_t now_plane_ = 0;
  std::optional<PartProgram> fast_, period_;
};

/// The cells that the wanted ones depend on over any number of periods, with them, ascending.
std::vector<execute::CellId> DependedOn(const terms::Terms& terms, const machine::Relation& relation,
                                        std::span<const execute::CellId> wanted);

}  // namespace plcxx::prove::wide
