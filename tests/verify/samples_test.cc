// The machines of samples/, verified by the tool itself: whole where that takes seconds, else some routines in a normal
// run and whole in the heavy one; and what the tool says and writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/driver/run_plcxx.h"
#include "tests/volume.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;

struct Sample {
  const char* folder;
  const char* arguments;
  const char* part = "";  // of a normal run
};
constexpr Sample kSamples[] = {
    {"nc110/lathe_16k20",
     "lathe.sym fast.plc spindle.plc turret.plc --set iocfil=IOCFIL --set axcfil=AXCFIL --set pgcfil=PGCFIL "
     "--set messages=RUMES5 --set menu=LGCMNU --set help=HELP"},
    {"host50/ck6150", "ck6150.il texts.il fast.il main.il spindle.il turret.il units.il mcodes.il"},
    {"prostep/mill_fnd32", "mill.plc texts.plc fast.plc loop.plc magazine.plc --dialect prostep"},
    {"classicladder/turret", "turret.clp"},
    {"technol/mcv_750", "mcv.plc main.plc nc.plc vymena.plc vypnuti.plc TAB_MCV.TCH --dialect technol",
     " --routine init --routine fast --routine requests"},
    {"hnc/mill_xk7132", "mill.cld --front-end off", " --routine init"},
};

std::string FolderOf(const Sample& sample) { return std::string(PLCXX_ROOT "/samples/") + sample.folder; }

class SamplesTest : public ::testing::TestWithParam<Sample> {};

TEST_P(SamplesTest, IsProved) {
  const Workplace workplace;
  const std::string part = testing_support::Volume(GetParam().part, "");
  // Not by Run: solver and LLVM together take more address space than it leaves.
  const std::string command = "cd '" + FolderOf(GetParam()) + "' && timeout 900 " PLCXX_BINARY " verify --time 150s " +
                              GetParam().arguments + part + " >'" + workplace.Path("said") + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << workplace.Read("said");
  const std::string what = part.empty() ? "the compiled code" : "what was asked for";
  EXPECT_THAT(workplace.Read("said"), HasSubstr(what + " is proved equal to the program"));
}

INSTANTIATE_TEST_SUITE_P(All, SamplesTest, ::testing::ValuesIn(kSamples), [](const auto& sample) {
  const std::string folder = sample.param.folder;
  return folder.substr(0, folder.find('/'));
});

/// What a routine does is known from what its functions do, which are proved before it.
TEST(VerifyCommand, CallersRelyOnWhatIsProved) {
  const Workplace workplace;
  workplace.Write("turret.plc", "U4A0=I0A0*/I0A1\n$\nT5I(10)=I0A2\nU4A1=T5U\n");
  ASSERT_EQ(workplace.Run("verify turret.plc --certificate one.json -q").code, 0);
  const auto json = nlohmann::json::parse(workplace.Read("one.json"));
  EXPECT_EQ(json["routines"][3]["routine"], "period");
  EXPECT_EQ(json["routines"][3]["relies_on"], (std::vector<std::string>{"fast", "slow"}));
}

/// Clang leaves out what a caller writes into a register that the callee sets before it reads it: such a register is
/// nothing that the two calls must agree in, and so the call is not looked into.
TEST(VerifyCommand, WhatACalleeSetsFirstIsNoArgument) {
  const Workplace workplace;
  const std::string command = "cd " PLCXX_ROOT "/samples/technol/mcv_750 && timeout 300 " PLCXX_BINARY
                              " verify mcv.plc main.plc nc.plc vymena.plc vypnuti.plc TAB_MCV.TCH --dialect technol"
                              " --routine init -q --certificate '" +
                              workplace.Path("init.json") + "' >'" + workplace.Path("said") + "' 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << workplace.Read("said");
  const auto json = nlohmann::json::parse(workplace.Read("init.json"));
  ASSERT_EQ(json["routines"][0]["routine"], "init");
  EXPECT_EQ(json["routines"][0]["relies_on"], std::vector<std::string>{"SUMA"}) << json["routines"][0];
}

TEST(VerifyCommand, CertificateSaysWhatWasProved) {
  const Workplace workplace;
  workplace.Write("turret.plc", "U4A0=I0A0*/I0A1\n$\nT5I(10)=I0A2\nU4A1=T5U\n");
  ASSERT_EQ(workplace.Run("verify turret.plc --certificate one.json -q").code, 0);
  ASSERT_EQ(workplace.Run("verify turret.plc --certificate two.json -q").code, 0);
  EXPECT_EQ(workplace.Read("one.json"), workplace.Read("two.json"));
  const auto json = nlohmann::json::parse(workplace.Read("one.json"));
  EXPECT_EQ(json["proved"], true);
  EXPECT_EQ(json["sources"][0]["file"], "turret.plc");
  EXPECT_EQ(json["sources"][0]["sha256"].get<std::string>().size(), 64U);
  EXPECT_EQ(json["routines"].size(), 4U);
  EXPECT_EQ(json["routines"][1]["result"], "proved");
  EXPECT_THAT(json["compiler"]["version"].get<std::string>(), HasSubstr("clang version 19"));
}

/// A page is tried until nothing changes: whatever is guessed of that, the reason names the page.
TEST(VerifyCommand, SaysWhoseLoopIsNotProved) {
  const Workplace workplace;
  const std::string none = ",-1,-1,-1,-1,-1,-1,-1,-1,-1";
  workplace.Write("page.clp",
                  "_FILES_CLASSICLADDER\n_FILE-sections.csv\n000,1,-1,0,0,0\n_/FILE-sections.csv\n"
                  "_FILE-sequential.csv\n#VER=1.0\nS0,1,1,0,1,1\nS1,0,2,0,1,3\nT0,1" +
                      none + ",0" + none + none + none + ",-1,-1,0,1,2\nT1,0" + none + ",1" + none + none + none +
                      ",-1,-1,0,1,4\nC0,0,50/0\nC1,0,50/1\n_/FILE-sequential.csv\n_/FILES_CLASSICLADDER\n");
  const Ran ran = workplace.Run("verify page.clp --routine fast --time 1ms --certificate page.json");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("  fast: not decided: "));
  EXPECT_THAT(ran.errors, HasSubstr("\n    the loop belongs to page.clp:3:1: page 0\n"));
  const auto json = nlohmann::json::parse(workplace.Read("page.json"));
  EXPECT_EQ(json["routines"][0]["loop_of"], "page.clp:3:1: page 0") << json["routines"][0];
}

TEST(VerifyCommand, SaysWhatItNeeds) {
  const Workplace workplace;
  workplace.Write("turret.plc", "U4A0=I0A0\n");
  const Ran other = workplace.Run("verify turret.plc --compiler g++");
  EXPECT_EQ(other.code, 1) << other;
  EXPECT_THAT(other.errors, HasSubstr("'g++' is no Clang"));
  EXPECT_EQ(workplace.Run("verify turret.plc --compiler no-such-compiler").code, 1);
  EXPECT_EQ(workplace.Run("verify turret.plc -O 0").code, 2);
  workplace.Write("wrong.plc", "U4A0=I0A0*\n");
  EXPECT_EQ(workplace.Run("verify wrong.plc").code, 1);
}

}  // namespace
}  // namespace plcxx::driver
