// The tool with C sources: options of C compilers, the order of messages, what of the source is in the output.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view kEntries = "void init() { plc1_time = 16; plc2_time = 32; }\nvoid plc2() { }\n";

std::string Program(std::string_view rest) {
  return "#include \"plc.h\"\n" + std::string(kEntries) + std::string(rest);
}

size_t Count(std::string_view text, std::string_view word) {
  size_t count = 0;
  for (size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

// covers: HNC-052 HNC-356
TEST(HncCommand, DefinesAndUndefines) {
  const Workplace work;
  work.Write("mill.cld", Program("#ifndef __MSDOS__\nint undefined;\n#endif\nvoid plc1() { Y[0] = SPEED; }\n"));
  EXPECT_EQ(work.Run("check mill.cld").code, 1);
  EXPECT_EQ(work.Run("check mill.cld -D SPEED=3").code, 0);
  EXPECT_EQ(work.Run("check mill.cld -D SPEED").code, 0);
  EXPECT_THAT(work.Run("print syntax mill.cld -D SPEED=3 -U __MSDOS__").out, HasSubstr("undefined"));
}

// covers: HNC-047 HNC-356
TEST(HncCommand, IncludeDirectories) {
  const Workplace work;
  ASSERT_TRUE(std::filesystem::create_directory(work.Path("common")));
  work.Write("common/Speeds.h", "#define SPEED 3\n");
  work.Write("mill.cld", Program("#include \"SPEEDS.H\"\nvoid plc1() { Y[0] = SPEED; }\n"));
  EXPECT_THAT(work.Run("check mill.cld").errors, HasSubstr("hnc-E005"));
  EXPECT_EQ(work.Run("check mill.cld -I common").code, 0);
}

// covers: HNC-347
// What follows an #include stands in the block that the header leaves open: that is one mistake, and it is in the
// header.
TEST(HncCommand, AHeaderThatDoesNotCloseItsBlock) {
  const Workplace work;
  work.Write("mill.cld", "#include \"plc.h\"\n#include \"own.h\"\nint a;\n" + std::string(kEntries) +
                             "void plc1() { Y[0] = a; }\n");
  for (const std::string header : {"int b;\nvoid f() { if (b) { b = 1; }\n", "int b;\nstruct s { int c;\n"}) {
    work.Write("own.h", header);
    const Ran ran = work.Run("check mill.cld");
    EXPECT_EQ(ran.code, 1) << ran;
    EXPECT_EQ(Count(ran.errors, "error:"), 1) << ran;
    EXPECT_THAT(ran.errors, AllOf(HasSubstr("own.h:2:"), HasSubstr("the end of 'own.h': '}' expected")));
  }
}

// The line after the one that lacks its ';' is where the syntax breaks; the note is where it belongs.
TEST(HncCommand, AMissingSemicolonIsToldWhereItBelongs) {
  const Workplace work;
  work.Write("mill.cld", "#include \"plc.h\"\n#include \"own.h\"\nint a;\n" + std::string(kEntries) +
                             "void plc1() { Y[0] = a; }\n");
  work.Write("own.h", "int speed\n");
  EXPECT_THAT(work.Run("check mill.cld").errors,
              AllOf(HasSubstr("mill.cld:3:1: error: syntax error at 'int': ';' expected"),
                    HasSubstr("own.h:1:9: note: the ';' is missing behind this")));
}

TEST(HncCommand, WarningsAsErrorsAndSilenced) {
  const Workplace work;
  work.Write("mill.cld", Program("void plc1() { if (X[0] & 1 != 0) Y[0] = 1; }\n"));
  const Ran plain = work.Run("check mill.cld");
  EXPECT_EQ(plain.code, 0) << plain;
  EXPECT_THAT(plain.errors, HasSubstr("hnc-W12"));
  EXPECT_EQ(work.Run("check mill.cld -Werror").code, 1);
  EXPECT_EQ(work.Run("check mill.cld -Werror=W12").code, 1);
  EXPECT_EQ(work.Run("check mill.cld -Werror=W3").code, 0);
  EXPECT_THAT(work.Run("check mill.cld -Wno-W12").errors, Not(HasSubstr("hnc-W12")));
}

// covers: HNC-347
TEST(HncCommand, LostDigitsAreToldWhenAskedFor) {
  const Workplace work;
  work.Write("mill.cld", Program("void plc1() { Y[0] = 300; }\n"));
  EXPECT_THAT(work.Run("check mill.cld").errors, Not(HasSubstr("hnc-W17")));
  EXPECT_THAT(work.Run("check mill.cld -WW17").errors, HasSubstr("hnc-W17"));
}

TEST(HncCommand, OneSourceIsAProgram) {
  const Workplace work;
  work.Write("mill.cld", Program("void plc1() { }\n"));
  work.Write("other.cld", Program("void plc1() { }\n"));
  EXPECT_EQ(work.Run("check mill.cld other.cld").code, 2);
}

// covers: HNC-345
TEST(HncCommand, AllErrorsInTheOrderOfTheirPlaces) {
  const Workplace work;
  work.Write("mill.cld",
             Program("void plc1() { Y[0] = first; }\nvoid f() { f(); }\nint g() { while (X[0]) ; return 1; }\n"
                     "void h() { goto nowhere; }\n"));
  const std::string errors = work.Run("check mill.cld").errors;
  const size_t undeclared = errors.find("mill.cld:4:"), recursion = errors.find("mill.cld:5:"),
               loop = errors.find("mill.cld:6:"), label = errors.find("mill.cld:7:");
  EXPECT_NE(label, std::string::npos) << errors;
  EXPECT_LT(undeclared, recursion) << errors;
  EXPECT_LT(recursion, loop) << errors;
  EXPECT_LT(loop, label) << errors;
}

// covers: HNC-345
TEST(HncCommand, AtMostFiftyErrors) {
  const Workplace work;
  std::string body = "void plc1()\n{\n";
  for (int i = 0; i < 200; ++i) body += "    Y[0] = x" + std::to_string(i) + ";\n";
  work.Write("mill.cld", Program(body + "}\n"));
  const size_t told = Count(work.Run("check mill.cld").errors, "error: ");
  EXPECT_GE(told, 45u);
  EXPECT_LE(told, 52u);
}

// covers: HNC-124 HNC-128
TEST(HncCommand, ScenariosRunWholeBaseCyclesAndValuesWrap) {
  const Workplace work;
  work.Write("mill.cld", Program("void plc1() { Y[0] = X[0]; }\n"));
  const std::string head = "dialect: hnc\nsources: [mill.cld]\noptions: {base-cycle: 5}\nsteps:\n";
  work.Write("good.yaml", head + "- set: {'X[0]': 0x1FE}\n- run: {ms: 10}\n- expect: {'Y[0]': -2, Y0.1: 3}\n");
  work.Write("bad.yaml", head + "- run: {s: 1}\n- run: {ms: 12}\n");
  // Without the limit of memory that Run sets: threads that load Clang need more.
  const auto test = [&work](const std::string& scenario) {
    const std::string command = "cd '" + work.Path("") + "' && timeout 60 " PLCXX_BINARY " test " + scenario;
    return std::system((command + " --engine sim >out.txt 2>&1").c_str());
  };
  EXPECT_EQ(test("good.yaml"), 0) << work.Read("out.txt");
  EXPECT_EQ(WEXITSTATUS(test("bad.yaml")), 2);
  EXPECT_THAT(work.Read("out.txt"), AllOf(HasSubstr("bad.yaml:6:"), HasSubstr("multiple of the base cycle of 5 ms")));
}

// covers: HNC-355 HNC-351
TEST(HncCommand, LinesAreInTheMapOnly) {
  const Workplace work;
  const std::string body = "int a;\nvoid plc1() { a = 1 / X[0]; Y[0] = a; }\n";
  work.Write("mill.cld", Program(body));
  ASSERT_EQ(work.Run("emit mill.cld -o one --quiet --name mill").code, 0);
  work.Write("mill.cld", Program("/* a line\n   more */\n\n" + body));
  ASSERT_EQ(work.Run("emit mill.cld -o two --quiet --name mill").code, 0);
  EXPECT_EQ(work.Read("one/mill.cpp"), work.Read("two/mill.cpp"));
  EXPECT_EQ(work.Read("one/mill.hpp"), work.Read("two/mill.hpp"));
  EXPECT_NE(work.Read("one/mill.map.json"), work.Read("two/mill.map.json"));
}

// covers: HNC-331 HNC-353
TEST(HncCommand, NoPointerToAFunctionAndNoTextOutsideComments) {
  const Workplace work;
  work.Write("mill.cld",
             "#include \"plc.h\"\n#define DOUBLED(x) ((x) + (x))\nint a;\n"
             "void on_m(int ch) { mod_M_code(ch) = -1; }\n"
             "void init() { plc1_time = 16; plc2_time = 32; set_mst_func(0, 'M', on_m); }\n"
             "void plc1() { a = DOUBLED(X[0]); /* */ Y[0] = a; }\nvoid plc2() { }\n");
  ASSERT_EQ(work.Run("emit mill.cld -o out --quiet --name mill").code, 0);
  const std::string code = work.Read("out/mill.cpp");
  EXPECT_THAT(code, AllOf(Not(HasSubstr("(*")), HasSubstr("on_m(m, 0")));
  for (size_t at = code.find("DOUBLED"); at != std::string::npos; at = code.find("DOUBLED", at + 1)) {
    const size_t line = code.rfind('\n', at) + 1;
    EXPECT_NE(code.substr(line, at - line).find("//"), std::string::npos);
  }
}

// covers: HNC-349 HNC-350
TEST(HncCommand, ReportNamesCellsAsTheMacrosDo) {
  const Workplace work;
  work.Write("mill.cld",
             Program("#define mode_sel R[0]\nvoid plc1() { mode_sel = X[0]; if (mode_sel == 1) Y[1] |= 8; }\n"));
  const Ran report = work.Run("report mill.cld --print-symbols");
  EXPECT_EQ(report.code, 0) << report;
  EXPECT_THAT(report.out, HasSubstr("mode_sel"));
  EXPECT_THAT(work.Run("report mill.cld --cross-reference").out, HasSubstr("R[0]  mode_sel"));
}

// covers: HNC-349 HNC-350
TEST(HncCommand, ListsForTheDocumentationOfTheMachine) {
  const Workplace work;
  work.Write(
      "mill.cld",
      "#include \"plc.h\"\n#define feed_limit P[30]\nint scans = 5;\n"
      "void on_m(int ch) {\n    switch (mod_M_code(ch)) { case 3: Y[1] |= 8; break; case 0x1E: Y[1] &= ~8; }\n"
      "    mod_M_code(ch) = -1;\n}\n"
      "void off(void) { Y[1] = 0; *sys_ext_alm() &= ~4; }\n"
      "void init() { plc1_time = 16; plc2_time = 32; set_mst_func(0, 'M', on_m);\n"
      "    if (P[0]) set_mst_func(2, 'T', on_m); }\n"
      "void plc1() {\n    int i;\n    for (i = 0; i < 12; i++) R[i] = X[i];\n"
      "    if (X[0] & 0x81) *sys_ext_alm() |= 0x0204; /* air pressure */\n    if (feed_limit > scans++) off();\n}\n"
      "void plc2() { R_ui[30] = G_ui[163][0] & 0x30; }\n");
  const Ran report = work.Run("report mill.cld --lists -Wno-W20");
  EXPECT_EQ(report.code, 0) << report;
  const auto has_line = [&report](const std::string& pattern) {
    EXPECT_THAT(report.out, ::testing::ContainsRegex(pattern));
  };
  has_line("0 +M +on_m +always +mill.cld:9");
  has_line("2 +T +on_m +at run time +mill.cld:10");
  has_line("3 +2 +mill.cld:14 +air pressure");
  has_line("10 +9 +mill.cld:14 +air pressure");
  has_line("M +3 +on_m +mill.cld:5");
  has_line("M +30 +on_m +mill.cld:5");
  has_line("Y1.2 +off +plc1");
  has_line("Y1.3 +off on_m +plc1");
  has_line("G251.9 +plc1 +plc1");
  has_line("P.30. +feed_limit +plc1");
  has_line("X.0. +0 7 +plc1");
  has_line("G.163. +4 5 +plc2");
  has_line("R_ui.30. +all +plc2 +plc2");
  has_line("scans +int +5 +plc1 +plc1 +plc1");
  has_line("plc1 +plc1 +12 +1");
}

// A switch within a case has cases of its own; a variable that takes the word, or a quotient of it, is followed.
TEST(HncCommand, CodesOfRequestsAreThoseThatTheProgramCompares) {
  const Workplace work;
  work.Write(
      "mill.cld",
      "#include \"plc.h\"\nint step;\n"
      "void on_m(int ch)\n{\n    int m = mod_M_code(ch), other = 0;\n    other = m; other++;\n"
      "    switch (mod_M_code(ch)) {\n    case 6:\n        switch (step) { case 41: step = 0; }\n    case 7: break;\n"
      "    }\n"
      "    if (m == 8 || 9 == m || m != -1)\n        mod_M_code(0) = -1;\n    if (other == 42) step = 43;\n}\n"
      "void on_t(int ch)\n{\n    int t;\n    t = 0;\n    t = (unsigned)mod_T_code(ch) / 10 / 10;\n"
      "    switch (t) { case 2: step = 1; }\n"
      "    if (mod_T_code(ch) / 2000000000 / 2000000000 / 2000000000 == 3) step = 2;\n    mod_T_code(ch) = -1;\n}\n"
      "void init() { plc1_time = plc2_time = 16; set_mst_func(0, 'M', on_m); set_mst_func(0, 'T', on_t); }\n"
      "void plc1() { }\nvoid plc2() { }\n");
  const Ran report = work.Run("report mill.cld --lists");
  EXPECT_EQ(report.code, 0) << report;
  EXPECT_THAT(report.out, HasSubstr("Codes of requests that switches and comparisons name\n"
                                    "  kind  code     function  place\n"
                                    "  M     6        on_m      mill.cld:8\n"
                                    "  M     7        on_m      mill.cld:10\n"
                                    "  M     8        on_m      mill.cld:12\n"
                                    "  M     9        on_m      mill.cld:12\n"
                                    "  T     200-299  on_t      mill.cld:21\n"
                                    "Bits of Y"));
}

// Each of these includes the next one three times: no macro is in them.
TEST(HncCommand, HeadersThatMultiplyAreToldAsHeaders) {
  const Workplace work;
  constexpr int kDepth = 12;
  for (int i = 0; i < kDepth; ++i) {
    const std::string next = "#include \"h" + std::to_string(i + 1) + ".h\"\n";
    work.Write("h" + std::to_string(i) + ".h", next + next + next);
  }
  work.Write("h" + std::to_string(kDepth) + ".h", ";;;;;;;;;;\n");
  work.Write("a.cld", "#include \"h0.h\"\nvoid plc1(void) { }\nvoid plc2(void) { }\n");
  const std::string command = "cd '" + work.Path(".") + "' && " PLCXX_BINARY " check a.cld 2>errors";
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_THAT(work.Read("errors"), HasSubstr("the files have, with their headers, more than 4000000 tokens"));
  // Clang reads on a thread of its own: where memory is over in it, the process was aborted.
  const Ran small = work.Run("check a.cld");
  EXPECT_THAT(small.code, AnyOf(1, 3)) << small;
  EXPECT_THAT(small.errors, AnyOf(HasSubstr("more than 4000000 tokens"), HasSubstr("plcxx: out of memory")));
}

}  // namespace
}  // namespace plcxx::driver
