// The scan table and the rules of HOST50 7.2, and random inputs against a timer that keeps its history.
#include "plcxx/unit_timers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <type_traits>

namespace plcxx {
namespace {

static_assert(std::is_trivial_v<UnitTimer>, "part of a state that is copied and cleared as bytes");

// covers: HOST50-180 HOST50-183 HOST50-186 HOST50-188 HOST50-189 HOST50-191
TEST(UnitTimers, ScanTable) {
  constexpr bool kInput[] = {false, true, true, true, true, false, false, false, false, false};
  constexpr uint64_t kTonElapsed[] = {0, 0, 100, 200, 300, 0, 0, 0, 0, 0};
  constexpr bool kTon[] = {false, false, false, false, true, false, false, false, false, false};
  constexpr uint64_t kTofElapsed[] = {0, 0, 0, 0, 0, 0, 100, 200, 300, 300};
  constexpr bool kTof[] = {false, true, true, true, true, true, true, true, false, false};
  constexpr uint64_t kPulseElapsed[] = {0, 0, 100, 200, 300, 0, 0, 0, 0, 0};
  constexpr bool kPulse[] = {false, true, true, true, false, false, false, false, false, false};
  UnitTimer ton{}, tof{}, tp{}, pulse{};
  for (int i = 0; i < 10; ++i) {
    SCOPED_TRACE(i + 1);
    EXPECT_EQ(TONMS(ton, kInput[i], 3, 100), kTon[i]);
    EXPECT_EQ(TOFMS(tof, kInput[i], 3, 100), kTof[i]);
    EXPECT_EQ(TPMS(tp, kInput[i], 3, 100), kTof[i]);
    EXPECT_EQ(PulseMS(pulse, kInput[i], 3, 100), kPulse[i]);
    EXPECT_EQ(ton.elapsed_ms, kTonElapsed[i]);
    EXPECT_EQ(tof.elapsed_ms, kTofElapsed[i]);
    EXPECT_EQ(pulse.elapsed_ms, kPulseElapsed[i]);
    for (const UnitTimer* timer : {&ton, &tof, &tp, &pulse}) {
      EXPECT_EQ(timer->value, timer->elapsed_ms / 100);
      EXPECT_EQ(timer->preset, 3U);
    }
    EXPECT_EQ(ton.output, kTon[i]);
  }
}

/// Executions until the output is `wanted`, at most 100000.
template <class Step>
int Count(UnitTimer& timer, Step step, bool input, uint32_t preset, uint32_t period_ms, bool wanted) {
  for (int i = 1; i <= 100000; ++i) {
    if (step(timer, input, preset, period_ms) == wanted) return i;
  }
  return 0;
}

// covers: HOST50-181 HOST50-182 HOST50-186 HOST50-188 HOST50-189
TEST(UnitTimers, Units) {
  // The first execution starts the time; from then on one period each.
  const auto ton = [](auto step, uint32_t preset, uint32_t period_ms) {
    UnitTimer timer{};
    return Count(timer, step, true, preset, period_ms, true);
  };
  EXPECT_EQ(ton(TONMS, 7, 1), 701);
  EXPECT_EQ(ton(TONS, 2, 8), 251);
  EXPECT_EQ(ton(TONM, 1, 8), 7501);
  const auto off = [](auto step, uint32_t preset, uint32_t period_ms) {
    UnitTimer timer{};
    step(timer, true, preset, period_ms);
    return Count(timer, step, false, preset, period_ms, false);
  };
  EXPECT_EQ(off(TOFMS, 7, 1), 701);
  EXPECT_EQ(off(TOFS, 2, 8), 251);
  EXPECT_EQ(off(TOFM, 1, 8), 7501);
  EXPECT_EQ(off(TPMS, 7, 1), 701);
  EXPECT_EQ(off(TPS, 2, 8), 251);
  EXPECT_EQ(off(TPM, 1, 8), 7501);
  const auto pulse = [](auto step, uint32_t preset, uint32_t period_ms) {
    UnitTimer timer{};
    return Count(timer, step, true, preset, period_ms, false);
  };
  EXPECT_EQ(pulse(PulseMS, 7, 1), 701);
  EXPECT_EQ(pulse(PulseS, 2, 8), 251);
  EXPECT_EQ(pulse(PulseM, 1, 8), 7501);
}

// covers: HOST50-184
TEST(UnitTimers, PresetZeroAndNegative) {
  for (const uint32_t preset : {0U, 0xFFFFFFFFU, 0x80000000U}) {
    UnitTimer ton{}, tof{}, tp{}, pulse{};
    EXPECT_TRUE(TONS(ton, true, preset, 8));  // at once
    EXPECT_EQ(ton.preset, preset);
    EXPECT_EQ(ton.value, 0U);
    EXPECT_TRUE(TOFS(tof, true, preset, 8));
    EXPECT_FALSE(TOFS(tof, false, preset, 8));
    EXPECT_TRUE(TPS(tp, true, preset, 8));
    EXPECT_FALSE(TPS(tp, false, preset, 8));
    EXPECT_FALSE(PulseS(pulse, true, preset, 8));  // a pulse of no length
  }
}

// covers: HOST50-185
TEST(UnitTimers, PresetIsReadAtEveryExecution) {
  UnitTimer ton{};
  TONMS(ton, true, 10, 100);
  TONMS(ton, true, 10, 100);
  EXPECT_TRUE(TONMS(ton, true, 2, 100));   // shortened: done at once
  EXPECT_TRUE(TONMS(ton, true, 50, 100));  // lengthened: stays until the input falls
  EXPECT_EQ(ton.value, 2U);
  EXPECT_EQ(ton.preset, 50U);
  UnitTimer tof{};
  TOFMS(tof, true, 10, 100);
  TOFMS(tof, false, 10, 100);
  EXPECT_TRUE(TOFMS(tof, false, 10, 100));
  EXPECT_FALSE(TOFMS(tof, false, 1, 100));
}

// covers: HOST50-187 HOST50-189
TEST(UnitTimers, Retriggering) {
  UnitTimer tof{}, pulse{};
  TOFMS(tof, true, 3, 100);
  PulseMS(pulse, true, 3, 100);
  for (const bool input : {false, false, true, false, false, false}) {
    EXPECT_TRUE(TOFMS(tof, input, 3, 100));
    PulseMS(pulse, input, 3, 100);
  }
  EXPECT_FALSE(TOFMS(tof, false, 3, 100));
  // The pulse of the first edge ended in its time; the edge inside it started no other one.
  EXPECT_FALSE(pulse.output);
  EXPECT_EQ(pulse.elapsed_ms, 0U);
}

// covers: HOST50-190
TEST(UnitTimers, ValueIsTruncated) {
  UnitTimer timer{};
  TONS(timer, true, 3, 250);
  for (int i = 1; i <= 7; ++i) TONS(timer, true, 3, 250);
  EXPECT_EQ(timer.elapsed_ms, 1750U);
  EXPECT_EQ(timer.value, 1U);
  TONS(timer, true, 1, 250);  // done: never more than the preset
  EXPECT_EQ(timer.value, 1U);
}

TEST(UnitTimers, GreatestPreset) {
  UnitTimer timer{};
  TONM(timer, true, 0x7FFFFFFF, 1000);
  timer.elapsed_ms = uint64_t{0x7FFFFFFF} * 60000 - 1500;
  EXPECT_FALSE(TONM(timer, true, 0x7FFFFFFF, 1000));
  EXPECT_EQ(timer.value, 0x7FFFFFFEU);
  EXPECT_TRUE(TONM(timer, true, 0x7FFFFFFF, 1000));
  EXPECT_EQ(timer.value, 0x7FFFFFFFU);
}

/// The outputs as a reader of the rules says them, from when things happened instead of from counts.
struct History {
  int64_t now = 0;
  bool previous = false;
  std::optional<int64_t> rose, fell;  // the running stretch of 1, of 0 after a 1
  std::optional<int64_t> pulse;       // begin of the running IEC pulse
  bool ton = false, tof = false;

