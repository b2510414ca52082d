#include "transpiler/sim/trace.h"

#include <gmock/gmock.h>

#include "tests/sim/test_program.h"

namespace plcxx::sim {
namespace {

using testing::ElementsAre;

constexpr std::string_view kProgram = R"(
  space A 4 volatile little
  space K 4 volatile little
  state T5 on_delay_timer
  place U4A8 bit A[0].0
  place W2K0 i8 K[0]
  place T5U bit field T5 done
  place WIDE i16 A[2]
)";

struct Tracing : testing::Test {
  Machine machine{kProgram};

  std::vector<Watched> WatchAll() {
    std::vector<Watched> watched;
    for (const ir::Place& place : machine.program.places) watched.push_back(Watch(machine.program, place.name, place));
    return watched;
  }
};

TEST_F(Tracing, Vcd) {
  Trace trace(WatchAll());
  trace.Record(0, ReadsFrom(machine.simulator));
  machine.Set("U4A8", 1);
  machine.Set("WIDE", 0x0105);
  trace.Record(10, ReadsFrom(machine.simulator));
  trace.Record(20, ReadsFrom(machine.simulator));
  machine.Set("T5U", 1);
  machine.Set("U4A8", 0);
  machine.Set("W2K0", 0xFF);
  trace.Record(30, ReadsFrom(machine.simulator));
  trace.Record(40, ReadsFrom(machine.simulator));
  EXPECT_EQ(WriteVcd(trace, "two words"), R"($timescale 1 ms $end
$scope module two_words $end
$scope module A $end
$var wire 1 ! U4A8 $end
$var wire 16 $ WIDE [15:0] $end
$upscope $end
$scope module K $end
$var wire 8 " W2K0 [7:0] $end
$upscope $end
$scope module on_delay_timer $end
$var wire 1 # T5U $end
$upscope $end
$upscope $end
$enddefinitions $end
#0
$dumpvars
0!
b0 "
0#
b0 $
$end
#10
1!
b100000101 $
#30
0!
b11111111 "
1#
#40
)");
}

TEST_F(Tracing, FloatsAreNumbersAndCellsAreTheReaders) {
  Trace trace({{.name = "F0", .scope = "F", .place = {.type = ir::Type::kF32}},
               {.name = "P0.3", .scope = "ports", .place = {.type = ir::Type::kI8}, .cell = 3}});
  const uint64_t values[] = {0x41480000, 0xC0500000, 0x7FC00000};  // 12.5, -3.25, nan
  for (uint64_t time = 0; time < 3; ++time) {
    trace.Record(10 * time, [&](const Watched& watched) { return watched.cell ? *watched.cell + time : values[time]; });
  }
  EXPECT_EQ(WriteTable(trace),
            "t/ms     F0  P0.3\n"
            "   0   12.5     3\n"
            "  10  -3.25     4\n"
            "  20    nan     5\n");
  const std::string text = WriteVcd(trace, "p");
  EXPECT_THAT(text, testing::HasSubstr("$var real 32 ! F0 $end\n"));
  EXPECT_THAT(text, testing::HasSubstr("#10\nr-3.25 !\nb100 \"\n#20\nrnan !\n"));
}

TEST_F(Tracing, VcdOfNothing) {
  EXPECT_EQ(WriteVcd(Trace({}), ""),
            "$timescale 1 ms $end\n$scope module _ $end\n$upscope $end\n$enddefinitions $end\n");
}

TEST_F(Tracing, VcdCodesAreDistinct) {
  std::vector<Watched> watched(200, WatchAll()[0]);
  const std::string text = WriteVcd(Trace(watched), "p");
  EXPECT_THAT(text, testing::HasSubstr("$var wire 1 ~ U4A8 $end\n$var wire 1 !\" U4A8 $end\n"));
}

TEST_F(Tracing, Table) {
  std::vector<Watched> watched = WatchAll();
  watched[0].name = "Насос";  // as wide as its characters
  Trace trace(watched);
  trace.Record(0, ReadsFrom(machine.simulator));
  machine.Set("W2K0", 200);
  machine.Set("WIDE", 65535);
  trace.Record(1000, ReadsFrom(machine.simulator));
  machine.Set("U4A8", 1);
  trace.Record(1000, ReadsFrom(machine.simulator));  // once more at the same time: the later one counts
  EXPECT_EQ(WriteTable(trace),
            "t/ms  Насос  W2K0  T5U   WIDE\n"
            "   0      0     0    0      0\n"
            "1000      1   200    0  65535\n");
}

std::vector<uint64_t> Times(const Graph& graph) {
  std::vector<uint64_t> times;
  for (const Sample& sample : graph.trace().samples()) times.push_back(sample.time_ms);
  return times;
}

TEST_F(Tracing, GraphStartsAtTheEdge) {
  const Watched trigger = Watch(machine.program, "U4A8", PlaceNamed(machine.program, "U4A8"));
  Graph rising(WatchAll(), {.trigger = trigger, .edge = Edge::kRising, .sampling_ms = 20, .samples = 3});
  Graph falling(WatchAll(), {.trigger = trigger, .edge = Edge::kFalling, .sampling_ms = 4, .delay_ms = 15});
  machine.Set("U4A8", 1);  // no edge: it was so from the start
  for (uint64_t time = 0; time <= 130; time += 10) {
    if (time == 20) machine.Set("U4A8", 0);
    if (time == 40) machine.Set("U4A8", 1);
    if (time == 60) machine.Set("U4A8", 0);
    if (time == 80) machine.Set("U4A8", 1);
    rising.Observe(time, ReadsFrom(machine.simulator));
    falling.Observe(time, ReadsFrom(machine.simulator));
    EXPECT_EQ(rising.phase(), time < 40   ? Graph::Phase::kArmed
                              : time < 80 ? Graph::Phase::kStarted
                                          : Graph::Phase::kComplete);
  }
  EXPECT_THAT(Times(rising), ElementsAre(40, 60, 80));
  EXPECT_THAT(Times(falling), ElementsAre(40, 50, 60, 70, 80, 90, 100, 110, 120, 130));
  EXPECT_EQ(rising.trace().samples()[1], (Sample{60, {0, 0, 0, 0}}));
}

TEST_F(Tracing, GraphTakesALateSampleAndKeepsItsGrid) {
  const Watched trigger = Watch(machine.program, "U4A8", PlaceNamed(machine.program, "U4A8"));
  Graph graph(WatchAll(), {.trigger = trigger, .sampling_ms = 25});
  for (uint64_t time = 0; time <= 120; time += 10) {
    if (time == 10) machine.Set("U4A8", 1);
    graph.Observe(time, ReadsFrom(machine.simulator));
  }
  EXPECT_THAT(Times(graph), ElementsAre(10, 40, 60, 90, 110));  // due at 10, 35, 60, 85, 110
}

}  // namespace
}  // namespace plcxx::sim
