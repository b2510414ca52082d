// plcxx diff: memory that lives on without power. The host has a copy of it, or none, and init makes something of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/temporary_directory.h"
#include "transpiler/review/diff/diff.h"

namespace plcxx::review::diff {
namespace {

/// With a technology table, of which one item is given.
Diff CompareTexts(const std::string& old_text, const std::string& new_text, const std::string& old_item = "100",
                  const std::string& new_item = "100") {
  const testing_support::TemporaryDirectory old_directory, new_directory;
  const auto side = [&](const testing_support::TemporaryDirectory& directory, const std::string& text,
                        const std::string& item) {
    compilation::CompilationRequest request;
    request.sources = {directory.Write("program.plc", text),
                       directory.Write("TAB.TCH", "$TCH 1 2 1\n0: 1 " + item + "\n")};
    request.dialect = "technol";
    return MakeDiffSide("side", request);
  };
  DiffSide old_side = side(old_directory, old_text, old_item), new_side = side(new_directory, new_text, new_item);
  EXPECT_TRUE(old_side.compilation.ok());
  EXPECT_TRUE(new_side.compilation.ok());
  Diff diff =
      CompareSides(old_side, new_side, {.same = {}, .time_ms = 20'000, .scenario_directory = {}, .progress = {}});
  EXPECT_EQ(diff.refusal, "");
  return diff;
}

bool IsListed(const Diff& diff, const std::string& name) {
  return std::ranges::any_of(diff.items, [&name](const DiffItem& item) { return item.name == name; });
}

/// `written` goes into retentive memory, and from there into WORK when power comes back.
std::string WithInit(const std::string& written) {
  return R"(CMOS_MEM  STRUC
COUNT     DW ?
OTHER     DW ?
CMOS_MEM  ENDS
          DATA
WORK:     DS 2
          DATA_END
          MODULE_INIT
          LOD  LABEL_MEM.COUNT
          STO  WORK
          MODULE_INIT_END
          MODULE_MAIN
          LOD  )" +
         written + R"(
          STO  LABEL_MEM.COUNT
          LOD  IN1
          STO  LABEL_MEM.OTHER
          LOD  WORK
          STO  OUT1
          LOD  LABEL_MEM.OTHER
          STO  OUT2
          MODULE_MAIN_END
          STOP
)";
}

TEST(Retentive, WhatInitMakesOfItDiffersWithIt) {
  // WORK is 0 in both versions until the power has failed once.
  const Diff diff = CompareTexts(WithInit("CNST.1"), WithInit("CNST.2"));
  EXPECT_TRUE(IsListed(diff, "WORK"));
  EXPECT_TRUE(IsListed(diff, "OUT1"));
  EXPECT_FALSE(IsListed(diff, "OUT2"));
  EXPECT_TRUE(CompareTexts(WithInit("CNST.1"), WithInit("CNST.2-1")).items.empty());
}

TEST(Retentive, WhatItStartsWithCountsWhereTheHostHasNoCopy) {
  const std::string reader = R"(          DATA
          DATA_END
          MODULE_MAIN
          LOD  BYTE.TAB_TECHNOL.TCH_DATA+5
          STO  OUT1
          LOD  IN2
          STO  OUT2
          MODULE_MAIN_END
          STOP
)";
  const Diff diff = CompareTexts(reader, reader, "100", "101");
  EXPECT_FALSE(diff.items.empty());
  EXPECT_FALSE(IsListed(diff, "OUT2"));
  EXPECT_TRUE(CompareTexts(reader, reader, "100", "100.0").items.empty());
}

}  // namespace
}  // namespace plcxx::review::diff
