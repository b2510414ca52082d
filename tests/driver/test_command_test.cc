// `plcxx test` as its users see it: exit codes, output, JUnit, waveforms.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/compile/child_process.h"

namespace plcxx::driver {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

constexpr int kSeconds = 120;

/// A folder with a program and scenarios; the tool runs in it.
class TestCommand : public testing::Test {
 protected:
  TestCommand() {
    Write("coil.plc", "$\nU4A8=I0A3*/I0A4\n");
    Write("good.yaml", Scenario("- set: {I0A3: 1}\n- run: {slow: 1}\n- expect: {U4A8: 1}\n"));
    Write("wrong.yaml", Scenario("- run: {slow: 2}\n- expect: {U4A8: 1}\n"));
  }

  static std::string Scenario(const std::string& steps) {
    return "dialect: nc110\nsources: [coil.plc]\nsteps:\n" + steps;
  }

  void Write(const std::string& name, const std::string& text) const {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name, std::ios::binary) << text;
  }
  std::string Read(const std::string& name) const {
    std::ifstream in(root_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  compile::ProcessResult Run(const std::string& arguments) const {
    return compile::RunProcess({"sh", "-c", "cd '" + root_.string() + "' && '" PLCXX_BINARY "' test " + arguments},
                               kSeconds);
  }

  compile::TemporaryDirectory directory_;
  fs::path root_ = directory_.path();
};

// Its program with its options; what the run's own scenario sets counts more.
TEST_F(TestCommand, SourcesMayBeAScenario) {
  Write("sub/program.yaml",
        "dialect: nc110\noptions: {clo: [20, 2], tim: 4}\nsources:\n  own.plc: |\n    $\n    T48I(W5K0)=I0A3\n"
        "    U4A8=T48U\nsteps:\n- run: {slow: 1}\n");
  Write("steps.yaml",
        "dialect: nc110\noptions: {tim: 5}\nsteps:\n- set: {W5K0: 10, I0A3: 1}\n- run: {ms: 60}\n- expect: {U4A8: 0}\n"
        "- run: {ms: 1}\n- expect: {U4A8: 1}\n");
  const compile::ProcessResult ran = Run("steps.yaml --engine sim --sources sub/program.yaml");
  EXPECT_EQ(ran.exit_code, 0) << ran.output;
  const compile::ProcessResult without = Run("steps.yaml --engine sim --sources steps.yaml");
  EXPECT_EQ(without.exit_code, 2) << without.output;
  EXPECT_THAT(without.output, HasSubstr("the scenario names no program"));
}

TEST_F(TestCommand, AScenarioThatPasses) {
  const compile::ProcessResult simulated = Run("good.yaml --engine sim --verbose");
  EXPECT_EQ(simulated.exit_code, 0);
  EXPECT_EQ(simulated.output, "passed  good.yaml  (3 steps in simulator)\n1 scenario passed\n");
  const compile::ProcessResult both = Run("good.yaml --verbose");
  EXPECT_EQ(both.exit_code, 0) << both.output;
  EXPECT_THAT(both.output, HasSubstr("(3 steps in simulator and compiled)"));
  EXPECT_THAT(Run("good.yaml --engine host --verbose").output, HasSubstr("(3 steps in compiled)"));
}

TEST_F(TestCommand, EnginesByTheirNames) {
  EXPECT_THAT(Run("good.yaml --engine cobol").output,
              HasSubstr("there is no engine 'cobol'; there are: sim, host, all, "));
  EXPECT_EQ(Run("good.yaml --engine cobol").exit_code, 2);
  EXPECT_THAT(Run("good.yaml --engine hal").output,
              HasSubstr("runs in LinuxCNC (dev/install linuxcnc) by tests/host/linuxcnc.py"));
  EXPECT_THAT(Run("good.yaml --engine classicladder").output, HasSubstr("by tests/judges/classicladder/run.py"));
  EXPECT_EQ(Run("good.yaml --engine sim,").exit_code, 2);
  EXPECT_THAT(Run("good.yaml --engine host/0").output, HasSubstr("a whole number from 1 on stands behind '/'"));
  EXPECT_THAT(Run("good.yaml --engine host,sim,host --verbose").output,
              HasSubstr("(3 steps in simulator and compiled)"));
  // One in so many that it is none of them; unless all are asked for.
  EXPECT_THAT(Run("good.yaml --engine all/4000000000 --verbose").output, HasSubstr("(3 steps in simulator)"));
  EXPECT_THAT(compile::RunProcess({"sh", "-c",
                                   "cd '" + root_.string() +
                                       "' && PLCXX_ALL_TARGETS=1 '" PLCXX_BINARY
                                       "' test good.yaml --engine sim,host/4000000000 --verbose"},
                                  kSeconds)
                  .output,
              HasSubstr("(3 steps in simulator and compiled)"));
}

TEST_F(TestCommand, EmulatedMachines) {
  for (const auto& [command, machines] :
       {std::pair<std::string, std::string>("arm-none-eabi-g++ --version && qemu-system-arm", "cortex-m,cortex-m7"),
        {"riscv64-unknown-elf-g++ --version && qemu-system-riscv32", "riscv,riscv64"}}) {
    const std::string engines = "good.yaml --verbose --engine " + machines;
    if (compile::RunProcess({"sh", "-c", command + " --version"}, kSeconds).exit_code != 0) {
      EXPECT_THAT(Run(engines).output, HasSubstr(": install "));
      continue;
    }
    const std::string first = machines.substr(0, machines.find(',')), second = machines.substr(machines.find(',') + 1);
    EXPECT_THAT(Run(engines).output, HasSubstr("(3 steps in simulator and " + first + " and " + second + ")"));
    EXPECT_THAT(Run("wrong.yaml --engine " + first).output, HasSubstr("U4A8"));
  }
  const compile::ProcessResult missing = compile::RunProcess(
      {"sh", "-c", "cd '" + root_.string() + "' && PATH=/nowhere '" PLCXX_BINARY "' test good.yaml --engine cortex-m"},
      kSeconds);
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.output, HasSubstr("engine 'cortex-m' needs 'arm-none-eabi-g++': install gcc-arm-none-eabi"));
}

TEST_F(TestCommand, AScenarioThatFails) {
  const compile::ProcessResult result = Run("good.yaml wrong.yaml --engine sim");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.output,
            "passed  good.yaml\n"
            "FAILED  wrong.yaml\n"
            "wrong.yaml:5:12: step 2 (expect), at 20 ms: expected U4A8 = 1, found 0\n"
            "  last writes to U4A8, newest first:\n"
            "    value 0 from 0 ms to 10 ms: coil.plc:2:1: U4A8=I0A3*/I0A4\n"
            "  why:\n"
            "    U4A8 is 0 at 10 ms: coil.plc:2:1: U4A8=I0A3*/I0A4\n"
            "      I0A3 is 0: as at power-on\n"
            "1 scenario passed, 1 failed\n");
  EXPECT_THAT(Run("wrong.yaml --engine host").output, HasSubstr("only the simulator keeps a record"));
}

