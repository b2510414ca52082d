// Structure and NestBlocks keep what is executed: random jumps, followed as they stand and as the regions they became.

#include <gtest/gtest.h>

#include <random>

#include "tests/passes/random_jumps.h"
#include "transpiler/passes/nest_blocks.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/passes/structure.h"

namespace plcxx::passes {
namespace {

void ExpectSameTraces(uint32_t seed, uint32_t rounds, Ways ways) {
  std::mt19937 random(seed);
  for (uint32_t round = 0; round < rounds; ++round) {
    const uint32_t count = 1 + round % 14;
    const std::string entry = RandomEntry(random, count), body = entry + RandomBody(random, count, ways);
    const ir::Program before = ReadFast(body);
    ASSERT_TRUE(ir::Verify(before, ir::Stage::kLowered).empty()) << body << ir::Verify(before, ir::Stage::kLowered)[0];
    ir::Program after = before;
    Structure(after);
    ASSERT_TRUE(ir::Verify(after, ir::Stage::kStructured).empty())
        << body << ir::Print(after) << ir::Verify(after, ir::Stage::kStructured)[0];
    ir::Program nested = after;
    NestBlocks(nested);
    ASSERT_TRUE(ir::Verify(nested, ir::Stage::kStructured).empty())
        << body << ir::Print(nested) << ir::Verify(nested, ir::Stage::kStructured)[0];
    ir::Program optimized = nested;
    Optimize(optimized);
    ASSERT_TRUE(ir::Verify(optimized, ir::Stage::kStructured).empty()) << body << ir::Print(optimized);
    for (uint32_t inputs = 0; inputs < 12; ++inputs) {
      ASSERT_EQ(Trace(before, inputs), Trace(after, inputs)) << body << ir::Print(after);
      ASSERT_EQ(Trace(before, inputs), Trace(nested, inputs)) << body << ir::Print(after) << ir::Print(nested);
      ASSERT_EQ(Trace(before, inputs), Trace(optimized, inputs)) << body << ir::Print(optimized);
    }
  }
}

TEST(StructureRandom, ForwardJumpsExecuteTheSameStatements) { ExpectSameTraces(4711, 2000, Ways::kForward); }

TEST(StructureRandom, JumpsBothWaysExecuteTheSameStatements) { ExpectSameTraces(815, 2000, Ways::kBoth); }

}  // namespace
}  // namespace plcxx::passes
