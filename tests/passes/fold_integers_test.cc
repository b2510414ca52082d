// What a pass computes of constants is what the simulator computes of them: every operation that it folds.

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "transpiler/ir/reader.h"
#include "transpiler/passes/fold_constants.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::passes {
namespace {

struct FoldedType {
  ir::Type type;
  std::string_view text;
  uint32_t bits;
};
constexpr FoldedType kFoldedTypes[] = {
    {ir::Type::kBit, "bit", 1}, {ir::Type::kI8, "i8", 8}, {ir::Type::kI16, "i16", 16}, {ir::Type::kI32, "i32", 32}};

const FoldedType* RowOf(ir::Type type) {
  for (const FoldedType& row : kFoldedTypes) {
    if (row.type == type) return &row;
  }
  return nullptr;
}

uint64_t FoldedOperand(std::mt19937_64& random, uint32_t bits) {
  const uint64_t limits[] = {0, 1, (uint64_t{1} << bits) - 1, uint64_t{1} << (bits - 1),
                             (uint64_t{1} << (bits - 1)) - 1};
  const uint64_t value = random() % 2 == 0 ? random() : limits[random() % std::size(limits)];
  return value & ((uint64_t{1} << bits) - 1);
}

/// A routine that stores the operation of random constants; empty: of types that have no constants here.
std::string FoldedProgram(const ir::OpInfo& info, std::mt19937_64& random) {
  const FoldedType* result = RowOf(info.result);
  if (info.shape != ir::Shape::kPure || result == nullptr) return "";
  std::string body, operands;
  for (uint8_t i = 0; i < info.operand_count; ++i) {
    const FoldedType* row = RowOf(info.operands[i]);
    if (row == nullptr) return "";
    const std::string name = "%" + std::to_string(i);
    body += name + " = const " + std::string(row->text) + " " + std::to_string(FoldedOperand(random, row->bits)) + "\n";
    operands += " " + name;
  }
  return "space m 8 volatile little\nplace to " + std::string(result->text) +
         (result->bits == 1 ? " m[0].0\n" : " m[0]\n") + "routine period schedule {\n" + body +
         "%9 = " + std::string(info.text) + operands + "\nstore to %9\n}\nschedule period period\n";
}

TEST(FoldIntegers, AsTheSimulatorComputesThem) {
  std::mt19937_64 random(7);
  uint32_t folded = 0;
  for (uint32_t op = 0; op < ir::OpCount(); ++op) {
    const ir::OpInfo& info = ir::Info(static_cast<ir::OpKind>(op));
    for (uint32_t round = 0; round < 60; ++round) {
      const std::string text = FoldedProgram(info, random);
      if (text.empty()) break;
      const ir::Program program = ir::ReadOrDie(text);
      ir::Program after = program;
      FoldConstants(after);
      const ir::RegionId body = after.routines[ir::RoutineId(0)].body;
      const ir::Inst& store = after[after.regions[body].insts.back()];
      const ir::Inst& value = after[ir::ValueId(store.a)];
      if (value.op != ir::OpKind::kConst) break;
      ++folded;
      sim::Simulator simulator(program);
      simulator.PowerOn();
      simulator.RunPeriod(1);
      ASSERT_EQ(ir::ConstantValue(value), simulator.Read(program.places[ir::PlaceId(0)])) << text;
    }
  }
  EXPECT_GE(folded, 34u * 60u);
}

}  // namespace
}  // namespace plcxx::passes
