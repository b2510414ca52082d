#include "transpiler/ir/slices.h"

#include <gtest/gtest.h>

#include "transpiler/ir/builder.h"

namespace plcxx::ir {
namespace {

/// A slow part that chooses between arms by a place; the parameter "slice" is one of two places.
struct Sliced {
  Program program;
  RoutineId slow;
  PlaceId slice, other;

  explicit Sliced(bool by_slice, bool falls_through = false) {
    const SpaceId space = program.spaces.Add({.name = "locals", .bytes = 2, .lifetime = Lifetime::kRoutine});
    slice = program.places.Add({.name = "slice", .type = Type::kI8, .space = space, .offset = 0});
    other = program.places.Add({.name = "other", .type = Type::kI8, .space = space, .offset = 1});
    const RegionId body = program.regions.Add({});
    slow = program.routines.Add({.name = "slow",
                                 .kind = RoutineKind::kSlow,
                                 .parameters = {{.name = "slice", .type = Type::kI8, .enumerators = {}}},
                                 .parameter_places = {slice},
                                 .body = body});
    Builder builder(program);
    Switch arms;
    arms.cases.push_back({.values = {2}, .region = program.regions.Add({}), .falls_through = falls_through});
    arms.cases.push_back({.values = {0, 1}, .region = program.regions.Add({})});
    arms.cases.push_back({.values = {}, .region = program.regions.Add({})});
    builder.SetRegion(body);
    const ValueId selector = builder.Load(by_slice ? slice : other);
    builder.SwitchOn(selector, std::move(arms));
  }
};

TEST(Slices, ArmsOfTheChoiceBySliceAscending) {
  const Sliced sliced(true);
  const std::vector<SlicePiece> pieces = SlicePieces(sliced.program, sliced.slow);
  ASSERT_EQ(pieces.size(), 3u);
  for (uint64_t i = 0; i < pieces.size(); ++i) EXPECT_EQ(pieces[i].slice, i);
  EXPECT_EQ(pieces[0].region, pieces[1].region);
  EXPECT_NE(pieces[1].region, pieces[2].region);
}

TEST(Slices, AnotherChoiceIsNone) {
  const Sliced sliced(false);
  EXPECT_TRUE(SlicePieces(sliced.program, sliced.slow).empty());
  EXPECT_TRUE(TakesSlice(sliced.program.routines[sliced.slow]));
}

// What runs on into the next arm is no piece of its own.
TEST(Slices, NoPiecesWhereArmsRunOn) {
  const Sliced sliced(true, true);
  EXPECT_TRUE(SlicePieces(sliced.program, sliced.slow).empty());
}

}  // namespace
}  // namespace plcxx::ir
