// Reading, printing and verifying cost the same per statement at any size (release builds only).

#include <gtest/gtest.h>

#include <ctime>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/printer.h"
#include "transpiler/ir/reader.h"
#include "transpiler/ir/verifier.h"

namespace plcxx::ir {
namespace {

Program Large(uint32_t statements) {
  Program program;
  Builder builder(program);
  const SpaceId space = program.spaces.Add({.name = "m", .bytes = 8});
  std::vector<PlaceId> bits;
  for (uint8_t i = 0; i < 8; ++i) {
    bits.push_back(program.places.Add({.name = std::string(1, static_cast<char>('a' + i)), .space = space, .bit = i}));
  }
  const RegionId body = builder.NewRegion();
  program.routines.Add({.name = "fast", .kind = RoutineKind::kFast, .body = body});
  builder.SetRegion(body);
  for (uint32_t i = 0; i < statements; ++i) {
    builder.Statement(program.statements.Add({.id = i}));
    const ValueId a = builder.Load(bits[i % 8]), b = builder.Load(bits[(i + 1) % 8]),
                  c = builder.Load(bits[(i + 2) % 8]);
    const ValueId both = builder.Pure(OpKind::kBitAnd, {a, b});
    const ValueId either = builder.Pure(OpKind::kBitOr, {both, builder.Pure(OpKind::kBitNot, {c})});
    const RegionId then = builder.NewRegion();
    builder.If(either, then);
    builder.SetRegion(then);
    builder.Store(bits[(i + 3) % 8], both);
    builder.SetRegion(body);
  }
  return program;
}

TEST(Speed, VerifyingIsLinear) {
  const Program program = Large(100000);
  const std::clock_t begin = std::clock();  // of this process: other work on the machine does not count
  EXPECT_TRUE(Verify(program, Stage::kStructured).empty());
  const long ms = (std::clock() - begin) * 1000 / CLOCKS_PER_SEC;
  RecordProperty("ms", static_cast<int>(ms));
#ifdef NDEBUG
  EXPECT_LT(ms, 300);  // some 20 ms on an idle machine
#endif
}

TEST(Speed, LargeTextsComeBack) {
  const std::string text = Print(Large(20000));
  EXPECT_EQ(Print(ReadOrDie(text)), text);
}

}  // namespace
}  // namespace plcxx::ir
