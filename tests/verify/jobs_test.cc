// However many functions are proved at a time, the same is told of them, in the order of the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/driver/run_plcxx.h"
#include "tests/verify/changed_code.h"

namespace plcxx {
namespace {

using driver::Workplace;
using ::testing::HasSubstr;

/// Modules that call the same one; functions of C, and what Clang makes of them.
class JobsTest : public ::testing::TestWithParam<const char*> {};

TEST_P(JobsTest, SayAndCertifyTheSame) {
  const Workplace workplace;
  const auto verify = [&](const std::string& jobs) {
    const std::string program = std::string(PLCXX_ROOT "/tests/golden/") + GetParam();
    // Not by Run: solver and LLVM together take more address space than that leaves.
    const std::string command = "cd '" + workplace.Path("") + "' && " PLCXX_BINARY " verify " + program + " --jobs " +
                                jobs + " --certificate " + jobs + ".json >said 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return workplace.Read("said") + workplace.Read(jobs + ".json");
  };
  const std::string one = verify("1");
  EXPECT_THAT(one, HasSubstr("proved equal to the program"));
  EXPECT_EQ(verify("2"), one);
  EXPECT_EQ(verify("5"), one);
}

INSTANTIATE_TEST_SUITE_P(All, JobsTest,
                         ::testing::Values("prostep/modules/diamond_is_no_recursion.plc --dialect prostep",
                                           "hnc/functions/argument_conversion.cld"),
                         [](const auto& golden) {
                           const std::string path = golden.param;
                           return path.substr(0, path.find('/'));
                         });

/// All that a proof has, as text.
std::string TextOf(const prove::verify::RoutineProof& proof) {
  std::string text = proof.routine + " " + std::to_string(static_cast<int>(proof.result)) + " " + proof.reason;
  for (const uint64_t count : {proof.obligations, proof.claims, proof.instructions, proof.asked})
    text += " " + std::to_string(count);
  for (const std::string& function : proof.relies_on) text += " " + function;
  for (const prove::verify::CodeDifference& difference : proof.differences) {
    text +=
        "; " + difference.what + " " + std::to_string(difference.expected) + " " + std::to_string(difference.compiled);
    for (const prove::verify::VariableValue& value : difference.state)
      text += " " + value.name + "=" + std::to_string(value.value);
  }
  return text + "\n";
}

/// What is told as it is decided, which is what is found in the end.
std::string ProofsOf(prove::Subject& subject, uint32_t jobs) {
  prove::verify::VerifyLimits limits;
  limits.jobs = jobs;
  std::string told, all;
  limits.is_decided = [&told](const prove::verify::RoutineProof& proof) { told += TextOf(proof); };
  for (const prove::verify::RoutineProof& proof : subject.Proofs(limits)) all += TextOf(proof);
  EXPECT_EQ(told, all);
  return told;
}

/// One that differs is looked into where it is called, by two of its callers at a time.
TEST(Jobs, AreShownTheSameStates) {
  prove::Subject subject("modules.plc",
                         ":MOD PM 9\n:JU PM 20\n:JU PM 21\n:END PM 9\n:MOD PM 20\n:JU PM 22\n:A I 20.1\n:= F 250.1\n"
                         ":END PM 20\n:MOD PM 21\n:JU PM 22\n:A I 20.2\n:= F 250.2\n:END PM 21\n"
                         ":MOD PM 22\n:A I 20.3\n:A I 20.4\n:= F 250.3\n:END PM 22\n"
                         ":MOD PM 0\n:A I 20.1\n:S F 251.0\n:END PM 0\n",
                         "prostep");
  std::string& text = subject.TextOf("turret.cpp");
  const std::string right = "m[I20_3] & m[I20_4]";
  const size_t at = text.find(right);
  ASSERT_NE(at, std::string::npos) << text;
  text.replace(at, right.size(), "m[I20_3] | m[I20_4]");
  const std::string found = ProofsOf(subject, 1);
  EXPECT_THAT(found, HasSubstr("; F.250.3 "));
  EXPECT_EQ(ProofsOf(subject, 2), found);
  EXPECT_EQ(ProofsOf(subject, 3), found);
}

/// They begin with answers of one another.
TEST(Jobs, ChunksOfALongPart) {
  std::string program = "U4A0=I0A0\n$\n";
  for (int i = 0; i < 100; ++i) {
    const std::string timer = "T" + std::to_string(i + 1), bit = "A" + std::to_string(i % 8);
    program += timer + "I(" + std::to_string(3 + 7 * i % 150) + ")=I" + std::to_string(i % 8) + bit + "*/I3A0\n";
    program += "U" + std::to_string(4 + i / 8) + bit + "=" + timer + "U+I2" + bit + "\n";
  }
  prove::Subject subject("turret.plc", program.c_str(), "nc110");
  const std::string found = ProofsOf(subject, 1);
  size_t chunks = 0;
  for (size_t at = found.find("\nslow_"); at != std::string::npos; at = found.find("\nslow_", at + 1)) ++chunks;
  EXPECT_GT(chunks, 2U) << found;
  EXPECT_EQ(ProofsOf(subject, 3), found);
}

}  // namespace
}  // namespace plcxx
