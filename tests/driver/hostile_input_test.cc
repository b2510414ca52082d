// Scenarios and names that somebody else wrote: no hang, no file of another's, nothing that acts on the terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view kScenario = "dialect: nc110\nsources: [ok.plc]\nsteps:\n- run: {slow: 1}\n";

TEST(HostileInput, ScenariosThatHaveNoEnd) {
  const Workplace work;
  for (const char* text : {",", "{a: 1},\n", "\"x\",", "- a\n,", "steps: []\n]", "{a: 1}}", "[", "{", "*a", "&a *a"}) {
    work.Write("s.yaml", text);
    const Ran ran = work.Run("test s.yaml --engine sim");
    EXPECT_EQ(ran.code, 2) << text << "\n" << ran;
    EXPECT_THAT(ran.errors, HasSubstr("s.yaml:")) << text;
  }
  work.Write("s.yaml", "{a: 1},\n");
  EXPECT_THAT(work.Run("test s.yaml --engine sim").errors,
              HasSubstr("s.yaml:1:7: not YAML: ',' belongs to no list and no map: delete it"));
}

TEST(HostileInput, NoStatementOfAListingActsOnTheTerminal) {
  const Workplace work;
  work.Write("ok.plc", "U4A0\t=\fI0A0\f*\t\fI0A1\f");
  EXPECT_THAT(work.Run("report ok.plc --dialect nc110 --cost-listing").out,
              AllOf(HasSubstr("=<U+000C>I0A0"), Not(HasSubstr("\f"))));
}

TEST(HostileInput, NothingOfAScenarioActsOnTheTerminal) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  const std::string begin = "dialect: nc110\nsources: [ok.plc]\nsteps:\n";
  for (const std::string& steps :
       {begin + "- set: {\"\\e]0;title\\a\": 1}\n", begin + "- set: {\"\xE2\x80\xAE\": 1}\n",
        begin + "- run: {\"\\e[2J\": 1}\n", begin + "- \"\\x9b\": 1\n", begin + "- set: {I0A0: \"\\e[2J\"}\n",
        begin + "- \x1b]0;title\x07: 1\n", begin + "- set: {\xFF: 1}\n", begin + "- set: {\"\\\x01\": 1}\n"}) {
    work.Write("s.yaml", steps);
    const Ran ran = work.Run("test s.yaml --engine sim");
    EXPECT_EQ(ran.code, 2) << ran;
    for (const std::string& text : {ran.out, ran.errors}) {
      EXPECT_EQ(text.find_first_of("\x1b\x07\x01\xFF"), std::string::npos) << text;
      EXPECT_EQ(text.find("\xE2\x80\xAE"), std::string::npos) << text;
    }
  }
  work.Write("\x1b[31m.yaml", kScenario);
  EXPECT_THAT(work.Run("test . --engine sim").out, AllOf(HasSubstr("<U+001B>[31m"), Not(HasSubstr("\x1b"))));
  EXPECT_THAT(work.Run("check '\x1b[31m.plc'").errors, Not(HasSubstr("\x1b")));
}

TEST(HostileInput, AScenarioNamesFilesOfItsProjectOnly) {
  const Workplace work;
  std::filesystem::create_directories(work.Path("mine/tests"));
  work.Write("secret.plc", "TOP SECRET\n");
  work.Write("mine/ok.plc", kGoodProgram);
  work.Write("mine/tests/ok.yaml", "dialect: nc110\nsources: [../ok.plc]\nsteps:\n- run: {slow: 1}\n");
  std::filesystem::create_symlink(work.Path("secret.plc"), work.Path("mine/tests/link.plc"));
  for (const std::string& name : {std::string("../../secret.plc"), std::string("link.plc"), work.Path("secret.plc")}) {
    work.Write("mine/tests/s.yaml", "dialect: nc110\nsources: ['" + name + "']\nexpect_error: {line: 1}\n");
    const Ran refused = work.Run("test tests/s.yaml --engine sim", "", "", "mine");
    EXPECT_EQ(refused.code, 2) << refused;
    EXPECT_THAT(refused.errors, AllOf(HasSubstr("outside of the project"), Not(HasSubstr("SECRET"))));
    EXPECT_EQ(work.Run("test tests/s.yaml --engine sim --allow-outside", "", "", "mine").code, 0);
  }
  work.Write("mine/tests/s.yaml",
             "dialect: nc110\nsources: [../ok.plc]\noptions: {messages: /etc/passwd}\nsteps:\n- run: {slow: 1}\n");
  EXPECT_THAT(work.Run("test tests/s.yaml --engine sim", "", "", "mine").errors, HasSubstr("outside of the project"));
  EXPECT_EQ(work.Run("test tests/ok.yaml --engine sim", "", "", "mine").code, 0)
      << "the working directory is the project";
  std::filesystem::create_directory(work.Path("mine/.git"));
  EXPECT_EQ(work.Run("test mine/tests/ok.yaml --engine sim").code, 0);
  EXPECT_EQ(work.Run("test ok.yaml --engine sim", "", "", "mine/tests").code, 0) << "what is under version control";
}

