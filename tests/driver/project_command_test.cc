// plcxx.yaml on the command line: which program a command is about, and where what it names is looked for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

/// A lathe with an option that its program needs, a scenario without sources, and a folder below.
/// The exit code of git in the folder.
int Git(const Workplace& work, const std::string& words) {
  const std::string command =
      "cd '" + work.Path(".") + "' && git -c user.name=t -c user.email=t " + words + " >git.log 2>&1";
  return std::system(command.c_str());
}

class ProjectCommand : public ::testing::Test {
 protected:
  ProjectCommand() {
    work_.Write("lathe.plc", "U4A0=I0A0\n$\nU4A1=I0A1\n");
    work_.Write("plcxx.yaml", "name: saw\ndialect: nc110\nsources: lathe.plc\noptions: {clo: [20, 2]}\n");
    work_.Write("s.yaml", "steps:\n- set: {I0A0: 1}\n- run: {fast: 1}\n- expect: {U4A0: 1}\n");
    std::filesystem::create_directories(work_.Path("sub"));
  }

  Workplace work_;
};

TEST_F(ProjectCommand, EveryCommandFindsIt) {
  for (const std::string folder : {".", "sub"}) {
    const Ran check = work_.Run("check", "", "", folder);
    EXPECT_EQ(check.code, 0) << check;
    EXPECT_EQ(check.errors, "saw: no errors, no warnings\n");
    const Ran ir = work_.Run("print ir", "", "", folder);
    EXPECT_THAT(ir.out, HasSubstr("load I0A0")) << ir;
    const Ran sim = work_.Run("sim --cycles 2 --watch U4A0", "", "", folder);
    EXPECT_THAT(sim.errors, HasSubstr("40 ms simulated")) << sim;  // the option counts
    const Ran test = work_.Run("test --engine sim", "", "", folder);
    EXPECT_THAT(test.out, HasSubstr("1 scenario passed")) << test;
    const Ran report = work_.Run("report --cross-reference", "", "", folder);
    EXPECT_THAT(report.out, HasSubstr("lathe.plc:1")) << report;
  }
  EXPECT_EQ(work_.Run("emit -q", "", "", "sub").code, 0);
  EXPECT_TRUE(work_.Has("generated/saw.cpp"));
  EXPECT_EQ(work_.Run("emit -q --depfile saw.d -o out --name other").code, 0);
  EXPECT_TRUE(work_.Has("out/other.hpp"));
  EXPECT_THAT(work_.Read("saw.d"), AllOf(HasSubstr("plcxx.yaml"), HasSubstr("lathe.plc")));
}

// What only live and scenarios would say otherwise, to who runs them.
TEST_F(ProjectCommand, CheckLooksAtThePlantAndThePanelThatItNames) {
  work_.Write("plcxx.yaml",
              "name: saw\ndialect: nc110\nsources: lathe.plc\noptions: {clo: [20, 2]}\nplant: p.yaml\npanel: q.yaml\n");
  work_.Write("p.yaml", "elements:\n- switch: {input: I0A1, follows: U4A0}\n");
  work_.Write("q.yaml", "groups:\n- title: All\n  controls:\n  - button: {text: Go, input: I0A0}\n");
  EXPECT_EQ(work_.Run("check", "", "", "sub").errors, "saw: no errors, no warnings\n");
  work_.Write("p.yaml", "elements:\n- switch: {input: I0A1, follows: U4B9}\n");
  work_.Write("q.yaml", "groups:\n- title: All\n  controls:\n  - buton: {text: Go, input: I0A0}\n");
  const Ran wrong = work_.Run("check");
  EXPECT_EQ(wrong.code, 2) << wrong;
  EXPECT_THAT(wrong.errors, AllOf(HasSubstr("p.yaml:2:34: "), HasSubstr("U4B9"), HasSubstr("help: "),
                                  HasSubstr("q.yaml:4:"), HasSubstr("buton"), Not(HasSubstr("no errors"))));
  work_.Write("p.yaml", "elements:\n- switch: {input: I0A0, follows: U4A0}\n");
  work_.Write("q.yaml", "groups:\n- title: All\n  controls:\n  - button: {text: Go, input: I0A0}\n");
  const Ran driven = work_.Run("check");
  EXPECT_EQ(driven.code, 2) << driven;
  EXPECT_THAT(driven.errors, AllOf(HasSubstr("q.yaml:4:"), HasSubstr("p.yaml:2"))) << driven;
  std::filesystem::remove(work_.Path("p.yaml"));
  EXPECT_THAT(work_.Run("check").errors, HasSubstr("p.yaml"));
  work_.Write("p.yaml", "elements: 1\n");
  work_.Write("lathe.plc", "U4A0=\n$\n");
  EXPECT_EQ(work_.Run("check").code, 1);
}

