// plcxx init on folders as they come from controls: the samples without what plcxx has made of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The files of the control alone.
void CopyMachine(const std::string& sample, const std::string& folder) {
  fs::create_directories(folder);
  for (const auto& entry : fs::directory_iterator(PLCXX_ROOT "/samples/" + sample)) {
    const std::string extension = entry.path().extension().string();
    const bool own = extension == ".yaml" || extension == ".cpp" || extension == ".cmake" || extension == ".prop" ||
                     entry.path().filename() == "CMakeLists.txt" || entry.path().filename() == ".gitattributes";
    if (entry.is_regular_file() && !own) fs::copy_file(entry.path(), folder / entry.path().filename());
  }
}

struct Machine {
  const char *sample, *dialect;
};

class Init : public ::testing::TestWithParam<Machine> {};

TEST_P(Init, MakesAProjectThatCompiles) {
  const Workplace work;
  CopyMachine(GetParam().sample, work.Path("machine"));
  const Ran init = work.Run("init machine");
  ASSERT_EQ(init.code, 0) << init;
  EXPECT_THAT(init.out, AllOf(HasSubstr("dialect   " + std::string(GetParam().dialect) + ": "), HasSubstr("check     "),
                              HasSubstr("wrote     machine/plcxx.yaml"), HasSubstr("machine/.gitattributes")));
  const Ran check = work.Run("check", "", "", "machine");
  EXPECT_EQ(check.code, 0) << init << check << work.Read("machine/plcxx.yaml");
  const Ran test = work.Run("test --engine sim", "", "", "machine");
  EXPECT_THAT(test.out, HasSubstr("passed  power_on.yaml")) << test;
  EXPECT_THAT(work.Read("machine/.gitattributes"), HasSubstr(" -text"));
}

INSTANTIATE_TEST_SUITE_P(Samples, Init,
                         ::testing::Values(Machine{"nc110/lathe_16k20", "nc110"}, Machine{"cmake_project", "nc110"},
                                           Machine{"prostep/mill_fnd32", "prostep"}, Machine{"host50/ck6150", "host50"},
                                           Machine{"technol/mcv_750", "technol"}),
                         [](const auto& named) {
                           std::string name = named.param.sample;
                           for (char& c : name) c = c == '/' ? '_' : c;
                           return name;
                         });

TEST(InitCommand, SaysWhatItDecidedAndLeavesWhatIsThere) {
  const Workplace work;
  work.Write("b.plc", "$\nU4A1=!LAMP\n");
  work.Write("a.sym", "* names\nLAMP = I0A0\n");
  work.Write("RUMES5", "1#A MESSAGE\n");
  work.Write("NOTES.DOC", "no program\n");
  work.Write("plcxx.yaml", "# mine\n");
  const Ran init = work.Run("init --pipeline gitlab");
  EXPECT_EQ(init.code, 0) << init;
  EXPECT_THAT(init.out, AllOf(HasSubstr("messages  by its name"), HasSubstr("left out  no source of nc110"),
                              HasSubstr("left      plcxx.yaml: it is there already"), HasSubstr(".gitlab-ci.yml")));
  EXPECT_EQ(work.Read("plcxx.yaml"), "# mine\n");
  fs::remove(work.Path("plcxx.yaml"));
  EXPECT_EQ(work.Run("init --pipeline none").code, 0);
  EXPECT_THAT(work.Read("plcxx.yaml"), AllOf(HasSubstr("sources: [a.sym, b.plc]"), HasSubstr("messages: RUMES5")));
}

TEST(InitCommand, DeclarationsComeFirstThoughNothingButAWarningSaysSo) {
  const Workplace work;
  work.Write("a.plc", ":MOD PM 9\n:A I 0.0\n:= O 0.0\n:END PM 9\n");
  work.Write("b.plc", "%PLC B\nDDW 40 2030D\nDM 1 .NO PRESSURE\n");
  const Ran init = work.Run("init --dialect prostep");
  EXPECT_EQ(init.code, 0) << init;
  EXPECT_THAT(init.out, HasSubstr("order     the one that has fewest warnings"));
  EXPECT_THAT(work.Read("plcxx.yaml"), HasSubstr("sources: [b.plc, a.plc]"));
}

TEST(InitCommand, ALanguageThatNoFileIsIn) {
  const Workplace work;
  work.Write("machine.cld", "void init() {}\n");
  const Ran other = work.Run("init --dialect host50");
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.errors, HasSubstr("no file in '.' is a source of host50; without --dialect, plcxx looks for the"));
  work.Write("machine.cld", "");
  EXPECT_THAT(work.Run("init").errors, HasSubstr("a source that plcxx knows; --dialect NAME says which language"));
}

