// plcxx build on the samples of all dialects: what is written, how, and what the figures say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/driver/run_plcxx.h"
#include "transpiler/compile/child_process.h"
#include "transpiler/compile/toolchain.h"

namespace plcxx::driver {
namespace {

using ::testing::AllOf;
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
        EXPECT_LE(partition.at("constant_bytes"), build.at("constant_bytes")) << partition;
        EXPECT_LE(partition.at("retentive_bytes"), build.at("retentive_bytes")) << partition;
        EXPECT_LE(partition.at("volatile_bytes"), build.at("volatile_bytes")) << partition;
        if (partition.at("name") == "init") {
          EXPECT_EQ(partition.at("volatile_bytes"), build.at("volatile_bytes"));
        }
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

TEST(Build, NamesTheProgramInItsObjects) {
  const Workplace work;
  work.Write("door.plc", "$\nU4A0=I0A0\n");
  work.Write("other.plc", "$\nU4A0=I0A1\n");
  for (const std::string target : {"host", "cortex-m4f", "rv32imac"}) {
    if (!IsInstalled(target)) continue;
    ASSERT_EQ(RunIn(work, ".", "build door.plc -q --target " + target + " -o out").code, 0) << target;
    const Ran same = RunIn(work, ".", "identify out/libdoor.a door.plc");
    EXPECT_EQ(same.code, 0) << target;
    EXPECT_THAT(same.errors, AllOf(HasSubstr("door\n"), HasSubstr("as here"), Not(HasSubstr("other")))) << target;
  }
  const Ran other = RunIn(work, ".", "identify out/libdoor.a other.plc --format json");
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.errors, AllOf(HasSubstr("\"sameSources\": false"), HasSubstr("\"sameOptions\": true")));
  const Ran options = RunIn(work, ".", "identify out/libdoor.a door.plc --set clo=20,4");
  EXPECT_EQ(options.code, 1);
  EXPECT_THAT(options.errors, HasSubstr("other options than here"));
  ASSERT_EQ(RunIn(work, ".", "build door.plc -q --target host --no-identity -o bare").code, 0);
  const Ran none = RunIn(work, ".", "identify bare/libdoor.a");
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.errors, HasSubstr("--no-identity"));
  EXPECT_EQ(work.Read("out/door.cpp"), work.Read("bare/door.cpp"));
}

/// A compiler that counts its calls for objects.
std::string CountingCompiler(const Workplace& work) {
  work.Write("counting-g++", "#!/bin/sh\ncase \"$*\" in *\" -c \"*) echo \"$*\" >> '" + work.Path("compiled") +
                                 "';; esac\nexec g++ \"$@\"\n");
  std::filesystem::permissions(work.Path("counting-g++"), std::filesystem::perms::owner_all);
  return " --compiler '" + work.Path("counting-g++") + "'";
}

/// How often it compiled since this was asked last.
size_t Compiled(const Workplace& work) {
  if (!work.Has("compiled")) return 0;
  const std::string lines = work.Read("compiled");
  std::filesystem::remove(work.Path("compiled"));
  return static_cast<size_t>(std::ranges::count(lines, '\n'));
}

TEST(Build, AnUnchangedSourceIsNotCompiledAgain) {
  const Workplace work;
  std::string text = "$\n";
  for (int i = 0; i < 3200; ++i)
    text += "U" + std::to_string(100 + i / 32) + "K" + std::to_string(i % 32) + " = I0A" + std::to_string(i % 8) + "\n";
  work.Write("p.plc", text);
  const std::string compiler = CountingCompiler(work);
  const auto build = [&](const std::string& more) {
    const Ran ran = RunIn(work, ".", "build p.plc -q --target host -o out" + more + compiler);
    EXPECT_EQ(ran.code, 0) << ran;
    return Compiled(work);
  };
  const size_t all = build("");
  EXPECT_GE(all, 3u);
  const Times before = TimesOf(work.Path("out"));
  EXPECT_EQ(build(""), 0u);
  EXPECT_EQ(TimesOf(work.Path("out")), before);

  const size_t edited = text.find("I0A3", text.size() / 2);
  text.replace(edited, 4, "I0A4");
  work.Write("p.plc", text);
  // The part that it is in, and p.cpp with the program's identity.
  EXPECT_EQ(build(""), 2u);
  text.replace(edited, 4, "I0A3");
  work.Write("p.plc", text);
  EXPECT_EQ(build(" --no-identity"), 2u) << "back, and without the identity";
  text.replace(edited, 4, "I0A4");
  work.Write("p.plc", text);
  EXPECT_EQ(build(" --no-identity"), 1u);
  EXPECT_EQ(build(" -O 1"), all);
  EXPECT_EQ(build(" -O 1"), 0u);

  // A compiler of another time is another compiler.
  const auto later = std::filesystem::last_write_time(work.Path("counting-g++")) + std::chrono::seconds(2);
  std::filesystem::last_write_time(work.Path("counting-g++"), later);
  EXPECT_EQ(build(" -O 1"), all);

  // Neither a library that somebody else wrote nor a record that is damaged is believed.
  const std::string library = work.Read("out/libp.a");
  work.Write("out/libp.a", "!<arch>\n");
  EXPECT_EQ(build(" -O 1"), all);
  EXPECT_EQ(work.Read("out/libp.a"), library);
  work.Write("out/libp.objects", "p.o\n\n0 0 p.o\n");
  EXPECT_EQ(build(" -O 1"), all);
  std::filesystem::remove(work.Path("out/libp.a"));
  EXPECT_EQ(build(" -O 1"), all);
  EXPECT_EQ(work.Read("out/libp.a"), library);
}

