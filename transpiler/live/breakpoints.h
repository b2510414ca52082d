// Where a running program stops: at statements, when a location changes, when a condition comes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/live/condition.h"
#include "transpiler/live/machine.h"
#include "transpiler/live/refusal.h"
#include "transpiler/sim/trace.h"

namespace plcxx::live {

enum class BreakKind : uint8_t { kStatement, kChange, kCondition };
struct Breakpoint {
  uint32_t number = 0;
  BreakKind kind{};
  std::string text;  // of a change the location, of a condition itself
  ir::StatementId statement;
  std::optional<sim::Watched> location;  // of a change
  std::optional<uint64_t> last;          // of a change: the value before
  std::optional<Condition> condition;
};
inline constexpr size_t kMostBreakpoints = 64;

class Breakpoints {
 public:
  explicit Breakpoints(const ir::Program& program) : program_(program), stops_at_(program.statements.size()) {}

  Refusal AtStatement(ir::StatementId statement, bool on);
  /// From its value now.
  Refusal AtChange(sim::Watched location, uint64_t now);
  /// What is so already does not come.
  Refusal AtCondition(Condition condition, Machine& machine);
  Refusal Remove(uint32_t number);

  /// Asked before each statement; none where no statement has one.
  Machine::StopAt StatementStops() const;
  /// Why the program stops after this period; empty: it does not.
  std::string AfterPeriod(Machine& machine);
  /// The machine is at a moment that does not follow from the one before.
  void Forget();

  const std::vector<Breakpoint>& all() const { return breakpoints_; }

 private:
  Refusal Add(Breakpoint breakpoint);

  const ir::Program& program_;
  std::vector<Breakpoint> breakpoints_;
  uint32_t next_ = 1;
  std::vector<bool> stops_at_;  // by StatementId
};

}  // namespace plcxx::live
