// Goldens: printed phases beside their programs, generated C++ of the samples, and the conventions of the cases.

#include "tests/golden/golden.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/compile/child_process.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/yaml/words.h"

namespace plcxx::golden {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const fs::path kRoot = PLCXX_ROOT;

/// A path below the project as the name of a test.
std::string NameOf(const fs::path& path) {
  std::string name = path.lexically_relative(kRoot).generic_string();
  std::ranges::replace_if(name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

// A test each: dev/mutants runs them one by one.
class PrintedPhases : public testing::TestWithParam<PhaseGolden> {};

TEST_P(PrintedPhases, AreAsKept) {
  if (const auto problem = CheckPhase(GetParam(), ChosenMode())) ADD_FAILURE() << *problem;
}

INSTANTIATE_TEST_SUITE_P(Golden, PrintedPhases, testing::ValuesIn(PhaseGoldens(kRoot / "tests/golden")),
                         [](const auto& named) { return NameOf(named.param.file); });

TEST(Golden, EachLanguageHasPhases) { EXPECT_THAT(MissingPhases(kRoot / "tests/golden", 12), ElementsAre()); }

std::vector<fs::path> Machines() {
  std::vector<fs::path> machines;
  for (const auto& dialect : fs::directory_iterator(kRoot / "samples")) {
    // samples/baremetal: boards that run a machine of another folder.
    if (!dialect.is_directory() || dialect.path().filename() == "baremetal") continue;
    for (const auto& machine : fs::directory_iterator(dialect.path())) {
      if (machine.is_directory()) machines.push_back(machine.path());
    }
  }
  std::ranges::sort(machines);
  return machines;
}

class Samples : public testing::TestWithParam<fs::path> {};

// The same sources give the same bytes. covers: TECHNOL-213 PS-290
TEST_P(Samples, GeneratedCodeIsAsKept) {
  for (const std::string& problem : CheckSample(GetParam(), ChosenMode())) ADD_FAILURE() << problem;
}

INSTANTIATE_TEST_SUITE_P(Golden, Samples, testing::ValuesIn(Machines()),
                         [](const auto& named) { return NameOf(named.param); });

TEST(Golden, CasesThatMustFailAreNamedSo) {
  for (const fs::path& file : FilesBelow(kRoot / "tests/golden", ".yaml")) {
    const scenarios::ScenarioOrErrors read = scenarios::ReadScenario(file.string());
    const auto* scenario = std::get_if<scenarios::Scenario>(&read);
    ASSERT_NE(scenario, nullptr) << file << ": "
                                 << ToText(std::get<std::vector<scenarios::ScenarioError>>(read).front());
    EXPECT_EQ(file.stem().string().ends_with("_bad"), scenario->expect_error.has_value()) << file;
  }
}

// As tests/inline_sources.py reads them.
TEST(Golden, WrittenProgramsAreBlocks) {
  size_t written = 0;
  for (const fs::path& file : FilesBelow(kRoot / "tests/golden", ".yaml")) {
    const scenarios::ScenarioOrErrors read = scenarios::ReadScenario(file.string());
    const auto* scenario = std::get_if<scenarios::Scenario>(&read);
    if (scenario == nullptr || scenario->texts.empty()) continue;
    ++written;
    const std::string text = ReadFile(file);
    for (const auto& [path, program] : scenario->texts) {
      EXPECT_THAT(text, HasSubstr("\n  " + fs::path(path).filename().string() + ": " +
                                  std::string(yaml::YamlText(program, 4)) + "\n"))
          << file;
    }
  }
  EXPECT_GT(written, 4000U);
}

TEST(Golden, EveryProgramBelongsToACase) {
  for (const fs::path& file : FilesBelow(kRoot / "tests/golden", ".plc")) {
    bool named = false;
    for (const fs::path& scenario : FilesBelow(file.parent_path(), ".yaml")) {
      named = named || ReadFile(scenario).find(file.filename().string()) != std::string::npos;
    }
    EXPECT_TRUE(named) << file << ": no scenario beside it names it";
  }
}

/// A private folder with files in it.
struct Folder {
  compile::TemporaryDirectory directory;
  fs::path path = directory.path();

  void Write(const std::string& name, std::string_view text) const {
    fs::create_directories((path / name).parent_path());
    std::ofstream(path / name, std::ios::binary) << text;
  }
};

TEST(GoldenRunner, SeesADifferenceAndRewritesIt) {
  const Folder folder;
  folder.Write("a.txt", "one\ntwo\nthree\n");
  EXPECT_EQ(CheckFile(folder.path / "a.txt", "one\ntwo\nthree\n", Mode::kCompare), std::nullopt);
  EXPECT_THAT(CheckFile(folder.path / "a.txt", "one\ntwenty\nthree\n", Mode::kCompare).value_or(""),
              HasSubstr("a.txt: line 2 is 'two', but plcxx gives 'twenty'; PLCXX_UPDATE_GOLDEN=1 rewrites it"));
  EXPECT_THAT(CheckFile(folder.path / "a.txt", "one\n", Mode::kCompare).value_or(""),
              HasSubstr("line 2 is 'two', but plcxx gives '(end of file)'"));
  EXPECT_THAT(CheckFile(folder.path / "b.txt", "x", Mode::kCompare).value_or(""), HasSubstr("b.txt: is missing"));
  EXPECT_EQ(CheckFile(folder.path / "a.txt", "other\n", Mode::kUpdate), std::nullopt);
  EXPECT_EQ(ReadFile(folder.path / "a.txt"), "other\n");
}

TEST(GoldenRunner, SeesAPhaseThatChanged) {
  const Folder folder;
  folder.Write("coil.plc", "$\nU4A8=I0A3\n");
  folder.Write("coil.plc.ir", "program other\n");
  folder.Write("coil.plc.cc", "");
  folder.Write("own.cc", "not a phase: there is no program 'own'");
  const std::vector<PhaseGolden> goldens = PhaseGoldens(folder.path);
  ASSERT_EQ(goldens.size(), 2u);
  EXPECT_EQ(goldens[1].phase, "cpp");
  EXPECT_THAT(CheckPhase(goldens[0], Mode::kCompare).value_or(""),
              HasSubstr("coil.plc.ir: line 1 is 'program other', but plcxx gives"));
  EXPECT_EQ(CheckPhase(goldens[0], Mode::kUpdate), std::nullopt);
  EXPECT_EQ(CheckPhase(goldens[0], Mode::kCompare), std::nullopt);
  EXPECT_THAT(ReadFile(goldens[0].file), HasSubstr("U4A8"));
  folder.Write("coil.plc", "$\nU4A8=\n");
  EXPECT_THAT(CheckPhase(goldens[0], Mode::kCompare).value_or(""), HasSubstr("plcxx ends with 1"));
}

TEST(GoldenRunner, SeesAPhaseWithoutItsProgramAndALanguageWithoutPhases) {
  const Folder folder;
  folder.Write("nc110/coil.plc.ir", "");
  folder.Write("nc110/case.yaml", "");
  folder.Write("begun/readme.txt", "a language without cases");
  folder.Write("golden.cc", "");
  const std::vector<PhaseGolden> goldens = PhaseGoldens(folder.path);
  ASSERT_EQ(goldens.size(), 1u);
  EXPECT_THAT(CheckPhase(goldens[0], Mode::kUpdate).value_or(""), HasSubstr("coil.plc"));
  EXPECT_THAT(MissingPhases(folder.path, 1),
              ElementsAre(HasSubstr("nc110: 0 files *.syntax beside programs, and 1 are asked for"),
                          HasSubstr("nc110: 0 files *.cc beside programs")));
}

TEST(GoldenRunner, SeesASampleThatChanged) {
  const Folder folder;
  EXPECT_THAT(CheckSample(folder.path, Mode::kCompare), ElementsAre(HasSubstr("a sample has scenarios")));
  folder.Write("mill.plc", "$\nU4A8=I0A3\n");
  folder.Write("run.yaml", "steps: []\n");
  EXPECT_THAT(CheckSample(folder.path, Mode::kCompare), ElementsAre(HasSubstr("a sample has a plcxx.yaml")));
  folder.Write("plcxx.yaml", "dialect: nc110\nsources: [mill.plc]\n");
  EXPECT_THAT(CheckSample(folder.path, Mode::kCompare), testing::Contains(HasSubstr("generated/mill.hpp: is missing")));
  EXPECT_THAT(CheckSample(folder.path, Mode::kUpdate), ElementsAre());
  EXPECT_THAT(CheckSample(folder.path, Mode::kCompare), ElementsAre());
  folder.Write("generated/mill_old.cpp", "");
  EXPECT_THAT(CheckSample(folder.path, Mode::kCompare), ElementsAre(HasSubstr("plcxx writes no such file any more")));
  folder.Write("mill.plc", "$\nU4A8=I0A3*I0A4\n");
  EXPECT_THAT(CheckSample(folder.path, Mode::kCompare), testing::Contains(HasSubstr("mill.cpp: line ")));
  EXPECT_THAT(CheckSample(folder.path, Mode::kUpdate), ElementsAre());
  EXPECT_FALSE(fs::exists(folder.path / "generated/mill_old.cpp"));
}

}  // namespace
}  // namespace plcxx::golden
