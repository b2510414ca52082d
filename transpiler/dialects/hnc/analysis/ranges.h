// What an integer can be at a place of a program: bounds that loops and index checks are proved with (specification
// 6.6, 6.9). Bounds are those of the value as its C type reads it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "transpiler/dialects/hnc/analysis/objects.h"
#include "transpiler/dialects/hnc/syntax/bounds.h"

namespace plcxx::hnc {

/// Where a fact about a cell comes from. What has been stored into memory need not be there: it may be forced from
/// outside. kDeclared: of a constant object, its initialiser; no fact of a flow is that.
enum class Origin : uint8_t { kTested, kStored, kDeclared };

/// What is known at one place of a function. Facts are few: a long function forgets old ones.
class Flow {
 public:
  bool reachable = true;
  std::optional<source::Range> critical;  // the `asm cli` that no `asm sti` has ended on some way here

  std::optional<Bounds> Find(const Cell& cell) const;
  /// Only what holds however memory is forced.
  std::optional<Bounds> FindTested(const Cell& cell) const;
  void Learn(const Cell& cell, const Bounds& bounds, Origin origin);
  /// Narrows what is known; what it was narrowed from decides where it comes from.
  void Narrow(const Cell& cell, const Bounds& bounds);
  void Forget(const Cell& cell);
  void Forget(ObjectId object);
  void ForgetAll() { facts_.clear(); }
  /// Keeps what holds on both ways; `other` leads to the same place.
  void JoinWith(const Flow& other);

  /// Automatic variables that some way has not assigned yet.
  std::set<VariableId> unassigned;

 private:
  static constexpr size_t kMostFacts = 48;
  struct Fact {
    Bounds bounds;
    Origin origin = Origin::kTested;
  };
  std::map<Cell, Fact> facts_;
};

}  // namespace plcxx::hnc
