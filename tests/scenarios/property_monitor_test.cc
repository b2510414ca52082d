// Properties that are watched in one run: when each is said to be violated, and what counts after that.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/scenarios/scenario_fixture.h"
#include "transpiler/scenarios/property_machine.h"
#include "transpiler/scenarios/property_monitor.h"
#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::scenarios {
namespace {

/// A machine whose bit I0 and word W1 the test sets; a period is 10 ms.
class Watching {
 public:
  explicit Watching(std::string_view properties)
      : dialect_(TestDialect()), cells_(execute::MakeCells(bench_.program)), simulator_(bench_.program) {
    prove::properties::Properties parsed =
        prove::properties::ParseProperties(properties, PropertyContextOf(dialect_, bench_.program, cells_, {}));
    EXPECT_TRUE(parsed.errors.empty());
    monitor_.emplace(bench_.program, cells_, std::move(parsed.properties));
    monitor_->PowerOn();
  }

  /// For each period "." or, where something is violated, the last letter of its text; I0 and W1 as two texts say.
  std::string Run(std::string_view bits, std::string_view words) {
    std::string seen;
    for (size_t i = 0; i < bits.size(); ++i) {
      Set("I0", bits[i] == '1' ? 1 : 0);
      Set("W1", static_cast<uint64_t>(words[i] - '0'));
      monitor_->AfterPart(simulator_, sim::Clock::Part::kWholePeriod);
      const std::optional<std::string>& violation = monitor_->violation();
      seen += violation ? (*violation)[violation->find("' does not hold") - 1] : '.';
      monitor_->GoOn();
    }
    return seen;
  }
  PropertyMonitor& monitor() { return *monitor_; }

 private:
  void Set(std::string_view name, uint64_t value) {
    const ir::NameIndex names(bench_.program);
    simulator_.Write(LocateByName(names, name)->place, value);
  }

  ScenarioBench bench_;
  dialects::Dialect dialect_;
  execute::Cells cells_;
  sim::Simulator simulator_;
  std::optional<PropertyMonitor> monitor_;
};

TEST(PropertyMonitor, WhatIsHeldIsHeldOnBehindAViolation) {
  Watching watching("never I0 for 3 slow and W1 > 2H");
  EXPECT_EQ(watching.Run("1101111101", "3333333333"), ".....HHH..");
  watching.monitor().PowerOn();
  EXPECT_EQ(watching.Run("1101111101", "3333303333"), "......HH..");
}

TEST(PropertyMonitor, WhoAskedWaitsNoLongerBehindAViolation) {
  Watching watching("I0 implies W1 is 5H within 3 slow");
  EXPECT_EQ(watching.Run("1000000100000", "0000000000000"), "..w......w...");
  EXPECT_EQ(watching.Run("1000010000", "0050000500"), "..........");
  // Asked for all the time, it is due again after as long.
  EXPECT_EQ(watching.Run("11111110", "00000000"), "..w..w..");
}

TEST(PropertyMonitor, OfTwoAtOnceTheFirstIsToldAndTheOtherIsNotLost) {
  Watching watching("never W1 is 1H\nI0 implies W1 is 5H within 3 slow");
  EXPECT_EQ(watching.Run("1000000", "0010000"), "..Hw...");
}

TEST(PropertyMonitor, OfAMomentThePastIsUnknown) {
  Watching watching("never I0 for 3 slow and W1 > 2H");
  EXPECT_EQ(watching.Run("11", "33"), "..");
  watching.monitor().PowerOn();
  EXPECT_EQ(watching.Run("111", "333"), "..H");
}

}  // namespace
}  // namespace plcxx::scenarios