TEST(Build, EachSliceHasItsFigures) {
  const Workplace work;
  CopySample(work, kSamples[0]);
  const std::string command = "build " + std::string(kSamples[0].arguments) +
                              " --name sample --clock 1MHz -o ../out --target host --set slices=4 ";
  const Ran ran = RunIn(work, "sample", command);
  ASSERT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("\n    slice 3 "));
  const auto report = nlohmann::json::parse(work.Read("out/sample.report.json"));
  uint64_t fast = 0, slow = 0, period = 0, dearest = 0, sum = 0;
  for (const auto& partition : report.at("build").at("partitions")) {
    const uint64_t count = partition.at("instructions");
    if (partition.at("name") == "fast") fast = count;
    if (partition.at("name") == "period") period = count;
    if (partition.at("name") != "slow") continue;
    slow = count;
    ASSERT_EQ(partition.at("slices").size(), 4u);
    for (uint64_t i = 0; i < 4; ++i) {
      const auto& slice = partition.at("slices")[i];
      EXPECT_EQ(slice.at("slice"), i);
      EXPECT_GT(slice.at("cycles"), 0) << slice;
      EXPECT_LE(slice.at("stack_bytes"), partition.at("stack_bytes")) << slice;
      EXPECT_LT(slice.at("code_bytes"), partition.at("code_bytes")) << slice;
      EXPECT_TRUE(slice.at("not_whole").empty()) << slice;
      EXPECT_GT(slice.at("volatile_bytes"), 10) << slice;
      EXPECT_LT(slice.at("volatile_bytes"), partition.at("volatile_bytes")) << slice;
      dearest = std::max(dearest, slice.at("instructions").get<uint64_t>());
      sum += slice.at("instructions").get<uint64_t>();
    }
  }
  EXPECT_EQ(dearest, slow);
  EXPECT_LT(sum, 3 * slow);
  EXPECT_GT(period, fast + slow);
  // The statements that the error names are those of the slice.
  const Ran above = RunIn(work, "sample", command + "--max-slow-us 1000");
  EXPECT_EQ(above.code, 1) << above;
  EXPECT_THAT(above.errors, HasSubstr("partition 'slow, slice 0' takes "));
  EXPECT_THAT(above.errors, Not(HasSubstr("slice 2' takes ")));
}

// PROSTEP: the modules of the loop are the slices. HOST 50: the networks, in equal parts; where jumps lead from one
// slice to another, each may be as long as the whole.
TEST(Build, SlicesOfOtherLanguages) {
  const Workplace work;
  CopySample(work, kSamples[2]);
  const Ran mill =
      RunIn(work, "sample",
            "build " + std::string(kSamples[2].arguments) + " --target host -o ../mill --max-slow-us 1 --clock 1GHz");
  EXPECT_EQ(mill.code, 1);
  EXPECT_THAT(mill.errors, HasSubstr("\n    slice 7 "));
  EXPECT_THAT(mill.errors, HasSubstr("partition 'slow, slice 1' takes "));
  EXPECT_THAT(mill.errors, HasSubstr("loop.plc:"));
  const auto networks = [](const char* jump) {
    std::string text = "SLOWDIV 2\nOPTION SLICES=SLICED\nSLOW\n";
    for (int i = 0; i < 8; ++i) {
      const std::string number = std::to_string(i);
      text += "NETWORK \"n" + number + "\"\nLD %I" + number + "\nOUT %Q" + number + "\n" + (i == 1 ? jump : "");
    }
    return text + "END_SLOW\n";
  };
  work.Write("choice.il", networks(""));
  const Ran choice = RunIn(work, ".", "build choice.il --target host -o choice");
  EXPECT_EQ(choice.code, 0) << choice;
  EXPECT_THAT(choice.errors, HasSubstr("\n    slice 1 "));
  work.Write("joined.il", networks("LBL J7\n"));
  const Ran joined = RunIn(work, ".", "build joined.il --target host -o joined");
  EXPECT_EQ(joined.code, 0) << joined;
  EXPECT_THAT(joined.errors, HasSubstr("slow: jumps lead from slice to slice"));
}

