// Heads of functions: what is handed over, and how, to subroutines and to what is cut out of long functions; and which
// parameters have a name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::print {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::string_view kHeadDeclarations = R"(program "p" test
space A 32 volatile little host_visible "outputs"
space handed 8 routine little own
space locals 8 routine little own
place a bit A[0].0
place b bit A[0].1
place W i8 A[2]
place count i8 handed[0]
place kept bit locals[0].0
host stop (index : i32) "stops"
)";

std::string PrintAll(const std::string& text, Flavour flavour = Flavour::kRelease) {
  const ir::Program program = ir::ReadOrDie(std::string(kHeadDeclarations) + text);
  const source::SourceManager sources;
  std::string all;
  for (const OutputFile& file : PrintCpp(legalize::Legalize(program, {.name = "p", .flavour = flavour}), sources))
    all += file.text;
  return all;
}

/// So many statements that each read the parameter.
std::string Statements(uint32_t statements, const std::string& body) {
  std::string text;
  for (uint32_t i = 0; i < statements; ++i) text += "stmt s" + std::to_string(i * 7919 + 1) + "\n" + body;
  return text;
}

// A parameter that nothing writes stays a value in the functions that the subroutine is cut into.
TEST(Functions, GetAParameterByValueUnlessTheyChangeIt) {
  const std::string declared = "routine fast fast {\n body {\n %0 = const i8 3\n call f (%0)\n }\n}\n";
  const std::string head = "routine f subroutine (count : i8 = count) {\n body {\n";
  const std::string reads = PrintAll(head + Statements(300, "%0 = load count\nstore W %0\n") + "}\n}\n" + declared);
  EXPECT_THAT(reads, HasSubstr("static void f(State& m, uint8_t count, Host& host) noexcept {"));
  EXPECT_THAT(reads, HasSubstr("static void f_part(State& m, uint8_t count, Host&) noexcept {"));
  EXPECT_THAT(reads, Not(HasSubstr("uint8_t& count")));
  const std::string writes =
      PrintAll(head + Statements(300, "%0 = load count\nstore W %0\nstore count %0\n") + "}\n}\n" + declared);
  EXPECT_THAT(writes, HasSubstr("static void f(State& m, uint8_t count, Host& host) noexcept {"));
  EXPECT_THAT(writes, HasSubstr("static void f_part(State& m, uint8_t& count, Host&) noexcept {"));
}

// What is cut out stores the result, the subroutine itself returns it.
TEST(Functions, ReturnWhereTheResultIsTheirs) {
  const std::string text =
      PrintAll("place result i8 locals[1]\nroutine f subroutine (count : i8 = count) -> i8 result {\n body {\n" +
               Statements(300, "%0 = load count\nstore result %0\n") +
               "}\n}\nroutine fast fast {\n body {\n %0 = const i8 3\n %1 = call f (%0)\n store W %1\n }\n}\n");
  EXPECT_THAT(text,
              HasSubstr("static uint8_t f(State& m, uint8_t count, Host& host) noexcept {\n  uint8_t result = 0;\n"));
  EXPECT_THAT(text, HasSubstr("static void f_part(State&, uint8_t count, uint8_t& result, Host&) noexcept {"));
  size_t returns = 0;
  for (size_t at = text.find("return "); at != std::string::npos; at = text.find("return ", at + 1))
    returns += text.compare(at, 14, "return result;") == 0 ? 1 : 0;
  EXPECT_EQ(returns, 1u);
  EXPECT_EQ(text.find("return count"), std::string::npos);
}

// The first call, the first place: one number says nothing of the other.
TEST(Functions, GiveAResultThatIsStoredInTheFirstPlace) {
  const std::string text = PrintAll(
      "routine f subroutine -> bit kept {\n body {\n %0 = load b\n store kept %0\n }\n}\n"
      "routine fast fast {\n body {\n %0 = call f ()\n store a %0\n }\n}\n");
  EXPECT_THAT(text, HasSubstr("  m[a] = f(m, host);\n"));
}

constexpr std::string_view kPlainIf =
    "routine fast fast {\n body {\n %0 = const bit 1\n store kept %0\n %1 = load kept\n if %1 {\n %2 = const i32 1\n"
    " host stop (%2)\n }\n }\n}\n";

// An if of the control's own asks for no statement, and names nothing of the state.
TEST(Functions, NameTheStateWhereTheyAskForAStatementOnly) {
  const std::string own(kPlainIf);
  for (const Flavour flavour : {Flavour::kRelease, Flavour::kDebug})
    EXPECT_THAT(PrintAll(own, flavour), HasSubstr("void fast(State&, Host& host) noexcept {"));
  std::string of_statement = own;
  of_statement.insert(of_statement.find(" %1 = load"), "stmt s1\n");
  EXPECT_THAT(PrintAll(of_statement), HasSubstr("void fast(State&, Host& host) noexcept {"));
  EXPECT_THAT(PrintAll(of_statement, Flavour::kDebug), HasSubstr("void fast(State& m, Host& host) noexcept {"));
}