TEST_F(ProjectCommand, TheCommandLineComesFirst) {
  EXPECT_THAT(work_.Run("sim --cycles 2 --set clo=10,2").errors, HasSubstr("20 ms simulated"));
  // Also of two options that mean the same thing.
  work_.Write("plcxx.yaml", "name: saw\ndialect: nc110\nsources: lathe.plc\noptions: {cycle_ms: 30}\n");
  EXPECT_THAT(work_.Run("sim --cycles 2").errors, HasSubstr("60 ms simulated"));
  EXPECT_THAT(work_.Run("sim --cycles 2 --set clo=10,2").errors, HasSubstr("20 ms simulated"));
  EXPECT_THAT(work_.Run("sim --cycles 2 --set cycle_ms=40 --set clo=10,2").errors, HasSubstr("20 ms simulated"));
  EXPECT_THAT(work_.Run("sim --cycles 2 --set clo=10,2 --set cycle_ms=40").errors, HasSubstr("80 ms simulated"));
  work_.Write("u.yaml", "steps:\n- run: {fast: 1}\n- expect: {U4A0: 1}\n");
  EXPECT_THAT(work_.Run("test u.yaml --engine sim --set clo=10,2").out, HasSubstr("at 10 ms"));
  work_.Write("u.yaml", "options: {clo: [50, 2]}\nsteps:\n- run: {fast: 1}\n- expect: {U4A0: 1}\n");
  EXPECT_THAT(work_.Run("test u.yaml --engine sim").out, HasSubstr("at 50 ms"));
  work_.Write("d.plc", "      DATA\n      DATA_END\n      MODULE_MAIN\n      MODULE_MAIN_END\n      STOP\n");
  work_.Write("plcxx.yaml", "dialect: technol\nsources: d.plc\noptions: {slow_ms: 40}\n");
  EXPECT_THAT(work_.Run("sim --cycles 2 --set slow-ms=10").errors, HasSubstr("20 ms simulated"));
  work_.Write("plcxx.yaml", "name: saw\ndialect: nc110\nsources: lathe.plc\noptions: {clo: [20, 2]}\n");
  work_.Write("other.plc", "$\nU4A5=I0A5\n");
  EXPECT_THAT(work_.Run("check other.plc").errors, StartsWith("other: "));
  const Ran both = work_.Run("check other.plc --project plcxx.yaml");
  EXPECT_EQ(both.code, 2);
  EXPECT_THAT(both.errors, HasSubstr("sources and a project are named: leave one of them out"));
  // A file that --set names is looked for here, too.
  work_.Write("sub/MESSAGES", "1#HERE\n");
  EXPECT_EQ(work_.Run("check --set messages=MESSAGES", "", "", "sub").code, 0);
}

TEST_F(ProjectCommand, SaysWhatIsWrong) {
  work_.Write("plcxx.yaml", "sorces: lathe.plc\n");
  for (const std::string command :
       {"check", "emit", "test", "prove", "report", "sim", "verify", "build", "print ir", "diff"}) {
    const Ran ran = work_.Run(command);
    EXPECT_EQ(ran.code, 2) << command << ran;
    EXPECT_THAT(ran.errors, AllOf(StartsWith("plcxx.yaml:1:1: 'sorces' is no key of plcxx.yaml"),
                                  HasSubstr("help: did you mean 'sources'")))
        << command;
  }
  // A warning in the place of what is done with it.
  for (const std::string value : {"off", "on", "\"off\"", "false", "error"}) {
    work_.Write("plcxx.yaml", "sources: lathe.plc\nwarnings: {W350: " + value + "}\n");
    EXPECT_THAT(work_.Run("check").errors,
                AllOf(HasSubstr("plcxx.yaml:2:12: 'W350' is a warning, and no key of 'warnings'; there are: enable, "),
                      HasSubstr("help: 'disable: [W350]' turns it off, 'enable: [W350]' on")));
  }
  work_.Write("plcxx.yaml", "sources: lathe.plc\nwarnings: {W9999: off}\n");
  EXPECT_THAT(work_.Run("check").errors, HasSubstr("'W9999' is no key of 'warnings'"));
  std::filesystem::remove(work_.Path("plcxx.yaml"));
  const Ran none = work_.Run("check");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.errors, HasSubstr("no sources are named, and there is no plcxx.yaml here or above"));
  EXPECT_THAT(work_.Run("check --project nowhere.yaml").errors, HasSubstr("nowhere.yaml: there is no such file"));
}