TEST_F(TestCommand, AScenarioThatCannotBeRun) {
  Write("unknown.yaml", Scenario("- wait: 3\n"));
  const compile::ProcessResult result = Run("good.yaml unknown.yaml nowhere.yaml wrong.yaml --engine sim");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.output, HasSubstr("unknown.yaml:4:3: 'wait' is no step"));
  EXPECT_THAT(result.output, HasSubstr("nowhere.yaml: there is no such file"));
  EXPECT_THAT(result.output, HasSubstr("1 scenario passed, 1 failed, 2 cannot be run"));
  Write("location.yaml", Scenario("- set: {Z9: 1}\n"));
  const compile::ProcessResult location = Run("location.yaml --engine sim");
  EXPECT_EQ(location.exit_code, 2);
  EXPECT_THAT(location.output, HasSubstr("location.yaml:4:9: 'Z9' is no location of dialect nc110"));
  Write("sources.yaml", "steps: []\n");
  EXPECT_THAT(Run("sources.yaml --engine sim").output, HasSubstr("no 'sources'"));
  EXPECT_EQ(Run("sources.yaml --engine sim --sources coil.plc").exit_code, 0);
}

TEST_F(TestCommand, AProgramWithErrorsFailsAndShowsThem) {
  Write("broken.plc", "$\nU4A8=\n");
  Write("broken.yaml", "dialect: nc110\nsources: [broken.plc]\nsteps: []\n");
  const compile::ProcessResult result = Run("broken.yaml --engine sim");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("broken.yaml: the program has errors\nbroken.plc:2:"));
  Write("expected_bad.yaml", "dialect: nc110\nsources: [broken.plc]\nexpect_error: {line: 2}\n");
  EXPECT_EQ(Run("expected_bad.yaml --engine sim").exit_code, 0);
}

TEST_F(TestCommand, DirectoriesAreSearchedInOrder) {
  Write("sub/b/coil.plc", "$\nU4A8=I0A3\n");
  Write("sub/b/z.yaml", "sources: [coil.plc]\nsteps: []\n");
  Write("sub/b/a.yaml", "sources: [coil.plc]\nsteps: []\n");
  Write("sub/a.txt", "not a scenario");
  EXPECT_EQ(Run("sub --engine sim --jobs 4").output,
            "passed  sub/b/a.yaml\npassed  sub/b/z.yaml\n2 scenarios passed\n");
  Write("empty/readme", "");
  const compile::ProcessResult empty = Run("empty");
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_THAT(empty.output, HasSubstr("there is no scenario (*.yaml) in directory 'empty'"));
}

TEST_F(TestCommand, ResultsForBuildServers) {
  EXPECT_EQ(Run("good.yaml wrong.yaml --engine sim --junit out/result.xml").exit_code, 1);
  const std::string xml = Read("out/result.xml");
  EXPECT_THAT(xml, HasSubstr("tests=\"2\" failures=\"1\" errors=\"0\""));
  EXPECT_THAT(
      xml, HasSubstr("<failure message=\"wrong.yaml:5:12: step 2 (expect), at 20 ms: expected U4A8 = 1, found 0\">"));
  const compile::ProcessResult refused = Run("good.yaml --engine sim --junit good.yaml/result.xml");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, AllOf(HasSubstr("cannot write 'good.yaml/result.xml': not a directory; "),
                                    Not(HasSubstr("passed"))));  // it is told before anything runs
  EXPECT_EQ(Run("good.yaml --engine sim --junit good.yaml").exit_code, 2);
  EXPECT_THAT(Read("good.yaml"), HasSubstr("sources:"));
}

