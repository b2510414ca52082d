// A condition in the language of `plcxx prove`, looked at after each part while the machine runs.
//
// In: "U4A8 and not I0A3 for 100 ms", which comes true, or a whole property ("never A and B"), which is violated. Out:
// whether that happened in the part that has just been executed, and not in the one before. Not its job: the language
// (prove/properties), and what follows (breakpoints, triggers).
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "transpiler/compilation/compilation.h"
#include "transpiler/prove/properties/property.h"
#include "transpiler/scenarios/property_monitor.h"
#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::live {

/// What reading conditions of one program needs; measured once.
struct ConditionContext {
  explicit ConditionContext(const compilation::Compilation& the_compilation);
  const compilation::Compilation& compilation;
  execute::Cells cells;
  prove::properties::PropertyTiming timing;
};

class Condition {
 public:
  /// Or what is wrong with the text. The context outlives the condition.
  static std::variant<Condition, std::string> Parse(const ConditionContext& context, const std::string& text);

  const std::string& text() const { return text_; }
  /// After a part. What held at the first call is no event.
  bool Comes(sim::Engine& engine, sim::Clock::Part part);
  /// The machine is at another moment of its time: nothing is known of before.
  void Forget();

 private:
  Condition() = default;
  std::string text_;
  std::unique_ptr<scenarios::PropertyMonitor> monitor_;
  enum class Seen : uint8_t { kNothing, kFalse, kTrue };
  Seen seen_ = Seen::kNothing;
};

}  // namespace plcxx::live
