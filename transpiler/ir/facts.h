// Facts that decisions rest on, as assertions: the checked flavour of a program.
//
// Who decides from a range or a bound (leaves out the check of an index, folds a comparison, drops a sign, calls a loop
// proved, takes a register for a constant) states here what must hold. In: a builder where the decision is taken. Out:
// nothing where facts are trusted; where they are checked, a call of the host function `false_fact` under the condition
// that the fact does not hold. A host call is an effect, so that no pass removes or moves it; simulator and generated
// code execute it, scenarios fail with it, and `plcxx verify` shows that none is reached. The decision itself must not
// depend on the flavour. Not its job: which statement a fact belongs to (passes/complete_facts.h), proofs.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "transpiler/ir/builder.h"

namespace plcxx::ir {

enum class Facts : uint8_t { kTrusted, kChecked };

/// What is decided from the fact.
enum class FactKind : uint8_t {
  kComparison,  // a comparison folded, or made without signs
  kDivision,    // the check of a divisor left out, or a division made without signs
  kShift,       // a count not masked, or a shift made without signs
  kSign,        // a number widened without its sign
  kVariable,    // a variable known to be in a range
  kIndex,       // the check of an index left out
  kLoop,        // a loop called proved: it ends after so many iterations
  kRegister,    // a register of the language taken for a constant
  kResult       // the result of an operation not looked at
};
/// "COMPARISON", by FactKind.
std::span<const std::string_view> FactNames();

/// Called where a fact does not hold; none: facts are trusted.
HostFunctionId FalseFactOf(const Program& program);
HostFunctionId AddFalseFact(Program& program);
/// Which argument of `false_fact` is what.
enum class FalseFactArgument : uint8_t { kKind, kStatement, kValue };
bool IsFalseFact(const Program& program, const Inst& inst);

class FactChecks {
 public:
  explicit FactChecks(Builder& builder) : builder_(builder) {}
  void Begin(Facts facts) {
    if (facts == Facts::kChecked) false_fact_ = AddFalseFact(builder_.program());
  }
  /// Of a program that has been begun with; false where its facts are trusted.
  bool Resume() {
    false_fact_ = FalseFactOf(builder_.program());
    return on();
  }

  bool on() const { return false_fact_.valid(); }
  /// `holds`: a bit that must be 1 here. `value`: what it is said of, a bit or an integer; shown without sign.
  void Check(FactKind kind, ValueId holds, ValueId value) const;
  /// What is executed only where a fact does not hold.
  void Fail(FactKind kind, ValueId value) const;

 private:
  Builder& builder_;
  HostFunctionId false_fact_;
};

}  // namespace plcxx::ir
