#include "transpiler/passes/cut_slices.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/passes/passes_testing.h"

namespace plcxx::passes {
namespace {

std::string Cut(std::string_view slices, std::string_view parts, std::vector<uint64_t> weights) {
  ir::Program program = ReadRoutines("routine slow slow (slice : i32 = slice) sliced" + std::string(slices) + " {\n" +
                                     std::string(parts) + "}\n");
  CutSlices(program, ir::RoutineId(0), weights);
  const std::string text = Routines(program);
  return text.substr(text.find('\n') + 1);
}

constexpr std::string_view kParts = R"(  prologue {
    %0 = load a
    store b %0
  }
  body {
    stmt s1
    %0 = load a
    if %0 {
      stmt s2
    }
    stmt s3
    %0 = load b
    store c %0
    stmt s4
  }
  epilogue {
    %0 = load c
    store a %0
  }
}
)";

TEST(CutSlices, OneSliceIsLeftAsItIs) {
  EXPECT_EQ(Cut("", std::string(kParts.substr(0, kParts.size() - 2)), {1, 1, 1}), kParts);
}

TEST(CutSlices, ItemsGoWhereTheWeightsBeforeThemSay) {
  EXPECT_EQ(Cut(" slices 3", std::string(kParts.substr(0, kParts.size() - 2)), {10, 10, 10}), R"(  body {
    %0 = load slice
    switch %0 {
      case 0 {
        %1 = load a
        store b %1
        stmt s1
        %0 = load a
        if %0 {
          stmt s2
        }
      }
      case 1 {
        stmt s3
        %0 = load b
        store c %0
      }
      case 2 {
        stmt s4
      }
    }
  }
  epilogue {
    %0 = load slice
    %1 = const i32 2
    %2 = eq.i32 %0 %1
    if %2 {
      %3 = load c
      store a %3
    }
  }
}
)");
}

/// The slice of each statement s1, s2 ...
std::vector<int> SlicesOf(int slices, const std::vector<uint64_t>& weights) {
  std::string body;
  for (size_t i = 0; i < weights.size(); ++i) body += "stmt s" + std::to_string(i + 1) + "\n";
  const std::string text = Cut(" slices " + std::to_string(slices), body, weights);
  std::vector<int> of(weights.size(), -1);
  int slice = -1;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 5, "case ") == 0) ++slice;
    if (text.compare(i, 6, "stmt s") == 0) of[static_cast<size_t>(std::stoi(text.substr(i + 6))) - 1] = slice;
  }
  return of;
}

TEST(CutSlices, TheRuleOfTheSpecification) {
  EXPECT_EQ(SlicesOf(2, {10, 10, 10, 10}), (std::vector{0, 0, 1, 1}));
  EXPECT_EQ(SlicesOf(2, {1, 1}), (std::vector{0, 1}));
  EXPECT_EQ(SlicesOf(3, {1, 1, 1}), (std::vector{0, 1, 2}));
  EXPECT_EQ(SlicesOf(2, {30, 1, 1}), (std::vector{0, 1, 1}));
  EXPECT_EQ(SlicesOf(2, {1, 1, 30}), (std::vector{0, 0, 0}));
  EXPECT_EQ(SlicesOf(4, {5, 100}), (std::vector{0, 0}));
  EXPECT_EQ(SlicesOf(4, {100, 5}), (std::vector{0, 3}));
  EXPECT_EQ(SlicesOf(3, {0, 0}), (std::vector{0, 0}));
  EXPECT_EQ(SlicesOf(3, {5, 0}), (std::vector{0, 2}));  // weightless behind all others: the last slice, not one more
  EXPECT_EQ(SlicesOf(64, {}), (std::vector<int>{}));
}

}  // namespace
}  // namespace plcxx::passes
