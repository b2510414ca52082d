// The command line of plcxx diff: directories, revisions of git, git's own words, and what is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/driver/run_plcxx.h"
#include "tests/temporary_directory.h"

namespace plcxx::driver {
namespace {

using testing::HasSubstr;

class DiffCommand : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(directory_.path() / "old");
    std::filesystem::create_directory(directory_.path() / "new");
    old_ = directory_.Write("old/door.plc", "$\nU4A0=I0A0*/I0A1\n");
    new_ = directory_.Write("new/door.plc", "$\nU4A0=I0A0\n");
  }

  std::string Shell(const std::string& command) const {
    return "cd '" + directory_.path().string() + "' && " + command;
  }

  testing_support::TemporaryDirectory directory_;
  std::string old_, new_;
};

TEST_F(DiffCommand, TwoDirectoriesAreTwoPrograms) {
  const PlcxxRun run = RunPlcxx("diff '" + directory_.File("old") + "' '" + directory_.File("new") + "'");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, HasSubstr("I0A0=1, I0A1=1, slow 1: 0 in the old version, 1 in the new one"));
  EXPECT_THAT(run.output, HasSubstr("1 output differs"));
}

TEST_F(DiffCommand, EqualVersionsGiveZero) {
  const PlcxxRun run = RunPlcxx("diff '" + old_ + "' '" + old_ + "'");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("no difference; "));
}

TEST_F(DiffCommand, RevisionsOfGit) {
  ASSERT_EQ(
      std::system(Shell("git init -q . && cp old/door.plc door.plc && git add door.plc && "
                        "git -c user.name=a -c user.email=a@example.com commit -q -m one && cp new/door.plc door.plc")
                      .c_str()),
      0);
  const PlcxxRun run = RunPlcxxIn(directory_.path().string(), "diff --git HEAD.. door.plc");
  EXPECT_EQ(run.exit_code, 1) << run.output << run.errors;
  EXPECT_THAT(run.output, HasSubstr("old * door.plc:2  U4A0=I0A0*/I0A1"));
  EXPECT_THAT(run.output, HasSubstr("HEAD -> the work tree: 1 output differs"));
  const PlcxxRun wrong = RunPlcxxIn(directory_.path().string(), "diff --git nowhere.. door.plc");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.errors, HasSubstr("--git: 'nowhere'"));
}

TEST_F(DiffCommand, AsAToolOfGitItIsNeverBroken) {
  const PlcxxRun run =
      RunPlcxx("diff --git-external door.plc '" + old_ + "' 1234567 100644 '" + new_ + "' 89abcde 100644");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("door.plc (old) -> door.plc (new): 1 output differs"));
}

TEST_F(DiffCommand, SaysWhatIsWrong) {
  EXPECT_THAT(RunPlcxx("diff '" + old_ + "'").errors, HasSubstr("diff takes an old and a new program"));
  EXPECT_THAT(RunPlcxx("diff '" + old_ + "' '" + new_ + "' --map I0A0").errors,
              HasSubstr("--map takes OLD=NEW, not 'I0A0'"));
  EXPECT_THAT(RunPlcxx("diff '" + old_ + "' '" + new_ + "' --map I0A0=NONE").errors,
              HasSubstr("'NONE' is no location of"));
  EXPECT_THAT(RunPlcxx("diff '" + old_ + "' '" + new_ + "' --time soon").errors, HasSubstr("'soon' is no time"));
  const PlcxxRun broken = RunPlcxx("diff '" + old_ + "' '" + directory_.Write("wrong.plc", "$\nU4A0=\n") + "'");
  EXPECT_EQ(broken.exit_code, 2);
  EXPECT_THAT(broken.errors, HasSubstr("cannot be compared: it has errors"));
}

}  // namespace
}  // namespace plcxx::driver
