#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transpiler/diagnostics/diagnostics.h"

namespace plcxx::diag {
namespace {

using testing::ElementsAre;

// Rows of our own: the catalogue's wording may change without touching these tests.
constexpr Message<Text, Number> kBrokenTimes{
    {"Broken", "test-1", Severity::kError, "'{0}' is broken {1} times", "mend '{0}'"}};
constexpr Message<> kOdd{{"Odd", "test-W7", Severity::kWarning, "this is odd", ""}};
constexpr Message<> kOther{{"Other", "test-W8", Severity::kWarning, "this is other", ""}};
constexpr Message<> kRare{{"Rare", "test-W9", Severity::kWarning, "this is rare", "", true}};

std::vector<std::string> Texts(const Engine& engine) {
  std::vector<std::string> texts;
  for (const Diagnostic& diagnostic : engine.all()) texts.push_back(diagnostic.text);
  return texts;
}

TEST(Format, FillsIn) {
  EXPECT_EQ(Format("{1} before {0}, {1}", {"a", "b"}), "b before a, b");
  EXPECT_EQ(Format("{{0} is {0}", {"x"}), "{0} is x");
  EXPECT_EQ(Format("}", {}), "}");
  EXPECT_EQ(Format("", {}), "");
  EXPECT_EQ(Format("{0}", {"{1}"}), "{1}") << "what is filled in is not read again";
}

TEST(FormatDeathTest, AWrongRowIsOurFault) {
  EXPECT_EXIT(Format("{2}", {"a"}), testing::ExitedWithCode(3), "args");
  EXPECT_EXIT(Format("{", {"a"}), testing::ExitedWithCode(3), "pattern");
  EXPECT_EXIT(Format("{x}", {"a"}), testing::ExitedWithCode(3), "args");
}

TEST(Engine, ReportsWithParameters) {
  Engine engine;
  engine.Report({3, 5}, kBrokenTimes, "I0A7", 12).notes.push_back({{1, 2}, "here"});
  ASSERT_EQ(engine.all().size(), 1u);
  const Diagnostic& diagnostic = engine.all().front();
  EXPECT_EQ(diagnostic.text, "'I0A7' is broken 12 times");
  EXPECT_EQ(diagnostic.remedy, "mend 'I0A7'");
  EXPECT_EQ(diagnostic.range, (source::Range{3, 5}));
  EXPECT_EQ(diagnostic.severity, Severity::kError);
  EXPECT_EQ(diagnostic.notes.size(), 1u);
  EXPECT_TRUE(engine.HasErrors());
  EXPECT_EQ(engine.error_count(), 1u);
  EXPECT_EQ(engine.warning_count(), 0u);
}

TEST(Engine, TheRowOutlivesItsMessage) {
  Engine engine;
  {
    const auto copy = UnknownDialect;
    engine.Report({}, copy, "a", "b");
  }
  EXPECT_EQ(engine.all().front().row->code, "plcxx-1");
}

TEST(Engine, KeepsARepetitionOnce) {
  Engine engine;
  engine.Report({3, 5}, kOdd);
  engine.Report({3, 5}, kOdd).notes.push_back({{}, "lost"});
  engine.Report({3, 6}, kOdd);
  engine.Report({3, 5}, kBrokenTimes, "a", 1);
  engine.Report({3, 5}, kBrokenTimes, "b", 1);
  engine.Report({3, 5}, kBrokenTimes, "b", 1);
  EXPECT_EQ(engine.all().size(), 4u);
  EXPECT_TRUE(engine.all().front().notes.empty());
  EXPECT_EQ(engine.error_count(), 2u);
  EXPECT_EQ(engine.warning_count(), 2u);
}

TEST(Engine, AWarningIsMadeAnError) {
  Engine engine;
  engine.MakeError(kOdd.row);
  engine.Report({}, kOdd);
  engine.Report({}, kOther);
  EXPECT_EQ(engine.error_count(), 1u);
  EXPECT_EQ(engine.warning_count(), 1u);
  Engine silent({.disabled = {"W7"}});
  silent.MakeError(kOdd.row);
  silent.Report({}, kOdd);
  EXPECT_FALSE(silent.HasErrors()) << "-Wno- wins";
}

TEST(Engine, WarningsAreSwitchedOffByEitherName) {
  for (const char* name : {"W7", "test-W7"}) {
    Engine engine({.disabled = {name}});
    EXPECT_FALSE(engine.Enabled(kOdd.row));
    engine.Report({}, kOdd).notes.push_back({{}, "goes nowhere"});
    engine.Report({}, kOther);
    EXPECT_THAT(Texts(engine), ElementsAre("this is other"));
    EXPECT_EQ(engine.warning_count(), 1u);
  }
}

TEST(Engine, OtherNamesDoNotSwitchOff) {
  for (const char* name : {"W", "7", "W70", "other-W7", "test"}) {
    EXPECT_TRUE(Engine({.disabled = {name}}).Enabled(kOdd.row)) << name;
  }
}

TEST(Engine, ErrorsCannotBeSwitchedOff) {
  Engine engine({.disabled = {"1", "test-1"}});
  engine.Report({}, kBrokenTimes, "a", 1);
  EXPECT_TRUE(engine.HasErrors());
}

TEST(Engine, SomeRowsAreOffUnlessAskedFor) {
  EXPECT_FALSE(Engine().Enabled(kRare.row));
  EXPECT_TRUE(Engine({.enabled = {"W9"}}).Enabled(kRare.row));
  EXPECT_TRUE(Engine({.errors = {"test-W9"}}).Enabled(kRare.row));
  EXPECT_FALSE(Engine({.enabled = {"W8"}}).Enabled(kRare.row));
}

TEST(Engine, TheWholeNameDecidesBeforeTheShortOne) {
  EXPECT_TRUE(Engine({.enabled = {"test-W7"}, .disabled = {"W7"}}).Enabled(kOdd.row));
  EXPECT_FALSE(Engine({.enabled = {"W7"}, .disabled = {"test-W7"}}).Enabled(kOdd.row));
}

TEST(Engine, WarningsBecomeErrors) {
  Engine all({.all_errors = true});
  all.Report({}, kOdd);
  EXPECT_TRUE(all.HasErrors());
  EXPECT_EQ(all.warning_count(), 0u);

  Engine one({.errors = {"W7"}});
  one.Report({}, kOther);
  EXPECT_FALSE(one.HasErrors());
  one.Report({}, kOdd);
  EXPECT_TRUE(one.HasErrors());
  EXPECT_EQ(one.all().back().severity, Severity::kError);
  EXPECT_EQ(one.all().back().row->severity, Severity::kWarning);
}

TEST(Engine, SortsBySourceAndKeepsTheOrderOfTies) {
  Engine engine;
  engine.Report({9, 9}, kBrokenTimes, "z", 1);
  engine.Report({5, 9}, kBrokenTimes, "b", 1);
  engine.Report({5, 6}, kOdd);
  engine.Report({5, 6}, kBrokenTimes, "a", 1);
  engine.Report({}, kOther);
  engine.SortBySource();
  EXPECT_THAT(Texts(engine), ElementsAre("this is other", "'b' is broken 1 times", "this is odd",
                                         "'a' is broken 1 times", "'z' is broken 1 times"));
}

TEST(Engine, StopsAtTheFirstError) {
  Engine engine;
  engine.Report({9, 9}, kBrokenTimes, "z", 1);
  engine.Report({5, 9}, kBrokenTimes, "b", 1);
  engine.Report({1, 2}, kOdd);
  engine.Report({7, 8}, kOther);
  engine.KeepFirstErrorOnly();
  EXPECT_THAT(Texts(engine), ElementsAre("this is odd", "'b' is broken 1 times"));
  EXPECT_EQ(engine.error_count(), 1u);
  EXPECT_EQ(engine.warning_count(), 1u);
  engine.Report({9, 9}, kBrokenTimes, "z", 1);
  EXPECT_EQ(engine.error_count(), 2u) << "what was dropped may be reported again";
}

TEST(Engine, LimitsTheErrorsAndKeepsTheRest) {
  Engine engine;
  engine.Report({9, 9}, kBrokenTimes, "z", 1);
  engine.Report({1, 2}, kBrokenTimes, "a", 1);
  engine.Report({5, 9}, kBrokenTimes, "b", 1);
  engine.Report({11, 12}, kOdd);
  engine.LimitErrors(3);
  EXPECT_EQ(engine.error_count(), 3u);
  engine.LimitErrors(1);
  EXPECT_THAT(Texts(engine), ElementsAre("'a' is broken 1 times", "this is odd"));
  EXPECT_EQ(engine.error_count(), 1u);
  EXPECT_EQ(engine.warning_count(), 1u);
  ASSERT_EQ(engine.all().front().notes.size(), 1u);
  EXPECT_EQ(engine.all().front().notes.front().range, (source::Range{5, 9}));
}

TEST(Engine, MovesPlaces) {
  Engine engine;
  engine.Report({5, 9}, kBrokenTimes, "b", 1);
  engine.Report({2, 3}, kOdd);
  engine.MovePlaces([](source::Range range) { return range.begin == 5 ? source::Range{1, 2} : range; });
  EXPECT_EQ(engine.all()[0].range, (source::Range{1, 2}));
  ASSERT_EQ(engine.all()[0].notes.size(), 1u);
  EXPECT_EQ(engine.all()[0].notes[0].range, (source::Range{5, 9}));
  EXPECT_TRUE(engine.all()[1].notes.empty());
}

TEST(Engine, NotesAreBelowWarnings) {
  constexpr Message<> kNote{{"Note", "test-N1", Severity::kNote, "this was chosen", ""}};
  Engine engine({.all_errors = true});
  engine.Report({1, 2}, kNote);
  EXPECT_FALSE(engine.HasErrors());
  EXPECT_EQ(engine.warning_count(), 0u);
  EXPECT_EQ(engine.note_count(), 1u);
  Engine named({.errors = {"N1"}});
  named.Report({1, 2}, kNote);
  EXPECT_TRUE(named.HasErrors());
  Engine without({.disabled = {"N1"}});
  without.Report({1, 2}, kNote);
  EXPECT_TRUE(without.all().empty());
}

TEST(Engine, AForkReportsOnItsOwnUntilItIsJoined) {
  Engine engine({.errors = {"W8"}, .all_errors = false});
  engine.Report({1, 2}, kOdd);
  Engine fork = engine.Fork();
  EXPECT_EQ(fork.warning_count(), 1u);
  engine.Report({3, 4}, kOdd);
  fork.Report({1, 2}, kOdd);  // known to both
  fork.Report({3, 4}, kOdd);  // the same again
  fork.Report({5, 6}, kOther).notes.push_back({{7, 8}, "because of this"});
  fork.Report({5, 6}, kRare);  // off
  EXPECT_FALSE(engine.HasErrors());
  engine.Join(std::move(fork));
  EXPECT_THAT(Texts(engine), ElementsAre("this is odd", "this is odd", "this is other"));
  EXPECT_EQ(engine.all().back().notes.size(), 1u);
  EXPECT_EQ(engine.error_count(), 1u);
  EXPECT_EQ(engine.warning_count(), 2u);
  engine.Report({5, 6}, kOther);
  EXPECT_EQ(engine.all().size(), 3u);
}

TEST(Engine, WhatAForkHasOnlyCountedIsCounted) {
  Engine engine;
  for (uint32_t i = 0; i < Engine::kMostKept - 1; ++i) engine.Report({i, i + 1}, kOdd);
  Engine fork = engine.Fork();
  for (uint32_t i = 0; i < 3; ++i) fork.Report({100'000 + i, 100'000 + i}, kOdd);  // of which it keeps one
  engine.Report({200'000, 200'000}, kOdd);
  engine.Join(std::move(fork));
  EXPECT_EQ(engine.all().size(), Engine::kMostKept);
  EXPECT_EQ(engine.warning_count(), Engine::kMostKept + 3);
}

TEST(Engine, WithoutErrorsNothingIsDropped) {
  Engine engine;
  engine.Report({9, 9}, kOdd);
  engine.Report({5, 9}, kOther);
  engine.KeepFirstErrorOnly();
  EXPECT_EQ(engine.all().size(), 2u);
}

}  // namespace
}  // namespace plcxx::diag
