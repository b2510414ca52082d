// Values by bit of a program's memory: kept apart, at first Value(), and only what was asked for is gone through.
#include <gtest/gtest.h>

#include "transpiler/checks/accesses.h"

namespace plcxx::checks {
namespace {

TEST(ByBit, KeepsEachBitsValueAndGoesThroughFewOthers) {
  ir::Program program;
  ir::Space& space = program.spaces[program.spaces.Add({})];
  space.bytes = 32768;
  const BitNumbering numbering(program);
  ByBit<uint32_t> values(numbering);
  const uint32_t last = numbering.count() - 1;
  values[0] = 3;
  values[last] = 5;
  EXPECT_EQ(values[0], 3U);
  EXPECT_EQ(values[1], 0U);
  EXPECT_EQ(values[last], 5U);
  uint32_t sum = 0, visited = 0;
  values.ForTouched([&](uint32_t& value) {
    sum += value;
    ++visited;
    value = 0;
  });
  EXPECT_EQ(sum, 8U);
  EXPECT_LE(visited, 128U);
  EXPECT_EQ(values[0] + values[last], 0U);
}

}  // namespace
}  // namespace plcxx::checks
