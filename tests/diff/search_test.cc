// plcxx diff: where the search for runs begins, and that the time is used.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "tests/diff/compared_texts.h"
#include "transpiler/review/diff/search.h"
#include "transpiler/review/diff/shorten.h"

namespace plcxx::review::diff {
namespace {

using testing::HasSubstr;

compilation::CompilationRequest RequestOf(const testing_support::TemporaryDirectory& directory,
                                          const std::string& source = "p.plc", const std::string& dialect = "nc110") {
  compilation::CompilationRequest request;
  request.sources = {source};
  request.base_directory = directory.path().string();
  request.dialect = dialect;
  return request;
}

/// Both versions with a scenario beside the old one.
struct WithScenario {
  WithScenario(const std::string& old_text, const std::string& new_text, const std::string& scenario) {
    old_.Write("p.plc", old_text);
    new_.Write("p.plc", new_text);
    old_.Write("s.yaml", "dialect: nc110\nsources: [p.plc]\nsteps:\n" + scenario);
  }
  Diff Compared(uint64_t time_ms) const {
    DiffSide old_side = MakeDiffSide("old", RequestOf(old_)), new_side = MakeDiffSide("new", RequestOf(new_));
    return CompareSides(old_side, new_side,
                        {.same = {}, .time_ms = time_ms, .scenario_directory = old_.path().string(), .progress = {}});
  }
  testing_support::TemporaryDirectory old_, new_;
};

/// The search itself between two versions, and what it has found.
struct Searching {
  Searching(const compilation::CompilationRequest& old_request, const compilation::CompilationRequest& new_request)
      : old_side(MakeDiffSide("old", old_request)), new_side(MakeDiffSide("new", new_request)) {
    for (uint32_t i = 0; i < old_version.cells.count; ++i) {
      if (match.new_of_old[i].valid() && prove::machine::IsState(old_version, execute::CellId(i)))
        cells.emplace_back(i);
    }
    search.emplace(old_side, new_side, old_version, new_version, match, words, cells);
  }
  std::vector<execute::CellId> Named(const std::string& name) const {
    std::vector<execute::CellId> named;
    std::ranges::copy_if(cells, std::back_inserter(named),
                         [&](execute::CellId cell) { return words.WordOf(cell).name == name; });
    return named;
  }
  /// Whether the simulator shows it again, from power-on.
  bool ShowsAgain(execute::CellId cell) const {
    const RandomRuns::Difference& difference = found.difference_of.at(cell);
    const Stimuli& whole = found.runs[difference.run];
    const Shortener::Shows shows =
        ShowsDifference(old_side, new_side, old_version, new_version, {cell}, {match.new_of_old[cell.index]});
    return shows(Stimuli(whole.begin(), whole.begin() + difference.steps),
                 std::chrono::steady_clock::time_point::max());
  }

