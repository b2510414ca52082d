// The parts of specialize.cc: a walk over a routine that executes what is constant and writes down all else.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::fleet {

/// What is known of named locals at a point of the program.
using Known = std::map<uint32_t, uint64_t>;  // by PlaceId

class Specializer {
 public:
  explicit Specializer(ir::Program& program);
  void Run();

 private:
  /// Of a routine: the constants that it is called with.
  using Arguments = std::vector<std::optional<uint64_t>>;
  using Regions = std::array<ir::RegionId, 3>;  // prologue, body, epilogue

  void WalkRoutine(ir::RoutineId id, const Regions& regions, const Known& arguments);
  void WalkOnce(ir::RoutineId id);
  /// Writes the instructions of `region` behind those that are written; false: what follows is not reached.
  bool WalkInto(ir::RegionId region, Known& known);
  /// Into a region of its own; none becomes none, and what follows it is reached.
  struct Apart {
    ir::RegionId region;
    bool reached = true;
  };
  Apart WalkApart(ir::RegionId region, Known& known);
  bool WalkInst(ir::InstId id, Known& known);
  void WalkPure(ir::InstId id, ir::Inst inst);
  void WalkLoad(ir::InstId id, ir::Inst inst, const Known& known);
  void WalkStore(ir::Inst inst, Known& known);
  bool WalkIf(ir::Inst inst, Known& known);
  bool WalkSwitch(ir::Inst inst, Known& known);
  bool WalkBlock(ir::InstId id, ir::Inst inst, Known& known);
  bool WalkLoop(ir::InstId id, ir::Inst inst, Known& known);
  /// None: it is not known how many rounds there are, or they are too many.
  std::optional<bool> Unroll(ir::InstId id, const ir::Inst& inst, Known& known);
  bool WalkExit(ir::Inst inst);
  void WalkRepeat(ir::Inst inst, Known& known);
  void WalkCall(ir::InstId id, ir::Inst inst);
  void WalkHostCall(ir::InstId id, ir::Inst inst, Known& known);

  ir::InstId Write(const ir::Inst& inst);
  void WriteConstant(ir::InstId id, const ir::Inst& inst, uint64_t value);
  /// Writes a block whose content is `inside`; when nothing leaves it, its instructions alone.
  bool EndBlock(const ir::Inst& block, ir::InstId id, ir::RegionId inside, bool reached);
  void Map(ir::Inst& inst);
  std::optional<uint64_t> Constant(uint32_t value) const;
  ir::CallId CallWith(const ir::Call& call);
  bool IsFollowed(ir::PlaceId place) const { return place.index < followed_.size() && followed_[place.index]; }
  void FindFollowed();
  bool HasRecursion() const;
  /// None: the element is outside the bounds.
  std::optional<ir::PlaceId> ElementAt(ir::PlaceId place, uint64_t index);
  ir::RoutineId CopyFor(ir::RoutineId routine, const Arguments& arguments);
  void ForgetWritten(const std::vector<ir::RegionId>& regions, Known& known) const;
  void RemoveUnread();

  ir::Program& program_;
  std::vector<Regions> sources_;  // by RoutineId
  std::vector<bool> walked_;      // likewise, copies included
  std::vector<uint32_t> now_;     // by InstId of what is read: the value, block or loop that stands for it
  std::vector<bool> followed_;    // by PlaceId
  std::set<uint32_t> left_;       // blocks that an exit leaves
  std::map<std::pair<uint32_t, uint32_t>, std::optional<ir::PlaceId>> elements_;
  std::map<std::pair<uint32_t, Arguments>, ir::RoutineId> copies_;
  ir::RegionId out_;    // is being written
  size_t written_ = 0;  // instructions, in all
  uint32_t depth_ = 0;  // of what is read; 1: the outermost region of a routine
};

}  // namespace plcxx::fleet
