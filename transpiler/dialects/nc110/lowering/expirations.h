// Counters and one-shots whose carry or pulse ends with a part: a step at the end of the part that drives them.
#pragma once

#include <array>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

class Expirations : Context {
 public:
  explicit Expirations(const Context& context) : Context(context) {}

  /// The part that is lowered drives it.
  void Add(ir::StateId state);
  /// In the order of their first statement.
  const std::vector<ir::StateId>& Of(Part part) const { return driven_[static_cast<size_t>(part)].order; }

 private:
  struct Driven {
    std::vector<ir::StateId> order;
    std::unordered_set<uint32_t> known;
  };
  std::array<Driven, 2> driven_;  // by Part
};

}  // namespace plcxx::nc110
