// The module of LinuxCNC's HAL, for each of its APIs, on a HAL of our own in one process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "tests/host/host_program.h"

namespace plcxx::host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// One program for each API, compiled once.
const HostProgram& Module(HalApi api) {
  static std::map<HalApi, std::unique_ptr<HostProgram>> programs;
  std::unique_ptr<HostProgram>& program = programs[api];
  if (!program) {
    program = std::make_unique<HostProgram>("linuxcnc");
    EXPECT_EQ(program->CompileModule(api), "");
  }
  return *program;
}

class HalModule : public ::testing::TestWithParam<HalApi> {
 protected:
  std::string Talk(const std::string& lines) const { return Module(GetParam()).Talk("", lines).out; }
};
INSTANTIATE_TEST_SUITE_P(Apis, HalModule, ::testing::ValuesIn(kHalApis));

TEST_P(HalModule, HasAPinForEachTerminalAndEachNamedSignal) {
  const std::string pins = Talk("load\npins\n");
  EXPECT_THAT(pins, HasSubstr("loaded 0\n"));
  for (const char* pin : {"fan.i0a0 b in", "fan.i0a1 b in", "fan.w1a0 u in", "fan.pump b out", "fan.lamp b out",
                          "fan.kept u out", "fan.u4a2 b out", "fan.u10n4 b out", "fan.host.running b out",
                          "fan.host.period-fault b out", "fan.host.retentive-fault b out"})
    EXPECT_THAT(pins, HasSubstr(std::string(pin) + "\n"));
  // The counts of the control are nobody's pins.
  EXPECT_THAT(pins, Not(HasSubstr("slow")));
}

TEST_P(HalModule, RunsThePeriodsOfTheProgram) {
  EXPECT_THAT(
      Talk("load\nset fan.i0a0 1\nget fan.pump\ncall fan.period 10000000 1\nget fan.pump\nget fan.host.running\n"
           "set fan.i0a0 0\ncall fan.period 10000000 19\nget fan.lamp\ncall fan.period 10000000 3\nget fan.lamp\n"
           "set fan.i0a1 1\ncall fan.period 10000000 1\nget fan.pump\n"),
      HasSubstr("loaded 0\nfan.pump 0\nfan.pump 1\nfan.host.running 1\nfan.lamp 0\nfan.lamp 1\nfan.pump 0\n"));
}

TEST_P(HalModule, WhatIsKeptAndNeverStoredIsAParameter) {
  EXPECT_THAT(Talk("load\npins\n"), HasSubstr("fan.limit u io\n"));
  // Written before the first period, between two, and with more than the place holds.
  EXPECT_THAT(Talk("load\nset fan.limit 9\ncall fan.period 10000000 1\nget fan.u4a3\nset fan.limit 5\n"
                   "call fan.period 10000000 1\nget fan.u4a3\nget fan.limit\nset fan.limit 300\n"
                   "call fan.period 10000000 1\nget fan.limit\ncall fan.period 10000000 1\nget fan.limit\n"),
              HasSubstr("fan.u4a3 1\nfan.u4a3 0\nfan.limit 5\nfan.limit 255\nfan.limit 255\n"));
}

TEST_P(HalModule, AThreadThatGoesIntoThePeriodCallsItOftenEnough) {
  // The first call is a period; then every tenth.
  EXPECT_THAT(Talk("load\nset fan.i0a0 1\ncall fan.period 1000000 1\nget fan.pump\nset fan.i0a1 1\nset fan.i0a0 0\n"
                   "call fan.period 1000000 9\nget fan.pump\ncall fan.period 1000000 1\nget fan.pump\n"),
              HasSubstr("loaded 0\nfan.pump 1\nfan.pump 1\nfan.pump 0\n"));
}

TEST_P(HalModule, AThreadOfAnotherPeriodIsRefused) {
  const std::string said = Talk(
      "load\nset fan.i0a0 1\ncall fan.period 10000000 1\nget fan.pump\ncall fan.period 7000000 1\nget fan.pump\n"
      "get fan.host.running\nget fan.host.period-fault\nwait 100\ncall fan.period 20000000 1\nget "
      "fan.host.period-fault\n"
      "call fan.period 10000000 1\nget fan.host.period-fault\nget fan.pump\n");
  EXPECT_THAT(said, HasSubstr("fan.pump 1\nfan.pump 0\nfan.host.running 0\nfan.host.period-fault 1\n"));
  EXPECT_THAT(said, HasSubstr("message 1: fan: the period of the thread does not fit, outputs stay 0: thread us 7000, "
                              "program us 10000\n"));
  EXPECT_THAT(said, HasSubstr("fan.host.period-fault 1\nfan.host.period-fault 0\nfan.pump 1\n"));
}

TEST_P(HalModule, InstancesAreMachinesOfTheirOwn) {
  EXPECT_THAT(
      Talk("load names=north,south\nset north.i0a0 1\ncall north.period 10000000 1\ncall south.period 10000000 1\n"
           "get north.pump\nget south.pump\nget fan.pump\n"),
      HasSubstr("loaded 0\nnorth.pump 1\nsouth.pump 0\nfan.pump is no pin\n"));
  EXPECT_THAT(Talk("load names=north,north\n"), HasSubstr("message 1: fan: 'north': an instance twice\nloaded -22\n"));
  EXPECT_THAT(Talk("load names=a,,b\n"), HasSubstr("no name of an instance"));
  EXPECT_THAT(Talk("load names=a,b,c,d,e,f,g,h,i\n"), HasSubstr("more than 8 instances"));
  const int most = GetParam() == HalApi::k29 ? 47 : 55;
  const std::string tall(static_cast<size_t>(most) - 7, 'x');
  EXPECT_THAT(Talk("load names=" + tall + "\n"),
              HasSubstr("characters, and HAL takes " + std::to_string(most) + ": name the instance shorter"));
}