TEST_F(ProjectCommand, OneOfSeveralPrograms) {
  std::filesystem::create_directories(work_.Path("mill"));
  work_.Write("mill/m.plc", "$\nU4A1=I0A1\n");
  work_.Write("mill/t.yaml", "steps:\n- set: {I0A1: 1}\n- run: {slow: 1}\n- expect: {U4A1: 1}\n");
  work_.Write("plcxx.yaml",
              "dialect: nc110\nprograms:\n- {name: saw, sources: lathe.plc, scenarios: s.yaml}\n"
              "- {folder: mill, sources: '*.plc'}\n");
  const Ran which = work_.Run("check");
  EXPECT_EQ(which.code, 2);
  EXPECT_THAT(which.errors, HasSubstr("which program? --program NAME takes one of them, --all every one: saw, mill"));
  EXPECT_EQ(work_.Run("check --program saw").errors, "saw: no errors, no warnings\n");
  EXPECT_EQ(work_.Run("check", "", "", "mill").errors, "m: no errors, no warnings\n");
  EXPECT_THAT(work_.Run("check --all").errors, AllOf(HasSubstr("saw: "), HasSubstr("m: ")));
  EXPECT_THAT(work_.Run("check --program sow").errors,
              HasSubstr("there is no program 'sow' in plcxx.yaml, did you mean 'saw'"));
  const Ran test = work_.Run("test --all --engine sim");
  EXPECT_THAT(test.out,
              AllOf(HasSubstr("passed  s.yaml"), HasSubstr("passed  mill/t.yaml"), HasSubstr("2 scenarios passed")))
      << test;
  work_.Write("s.yaml", "program: mill\nsteps:\n- run: {slow: 1}\n- expect: {U4A1: 0}\n");
  EXPECT_EQ(work_.Run("test s.yaml --engine sim").code, 0);
  work_.Write("s.yaml", "program: mil\nsteps: []\n");
  EXPECT_THAT(work_.Run("test s.yaml --engine sim").errors,
              HasSubstr("s.yaml:1:10: there is no program 'mil' in plcxx.yaml"));
}

/// Two machines of one language in a folder each.
class Park : public ::testing::Test {
 protected:
  Park() {
    for (const std::string name : {"saw", "mill"}) {
      std::filesystem::create_directories(work_.Path(name));
      work_.Write(name + "/p.plc", "U4A0=I0A0\n$\nU4A1=I0A1\n");
      work_.Write(name + "/p.prop", "I0A0 implies U4A0\nnever U4A1\n");
    }
    work_.Write("plcxx.yaml",
                "dialect: nc110\nsources: p.plc\nproperties: p.prop\nprograms:\n- {name: saw, folder: saw}\n"
                "- {name: mill, folder: mill, options: {clo: [20, 2]}}\n");
  }

  Workplace work_;
};

// The last program's file stood where the first one's had been, and nothing said so.
TEST_F(Park, NoProgramOverwritesWhatAnotherHasWritten) {
  for (const std::string command : {"emit -q --single-file -o x.hpp", "emit -q -o out --name same",
                                    "report -q -o page.html", "sim --cycles 2 --watch U4A0 --vcd run.vcd"}) {
    const Ran ran = work_.Run(command + " --all");
    EXPECT_NE(ran.code, 0) << command << ran;
    EXPECT_THAT(ran.errors, HasSubstr("it has just been written for program 'saw'")) << command;
    EXPECT_EQ(work_.Run(command + " --program mill").code, 0) << command;
  }
  EXPECT_EQ(work_.Run("emit -q --all -o both").code, 0);
  EXPECT_TRUE(work_.Has("both/saw.cpp") && work_.Has("both/mill.cpp"));
}