TEST(HostileInput, NamesOfAnyScriptGiveFilesOfTheirOwn) {
  const Workplace work;
  std::set<std::string> names;
  for (const char* name : {"пила", "пыла", "锯", "举", "のこぎり", "saw"}) {
    work.Write(std::string(name) + ".plc", kGoodProgram);
    ASSERT_EQ(work.Run(std::string("emit ") + name + ".plc -o out").code, 0) << name;
  }
  for (const std::string& file : work.Files("out")) {
    if (file.ends_with(".hpp")) names.insert(file);
  }
  EXPECT_EQ(names.size(), 6u) << ::testing::PrintToString(names);
  EXPECT_TRUE(std::ranges::any_of(names, [](const std::string& name) { return name.starts_with("pila_"); }));
}

TEST(HostileInput, CallsThatDoubleEachOtherAreNotExecutedForEver) {
  const Workplace work;
  std::string program = ":MOD PM 1\n:JU PM 17\n:END PM 1\n:MOD PM 98\n:A I 0.0\n:= O 0.0\n:END PM 98\n";
  for (uint32_t i = 17; i < 98; ++i) {
    const std::string own = "PM " + std::to_string(i), next = ":JU PM " + std::to_string(i + 1) + "\n";
    program += ":MOD " + own + "\n" + next + next + ":END " + own + "\n";
  }
  work.Write("p.plc", program);
  work.Write("p.prop", "never O0.0\n");
  const Ran ran = work.Run("prove p.plc --dialect prostep --property p.prop --time 2s");
  EXPECT_EQ(ran.code, 2) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("the program executes more than 10000000 statements at a time"));
}

TEST(HostileInput, MessagesEnd) {
  const Workplace work;
  std::string text;
  for (int i = 0; i < 30'000; ++i) text += "U4A0=NOSUCH" + std::to_string(i) + "\n";
  work.Write("bad.plc", text);
  const auto errors = [](const std::string& shown) {
    size_t count = 0;
    for (size_t at = shown.find(": error: "); at != std::string::npos; at = shown.find(": error: ", at + 1)) ++count;
    return count;
  };
  const Ran usual = work.Run("check bad.plc");
  EXPECT_EQ(errors(usual.errors), 100u);
  EXPECT_THAT(usual.errors, HasSubstr("29900 more not shown; see --max-messages\n30000 errors, 1 warning"));
  EXPECT_EQ(errors(work.Run("check bad.plc --max-messages 3").errors), 3u);
  EXPECT_EQ(errors(work.Run("check bad.plc --max-messages 0").errors), 20'000u) << "what is kept at all";
}

TEST(HostileInput, AKilledProcessLeavesNothingForLong) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  std::filesystem::create_directory(work.Path("out"));
  const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
  for (const char* name :
       {"out/.ok.cpp.99999999.new", "out/.ok.cpp.99999998.old", "out/.ok.cpp.1.new", "out/.ok.cpp.x.new"}) {
    std::filesystem::last_write_time(work.Write(name, "half"), old);
  }
  work.Write("out/.ok.cpp.99999997.new", "young");
  ASSERT_EQ(work.Run("emit ok.plc -o out").code, 0);
  EXPECT_FALSE(work.Has("out/.ok.cpp.99999999.new"));
  EXPECT_FALSE(work.Has("out/.ok.cpp.99999998.old"));
  EXPECT_TRUE(work.Has("out/.ok.cpp.1.new")) << "its process is there";
  EXPECT_TRUE(work.Has("out/.ok.cpp.x.new")) << "none of ours";
  EXPECT_TRUE(work.Has("out/.ok.cpp.99999997.new")) << "may be another machine's";
}

TEST(HostileInput, RulesOfMakeHaveNoLineEnds) {
  const Workplace work;
  work.Write("a\nb.plc", kGoodProgram);
  const Ran ran = work.Run("emit $'a\\nb.plc' -o out --depfile out/a.d");
  EXPECT_NE(ran.code, 0) << ran;
  EXPECT_FALSE(work.Has("out/a.d"));
}

}  // namespace
}  // namespace plcxx::driver