TEST_F(TestCommand, WaveformsHoldTheLocationsOfTheScenario) {
  EXPECT_EQ(Run("good.yaml --engine sim --vcd wave.vcd").exit_code, 0);
  const std::string wave = Read("wave.vcd");
  EXPECT_THAT(wave, HasSubstr("I0A3"));
  EXPECT_THAT(wave, HasSubstr("U4A8"));
  EXPECT_THAT(wave, Not(HasSubstr("I0A4")));
  EXPECT_EQ(Run("good.yaml wrong.yaml --vcd wave.vcd").exit_code, 2);
}

TEST_F(TestCommand, GeneratedCodeOfEachCompiler) {
  for (const char* compiler : {"g++", "clang++-19"}) {
    const compile::ProcessResult result = Run("good.yaml --engine host --cxx " + std::string(compiler));
    EXPECT_EQ(result.exit_code, 0) << result.output;
  }
}

TEST_F(TestCommand, WhatTheCompilerSaysIsShown) {
  const compile::ProcessResult result = Run("good.yaml --cxx false");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("good.yaml: 'false' cannot compile the generated code"));
  EXPECT_EQ(Run("good.yaml --engine fast").exit_code, 2);
}

TEST_F(TestCommand, ACompilerMayStandBehindALauncher) {
  EXPECT_EQ(Run("good.yaml --engine host --cxx 'env c++'").exit_code, 0);
  fs::create_directories(root_ / "a folder");
  Write("a folder/cxx", "#!/bin/sh\nexec c++ \"$@\"\n");
  fs::permissions(root_ / "a folder/cxx", fs::perms::owner_all);
  const compile::ProcessResult result = Run("good.yaml --engine host --cxx \"$PWD/a folder/cxx\"");
  EXPECT_EQ(result.exit_code, 0) << result.output;
}

TEST_F(TestCommand, AProgramThatCannotBeExecutedIsToldAsThat) {
  EXPECT_THAT(Run("good.yaml --cxx true").output, HasSubstr("'true' reported no error, and has made no program"));
  // As on a disk that is mounted noexec.
  Write("cxx", "#!/bin/sh\nwhile [ $# -gt 1 ]; do [ \"$1\" = -o ] && : > \"$2\"; shift; done\n");
  fs::permissions(root_ / "cxx", fs::perms::owner_all);
  EXPECT_THAT(Run("good.yaml --cxx ./cxx").output,
              testing::AllOf(HasSubstr("may not be executed: let TMPDIR name"), HasSubstr("noexec")));
}

TEST_F(TestCommand, WithoutARoomForTemporaryFilesItSaysWhere) {
  const compile::ProcessResult result =
      compile::RunProcess({"env", "TMPDIR=/nosuch", PLCXX_BINARY, "test", (root_ / "good.yaml").string()}, kSeconds);
  EXPECT_EQ(result.exit_code, 2) << result.output;
  EXPECT_THAT(result.output, HasSubstr("cannot write temporary files below '/nosuch': no such file or directory; let "
                                       "TMPDIR name a folder with room and rights"));
}

TEST_F(TestCommand, NoResultGoesOverWhatWasRead) {
  for (const std::string option : {"--junit coil.plc", "--vcd coil.plc", "--junit good.yaml"}) {
    const compile::ProcessResult result = Run("good.yaml --engine sim " + option);
    EXPECT_EQ(result.exit_code, 2) << option << result.output;
    EXPECT_THAT(result.output, HasSubstr("it is a source of this program")) << option;
    EXPECT_THAT(Read("coil.plc"), testing::StartsWith("$")) << option;
  }
}

TEST_F(TestCommand, OptionsOfTheCommandLineGiveWayToTheScenario) {
  const std::string steps = "sources: [coil.plc]\nsteps:\n- run: {slow: 1}\n- set: {I0A3: 1}\n- run: {slow: 1}\n";
  Write("plain.yaml", "dialect: nc110\n" + steps);
  EXPECT_EQ(Run("plain.yaml --engine sim --set cycle_ms=20 --vcd plain.vcd").exit_code, 0);
  EXPECT_THAT(Read("plain.vcd"), HasSubstr("#20\n"));
  Write("own.yaml", "dialect: nc110\noptions: {cycle_ms: 10}\n" + steps);
  EXPECT_EQ(Run("own.yaml --engine sim --set cycle_ms=20 --vcd own.vcd").exit_code, 0);
  EXPECT_THAT(Read("own.vcd"), HasSubstr("#10\n"));
  EXPECT_EQ(Run("plain.yaml --engine sim --set nonsense=1").exit_code, 2);
}

}  // namespace
}  // namespace plcxx::driver
