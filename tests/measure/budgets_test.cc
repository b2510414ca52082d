// How many rounds loops with a budget can make in one call of a partition.
#include "transpiler/measure/budgets.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "transpiler/ir/reader.h"

namespace plcxx::measure {
namespace {

constexpr std::string_view kSpaces = R"(space m 16 volatile little host_visible
space r 32 routine little
place a bit m[0].0
place left i32 m[4]
place kept i32 m[8]
place rounds i32 r[4]
place own i32 r[8]
)";

/// A subroutine with a loop that takes from the budget, and a partition that calls it.
std::optional<uint64_t> Rounds(const std::string& partition, const std::string& budget = "rounds",
                               const std::string& before_loop = "") {
  const ir::Program program =
      ir::ReadOrDie(std::string(kSpaces) + "routine slow slow {\n" + partition + "}\nroutine search subroutine {\n" +
                    before_loop + "  loop @1 budget 0 " + budget + R"( {
    body {
      %0 = load a
      repeat @1 if %0 refused {
      }
    }
  }
}
)");
  ir::RoutineId slow;
  for (uint32_t i = 0; i < program.routines.size(); ++i)
    if (program.routines[ir::RoutineId(i)].name == "slow") slow = ir::RoutineId(i);
  for (const auto& [place, rounds] : BudgetRounds(program, slow))
    if (program.places[ir::PlaceId(place)].name == budget) return rounds;
  return std::nullopt;
}

const std::string kFill = "  %9 = const i32 100\n  store rounds %9\n";
const std::string kCall = "  call search ()\n";

TEST(BudgetRounds, AreThoseOfTheFillingHoweverManyLoopsTakeFromIt) {
  EXPECT_EQ(Rounds(kFill + kCall), 100u);
  EXPECT_EQ(Rounds(kFill + kCall + kCall), 100u);
  EXPECT_EQ(Rounds("  %0 = load a\n  if %0 {\n  " + kFill +
                   "  } else {\n  %1 = const i32 70\n  store rounds %1\n  }\n" + kCall),
            100u);
}

TEST(BudgetRounds, CountEachFilling) {
  EXPECT_EQ(Rounds(kFill + kCall + "  %1 = const i32 60\n  store rounds %1\n" + kCall), 200u);
  EXPECT_EQ(Rounds(kCall + kCall + kCall, "rounds", kFill), 300u);
}

TEST(BudgetRounds, OfABudgetThatOutlivesThePartitionAreWhatWasLeft) {
  EXPECT_EQ(Rounds("  %0 = const i32 100\n  store left %0\n" + kCall, "left"), 200u);
}

TEST(BudgetRounds, MayBeKeptElsewhereMeanwhile) {
  EXPECT_EQ(
      Rounds(kFill + "  %1 = load rounds\n  store own %1\n" + kCall + "  %2 = load own\n  store rounds %2\n" + kCall),
      100u);
  EXPECT_EQ(Rounds("  %0 = const i32 50\n  store kept %0\n  %1 = load kept\n  store rounds %1\n" + kCall +
                   "  %2 = load rounds\n  store kept %2\n"),
            100u);
}

TEST(BudgetRounds, AreNotKnownWhereNoConstantFillsIt) {
  EXPECT_EQ(Rounds("  %0 = load kept\n  %1 = const i32 1\n  %2 = add.i32 %0 %1\n  store rounds %2\n" + kCall),
            std::nullopt);
}

}  // namespace
}  // namespace plcxx::measure
