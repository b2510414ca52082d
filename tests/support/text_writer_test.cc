#include "transpiler/support/text_writer.h"

#include <gtest/gtest.h>

namespace plcxx::support {
namespace {

TEST(TextWriter, JoinsPiecesAndIndents) {
  TextWriter writer;
  writer.Line("if (", std::string("io.q7"), ") {");
  {
    const Indented deeper(writer);
    writer.Line("io.q8 = ", std::string_view("true"), ";");
    writer.Line();
  }
  writer.Line("}");
  EXPECT_EQ(writer.text(), "if (io.q7) {\n  io.q8 = true;\n\n}\n");
}

TEST(TextWriter, IndentsEveryLineOfSeveral) {
  TextWriter writer(4);
  writer.Indent();
  writer.Lines("a\n\nb");
  writer.Outdent();
  writer.Write("c");
  EXPECT_EQ(writer.text(), "    a\n\n    b\nc");
}

TEST(TextWriter, EmptyPieceIsAnEmptyLine) {
  TextWriter writer;
  writer.Indent();
  writer.Line("");
  EXPECT_EQ(writer.text(), "\n");
}

TEST(TextWriter, TakeLeavesItEmpty) {
  TextWriter writer;
  writer.Line("a");
  EXPECT_EQ(writer.Take(), "a\n");
  EXPECT_TRUE(writer.empty());
}

TEST(TextWriterDeathTest, MoreOutdentThanIndentIsOurFault) {
  TextWriter writer;
  EXPECT_EXIT(writer.Outdent(), testing::ExitedWithCode(3), "indent_");
}

}  // namespace
}  // namespace plcxx::support
