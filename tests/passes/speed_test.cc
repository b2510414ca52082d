// Passes cost the same per statement at any size (release builds only).

#include <gtest/gtest.h>

#include <ctime>
#include <functional>
#include <vector>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/items.h"
#include "transpiler/passes/cut_slices.h"
#include "transpiler/passes/fold_constants.h"
#include "transpiler/passes/remove_dead.h"
#include "transpiler/passes/structure.h"

namespace plcxx::passes {
namespace {

constexpr uint32_t kStatements = 100000;

/// Every fourth statement jumps over the next two; jumps cross.
ir::Program Large() {
  ir::Program program;
  ir::Builder builder(program);
  const ir::SpaceId space = program.spaces.Add({.name = "m", .bytes = 8});
  std::vector<ir::PlaceId> bits;
  for (uint8_t i = 0; i < 8; ++i) {
    bits.push_back(program.places.Add({.name = std::string(1, static_cast<char>('a' + i)), .space = space, .bit = i}));
  }
  const ir::PlaceId slice = program.places.Add({.name = "slice", .type = ir::Type::kI8, .space = space, .offset = 1});
  builder.SetRegion(builder.NewRegion());
  program.routines.Add({.name = "slow",
                        .kind = ir::RoutineKind::kSlow,
                        .parameters = {{.name = "slice", .type = ir::Type::kI8}},
                        .parameter_places = {slice},
                        .slices = 8,
                        .sliced = true,
                        .body = builder.region()});
  for (uint32_t i = 0; i < kStatements; ++i) {
    builder.Label(i);
    builder.Statement(program.statements.Add({.id = i}));
    const ir::ValueId a = builder.Load(bits[i % 8]), b = builder.Load(bits[(i + 1) % 8]);
    const ir::ValueId one = builder.Bit(1);
    const ir::ValueId both = builder.Pure(ir::OpKind::kBitAnd, {a, one});
    const ir::ValueId either = builder.Pure(ir::OpKind::kBitOr, {both, builder.Pure(ir::OpKind::kBitNot, {b})});
    builder.Store(bits[(i + 3) % 8], either);
    if (i % 4 < 2 && i + 3 < kStatements) builder.Jump(i + 3, either);
  }
  return program;
}

void ExpectFast(const char* what, const std::function<void()>& pass) {
  const std::clock_t begin = std::clock();  // of this process: other work on the machine does not count
  pass();
  const long ms = (std::clock() - begin) * 1000 / CLOCKS_PER_SEC;
  testing::Test::RecordProperty(what, static_cast<int>(ms));
#ifdef NDEBUG
  EXPECT_LT(ms, 300) << what;  // some 10 to 30 ms on an idle machine
#endif
}

TEST(PassesSpeed, EachPassIsLinear) {
  ir::Program program = Large();
  ExpectFast("structure", [&program] { Structure(program); });
  ExpectFast("fold_constants", [&program] { FoldConstants(program); });
  ExpectFast("remove_dead", [&program] { RemoveDead(program); });
  const std::vector<uint64_t> weights(ir::Items(program, program.routines[ir::RoutineId(0)].body).size(), 10);
  ExpectFast("cut_slices", [&program, &weights] { CutSlices(program, ir::RoutineId(0), weights); });
}

}  // namespace
}  // namespace plcxx::passes
