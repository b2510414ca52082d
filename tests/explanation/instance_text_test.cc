// What is said of an instance after its name is a sentence, whatever kind it is.
#include "transpiler/explanation/instance_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "transpiler/ir/op.h"

namespace plcxx::explanation {
namespace {

using ::testing::AnyOf;
using ::testing::StartsWith;

TEST(InstancePredicate, BeginsWithAVerbInEachKind) {
  for (uint8_t kind = 0; kind <= static_cast<uint8_t>(ir::StateKind::kAxisRequest); ++kind) {
    ir::Program program;
    const ir::StateId state = program.states.Add({.kind = static_cast<ir::StateKind>(kind), .name = "it"});
    const sim::Instances instances(program);
    const std::string text = InstancePredicate(program, state, instances);
    SCOPED_TRACE(std::string(ir::Info(program.states[state].kind).text) + ": it " + text);
    EXPECT_THAT(text, AnyOf(StartsWith("is "), StartsWith("has "), StartsWith("had ")));
    EXPECT_EQ(text.find(" was"), std::string::npos);
    EXPECT_NE(text.back(), ' ');
  }
}

// A counter of host50 counts from a negative preset, or down to one; a timer's milliseconds have no sign.
TEST(InstanceText, ACounterBelowZeroHasASign) {
  ir::Program program;
  const ir::StateId state = program.states.Add({.kind = ir::StateKind::kPositionCounter, .name = "C1"});
  sim::Instances instances(program);
  instances.Write(state.index, ir::FieldIndex(ir::StateKind::kPositionCounter, "preset"), static_cast<uint32_t>(-2));
  EXPECT_EQ(InstanceText(program, state, instances), "value 0, preset -2, output 0");
  EXPECT_EQ(FieldDigits(ir::StateKind::kPositionCounter, ir::Type::kBit, 1), "1");
  EXPECT_EQ(FieldDigits(ir::StateKind::kOnDelayTimer, ir::Type::kI32, 0xFFFFFFFE), "4294967294");
}

}  // namespace
}  // namespace plcxx::explanation