TEST(InitCommand, ColumnsAreLettersAndNotBytes) {
  const Workplace work;
  for (const std::string name : {"ШЛИФ.plc", "a.plc", "ДЛИННОЕ_ИМЯ_ФАЙЛА_1.plc"})
    work.Write(name, "$\n; " + name + "\n");
  const Ran init = work.Run("init --dialect nc110");
  EXPECT_THAT(init.out, AllOf(HasSubstr("\n          ШЛИФ.plc                 source "),
                              HasSubstr("\n          a.plc                    source "),
                              HasSubstr("\n          ДЛИННОЕ_ИМЯ_ФАЙЛА_1.plc  source ")))
      << init;
}

TEST(InitCommand, WhatASourceIncludesKeepsItsBytesToo) {
  const Workplace work;
  work.Write(
      "m.plc",
      "          T_INCLUDE times.inc\n          DATA\nIN0:      DFM I_A\n          DATA_END\n          MODULE_MAIN\n"
      "          LDR I_A\n          WR I_A\n          MODULE_MAIN_END\n          STOP\n");
  work.Write("times.inc", "          EQUI SECOND,50\n");
  const Ran init = work.Run("init --dialect technol");
  EXPECT_EQ(init.code, 0) << init;
  EXPECT_THAT(init.out, HasSubstr("times.inc           included  a source includes it")) << init;
  EXPECT_THAT(work.Read(".gitattributes"), AllOf(HasSubstr("*.plc -text\n"), HasSubstr("times.inc -text\n")));
}

TEST(InitCommand, AFolderOfMachinesIsAPark) {
  const Workplace work;
  for (const std::string name : {"lathe", "mill"}) {
    fs::create_directories(work.Path(name));
    work.Write(name + "/p.plc", "$\nU4A0=I0A0\n");
  }
  fs::create_directories(work.Path(".git"));
  work.Write(".git/config", "[remote \"origin\"]\n\turl = https://github.com/x/y\n");
  const Ran init = work.Run("init");
  EXPECT_EQ(init.code, 0) << init;
  EXPECT_TRUE(work.Has(".github/workflows/plcxx.yml"));
  EXPECT_THAT(work.Read(".github/workflows/plcxx.yml"), HasSubstr("plcxx check --all"));
  const Ran check = work.Run("check --all");
  EXPECT_THAT(check.errors, AllOf(HasSubstr("lathe: no errors"), HasSubstr("mill: no errors"))) << check;
  EXPECT_THAT(work.Run("test --all --engine sim").out, HasSubstr("2 scenarios passed"));
}

// Folders are called as people call their machines, and the files in them are called the same in each.
TEST(InitCommand, EachFolderOfAParkIsAProgramWhateverItIsCalled) {
  const Workplace work;
  for (const std::string name : {"Станок 1", "Станок 2", "cell 3", "cell_3"}) {
    fs::create_directories(work.Path(name));
    work.Write(name + "/MAIN.PLC", "$\nU4A0=I0A0\n");
  }
  const Ran init = work.Run("init --pipeline none");
  EXPECT_EQ(init.code, 0) << init;
  const Ran check = work.Run("check --all");
  EXPECT_THAT(check.errors, AllOf(HasSubstr("Stanok_1_"), HasSubstr("Stanok_2_"), HasSubstr("cell_3: no errors"),
                                  HasSubstr("cell_3_2: no errors")))
      << check << work.Read("plcxx.yaml");
}

// What lies beside a program on an old disk is not a part of it: each of these made the program one with errors.
TEST(InitCommand, BackupsCopiesAndEmptyFilesAreNoSources) {
  const Workplace work;
  work.Write("LOGIC", "$\nU4A0=I0A0\n");
  work.Write("LOGIC.BAK", "$\nU4A0=I0A1\n");
  work.Write("b.plc", "U4A1=I0A0\n");
  work.Write("b.plc~", "U4A1=I0A1\n");
  work.Write("copy.plc", "U4A1=I0A0\n");
  work.Write("empty.plc", "");
  work.Write("only.old", "U4A2=I0A0\n");  // of nothing that is there
  const Ran init = work.Run("init --dialect nc110");
  EXPECT_EQ(init.code, 0) << init;
  EXPECT_THAT(work.Read("plcxx.yaml"), HasSubstr("sources: [LOGIC, b.plc, only.old]")) << init;
  EXPECT_THAT(init.out, AllOf(HasSubstr("LOGIC.BAK           left out  a backup of LOGIC, by its name"),
                              HasSubstr("b.plc~              left out  a backup of b.plc, by its name"),
                              HasSubstr("copy.plc            left out  the same bytes as b.plc"),
                              HasSubstr("empty.plc           left out  it is empty")));
}

