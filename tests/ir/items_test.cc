#include "transpiler/ir/items.h"

#include <gtest/gtest.h>

#include "transpiler/ir/reader.h"

namespace plcxx::ir {
namespace {

TEST(Items, GoFromMarkerToMarker) {
  const Program program = ReadOrDie(R"(
    space m 1 volatile little
    place a bit m[0].0
    statement s3 closes
    routine fast fast {
      %0 = load a
      stmt s1
      %1 = load a
      store a %1
      stmt s2
      %2 = load a
      if %2 {
        stmt s4
      }
      stmt s3
      stmt s5
    })");
  const std::vector<Item> items = Items(program, program.routines[RoutineId(0)].body);
  ASSERT_EQ(items.size(), 4u);
  EXPECT_FALSE(items[0].statement.valid());
  EXPECT_EQ(items[1].begin, 1u);
  EXPECT_EQ(items[1].end, 4u);
  EXPECT_EQ(program.statements[items[2].statement].id, 2u);
  EXPECT_EQ(items[2].end, 8u);  // the end of the block stays with its head
  EXPECT_EQ(program.statements[items[3].statement].id, 5u);
}

TEST(Items, AnEmptyRegionHasNone) {
  const Program program = ReadOrDie("routine fast fast {\n}\n");
  EXPECT_TRUE(Items(program, program.routines[RoutineId(0)].body).empty());
}

}  // namespace
}  // namespace plcxx::ir