TEST_F(Park, WhatIsFoundOfEachProgramSaysOfWhich) {
  const Ran proved = work_.Run("prove --all --junit j.xml --counterexamples found");
  EXPECT_EQ(proved.code, 1) << proved;
  EXPECT_THAT(proved.out, AllOf(StartsWith("saw:\nproved "), HasSubstr("\nmill:\nproved ")));
  EXPECT_THAT(work_.Read("j.xml"), HasSubstr("tests=\"4\" failures=\"2\""));
  EXPECT_TRUE(work_.Has("found/saw/property-2.yaml") && work_.Has("found/mill/property-2.yaml"));
  EXPECT_THAT(work_.Run("sim --all --cycles 2 --watch U4A0").out, AllOf(StartsWith("saw:\n"), HasSubstr("mill:\n")));
  const Ran alone = work_.Run("prove --program saw");
  EXPECT_THAT(alone.out, StartsWith("proved "));
  EXPECT_EQ(work_.Run("soak --all --for 1s -o soaked").code, 1);
  EXPECT_TRUE(work_.Has("soaked/saw/soak.json") && work_.Has("soaked/mill/soak.json"));
}

TEST_F(Park, JsonIsOneValue) {
  for (const std::string command :
       {"prove --format json", "why U4A1 --can --format json", "soak --for 1s --format json"}) {
    const auto all = nlohmann::json::parse(work_.Run(command + " --all").out, nullptr, false);
    ASSERT_TRUE(all.is_array() && all.size() == 2) << command;
    EXPECT_EQ(all[0]["program"], "saw") << command;
    EXPECT_EQ(all[1]["program"], "mill") << command;
    EXPECT_TRUE(nlohmann::json::parse(work_.Run(command + " --program mill").out, nullptr, false).is_object());
  }
}

// One program without a scenario kept those of all others from being run.
TEST_F(Park, AProgramWithoutAScenarioIsNoted) {
  const Ran none = work_.Run("test --all --engine sim");
  EXPECT_EQ(none.code, 2) << none;
  EXPECT_THAT(none.errors, HasSubstr("no program of the project has a scenario"));
  work_.Write("mill/t.yaml", "steps:\n- set: {I0A1: 1}\n- run: {slow: 1}\n- expect: {U4A1: 1}\n");
  const Ran one = work_.Run("test --all --engine sim");
  EXPECT_EQ(one.code, 0) << one;
  EXPECT_THAT(one.out, HasSubstr("1 scenario passed"));
  EXPECT_THAT(one.errors, HasSubstr("note: saw: there is no scenario (*.yaml) in directory 'saw'"));
  EXPECT_EQ(work_.Run("test --program saw --engine sim").code, 2);
}

// One without properties made the command fail, and nothing said which one.
TEST_F(Park, AProgramWithoutPropertiesIsNoted) {
  const std::string programs =
      "programs:\n- {name: saw, folder: saw, properties: p.prop}\n- {name: mill, folder: mill}\n";
  work_.Write("saw/p.prop", "U4A0 implies U4A0\n");
  work_.Write("plcxx.yaml", "dialect: nc110\nsources: p.plc\n" + programs);
  const Ran one = work_.Run("prove --all --junit j.xml");
  EXPECT_EQ(one.code, 0) << one;
  EXPECT_THAT(one.errors, HasSubstr("note: mill: there is nothing to prove"));
  EXPECT_THAT(work_.Read("j.xml"), HasSubstr("<testsuites name=\"plcxx prove\" tests=\"1\""));
  EXPECT_EQ(work_.Run("prove --program mill").code, 2);
  work_.Write("plcxx.yaml",
              "dialect: nc110\nsources: p.plc\nprograms:\n- {name: saw, folder: saw}\n- {name: mill, folder: mill}\n");
  const Ran none = work_.Run("prove --all");
  EXPECT_EQ(none.code, 2) << none;
  EXPECT_THAT(none.errors, HasSubstr("no program of the project has properties"));
}

TEST_F(Park, AProgramIsChosenOnce) {
  const Ran both = work_.Run("check --all --program mill");
  EXPECT_EQ(both.code, 2) << both;
  EXPECT_THAT(both.errors, HasSubstr("--all takes every program, --program one of them"));
  const Ran twice = work_.Run("check --program mill --program mill");
  EXPECT_EQ(twice.code, 0) << twice;
  EXPECT_EQ(twice.errors, "mill: no errors, no warnings\n");
}

