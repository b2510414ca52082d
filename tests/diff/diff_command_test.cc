// The command line of plcxx diff: directories, revisions of git, git's own words, and what is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class DiffCommand : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(place_.Path("old"));
    std::filesystem::create_directory(place_.Path("new"));
    place_.Write("old/door.plc", "$\nU4A0=I0A0*/I0A1\n");
    place_.Write("new/door.plc", "$\nU4A0=I0A0\n");
  }

  Workplace place_;
};

TEST_F(DiffCommand, TwoDirectoriesAreTwoPrograms) {
  const Ran ran = place_.Run("diff old new");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("I0A0=1, I0A1=1, slow 1: 0 in the old version, 1 in the new one"));
  EXPECT_THAT(ran.out, HasSubstr("old -> new: 1 output differs; "));
}

TEST_F(DiffCommand, EqualVersionsGiveZero) {
  const Ran ran = place_.Run("diff old/door.plc old/door.plc");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, HasSubstr("no difference; "));
}

/// The control knows the word that has a message's number by its address.
TEST_F(DiffCommand, ARenamedMessageWordIsTheSame) {
  place_.Write("old/names.sym", "* names\nShown = W17K3\n");
  place_.Write("new/names.sym", "* names\nTold = W17K3\n");
  place_.Write("old/door.plc", "$\n!Shown=W0K0\n");
  place_.Write("new/door.plc", "$\n!Told=W0K0\n");
  const Ran ran = place_.Run("diff old new --sources names.sym door.plc --dialect nc110");
  EXPECT_EQ(ran.code, 0) << ran;
}

TEST_F(DiffCommand, RevisionsOfGit) {
  const std::string commands =
      "cd '" + place_.Path(".") +
      "' && git init -q . && cp old/door.plc door.plc && git add door.plc && git -c user.name=a -c "
      "user.email=none commit -q -m one && cp new/door.plc door.plc";
  ASSERT_EQ(std::system(commands.c_str()), 0);
  const Ran ran = place_.Run("diff --git HEAD.. door.plc");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("old * door.plc:2  U4A0=I0A0*/I0A1"));
  EXPECT_THAT(ran.out, HasSubstr("HEAD -> the work tree: 1 output differs"));
  const Ran wrong = place_.Run("diff --git nowhere.. door.plc");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.errors, HasSubstr("git has no version 'nowhere'"));
}

/// Each version has its own folders and files, however the command line names them.
TEST_F(DiffCommand, RevisionsHaveTheirOwnFolders) {
  std::filesystem::create_directory(place_.Path("inc"));
  place_.Write("inc/k.h", "#define LIM 3\n");
  place_.Write("a.cld",
               "#include \"plc.h\"\n#include \"k.h\"\nstatic int c;\nvoid init() { plc1_time = 8; plc2_time = 16; }\n"
               "void plc1() {}\nvoid plc2() { if (X[0] & 1) { if (++c >= LIM) { c = 0; Y[0] ^= 1; } } }\n");
  const std::string commands =
      "cd '" + place_.Path(".") +
      "' && git init -q . && git add inc a.cld && git -c user.name=a -c user.email=none commit "
      "-q -m one && sed -i 's/3/4/' inc/k.h";
  ASSERT_EQ(std::system(commands.c_str()), 0);
  for (const std::string& folder : {std::string("inc"), place_.Path("inc")}) {
    for (const std::string& file : {std::string("a.cld"), place_.Path("a.cld")}) {
      const Ran ran = place_.Run("diff --git HEAD.. '" + file + "' -I '" + folder + "' --time 5s");
      EXPECT_EQ(ran.code, 1) << ran;
      EXPECT_THAT(ran.out, HasSubstr("Y[0]"));
    }
  }
  const Workplace elsewhere;
  const Ran outside = place_.Run("diff --git HEAD.. a.cld -I inc -I '" + elsewhere.Path(".") + "' --time 5s");
  EXPECT_THAT(outside.out, HasSubstr("not looked at: what other versions of folders outside of the repository had ("));
}