  void Execute(bool input, int64_t preset_ms, int64_t period) {
    now += period;
    if (input && !previous) {
      rose = now;
      if (!pulse) pulse = now;
    }
    if (!input) rose.reset();
    if (!input && previous) fell = now;
    if (input) fell.reset();
    ton = input && (ton || now - *rose >= preset_ms);
    if (input) tof = true;
    if (fell && now - *fell >= preset_ms) {
      tof = false;
      fell.reset();
    }
    if (pulse && now - *pulse >= preset_ms) pulse.reset();
    previous = input;
  }
};

// covers: HOST50-183 HOST50-187 HOST50-188 HOST50-189
TEST(UnitTimers, RandomInputs) {
  std::mt19937 random(17);
  for (int run = 0; run < 200; ++run) {
    const uint32_t period = 1 + static_cast<uint32_t>(random() % 150);
    UnitTimer ton{}, tof{}, tp{}, pulse{};
    History history;
    bool input = false;
    uint32_t preset = static_cast<uint32_t>(random() % 8);
    for (int i = 0; i < 300; ++i) {
      if (random() % 5 == 0) input = !input;
      if (random() % 40 == 0) preset = static_cast<uint32_t>(random() % 8);
      history.Execute(input, int64_t{preset} * 100, period);
      ASSERT_EQ(TONMS(ton, input, preset, period), history.ton);
      ASSERT_EQ(TOFMS(tof, input, preset, period), history.tof);
      ASSERT_EQ(TPMS(tp, input, preset, period), history.tof) << "D21: TP by the manual is a TOF";
      ASSERT_EQ(PulseMS(pulse, input, preset, period), history.pulse.has_value());
    }
  }
}

}  // namespace
}  // namespace plcxx