TEST_F(ProjectCommand, ProvesWhatTheProjectNames) {
  work_.Write("p.prop", "I0A0 implies U4A0\n");
  work_.Write("props.yaml", "properties: [I0A1 implies U4A1]\n");
  work_.Write("plcxx.yaml", "dialect: nc110\nsources: lathe.plc\nproperties: [p.prop, props.yaml]\n");
  const Ran both = work_.Run("prove");
  EXPECT_EQ(both.code, 0) << both;
  EXPECT_THAT(both.out, HasSubstr("2 properties: 2 proved"));
  EXPECT_THAT(work_.Run("prove --property p.prop").out, HasSubstr("1 property: 1 proved"));
}

TEST_F(ProjectCommand, EachRevisionHasItsOwn) {
  if (Git(work_, "init -q") != 0) GTEST_SKIP() << "no git";
  ASSERT_EQ(Git(work_, "add ."), 0);
  ASSERT_EQ(Git(work_, "commit -q -m one"), 0);
  // The file has another name since, and says it.
  std::filesystem::rename(work_.Path("lathe.plc"), work_.Path("turning.plc"));
  work_.Write("plcxx.yaml", "name: saw\ndialect: nc110\nsources: turning.plc\noptions: {clo: [20, 2]}\n");
  for (const std::string words : {"diff", "diff HEAD..", "diff --git HEAD.."}) {
    const Ran same = work_.Run(words);
    EXPECT_EQ(same.code, 0) << words << same;
    EXPECT_THAT(same.out, HasSubstr("HEAD -> the work tree: no difference")) << words;
  }
  work_.Write("turning.plc", "U4A0=I0A0*I0A2\n$\nU4A1=I0A1\n");
  const Ran changed = work_.Run("diff HEAD..", "", "", "sub");
  EXPECT_EQ(changed.code, 1) << changed;
  EXPECT_THAT(changed.out, HasSubstr("U4A0  different"));
  const Ran unknown = work_.Run("diff nothing..");
  EXPECT_EQ(unknown.code, 2) << unknown;
  ASSERT_EQ(Git(work_, "branch stable"), 0);
  EXPECT_THAT(work_.Run("diff stabel..").errors, HasSubstr("git has no version 'stabel', did you mean 'stable'"));
  EXPECT_THAT(work_.Run("diff stable").errors, HasSubstr("'stable..' compares that version in git with the work tree"));
}

// They were ignored, and a comparison of something else was taken for the one that was asked for.
TEST_F(ProjectCommand, DiffRefusesWhatItDoesNotLookAt) {
  for (const std::string words : {"--project nope.yaml", "--program foo", "--all"}) {
    const Ran ran = work_.Run("diff lathe.plc lathe.plc " + words);
    EXPECT_EQ(ran.code, 2) << words << ran;
    EXPECT_THAT(ran.errors, HasSubstr("sources and a project are named: leave one of them out")) << words;
  }
  for (const std::string words : {"diff HEAD.. --sources nope.plc", "diff --sources nope.plc"}) {
    const Ran ran = work_.Run(words);
    EXPECT_EQ(ran.code, 2) << words << ran;
    EXPECT_THAT(ran.errors, HasSubstr("--sources is about two directories")) << words;
  }
  EXPECT_EQ(work_.Run("diff --map U4A0=U4A0 lathe.plc lathe.plc").code, 0);
}

// A message named the copy of the revision, another one in each run, and gone afterwards.
TEST_F(ProjectCommand, ARevisionIsNamedAsGitNamesIt) {
  if (Git(work_, "init -q") != 0) GTEST_SKIP() << "no git";
  const std::string right = work_.Read("lathe.plc"), project = work_.Read("plcxx.yaml");
  work_.Write("lathe.plc", "$\nU4A0=I0A0+\n");
  ASSERT_EQ(Git(work_, "add ."), 0);
  ASSERT_EQ(Git(work_, "commit -q -m one"), 0);
  work_.Write("lathe.plc", right);
  EXPECT_THAT(work_.Run("diff HEAD..").errors, AllOf(HasSubstr("HEAD:lathe.plc:2:"), Not(HasSubstr("/plcxx-"))));
  EXPECT_THAT(work_.Run("diff HEAD.. --diagnostics json").errors, HasSubstr("\"HEAD:lathe.plc\""));
  EXPECT_THAT(work_.Run("diff HEAD.. --diagnostics sarif").errors,
              AllOf(HasSubstr("\"lathe.plc\""), Not(HasSubstr("/plcxx-"))));
  work_.Write("plcxx.yaml", "sorces: a\n");
  ASSERT_EQ(Git(work_, "commit -q -a -m two"), 0);
  work_.Write("plcxx.yaml", project);
  EXPECT_THAT(work_.Run("diff HEAD..").errors, HasSubstr("plcxx.yaml of 'HEAD':1:1: 'sorces' is no key"));
}

