// What no committed text contains.
#include "tests/policy/texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plcxx::policy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Generated, SamplesKeepNothingOfTheirMaking) { EXPECT_THAT(CheckGenerated(Root()), IsEmpty()); }

TEST(Generated, FixtureDoes) {
  EXPECT_THAT(CheckGenerated(Fixture("generated")),
              ElementsAre(HasSubstr(":1: version"), HasSubstr(":2: date"), HasSubstr(":3: path"),
                          HasSubstr(":4: line number"), HasSubstr(":5: line number")));
}

TEST(NamedFiles, AreThere) { EXPECT_THAT(CheckNamedFiles(Root()), IsEmpty()); }

TEST(NamedFiles, FixtureNamesOneThatIsNot) {
  EXPECT_THAT(CheckNamedFiles(Fixture("named_files")),
              ElementsAre(HasSubstr("page.md:3: there is no 'docs/missing.md'")));
}

TEST(NamedFiles, ARuleWithoutDocumentsFails) {
  EXPECT_THAT(CheckNamedFiles(Fixture("generated")), ElementsAre("no document names a file"));
}

TEST(NamedSources, AreThere) { EXPECT_THAT(CheckNamedSources(Root()), IsEmpty()); }

TEST(NamedSources, FixtureNamesTwoThatAreNot) {
  EXPECT_THAT(CheckNamedSources(Fixture("named_sources")),
              ElementsAre(HasSubstr("transpiler/ir/here.h:2: there is no 'moved.h'"),
                          HasSubstr("transpiler/ir/here.h:5: there is no 'ir/gone.cc'")));
}

TEST(NamedSources, ARuleWithoutCommentsFails) {
  EXPECT_THAT(CheckNamedSources(Fixture("generated")), ElementsAre("no comment names a source"));
}

TEST(NamedFolders, AllAre) { EXPECT_THAT(CheckNamedFolders(Root()), IsEmpty()); }

TEST(NamedFolders, FixtureLeavesOneOut) {
  EXPECT_THAT(CheckNamedFolders(Fixture("named_folders")),
              ElementsAre("CONTRIBUTING.md does not say what transpiler/yaml is"));
}

TEST(NamedFolders, ARuleWithoutFoldersFails) {
  EXPECT_THAT(CheckNamedFolders(Fixture("shown_files")), ElementsAre("there are no folders"));
}

// The name of a file that the reader is to write is read where the page is read.
TEST(ShownFiles, HaveTheirNameAboveThem) { EXPECT_THAT(CheckShownFiles(Root()), IsEmpty()); }

TEST(ShownFiles, FixtureHasOneWithout) {
  EXPECT_THAT(CheckShownFiles(Fixture("shown_files")),
              ElementsAre(HasSubstr("docs/page.md:13: nothing above says that this is 'b.plc'")));
}

TEST(ShownFiles, ARuleWithoutDocumentsFails) {
  EXPECT_THAT(CheckShownFiles(Fixture("generated")), ElementsAre("no document shows a file"));
}

TEST(Security, NamesEveryCommandAndEachVariable) { EXPECT_THAT(CheckSecurity(Root()), IsEmpty()); }

TEST(Security, FixtureNamesOneOfTwo) {
  EXPECT_THAT(CheckSecurity(Fixture("security")),
              ElementsAre(HasSubstr("transpiler/command.cc:2: docs/security.md does not name 'burn'"),
                          HasSubstr("transpiler/command.cc:4: docs/security.md does not name 'PLCXX_MOOD'")));
}

TEST(Security, ARuleWithoutCommandsFails) {
  EXPECT_THAT(CheckSecurity(Fixture("generated")), ElementsAre("there are no commands"));
}

TEST(Private, NothingOfAMachineOrAPerson) { EXPECT_THAT(CheckPrivate(Root()), IsEmpty()); }

TEST(Private, FixtureDoes) {
  EXPECT_THAT(CheckPrivate(Fixture("private")),
              ElementsAre(HasSubstr("notes.md:1: path of a machine"), HasSubstr("notes.md:2: e-mail address"),
                          HasSubstr("notes.md:3: registry")));
}

}  // namespace
}  // namespace plcxx::policy
