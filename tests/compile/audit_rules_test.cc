// Each rule of the audit: a text that breaks it is caught for every target, a clean one is not.
#include "transpiler/compile/audit_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/compile/compiled_fixture.h"

namespace plcxx::compile {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Violation {
  const char* fixture;
  AuditRule rule;
  const char* function;
  const char* detail;
  bool without_float_unit = false;  // only where doubles are computed by software
};
constexpr Violation kViolations[] = {
    {"heap_malloc.cpp", AuditRule::kHeap, "sample::fast", "malloc"},
    {"heap_new.cpp", AuditRule::kHeap, "sample::fast", "operator new"},
    {"exception.cpp", AuditRule::kException, "sample::fast", "_Unwind_Resume"},
    {"unwind_tables.cpp", AuditRule::kException, ".gcc_except_table", "unwind tables"},
    {"static_constructor.cpp", AuditRule::kStaticConstructor, ".init_array", ""},
    {"recursion.cpp", AuditRule::kRecursion, "sample::", "sample::slow, "},
    {"indirect_call.cpp", AuditRule::kIndirectCall, "sample::fast", ""},
    {"indirect_jump.cpp", AuditRule::kIndirectCall, "sample::fast", ""},
    {"float_routine.cpp", AuditRule::kFloat, "sample::fast", "__", true},
    {"undefined.cpp", AuditRule::kUndefined, "sample::fast", "log_value"},
};

const AuditExpectations kExpectations{.host_functions = {"sample::fault", "sample::host"}, .has_floats = false};

bool HasDoubleUnit(const Target& target) {
  return target.name == "host" || target.name == "rv64gc" || target.name == "cortex-m7";
}

std::string Text(const std::vector<AuditFinding>& findings) {
  std::string text;
  for (const AuditFinding& finding : findings) {
    text += std::to_string(static_cast<int>(finding.rule)) + " " + finding.function + ": " + finding.detail + "\n";
  }
  return text;
}

TEST(Audit, ViolationsAreCaught) {
  for (const Tools& tools : InstalledTools()) {
    for (const Violation& violation : kViolations) {
      if (violation.without_float_unit && HasDoubleUnit(*tools.target)) continue;
      SCOPED_TRACE(std::string(violation.fixture) + " for " + std::string(tools.target->name) + ", " +
                   tools.toolchain.version);
      const auto code = CompileText(FixtureText(violation.fixture), *tools.target, tools.toolchain);
      ASSERT_TRUE(code);
      const std::vector<AuditFinding> findings = Audit(*code, kExpectations);
      EXPECT_FALSE(findings.empty());
      for (const AuditFinding& finding : findings) {
        EXPECT_EQ(finding.rule, violation.rule) << Text(findings);
        EXPECT_THAT(finding.function, HasSubstr(violation.function));
        EXPECT_THAT(finding.detail, HasSubstr(violation.detail));
      }
    }
  }
}

TEST(Audit, CleanCodeIsNot) {
  const std::string text = FixtureText("clean.cpp");
  for (const Tools& tools : InstalledTools()) {
    for (const std::string level : {"0", "1", "2", "3", "s"}) {
      SCOPED_TRACE(std::string(tools.target->name) + ", " + tools.toolchain.version + ", -O" + level);
      const auto code = CompileText(text, *tools.target, tools.toolchain, level);
      ASSERT_TRUE(code);
      const std::vector<AuditFinding> findings = Audit(*code, kExpectations);
      EXPECT_TRUE(findings.empty()) << Text(findings);
    }
  }
}

TEST(Audit, FloatsMayBeThereWhereTheProgramHasSome) {
  for (const Tools& tools : InstalledTools()) {
    const auto code = CompileText(FixtureText("float_routine.cpp"), *tools.target, tools.toolchain);
    ASSERT_TRUE(code);
    EXPECT_THAT(Audit(*code, {.host_functions = {}, .has_floats = true}), IsEmpty()) << tools.target->name;
  }
}

TEST(Audit, OfAHostWhatOnePeriodReaches) {
  const std::string text = FixtureText("waits_beside.cpp");
  const auto findings_of = [&](const std::string& head, const Tools& tools) {
    const auto code = CompileText(head + text, *tools.target, tools.toolchain);
    EXPECT_TRUE(code);
    const auto findings = AuditFrom(*code, "sample::OnePeriod(", {.host_functions = {}, .has_floats = false});
    EXPECT_TRUE(findings);
    return Text(*findings);
  };
  for (const Tools& tools : InstalledTools()) {
    SCOPED_TRACE(tools.target->name);
    EXPECT_EQ(findings_of("", tools), "");
    EXPECT_EQ(findings_of("#define WAITS\n", tools),
              std::to_string(static_cast<int>(AuditRule::kUndefined)) + " sample::OnePeriod: fsync\n");
    EXPECT_EQ(findings_of("#define ALLOCATES\n", tools),
              std::to_string(static_cast<int>(AuditRule::kHeap)) + " sample::program: malloc\n");
    EXPECT_FALSE(AuditFrom(*CompileText(text, *tools.target, tools.toolchain), "sample::Nothing(", {}));
  }
}

TEST(Audit, SymbolsAreKnownByNameOrFamily) {
  EXPECT_EQ(UseOfSymbol("memcpy"), RoutineUse::kMemory);
  EXPECT_EQ(UseOfSymbol("memcpyx"), RoutineUse::kUnknown);
  EXPECT_EQ(UseOfSymbol("__aeabi_uidivmod"), RoutineUse::kInteger);
  EXPECT_EQ(UseOfSymbol("__aeabi_dmul"), RoutineUse::kFloat);
  EXPECT_EQ(UseOfSymbol("_Znwj"), RoutineUse::kHeap);
  EXPECT_EQ(UseOfSymbol("__cxa_throw"), RoutineUse::kException);
}

TEST(Audit, NamesAreThoseOfTheSource) {
  EXPECT_EQ(NameOf("mill::fast(mill::State&, mill::Host&) (.part.0)"), "mill::fast");
  EXPECT_EQ(NameOf("mill::(anonymous namespace)::slow_C8(mill::State&)"), "mill::(anonymous namespace)::slow_C8");
  EXPECT_EQ(NameOf("malloc"), "malloc");
}

}  // namespace
}  // namespace plcxx::compile
