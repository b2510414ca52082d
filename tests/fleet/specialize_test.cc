// What constants decide is decided before a fleet is made of a program, and elements at an index.
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "tests/fleet/lanes_beside.h"
#include "transpiler/engines/platform.h"
#include "transpiler/fleet/specialize.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/reader.h"

namespace plcxx::fleet {
namespace {

/// Four rounds with a call in each, the third of which is left early where an input says so; an element of its own, or
/// none at all, for every lane; and what is in a routine's locals meanwhile.
constexpr const char* kRounds = R"(
space IN 16 volatile little host_visible
space OUT 64 volatile little host_visible
space TABLE 8 volatile little host_visible
space BIG 16 retentive big host_visible
space put 4 routine little own
space period 8 routine little own
place stop bit IN[0].0
place which i8 IN[1]
place value i16 IN[2]
place which_bit i8 IN[4]
place n i32 put[0]
place i i32 period[0]
place rounds i32 OUT[0]
place last i32 OUT[4]
place found i8 OUT[8]
place word i16 OUT[10]
place bit bit OUT[12].3
place slot i8 OUT[16] stride 4 low 16 high 48 indexed
place element i8 TABLE[0] stride 1 low 0 high 6 indexed
place pair i16 BIG[2] stride 2 low 2 high 15 indexed
place flag bit BIG[0].5 stride 1 low 0 high 16 indexed
routine put subroutine (n : i32 = n) "puts" {
  %0 = load n
  %1 = load which
  store slot[%0] %1
  %2 = const i32 2
  %3 = eq.i32 %0 %2
  if %3 {
    store last %0
  }
}
routine period schedule {
  %0 = const i32 0
  store i %0
  loop @1 proven 4 {
    condition {
      %1 = load i
      %2 = const i32 4
      %3 = ult.i32 %1 %2
    }
    body {
      %4 = load i
      call put (%4)
      %5 = load i
      %6 = const i32 2
      %7 = eq.i32 %5 %6
      %8 = load stop
      %9 = and.bit %7 %8
      exit @1 if %9
    }
    step {
      %10 = load i
      %11 = const i32 1
      %12 = add.i32 %10 %11
      store i %12
    }
  }
  %20 = load i
  store rounds %20
  %21 = load which
  %22 = zext.i8.i32 %21
  %23 = load element[%22]
  store found %23
  %24 = load value
  store pair[%22] %24
  %25 = load pair[%22]
  store word %25
  %26 = load which_bit
  %27 = zext.i8.i32 %26
  %28 = load flag[%27]
  %29 = not.bit %28
  store flag[%27] %29
  store bit %29
  store element[%22] %26
}
schedule period period
schedule period_ms 10
)";

uint32_t IndexedIn(const ir::Program& program) {
  uint32_t count = 0;
  for (const ir::Routine& routine : program.routines) {
    ir::ForEachInst(program, routine.body, [&](ir::InstId id) {
      const ir::Inst& inst = program[id];
      const ir::Shape shape = ir::Info(inst.op).shape;
      if (shape != ir::Shape::kLoad && shape != ir::Shape::kStore) return;
      if (program.places[ir::PlaceId(inst.payload)].indexed) ++count;
    });
  }
  return count;
}

TEST(Specialize, LoopsAndCallsWithConstants) {
  const ir::Program program = ir::ReadOrDie(kRounds);
  const ir::Program specialized = Specialize(program);
  EXPECT_EQ(IndexedIn(program), 7u);
  EXPECT_EQ(IndexedIn(specialized), 6u);  // `slot` has places of its own
  EXPECT_EQ(specialized.routines.size(), program.routines.size() + 4);
  EXPECT_FALSE(specialized.routines[ir::RoutineId(0)].body.valid());  // nobody calls it as it was
  bool has_loop = false;
  ir::ForEachInst(specialized, specialized.routines[specialized.schedule.period].body,
                  [&](ir::InstId id) { has_loop = has_loop || specialized[id].op == ir::OpKind::kLoop; });
  EXPECT_FALSE(has_loop);
}

class Elements : public testing::TestWithParam<unsigned> {};

TEST_P(Elements, AreThoseOfEachLane) {
  const ir::Program program = ir::ReadOrDie(kRounds);
  if (GetParam() > WidestFleet()) GTEST_SKIP() << "this processor has no such vectors";
  for (const bool forces : {false, true}) {
    const LibraryOrFailure built = CompileFleet(
        program,
        {.compiler = engines::FindCompiler(), .level = "1", .lanes = GetParam(), .forces = forces, .cache = {}});
    const auto* const library = std::get_if<std::shared_ptr<const Library>>(&built);
    ASSERT_NE(library, nullptr) << std::get<std::string>(built);
    for (const uint64_t seed : {1, 2}) EXPECT_EQ(CompareLanes(*library, seed, 300), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, Elements, testing::Values(64U, 512U));

}  // namespace
}  // namespace plcxx::fleet
