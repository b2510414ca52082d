// Facts that decisions rest on, stated where they are decided (ir/facts.h): a comparison folded, a sign dropped, a
// check of an index or a divisor left out.
#pragma once

#include <functional>

#include "transpiler/dialects/hnc/lowering/context.h"
#include "transpiler/ir/facts.h"

namespace plcxx::hnc {

class StatedFacts : Context {
 public:
  explicit StatedFacts(const Context& context) : Context(context) {}

  void Check(ir::FactKind kind, ir::ValueId fact, ir::ValueId value);
  void Where(ir::ValueId condition, bool holds, const std::function<void()>& body);
  /// That a number is where it is believed to be. What its type, or the byte that it was widened from, says is no
  /// belief.
  void CheckBounds(ir::FactKind kind, const Value& value);
  void Begin() { checks_.Begin(settings_.facts); }
  /// Whether facts become assertions; else they are trusted.
  bool on() const { return checks_.on(); }
  /// A place that no execution comes to.
  void Fail(ir::FactKind kind) {
    if (checks_.on()) checks_.Fail(kind, Long(0));
  }

 private:
  ir::FactChecks checks_{builder_};
  ir::ValueId given_;  // a bit: where it is 0, what is computed is not used; none: it is
};

}  // namespace plcxx::hnc