TEST_F(Park, DiffSaysWhichProgramItIsAbout) {
  if (Git(work_, "init -q") != 0) GTEST_SKIP() << "no git";
  ASSERT_EQ(Git(work_, "add ."), 0);
  ASSERT_EQ(Git(work_, "commit -q -m one"), 0);
  work_.Write("mill/p.plc", "U4A0=I0A0\n$\nU4A1=I0A1*I0A2\n");
  const Ran text = work_.Run("diff --all --counterexamples found");
  EXPECT_EQ(text.code, 1) << text;
  EXPECT_THAT(text.out, AllOf(StartsWith("saw: HEAD -> the work tree: no difference"),
                              HasSubstr("\nmill: HEAD -> the work tree: 1 output differs")));
  EXPECT_TRUE(work_.Has("found/mill/U4A1.yaml"));
  EXPECT_THAT(work_.Run("diff --all --format markdown").out,
              AllOf(StartsWith("### saw: what changed"), HasSubstr("### mill: what changed")));
  const auto all = nlohmann::json::parse(work_.Run("diff --all --format json").out, nullptr, false);
  ASSERT_TRUE(all.is_array() && all.size() == 2);
  EXPECT_EQ(all[1]["program"], "mill");
  const auto sarif = nlohmann::json::parse(work_.Run("diff --all --format sarif").out, nullptr, false);
  ASSERT_TRUE(sarif.is_object() && sarif["runs"].size() == 2);
  EXPECT_EQ(sarif["runs"][1]["automationDetails"]["id"], "mill/");
  EXPECT_THAT(work_.Run("diff --all --format html").errors, HasSubstr("is a page about one program"));
  // A program that had another name: the copy of the revision is nobody's file.
  work_.Write("plcxx.yaml",
              "dialect: nc110\nsources: p.plc\nprograms:\n- {name: saw, folder: saw}\n"
              "- {name: press, folder: mill}\n");
  EXPECT_THAT(work_.Run("diff --program press").errors,
              HasSubstr("there is no program 'press' in plcxx.yaml of 'HEAD'; there are: saw, mill"));
}

TEST_F(ProjectCommand, AStrangersFileReadsNothingOutside) {
  work_.Write("plcxx.yaml", "dialect: nc110\nsources: /etc/passwd\n");
  const Ran check = work_.Run("check");
  EXPECT_EQ(check.code, 2);
  EXPECT_THAT(check.errors, AllOf(HasSubstr("'/etc/passwd' is outside of the project"), Not(HasSubstr("root:"))));
  work_.Write("plcxx.yaml", "dialect: nc110\nsources: lathe.plc\noptions: {messages: ../../../etc/passwd}\n");
  EXPECT_THAT(work_.Run("test s.yaml").errors, AllOf(HasSubstr("is outside of the project"), Not(HasSubstr("root:"))));
}

TEST_F(ProjectCommand, WordsOfTheFileBeginNoLineOfAMessage) {
  work_.Write("plcxx.yaml", "dialect: nc110\nsources: [\"a\\nlathe.plc:1:1: error: forged\"]\n");
  EXPECT_THAT(work_.Run("check").errors, AllOf(HasSubstr("'a<U+000A>lathe.plc"), Not(HasSubstr("\nlathe.plc"))));
}

TEST_F(ProjectCommand, AByteThatIsNoTextIsToldWhereItIs) {
  work_.Write("plcxx.yaml", std::string("dialect: nc110\nsources: [la\0the.plc]\n", 39));
  EXPECT_THAT(work_.Run("check").errors, HasSubstr("plcxx.yaml:2:13: not YAML: a byte with the value 0 or 4"));
}

TEST_F(ProjectCommand, PrintsItsSchema) {
  const Ran schema = work_.Run("print schema");
  EXPECT_EQ(schema.code, 0);
  EXPECT_THAT(schema.out, HasSubstr("\"$schema\""));
  EXPECT_THAT(schema.errors, IsEmpty());
}

}  // namespace
}  // namespace plcxx::driver
