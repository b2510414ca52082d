// The headers that the product supplies against the control's table of signals (specification 5, 9).
// covers: HNC-130 HNC-155..158 HNC-173..175 HNC-178 HNC-360
#include "tests/dialects/hnc_parsing.h"
#include "transpiler/dialects/hnc/machine/headers.h"
#include "transpiler/dialects/hnc/machine/machine.h"

namespace plcxx::hnc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(HncHeader, NamesOfTheSystemHeader) {
  for (const char* name : {"\"plc.h\"", "<PLC.H>", "\"plcs.h\"", "\"HncPlc.h\"", "<hnc.h>"}) {
    Parsed parsed;
    ParseInto(parsed, "#include " + std::string(name) + "\n" + kEntries);
    EXPECT_THAT(parsed.Errors(), IsEmpty()) << name;
  }
  Parsed named;
  ParseInto(named, "#include \"mill.h\"\n" + std::string(kEntries), {{"system-header", "MILL.H"}});
  EXPECT_THAT(named.Errors(), IsEmpty());
}

TEST(HncHeader, OneMissingIncludeIsTakenForIt) {
  Parsed parsed;
  ParseInto(parsed, "#include \"mill.h\"\n" + std::string(kEntries));
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_THAT(parsed.Warnings(), ElementsAre("1:10 W26"));
  Parsed two;
  ParseInto(two, "#include \"mill.h\"\n#include \"lathe.h\"\nint init, plc1, plc2;\n");
  EXPECT_THAT(two.Errors(), testing::Contains("1:10 E005"));
  EXPECT_THAT(two.Errors(), testing::Contains("2:10 E005"));
}

TEST(HncHeader, WithoutItTheNamesAreUndeclared) {
  Parsed parsed;
  ParseInto(parsed, "void init() { }\nvoid plc1() { Y[0] = 1; }\nvoid plc2() { }\n");
  EXPECT_THAT(parsed.Errors(), ElementsAre("2:15 E010"));
}

TEST(HncHeader, ViewsHaveTheirSizes) {
  Parsed parsed;
  ParseInto(parsed, Program("void f() { R_l[0] = P_uc[0] = *F_l[0] + B[0] + X_i[0]; }\n"));
  ASSERT_THAT(parsed.Errors(), IsEmpty());
  const auto count = [&](const char* name) { return parsed.Find(name)->view->count; };
  EXPECT_EQ(count("R_l"), 192U);
  EXPECT_EQ(count("P_uc"), 200U);
  EXPECT_EQ(count("F_l"), 256U);
  EXPECT_EQ(count("B"), 100U);
  EXPECT_EQ(count("X_i"), 64U);
  EXPECT_TRUE(parsed.Find("F_l")->view->table);
}

TEST(HncHeader, ProgramsRepeatIt) {
  EXPECT_THAT(ErrorsOf("extern unsigned char R_uc[]; extern unsigned char R[768]; extern unsigned *F[];\n"
                       "#define axis_stat(x) (F_ui[(x)*10])\nunsigned plc1_time = 16;\n"),
              IsEmpty());
  EXPECT_THAT(ErrorsOf("extern int R[];\n"), ElementsAre("3:12 E012"));
  EXPECT_THAT(ErrorsOf("extern unsigned char R[100];\n"), ElementsAre("3:22 E012"));
  EXPECT_THAT(ErrorsOf("unsigned char R[768];\n"), ElementsAre("3:15 E011"));
}

TEST(HncHeader, AProgramWithItsOwnHeader) {
  Parsed parsed;
  ParseInto(parsed,
            "extern unsigned char Y[]; extern unsigned plc1_time, plc2_time; void set_axis_jog(int a, int v);\n" +
                std::string(kEntries) + "void f() { Y[0] = 1; set_axis_jog(0, 5); }\n");
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_EQ(parsed.Find("Y")->storage, Storage::kSystem);
  const auto jog = std::ranges::find(parsed.unit.functions, "set_axis_jog", &Function::name);
  ASSERT_NE(jog, parsed.unit.functions.end());
  EXPECT_EQ(jog->system, SystemFunction::kSetAxisJog);
}

TEST(HncHeader, StandardHeaders) {
  EXPECT_THAT(
      ErrorsOf("#include <stdlib.h>\n#include <DOS.H>\n#include <stdio.h>\nint a = NULL;\nsize_t n; FILE *f;\n"),
      IsEmpty());
  EXPECT_THAT(ErrorsOf("#include <windows.h>\n"), ElementsAre("3:10 E005"));
  EXPECT_THAT(SystemHeader(AbsMeaning::kInt), HasSubstr("#define axis_stat(x) (F_ui[(x)*10])\n"));
  EXPECT_THAT(SystemHeader(AbsMeaning::kInt), HasSubstr("#define mod_M_code(ch) (*ch_mst_mod(ch,0))\n"));
}

}  // namespace
}  // namespace plcxx::hnc
