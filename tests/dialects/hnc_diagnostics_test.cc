// What the front end refuses, where it says so, and what it does not say twice (specification 10.2).
// covers: HNC-345 HNC-346 HNC-348
#include <algorithm>

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

// Clang takes the sum of an integer and an address for one.
TEST(HncDiagnostics, AnAddressIsAddedToNoNumber) {
  for (const char* address : {"p", "&b", "t", "b ? &b : t", "(b, p)", "f()", "\"ab\"", "b ? p : 0"}) {
    for (const char* target : {"a", "c", "l", "t[1]"}) {
      for (const char* sign : {"+=", "-=", "*="}) {
        EXPECT_THAT(ErrorsOf("int a, b, t[4], *p; unsigned char c; long l;\nint *f() { return p; }\nvoid g() {\n" +
                             std::string(target) + ' ' + sign + ' ' + address + "; }\n"),
                    ElementsAre(testing::AllOf(testing::StartsWith("6:"), testing::EndsWith(" E019"))))
            << target << sign << address;
      }
    }
  }
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

/// What the help of E054 says, done.
TEST(HncDiagnostics, ExtensionsHaveRemediesThatCompile) {
  struct Case {
    const char *wrong, *remedy, *right;
  };
  for (const Case& c : std::initializer_list<Case>{
           {"_Bool b;", "write unsigned char", "unsigned char b;"},
           {"long long l;", "write long,", "long l;"},
           {"__int64 l;", "write long,", "long l;"},
           {"long l = 5LL;", "write 5L,", "long l = 5L;"},
           {"unsigned long l = 0x5uLL;", "write 0x5UL,", "unsigned long l = 0x5UL;"},
           {"int a = 0b11;", "write 0x03", "int a = 0x03;"},
           {"unsigned a = 0B1000000000u;", "write 0x0200u", "unsigned a = 0x0200u;"},
           {"int a = 0b12;", "write the number in hexadecimal", "int a = 0x05;"},
           {"int a = 0x1p3;", "with decimal digits", "int a = 8;"},
           {"int a = L'x';", "without the letter", "int a = 'x';"},
           {"int a[0];", "a size of at least 1", "int a[1];"},
           {"void f(n) int n; { int a[n]; a[0] = 1; }", "a constant size", "void f(n) int n; { int a[8]; a[0] = n; }"},
           {"struct s { };", "a member", "struct s { int a; };"},
           {"struct s { struct { int b; }; };", "a name between its '}'", "struct s { struct { int b; } m; };"},
           {"int a[3] = { [1] = 2 };", "without names, and 0", "int a[3] = { 0, 2 };"},
           {"int a[3] = { };", "write {0}", "int a[3] = {0};"},
           {"void f() { ; { int a; a = 1; int b; } }", "the beginning of its block",
            "void f() { ; { int b; int a; a = 1; } }"},
           {"void f() { for (int i = 0; i < 2; i++) ; }", "the beginning of the block",
            "void f() { int i; for (i = 0; i < 2; i++) ; }"},
           {"void f() { switch (R[0]) { case 1 ... 2: ; } }", "a case for each value",
            "void f() { switch (R[0]) { case 1: case 2: ; } }"},
           {"void f() { R[0] = R[1] ?: 2; }", "between '?' and ':'", "void f() { R[0] = R[1] ? R[1] : 2; }"},
           {"void f() { R[0] = ({ R[1]; }); }", "in front of this one", "void f() { R[1]; R[0] = R[1]; }"},
           {"char *t = __func__;", "in quotation marks", "char *t = \"t\";"},
           {"__typeof__(int) a;", "write the type itself", "int a;"},
           {"int a __attribute__((unused));", "delete it", "int a;"},
           {"_Static_assert(1, \"\");", "#if and #error", "#if 0\n#error\n#endif"},
           {"int a = __alignof__(int);", "write 1", "int a = 1;"},
           {"#define m(a, ...) a\nint b = m(1, 2);", "a fixed number of parameters",
            "#define m(a, c) a\nint b = m(1, 2);"},
       }) {
    Parsed wrong;
    ParseInto(wrong, Program(c.wrong + std::string("\n")));
    wrong.diagnostics.SortBySource();
    const auto first =
        std::ranges::find(wrong.diagnostics.all(), diag::Severity::kError, [](const auto& d) { return d.severity; });
    ASSERT_NE(first, wrong.diagnostics.all().end()) << c.wrong;
    EXPECT_EQ(first->row->code, "hnc-E054") << c.wrong;
    EXPECT_THAT(first->remedy, HasSubstr(c.remedy)) << c.wrong;
    Parsed right;
    ParseInto(right, Program(c.right + std::string("\n")));
    EXPECT_THAT(right.Errors(), IsEmpty()) << c.right;
  }
}

/// The texts that #line makes are not longer than the program but for the lines up to it, and these are limited.
TEST(HncDiagnostics, LineDirectivesDoNotGrow) {
  constexpr size_t kMany = 3000;
  Parsed parsed;
  std::string text;
  for (size_t i = 0; i < kMany; ++i) text += "#line 32767 \"a.h\"\n\n";
  ParseInto(parsed, Program(text + "int a = nowhere;\n"));
  size_t bytes = 0;
  for (uint32_t i = 0; i < parsed.sources.size(); ++i) bytes += parsed.sources.Get(source::FileId(i)).text.size();
  EXPECT_LT(bytes, 2'000'000);
  EXPECT_THAT(parsed.Errors(), testing::SizeIs(1));
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
  std::string statements;
  for (int i = 0; i < 2000; ++i) statements += "nosuch" + std::to_string(i) + " = 1;\n";
  EXPECT_THAT(ErrorsOf("void f() {\n" + statements + "}\nvoid g() { }\n"), testing::SizeIs(1000));
}

// One declaration is missing, however often its name is used; another function misses its own.
TEST(HncDiagnostics, ANameThatIsNotDeclaredIsOneErrorInAFunction) {
  EXPECT_THAT(ErrorsOf("void f() {\n" + Repeated("nosuch = nosuch + 1;\n", 5) + "}\nvoid g() { nosuch = 1; }\n"),
              ElementsAre("4:1 E010", "10:12 E010"));
  EXPECT_THAT(ErrorsOf("void f() {\nR[0] = ; R[1] = nosuch;\nR[2] = nosuch;\n}\n"),
              ElementsAre("4:8 E001", "5:8 E010"));
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
