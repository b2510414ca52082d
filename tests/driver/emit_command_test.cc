// plcxx emit: which files, whole or not at all, the same bytes wherever and however it runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

TEST(EmitFiles, FourFilesByTheFirstLogicSource) {
  const Workplace work;
  work.Write("names.sym", "*\nCLAMP=U4A0\n");
  work.Write("tur-ret 1.plc", "!CLAMP=I0A0\n$\n");
  EXPECT_EQ(work.Run("emit names.sym 'tur-ret 1.plc' -o out/deep").code, 0);
  EXPECT_THAT(work.Files("out/deep"),
              UnorderedElementsAre("tur_ret_1.hpp", "tur_ret_1.cpp", "tur_ret_1.map.json", "tur_ret_1.report.json"));
  EXPECT_EQ(work.Run("emit names.sym 'tur-ret 1.plc' -o named --name mill").code, 0);
  EXPECT_THAT(work.Files("named"), UnorderedElementsAre("mill.hpp", "mill.cpp", "mill.map.json", "mill.report.json"));
}

// covers: NC110-215
TEST(EmitFiles, TheReportTellsWhatTheControlsCompilerTells) {
  const Workplace work;
  work.Write("main.plc", "U4A0=I0A0\n\nU4A2=I0A2\n$\nU4A1=I0A1\n");
  const Ran ran = work.Run("emit main.plc -o out --set slices=2 --set clo=20,2");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("5 lines, 3 statements"));
  EXPECT_THAT(ran.errors, HasSubstr("2 slices, period 40 ms"));
  const auto report = nlohmann::json::parse(work.Read("out/main.report.json"));
  EXPECT_EQ(report["lines"], 5);
  EXPECT_EQ(report["statements"], 3);
  EXPECT_EQ(report["warnings"], 0);
  EXPECT_EQ(report["errors"], 0);
  EXPECT_EQ(report["slices"], 2);
  EXPECT_EQ(report["slow_period_ms"], 40);
  ASSERT_EQ(report["partitions"].size(), 2u);
  for (const auto& partition : report["partitions"]) {
    EXPECT_GT(partition["time_us"], 0);
    EXPECT_GT(partition["code_bytes"], 0);
  }
  EXPECT_EQ(work.Run("emit main.plc -o out -q").errors, "");
}

// covers: NC110-216 NC110-254
TEST(EmitFiles, BudgetsAreErrorsOfTheFirstLine) {
  const Workplace work;
  std::string program;
  for (int i = 0; i < 600; ++i)
    program += "U" + std::to_string(100 + i / 32) + "K" + std::to_string(i % 32) + "=I0A0\n";
  work.Write("fast.plc", program + "$\n");
  const Ran fast = work.Run("emit fast.plc -o out --set fast-budget-us=1");
  EXPECT_EQ(fast.code, 1);
  EXPECT_THAT(fast.errors, HasSubstr("fast.plc:1:1: error"));
  EXPECT_THAT(fast.errors, HasSubstr("nc110-38"));
  const Ran code = work.Run("emit fast.plc -o out --set code-budget-kb=1");
  EXPECT_EQ(code.code, 1);
  EXPECT_THAT(code.errors, HasSubstr("nc110-NC105"));
  EXPECT_FALSE(work.Has("out"));
  EXPECT_EQ(work.Run("emit fast.plc -o out --set fast-budget-us=0 --set code-budget-kb=1000").code, 0);
}

// covers: NC110-231
TEST(EmitFiles, NothingIsWrittenForAProgramWithErrors) {
  const Workplace work;
  work.Write("bad.plc", kBadProgram);
  EXPECT_EQ(work.Run("emit bad.plc -o out --depfile bad.d").code, 1);
  EXPECT_FALSE(work.Has("out"));
  EXPECT_FALSE(work.Has("bad.d"));
}