// Who edits it opens the file with the plain name: by their bytes, capitals come first.
TEST(InitCommand, TheOriginalIsKeptAndNotItsCopies) {
  const Workplace work;
  for (const std::string name : {"door.plc", "Copy of door.plc", "door (2).plc", "DOOR_OLD.PLC", "door - копия.plc"})
    work.Write(name, "$\nU4A0=I0A0\n");
  work.Write("Old.plc", "U4A1=I0A0\n");
  work.Write("spindle.plc", "U4A1=I0A0\n");
  const Ran init = work.Run("init");
  EXPECT_EQ(init.code, 0) << init;
  EXPECT_THAT(work.Read("plcxx.yaml"), HasSubstr("sources: [door.plc, spindle.plc]")) << init;
  EXPECT_THAT(init.out, AllOf(HasSubstr("Copy of door.plc    left out  the same bytes as door.plc"),
                              HasSubstr("left out  the same bytes as spindle.plc")))
      << init;
}

// A service runs what lies in the root of the repository, and there is no project.
TEST(InitCommand, APipelineIsForTheRootOfTheRepository) {
  const Workplace work;
  fs::create_directories(work.Path(".git"));
  work.Write(".git/config", "[remote \"origin\"]\n\turl = https://github.com/x/y\n");
  for (const std::string name : {"machines/M1", "machines/M2", "machines/M 3"}) {
    fs::create_directories(work.Path(name));
    work.Write(name + "/p.plc", "$\nU4A0=I0A0\n");
  }
  EXPECT_THAT(work.Run("init machines/M1").out, HasSubstr(" .github/workflows/plcxx_machines_M1.yml\n"));
  EXPECT_THAT(work.Run("init", "", "", "machines/M2").out,
              HasSubstr(" ../../.github/workflows/plcxx_machines_M2.yml\n"));
  EXPECT_FALSE(work.Has("machines/M1/.github"));
  EXPECT_THAT(work.Read(".github/workflows/plcxx_machines_M2.yml"),
              AllOf(HasSubstr("- run: plcxx check\n      working-directory: machines/M2\n"),
                    HasSubstr("--junit results.xml\n      working-directory: machines/M2\n"),
                    HasSubstr("'pull_request'\n      working-directory: machines/M2\n")));
  EXPECT_EQ(work.Run("init 'machines/M 3' --pipeline gitlab").code, 0);
  const std::string gitlab = work.Read(".gitlab-ci.yml");
  EXPECT_THAT(gitlab, AllOf(HasSubstr("  script:\n  - 'cd ''machines/M 3'''\n"), HasSubstr("machines/M 3/changes.md"),
                            HasSubstr("machines/M 3/results.xml")));
}

// git gives its tool one file: of a program in several it showed errors in the place of every difference.
TEST(InitCommand, GitComparesProgramsInOneFile) {
  const Workplace work;
  work.Write("a.plc", "$\nU4A0=I0A0\n");
  EXPECT_EQ(work.Run("init").code, 0);
  EXPECT_THAT(work.Read(".gitattributes"), AllOf(HasSubstr("--git-external"), HasSubstr("*.plc -text diff=plc\n")));
  const Workplace several;
  several.Write("a.plc", "$\nU4A0=!LAMP\n");
  several.Write("a.sym", "LAMP = I0A0\n");
  EXPECT_EQ(several.Run("init").code, 0);
  EXPECT_THAT(several.Read(".gitattributes"), AllOf(HasSubstr("program does: plcxx diff HEAD..\n"),
                                                    HasSubstr("*.plc -text\n"), Not(HasSubstr("diff=plc"))));
}

TEST(InitCommand, AMachineOfAParkMayLieDeeper) {
  const Workplace work;
  for (const std::string name : {"M1", "M1/before", "M3/PLC", "M4/fast", "M4/slow", "M5/drawings"}) {
    fs::create_directories(work.Path(name));
    if (name != "M5/drawings") work.Write(name + "/p.plc", "$\nU4A0=I0A0\n");
  }
  const Ran init = work.Run("init --pipeline none");
  EXPECT_EQ(init.code, 0) << init;
  EXPECT_THAT(init.out,
              AllOf(HasSubstr("program   M3, in M3/PLC\n"), HasSubstr("before/             left out  a folder")));
  const Ran check = work.Run("check --all");
  EXPECT_THAT(check.errors, AllOf(HasSubstr("M1: no errors"), HasSubstr("M3: no errors"),
                                  HasSubstr("M4_fast: no errors"), HasSubstr("M4_slow: no errors")))
      << check << work.Read("plcxx.yaml");
  EXPECT_THAT(work.Run("test --all --engine sim").out, HasSubstr("4 scenarios passed"));
}

