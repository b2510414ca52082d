// plcxx build on the samples of all dialects: what is written, how, and what the figures say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/driver/run_plcxx.h"
#include "transpiler/compile/child_process.h"
#include "transpiler/compile/toolchain.h"

namespace plcxx::driver {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

struct Sample {
  const char* folder;  // below samples/
  const char* arguments;
  const char* entry;  // a partition that runs
};
constexpr Sample kSamples[] = {
    {"nc110/lathe_16k20", "lathe.sym fast.plc spindle.plc turret.plc --set iocfil=IOCFIL --set axcfil=AXCFIL", "slow"},
    {"host50/ck6150", "ck6150.il texts.il fast.il main.il spindle.il turret.il units.il mcodes.il", "slow"},
    {"prostep/mill_fnd32", "mill.plc texts.plc fast.plc loop.plc magazine.plc", "slow"},
    {"technol/mcv_750", "mcv.plc main.plc nc.plc vymena.plc vypnuti.plc TAB_MCV.TCH", "slow"},
    {"hnc/mill_xk7132", "mill.cld", "fast"},
};

bool IsInstalled(const std::string& target) {
  const auto found = compile::FindToolchain(*compile::FindTarget(target), "");
  if (const auto* missing = std::get_if<compile::MissingTool>(&found)) {
    std::cerr << "skipped " << target << ": " << missing->command << " is not there\n";
    return false;
  }
  return true;
}

/// Without the limit of memory that other commands keep to: compilers and LLVM's libraries reserve more.
Ran RunIn(const Workplace& work, const std::string& folder, const std::string& arguments) {
  const compile::ProcessResult result =
      compile::RunProcess({"sh", "-c", PLCXX_BINARY " " + arguments}, 120, work.Path(folder));
  return {result.exit_code, "", result.output};
}

/// The tool's own copy of a sample, so that nothing is written beside the sources.
void CopySample(const Workplace& work, const Sample& sample) {
  std::filesystem::copy(std::string(PLCXX_ROOT) + "/samples/" + sample.folder, work.Path("sample"),
                        std::filesystem::copy_options::recursive);
}

using Times = std::map<std::string, std::filesystem::file_time_type>;
Times TimesOf(const std::string& folder) {
  Times times;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) times[entry.path().string()] = entry.last_write_time();
  }
  return times;
}

TEST(Build, SamplesOfAllDialects) {
  for (const std::string target : {"host", "cortex-m4f", "rv32imac"}) {
    if (!IsInstalled(target)) continue;
    for (const Sample& sample : kSamples) {
      SCOPED_TRACE(std::string(sample.folder) + " for " + target);
      const Workplace work;
      CopySample(work, sample);
      const Ran ran = RunIn(
          work, "sample",
          "build " + std::string(sample.arguments) + " --name sample --clock 100MHz -o ../out --target " + target);
      ASSERT_EQ(ran.code, 0) << ran;
      EXPECT_THAT(ran.errors, HasSubstr("longest path"));
      EXPECT_TRUE(work.Has("out/libsample.a"));
      EXPECT_TRUE(work.Has("out/sample.hpp"));
      EXPECT_TRUE(work.Has("out/plcxx/state.h"));
      const auto report = nlohmann::json::parse(work.Read("out/sample.report.json"));
      const auto& build = report.at("build");
      EXPECT_EQ(build.at("target"), target);
      EXPECT_GT(build.at("code_bytes"), 1000);
      EXPECT_GT(build.at("retentive_bytes").get<int>() + build.at("volatile_bytes").get<int>(), 100);
      bool runs = false;
      for (const auto& partition : build.at("partitions")) {
        EXPECT_GT(partition.at("instructions"), 0) << partition;
        EXPECT_GT(partition.at("cycles"), 0) << partition;
        EXPECT_GT(partition.at("code_bytes"), 0) << partition;
        const bool whole_ns = partition.at("time_ns") == partition.at("cycles").get<uint64_t>() * 10;
        EXPECT_TRUE(whole_ns) << partition;
        EXPECT_TRUE(partition.at("not_whole").empty()) << partition;
        if (partition.at("name") != sample.entry) continue;
        runs = true;
        EXPECT_GT(partition.at("instructions"), 300) << partition;
        EXPECT_GT(partition.at("stack_bytes"), 0) << partition;
      }
      EXPECT_TRUE(runs);
    }
  }
}

TEST(Build, TheSameAgainWritesNothing) {
  const Workplace work;
  CopySample(work, kSamples[0]);
  const std::string command = "build " + std::string(kSamples[0].arguments) + " -q --target host -o ";
  ASSERT_EQ(RunIn(work, "sample", command + "../out").code, 0);
  const Times before = TimesOf(work.Path("out"));
  ASSERT_EQ(RunIn(work, "sample", command + "../out").code, 0);
  EXPECT_EQ(TimesOf(work.Path("out")), before);
  // Elsewhere the same bytes: no path is in objects and archive.
  ASSERT_EQ(RunIn(work, "sample", command + "'" + work.Path("elsewhere/deeper") + "' -j 1").code, 0);
  for (const auto& [path, time] : before) {
    const std::string name = std::filesystem::relative(path, work.Path("out")).string();
    EXPECT_EQ(work.Read("out/" + name), work.Read("elsewhere/deeper/" + name)) << name;
  }
}