  const DiffSide old_side, new_side;
  const prove::machine::Version old_version = prove::machine::MakeVersion(old_side.whole),
                                new_version = prove::machine::MakeVersion(new_side.whole);
  const prove::diff::Match match = prove::diff::MatchCells(old_version, new_version, {});
  const CellWords words{old_version, old_side.compilation};
  std::vector<execute::CellId> cells;
  std::optional<DirectedSearch> search;
  RandomRuns found;
};

std::chrono::steady_clock::time_point Within(int seconds) {
  return std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
}

/// A code that nobody guesses, in four words one after the other; then a timer.
std::string Lock(const std::string& preset) {
  return "$\nU100K0 = [W0A0=157] + U100K0\nU100K1 = U100K0*[W0A0=46] + U100K1\n"
         "U100K2 = U100K1*[W0A0=211] + U100K2\nU100K3 = U100K2*[W0A0=98] + U100K3\nT1I(" +
         preset + ") = U100K3\nU4A0 = T1U\n";
}

TEST(Search, BeginsWithTheScenariosBesideTheProgram) {
  const WithScenario pair(Lock("30"), Lock("50"),
                          "- set: {W0A0: 157}\n- run: {slow: 1}\n- set: {W0A0: 46}\n- run: {slow: 1}\n"
                          "- set: {W0A0: 211}\n- run: {slow: 1}\n- set: {W0A0: 98}\n- run: {ms: 9000}\n");
  const Diff diff = pair.Compared(4000);
  const DiffItem* const lamp = ItemNamed(diff, "U4A0");
  ASSERT_NE(lamp, nullptr);
  ASSERT_TRUE(lamp->counterexample.has_value());
  EXPECT_EQ(lamp->verdict, ItemVerdict::kDifferent);
  EXPECT_EQ(lamp->counterexample->replay, Replay::kSimulator);
}

/// The scenario sets a symbol that has another name in the new version: it is set there all the same.
TEST(Search, ARenamedInputIsTheSameInput) {
  const testing_support::TemporaryDirectory old_directory, new_directory;
  const auto program = [](const std::string& name) {
    return "#include \"plc.h\"\nint " + name +
           ", seen;\nvoid init() { plc1_time = 1; plc2_time = 1; }\nvoid plc1() { seen = " + name +
           " + X[0]; }\nvoid plc2() { }\n";
  };
  old_directory.Write("p.cld", program("wanted"));
  new_directory.Write("p.cld", program("desired"));
  old_directory.Write("s.yaml", "dialect: hnc\nsources: [p.cld]\nsteps:\n- set: {wanted: 7}\n- run: {slow: 2}\n");
  const auto side = [](const std::string& name, const testing_support::TemporaryDirectory& directory) {
    compilation::CompilationRequest request;
    request.sources = {"p.cld"};
    request.base_directory = directory.path().string();
    request.dialect = "hnc";
    return MakeDiffSide(name, request);
  };
  DiffSide old_side = side("old", old_directory), new_side = side("new", new_directory);
  const Diff diff =
      CompareSides(old_side, new_side,
                   {.same = {}, .time_ms = 3000, .scenario_directory = old_directory.path().string(), .progress = {}});
  EXPECT_EQ(NamesIn(diff), "");
}

/// Four bytes that have to be right in one scan, on a machine that was at work for a while: nobody guesses them, and no
/// run from power-on is short. The solver is asked what has to be set from there.
TEST(Search, WhatHasToBeSetAtOnceIsComputedFromTheMachineAtWork) {
  const testing_support::TemporaryDirectory old_directory, new_directory;
  const auto program = [](const std::string& code) {
    return "#include \"plc.h\"\nint n;\nvoid init() { plc1_time = 1; plc2_time = 1; }\nvoid plc1()\n{\n"
           "    if (X[0] == 5) n++;\n    Y[0] = n > 40 && X[1] * 16777216L + X[2] * 65536L + X[3] * 256L + X[4] == " +
           code + ";\n}\nvoid plc2() { }\n";
  };
  old_directory.Write("p.cld", program("1715004L"));
  new_directory.Write("p.cld", program("1715005L"));
  old_directory.Write("s.yaml",
                      "dialect: hnc\nsources: [p.cld]\nsteps:\n- set: {\"X[0]\": 5}\n- run: {fast: 60}\n"
                      "- set: {\"X[0]\": 0}\n- run: {fast: 2}\n");
  const auto side = [](const std::string& name, const testing_support::TemporaryDirectory& directory) {
    compilation::CompilationRequest request;
    request.sources = {"p.cld"};
    request.base_directory = directory.path().string();
    request.dialect = "hnc";
    return MakeDiffSide(name, request);
  };
  DiffSide old_side = side("old", old_directory), new_side = side("new", new_directory);
  const Diff diff = CompareSides(
      old_side, new_side,
      {.same = {}, .time_ms = 40'000, .scenario_directory = old_directory.path().string(), .progress = {}});
  const DiffItem* const output = ItemNamed(diff, "Y[0]");
  ASSERT_NE(output, nullptr);
  ASSERT_TRUE(output->counterexample.has_value());
  EXPECT_EQ(output->verdict, ItemVerdict::kDifferent);
  EXPECT_FALSE(output->counterexample->from_state);
  EXPECT_EQ(output->counterexample->replay, Replay::kSimulator);
}

/// An execution that is not done in time is given up: nothing is claimed, and that is no reason to compare nothing.
TEST(Search, WhatIsNotExecutedInTimeIsNotDecided) {
  const Diff diff = WithScenario(Lock("30"), Lock("50"), "- run: {slow: 1}\n").Compared(1);
  EXPECT_EQ(diff.refusal, "");
  EXPECT_EQ(diff.equal, 0U);
  const DiffItem* const lamp = ItemNamed(diff, "U4A0");
  ASSERT_NE(lamp, nullptr);
  EXPECT_EQ(lamp->verdict, ItemVerdict::kUndecided);
  EXPECT_EQ(lamp->reason, "the time was not enough");
  EXPECT_EQ(ItemNamed(diff, "I0A0"), nullptr);
}

/// A lamp that was kept without power, and is not any more: only a power failure shows it.
TEST(Search, PowerFailsInARun) {
  const std::string text =
      "SLOW\nNETWORK \"a\"\nLD %I0\nSET %B20\nSET %B600\nLD %I1\nRST %B20\nRST %B600\nLD @\nOUT %Q0\nEND_SLOW\n";
  const Diff diff = ComparedTexts(kHost50, With(text, "%B20"), With(text, "%B600"),
                                  {.same = {}, .time_ms = 20'000, .scenario_directory = {}, .progress = {}});
  const DiffItem* const lamp = ItemNamed(diff, "Q0");
  ASSERT_NE(lamp, nullptr);
  ASSERT_TRUE(lamp->counterexample.has_value());
  EXPECT_THAT(lamp->counterexample->steps, HasSubstr("power off and on"));
  EXPECT_EQ(lamp->counterexample->replay, Replay::kSimulator);
}

/// The search goes back to moments; a difference counts because the run from power-on shows it, too.
TEST(Search, WhatIsSeenIsSeenAgainFromPowerOn) {
  const testing_support::TemporaryDirectory changed;
  const std::filesystem::path lathe = PLCXX_ROOT "/samples/nc110/lathe_16k20";
  for (const auto& entry : std::filesystem::directory_iterator(lathe)) {
    if (entry.is_regular_file()) std::filesystem::copy_file(entry.path(), changed.path() / entry.path().filename());
  }
  std::ifstream in(lathe / "turret.plc", std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  text.replace(text.find("T24I(30)"), 8, "T24I(50)");
  changed.Write("turret.plc", text);
  const auto request = [](const std::filesystem::path& directory) {
    compilation::CompilationRequest request;
    request.sources = {"lathe.sym", "fast.plc", "spindle.plc", "turret.plc"};
    request.base_directory = directory.string();
    request.options = {{"iocfil", "IOCFIL"}, {"axcfil", "AXCFIL"}, {"pgcfil", "PGCFIL"}};
    request.dialect = "nc110";
    return request;
  };
  Searching pair(request(lathe), request(changed.path()));
  pair.search->RunScenarios(Within(20), pair.found);
  pair.search->Run(pair.cells, Within(2), pair.found);
  EXPECT_GT(pair.found.difference_of.size(), 5U);
  for (const auto& [cell, difference] : pair.found.difference_of)
    EXPECT_TRUE(pair.ShowsAgain(cell)) << pair.words.WordOf(cell).name;
}

/// A code in six words one after the other, and no scenario that knows it: in hundreds of runs at once, with words that
/// the program compares with, some go through. What they show is shown in the simulator, from power-on.
TEST(Search, RunsBesideEachOtherGoThroughACode) {
  const testing_support::TemporaryDirectory old_directory, new_directory;
  const auto program = [](const std::string& input) {
    return "$\nU100K0 = [W0A0=157] + U100K0\nU100K1 = U100K0*[W0A0=46] + U100K1\n"
           "U100K2 = U100K1*[W0A0=211] + U100K2\nU100K3 = U100K2*[W0A0=98] + U100K3\n"
           "U100K4 = U100K3*[W0A0=77] + U100K4\nU100K5 = U100K4*[W0A0=12] + U100K5\n"
           "U100K6 = U100K5*" +
           input + "\nU4A0 = U100K6\n";
  };
  old_directory.Write("p.plc", program("I1A0"));
  new_directory.Write("p.plc", program("I1A1"));
  Searching pair(RequestOf(old_directory), RequestOf(new_directory));
  const std::vector<execute::CellId> sought = pair.Named("U4A0");
  ASSERT_EQ(sought.size(), 1U);
  pair.search->RunWide(sought, Within(60), pair.found);
  ASSERT_TRUE(pair.found.difference_of.contains(sought.front()));
  EXPECT_TRUE(pair.ShowsAgain(sought.front()));
}

/// A machine at work behind a code that nobody guesses: one input near the change shows it, held for two scans. From
/// each moment that the scenario comes by every such input is changed in a run of its own.
TEST(Search, OneInputIsChangedAtEachMomentThatWasSeen) {
  const testing_support::TemporaryDirectory old_directory, new_directory;
  const auto program = [](const std::string& interlock) {
    return "$\nU100K0 = [W0A0=157] + U100K0\nU100K1 = U100K0*[W0A0=46] + U100K1\nU100K2 = U100K1*[W0A0=211]\n"
           "U100K3 = I1A7\nU100K4 = U100K3*I1A7\nU4A0 = U100K4*U100K2" +
           interlock + "\n";
  };
  old_directory.Write("p.plc", program("*I1A0"));
  new_directory.Write("p.plc", program(""));
  old_directory.Write("s.yaml",
                      "dialect: nc110\nsources: [p.plc]\nsteps:\n- set: {W0A0: 157}\n- run: {slow: 1}\n"
                      "- set: {W0A0: 46}\n- run: {slow: 1}\n- set: {W0A0: 211}\n- run: {slow: 1}\n");
  Searching pair(RequestOf(old_directory), RequestOf(new_directory));
  const std::vector<execute::CellId> sought = pair.Named("U4A0");
  ASSERT_EQ(sought.size(), 1U);
  pair.search->RunScenarios(Within(20), pair.found);
  ASSERT_FALSE(pair.found.difference_of.contains(sought.front()));
  // A single pass over the moments, whatever the time.
  pair.search->RunWideFromMoments(sought, Within(60), pair.found);
  ASSERT_TRUE(pair.found.difference_of.contains(sought.front()));
  EXPECT_TRUE(pair.ShowsAgain(sought.front()));
}

/// The control of hnc has a base cycle of 1 ms, and calls the program every 16 ms: what takes three calls is seen.
TEST(Search, AShortBaseCycleIsNoPeriodOfRunsInLanes) {
  const testing_support::TemporaryDirectory old_directory, new_directory;
  const auto program = [](const std::string& condition) {
    return "#include \"plc.h\"\nint n, calls;\nvoid init() { plc1_time = 16; plc2_time = 32; }\nvoid plc1()\n{\n"
           "    if (X[0] == 5) n++;\n    calls = (X[1] & 1) ? calls + 1 : 0;\n    Y[0] = " +
           condition + "calls == 3;\n}\nvoid plc2() { }\n";
  };
  old_directory.Write("p.cld", program("n < 4 && "));
  new_directory.Write("p.cld", program(""));
  old_directory.Write("s.yaml", "dialect: hnc\nsources: [p.cld]\nsteps:\n- set: {\"X[0]\": 5}\n- run: {fast: 6}\n");
  Searching pair(RequestOf(old_directory, "p.cld", "hnc"), RequestOf(new_directory, "p.cld", "hnc"));
  pair.search->RunScenarios(Within(20), pair.found);
  ASSERT_TRUE(pair.found.difference_of.empty());
  pair.search->RunWideFromMoments(pair.cells, Within(60), pair.found);
  EXPECT_FALSE(pair.found.difference_of.empty());
}

/// Two contactors; in step 3 of a counter the second one is on. Steps begin behind a code that nobody guesses.
std::string Contactors(const std::string& interlock, const std::string& also) {
  return "$\nU100K0 = [W0A0=157] + U100K0\nU100K1 = U100K0*[W0A0=46] + U100K1\nC20I(5) = U100K1*I0A0*/C20I\n"
         "U4A10 = [C20W=1]*I0A1" +
         interlock + "\nU4A11 = [C20W=3]*I0A1*/U4A10" + also + "\n";
}
constexpr const char* kStepsOfContactors =
    "- set: {W0A0: 157}\n- run: {slow: 1}\n- set: {W0A0: 46}\n- run: {slow: 1}\n- set: {I0A0: 1, I0A1: 1}\n"
    "- run: {slow: 12}\n- set: {I0A1: 0}\n- run: {slow: 11}\n";

/// What the counter is while the second contactor is on is seen in the scenario alone, and proved.
TEST(Search, WhatAMachineAtWorkIsSeenToDoIsAnInvariant) {
  const WithScenario pair(Contactors("*/U4A11", ""), Contactors("", ""), kStepsOfContactors);
  const Diff diff = pair.Compared(30'000);
  EXPECT_TRUE(diff.items.empty()) << NamesIn(diff);
  EXPECT_GT(diff.invariants, 0U);
}

/// It looks alike in the scenario, and is not.
TEST(Search, WhatIsOnlySeenIsNoInvariant) {
  const std::string also = " + [C20W=1]*[W0A1=77]";
  const WithScenario pair(Contactors("*/U4A11", also), Contactors("", also), kStepsOfContactors);
  const Diff diff = pair.Compared(3000);
  const DiffItem* const first = ItemNamed(diff, "U4A10");
  ASSERT_NE(first, nullptr) << NamesIn(diff);
}

TEST(Search, TheTimeIsUsedWhileSomethingIsOpenAndNotMuchMore) {
  // Equal for all numbers, and far beyond what is proved of products in two seconds.
  const auto program = [](const std::string& value) {
    return "#include \"plc.h\"\nlong a, b, o;\nvoid init() { plc1_time = 1; plc2_time = 1; }\n"
           "void plc1() { a = a * 31421 + X[0]; b = b * 7919 + X[1]; o = " +
           value + "; }\nvoid plc2() { }\n";
  };
  const auto begin = std::chrono::steady_clock::now();
  const Diff diff = ComparedTexts({"hnc", ".cld"}, program("a * b"), program("(a & b) * (a | b) + (a & ~b) * (~a & b)"),
                                  {.same = {}, .time_ms = 2000, .scenario_directory = {}, .progress = {}});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const DiffItem* const product = ItemNamed(diff, "o");
  ASSERT_NE(product, nullptr) << "it was proved";
  EXPECT_EQ(product->verdict, ItemVerdict::kUndecided);
  EXPECT_GT(seconds, 1.5);
}

/// A sequence that has to be begun with seven signals, and then to stand still for eight seconds.
const std::string kStuckTurret = R"($
P0 = I0A1
U100K0 = (P0 + U100K0)*I0A2*I0A0*/U100K1
T52I(50) = U100K0*/I0A3
U100K1 = T52U + U100K1*/I0K1
DOF: I4K17
  W101K0 = BIN(W4K0)
ENDF
DOF: I0A6
  W101K1 = W1A0*0FH
ENDF
U100K6 = I0A6*[W101K1=W101K0]
U100K5 = (I4K17*/[W101K0=0]*/[W101K0>W3T0])*/U100K6*U100K0 + U100K5*/[C20W=4]*/I0K1*U100K0
C20Z = I0K1 + U100K3
C20I(5) = ([C20W=0]*U100K5 + [C20W=1]*U100K6 + [C20W=2]*T50U + [C20W=3]*I0A7 + [C20W=4]*U100K6)*/C20I
T50I(10) = [C20W=2]
U4A2 = [C20W=1]*U100K0*/U4A3
U4A3 = [C20W=3]*U100K0*/U4A2
T20I(80) = /[C20W=0]
U100K3 = T20U + U100K3*/I0K1
@ = U100K3
)";

TEST(Search, WhatLeadsToAChangeIsGoneBackTo) {
  // What the changed statement reads is seen to be 0 until the very end: nothing of it tells how far a run has come.
  const Diff diff = ComparedUntilShown(kNc110, With(kStuckTurret, "U21K2"), With(kStuckTurret, "U21K3"), {"U21K2"});
  const DiffItem* const message = ItemNamed(diff, "U21K2");
  ASSERT_NE(message, nullptr) << NamesIn(diff);
  EXPECT_EQ(message->verdict, ItemVerdict::kDifferent);
  EXPECT_TRUE(message->counterexample.has_value());
}

// The search from a moment of a scenario met an input that only the old version has: it has no cell in the new one.
TEST(Search, GoesOnWithAnInputThatOnlyOneVersionHas) {
  const std::string program =
      "#include \"plc.h\"\nint g, d;\nvoid init(void) { }\n"
      "void plc1(void) {\n  int i;\n  g = d = 0;\n  i = 0;\n  while (i < 5) {\n    if (X[0] & (1 << i)) goto skip;\n"
      "    g += 10;\n    goto next;\nskip:\n    d++;\nnext:\n    i++;\n  }\n  plc1_time = 16;\n}\n"
      "void plc2(void) {\n@}\n";
  const testing_support::TemporaryDirectory old_directory, new_directory;
  old_directory.Write("p.cld", With(program, ""));
  new_directory.Write("p.cld", With(program, "  plc2_time = 32;\n"));
  old_directory.Write("s.yaml",
                      "dialect: hnc\nsources: [p.cld]\nsteps:\n- set: {X[0]: 5}\n- run: {ms: 16}\n- expect: {g: 30}\n");
  const auto side = [](const std::string& name, const testing_support::TemporaryDirectory& directory) {
    compilation::CompilationRequest request;
    request.sources = {"p.cld"};
    request.base_directory = directory.path().string();
    request.dialect = "hnc";
    return MakeDiffSide(name, request);
  };
  DiffSide old_side = side("old", old_directory), new_side = side("new", new_directory);
  const Diff diff =
      CompareSides(old_side, new_side,
                   {.same = {}, .time_ms = 6000, .scenario_directory = old_directory.path().string(), .progress = {}});
  EXPECT_FALSE(diff.items.empty());
}

/// What differs at power-on is shown without a step.
TEST(Shortening, ARunWithoutStepsStaysOne) {
  Shortener shortener([](const Stimuli&, Shortener::Time) { return true; }, Within(60));
  EXPECT_TRUE(shortener.Shorten({}).empty());
}

TEST(Shortening, AWaitTakesOverTheTimeOfTheStepsBeforeIt) {
  const auto shows = [](const Stimuli& stimuli, Shortener::Time) {
    uint32_t passed_ms = 0;
    for (const Stimulus& stimulus : stimuli) passed_ms += stimulus.ms + 100 * stimulus.slow;
    return passed_ms >= 3700;
  };
  Shortener shortener(shows, Within(60));
  const Stimuli shortened = shortener.Shorten({{.inputs = {}, .words = {}, .ms = 150},
                                               {.inputs = {}, .words = {}, .slow = 3},
                                               {.inputs = {}, .words = {}, .ms = 3460}});
  ASSERT_EQ(shortened.size(), 1U);
  EXPECT_GE(shortened.front().ms, 3700U);
}

}  // namespace
}  // namespace plcxx::review::diff