/// What a version does depends on the options with which its scenarios run it, whoever names its sources.
TEST_F(DiffCommand, OptionsOfTheScenariosBesideTheProgram) {
  const auto scenario = [](const std::string& options) {
    return "sources: [door.plc]\noptions: {" + options + "}\nsteps:\n- run: {slow: 1}\n";
  };
  const std::string slow = "$\nU4A0=I0A0\nU4A1=I0A1\nU4A2=I0A2\nU4A3=I0A3\n";
  place_.Write("old/door.plc", slow);
  place_.Write("new/door.plc", slow);
  place_.Write("old/a.yaml", scenario("slices: 2"));
  // A version without scenarios is run as the other one.
  EXPECT_EQ(place_.Run("diff old new --sources door.plc").code, 0);
  place_.Write("new/a.yaml", scenario("slices: 4"));
  for (const std::string words : {"old new", "old new --sources door.plc", "old/door.plc new/door.plc"}) {
    const Ran ran = place_.Run("diff " + words + " --time 5s");  // it is seen at once
    EXPECT_EQ(ran.code, 1) << ran;
    EXPECT_THAT(ran.out, HasSubstr("slices"));
  }
  EXPECT_EQ(place_.Run("diff old new --sources door.plc --set slices=2").code, 0);
  place_.Write("new/b.yaml", scenario("slices: 2"));
  const Ran unclear = place_.Run("diff old new --time 5s");
  EXPECT_THAT(unclear.out, HasSubstr("not looked at: the program with options that only some of its scenarios have "
                                     "(slices); give them with --set"));
}

TEST_F(DiffCommand, RevisionsTakeTheOptionsOfTheirScenarios) {
  place_.Write("old/a.yaml", "sources: [door.plc]\noptions: {slices: 2}\nsteps:\n- run: {slow: 1}\n");
  const std::string commands =
      "cd '" + place_.Path(".") +
      "' && git init -q . && git add old && git -c user.name=a -c user.email=none commit -q -m one && sed -i "
      "'s/slices: 2/slices: 4/' old/a.yaml";
  ASSERT_EQ(std::system(commands.c_str()), 0);
  place_.Write("old/door.plc", "$\nU4A0=I0A0*/I0A1\nU4A1=I0A1\nU4A2=I0A2\nU4A3=I0A3\n");
  const Ran ran = place_.Run("diff --git HEAD.. old/door.plc --time 5s");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("slices"));
}

/// For who reads a page in a browser, a merge request or a viewer of SARIF: the same verdict, change and run.
TEST_F(DiffCommand, EachFormIsWellFormedAndSaysTheSame) {
  place_.Write("old/do or.plc", "$\nU4A0=I0A0*/I0A1 ; <b>|`\n");
  place_.Write("new/do or.plc", "$\nU4A0=I0A0 ; <script>alert(1)</script> |`\n");
  const auto form = [this](const std::string& name) {
    const Ran ran = place_.Run("diff 'old/do or.plc' 'new/do or.plc' --format " + name);
    EXPECT_EQ(ran.code, 1) << ran;
    return ran.out;
  };
  const std::string verdict = "1 output differs; ", shown = "I0A0=1, I0A1=1, slow 1";
  EXPECT_THAT(form("text"), AllOf(HasSubstr(verdict), HasSubstr(shown)));
  const std::string markdown = form("markdown");
  EXPECT_THAT(markdown, AllOf(HasSubstr(verdict), HasSubstr(shown), Not(HasSubstr("<script"))));
  std::istringstream rows(markdown);
  for (std::string row; std::getline(rows, row);) {
    if (row.starts_with('|')) {
      EXPECT_TRUE(row.ends_with('|')) << row;
    }
  }
  const std::string html = form("html");
  EXPECT_THAT(html, AllOf(HasSubstr(verdict), HasSubstr(shown), Not(HasSubstr("<script>alert")),
                          Not(HasSubstr("src=\"http")), Not(HasSubstr("href=\"http")), Not(HasSubstr("@import"))));
  const nlohmann::json json = nlohmann::json::parse(form("json"));
  EXPECT_THAT(json["summary"].get<std::string>(), HasSubstr(verdict));
  EXPECT_EQ(json["items"][0]["counterexample"]["steps"], shown);
  const nlohmann::json sarif = nlohmann::json::parse(form("sarif"));
  EXPECT_EQ(sarif["version"], "2.1.0");
  const nlohmann::json& run = sarif["runs"][0];
  EXPECT_EQ(run["tool"]["driver"]["name"], "plcxx diff");
  EXPECT_THAT(run["properties"]["summary"].get<std::string>(), HasSubstr(verdict));
  EXPECT_EQ(run["properties"]["newStatements"].size(), 1U);
  ASSERT_EQ(run["results"].size(), 1U);
  const nlohmann::json& result = run["results"][0];
  EXPECT_THAT(result["message"]["text"].get<std::string>(), HasSubstr(shown));
  EXPECT_EQ(result["ruleId"], run["tool"]["driver"]["rules"][0]["id"]);
  EXPECT_EQ(result["level"], "warning");
  const nlohmann::json& place = result["locations"][0]["physicalLocation"];
  EXPECT_EQ(place["artifactLocation"]["uri"], "new/do%20or.plc");
  EXPECT_EQ(place["region"]["startLine"], 2);
  EXPECT_GE(place["region"]["startColumn"].get<int>(), 1);
}

