// The tree of correct programs: types, layouts, constants, conversions, statements (specification 2.4, 2.5, 3, 5.6, 6).
// covers: HNC-016..018 HNC-021..027 HNC-029 HNC-072 HNC-073 HNC-075 HNC-180 HNC-220 HNC-274 HNC-258
#include "tests/dialects/hnc_parsing.h"
#include "transpiler/dialects/hnc/source/recognize.h"

namespace plcxx::hnc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(HncParser, TypesOfConstants) {
  EXPECT_EQ(ValueOf("sizeof(32767)"), 2);
  EXPECT_EQ(ValueOf("sizeof(32768)"), 4);
  EXPECT_EQ(ValueOf("0x8000 + 0x8000"), 0) << "unsigned int";
  EXPECT_EQ(ValueOf("-32768"), -32768);
  EXPECT_EQ(ValueOf("0x80000000 >> 31"), 1) << "unsigned long";
  EXPECT_EQ(ValueOf("sizeof(1ul) + sizeof(1Lu) + sizeof(1u)"), 10);
  EXPECT_EQ(ValueOf("0X7e + 017"), 141);
}

TEST(HncParser, CharacterConstants) {
  EXPECT_EQ(ValueOf("'\\xff'"), -1);
  EXPECT_EQ(ValueOf("'AB'"), 0x4241);
  EXPECT_EQ(ValueOf("'\\n'"), 10);
  EXPECT_EQ(ValueOf("sizeof('a')"), 2);
}

TEST(HncParser, FoldingHasTheWidthsOfTheLanguage) {
  EXPECT_EQ(ValueOf("30000 + 30000"), -5536);
  EXPECT_EQ(ValueOf("1 << 15"), -32768);
  EXPECT_EQ(ValueOf("1 << 20"), 0);
  EXPECT_EQ(ValueOf("-1 >> 20"), -1);
  EXPECT_EQ(ValueOf("1 << 33"), 2) << "modulo 32 in 16-bit operations";
  EXPECT_EQ(ValueOf("1L << 32"), 0);
  EXPECT_EQ(ValueOf("-1 < 1u"), 0);
  EXPECT_EQ(ValueOf("~(unsigned char)0"), -1);
  EXPECT_EQ(ValueOf("(long)300 * 300"), 90000);
  EXPECT_EQ(ValueOf("-7 / 2 * 10 + -7 % 2"), -31);
  EXPECT_EQ(ValueOf("300", "unsigned char"), 44);
  EXPECT_EQ(ValueOf("3.9"), 3);
}

TEST(HncParser, Layouts) {
  Parsed parsed;
  ParseInto(parsed,
            Program("struct s { char c; long l; unsigned a : 3, b : 14; unsigned char d : 5; int : 0; int e : 2; "
                    "double f; } v;\nunion u { char c; long l; } w;\nenum e { A = -2, B2, C } x;\n"));
  ASSERT_THAT(parsed.Errors(), IsEmpty());
  const Record& record = parsed.unit.records[parsed.unit.types[parsed.Find("v")->type].record];
  std::vector<std::string> places;
  for (const Member& member : record.members) {
    places.push_back(member.name + std::to_string(member.offset) +
                     (member.is_bit_field ? "." + std::to_string(member.bit_offset) : ""));
  }
  EXPECT_THAT(places, ElementsAre("c0", "l1", "a5.0", "b7.0", "d9.0", testing::_, "e10.0", "f12"));
  EXPECT_EQ(record.size, 20U);
  EXPECT_EQ(parsed.unit.types[parsed.Find("w")->type].size, 4U);
  EXPECT_TRUE(parsed.unit.types[parsed.Find("x")->type].is_signed);
}

TEST(HncParser, BorlandWords) {
  EXPECT_THAT(ErrorsOf("int far *p; unsigned char near _n; int huge _cdecl f(int a) { return a; }\n"
                       "int pascal g(void) { return __fastcall_; } int __fastcall_2;\n"),
              ElementsAre("4:29 E010"));
  EXPECT_THAT(WarningsOf("int _loadds f(void) { return 1; }\n"), ElementsAre("3:5 W27"));
  EXPECT_THAT(ErrorsOf("int class, new, template, inline, typeof, restrict, far;\n"), ElementsAre("3:56 E001"));
}

