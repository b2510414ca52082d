// A partition begins with its named locals 0 and leaves those of its callers as they were.
#include "transpiler/sim/local_stretches.h"

#include <gtest/gtest.h>

#include "tests/sim/test_program.h"

namespace plcxx::sim {
namespace {

/// `inner` uses two bytes of the locals of `outer`, and its own; `count_high` is a subroutine of `inner` with two more.
constexpr std::string_view kNested = R"(
  space M 16 volatile little host_visible
  space LOCALS 64 routine little
  space OTHERS 64 routine little
  place SEEN i8 M[0]
  place KEPT i8 M[1]
  place AGAIN i8 M[2]
  place OUTER i8 LOCALS[8]
  place SHARED i8 LOCALS[9]
  place HIGH i8 LOCALS[40]
  place OWN i8 OTHERS[3]
  routine count_high subroutine {
    %n = load HIGH
    %one = const i8 1
    %sum = add.i8 %n %one
    store HIGH %sum
    store AGAIN %sum
  }
  routine inner slow {
    %n = load SHARED
    %own = load OWN
    %both = add.i8 %n %own
    store SEEN %both
    %many = const i8 99
    store SHARED %many
    store OWN %many
    call count_high ()
  }
  routine period schedule {
    %seven = const i8 7
    store OUTER %seven
    store SHARED %seven
    store HIGH %seven
    call inner ()
    call inner ()
    %a = load SHARED
    %b = load HIGH
    %c = load OUTER
    %ab = add.i8 %a %b
    %abc = add.i8 %ab %c
    store KEPT %abc
  }
  schedule period period
)";

TEST(LocalStretches, APartitionBeginsWithZerosAndItsCallerGoesOnWithItsOwn) {
  Machine machine{std::string(kNested)};
  machine.Run();
  EXPECT_EQ(machine.Get("SEEN"), 0U) << "of the caller, and of the call before";
  EXPECT_EQ(machine.Get("AGAIN"), 1U) << "what a subroutine of the partition uses is new, too";
  EXPECT_EQ(machine.Get("KEPT"), 21U);
  machine.Run();
  EXPECT_EQ(machine.Get("SEEN"), 0U);
  EXPECT_EQ(machine.Get("KEPT"), 21U);
}

TEST(LocalStretches, ARoutineHasThoseOfWhatItCalls) {
  const Machine machine{std::string(kNested)};
  const ir::Program& program = machine.program;
  std::vector<PlaceAccess> places;
  for (const ir::Place& place : program.places) places.push_back(AccessTo(program, place));
  const std::vector<LocalStretches> found = FindLocalStretches(program, places);
  ASSERT_EQ(found.size(), 3U);
  ASSERT_EQ(found[0].size(), 1U) << "count_high";
  EXPECT_EQ(found[0][0].begin, 40U);
  EXPECT_EQ(found[0][0].end, 41U);
  ASSERT_EQ(found[1].size(), 2U) << "inner";
  EXPECT_EQ(found[1][0].begin, 9U);
  EXPECT_EQ(found[1][0].end, 41U);
  EXPECT_EQ(found[1][1].begin, 3U);
  ASSERT_EQ(found[2].size(), 2U) << "period";
  EXPECT_EQ(found[2][0].begin, 8U);
}

TEST(LocalStretches, ManySpacesAreEachRoutines) {
  std::string text = "space M 4 volatile little host_visible\nplace SEEN i8 M[0]\n";
  for (int i = 0; i < 70; ++i) {
    const std::string n = std::to_string(i);
    text += "space L" + n + " 4 routine little\nplace P" + n + " i8 L" + n + "[1]\n";
  }
  text += "routine inner slow {\n%n = load P69\nstore SEEN %n\nstore P69 %n\n}\n";
  text += "routine period schedule {\n%one = const i8 1\nstore P69 %one\ncall inner ()\n}\nschedule period period\n";
  Machine machine{text};
  machine.Run();
  EXPECT_EQ(machine.Get("SEEN"), 0U);
}

}  // namespace
}  // namespace plcxx::sim
