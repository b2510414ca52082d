// What each element does in time: the numbers are those that docs/plant.md gives, reckoned by hand.
#include "tests/plant/plant_fixture.h"

namespace plcxx::plant {
namespace {

TEST(Switch, FollowsWithADelayEachWay) {
  Bench bench("switch: {input: P, follows: PUMP, on: 300 ms, off: 100 ms}");
  bench.Run(1000);
  EXPECT_EQ(bench.Get("P"), 0);
  bench.Set("PUMP", 1);
  EXPECT_EQ(Changes(bench, "P", 400), "0:0 300:1");
  bench.Set("PUMP", 0);
  EXPECT_EQ(Changes(bench, "P", 200), "0:1 100:0");
}

TEST(Switch, AShorterTimeDoesNotCount) {
  Bench bench("switch: {input: P, follows: PUMP, on: 300 ms}");
  bench.Set("PUMP", 1);
  bench.Run(299);
  bench.Set("PUMP", 0);
  bench.Run(1);
  bench.Set("PUMP", 1);
  EXPECT_EQ(Changes(bench, "P", 300), "0:0 300:1");
}

TEST(Switch, WithoutDelayItFollowsAtOnceAndMayHaveValues) {
  Bench bench("switch: {values: {A: 1, W: 0x40}, follows: 'not X', at: 1}");
  EXPECT_EQ(bench.Get("W"), 64);
  bench.Set("X", 1);
  bench.Run(0);
  EXPECT_EQ(bench.Get("A"), 0);
  EXPECT_EQ(bench.Get("W"), 0);
}

TEST(Fixed, IsThereAtDelivery) {
  Bench bench("fixed: {input: [A, B], values: {W: -3}}");
  EXPECT_EQ(bench.Get("A") + bench.Get("B"), 2);
  EXPECT_EQ(bench.Get("W"), -3);
}

TEST(Cylinder, TwoValvesAndItStaysWithNone) {
  Bench bench(
      "cylinder: {extend: V1, retract: V2, extend-time: 600 ms, retract-time: 500 ms, extended: OUT, retracted: IN}");
  bench.Set("V1", 1);
  EXPECT_EQ(Changes(bench, "IN", 10), "0:1 1:0");
  EXPECT_EQ(Changes(bench, "OUT", 600), "0:0 590:1");
  bench.Set("V1", 0);
  bench.Run(10'000);
  EXPECT_EQ(bench.Get("OUT"), 1);
  bench.Set("V2", 1);
  EXPECT_EQ(Changes(bench, "IN", 600), "0:0 500:1");
  // Half of the way out, and back in half of the time.
  bench.Set("V1", 1);
  bench.Run(100);
  EXPECT_EQ(bench.Get("IN"), 1);  // both: it stays
  bench.Set("V2", 0);
  bench.Run(300);
  bench.Set("V1", 0);
  bench.Set("V2", 1);
  EXPECT_EQ(Changes(bench, "IN", 300), "0:0 250:1");
}

TEST(Cylinder, ASpringBringsItBack) {
  Bench bench("cylinder: {extend: V, extend-time: 200 ms, extended: OUT, retracted: IN, at: extended}");
  EXPECT_EQ(bench.Get("OUT"), 1);
  EXPECT_EQ(Changes(bench, "IN", 300), "0:0 200:1");
  bench.Set("V", 1);
  EXPECT_EQ(Changes(bench, "OUT", 300), "0:0 200:1");
}

constexpr const char* kTurret =
    "turret: {forward: F, reverse: R, positions: 8, time: 400 ms, code: [C0, C1, C2, C3], strobe: S, home: H}";
int64_t CodeOf(const Bench& bench) {
  return bench.Get("C0") + 2 * bench.Get("C1") + 4 * bench.Get("C2") + 8 * bench.Get("C3");
}

TEST(Turret, PositionsHaveAWindowAQuarterBeforeAndAfterThem) {
  Bench bench(kTurret);
  EXPECT_EQ(CodeOf(bench), 1);
  EXPECT_EQ(bench.Get("H"), 1);
  bench.Set("F", 1);
  // Position 1 up to 100 ms, 2 from 300 to 500, 3 from 700.
  EXPECT_EQ(Changes(bench, "S", 800), "0:1 101:0 300:1 501:0 700:1");
  EXPECT_EQ(CodeOf(bench), 3);
  bench.Run(2400);  // 3200 ms: once around
  EXPECT_EQ(CodeOf(bench), 1);
  EXPECT_EQ(bench.Get("H"), 1);
  bench.Set("F", 0);
  bench.Set("R", 1);
  bench.Run(400);
  EXPECT_EQ(CodeOf(bench), 8);
  bench.Set("F", 1);
  bench.Run(5000);
  EXPECT_EQ(CodeOf(bench), 8);
}

TEST(Turret, BetweenTwoPositionsThereIsNoCode) {
  Bench bench(kTurret);
  bench.Set("F", 1);
  bench.Run(200);
  EXPECT_EQ(CodeOf(bench), 0);
  EXPECT_EQ(bench.Get("H"), 0);
}

TEST(Turret, Codes) {
  const auto third = [](const std::string& coding, int inputs) {
    std::string code;
    for (int i = 0; i < inputs; ++i) code += (i == 0 ? "C" : ", C") + std::to_string(i);
    Bench bench("turret: {forward: F, positions: 12, time: 100 ms, at: 11, coding: " + coding + ", code: [" + code +
                "]}");
    std::string bits;
    for (int i = inputs; i-- > 0;) bits += std::to_string(bench.Get("C" + std::to_string(i)));
    return bits;
  };
  EXPECT_EQ(third("binary", 4), "1011");
  EXPECT_EQ(third("gray", 4), "1110");
  EXPECT_EQ(third("bcd", 5), "10001");
  EXPECT_EQ(third("one-hot", 12), "010000000000");
}

TEST(Turret, TheLockHoldsPullsInAndTakesItsTime) {
  Bench bench(
      "turret: {forward: F, positions: 4, time: 400 ms, lock: L, unlock: F, lock-time: 150 ms, locked: K, strobe: S}");
  EXPECT_EQ(bench.Get("K"), 1);
  bench.Set("F", 1);
  EXPECT_EQ(Changes(bench, "K", 149), "0:1 1:0");
  bench.Run(1);                                            // 150 ms: free
  EXPECT_EQ(Changes(bench, "S", 300), "0:1 101:0 300:1");  // 300 ms on the way: the window of the next
  bench.Set("F", 0);
  bench.Set("L", 1);
  EXPECT_EQ(Changes(bench, "K", 200), "0:0 150:1");
  bench.Set("L", 0);
  bench.Run(1000);
  EXPECT_EQ(bench.Get("K"), 1);  // it stays locked
  // Pulled into the middle: the next window begins 300 ms after it is free.
  bench.Set("F", 1);
  bench.Run(150);
  EXPECT_EQ(Changes(bench, "S", 310), "0:1 101:0 300:1");
}

TEST(Turret, BetweenTwoPositionsItDoesNotLock) {
  Bench bench("turret: {forward: F, positions: 4, time: 400 ms, lock: L, lock-time: 100 ms, locked: K}");
  bench.Set("F", 1);
  bench.Run(100 + 200);
  bench.Set("F", 0);
  bench.Set("L", 1);
  bench.Run(1000);
  EXPECT_EQ(bench.Get("K"), 0);
}

TEST(Magazine, PulsesAndReference) {
  Bench bench("magazine: {forward: F, reverse: R, pockets: 12, time: 600 ms, at: 12, pulse: P, reference: Z}");
  EXPECT_EQ(bench.Get("P"), 1);
  EXPECT_EQ(bench.Get("Z"), 0);
  bench.Set("F", 1);
  EXPECT_EQ(Changes(bench, "P", 700), "0:1 151:0 450:1");
  EXPECT_EQ(bench.Get("Z"), 1);
  bench.Set("F", 0);
  bench.Set("R", 1);
  bench.Run(700);
  EXPECT_EQ(bench.Get("Z"), 0);
  EXPECT_EQ(bench.Get("P"), 1);
}

TEST(Axis, LimitsCamAndPosition) {
  Bench bench(
      "axis: {forward: F, backward: B, enable: E, speed: 50, from: -10, to: 100, at: 0, low-limit: L, low-limit-at: "
      "-5, "
      "high-limit: U, high-limit-at: 95, reference: Z, reference-from: 20, reference-to: 30, position: X, "
      "position-step: 0.01}");
  EXPECT_EQ(bench.Get("L") + bench.Get("U"), 2);  // they open when they are hit
  bench.Set("F", 1);
  bench.Run(1000);
  EXPECT_EQ(bench.Get("X"), 0);  // not enabled
  bench.Set("E", 1);
  EXPECT_EQ(Changes(bench, "Z", 700), "0:0 400:1 601:0");  // 50 mm/s: 20 mm after 400 ms, 30 mm after 600 ms
  EXPECT_EQ(bench.Get("X"), 3500);
  EXPECT_EQ(Changes(bench, "U", 1300), "0:1 1200:0");  // 60 mm more
  bench.Run(10'000);
  EXPECT_EQ(bench.Get("X"), 10'000);
  bench.Set("F", 0);
  bench.Set("B", 1);
  bench.Run(2000 + 40);
  EXPECT_EQ(bench.Get("X"), -200);
  EXPECT_EQ(bench.Get("L"), 1);
  bench.Run(60);
  EXPECT_EQ(bench.Get("L"), 0);
}

TEST(Axis, SpeedFromALocationAndAnEncoder) {
  Bench bench("axis: {forward: F, speed: V, speed-step: 0.5, to: 100, encoder: [A, B], line: 4}");
  bench.Set("F", 1);
  bench.Set("V", 20);  // 10 a second: a line in 400 ms, a quarter in 100 ms
  EXPECT_EQ(Changes(bench, "A", 800), "0:0 100:1 300:0 500:1 700:0");
  Bench other("axis: {forward: F, speed: V, speed-step: 0.5, to: 100, encoder: [A, B], line: 4}");
  other.Set("F", 1);
  other.Set("V", 20);
  EXPECT_EQ(Changes(other, "B", 800), "0:0 200:1 400:0 600:1 800:0");
}

TEST(Tank, LevelsAndBothAtATime) {
  Bench bench(
      "tank: {fill: I, drain: O, fill-rate: 3, drain-rate: 1, capacity: 50, at: 10, levels: {LOW: 12, HIGH: 40}, "
      "level: W}");
  bench.Set("I", 1);
  EXPECT_EQ(Changes(bench, "LOW", 1000), "0:0 667:1");  // 2 units at 3 a second
  EXPECT_EQ(bench.Get("W"), 13);
  bench.Set("O", 1);
  EXPECT_EQ(Changes(bench, "HIGH", 14'000), "0:0 13500:1");  // 27 more at 2 a second
  bench.Run(60'000);
  EXPECT_EQ(bench.Get("W"), 50);
  bench.Set("I", 0);
  bench.Run(120'000);
  EXPECT_EQ(bench.Get("W"), 0);
}

TEST(Spindle, RampsReachedAndZero) {
  Bench bench(
      "spindle: {forward: F, reverse: R, top-speed: 3000, speed: S, ramp: 3 s, reached: X, zero: Z, actual: N}");
  EXPECT_EQ(bench.Get("Z"), 1);
  bench.Set("F", 1);
  bench.Set("S", 1500);
  EXPECT_EQ(Changes(bench, "X", 2000), "0:0 1500:1");  // half of the top speed: half of the ramp
  EXPECT_EQ(bench.Get("N"), 1500);
  bench.Set("S", 9000);
  EXPECT_EQ(Changes(bench, "X", 2000), "0:1 1:0 1500:1");  // the top speed
  EXPECT_EQ(bench.Get("N"), 3000);
  bench.Set("F", 0);
  EXPECT_EQ(Changes(bench, "Z", 4000), "0:0 3000:1");
  EXPECT_EQ(bench.Get("X"), 0);
  bench.Set("R", 1);
  bench.Run(1000);
  EXPECT_EQ(bench.Get("N"), -1000);
}

TEST(Spindle, APulseIsHalfOfARevolution) {
  Bench bench("spindle: {forward: F, top-speed: 600, ramp: 1 ms, pulse: P}");
  bench.Set("F", 1);
  EXPECT_EQ(Changes(bench, "P", 200), "0:0 50:1 100:0 150:1 200:0");  // ten revolutions a second
}

/// The same time in other pieces leads to the same place.
TEST(Plant, PeriodsMayBeLongOrShort) {
  for (const std::string element : {"switch: {input: A, follows: X, on: 120 ms}",
                                    "cylinder: {extend: X, extend-time: 700 ms, extended: A, retracted: B}",
                                    "turret: {forward: X, positions: 8, time: 130 ms, strobe: A, home: B}",
                                    "magazine: {forward: X, pockets: 5, time: 70 ms, pulse: A, reference: B}",
                                    "axis: {forward: X, speed: 12.5, to: 60, position: A, position-step: 0.1}",
                                    "tank: {fill: X, fill-rate: 2.5, capacity: 9, level: A, level-step: 0.01}",
                                    "spindle: {forward: X, top-speed: 1000, ramp: 5 s, actual: A}"}) {
    Bench whole(element), pieces(element);
    whole.Set("X", 1);
    pieces.Set("X", 1);
    whole.Run(1170);
    for (const uint64_t ms : {1, 9, 250, 0, 10, 900}) pieces.Run(ms);
    EXPECT_EQ(whole.Get("A"), pieces.Get("A")) << element;
  }
}

TEST(Plant, GoesBackToAMoment) {
  Bench bench(kTurret);
  bench.Set("F", 1);
  bench.Run(730);
  const Plant kept = bench.Kept();
  const std::string first = Changes(bench, "S", 900);
  bench.GoBackTo(kept);
  EXPECT_EQ(Changes(bench, "S", 900), first);
}

}  // namespace
}  // namespace plcxx::plant
