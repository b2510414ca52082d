#include "transpiler/live/condition.h"

#include <utility>

#include "transpiler/scenarios/property_machine.h"
#include "transpiler/scenarios/property_places.h"

namespace plcxx::live {
namespace {

bool IsWholeProperty(const std::string& text) {
  return text.starts_with("never ") || text.starts_with("always ") || text.find(" implies ") != std::string::npos ||
         text.find(" is never stuck") != std::string::npos;
}

}  // namespace

ConditionContext::ConditionContext(const compilation::Compilation& the_compilation)
    : compilation(the_compilation),
      cells(execute::MakeCells(the_compilation.program)),
      timing(scenarios::TimingOf(the_compilation.program)) {}

std::variant<Condition, std::string> Condition::Parse(const ConditionContext& context, const std::string& text) {
  if (text.find_first_of("\r\n#") != std::string::npos) return "a condition is one line without a comment";
  const dialects::Dialect& dialect = *context.compilation.dialect;
  const ir::Program& program = context.compilation.program;
  // A condition comes true where "never" it is violated.
  const std::string property = IsWholeProperty(text) ? text : "never " + text;
  prove::properties::Properties parsed = prove::properties::ParseProperties(
      property, scenarios::PropertyContextOf(dialect, program, context.cells, context.timing));
  if (!parsed.errors.empty()) return scenarios::TextOf(parsed.errors.front(), dialect.name);
  if (parsed.properties.empty()) return "there is no condition";
  if (parsed.properties.front().kind == prove::properties::PropertyKind::kNeverStuck) {
    return "whether something is stuck cannot be seen in one run";
  }
  Condition condition;
  condition.text_ = text;
  condition.monitor_ =
      std::make_unique<scenarios::PropertyMonitor>(program, context.cells, std::move(parsed.properties));
  condition.monitor_->PowerOn();
  return condition;
}

bool Condition::Comes(sim::Engine& engine, sim::Clock::Part part) {
  monitor_->AfterPart(engine, part);
  const Seen now = monitor_->violation() ? Seen::kTrue : Seen::kFalse;
  monitor_->GoOn();
  return std::exchange(seen_, now) == Seen::kFalse && now == Seen::kTrue;
}

void Condition::Forget() {
  monitor_->GoOn();
  monitor_->PowerOn();
  seen_ = Seen::kNothing;
}

}  // namespace plcxx::live
