// Who may include whom: layers.txt against the sources, and against the drawing in CONTRIBUTING.md.
#include "tests/policy/layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace plcxx::policy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

LayerTable Table() {
  Findings findings;
  LayerTable table = ReadLayers(ReadFile(Root() + "/tests/policy/layers.txt"), findings);
  EXPECT_THAT(findings, IsEmpty());
  EXPECT_FALSE(table.layers.empty());
  return table;
}

TEST(Layers, SourcesKeepThem) { EXPECT_THAT(CheckLayers(Table(), Root()), IsEmpty()); }

TEST(Layers, FixtureBreaksThem) {
  EXPECT_THAT(
      CheckLayers(Table(), Fixture("layers")),
      ElementsAre(
          HasSubstr("transpiler/dialects/host50/cellar/barrel.cc: layers.txt has no such room"),
          HasSubstr("transpiler/dialects/host50/lowering/lowering.cc:2: may not include \"transpiler/dialects/nc110"),
          HasSubstr("machine/machine.cc:2: may not include \"transpiler/dialects/host50/host50.h\""),
          HasSubstr("machine/machine.cc:3: may not include \"transpiler/dialects/host50/lowering/lowering.h\""),
          HasSubstr("machine/machine.cc:4: may not include \"transpiler/dialects/host50/source/tokens.h\""),
          HasSubstr("machine/signals.cc:3: may not include \"transpiler/dialects/host50/parser/parser.h\""),
          HasSubstr("transpiler/emit/print/cpp_routines.cc:2: may not include \"transpiler/emit/legalize/names.h\""),
          HasSubstr("transpiler/ir/program.cc:2: may not include \"transpiler/emit/legalize/names.h\""),
          HasSubstr("transpiler/ir/program.cc:3: <gtest/gtest.h> of GoogleTest is not for this folder"),
          HasSubstr("transpiler/ir/program.cc:4: <clang/AST/Decl.h> of Clang is not for this folder"),
          HasSubstr("transpiler/ir/program.cc:5: <windows.h> belongs to no library"),
          HasSubstr("transpiler/ir/program.cc:6: may not include \"runtime_support/plcxx/bits.h\""),
          HasSubstr("transpiler/odds/ends.cc: its folder has no row"),
          HasSubstr("runtime_support/plcxx/bits.h:2: <cstdint> belongs to no library"),
          HasSubstr("runtime_support/plcxx/bits.h:3: may not include \"transpiler/ir/types.h\""),
          HasSubstr("transpiler/ir/CMakeLists.txt:1: may not depend on transpiler/diagnostics")));
}

TEST(Layers, TableNamesFoldersThatHaveRows) {
  Findings findings;
  ReadLayers("transpiler/a: transpiler/b\nnot a row\n", findings);
  EXPECT_THAT(findings, ElementsAre(HasSubstr("layers.txt:2: cannot be read"), HasSubstr("transpiler/b")));
  findings.clear();
  ReadLayers("a: b\nb: c\nc: a\n", findings);
  EXPECT_THAT(findings, ElementsAre(HasSubstr("in a circle")));
}

// With PLCXX_UPDATE_GOLDEN set the drawing is written instead of compared.
TEST(Layers, DrawingIsTheTable) {
  const std::string path = Root() + "/CONTRIBUTING.md";
  const std::string text = ReadFile(path);
  const std::string begin = "<!-- layers: drawn by tests/policy -->\n```text\n";
  const size_t at = text.find(begin);
  ASSERT_NE(at, std::string::npos) << "CONTRIBUTING.md has no drawing of the layers";
  const size_t start = at + begin.size();
  const size_t end = text.find("```\n", start);
  ASSERT_NE(end, std::string::npos);
  const std::string drawing = DrawLayers(Table(), Root());
  if (std::getenv("PLCXX_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(path, std::ios::binary) << text.substr(0, start) << drawing << text.substr(end);
    return;
  }
  EXPECT_EQ(text.substr(start, end - start), drawing) << "PLCXX_UPDATE_GOLDEN=1 writes it anew";

  Findings ignored;
  EXPECT_NE(DrawLayers(ReadLayers("transpiler/ir:\n", ignored), Root()), drawing);
}

}  // namespace
}  // namespace plcxx::policy
