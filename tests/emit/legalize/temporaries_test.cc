// Which values get a name of their own, so that no expression is longer than compilers and readers take.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "transpiler/emit/emittable.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::legalize {
namespace {

/// A chain of ANDs over so many bits, stored.
ir::Program Chain(int bits) {
  std::string text =
      "space m 12 volatile little\nplace a bit m[0].0\nplace b bit m[0].1\nroutine fast fast {\n%0 = load a\n";
  for (int i = 1; i < bits; ++i) {
    const std::string load = "%" + std::to_string(2 * i - 1), sum = "%" + std::to_string(2 * i);
    text += load + " = load a\n" + sum + " = and.bit %" + std::to_string(2 * i - 2) + " " + load + "\n";
  }
  return ir::ReadOrDie(text + "store b %" + std::to_string(2 * bits - 2) + "\n}\n");
}

long Locals(const ir::Program& program) {
  const Emittable emittable = Legalize(program, {.name = "p"});
  return std::ranges::count(emittable.forms, Form::kLocal);
}

TEST(Temporaries, AnExpressionIsCutWhereItGrowsTooLong) {
  EXPECT_EQ(Locals(Chain(20)), 0);
  EXPECT_EQ(Locals(Chain(64)), 0) << "127 operations";
  EXPECT_EQ(Locals(Chain(65)), 1) << "129 operations";
  EXPECT_EQ(Locals(Chain(1000)), 15);
}

}  // namespace
}  // namespace plcxx::emit::legalize
