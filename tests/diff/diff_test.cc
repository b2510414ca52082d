// plcxx diff: verdicts that are worked out by hand on small programs.
#include "transpiler/review/diff/diff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "tests/temporary_directory.h"
#include "transpiler/driver/diff_output.h"

namespace plcxx::review::diff {
namespace {

struct Compared {
  Diff diff;
  const DiffItem* Find(const std::string& name) const {
    const auto at = std::ranges::find(diff.items, name, &DiffItem::name);
    return at == diff.items.end() ? nullptr : &*at;
  }
};

Compared CompareTexts(const std::string& old_text, const std::string& new_text, DiffOptions options = {},
                      const std::string& dialect = "nc110") {
  const testing_support::TemporaryDirectory directory;
  const auto side = [&directory, &dialect](const std::string& name, const std::string& text) {
    compilation::CompilationRequest request;
    request.sources = {directory.Write(name, text)};
    request.dialect = dialect;
    return MakeDiffSide(name, request);
  };
  DiffSide old_side = side("old.plc", old_text), new_side = side("new.plc", new_text);
  EXPECT_TRUE(old_side.compilation.ok());
  EXPECT_TRUE(new_side.compilation.ok());
  Compared compared{CompareSides(old_side, new_side, options)};
  EXPECT_EQ(compared.diff.refusal, "");
  return compared;
}

std::string NamesOf(const Diff& diff) {
  std::string names;
  for (const DiffItem& item : diff.items) names += item.name + " ";
  return names;
}

TEST(Diff, LogicWrittenInAnotherWayIsEqual) {
  const Compared compared = CompareTexts("U4A8=I0A3*I0A4+I0A3*I0A5\n$\nU4A9=/(I0A6+U4A8)\n", "$\nU4A9=/I0A6*/U4A8\n");
  EXPECT_NE(compared.Find("U4A8"), nullptr);  // gone: no longer equal
  const Compared equal =
      CompareTexts("U4A8=I0A3*I0A4+I0A3*I0A5\n$\nU4A9=/(I0A6+U4A8)\n", "U4A8=I0A3*(I0A5+I0A4)\n$\nU4A9=/I0A6*/U4A8\n");
  EXPECT_EQ(NamesOf(equal.diff), "");
  EXPECT_GE(equal.diff.equal, 2U);
}

TEST(Diff, AFlagOfOneVersionAloneIsNoDifference) {
  const std::string before = "$\nU4A8=I0A3*I0A4*I0A5\n", after = "$\nU200K0=I0A3*I0A4\nU4A8=U200K0*I0A5\n";
  EXPECT_EQ(NamesOf(CompareTexts(before, after).diff), "");
  EXPECT_EQ(NamesOf(CompareTexts(after, before).diff), "");
  // What it holds from scan to scan may be anything.
  const Compared late = CompareTexts(before, "$\nU4A8=U200K0*I0A5\nU200K0=I0A3*I0A4\n");
  EXPECT_EQ(NamesOf(late.diff), "U4A8 ");
  EXPECT_EQ(late.diff.items.front().verdict, ItemVerdict::kDifferent);
  const Compared timer = CompareTexts("$\nU4A8=I0A3\n", "$\nT0I(10)=I0A3\nU4A8=I0A3+T0U\n");
  EXPECT_EQ(NamesOf(timer.diff), "");
}

TEST(Diff, ABrokenInterlockIsShownByItsShortestRun) {
  const Compared compared =
      CompareTexts("$\nU4A8=I0A3*/I0A4\nU4A9=U4A8*I0A5\nU4A10=I0A6\n", "$\nU4A8=I0A3\nU4A9=U4A8*I0A5\nU4A10=I0A6\n");
  EXPECT_EQ(NamesOf(compared.diff), "U4A8 U4A9 ");
  const DiffItem* const broken = compared.Find("U4A8");
  ASSERT_NE(broken, nullptr);
  EXPECT_EQ(broken->verdict, ItemVerdict::kDifferent);
  EXPECT_TRUE(broken->changed_itself);
  ASSERT_EQ(broken->new_statements.size(), 1U);
  EXPECT_EQ(broken->new_statements[0].text, "U4A8=I0A3");
  EXPECT_TRUE(broken->new_statements[0].changed);
  ASSERT_TRUE(broken->counterexample.has_value());
  EXPECT_EQ(broken->counterexample->replay, Replay::kSimulator);
  EXPECT_EQ(broken->counterexample->steps, "I0A3=1, I0A4=1, slow 1");
  EXPECT_EQ(broken->counterexample->old_value, "0");
  EXPECT_EQ(broken->counterexample->new_value, "1");
  const DiffItem* const follows = compared.Find("U4A9");
  ASSERT_NE(follows, nullptr);
  EXPECT_EQ(follows->verdict, ItemVerdict::kDifferent);
  EXPECT_EQ(follows->through, std::vector<std::string>{"U4A8"});
}

TEST(Diff, ALatchThatHoldsLongerIsFound) {
  // Both set alike; only after I0A4 has come and gone they differ.
  const Compared compared = CompareTexts("$\nU4A8=I0A3+U4A8*/I0A4\n", "$\nU4A8=I0A3+U4A8\n");
  const DiffItem* const item = compared.Find("U4A8");
  ASSERT_NE(item, nullptr);
  ASSERT_TRUE(item->counterexample.has_value());
  EXPECT_EQ(item->counterexample->replay, Replay::kSimulator);
  EXPECT_EQ(item->counterexample->steps, "I0A3=1, slow 1, I0A3=0, I0A4=1, slow 1");
}

TEST(Diff, ATimeThatChangedIsFoundByWaiting) {
  const Compared compared = CompareTexts("$\nT0I(10)=I0A3\nU4A8=T0U\n", "$\nT0I(20)=I0A3\nU4A8=T0U\n");
  const DiffItem* const item = compared.Find("U4A8");
  ASSERT_NE(item, nullptr);
  EXPECT_EQ(item->verdict, ItemVerdict::kDifferent);
  ASSERT_TRUE(item->counterexample.has_value());
  EXPECT_EQ(item->counterexample->replay, Replay::kSimulator);
}

TEST(Diff, EqualWhereItCanBeReachedOnly) {
  // Two flags that are never 1 together; from an arbitrary state the versions differ.
  const std::string flags = "$\nU20K0=I0A3*/I0A4\nU20K1=I0A4*/I0A3\n";
  const Compared compared = CompareTexts(flags + "U4A8=U20K0*/U20K1\n", flags + "U4A8=U20K0\n");
  EXPECT_EQ(NamesOf(compared.diff), "");
  // The flags hold for a scan: only an invariant tells that they exclude each other.
  const std::string later = "$\nU4A8=U20K0*/U20K1\nU20K0=I0A3*/I0A4\nU20K1=I0A4*/I0A3\n";
  const std::string later_new = "$\nU4A8=U20K0\nU20K0=I0A3*/I0A4\nU20K1=I0A4*/I0A3\n";
  const Compared reachable = CompareTexts(later, later_new);
  EXPECT_EQ(NamesOf(reachable.diff), "");
  EXPECT_GE(reachable.diff.invariants, 1U);
}

TEST(Diff, APresetThatChangedByALittleIsFound) {
  // Both are longer than any wait that does not know them, and differ in a tenth of a second only.
  const Compared compared = CompareTexts("$\nT1I(255)=I0A3\nU4A8=T1U\n", "$\nT1I(254)=I0A3\nU4A8=T1U\n");
  const DiffItem* const item = compared.Find("U4A8");
  ASSERT_NE(item, nullptr);
  EXPECT_EQ(item->verdict, ItemVerdict::kDifferent);
  ASSERT_TRUE(item->counterexample.has_value());
  EXPECT_EQ(item->counterexample->replay, Replay::kSimulator);
  EXPECT_FALSE(item->counterexample->from_state);
}

TEST(Diff, ALimitOfACounterIsFoundByCounting) {
  const Compared compared = CompareTexts("$\nC1I(30)=I0A3\nU4A8=[C1W=0]\n", "$\nC1I(31)=I0A3\nU4A8=[C1W=0]\n");
  const DiffItem* const item = compared.Find("U4A8");
  ASSERT_NE(item, nullptr);
  EXPECT_EQ(item->verdict, ItemVerdict::kDifferent);
  ASSERT_TRUE(item->counterexample.has_value());
  EXPECT_FALSE(item->counterexample->from_state);
}

TEST(Diff, WhatOnlyTheOtherVersionReadsCounts) {
  // An edge with a flag instead of a one-shot: equal, since flag and memory of the one-shot are always alike.
  const std::string one_shot = "$\nP1=I0A3\nU4A8=P1\nU20K0=I0A3\n";
  const Compared compared = CompareTexts(one_shot, "$\nP1=I0A3\nU4A8=I0A3*/U20K0\nU20K0=I0A3\n");
  EXPECT_EQ(NamesOf(compared.diff), "");
}

TEST(Diff, ANumberStaysBelowAConstant) {
  // 24 positions: too many to list them, and no short run comes to the last one.
  const std::string turret = "DOF: I0A3*/U20K0\nW30K0=[W30K0+1]\nENDF\nDOF: [W30K0>23]\nW30K0=0\nENDF\nU20K0=I0A3\n";
  const Compared compared = CompareTexts("$\nU4A8=[W30K0=23]\n" + turret, "$\nU4A8=[W30K0>22]\n" + turret);
  EXPECT_EQ(NamesOf(compared.diff), "");
  EXPECT_GE(compared.diff.invariants, 1U);
}

TEST(Diff, TimersThatChangedTheirNumbersAreTheSameByMap) {
  const std::string before = "$\nT1I(10)=I0A3\nU4A8=T1U\nT2I(20)=I0A4\nU4A9=T2U\n";
  const std::string after = "$\nT2I(10)=I0A3\nU4A8=T2U\nT1I(20)=I0A4\nU4A9=T1U\n";
  EXPECT_EQ(NamesOf(CompareTexts(before, after, {.same = {{"T1U", "T2U"}, {"T2U", "T1U"}}}).diff), "");
}

TEST(Diff, WhatTheProgramStartsWithCounts) {
  // The only difference is a value that a variable has from power-on on, or that init() gives it.
  const std::string parts = "#include \"plc.h\"\nvoid plc1() {}\nvoid plc2() { Y[0] = n; }\n";
  const auto verdict = [&parts](const std::string& old_rest, const std::string& new_rest) {
    const Compared compared = CompareTexts(old_rest + parts, new_rest + parts, {}, "hnc");
    const DiffItem* const item = compared.Find("Y[0]");
    return item == nullptr ? ItemVerdict::kEqual : item->verdict;
  };
  EXPECT_EQ(verdict("void init() {}\nstatic int n = 5;\n", "void init() {}\nstatic int n = 6;\n"),
            ItemVerdict::kDifferent);
  EXPECT_EQ(verdict("static int n;\nvoid init() { n = 5; }\n", "static int n;\nvoid init() { n = 6; }\n"),
            ItemVerdict::kDifferent);
}

TEST(Diff, WhatHasNoNameIsInNoScenario) {
  const Compared compared = CompareTexts("$\nT0I(10)=I0A3\nU4A8=T0U\n", "$\nT0I(20)=I0A3\nU4A8=T0U\n");
  for (const DiffItem& item : compared.diff.items) {
    if (!item.counterexample || item.name.find('.') == std::string::npos) continue;
    EXPECT_EQ(item.counterexample->scenario, "") << item.name;
  }
}

TEST(Diff, AnInputThatMovedIsTheSameByMap) {
  const Compared moved = CompareTexts("$\nU4A8=I0A3\n", "$\nU4A8=I0A5\n");
  EXPECT_EQ(NamesOf(moved.diff), "U4A8 ");
  const Compared mapped = CompareTexts("$\nU4A8=I0A3\n", "$\nU4A8=I0A5\n", {.same = {{"I0A3", "I0A5"}}});
  EXPECT_EQ(NamesOf(mapped.diff), "");
}

TEST(Diff, OrderCountsOnlyWhereItIsRead) {
  const Compared equal = CompareTexts("$\nU4A8=I0A3\nU4A9=I0A4\n", "$\nU4A9=I0A4\nU4A8=I0A3\n");
  EXPECT_EQ(NamesOf(equal.diff), "");
  // One scan later is another behaviour.
  const Compared later = CompareTexts("$\nU20K0=I0A3\nU4A8=U20K0\n", "$\nU4A8=U20K0\nU20K0=I0A3\n");
  EXPECT_EQ(NamesOf(later.diff), "U4A8 ");
  EXPECT_EQ(later.diff.items[0].counterexample->steps, "I0A3=1, slow 1");
}

TEST(Diff, ChangedStatementsAreToldFromTheirWake) {
  const std::string rest = "U200K1=U200K0*I0A5\nU4A8=U200K1+I0A6\n";
  const Compared compared = CompareTexts("$\nU200K0=I0A3*I0A4\n" + rest, "$\nU200K0=I0A3+I0A4\n" + rest);
  EXPECT_EQ(NamesOf(compared.diff), "U4A8 U200K0 U200K1 ");
  EXPECT_TRUE(compared.Find("U200K0")->changed_itself);
  EXPECT_FALSE(compared.Find("U200K1")->changed_itself);
  EXPECT_FALSE(compared.Find("U4A8")->changed_itself);
  EXPECT_EQ(compared.Find("U4A8")->through, std::vector<std::string>{"U200K1"});
}

TEST(Diff, AValueThatDiffersInTheMiddleOfAScanHasItsStatementShown) {
  // Behind the scan U20K0 is the same in both; U4A8 has read it before.
  const std::string rest = "U4A8=U20K0*I0A5\nU20K0=I0A6\n";
  const Compared compared = CompareTexts("$\nU20K0=I0A3*I0A4\n" + rest, "$\nU20K0=I0A3\n" + rest);
  EXPECT_EQ(NamesOf(compared.diff), "U4A8 ");
  const DiffItem& item = compared.diff.items[0];
  EXPECT_EQ(item.verdict, ItemVerdict::kDifferent);
  ASSERT_EQ(item.new_statements.size(), 2U);
  EXPECT_EQ(item.new_statements[1].text, "U20K0=I0A3");
  EXPECT_TRUE(item.new_statements[1].changed);
}

TEST(Diff, WhatFollowsFromAChangeThatReachesEverythingIsShown) {
  // A row of flags, each a scan behind the one before it; the change is at its beginning, behind inputs that no random
  // run sets alike. The solver finds them; from the end of its run the search goes on.
  std::string row, condition;
  for (int i = 499; i > 0; --i) {
    const auto name = [](int k) { return "U" + std::to_string(200 + k / 32) + "K" + std::to_string(k % 32); };
    row += name(i) + "=" + name(i - 1) + "\n";
  }
  for (int i = 0; i < 28; ++i) condition += (i == 0 ? "I0A" : i % 3 == 0 ? "*I0A" : "*/I0A") + std::to_string(i);
  const Compared compared = CompareTexts("$\n" + row + "U200K0=" + condition + "\n",
                                         "$\n" + row + "U200K0=" + condition + "*I1A0\n", {.time_ms = 60'000});
  EXPECT_EQ(std::ranges::count_if(compared.diff.items, &DiffItem::changed_itself), 1);
  EXPECT_TRUE(compared.diff.items[0].changed_itself);
  EXPECT_EQ(compared.diff.items[0].verdict, ItemVerdict::kDifferent);
  EXPECT_GT(std::ranges::count(compared.diff.items, ItemVerdict::kDifferent, &DiffItem::verdict), 100);
  const std::string text =
      driver::DiffText(compared.diff, {.old_label = "old", .new_label = "new"}, diag::Colour::kOff);
  EXPECT_NE(text.find("through U200K0"), std::string::npos) << text;
  EXPECT_LT(std::ranges::count(text, '\n'), 40) << text;
}

// Who has read and compiled both versions has spent a part of the time; where nothing is left, nothing is claimed.
TEST(Diff, TheTimeCountsFromWhereTheCommandBegins) {
  const auto now = std::chrono::steady_clock::now();
  const DiffOptions options{.time_ms = 60'000, .begin = now - std::chrono::seconds(60)};
  const Compared compared = CompareTexts("$\nU4A8=I0A3*/I0A4+I0A5\n", "$\nU4A8=I0A3+I0A5*I0A3\n", options);
  EXPECT_LT(std::chrono::steady_clock::now() - now, std::chrono::seconds(30));
  ASSERT_NE(compared.Find("U4A8"), nullptr);
  EXPECT_EQ(compared.Find("U4A8")->verdict, ItemVerdict::kUndecided);
  EXPECT_EQ(compared.Find("U4A8")->reason, "the time was not enough");
}

TEST(DiffOutput, SaysTheSameInEveryForm) {
  const Compared compared = CompareTexts("$\nU4A8=I0A3*/I0A4\n", "$\nU4A8=I0A3\n");
  const driver::DiffNames names{"old", "new"};
  EXPECT_NE(driver::DiffText(compared.diff, names, diag::Colour::kOff).find("old -> new: 1 output differs; "),
            std::string::npos);
  EXPECT_NE(driver::DiffMarkdown(compared.diff, names).find("| `U4A8` | different |"), std::string::npos);
  EXPECT_NE(driver::DiffJson(compared.diff, names).find("\"steps\": \"I0A3=1, I0A4=1, slow 1\""), std::string::npos);
  EXPECT_NE(driver::DiffSarif(compared.diff, names).find("\"ruleId\": \"behaviour-differs\""), std::string::npos);
}

}  // namespace
}  // namespace plcxx::review::diff
