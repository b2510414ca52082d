// --diagnostics: text for people on standard error, JSON and SARIF for programs on standard output.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// covers: NC110-230
TEST(DiagnosticsOutput, Text) {
  const Workplace work;
  work.Write("bad.plc", kBadProgram);
  const Ran ran = work.Run("check bad.plc");
  EXPECT_THAT(ran.out, IsEmpty());
  EXPECT_THAT(ran.errors, HasSubstr("bad.plc:2:6: error: operand"));
  EXPECT_THAT(ran.errors, HasSubstr("[nc110-1]"));
  EXPECT_THAT(ran.errors, HasSubstr("1 error"));
}

TEST(DiagnosticsOutput, TextWithoutFindingsSaysSo) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  EXPECT_EQ(work.Run("check ok.plc").errors, "ok: no errors, no warnings\n");
}

TEST(DiagnosticsOutput, Json) {
  const Workplace work;
  work.Write("bad.plc", kBadProgram);
  work.Write("ok.plc", kGoodProgram);
  const Ran ran = work.Run("check bad.plc --diagnostics=json");
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.errors, IsEmpty());
  const auto found = nlohmann::json::parse(ran.out);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0]["code"], "nc110-1");
  EXPECT_EQ(found[0]["line"], 2);
  EXPECT_EQ(found[0]["column"], 6);
  EXPECT_EQ(nlohmann::json::parse(work.Run("check ok.plc --diagnostics json").out).size(), 0u);
}

TEST(DiagnosticsOutput, Sarif) {
  const Workplace work;
  work.Write("bad.plc", kBadProgram);
  const Ran ran = work.Run("emit bad.plc --diagnostics=sarif");
  EXPECT_EQ(ran.code, 1);
  const auto log = nlohmann::json::parse(ran.out);
  EXPECT_EQ(log["version"], "2.1.0");
  EXPECT_EQ(log["runs"][0]["results"][0]["ruleId"], "nc110-1");
}

TEST(DiagnosticsOutput, CommandLineFaultsAreInTheSameForm) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  const Ran ran = work.Run("check ok.plc ok.plc --diagnostics=json");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(nlohmann::json::parse(ran.out)[0]["code"], "plcxx-5");
}

TEST(DiagnosticsOutput, PrintKeepsItsOutputForThePhase) {
  const Workplace work;
  work.Write("bad.plc", kBadProgram);
  const Ran ran = work.Run("print ir bad.plc --diagnostics=json");
  EXPECT_THAT(ran.out, IsEmpty());
  EXPECT_EQ(nlohmann::json::parse(ran.errors).size(), 1u);
}

}  // namespace
}  // namespace plcxx::driver
