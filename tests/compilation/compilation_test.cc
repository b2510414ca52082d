// From files and options to a compiled program: which dialect, which warnings, how far.
#include "transpiler/compilation/compilation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/compilation/dialect_choice.h"
#include "transpiler/compilation/warning_options.h"

namespace plcxx::compilation {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

TEST(Warnings, LastWordWins) {
  std::vector<std::string> unknown;
  const diag::WarningOptions options = ReadWarningOptions(
      {"no-W303", "W303", "W370", "no-nc110-W370", "error=W356", "no-error=W356", "error=W357"}, unknown);
  EXPECT_THAT(unknown, ::testing::IsEmpty());
  EXPECT_THAT(options.enabled, UnorderedElementsAre("W303", "W370", "W356", "W357"));
  EXPECT_THAT(options.disabled, UnorderedElementsAre("nc110-W370"));
  EXPECT_THAT(options.errors, UnorderedElementsAre("W357"));
  EXPECT_FALSE(options.all_errors);
}

TEST(Warnings, ErrorsAreNoWarnings) {
  std::vector<std::string> unknown;
  ReadWarningOptions({"41", "no-nc110-41", "error=foo", "error"}, unknown);
  EXPECT_THAT(unknown, ElementsAre("-W41", "-Wno-nc110-41", "-Werror=foo"));
}

TEST(Dialects, ExtensionThenContent) {
  const auto peek = [](const std::string& path) -> std::string {
    return path.starts_with("program") ? "U4A0=I0A0*/I0A1\n$\n" : "good morning\n";
  };
  const dialects::Dialect* nc110 = dialects::DialectByName("nc110");
  EXPECT_EQ(ChooseDialect("nc110", {"x"}, peek), nc110);
  EXPECT_EQ(ChooseDialect("cobol", {"x.plc"}, peek), nullptr);
  EXPECT_EQ(ChooseDialect("", {"x.SYM"}, peek), nc110);
  EXPECT_EQ(ChooseDialect("", {"program.PLC"}, peek), nc110) << "two dialects use .plc: the content decides";
  EXPECT_EQ(ChooseDialect("", {"x.plc"}, peek), nullptr);
  EXPECT_EQ(ChooseDialect("", {"letter", "program"}, peek), nc110);
  EXPECT_EQ(ChooseDialect("", {"letter"}, peek), nullptr);
}

TEST(Compile, StopsWhereItIsToldTo) {
  const testing_support::TemporaryDirectory directory;
  CompilationRequest request;
  request.base_directory = directory.path().string();
  request.sources = {"main.plc"};
  directory.Write("main.plc", "U4A0=I0A0\n$\n");
  for (const Stage stage : {Stage::kLoaded, Stage::kLowered, Stage::kStructured, Stage::kChecked, Stage::kOptimized}) {
    const Compilation compilation = Compile(request, stage);
    EXPECT_TRUE(compilation.ok());
    EXPECT_EQ(compilation.reached, stage);
  }
  directory.Write("main.plc", "U4A0=I0A\n$\n");
  const Compilation bad = Compile(request);
  EXPECT_FALSE(bad.ok());
  EXPECT_FALSE(bad.wrong_use);
  EXPECT_EQ(bad.reached, Stage::kLoaded);
}

TEST(Compile, SlicesByCost) {
  const testing_support::TemporaryDirectory directory;
  std::string program = "$\n";
  for (int i = 0; i < 30'000; ++i) {
    program += "U" + std::to_string(100 + i / 32 % 100) + "K" + std::to_string(i % 32) + "=I0A0*I0A1+I0A2*/I0A3\n";
  }
  directory.Write("main.plc", program);
  CompilationRequest request;
  request.base_directory = directory.path().string();
  request.sources = {"main.plc"};
  request.options = {{"slices", "auto"}, {"clo", "10,1"}};
  const Compilation compilation = Compile(request);
  ASSERT_TRUE(compilation.ok());
  EXPECT_GT(compilation.estimates.slices, 1u);
  EXPECT_EQ(compilation.estimates.slow_period_ms, 10 * compilation.estimates.slices);
}

TEST(Compile, SlowPartInEveryNthPeriodHasNoPeriodInSlices) {
  const testing_support::TemporaryDirectory directory;
  directory.Write("main.il", "SLOWDIV 8\nSLOW\nNETWORK\nLD %I0\nOUT %Q0\nEND_SLOW\n");
  CompilationRequest request;
  request.base_directory = directory.path().string();
  request.sources = {"main.il"};
  const Compilation compilation = Compile(request);
  ASSERT_TRUE(compilation.ok());
  EXPECT_EQ(compilation.estimates.slow_period_ms, 0u);
}

}  // namespace
}  // namespace plcxx::compilation
