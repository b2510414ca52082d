// The builder of the lowerings: ir::Builder with what the dialects write alike. Regions that are filled by a function,
// after which the builder is back where it was; routines; counters; calls of the regular exchange.
//
// The order of instructions is a part of each promise: RegionOf makes its region before the instruction that will own
// it, When and Choose after the If that they append.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "transpiler/ir/builder.h"

namespace plcxx::dialects {

class Builder : public ir::Builder {
 public:
  using ir::Builder::Builder;

  /// What `fill` builds goes to the end of `region`.
  template <class Fill>
  void Into(ir::RegionId region, Fill&& fill) {
    const ir::RegionId after = this->region();
    SetRegion(region);
    fill();
    SetRegion(after);
  }
  /// A new region with what `fill` builds.
  template <class Fill>
  ir::RegionId RegionOf(Fill&& fill) {
    const ir::RegionId region = NewRegion();
    Into(region, fill);
    return region;
  }
  /// If `condition`: what `then` builds.
  template <class Then>
  void When(ir::ValueId condition, Then&& then) {
    const ir::RegionId region = NewRegion();
    If(condition, region);
    Into(region, then);
  }
  /// If `condition`: what `then` builds, else what `otherwise` builds.
  template <class Then, class Otherwise>
  void Choose(ir::ValueId condition, Then&& then, Otherwise&& otherwise) {
    const ir::RegionId first = NewRegion(), second = NewRegion();
    If(condition, first, second);
    Into(first, then);
    Into(second, otherwise);
  }
  /// An arm of a switch that is appended later; without values its default.
  template <class Fill>
  void AddArm(ir::Switch& arms, std::vector<uint64_t> values, Fill&& fill) {
    const ir::RegionId region = RegionOf(fill);
    arms.cases.push_back({.values = std::move(values), .region = region});
  }

  /// A routine with an empty body.
  ir::RoutineId AddRoutine(std::string name, ir::RoutineKind kind, std::string comment);
  /// Adds 1 to an i32.
  void Increment(ir::PlaceId place);
  /// Makes a host call a part of the regular exchange: no event that scenarios list.
  ir::ValueId AsExchange(ir::ValueId call);
};

}  // namespace plcxx::dialects
