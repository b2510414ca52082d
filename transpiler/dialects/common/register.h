// A register of an accumulator language (status, accumulator) while its program is lowered.
//
// No register exists in the result: what an instruction leaves in one is a value of the IR that the next one uses.
// Values end with their statement, so that what lives longer goes through a place of lifetime kRoutine: Spill() in
// front of every border (the next statement, a label, a jump, a call), a load at the first use after it. Stores that
// nothing reads vanish later (passes/remove_dead_locals.h), so a lowering spills at every border without asking.
#pragma once

#include <cstdint>
#include <optional>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/facts.h"

namespace plcxx::dialects {

class Register {
 public:
  /// `place`: of lifetime kRoutine. What the register holds at first is in it. `facts` gets what a constant that it is
  /// known to hold rests on.
  Register(ir::Builder& builder, ir::PlaceId place, const ir::FactChecks& facts)
      : builder_(builder), place_(place), facts_(facts) {}

  ir::PlaceId place() const { return place_; }

  /// What it holds: the value set last in this statement, a constant, or a load of its place.
  ir::ValueId Get();
  void Set(ir::ValueId value);
  /// It is known to hold `value` here, and so does its place, by the way that the program has come (a jump that was
  /// not taken tells its condition).
  void Know(uint64_t value);
  /// The constant that it is known to hold, for who decides something by it.
  std::optional<uint64_t> Known();
  /// Was something set or loaded in this statement?
  bool has_value() const { return value_.valid(); }

  /// From here on the place holds what the register holds.
  void Spill();
  /// What it holds is in its place: after a label, a call, an If that set it.
  void Forget();
  /// Before the marker of the next statement: spills what was set; a constant stays known.
  void EndStatement();

 private:
  /// That the place holds the constant, where that is not the last thing which this statement has set.
  void CheckKnown();

  ir::Builder& builder_;
  ir::PlaceId place_;
  const ir::FactChecks& facts_;
  ir::ValueId value_;              // none: not in this statement
  std::optional<uint64_t> known_;  // survives statements
  bool in_place_ = true;           // the place holds the same
};

}  // namespace plcxx::dialects
