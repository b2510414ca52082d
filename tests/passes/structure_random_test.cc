// Structure and NestBlocks keep what is executed: random jumps, followed as they stand and as the regions they became.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "tests/passes/random_jumps.h"
#include "transpiler/ir/builder.h"
#include "transpiler/passes/nest_blocks.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/passes/structure.h"

namespace plcxx::passes {
namespace {

/// As they stand, structured, nested and optimized.
void ExpectSameTraces(const std::string& body) {
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

void ExpectSameTraces(uint32_t seed, uint32_t rounds, Ways ways) {
  std::mt19937 random(seed);
  for (uint32_t round = 0; round < rounds; ++round) {
    const uint32_t count = 1 + round % 14;
    const std::string entry = RandomEntry(random, count);
    ExpectSameTraces(entry + RandomBody(random, count, ways));
  }
}

TEST(StructureRandom, ForwardJumpsExecuteTheSameStatements) { ExpectSameTraces(4711, 2000, Ways::kForward); }

TEST(StructureRandom, JumpsBothWaysExecuteTheSameStatements) { ExpectSameTraces(815, 2000, Ways::kBoth); }

/// Loops one in the other; which one goes on is told by what the innermost has stored.
std::string Nest(uint32_t loops) {
  std::string body;
  for (uint32_t i = 0; i < loops; ++i) {
    const std::string number = std::to_string(i);
    body += "label L" + number + "\nstmt s" + number + "\n%0 = load a\nstore b %0\n";
  }
  for (uint32_t i = loops; i-- > 0;) {
    body += "stmt s" + std::to_string(loops + i) + "\n%0 = load c\nstore a %0\njump L" + std::to_string(i) +
            " if %0 budget rounds refused {\n  %7 = load b\n  store a %7\n}\n";
  }
  return body;
}

uint32_t DeepestLoop(const ir::Program& program, ir::RegionId region) {
  uint32_t deepest = 0;
  for (const ir::InstId id : program.regions[region].insts) {
    for (const ir::RegionId owned : ir::OwnedRegions(program, program[id])) {
      deepest = std::max(deepest, DeepestLoop(program, owned) + (program[id].op == ir::OpKind::kLoop ? 1 : 0));
    }
  }
  return deepest;
}

// What a loop in it costs is not paid twice for each one around it, or this does not end.
TEST(StructureRandom, DeepNestsExecuteTheSameStatements) {
  for (const uint32_t loops : {1u, kDeepestLoops - 1, kDeepestLoops, kDeepestLoops + 1, 3 * kDeepestLoops}) {
    ExpectSameTraces(Nest(loops));
    ir::Program program = ReadFast(Nest(loops));
    Structure(program);
    EXPECT_EQ(DeepestLoop(program, program.routines[ir::RoutineId(0)].body), std::min(loops, kDeepestLoops));
  }
}

}  // namespace
}  // namespace plcxx::passes
