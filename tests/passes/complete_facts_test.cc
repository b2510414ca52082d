// Facts get their statements, and loops that are called proved the fact that they end.
#include "transpiler/passes/complete_facts.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/passes/passes_testing.h"
#include "transpiler/ir/facts.h"

namespace plcxx::passes {
namespace {

constexpr std::string_view kFalseFact =
    "host false_fact (kind : i8 = (COMPARISON, DIVISION, SHIFT, SIGN, VARIABLE, INDEX, LOOP, REGISTER, RESULT), "
    "statement : i32, value : i32)\n";
constexpr std::string_view kLoop =
    "  loop @1 proven 8 {\n"
    "    condition {\n"
    "      %0 = load a\n"
    "    }\n"
    "    body {\n"
    "    }\n"
    "  }\n";

ir::Program Completed(const std::string& host, const std::string& body) {
  ir::Program program = ReadRoutines(host + "routine fast fast {\n  stmt s7\n" + body + "}\n");
  CompleteFacts(program);
  return program;
}

TEST(CompleteFacts, ALoopThatIsCalledProvedIsCounted) {
  const std::string text = Routines(Completed(std::string(kFalseFact), std::string(kLoop)));
  EXPECT_NE(text.find("loop @1 guard 8 {"), std::string::npos) << text;
  EXPECT_NE(text.find("exhausted {"), std::string::npos) << text;
  EXPECT_NE(text.find("const i32 7"), std::string::npos) << text;  // its statement
}

TEST(CompleteFacts, NothingChangesWhereFactsAreTrusted) {
  const std::string text = Routines(Completed("", std::string(kLoop)));
  EXPECT_NE(text.find("loop @1 proven 8 {"), std::string::npos) << text;
  EXPECT_EQ(text.find("exhausted"), std::string::npos) << text;
}

TEST(CompleteFacts, AFactGetsTheStatementAroundIt) {
  const std::string fact =
      "  %0 = load a\n"
      "  if %0 {\n"
      "    %1 = const i8 5\n"
      "    %2 = const i32 0\n"
      "    %3 = const i32 12\n"
      "    host false_fact (%1, %2, %3)\n"
      "  }\n";
  const std::string text = Routines(Completed(std::string(kFalseFact), fact));
  EXPECT_NE(text.find("const i32 7\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace plcxx::passes