TEST(HncParser, AssemblerStatements) {
  Parsed parsed;
  ParseInto(parsed,
            Program("#define DI asm cli\nint a;\nvoid f() {\nasm cli\na = 1;\nasm { sti }\nDI;\nif (a) DI; else a = "
                    "2;\n__asm STI; a = 3;\n}\n"));
  EXPECT_THAT(parsed.Errors(), IsEmpty()) << parsed.FirstText();
  const std::string syntax = parsed.Syntax();
  EXPECT_THAT(syntax, HasSubstr("6: cli\n"));
  EXPECT_THAT(syntax, HasSubstr("8: sti\n"));
  EXPECT_THAT(syntax, HasSubstr("9: cli\n"));
  EXPECT_THAT(syntax, HasSubstr("11: sti\n"));
}

TEST(HncParser, ConversionsAreNodes) {
  Parsed parsed;
  ParseInto(parsed, Program("int a; long l;\nvoid f() { R[5] += 300; l = a; a = R[1] == -1; }\n"));
  ASSERT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_THAT(parsed.Syntax(), HasSubstr("(+=<int> ([] R 5:int) 300:int)"));
  EXPECT_THAT(parsed.Syntax(), HasSubstr("(= l (to<long> (load a)))"));
  EXPECT_THAT(parsed.Syntax(), HasSubstr("(= a (== (to<int> (load ([] R 1:int))) (- 1:int)))"));
}

TEST(HncParser, OldStyleFunctions) {
  Parsed parsed;
  ParseInto(parsed, Program("f(a, b) char a; { return a + b; }\nint x;\nvoid g() { x = f(300, 2); }\n"));
  ASSERT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_THAT(parsed.Syntax(), HasSubstr("(f (to<signed char> 300:int) 2:int)")) << "the low byte";
}

TEST(HncParser, LoopBounds) {
  Parsed parsed;
  ParseInto(parsed, Program("void f() {\n#pragma plcxx loop_bound(7)\nwhile (X[0]) ;\n/*@loop_bound 9@*/ /* wait */\n"
                            "do ; while (X[1]);\nwhile (X[2]) ; }\n"));
  ASSERT_THAT(parsed.Errors(), IsEmpty());
  std::vector<uint32_t> rounds;
  for (const Statement& statement : parsed.unit.statements) {
    const bool loop = statement.kind == StatementKind::kWhile || statement.kind == StatementKind::kDo;
    if (loop) rounds.push_back(statement.loop_bound ? statement.loop_bound->rounds : 0);
  }
  EXPECT_THAT(rounds, ElementsAre(7, 9, 0));
}

TEST(HncParser, MacrosThatNameACell) {
  Parsed parsed;
  ParseInto(parsed, Program("#define mode_sel R[0]\nvoid f() { mode_sel = 1; }\n"));
  ASSERT_THAT(parsed.Errors(), IsEmpty());
  const auto whole = std::ranges::find_if(
      parsed.unit.expressions, [](const Expr& expr) { return expr.kind == ExprKind::kIndex && expr.whole_macro; });
  ASSERT_NE(whole, parsed.unit.expressions.end());
  EXPECT_EQ(parsed.unit.macros[parsed.unit.macro_uses[whole->macro].macro].name, "mode_sel");
  EXPECT_EQ(parsed.sources.Text(whole->range), "mode_sel");
}

TEST(HncParser, Recognition) {
  EXPECT_TRUE(Recognize("void init() { }\nvoid plc1() { }"));
  EXPECT_TRUE(Recognize("#include \"x.h\"\nplc1 () {"));
  EXPECT_FALSE(Recognize("SLOW\nNETWORK\nLD %I0"));
}

}  // namespace
}  // namespace plcxx::hnc
