// Structure keeps what is executed: random forward jumps, followed as they stand and as the regions they became.

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/passes/passes_testing.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/passes/structure.h"

namespace plcxx::passes {
namespace {

/// The stores executed, in order, when the places have the values of the bits of `inputs`; what is stored is not kept.
struct Follower {
  const ir::Program& program;
  uint32_t inputs;
  std::vector<uint32_t> trace;
  ir::InstId leaving;    // an Exit was taken, to the end of this block
  uint32_t label = ~0u;  // a Jump was taken, to this label
  std::vector<bool> values;

  void Region(ir::RegionId region) {
    for (const ir::InstId id : program.regions[region].insts) {
      const ir::Inst& inst = program[id];
      if (label != ~0u) {
        if (inst.op == ir::OpKind::kLabel && inst.payload == label) label = ~0u;
        continue;
      }
      const bool condition = !ir::ValueId(inst.a).valid() || inst.a >= values.size() || values[inst.a];
      if (inst.op == ir::OpKind::kStore) trace.push_back(id.index);  // passes keep ids
      if (inst.op == ir::OpKind::kLoad) values[id.index] = (inputs >> inst.payload & 1) != 0;
      if (inst.op == ir::OpKind::kBitNot) values[id.index] = !values[inst.a];
      if (inst.op == ir::OpKind::kJump && condition) label = inst.payload;
      if (inst.op == ir::OpKind::kExit && condition) leaving = ir::InstId(inst.payload);
      if (inst.op == ir::OpKind::kIf && condition) Region(ir::RegionId(inst.b));
      if (inst.op == ir::OpKind::kBlock) {
        Region(ir::RegionId(inst.a));
        if (leaving == id) leaving = {};
      }
      if (leaving.valid()) return;
    }
  }
};

std::vector<uint32_t> Trace(const ir::Program& program, uint32_t inputs) {
  Follower follower{.program = program, .inputs = inputs, .values = std::vector<bool>(program.insts.size())};
  follower.Region(program.routines[ir::RoutineId(0)].body);
  EXPECT_EQ(follower.label, ~0u);
  return follower.trace;
}

/// `count` statements; each may jump to a label further down, each label stands before or behind a marker.
std::string RandomBody(std::mt19937& random, uint32_t count) {
  const auto below = [&random](uint32_t n) { return static_cast<uint32_t>(random() % n); };
  std::string body;
  std::vector<bool> wanted(count + 1);
  for (uint32_t i = 0; i < count; ++i) {
    const std::string label = wanted[i] || below(8) == 0 ? "label L" + std::to_string(i) + "\n" : "";
    const std::string marker = "stmt s" + std::to_string(i + 1) + "\n";
    body += below(2) == 0 ? label + marker : marker + label;
    if (below(3) != 0) body += "%9 = load a\nstore b %9\n";
    const uint32_t target = i + 1 + below(count - i);
    const std::string place(1, "abc"[below(3)]);
    const std::string jump = "jump L" + std::to_string(target);
    switch (below(5)) {
      case 0:
        body += jump + "\n";
        break;
      case 1:
        body += "%0 = load " + place + "\n" + jump + " if %0\n";
        break;
      case 2:
        body += "%0 = load " + place + "\n%1 = not.bit %0\n" + jump + " if %1\n";
        break;
      default:
        continue;
    }
    wanted[target] = true;
  }
  return body + "label L" + std::to_string(count) + "\n";
}

TEST(StructureRandom, ExecutesTheSameStatements) {
  std::mt19937 random(4711);
  for (uint32_t round = 0; round < 3000; ++round) {
    const std::string body = RandomBody(random, 1 + round % 14);
    const ir::Program before = ReadFast(body);
    ASSERT_TRUE(ir::Verify(before, ir::Stage::kLowered).empty()) << body;
    ir::Program after = before;
    Structure(after);
    ASSERT_TRUE(ir::Verify(after, ir::Stage::kStructured).empty()) << body << ir::Print(after);
    ir::Program optimized = after;
    Optimize(optimized);
    ASSERT_TRUE(ir::Verify(optimized, ir::Stage::kStructured).empty()) << body << ir::Print(optimized);
    for (uint32_t inputs = 0; inputs < 8; ++inputs) {
      ASSERT_EQ(Trace(before, inputs), Trace(after, inputs)) << body << ir::Print(after);
      ASSERT_EQ(Trace(before, inputs), Trace(optimized, inputs)) << body << ir::Print(optimized);
    }
  }
}

}  // namespace
}  // namespace plcxx::passes
