// Size, names, form and leftovers of the source files.
#include "tests/policy/sources.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>

namespace plcxx::policy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Sizes, FilesAreSmall) {
  Findings to_question;
  EXPECT_THAT(CheckSizes(Root(), to_question), IsEmpty());
  if (!to_question.empty()) std::cout << "above 400 lines, can they be split?\n" << Joined(to_question);
}

TEST(Sizes, FixtureIsTooLong) {
  Findings to_question;
  EXPECT_THAT(CheckSizes(Fixture("sizes"), to_question), ElementsAre("transpiler/long.cc: 601 lines"));
  EXPECT_THAT(to_question, ElementsAre("transpiler/longish.h: 401 lines"));
}

TEST(Names, SayWhatTheyMean) { EXPECT_THAT(CheckNames(Root()), IsEmpty()); }

TEST(Names, FixtureDoesNot) {
  EXPECT_THAT(CheckNames(Fixture("names")),
              ElementsAre(HasSubstr("transpiler/string_utils.h: the file's name says 'utils'"),
                          HasSubstr("string_utils.h:5: 'PlaceManager'"), HasSubstr("string_utils.h:6: 'ReadHelper'")));
}

TEST(Defaults, NoneOverAnEnumOfOurs) { EXPECT_THAT(CheckDefaults(Root()), IsEmpty()); }

TEST(Defaults, FixtureHasTwo) {
  EXPECT_THAT(CheckDefaults(Fixture("defaults")),
              ElementsAre(HasSubstr("transpiler/behind_characters.cc:11"), HasSubstr("transpiler/new.cc:5")));
}

TEST(Format, NothingToChange) { EXPECT_THAT(CheckFormat(Root()), IsEmpty()); }

TEST(Format, FixtureIsNotFormatted) {
  EXPECT_THAT(CheckFormat(Fixture("format")), ElementsAre("transpiler/crooked.cc:1: not formatted"));
}

TEST(Leftovers, TestsLeaveNothingBehind) { EXPECT_THAT(CheckLeftovers(Root()), IsEmpty()); }

TEST(Leftovers, FixtureDoes) {
  EXPECT_THAT(CheckLeftovers(Fixture("leftovers")), ElementsAre(HasSubstr("tests/leaves_files_test.cc:2: 'TempDir('")));
}

TEST(Scripts, MayBeExecuted) { EXPECT_THAT(CheckScripts(Root()), IsEmpty()); }

TEST(Scripts, FixtureHasOneThatMayNot) {
  EXPECT_THAT(CheckScripts(Fixture("scripts")), ElementsAre("dev/forgotten:1: not executable"));
}

TEST(Scripts, ARuleWithoutScriptsFails) {
  EXPECT_THAT(CheckScripts(Fixture("generated")), ElementsAre("there are no scripts"));
}

}  // namespace
}  // namespace plcxx::policy
