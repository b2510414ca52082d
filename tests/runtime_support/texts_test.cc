// The operator's texts and the flags of the literals, NC110 7.5.
#include "plcxx/texts.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <type_traits>

namespace plcxx {
namespace {

static_assert(std::is_trivial_v<TextInbox> && std::is_trivial_v<TextFlag>, "part of a state that is copied as bytes");

struct Texts {
  TextInbox inbox{};
  TextFlag start{}, stop{};

  void Send(const std::string& text) { SendText(inbox, text.data(), text.size()); }
  void SlowCycle() {
    UpdateText(start, inbox, "START");
    UpdateText(stop, inbox, "STOP");
    ClearText(inbox);
  }
};

// covers: NC110-100
TEST(Texts, FlagLastsTwoSlowCycles) {
  Texts t;
  t.SlowCycle();
  EXPECT_FALSE(t.start.flag);
  t.Send("START");
  EXPECT_FALSE(t.start.flag);
  t.SlowCycle();
  EXPECT_TRUE(t.start.flag);
  EXPECT_FALSE(t.stop.flag);
  t.SlowCycle();
  EXPECT_TRUE(t.start.flag);
  t.SlowCycle();
  EXPECT_FALSE(t.start.flag);
  t.SlowCycle();
  EXPECT_FALSE(t.start.flag);
}

// covers: NC110-100
TEST(Texts, TheSameTextAgainProlongs) {
  Texts t;
  t.Send("START");
  t.SlowCycle();
  t.Send("START");
  t.SlowCycle();
  EXPECT_TRUE(t.start.flag);
  t.SlowCycle();
  EXPECT_TRUE(t.start.flag);
  t.SlowCycle();
  EXPECT_FALSE(t.start.flag);
}

// covers: NC110-103
TEST(Texts, ASecondTextReplacesTheFirst) {
  Texts t;
  t.Send("START");
  t.Send("STOP");  // before the slow cycle: the latest wins
  t.SlowCycle();
  EXPECT_FALSE(t.start.flag);
  EXPECT_TRUE(t.stop.flag);
  t.Send("START");  // after it: the other flag ends at once
  t.SlowCycle();
  EXPECT_TRUE(t.start.flag);
  EXPECT_FALSE(t.stop.flag);
}

// covers: NC110-101
TEST(Texts, ComparisonIsExact) {
  for (const char* other : {"start", "START ", " START", "STAR", "STARTS", "", "STOP"}) {
    Texts t;
    t.Send(other);
    t.SlowCycle();
    EXPECT_FALSE(t.start.flag) << other;
  }
  Texts t;
  t.Send(std::string("START\0", 6));
  t.SlowCycle();
  EXPECT_FALSE(t.start.flag);
}

// covers: NC110-099, NC110-101
TEST(Texts, LongestText) {
  const std::string longest(32, '\xE0');  // a letter of CP866
  TextInbox inbox{};
  TextFlag flag{};
  SendText(inbox, longest.data(), longest.size());
  UpdateText(flag, inbox, longest.c_str());
  EXPECT_TRUE(flag.flag);
  UpdateText(flag, inbox, longest.substr(1).c_str());
  EXPECT_FALSE(flag.flag);
  UpdateText(flag, inbox, (longest + "!").c_str());
  EXPECT_FALSE(flag.flag);
}

// covers: NC110-101
TEST(Texts, LongerTextEqualsNoLiteralButIsASending) {
  for (size_t length : {size_t{33}, size_t{288}, size_t{1000}}) {
    const std::string text(length, 'x');
    Texts t;
    t.Send("START");
    t.SlowCycle();
    t.Send(text);
    EXPECT_TRUE(t.inbox.pending);
    TextFlag flag{};
    UpdateText(flag, t.inbox, text.c_str());
    EXPECT_FALSE(flag.flag);
    UpdateText(flag, t.inbox, text.substr(0, 32).c_str());
    EXPECT_FALSE(flag.flag);
    t.SlowCycle();
    EXPECT_FALSE(t.start.flag);  // the flag of the text before has ended
  }
}

TEST(Texts, LiteralEndsAtItsFirstZero) {
  TextInbox inbox{};
  SendText(inbox, "START\0", 6);
  EXPECT_FALSE(EqualsText(inbox, "START\0"));
  EXPECT_FALSE(EqualsText(inbox, "START"));
}

TEST(Texts, ShorterTextLeavesNothingOfALongerOne) {
  const std::string longest(32, 'x');
  TextInbox inbox{};
  SendText(inbox, longest.data(), longest.size());
  SendText(inbox, "x", 1);
  EXPECT_TRUE(EqualsText(inbox, "x"));
  SendText(inbox, longest.data(), 33);
  EXPECT_FALSE(EqualsText(inbox, longest.c_str()));
  EXPECT_FALSE(EqualsText(inbox, (longest + "!").c_str()));  // 33, the mark of its length
}

TEST(Texts, MissingTexts) {
  TextInbox inbox{};
  TextFlag flag{};
  SendText(inbox, nullptr, 5);
  EXPECT_TRUE(inbox.pending);
  UpdateText(flag, inbox, nullptr);
  EXPECT_FALSE(flag.flag);
  UpdateText(flag, inbox, "A");
  EXPECT_FALSE(flag.flag);
}

}  // namespace
}  // namespace plcxx
