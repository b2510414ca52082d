// The numbers that the specification gives: at each limit the last value that is accepted and the first one that is
// not.

#include <string>
#include <vector>

#include "hnc_lowered.h"

namespace plcxx::hnc {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::string_view kEntries =
    "void init() { plc1_time = 16; plc2_time = 32; }\nvoid plc1() { work(); }\nvoid plc2() { }\n";

std::vector<std::string> ErrorsOf(const std::string& text) {
  LoweredProgram lowered;
  LowerInto(lowered, "#include \"plc.h\"\n" + text + std::string(kEntries));
  std::vector<std::string> reported = lowered.Reported();
  std::erase_if(reported, [](const std::string& line) { return line.find(" W") != std::string::npos; });
  return reported;
}

// covers: HNC-080
TEST(HncLimits, StaticAndAutomaticDataAreCountedTogetherTheHeadersAreNot) {
  const auto data = [](uint32_t global, uint32_t kept, uint32_t automatic) {
    return ErrorsOf("char first[" + std::to_string(global) + "];\nvoid work() { static char kept[" +
                    std::to_string(kept) + "]; char own[" + std::to_string(automatic) +
                    "]; kept[X[0]] = first[1]; own[X[0]] = kept[2]; first[3] = own[1]; }\n");
  };
  EXPECT_THAT(data(20000, 30000, 10000), IsEmpty());
  EXPECT_THAT(data(20000, 30000, 10001), ElementsAre("3 E056"));
  EXPECT_THAT(data(20001, 20000, 20000), ElementsAre("2 E056"));
  EXPECT_THAT(data(20000, 20001, 20000), ElementsAre("3 E056"));
  EXPECT_THAT(data(30001, 30001, 10), ElementsAre("2 E056"));  // the first one of two
}

// covers: HNC-260
TEST(HncLimits, TenMillionRoundsAreAllowed) {
  const auto loops = [](const std::string& inner) {
    return ErrorsOf(
        "int a; void work() { long i; int n;\n for (i = 0; i < 10000000; i++) a++;\n for (n = 0; n < 1000; n++)\n " +
        inner + " }\n");
  };
  EXPECT_THAT(loops("for (i = 0; i < 10000; i++) a++;"), IsEmpty());
  EXPECT_THAT(loops("for (i = 0; i < 10001; i++) a++;"), ElementsAre("5 E032"));
  EXPECT_THAT(ErrorsOf("int a; void work() { long i;\n for (i = 0; i < 10000001; i++) a++; }\n"),
              ElementsAre("3 E032"));
  // However many are around it, the number does not wrap.
  EXPECT_THAT(
      loops("for (i = 0; i < 10000; i++) { int k, m; for (k = 0; k < 30000; k++) for (m = 0; m < 30000; m++) a++; }"),
      ElementsAre("5 E032", "5 E032"));
}

TEST(HncLimits, TwoHundredFiftyFiveHandlersAreChosenAmong) {
  const auto handlers = [](int count, std::string_view condition, int channels = 1) {
    std::string functions, calls;
    for (int i = 0; i < count; ++i) {
      const std::string number = std::to_string(i), channel = std::to_string(i % channels);
      functions += "void h" + number + "(int ch) { mod_M_code(ch) = -1; }\n";
      calls += std::string(condition) + "set_mst_func(" + channel + ", 'M', h" + number + ");\n";
    }
    LoweredProgram lowered;
    LowerInto(lowered, "#include \"plc.h\"\n" + functions + "void init() { plc1_time = 16; plc2_time = 32;\n" + calls +
                           "}\nvoid plc1() { }\nvoid plc2() { }\n");
    std::vector<std::string> reported = lowered.Reported();
    std::erase_if(reported, [](const std::string& line) { return line.find(" W") != std::string::npos; });
    return reported;
  };
  EXPECT_THAT(handlers(255, "if (P[0]) "), IsEmpty());
  EXPECT_THAT(handlers(257, "if (P[0]) "), ElementsAre("515 E046"));  // the first one that is too many, once
  EXPECT_THAT(handlers(257, ""), IsEmpty());                          // the last one counts: there is no choice
  EXPECT_THAT(handlers(510, "if (P[0]) ", 2), IsEmpty());             // of each channel
}

TEST(HncLimits, APointerRefersToSixteenObjects) {
  const auto pointers = [](int count) {
    std::string variables = "#include <string.h>\nint a0", choice = "p = &a0;";
    for (int i = 1; i < count; ++i) {
      variables += ", a" + std::to_string(i);
      choice += " if (X[0] == " + std::to_string(i) + ") p = &a" + std::to_string(i) + ";";
    }
    return ErrorsOf(variables + ";\nvoid work() { int *p; " + choice + " *p = 1; memset(p, 0, 2); }\n");
  };
  EXPECT_THAT(pointers(16), IsEmpty());
  EXPECT_THAT(pointers(17), ElementsAre("4 E050", "4 E050"));
}

// 7.4: what the control takes from the way of an axis; with its own functions, all that they ask for.
TEST(HncLimits, OfSixteenAxesTheControlWritesTheWay) {
  for (const bool host : {false, true}) {
    LoweredProgram lowered;
    LowerInto(lowered, "#include \"plc.h\"\nvoid work() { Y[0] = X[0]; }\n" + std::string(kEntries),
              {{"sysfunc", host ? "host" : "image"}});
    for (const ir::Space& space : lowered.program().spaces) {
      if (space.name != "G") continue;
      ASSERT_EQ(space.zones.size(), 17U);
      for (uint32_t axis = 0; axis < 16; ++axis) {
        const ir::Zone& zone = space.zones[1 + axis];
        EXPECT_EQ(zone.begin, 8 * (20 * axis + (host ? 0 : 2))) << axis;
        EXPECT_EQ(zone.end, 8 * (20 * axis + (host ? 10 : 6))) << axis;
        EXPECT_EQ(zone.direction, ir::Direction::kInput) << axis;
      }
    }
  }
}

// 9.2: a period is a word of ms; another base cycle is the shortest time between two calls.
TEST(HncLimits, APeriodHasSixteenBits) {
  const auto every = [](const std::string& time, const std::string& base) {
    LoweredProgram lowered;
    LowerInto(lowered,
              "#include \"plc.h\"\nvoid init() { plc1_time = " + time +
                  "; plc2_time = 70; }\nvoid plc1() { }\nvoid plc2() { }\n",
              {{"base-cycle", base}});
    const ir::Schedule& schedule = lowered.program().schedule;
    EXPECT_EQ(schedule.most_periods, 65537U);
    EXPECT_EQ(schedule.slow_every_ms, 70U);
    EXPECT_EQ(std::to_string(schedule.period_ms), base);
    EXPECT_EQ(std::to_string(schedule.slot_ms), base);
    return schedule.fast_every_ms;
  };
  EXPECT_EQ(every("16", "1"), 16U);
  EXPECT_EQ(every("16", "20"), 20U);
  EXPECT_EQ(every("0", "4"), 4U);
  EXPECT_EQ(every("-1", "4"), 65535U);
  EXPECT_EQ(every("P[0]", "4"), 0U);
}

// Up to 64 bytes are cleared one after the other, more in a loop.
TEST(HncLimits, LargeArraysAreClearedInALoop) {
  const auto routine = [](int bytes) {
    LoweredProgram lowered;
    LowerInto(lowered, "#include \"plc.h\"\nvoid work() { char own[" + std::to_string(bytes) +
                           "]; own[X[0]] = 1; Y[0] = own[X[1]]; }\n" + std::string(kEntries));
    return lowered.Routine("work");
  };
  const auto loops = [](const std::vector<std::string>& lines) {
    return std::ranges::count_if(lines, [](const std::string& line) { return line.starts_with("loop "); });
  };
  EXPECT_EQ(loops(routine(64)), 0);
  EXPECT_EQ(loops(routine(65)), 1);
  EXPECT_THAT(routine(65), Contains(testing::HasSubstr("proven 65")));
}

}  // namespace
}  // namespace plcxx::hnc
