// What the front end refuses, where it says so, and what it does not say twice (specification 10.2).
// covers: HNC-345 HNC-346 HNC-348
#include "tests/dialects/hnc_parsing.h"

namespace plcxx::hnc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(HncDiagnostics, SyntaxAtTheOffendingToken) {
  EXPECT_THAT(ErrorsOf("void f() { int a\na = 1; }\n"), ElementsAre("4:1 E001"));
  EXPECT_THAT(ErrorsOf("void f();\n{\n}\n"), ElementsAre("4:1 E001"));
  EXPECT_THAT(ErrorsOf("void f() { Y[2] | = 0x80; }\n"), ElementsAre("3:19 E001"));
}

TEST(HncDiagnostics, ErrorsOfOtherFunctionsAreFound) {
  EXPECT_THAT(ErrorsOf("void f() { a = 1; }\nvoid g() { b = 1; }\n"), ElementsAre("3:12 E010", "4:12 E010"));
}

TEST(HncDiagnostics, AtTheUseOfAMacro) {
  EXPECT_THAT(ErrorsOf("#define SET (nowhere = 1)\nvoid f() {\nSET; }\n"), ElementsAre("5:1 E010"));
}

TEST(HncDiagnostics, AddressesAndTables) {
  EXPECT_THAT(ErrorsOf("void f() { ch_feedover(0) = 100; }\n"), ElementsAre("3:12 E020"));
  EXPECT_THAT(ErrorsOf("void f() { if (axis_stat(0) & 1) ; }\n"), ElementsAre("3:29 E019"));
  EXPECT_THAT(ErrorsOf("int *p = (int *)0x400;\n"), ElementsAre("3:10 E048"));
  EXPECT_THAT(ErrorsOf("void f() { X = 1; }\n"), ElementsAre("3:14 E021"));
}

TEST(HncDiagnostics, Declarations) {
  EXPECT_THAT(ErrorsOf("void (*p)(void);\n"), ElementsAre("3:8 E045"));
  EXPECT_THAT(ErrorsOf("struct s { char *p; } a;\n"), ElementsAre("3:18 E050"));
  EXPECT_THAT(ErrorsOf("char **p;\n"), ElementsAre("3:8 E050"));
  EXPECT_THAT(ErrorsOf("char *const t[] = { \"a\", \"b\" };\n"), IsEmpty());
  EXPECT_THAT(ErrorsOf("int f(int a, ...) { return a; }\n"), ElementsAre("3:14 E041"));
  EXPECT_THAT(ErrorsOf("long double d;\n"), ElementsAre("3:1 E055"));
}

TEST(HncDiagnostics, Extensions) {
  for (const char* text :
       {"_Bool b;", "long long l;", "int a[0];", "struct s { };", "int a = 0b11;", "int a[2] = { [1] = 2 };",
        "void f() { ; { int a; a = 1; int b; } }", "void f() { for (int i = 0; i < 2; i++) ; }", "__typeof__(int) a;",
        "void f() { switch (R[0]) { case 1 ... 3: ; } }"}) {
    Parsed parsed;
    ParseInto(parsed, Program(text + std::string("\n")));
    ASSERT_THAT(parsed.Errors(), testing::SizeIs(1)) << text;
    EXPECT_THAT(parsed.FirstText(), testing::StartsWith("extension")) << text;
  }
}

TEST(HncDiagnostics, CallsOfWhatIsNotThere) {
  EXPECT_THAT(ErrorsOf("void f() { printf(\"a\"); }\n"), ElementsAre("3:12 E036"));
  EXPECT_THAT(ErrorsOf("void f() { g(); g(); }\n"), ElementsAre("3:12 E016"));
  EXPECT_THAT(ErrorsOf("int puts(int a) { return a; }\nvoid f() { puts(1); }\n"), IsEmpty());
  EXPECT_THAT(ErrorsOf("void f(a) int a; { }\nvoid g() { f(); f(1L); }\n"), ElementsAre("4:12 E017", "4:19 E017"));
}

TEST(HncDiagnostics, NoWordsOfTheParserBeneath) {
  Parsed parsed;
  ParseInto(parsed, Program("void f() { int a[2]; a = 3; R.x = 1; f(2).y; *R[1]; &5; (struct z)a; goto l; }\n"));
  for (const diag::Diagnostic& diagnostic : parsed.diagnostics.all()) {
    EXPECT_THAT(diagnostic.text, Not(HasSubstr("__plcxx"))) << diagnostic.text;
    EXPECT_THAT(diagnostic.text, Not(HasSubstr("%"))) << diagnostic.text;
  }
}

TEST(HncDiagnostics, NothingIsTooDeep) {
  EXPECT_THAT(ErrorsOf("int a = " + std::string(1000, '(') + "1" + std::string(1000, ')') + ";\n"),
              ElementsAre("3:136 E001"));
  EXPECT_THAT(ErrorsOf("int a = " + std::string(10000, '~') + "1;\n"), ElementsAre("3:136 E001"));
  std::string sum = "long a = 1";
  for (int i = 0; i < 5000; ++i) sum += " + 1";
  EXPECT_THAT(ErrorsOf(sum + ";\n"), IsEmpty());
}

std::string Repeated(const std::string& line, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += line;
  return text;
}

TEST(HncDiagnostics, AfterAThousandErrorsNothingIsRead) {
  EXPECT_THAT(ErrorsOf(Repeated("int v = 1;\n", 2000)), testing::SizeIs(1000));
  EXPECT_THAT(ErrorsOf("void f() {\n" + Repeated("nosuch = 1;\n", 2000) + "}\nvoid g() { }\n"), testing::SizeIs(1000));
}

TEST(HncDiagnostics, ANameIsDeclaredAThousandTimes) {
  for (const char* line : {"int v;\n", "extern int v;\n", "void v(void);\n", "struct v;\n"}) {
    EXPECT_THAT(ErrorsOf(Repeated(line, 1000)), IsEmpty()) << line;
    EXPECT_THAT(ErrorsOf(Repeated(line, 1001) + "int w = nosuch;\n"), testing::SizeIs(1)) << line;
  }
  EXPECT_THAT(ErrorsOf(Repeated("int v;\n", 2000)), ElementsAre("1003:5 E011"));
  EXPECT_THAT(ErrorsOf(Repeated("void v() { }\n", 2000)), ElementsAre("4:6 E011", "1003:6 E011"));
}

}  // namespace
}  // namespace plcxx::hnc