TEST(EmitFiles, AnUnchangedFileKeepsItsTime) {
  const Workplace work;
  work.Write("main.plc", kGoodProgram);
  ASSERT_EQ(work.Run("emit main.plc -o out").code, 0);
  const auto old_time = fs::last_write_time(work.Path("out/main.hpp")) - std::chrono::hours(1);
  for (const char* name : {"out/main.hpp", "out/main.cpp"}) fs::last_write_time(work.Path(name), old_time);
  ASSERT_EQ(work.Run("emit main.plc -o out").code, 0);
  EXPECT_EQ(fs::last_write_time(work.Path("out/main.hpp")), old_time);
  EXPECT_EQ(fs::last_write_time(work.Path("out/main.cpp")), old_time);
  work.Write("main.plc", "U4A0=/I0A0\n$\nU4A1=I0A1\n");
  ASSERT_EQ(work.Run("emit main.plc -o out").code, 0);
  EXPECT_NE(fs::last_write_time(work.Path("out/main.cpp")), old_time);
}

TEST(EmitFiles, WholeOrNotAtAll) {
  const Workplace work;
  work.Write("main.plc", kGoodProgram);
  fs::create_directory(work.Path("out"));
  work.Write("out/main.hpp", "old");
  fs::create_directory(work.Path("out/main.map.json"));  // in the way
  const Ran ran = work.Run("emit main.plc -o out");
  EXPECT_EQ(ran.code, 2) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("cannot write 'out/main.map.json'"));
  EXPECT_THAT(ran.errors, HasSubstr("nc110-60"));
  EXPECT_EQ(work.Read("out/main.hpp"), "old");
  EXPECT_THAT(work.Files("out"), UnorderedElementsAre("main.hpp", "main.map.json"));
}

TEST(EmitFiles, ADirectoryThatCannotBeMade) {
  const Workplace work;
  work.Write("main.plc", kGoodProgram);
  work.Write("taken", "");
  for (const std::string directory : {"taken", "taken/x", "main.plc/", "main.plc/x"}) {
    const Ran ran = work.Run("emit main.plc --name m -o " + directory);
    EXPECT_EQ(ran.code, 2) << ran;
    EXPECT_THAT(ran.errors, HasSubstr("cannot write"));
  }
  // The directories made on the way are gone again.
  const Ran ran = work.Run("emit main.plc -o new/deep --depfile main.plc/main.d");
  EXPECT_EQ(ran.code, 2) << ran;
  EXPECT_FALSE(work.Has("new"));
}

TEST(EmitFiles, ASourceIsNeverOverwritten) {
  const Workplace work;
  work.Write("main.cpp", kGoodProgram);
  const Ran ran = work.Run("emit main.cpp --dialect nc110");
  EXPECT_EQ(ran.code, 2) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("source of this program"));
  EXPECT_EQ(work.Read("main.cpp"), kGoodProgram);
}

TEST(EmitFiles, DependencyFileNamesAllThatWasRead) {
  const Workplace work;
  work.Write("a b.plc", kGoodProgram);
  work.Write("texts", "15#hello\n");
  ASSERT_EQ(work.Run("emit 'a b.plc' --name m -o out --set messages=texts --depfile m.d").code, 0);
  EXPECT_EQ(work.Read("m.d"), "out/m.hpp out/m.cpp out/m.map.json out/m.report.json: \\\n  a\\ b.plc \\\n  texts\n");
}

/// All four files of one run as one text.
std::string Emitted(const Workplace& work, const std::string& directory) {
  std::string text;
  for (const char* suffix : {".hpp", ".cpp", ".map.json", ".report.json"})
    text += work.Read(directory + "/main" + suffix);
  return text;
}

/// So many statements of one signal each, and one more in front of statement `before`.
std::string ManyStatements(int count, int before = -1) {
  std::string text = "$\n";
  for (int i = 0; i < count; ++i) {
    if (i == before) text += "U4A20=I0A9*/I0A8\n";
    text += "U" + std::to_string(100 + i / 32) + "K" + std::to_string(i % 32) + "=I0A" + std::to_string(i % 32) + "+U" +
            std::to_string(100 + (i * 7 % count) / 32) + "K" + std::to_string(i * 7 % count % 32) + "\n";
  }
  return text;
}