TEST(Build, ClangTakesThePlaceOfGcc) {
  const auto clang = compile::FindToolchain(*compile::FindTarget("rv32imac"), "clang++-19");
  if (std::holds_alternative<compile::MissingTool>(clang)) GTEST_SKIP() << "clang++-19 is not there";
  const Workplace work;
  CopySample(work, kSamples[0]);
  for (const std::string target : {"host", "cortex-m0plus", "cortex-m4f", "rv32imac", "rv64gc"}) {
    const Ran ran = RunIn(
        work, "sample",
        "build " + std::string(kSamples[0].arguments) + " -q --compiler clang++-19 -O s -o ../out --target " + target);
    EXPECT_EQ(ran.code, 0) << target << ran;
  }
}

constexpr const char* kProgram = "U0A0 = I0A0*I0A1\n$\nU0A1 = I0A2 + I0A3\n";

TEST(Build, WrongUseIsToldBeforeAnythingIsDone) {
  const Workplace work;
  work.Write("p.plc", kProgram);
  const auto errors = [&](const std::string& arguments) {
    const Ran ran = RunIn(work, ".", "build p.plc " + arguments);
    EXPECT_EQ(ran.code, 2) << arguments << ran;
    return ran.errors;
  };
  EXPECT_THAT(errors(""), HasSubstr("build needs a target: --target host, cortex-m0plus"));
  EXPECT_THAT(errors("--target z80"), HasSubstr("'z80' is no target"));
  EXPECT_THAT(errors("--target host --clock fast"), HasSubstr("'--clock fast' is no frequency"));
  EXPECT_THAT(errors("--target host --max-fast-us 5"), HasSubstr("needs the processor's clock"));
  EXPECT_THAT(errors("--target host --max-code 5 --no-audit"), HasSubstr("--no-audit leaves out"));
  EXPECT_THAT(errors("--target host -O 7"), HasSubstr("error"));
  EXPECT_THAT(work.Files("."), Not(Contains("plcxx")));
}

TEST(Build, AMissingCompilerIsNamedWithItsPackage) {
  const Workplace work;
  work.Write("p.plc", kProgram);
  const Ran ran = RunIn(work, ".", "build p.plc --target cortex-m4f --compiler no-such-g++ -o out");
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.errors, HasSubstr("compiler 'no-such-g++' cannot be run [plcxx-10]"));
  EXPECT_THAT(ran.errors, HasSubstr("gcc-arm-none-eabi"));
  EXPECT_THAT(ran.errors, HasSubstr("--compiler"));
  EXPECT_FALSE(work.Has("out"));
}

TEST(Build, ACompilerThatRefusesLeavesNothing) {
  const Workplace work;
  work.Write("p.plc", kProgram);
  const Ran ran = RunIn(work, ".", "build p.plc --target host --compiler 'g++ -DState=' -o out");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("[plcxx-11]"));
  EXPECT_FALSE(work.Has("out"));
}

TEST(Build, LimitsNameTheCostliestStatements) {
  const Workplace work;
  CopySample(work, kSamples[0]);
  const std::string command = "build " + std::string(kSamples[0].arguments) + " --target host -o ../out --clock 1MHz ";
  const Ran above = RunIn(work, "sample", command + "--max-fast-us 10 --max-slow-us 20 --max-stack 16 --max-code 100");
  EXPECT_EQ(above.code, 1) << above;
  EXPECT_THAT(above.errors, HasSubstr("fast.plc:"));
  EXPECT_THAT(above.errors, HasSubstr("partition 'fast' takes "));
  EXPECT_THAT(above.errors, HasSubstr("partition 'slow' takes "));
  EXPECT_THAT(above.errors, HasSubstr("the stack of partition 'slow' takes "));
  EXPECT_THAT(above.errors, HasSubstr("the code takes "));
  EXPECT_THAT(above.errors, HasSubstr("note: costly, too"));
  EXPECT_FALSE(work.Has("out"));
  const Ran below =
      RunIn(work, "sample", command + "--max-fast-us 9000 --max-slow-us 90000 --max-stack 9000 --max-code 900000");
  EXPECT_EQ(below.code, 0) << below;
}

TEST(Build, WithoutAuditThereAreNoFigures) {
  const Workplace work;
  work.Write("p.plc", kProgram);
  const Ran ran = RunIn(work, ".", "build p.plc --target host --no-audit -o out");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_TRUE(work.Has("out/libp.a"));
  EXPECT_THAT(work.Read("out/p.report.json"), Not(HasSubstr("\"build\"")));
}

TEST(Build, TheDebugFlavourToo) {
  const Workplace work;
  CopySample(work, kSamples[2]);
  const Ran ran =
      RunIn(work, "sample", "build " + std::string(kSamples[2].arguments) + " -q --debug --target host -o ../out");
  EXPECT_EQ(ran.code, 0) << ran;
}

}  // namespace
}  // namespace plcxx::driver