// What is stored where it was is not there, and neither is what it was read from.
TEST(Functions, NameNoStateForWhatIsNotStoredAgain) {
  const std::string unchanged = "routine fast fast {\n body {\n stmt s1\n %0 = load a\n store a %0\n";
  EXPECT_THAT(PrintAll(unchanged + " }\n}\n"), HasSubstr("void fast(State&, Host&) noexcept {"));
  EXPECT_THAT(PrintAll(unchanged + " store b %0\n }\n}\n"), HasSubstr("void fast(State& m, Host&) noexcept {"));
}

// To GCC 12 a function that stores to array + number stores to the beginning of the array: what the caller has stored
// there before is gone.
TEST(Functions, AddressBytesAsElements) {
  const std::string wide =
      "place w i32 A[4]\nplace low i16 A[6]\nroutine fast fast {\n body {\n %0 = load w\n store w %0\n %1 = load low\n"
      " store low %1\n }\n}\n";
  for (const Flavour flavour : {Flavour::kRelease, Flavour::kDebug}) {
    const std::string text = PrintAll(wide, flavour);
    EXPECT_THAT(text, HasSubstr("[tag.byte]"));
    EXPECT_THAT(text, Not(HasSubstr(" + tag.byte")));
    EXPECT_THAT(text, Not(HasSubstr(" + element.place.byte")));
  }
}

// The head of a block is never switched off: of what it holds only an if asks for it.
TEST(Functions, NameNoStateForTheHeadOfABlockAlone) {
  const std::string head =
      "statement s1 subject HEAD opens\nroutine fast fast {\n body {\n %0 = const bit 1\n store kept %0\nstmt s1\n"
      " %1 = load kept\n %2 = const i32 1\n host stop (%2)\n";
  EXPECT_THAT(PrintAll(head + " }\n}\n", Flavour::kDebug), HasSubstr("void fast(State&, Host& host) noexcept {"));
  const std::string with_if = head + " if %1 {\n %3 = const i32 2\n host stop (%3)\n }\n }\n}\n";
  EXPECT_THAT(PrintAll(with_if, Flavour::kDebug), HasSubstr("void fast(State& m, Host& host) noexcept {"));
  EXPECT_THAT(PrintAll(with_if), HasSubstr("void fast(State&, Host& host) noexcept {"));
}

// What only a simulation calls is not printed: what it calls alone is not declared either.
TEST(Functions, OfASimulationDeclareNothing) {
  const std::string called = "routine f subroutine {\n body {\n %0 = const bit 1\n store a %0\n }\n}\n";
  const std::string fast = "routine fast fast {\n body {\n %0 = const bit 0\n store b %0\n }\n}\n";
  const std::string text = called + fast + "routine only schedule simulation_only {\n body {\n call f ()\n }\n}\n";
  EXPECT_THAT(PrintAll(text), Not(HasSubstr("static void f(State& m, Host& host) noexcept;")));
  EXPECT_THAT(PrintAll(text, Flavour::kDebug), HasSubstr("static void f(State& m, Host& host) noexcept;"));
}

constexpr std::string_view kResult = "place result i8 locals[1]\nplace own i8 locals[2]\n";

/// The generated function `f` with these instructions, which gives `result`; what is between its braces.
std::string ResultFunction(const std::string& body, Flavour flavour = Flavour::kRelease) {
  const std::string text =
      PrintAll(std::string(kResult) + "routine f subroutine (count : i8 = count) -> i8 result {\n body {\n" + body +
                   "}\n}\nroutine fast fast {\n body {\n %0 = const i8 3\n %1 = call f (%0)\n store W %1\n }\n}\n",
               flavour);
  const std::string head = "static uint8_t f(";
  const size_t at = text.rfind(head), begin = text.find('\n', at) + 1;
  return text.substr(begin, text.find("\n}\n", begin) + 1 - begin);
}

// A chunk returns nothing, also where it ends by a return in the middle.
TEST(Functions, WhatIsCutOutReturnsNothing) {
  const std::string text =
      PrintAll(std::string(kResult) + "routine f subroutine (count : i8 = count) -> i8 result {\n body {\n" +
               Statements(300,
                          "block @1 {\n%0 = load a\nif %0 {\n%1 = load count\nstore result %1\nexit @1\n}\n"
                          "%2 = load count\nstore W %2\n}\n") +
               "}\n}\nroutine fast fast {\n body {\n %0 = const i8 3\n %1 = call f (%0)\n store W %1\n }\n}\n");
  EXPECT_THAT(text, HasSubstr("static void f_part("));
  EXPECT_THAT(text, HasSubstr("    result = count;\n    return;\n"));
  EXPECT_THAT(text, Not(HasSubstr("return count")));
}