TEST_F(DiffCommand, AsAToolOfGitItIsNeverBroken) {
  const Ran ran = place_.Run("diff --git-external door.plc old/door.plc 1234567 100644 new/door.plc 89abcde 100644");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, HasSubstr("door.plc (old) -> door.plc (new): 1 output differs"));
  place_.Write("wrong.plc", "$\nU4A0=\n");
  const Ran broken = place_.Run("diff --git-external door.plc old/door.plc 1234567 100644 wrong.plc 89abcde 100644");
  EXPECT_EQ(broken.code, 0) << broken;
  EXPECT_THAT(broken.errors, HasSubstr("'door.plc (new)' cannot be compared"));
}

/// git's copies stand in a temporary directory under names that say nothing, and are gone when the reader sees them.
TEST_F(DiffCommand, AsAToolOfGitItUsesGitsNames) {
  place_.Write("copy_1", "$\nU4A0=I0A0*/I0A1\n");
  place_.Write("copy_2", "$\nU4A0=I0A0\n");
  const Ran ran = place_.Run(
      "diff --dialect nc110 --counterexamples found --git-external door.plc copy_1 1234567 100644 copy_2 89abcde "
      "100644");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, HasSubstr("old * door.plc:2  U4A0=I0A0*/I0A1"));
  EXPECT_THAT(ran.out, HasSubstr("new * door.plc:2  U4A0=I0A0"));
  EXPECT_THAT(ran.out, Not(HasSubstr("copy_")));
  EXPECT_THAT(place_.Read("found/U4A0.yaml"), HasSubstr("sources: ['../door.plc']"));
}

TEST_F(DiffCommand, GitAlsoTellsOfFilesThatComeGoAndMove) {
  EXPECT_EQ(place_.Run("diff --git-external door.plc /dev/null . . new/door.plc 89abcde 100644").out,
            "door.plc: only in the new version\n");
  EXPECT_EQ(place_.Run("diff --git-external door.plc old/door.plc 1234567 100644 /dev/null . .").out,
            "door.plc: only in the old version\n");
  const Ran moved = place_.Run(
      "diff --git-external door.plc old/door.plc 1234567 100644 new/door.plc 89abcde 100644 gate.plc 'similarity index "
      "90%'");
  EXPECT_EQ(moved.code, 0) << moved;
  EXPECT_THAT(moved.out, HasSubstr("door.plc (old) -> gate.plc (new): 1 output differs"));
}

TEST_F(DiffCommand, AScenarioPassesOnTheOldVersionOnly) {
  EXPECT_EQ(place_.Run("diff old new --counterexamples found").code, 1);
  EXPECT_EQ(place_.Run("test found/U4A0.yaml --engine sim").code, 0);
  EXPECT_EQ(place_.Run("test found/U4A0.yaml --engine sim --sources new/door.plc").code, 1);
}

// A scenario of the same name that somebody else wrote stays.
TEST_F(DiffCommand, AScenarioTakesAFreeName) {
  std::filesystem::create_directory(place_.Path("found"));
  place_.Write("found/U4A0.yaml", "# my own\nsteps: []\n");
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(place_.Run("diff old new --counterexamples found").code, 1);
    EXPECT_EQ(place_.Read("found/U4A0.yaml"), "# my own\nsteps: []\n");
    EXPECT_EQ(place_.Run("test found/U4A0_2.yaml --engine sim").code, 0);
    EXPECT_FALSE(place_.Has("found/U4A0_3.yaml"));
  }
}

// Who reads results beside the files of the new version finds each one's place.
TEST_F(DiffCommand, EachResultOfSarifHasAPlace) {
  place_.Write("old/door.plc", "$\nU4A0=I0A0\nU4A1=I0A1\nU4A2=I0A2\nT5I(20)=I0A3\n");
  place_.Write("new/door.plc", "$\nU4A0=I0A0\nU4A2=I0A3\n");
  const Ran ran = place_.Run("diff old new --format sarif");
  EXPECT_EQ(ran.code, 1) << ran;
  const nlohmann::json results = nlohmann::json::parse(ran.out)["runs"][0]["results"];
  EXPECT_GE(results.size(), 2U);
  for (const nlohmann::json& result : results) {
    ASSERT_TRUE(result.contains("locations")) << result;
    const nlohmann::json& place = result["locations"][0]["physicalLocation"];
    EXPECT_EQ(place["artifactLocation"]["uri"], "new/door.plc") << result;
  }
}

