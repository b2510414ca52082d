// Locations and values of scenarios (specification section 5), texts of alarms (4.3).
#include "transpiler/dialects/host50/control/locate.h"

#include "host50_lowered.h"

namespace plcxx::host50 {
namespace {

const std::string kProgram =
    "CHANNELS 2\nSYMBOLS\n%Q0 PUMP\n%TM1 T_RUN\n%W1 'axis4-'\n%C2 Q5\nEND_SYMBOLS\n"
    "ALARMS\n%Q403 \"door\"\nEND_ALARMS\n" +
    Slow("LD %I0\nTONS T_RUN, 3\nOUT PUMP\nLD %I1\nTOFS %TM3, 3\nOUT %Q416\n");

struct Located {
  LoweredProgram lowered;
  Located() { LowerInto(lowered, {kProgram}); }
  std::optional<dialects::Location> operator()(std::string_view text) const {
    return Locate(ir::NameIndex(lowered.program), text);
  }
  std::string Memory(std::string_view text) const {
    const auto location = (*this)(text);
    if (!location || location->place.is_field()) return "none";
    const ir::Place& place = location->place;
    return lowered.program.spaces[place.space].name + "+" + std::to_string(place.offset) +
           (place.type == ir::Type::kBit ? "." + std::to_string(place.bit) : "") + " " +
           std::string(ir::Name(place.type));
  }
  std::string Field(std::string_view text) const {
    const auto location = (*this)(text);
    if (!location || !location->place.is_field()) return location && location->absent ? "absent" : "none";
    const ir::StateInstance& state = lowered.program.states[location->place.state];
    return state.name + " " + std::string(ir::Info(state.kind).fields[location->place.field].name);
  }
};

// covers: HOST50-033 HOST50-057
TEST(Host50Locate, Addresses) {
  const Located locate;
  EXPECT_EQ(locate.Memory("I0"), "I+0.0 bit");
  EXPECT_EQ(locate.Memory("%i0017"), "I+2.1 bit");
  EXPECT_EQ(locate.Memory("B500"), "B_retentive+62.4 bit");
  EXPECT_EQ(locate.Memory("b501"), "B+62.5 bit");
  EXPECT_EQ(locate.Memory("W100"), "W_retentive+400 i32");
  EXPECT_EQ(locate.Memory("W101"), "W+404 i32");
  EXPECT_EQ(locate.Memory("QF10"), "QF+40 f32");
  EXPECT_EQ(locate.Memory("Q4000"), "Q+500.0 bit");
  for (const char* word : {"W120", "IW5", "QW5", "TM1.V", "C2.V"}) EXPECT_TRUE(locate(word)->has_sign) << word;
  for (const char* other : {"I0", "QF10", "TM1"}) EXPECT_FALSE(locate(other)->has_sign) << other;
  EXPECT_FALSE(locate("Q2400"));
  EXPECT_FALSE(locate("Q4500"));
  EXPECT_FALSE(locate("X0"));
  EXPECT_FALSE(locate(""));
  EXPECT_FALSE(locate("W0.Q"));
}

// covers: HOST50-015 HOST50-016
TEST(Host50Locate, TimersAndCounters) {
  const Located locate;
  EXPECT_EQ(locate.Field("TM1"), "T_RUN output");
  EXPECT_EQ(locate.Field("T1.V"), "T_RUN value");
  EXPECT_EQ(locate.Field("%tm3.p"), "TM3 preset");
  EXPECT_EQ(locate.Field("TM4.Q"), "absent");
  EXPECT_EQ(locate.Field("C1.V"), "absent");
  EXPECT_EQ(locate("C1.V")->place.type, ir::Type::kI32);
  EXPECT_FALSE(locate("TM1.X"));
}

// covers: HOST50-014 HOST50-015
TEST(Host50Locate, Symbols) {
  const Located locate;
  EXPECT_EQ(locate.Memory("PUMP"), "Q+0.0 bit");
  EXPECT_EQ(locate.Memory("'PUMP'"), "Q+0.0 bit");
  EXPECT_EQ(locate.Memory("axis4-"), "W_retentive+4 i32");
  EXPECT_EQ(locate.Memory("'axis4-'"), "W_retentive+4 i32");
  EXPECT_EQ(locate.Field("T_RUN"), "T_RUN output");
  EXPECT_EQ(locate.Field("T_RUN.v"), "T_RUN value");
  EXPECT_EQ(locate.Field("'T_RUN'.P"), "T_RUN preset");
  EXPECT_FALSE(locate("pump"));
  EXPECT_FALSE(locate("PUMP.Q"));
  EXPECT_EQ(locate.Memory("Q5"), "Q+0.5 bit") << "an address goes before a symbol";
  EXPECT_EQ(locate.Field("'Q5'"), "absent");
}

// covers: HOST50-011
TEST(Host50Locate, Values) {
  EXPECT_EQ(ParseValue("$FF"), 255u);
  EXPECT_EQ(ParseValue("$FFFFFFFF"), 0xFFFFFFFFu);
  EXPECT_FALSE(ParseValue("$123456789"));
  EXPECT_FALSE(ParseValue("$"));
  EXPECT_FALSE(ParseValue("FF"));
}

class NoImage final : public dialects::ImagePort {
 public:
  uint8_t Get(ir::SpaceId, uint32_t) const override { return 0; }
  void Set(ir::SpaceId, uint32_t, uint8_t) override {}
  void StoreRetentive() override {}
  void LookAtMessages() override {}
};

// covers: HOST50-240
TEST(Host50Locate, AlarmsWithoutTextAreCalledByTheirAddress) {
  const Located locate;
  EXPECT_EQ(MessageText(locate.lowered.program, 3, NoImage()), "door");
  EXPECT_EQ(MessageText(locate.lowered.program, 16, NoImage()), "%Q416");
}

}  // namespace
}  // namespace plcxx::host50