// An arm that is left early by another word than return has something behind it that the result does not wait for.
TEST(Functions, ReturnNoResultWhereTheyGoOn) {
  const std::string arm =
      "%0 = load a\nif %0 jumps {\n%1 = load count\nstore result %1\n} else {\n%2 = load b\nstore kept %2\n"
      "%3 = load kept\nstore b %3\n}\n";
  const std::string behind = "%9 = load count\nstore W %9\n";
  const std::string chosen = ResultFunction("%8 = load W\nswitch %8 {\ncase 1 {\n" + arm + "}\n}\n" + behind);
  EXPECT_THAT(chosen, HasSubstr("result = count;\n        break;\n"));
  EXPECT_THAT(chosen, Not(HasSubstr("return count")));
  EXPECT_THAT(chosen, HasSubstr("return result;\n"));
  EXPECT_THAT(ResultFunction(arm), HasSubstr("    return count;\n"));
}

// Labels of a switch are numbers as any other.
TEST(Functions, SpellLabelsAsTheyWereWritten) {
  EXPECT_THAT(ResultFunction("%0 = load W\nswitch %0 {\ncase 0x1 12 0x100 {\n%1 = load count\nstore result %1\n}\n}\n"),
              HasSubstr("  case 0x01:\n    case 12:\n    case 0x0100: {\n"));
}

// The variable of the result is there as long as some text names it.
TEST(Functions, HaveAVariableOfTheResultWhereItIsNamed) {
  EXPECT_EQ(ResultFunction("stmt s1\n%0 = load count\nstore result %0\n"), "  return count;\n");
}

// One arm is left early with what the variable has, though the other one returns a value at once.
TEST(Functions, HaveAVariableOfTheResultForAnArmThatIsLeftEarly) {
  const std::string text = ResultFunction(
      "%0 = load a\nif %0 jumps {\n%8 = load b\nstore a %8\n} else {\nstmt s2\n%1 = load count\nstore result %1\n}\n");
  EXPECT_THAT(text, HasSubstr("uint8_t result = 0;\n"));
  EXPECT_THAT(text, HasSubstr("return result;\n"));
  EXPECT_THAT(text, HasSubstr("  return count;\n"));
}

// A value stored where it was is no other result.
TEST(Functions, ReturnTheVariableThatIsStoredInItself) {
  const std::string text = ResultFunction("%0 = load result\nstore result %0\n");
  EXPECT_THAT(text, HasSubstr("static_cast<void>(result);\n"));
  EXPECT_THAT(text, HasSubstr("return result;\n"));
}

// An arm without instructions gives what was there before.
TEST(Functions, GiveTheFirstValueWhereAnArmIsEmpty) {
  const std::string text = ResultFunction("%0 = load a\nif %0 {\n} else {\n%1 = load count\nstore result %1\n}\n");
  EXPECT_THAT(text, HasSubstr("return count;\n"));
  EXPECT_THAT(text, HasSubstr("return result;\n"));
}

// A second value in front of all statements is an assignment: the declaration has one value.
TEST(Functions, DeclareAVariableWithTheFirstOfItsValues) {
  const std::string text =
      ResultFunction("%0 = const i8 1\nstore own %0\n%1 = const i8 2\nstore own %1\n%2 = load own\nstore W %2\n");
  EXPECT_THAT(text, HasSubstr("uint8_t own = 1;\n"));
  EXPECT_THAT(text, HasSubstr("own = 2;\n"));
}

// What a host function gives beside its result may be what the subroutine gives.
TEST(Functions, GiveWhatAHostFunctionHasPutThere) {
  const std::string text = PrintAll(
      "place result i8 locals[1]\nhost read (index : i32) -> i16 out value : i8\n"
      "routine f subroutine -> i8 result {\n body {\n %0 = const i32 1\n %1 = host read (%0) out result\n }\n}\n"
      "routine fast fast {\n body {\n %1 = call f ()\n store W %1\n }\n}\n");
  EXPECT_THAT(text, HasSubstr("  uint8_t result = 0;\n"));
  EXPECT_THAT(text, HasSubstr("return result;\n"));
  // The variable is there also where another value is returned in the end.
  const std::string other = PrintAll(
      "place result i8 locals[1]\nhost read (index : i32) -> i16 out value : i8\n"
      "routine f subroutine -> i8 result {\n body {\n %0 = const i32 1\n %1 = host read (%0) out result\n stmt s1\n"
      " %2 = load W\n store result %2\n }\n}\n"
      "routine fast fast {\n body {\n %1 = call f ()\n store W %1\n }\n}\n");
  EXPECT_THAT(other, HasSubstr("  uint8_t result = 0;\n"));
  EXPECT_THAT(other, HasSubstr("return m[W];\n"));
}

