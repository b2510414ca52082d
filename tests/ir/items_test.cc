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

/// A loop is a part of the statement before it; without a condition it is a jump back to the first one inside.
TEST(StatementOfLoop, IsTheOneBeforeItOrTheFirstInside) {
  const Program program = ReadOrDie(R"(
    space m 1 volatile little
    place a bit m[0].0
    routine fast fast {
      stmt s1
      loop @11 proven 50 {
        condition {
          %0 = load a
        }
        body {
          store a %0
        }
      }
      stmt s2
      %1 = load a
      if %1 {
        stmt s5
        loop @14 proven 9 {
          condition {
            %4 = load a
          }
          body {
            stmt s6
          }
        }
        loop @12 proven 9 {
          body {
            stmt s3
            %2 = load a
            store a %2
            stmt s4
          }
        }
      }
    }
    routine told subroutine {
      loop @13 proven 50 {
        condition {
          %3 = load a
        }
        body {
        }
      }
    })");
  std::vector<StatementId> statements;
  for (uint32_t i = 0; i < program.insts.size(); ++i) {
    if (program[InstId(i)].op == OpKind::kLoop) statements.push_back(StatementOfLoop(program, InstId(i)));
  }
  ASSERT_EQ(statements.size(), 4u);
  EXPECT_EQ(program.statements[statements[0]].id, 1u);
  EXPECT_EQ(program.statements[statements[1]].id, 5u);
  EXPECT_EQ(program.statements[statements[2]].id, 3u);
  EXPECT_FALSE(statements[3].valid());
}

TEST(Items, AnEmptyRegionHasNone) {
  const Program program = ReadOrDie("routine fast fast {\n}\n");
  EXPECT_TRUE(Items(program, program.routines[RoutineId(0)].body).empty());
}

}  // namespace
}  // namespace plcxx::ir