/// "12.2" of a compiler's first line.
bool IsGccOfTheGuide(const std::string& target) {
  const auto found = compile::FindToolchain(*compile::FindTarget(target), "");
  const auto* toolchain = std::get_if<compile::Toolchain>(&found);
  return toolchain != nullptr && !toolchain->is_clang && toolchain->version.find(" 12.2.") != std::string::npos;
}

/// The table of docs/guide.md: `target` and the numbers of its columns, without what is not a digit.
std::map<std::string, std::vector<uint64_t>> GuideTable() {
  std::map<std::string, std::vector<uint64_t>> table;
  std::ifstream guide(std::string(PLCXX_ROOT) + "/docs/guide.md");
  bool inside = false;
  for (std::string line; std::getline(guide, line);) {
    if (line.starts_with("| target | period: instructions | cycles | at 168 MHz | stack | code | volatile |"))
      inside = true;
    if (!line.starts_with("|")) inside = false;
    if (!inside || !line.starts_with("| `")) continue;
    std::istringstream cells(line.substr(line.find('`', 3) + 1));
    std::vector<uint64_t>& numbers = table[line.substr(3, line.find('`', 3) - 3)];
    std::string cell;
    for (std::getline(cells, cell, '|'); std::getline(cells, cell, '|');) {
      std::erase_if(cell, [](char letter) { return letter < '0' || letter > '9'; });
      numbers.push_back(std::stoull(cell));
    }
  }
  return table;
}

TEST(Build, TheTableOfTheGuideIsCurrent) {
  const auto table = GuideTable();
  EXPECT_EQ(table.size(), 4u);
  for (const auto& [target, numbers] : table) {
    SCOPED_TRACE(target);
    ASSERT_EQ(numbers.size(), 6u);
    if (!IsGccOfTheGuide(target)) continue;
    const Workplace work;
    CopySample(work, kSamples[0]);
    const Ran ran = RunIn(
        work, "sample",
        "build lathe.sym fast.plc spindle.plc turret.plc --clock 168MHz --name sample -o ../out --target " + target);
    ASSERT_EQ(ran.code, 0) << ran;
    const auto report = nlohmann::json::parse(work.Read("out/sample.report.json"));
    const auto& build = report.at("build");
    const auto& parts = build.at("partitions");
    const auto period = std::ranges::find_if(parts, [](const auto& part) { return part.at("name") == "period"; });
    ASSERT_NE(period, parts.end());
    constexpr uint64_t kNsPerUs = 1000;
    const uint64_t us = (period->at("time_ns").template get<uint64_t>() + kNsPerUs / 2) / kNsPerUs;
    const std::vector<uint64_t> now = {period->at("instructions"), period->at("cycles"),   us,
                                       period->at("stack_bytes"),  build.at("code_bytes"), build.at("volatile_bytes")};
    for (size_t i = 0; i < now.size(); ++i)  // as good as the reader's trust: two of a hundred
      EXPECT_NEAR(static_cast<double>(numbers[i]), static_cast<double>(now[i]), 1 + static_cast<double>(now[i]) / 50);
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
  EXPECT_THAT(errors("--target host --clock 1MHz --max-fast-us -3"), HasSubstr("'-3' is no whole number"));
  EXPECT_THAT(errors("--target host --max-code 99999999999999999999"), HasSubstr("is no whole number"));
  EXPECT_THAT(errors("--target host --max-stack 1.5"), HasSubstr("'1.5' is no whole number"));
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

TEST(Build, ACompilerForOtherProcessorsIsNoFaultOfTheCode) {
  const Workplace work;
  work.Write("p.plc", kProgram);
  work.Write("g++-here", "#!/bin/sh\necho x86_64-linux-gnu\n");
  std::filesystem::permissions(work.Path("g++-here"), std::filesystem::perms::owner_all);
  const Ran ran = RunIn(work, ".", "build p.plc --target cortex-m4f --compiler ./g++-here -o out");
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.errors,
              HasSubstr("compiler './g++-here' makes code for x86_64-linux-gnu, not for target cortex-m4f"));
  EXPECT_THAT(ran.errors, HasSubstr("arm-none-eabi-g++"));
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