std::string HeaderOf(const ir::Program& program) {
  const source::SourceManager sources;
  std::string header;
  for (const OutputFile& file : PrintCpp(legalize::Legalize(program, {.name = "p"}), sources))
    if (file.name.ends_with(".hpp")) header = file.text;
  return header;
}

// Blank lines part what belongs together, one at a time.
TEST(Functions, AreInAHeaderOfParagraphs) {
  const ir::Program program = ir::ReadOrDie(
      std::string(kHeadDeclarations) +
      "routine fast fast {\n body {\n %0 = const i32 1\n host stop (%0)\n %1 = load a\n store b %1\n }\n}\n"
      "message 3 colour 1 \"x\"\ntable t (n : i16, name : none)\nrow 1 \"one\"\nrow 2 \"two\"\n");
  const std::string header = HeaderOf(program);
  EXPECT_THAT(header, HasSubstr("// How the scan reaches the control: you define Host and these functions.\n"
                                "struct Host;\nstruct State;\n\n/// stops\n"));
  EXPECT_THAT(header, HasSubstr("/// stops\nvoid stop(Host& host, uint32_t index) noexcept;\n\n"));
  EXPECT_THAT(header, HasSubstr("void fast(State& m, Host& host) noexcept;\n\n"));
  EXPECT_THAT(header, HasSubstr("    {3, 1, \"x\"},\n};\n\nstruct t_row {\n  uint16_t n;\n  const char* name;\n};\n"
                                "inline constexpr t_row t[] = {\n    {1, \"one\"},\n    {2, \"two\"},\n};\n\n}"));
  EXPECT_THAT(header, Not(HasSubstr("\n\n\n")));
}

// Where no function of the control is called none is announced, and there is one blank line in place of them.
TEST(Functions, AreNotAnnouncedWhereThereAreNone) {
  const std::string header = HeaderOf(ir::ReadOrDie(
      std::string(kHeadDeclarations) + "routine fast fast {\n body {\n %1 = load a\n store b %1\n }\n}\n"));
  EXPECT_THAT(header, HasSubstr("// The scan calls no function of the control: you define Host, which may be empty.\n"
                                "struct Host;\nstruct State;\n\n//"));
  EXPECT_THAT(header, Not(HasSubstr("these functions")));
  EXPECT_THAT(header, Not(HasSubstr("\n\n\n")));
}

/// What sets the bytes from `first` on at power-on.
std::string InitialText(uint32_t first, const std::vector<uint32_t>& distances) {
  std::string text =
      "space K 200 volatile little host_visible\nplace row i8 K[0] stride 1 low 0 high 200 indexed\nplace at i32 "
      "locals[4]\n";
  uint32_t at = first;
  text += "initial K " + std::to_string(at) + " 1\n";
  for (const uint32_t distance : distances) text += "initial K " + std::to_string(at += distance) + " 1\n";
  return PrintAll(text +
                  "routine init init {\n body {\n %0 = const bit 1\n store a %0\n }\n}\nschedule init init\nroutine "
                  "fast fast {\n body {\n %0 = const i32 0\n store at %0\n %1 = load at\n %2 = load row[%1]\n "
                  "store W %2\n }\n}\n");
}

size_t Count(const std::string& text, std::string_view word) {
  size_t count = 0;
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

// Eight values near each other are a table; a gap of more than four zeros ends it.
TEST(Functions, SetManyFirstValuesByATable) {
  EXPECT_EQ(Count(InitialText(3, std::vector<uint32_t>(6, 1)), "kValues[]"), 0u);
  EXPECT_EQ(Count(InitialText(3, std::vector<uint32_t>(7, 1)), "kValues[]"), 1u);
  EXPECT_EQ(Count(InitialText(3, std::vector<uint32_t>(7, 5)), "kValues[]"), 1u);
  EXPECT_EQ(Count(InitialText(3, std::vector<uint32_t>(7, 6)), "kValues[]"), 0u);
  const std::string two = InitialText(3, {1, 1, 1, 1, 1, 1, 1, 9, 1, 1, 1, 1, 1, 1, 1, 40});
  EXPECT_EQ(Count(two, "kValues[]"), 2u);
  EXPECT_EQ(Count(two, " = 0x01;\n"), 1u);
  // A row ends where the address is a multiple of 16.
  EXPECT_THAT(
      InitialText(12, {1, 1, 1, 1, 1, 1, 4}),
      HasSubstr("= {\n      0x01, 0x01, 0x01, 0x01,\n      0x01, 0x01, 0x01, 0x00, 0x00, 0x00, 0x01,\n    };\n"));
}

}  // namespace
}  // namespace plcxx::emit::print
