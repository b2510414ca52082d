// The judges of a part of the random programs see what is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/reference/shares.h"
#include "tests/temporary_directory.h"

namespace plcxx::reference {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class Shares : public testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = directory_.path() / name;
    std::ofstream(path, std::ios::binary) << text;
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path.string();
  }
  /// What a judge says of a program when plcxx prints this and ends so.
  std::vector<Disagreement> Verified(const std::string& printed, int code) {
    Judges judges;
    judges.plcxx = Write("plcxx", "#!/bin/sh\ncat <<E\n" + printed + "E\nexit " + std::to_string(code) + "\n");
    return Judge(Share::kVerified, {{directory_.path().string(), "nc110", {}}}, judges, counts_);
  }
  testing_support::TemporaryDirectory directory_;
  ShareCounts counts_;
};

TEST_F(Shares, ScenariosThatFailInCompiledCodeAreNamed) {
  Write("a.plc", "$\nU4A0=I0A0\n");
  const std::string right =
      Write("right.yaml", "dialect: nc110\nsources: [a.plc]\nsteps: [run: {slow: 1}, expect: {U4A0: 0}]\n");
  const std::string wrong =
      Write("wrong.yaml", "dialect: nc110\nsources: [a.plc]\nsteps: [run: {slow: 1}, expect: {U4A0: 1}]\n");
  testing::internal::CaptureStdout();
  EXPECT_EQ(RunJudge(Share::kCompiled, {"g++ -O0"}, {right}), 0);
  EXPECT_EQ(RunJudge(Share::kCompiled, {"g++ -O0"}, {right, wrong}), 1);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("FAILED " + wrong));
  EXPECT_EQ(RunJudge(Share::kCompiled, {}, {right}), 2) << "nothing that runs says nothing";
}

TEST_F(Shares, WhatVerifyFindsDifferentIsADisagreement) {
  EXPECT_THAT(Verified("a:\n  slow: proved (12 bytes of State)\n  fast: not decided: out of time\n", 1), IsEmpty());
  EXPECT_EQ(counts_.proved, 1u);
  EXPECT_EQ(counts_.not_decided, 1u);
  EXPECT_EQ(Verified("a:\n  slow: proved (12 bytes of State)\n  fast: different\n", 1).size(), 1u);
  EXPECT_EQ(Verified("a: not verified\n", 1).size(), 1u) << "no function was looked at";
  EXPECT_EQ(Verified("  slow: proved ()\n", 3).size(), 1u) << "a fault of plcxx";
}

}  // namespace
}  // namespace plcxx::reference