TEST_P(HalModule, KeepsItsRetentiveMemoryInFiles) {
  const HostProgram& program = Module(GetParam());
  const std::string folder = program.work.Path("kept");
  std::filesystem::create_directories(folder);
  const std::string load = "load retentive=" + folder + "\n";
  EXPECT_THAT(program.Talk("", load + "set fan.w1a0 66\nset fan.i0a2 1\ncall fan.period 10000000 2\nunload\n").out,
              HasSubstr("no retentive memory is stored yet"));
  ASSERT_TRUE(std::filesystem::exists(folder + "/fan.a"));
  // What was stored is there in the first period, before the program overwrites it in the second.
  const std::string again =
      program
          .Talk("", load + "set fan.w1a0 67\nset fan.i0a2 1\ncall fan.period 10000000 2\nunload\n" + load +
                        "get fan.host.retentive-fault\n")
          .out;
  EXPECT_THAT(again, HasSubstr("fan.host.retentive-fault 0\n"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/fan.b"));

  program.work.Write("kept/fan.a", "nonsense");
  program.work.Write("kept/fan.b", "");
  const std::string damaged =
      program.Talk("", load + "get fan.host.retentive-fault\ncall fan.period 10000000 1\nget fan.host.running\n").out;
  EXPECT_THAT(damaged, HasSubstr("both files of the retentive memory are damaged: the program's own values count"));
  EXPECT_THAT(damaged, HasSubstr("fan.host.retentive-fault 1\nfan.host.running 1\n"));
  EXPECT_THAT(program.Talk("", "load retentive=/nowhere\nget fan.host.retentive-fault\n").out,
              HasSubstr("retentive memory is not kept: /nowhere: No such file or directory"));
}

TEST(HalModuleNames, ALongOneAndTheSecondOfTwoThatAreAlikeGiveWayToTheAddress) {
  const driver::Workplace work;
  work.Write(
      "fan.il",
      "SYMBOLS\n%Q0 THE_PUMP_OF_THE_COOLANT_BEHIND_THE_DOOR_ON_THE_LEFT \"a\"\n%Q1 Pump_on \"b\"\n%Q2 PUMP_ON \"c\"\n"
      "END_SYMBOLS\nSLOW\nNETWORK\nLD %I0\nOUT %Q0\nOUT %Q1\nLD %I1\nOUT %Q2\nEND_SLOW\n");
  const driver::Ran ran = work.Run("emit fan.il -o out --host linuxcnc");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.errors,
              HasSubstr("fan.il:9:1: warning: the pin 'the-pump-of-the-coolant-behind-the-door-on-the-left' would have "
                        "a name of 55 characters with the program's, and LinuxCNC's HAL takes 47: it is called 'q0'"));
  EXPECT_THAT(ran.errors,
              HasSubstr("fan.il:12:1: warning: 'Q1' has the pin 'pump-on' already: this one is called 'q2'"));
  EXPECT_THAT(ran.errors, HasSubstr("plcxx-35"));
  const std::string hal = work.Read("out/fan.hal");
  for (const char* line : {"net q0 <= fan.q0\n", "net pump-on <= fan.pump-on\n", "net q2 <= fan.q2\n"})
    EXPECT_THAT(hal, HasSubstr(line));
}

TEST(HalModuleNames, AProgramWhoseNameLeavesNoRoomIsRefused) {
  const driver::Workplace work;
  work.Write("fan.plc", "$\nU4A0=I0A0\n");
  const std::string name(47, 'n');
  const driver::Ran ran = work.Run("emit fan.plc -o out --host linuxcnc --name " + name);
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("plcxx-36"));
  EXPECT_THAT(ran.errors, HasSubstr("would have a name of 52 characters, and LinuxCNC's HAL takes 47"));
  EXPECT_FALSE(work.Has("out"));
}

TEST(HostOption, IsOneOfTheTable) {
  const driver::Workplace work;
  work.Write("fan.plc", "$\nU4A0=I0A0\n");
  const driver::Ran ran = work.Run("emit fan.plc -o out --host windows");
  EXPECT_EQ(ran.code, 2);
  EXPECT_THAT(ran.errors, HasSubstr("windows"));
  EXPECT_EQ(work.Run("emit fan.plc -o own --host own -q").code, 0);
  EXPECT_FALSE(work.Has("own/fan_pins.hpp"));
}

TEST(HostOption, TheProjectSaysIt) {
  const driver::Workplace work;
  work.Write("fan.plc", "$\nU4A0=I0A0\n");
  work.Write("plcxx.yaml", "sources: fan.plc\nhost: posix\n");
  EXPECT_EQ(work.Run("emit -q").code, 0);
  EXPECT_TRUE(work.Has("generated/fan_posix.cpp"));
  EXPECT_EQ(work.Run("emit -q --host modbus -o other").code, 0);
  EXPECT_TRUE(work.Has("other/fan_modbus.cpp"));
}

}  // namespace
}  // namespace plcxx::host