TEST(EmitFiles, AsManyPartsAsTheBuildSystemExpects) {
  const Workplace place;
  place.Write("few.plc", "$\nU4A0=I0A0\n");
  const Ran few = place.Run("emit few.plc --parts 3 -o few -q");
  EXPECT_EQ(few.code, 0) << few;
  EXPECT_THAT(place.Files("few"),
              UnorderedElementsAre("few.hpp", "few.cpp", "few_2.cpp", "few_3.cpp", "few.map.json", "few.report.json"));

  place.Write("many.plc", ManyStatements(1200));
  fs::create_directories(place.Path("edited"));
  place.Write("edited/many.plc", ManyStatements(1200, 700));
  ASSERT_EQ(place.Run("emit many.plc --parts 4 -o a -q").code, 0);
  ASSERT_EQ(place.Run("emit edited/many.plc --parts 4 -o b -q").code, 0);
  int changed = 0;
  size_t statements = 0;
  for (const char* name : {"many.cpp", "many_2.cpp", "many_3.cpp", "many_4.cpp"}) {
    const std::string before = place.Read(std::string("a/") + name);
    changed += before != place.Read(std::string("b/") + name) ? 1 : 0;
    const auto own = static_cast<size_t>(std::ranges::count(before, '|'));
    EXPECT_GE(own, 50u) << name;
    statements += own;
  }
  EXPECT_EQ(statements, 1200u);
  EXPECT_EQ(changed, 1) << "an inserted statement is in one file";

  EXPECT_EQ(place.Run("emit few.plc --parts 65").code, 2);
  EXPECT_EQ(place.Run("emit few.plc --parts 0").code, 2);
  EXPECT_EQ(place.Run("emit few.plc --parts 2 --single-file").code, 2);
}

TEST(EmitFiles, OneFileIsCompleteInItself) {
  const Workplace place;
  place.Write("first.plc", "$\nU4A0=I0A0\n");
  place.Write("second-machine.plc", "$\nT1I(5)=I0A0\nU4A0=T1U\n");
  ASSERT_EQ(place.Run("emit first.plc --single-file -q").code, 0);
  ASSERT_EQ(place.Run("emit second-machine.plc --single-file -q").code, 0);
  EXPECT_FALSE(place.Has("first.cpp"));
  EXPECT_THAT(place.Read("second_machine.hpp"), HasSubstr("#ifdef SECOND_MACHINE_IMPLEMENTATION\n"));
  EXPECT_THAT(place.Read("first.hpp"), Not(HasSubstr("#include <plcxx/")));
}

TEST(EmitFiles, TheSameBytesFromEveryPlace) {
  const Workplace work;
  fs::create_directories(work.Path("some/where"));
  const std::string program =
      "; \xD0\xB7\xD0\xB0\xD0\xB6\xD0\xB8\xD0\xBC\nU4A0=I0A0*[W3K0=33H]\nT5I(30)=U4A0\n$\nU4A1=T5U\n";
  work.Write("main.plc", program);
  work.Write("some/where/main.plc", program);
  ASSERT_EQ(work.Run("emit main.plc -o a").code, 0);
  const std::string expected = Emitted(work, "a");
  ASSERT_FALSE(expected.empty());
  ASSERT_EQ(work.Run("emit '" + work.Path("main.plc") + "' -o b").code, 0);
  EXPECT_EQ(Emitted(work, "b"), expected);
  ASSERT_EQ(work.Run("emit ./some/../main.plc -o c", "", "LC_ALL=ru_RU.UTF-8 LANG=tr_TR TZ=Asia/Tokyo").code, 0);
  EXPECT_EQ(Emitted(work, "c"), expected);
  ASSERT_EQ(work.Run("emit main.plc -o ../../d", "", "-i LC_ALL=C", "some/where").code, 0);
  EXPECT_EQ(Emitted(work, "d"), expected);
}

}  // namespace
}  // namespace plcxx::driver