// The encodings of those behind it were told one line too early: u16.sym was cp1251.
TEST(InitCommand, AFileThatCannotBeReadIsToldAsOne) {
  const Workplace work;
  work.Write("a.plc", "$\nU4A0=I0A0 ; \xA4\xA0\n");
  work.Write("u16.sym", std::string("\xFF\xFE*\0 \0x\0\n\0", 10));
  work.Write("w.sym", "* \xE8\xEC\xE5\xED\xE0 \xF1\xE8\xE3\xED\xE0\xEB\xEE\xE2\nA = I0A0\n");
  const Ran init = work.Run("init --dialect nc110");
  EXPECT_EQ(init.code, 0) << init;
  EXPECT_THAT(init.out, AllOf(HasSubstr("a.plc               source    cp866, by its extension\n"),
                              HasSubstr("u16.sym             source    by its extension, but it cannot be read\n"),
                              HasSubstr("w.sym               source    cp1251, by its extension\n")));
}

TEST(InitCommand, FoldersBesideAProgramAreNamed) {
  const Workplace work;
  fs::create_directories(work.Path("mill"));
  work.Write("a.plc", "$\nU4A0=I0A0\n");
  work.Write("mill/b.plc", "$\nU4A1=I0A0\n");
  const Ran init = work.Run("init");
  EXPECT_EQ(init.code, 0) << init;
  EXPECT_THAT(init.out, HasSubstr("mill/               left out  a folder with sources of its own"));
}

// A project of the author's ClassicLadder 0.9 reads like one of LinuxCNC and is none: what checks with an error
// whatever is done about it is not written, and what to do is said at once.
TEST(InitCommand, AProjectOfAnotherLadderIsNoProgram) {
  constexpr const char* kAuthors =
      "_FILES_CLASSICLADDER\n_FILE-sections.csv\n000,0,-1,0,0,0\n_/FILE-sections.csv\n"
      "_FILE-timers.csv\n#VER=2.0\nT0,1,5\n_/FILE-timers.csv\n_/FILES_CLASSICLADDER\n";
  const Workplace work;
  work.Write("press.clprj", kAuthors);
  const Ran alone = work.Run("init");
  EXPECT_EQ(alone.code, 1) << alone;
  EXPECT_THAT(alone.out, HasSubstr("press.clprj         left out  version 2.0 of part 'timers.csv'"));
  EXPECT_THAT(alone.errors, AllOf(HasSubstr("nothing was written, for there is no program: press.clprj: "),
                                  HasSubstr("draw its rungs in LinuxCNC's ClassicLadder")));
  EXPECT_FALSE(work.Has("plcxx.yaml"));
  EXPECT_FALSE(work.Has(".gitattributes"));
  // Beside a project that LinuxCNC saved it is left out.
  work.Write("press.clp",
             "_FILES_CLASSICLADDER\n_FILE-sections.csv\n000,0,-1,0,0,0\n_/FILE-sections.csv\n_FILE-rung_0.csv\n"
             "1-0-50/0 , 50-0-60/0\n_/FILE-rung_0.csv\n_/FILES_CLASSICLADDER\n");
  EXPECT_EQ(work.Run("init").code, 0);
  EXPECT_THAT(work.Read("plcxx.yaml"), HasSubstr("sources: [press.clp]"));
  EXPECT_EQ(work.Run("check").code, 0);
}

// What comes next depends on whether there is a program to test.
TEST(InitCommand, WithErrorsTheNextStepIsToReadThem) {
  const Workplace work;
  work.Write("a.plc", kBadProgram);
  EXPECT_THAT(work.Run("init").out,
              HasSubstr("next      plcxx check shows the errors; plcxx test and plcxx emit work"));
  const Workplace good;
  good.Write("a.plc", kGoodProgram);
  EXPECT_THAT(good.Run("init").out, HasSubstr("next      plcxx check, plcxx test, plcxx emit\n"));
}

TEST(InitCommand, NamesWithALinesEnd) {
  const Workplace work;
  work.Write("a\nb.plc", kGoodProgram);
  EXPECT_EQ(work.Run("init").code, 0);
  const Ran check = work.Run("check");
  EXPECT_EQ(check.code, 0) << check << work.Read("plcxx.yaml");
}

TEST(InitCommand, WhereNothingIsToBeFound) {
  const Workplace work;
  work.Write("letter.doc", "Dear Sirs\n");
  const Ran init = work.Run("init");
  EXPECT_EQ(init.code, 1) << init;
  EXPECT_THAT(init.errors, HasSubstr("no file in '.' is a source that plcxx knows"));
  EXPECT_FALSE(work.Has("plcxx.yaml"));
  EXPECT_EQ(work.Run("init nowhere").code, 2);
  EXPECT_EQ(work.Run("init --dialect cobol").code, 2);
}

}  // namespace
}  // namespace plcxx::driver
