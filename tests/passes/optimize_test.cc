#include <gtest/gtest.h>

#include "tests/passes/passes_testing.h"
#include "transpiler/passes/fold_constants.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/passes/remove_dead.h"
#include "transpiler/passes/splice_constant_ifs.h"

namespace plcxx::passes {
namespace {

template <class Pass>
std::string After(Pass pass, std::string_view body) {
  ir::Program program = ReadFast(body);
  pass(program);
  return Body(program);
}

TEST(FoldConstants, NotOfAConstant) {
  EXPECT_EQ(After(FoldConstants, "%0 = const bit 1\n%1 = not.bit %0\n%2 = not.bit %1\nstore a %2\n"),
            "%0 = const bit 1\n%1 = const bit 0\n%2 = const bit 1\nstore a %2\n");
}

TEST(FoldConstants, AndOr) {
  struct Row {
    std::string_view op, constant, result;
  };
  const Row rows[] = {{"and.bit", "1", "store b %1\n"},
                      {"or.bit", "0", "store b %1\n"},
                      {"and.bit", "0", "%0 = const bit 0\nstore b %0\n"},
                      {"or.bit", "1", "%0 = const bit 1\nstore b %0\n"}};
  for (const Row& row : rows) {
    for (const std::string_view operands : {"%0 %1", "%1 %0"}) {
      const std::string body = "%0 = const bit " + std::string(row.constant) +
                               "\n%1 = load a\n%2 = " + std::string(row.op) + " " + std::string(operands) +
                               "\nstore b %2\n";
      const bool kept = row.result.starts_with("store");
      EXPECT_EQ(After(Optimize, body), kept ? "%0 = load a\nstore b %0\n" : row.result) << body;
    }
  }
}

TEST(FoldConstants, ResultsOfFoldingAreFolded) {
  EXPECT_EQ(
      After(Optimize,
            "%0 = const bit 1\n%1 = load a\n%2 = and.bit %0 %1\n%3 = and.bit %2 %0\n%4 = not.bit %3\nstore b %4\n"),
      "%0 = load a\n%1 = not.bit %0\nstore b %1\n");
}

TEST(FoldConstants, ComparisonsAndBitsOfIntegers) {
  EXPECT_EQ(After(Optimize, "%0 = const i32 4294967294\n%1 = const i32 0\n%2 = ugt.i32 %0 %1\nstore a %2\n"),
            "%0 = const bit 1\nstore a %0\n");
  EXPECT_EQ(After(Optimize, "%0 = const i8 33\n%1 = const i8 31\n%2 = and.i8 %0 %1\nstore w %2\n"),
            "%0 = const i8 1\nstore w %0\n");
  EXPECT_EQ(After(Optimize,
                  "%0 = const i16 65436\n%1 = sext.i16.i32 %0\nstore rounds %1\n%2 = load rounds\n%3 = const "
                  "i32 4294967196\n%4 = eq.i32 %1 %3\nstore a %4\n"),
            "%0 = const bit 1\nstore a %0\n");
}

TEST(FoldConstants, EachOperationOfIntegersOnEachSideOfItsBorders) {
  const std::pair<uint64_t, uint64_t> pairs[] = {{3, 5},           {5, 5},       {5, 3},      {0, 0x7FFF},
                                                 {0xFFFF, 0x7FFF}, {0x80, 0x7F}, {0xFF, 0xFF}};
  for (const auto& [a, b] : pairs) {
    for (const uint32_t width : {8U, 16U, 32U}) {
      if (width == 8 && (a > 0xFF || b > 0xFF)) continue;
      const auto folded = [&, first = a, second = b](const std::string& operation, std::string_view place) {
        const std::string type = "i" + std::to_string(width);
        const std::string body = After(Optimize, "%0 = const " + type + " " + std::to_string(first) + "\n%1 = const " +
                                                     type + " " + std::to_string(second) + "\n%2 = " + operation + "." +
                                                     type + " %0 %1\nstore " + std::string(place) + " %2\n");
        return body.substr(0, body.find('\n'));
      };
      const auto bit = [](bool value) { return std::string("%0 = const bit ") + (value ? "1" : "0"); };
      EXPECT_EQ(folded("eq", "a"), bit(a == b));
      EXPECT_EQ(folded("ne", "a"), bit(a != b));
      EXPECT_EQ(folded("ult", "a"), bit(a < b));
      EXPECT_EQ(folded("ugt", "a"), bit(a > b));
      if (width > 8) {
        EXPECT_EQ(folded("ule", "a"), bit(a <= b));
      }
      if (width > 8) {
        EXPECT_EQ(folded("uge", "a"), bit(a >= b));
      }
      if (width > 8) continue;
      const std::string constant = "%0 = const i8 ";
      EXPECT_EQ(folded("and", "w"), constant + std::to_string(a & b));
      EXPECT_EQ(folded("or", "w"), constant + std::to_string(a | b));
      EXPECT_EQ(folded("xor", "w"), constant + std::to_string(a ^ b));
    }
  }
}

TEST(FoldConstants, BothHalvesOfAValueAreTheValue) {
  EXPECT_EQ(
      After(FoldConstants,
            "%0 = load rounds\n%1 = low_half.i32 %0\n%2 = high_half.i32 %0\n%3 = pair.i32 %1 %2\nstore rounds %3\n"),
      "%0 = load rounds\n%1 = low_half.i32 %0\n%2 = high_half.i32 %0\n%3 = pair.i32 %1 %2\nstore rounds %0\n");
  const std::string swapped =
      "%0 = load rounds\n%1 = low_half.i32 %0\n%2 = high_half.i32 %0\n%3 = pair.i32 %2 %1\nstore rounds %3\n";
  EXPECT_EQ(After(FoldConstants, swapped), swapped);
}

TEST(FoldConstants, WhatHoldsStatementsStays) {
  const std::string body = "stmt s1\n%0 = const bit 0\nif %0 {\n  stmt s2\n  %0 = load a\n  store b %0\n}\n";
  EXPECT_EQ(After(Optimize, body), body);
}

TEST(FoldConstants, InsideOfWhatHoldsStatements) {
  const std::string fold = "%0 = const bit 0\n%1 = load a\n%2 = or.bit %0 %1\nstore b %2\n",
                    folded = "%0 = load a\nstore b %0\n";
  struct Row {
    std::string open, close;
  };
  const Row rows[] = {{"%3 = load c\nif %3 {\n", "}\n"},
                      {"%3 = load c\nif %3 {\n} else {\n", "}\n"},
                      {"block @1 {\n", "}\n"},
                      {"loop @1 guard 5 {\nbody {\n", "}\n}\n"},
                      {"%3 = load w\nswitch %3 {\ncase 1 {\n", "}\n}\n"}};
  const auto plain = [](std::string text) {
    std::erase(text, ' ');
    return text;
  };
  for (const Row& row : rows) {
    const std::string after = plain(After(Optimize, row.open + fold + row.close));
    EXPECT_NE(after.find(plain(folded.substr(folded.find('='))).substr(0, 6)), std::string::npos) << after;
    EXPECT_EQ(after.find("or.bit"), std::string::npos) << after;
  }
}

TEST(FoldConstants, PoisonIsNoConstant) {
  const std::string body = "%0 = poison bit\n%1 = not.bit %0\nstore a %1\n";
  EXPECT_EQ(After(Optimize, body), body);
}

TEST(RemoveDead, ValuesAndWhatOnlyTheyUse) {
  EXPECT_EQ(
      After(RemoveDead, "stmt s1\n%0 = load a\n%1 = load b\n%2 = and.bit %0 %1\nstore c %1\nstmt s2\n%0 = load w\n"),
      "stmt s1\n%0 = load b\nstore c %0\nstmt s2\n");
}

TEST(SpliceConstantIfs, TheArmThatIsExecutedIsLeft) {
  EXPECT_EQ(
      After(Optimize, "%0 = const bit 0\n%1 = load b\nif %0 {\n  store a %0\n} else {\n  store a %1\n}\nstore c %1\n"),
      "%0 = load b\nstore a %0\nstore c %0\n");
  EXPECT_EQ(After(Optimize, "%0 = const bit 1\n%1 = load b\nif %0 {\n  store a %1\n}\n"), "%0 = load b\nstore a %0\n");
  // Also one inside of another one.
  EXPECT_EQ(
      After(Optimize,
            "%0 = const bit 1\n%1 = load b\nif %1 {\n  if %0 {\n    store a %1\n  } else {\n    store a %0\n  }\n}\n"),
      "%0 = load b\nif %0 {\n  store a %0\n}\n");
}

TEST(SpliceConstantIfs, WhatIsNowhereElseStays) {
  const std::string_view arms[] = {"store a %1", "%3 = load a\n  store b %3", "step.on_delay T5 %1 %2 %2"};
  for (const std::string_view arm : arms) {
    const std::string body = "%0 = const bit 0\n%1 = load b\n%2 = const i32 1\nif %0 {\n  " + std::string(arm) +
                             "\n} else {\n  store b %1\n}\n";
    EXPECT_NE(After(SpliceConstantIfs, body).find("else {"), std::string::npos) << arm;
  }
  const std::string statement = "%0 = const bit 1\nif %0 {\n  stmt s7\n  %0 = load c\n  store b %0\n}\n";
  EXPECT_EQ(After(SpliceConstantIfs, statement), statement);
  const std::string jump = "block @1 {\n  %0 = const bit 1\n  if %0 {\n    exit @1\n  }\n  store a %0\n}\n";
  EXPECT_EQ(After(SpliceConstantIfs, jump), jump);
}

TEST(RemoveDead, UsesInNestedRegionsCount) {
  const std::string body = "%0 = load a\n%1 = load b\nif %0 {\n  store c %1\n}\n";
  EXPECT_EQ(After(RemoveDead, body), body);
  EXPECT_EQ(After(RemoveDead, "%0 = load a\n%1 = load b\nif %0 {\n %2 = not.bit %1\n}\n"), "%0 = load a\nif %0 {\n}\n");
}

TEST(RemoveDead, ALoopsConditionIsUsed) {
  const std::string body =
      "loop @1 proven 3 {\n  condition {\n    %0 = load a\n    %1 = not.bit %0\n  }\n  body {\n  }\n}\n";
  EXPECT_EQ(After(RemoveDead, body), body);
}

TEST(RemoveDead, WhatHasAnEffectStays) {
  ir::Program program = ReadRoutines(
      "host now () -> i32\nroutine fast fast {\n  %0 = host now ()\n  %1 = load a\n  step.on_delay T5 %1 %0 %0\n"
      "  %2 = host now ()\n}\n");
  RemoveDead(program);
  EXPECT_EQ(Routines(program),
            "routine fast fast {\n  %0 = host now ()\n  %1 = load a\n  step.on_delay T5 %1 %0 %0\n"
            "  %2 = host now ()\n}\n");
}

TEST(RemoveDead, RemovedInstructionsUseNothingAnyMore) {
  ir::Program program = ReadFast("%0 = load a\n%1 = not.bit %0\nstore b %0\n");
  RemoveDead(program);
  for (const ir::Inst& inst : program.insts) EXPECT_NE(inst.op, ir::OpKind::kBitNot);
}

}  // namespace
}  // namespace plcxx::passes