/// What stands at its old address in the new version is something else.
TEST_F(DiffCommand, AMovedLocationIsNamedByItsSymbol) {
  place_.Write("old/door.sym", "* door\nRUN = U100K0\n");
  place_.Write("new/door.sym", "* door\nRUN = U101K0\n");
  place_.Write("old/door.plc", "$\n!RUN=I0A0*/I0A1\nU4A0=!RUN*I0A2\n");
  place_.Write("new/door.plc", "$\n!RUN=I0A0\nU4A0=!RUN*I0A2\n");
  const Ran ran = place_.Run("diff old new --sources door.sym door.plc --counterexamples found");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, Not(HasSubstr("seen in the simulator only")));
  EXPECT_THAT(place_.Read("found/U100K0.yaml"), HasSubstr("- expect: {RUN: 0}"));
  EXPECT_EQ(place_.Run("test found/U100K0.yaml --engine sim").code, 0);
  EXPECT_EQ(place_.Run("test found/U100K0.yaml --engine sim --sources new/door.sym new/door.plc").code, 1);
}

TEST_F(DiffCommand, SaysWhatIsWrong) {
  EXPECT_THAT(place_.Run("diff old").errors, HasSubstr("diff takes an old and a new program"));
  EXPECT_THAT(place_.Run("diff old new --map I0A0").errors, HasSubstr("--map takes OLD=NEW, not 'I0A0'"));
  EXPECT_THAT(place_.Run("diff old new --map I0A0=NONE").errors, HasSubstr("'NONE' is no location of"));
  EXPECT_THAT(place_.Run("diff old new --time soon").errors, HasSubstr("'soon' is no time"));
  place_.Write("wrong.plc", "$\nU4A0=\n");
  const Ran broken = place_.Run("diff old/door.plc wrong.plc");
  EXPECT_EQ(broken.code, 2) << broken;
  EXPECT_THAT(broken.errors, HasSubstr("cannot be compared: it has errors"));
  place_.Write("open.yaml", "dialect: nc110\nsources: [old/door.plc]\nsteps:\n- run: {slow: 1}\n");
  for (const std::string words : {"open.yaml new/door.plc", "old/door.plc open.yaml", "old new --sources open.yaml"}) {
    const Ran scenario = place_.Run("diff " + words);
    EXPECT_EQ(scenario.code, 2) << scenario;
    EXPECT_THAT(scenario.errors, HasSubstr("'open.yaml' is YAML, as scenarios are: diff compares programs"));
  }
  place_.Write("new/plcxx.yaml", "dialect: nc110\nsources: door.plc\n");
  EXPECT_THAT(place_.Run("diff old/door.plc new/plcxx.yaml").errors,
              HasSubstr("name its folder, as in 'plcxx diff new NEW'"));
}

/// What git says of the versions is no matter of one program.
TEST_F(DiffCommand, VersionsThatGitHasNotAreToldOnce) {
  place_.Write("plcxx.yaml",
               "programs:\n- {name: a, dialect: nc110, sources: old/door.plc}\n"
               "- {name: b, dialect: nc110, sources: new/door.plc}\n");
  const auto messages = [&] {
    const Ran ran = place_.Run("diff --all");
    EXPECT_EQ(ran.code, 2) << ran;
    EXPECT_EQ(std::ranges::count(ran.errors, '\n'), 1) << ran;
    return ran.errors;
  };
  EXPECT_THAT(messages(), HasSubstr("git has no version here"));
  ASSERT_EQ(std::system(("git init -q '" + place_.Path(".") + "'").c_str()), 0);
  EXPECT_THAT(messages(), HasSubstr("git has no version here yet: commit the program first"));
}

/// Ports that are refreshed at every millisecond show more than the ends of ticks: nothing is claimed of such a
/// program.
TEST_F(DiffCommand, WhatHappensBetweenTicksIsRefused) {
  const std::string program = PLCXX_ROOT "/tests/golden/prostep/jumps/loop_budget.plc";
  EXPECT_EQ(place_.Run("diff " + program + " " + program + " --dialect prostep").code, 0);
  const Ran ran = place_.Run("diff " + program + " " + program + " --dialect prostep --set io-refresh=1ms");
  EXPECT_EQ(ran.code, 2) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("at every millisecond between two ticks is not followed yet"));
  place_.Write("m.prop", "never 'O 0.0' and 'O 0.1'\n");
  const Ran prove = place_.Run("prove " + program + " --dialect prostep --set io-refresh=1ms --property m.prop");
  EXPECT_EQ(prove.code, 2) << prove;
  EXPECT_THAT(prove.errors, HasSubstr("at every millisecond between two ticks is not followed yet"));
}

}  // namespace
}  // namespace plcxx::driver
