// Properties as words: what is read, and every way in which a line can be wrong.
#include <gtest/gtest.h>

#include <charconv>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/prove/properties/condition.h"
#include "transpiler/prove/properties/property.h"

namespace plcxx::prove {
namespace {

/// A, B, C: bits 0, 1, 2. W: a byte of bits 8 to 15. S: the same with a sign. T: a text input.
properties::PropertyContext PropertyContext() {
  properties::PropertyContext context;
  context.timing = {.period_ms = 10, .slow_periods = 2, .fast_periods = 1, .fast_per_period = 1};
  context.locate = [](std::string_view word) -> std::optional<properties::LocatedOperand> {
    if (word == "T") return std::string("a text input");
    properties::PropertyOperand operand{.text = std::string(word)};
    if (word == "W" || word == "S") {
      operand.width = 8;
      operand.has_sign = word == "S";
      for (uint32_t i = 8; i < 16; ++i) operand.cells.emplace_back(i);
      return operand;
    }
    const size_t index = std::string_view("ABC").find(word);
    if (index == std::string_view::npos && word != "or") return std::nullopt;
    operand.is_bit = true;
    operand.cells.emplace_back(word == "or" ? 0 : static_cast<uint32_t>(index));
    return operand;
  };
  context.number = [](std::string_view word) -> std::optional<int64_t> {
    int64_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return number;
  };
  return context;
}

/// Whether the property holds after the last of these periods; each is the value of cells 0 to 15.
bool Holds(const std::string& text, const std::vector<uint32_t>& periods) {
  const properties::Properties parsed = properties::ParseProperties(text, PropertyContext());
  EXPECT_TRUE(parsed.errors.empty()) << text;
  if (parsed.properties.size() != 1) return false;
  terms::Terms terms;
  const auto value = [&](execute::CellId cell, uint32_t period) {
    return terms.Bit((periods[period - 1] >> cell.index & 1) != 0);
  };
  return terms.IsTrue(
      properties::HoldsAfter(terms, parsed.properties.front(), static_cast<uint32_t>(periods.size()), value));
}

TEST(Properties, ConditionsMeanWhatTheySay) {
  EXPECT_TRUE(Holds("never A and B", {1}));
  EXPECT_FALSE(Holds("never A and B", {3}));
  EXPECT_TRUE(Holds("A or B and C", {1}));  // and binds more tightly
  EXPECT_FALSE(Holds("(A or B) and C", {1}));
  EXPECT_TRUE(Holds("not A and B", {2}));
  EXPECT_TRUE(Holds("always A is not B", {2}));
  EXPECT_TRUE(Holds("at most one of A, B, C", {0}));
  EXPECT_FALSE(Holds("at most one of A, B, C", {6}));
  EXPECT_FALSE(Holds("exactly one of A, B, C", {0}));
  EXPECT_TRUE(Holds("exactly one of A, (B and C), not A", {0}));
  EXPECT_TRUE(Holds("'or' or B  # a location that looks like a word", {1}));
}

TEST(Properties, NumbersAreComparedWithTheirSigns) {
  EXPECT_TRUE(Holds("W in 0..12", {12 << 8}));
  EXPECT_FALSE(Holds("W in 0 .. 12", {13 << 8}));
  EXPECT_TRUE(Holds("W > 200", {255 << 8}));
  EXPECT_TRUE(Holds("S < 0", {255 << 8}));
  EXPECT_TRUE(Holds("S in -1..3", {255 << 8}));
  EXPECT_TRUE(Holds("3 <= W", {3 << 8}));
  EXPECT_FALSE(Holds("W >= 4", {3 << 8}));
  EXPECT_TRUE(Holds("W != 4", {3 << 8}));
  EXPECT_TRUE(Holds("bit 1 of W and bit 0 of W = 1", {3 << 8}));
  EXPECT_FALSE(Holds("bit 2 of W", {3 << 8}));
}

TEST(Properties, AResponseIsDueInTheLastPeriodOfItsTime) {
  EXPECT_TRUE(Holds("A implies B", {3}));
  EXPECT_FALSE(Holds("A implies B", {1}));
  EXPECT_TRUE(Holds("A implies B within 20 ms", {1}));  // one more period to come
  EXPECT_FALSE(Holds("A implies B within 20 ms", {1, 0}));
  EXPECT_TRUE(Holds("A implies B within 20 ms", {1, 2}));
  EXPECT_TRUE(Holds("A implies B within 15 ms", {3, 0}));  // rounded up
  EXPECT_FALSE(Holds("A implies B within 1 slow", {1, 0}));
}

TEST(Properties, ForLooksBack) {
  EXPECT_TRUE(Holds("never A for 3 fast", {1, 1}));  // what lies before power-on has not held
  EXPECT_FALSE(Holds("never A for 3 fast", {1, 1, 1}));
  EXPECT_TRUE(Holds("never A for 3 fast", {1, 0, 1, 1}));
  EXPECT_FALSE(Holds("A for 20 ms implies B", {1, 1}));
}

TEST(Properties, NeverStuckIsAKindOfItsOwn) {
  const properties::Properties parsed =
      properties::ParseProperties("A is never stuck\nB is never stuck within 3 slow", PropertyContext());
  ASSERT_EQ(parsed.properties.size(), 2U);
  EXPECT_EQ(parsed.properties[0].kind, properties::PropertyKind::kNeverStuck);
  EXPECT_EQ(parsed.properties[0].periods, properties::kStuckPeriods);
  EXPECT_EQ(parsed.properties[1].periods, 6U);
  EXPECT_EQ(parsed.properties[1].line, 2U);
}

struct WrongLine {
  const char* text;
  properties::PropertyFault fault;
  uint32_t column;
  std::vector<std::string> words;
};

TEST(Properties, EveryWrongLineHasItsPlace) {
  const WrongLine kLines[] = {
      {"never A and", properties::PropertyFault::kSyntax, 12, {"the end of the line", "a location, a number or '('"}},
      {"never A B", properties::PropertyFault::kSyntax, 9, {"'B'", "the end of the line"}},
      {"A B",
       properties::PropertyFault::kSyntax,
       3,
       {"'B'", "'and', 'or', 'implies', a comparison or the end of the line"}},
      {"(A or B", properties::PropertyFault::kSyntax, 8, {"the end of the line", "')'"}},
      {"A = 'B", properties::PropertyFault::kSyntax, 5, {"a quote without its partner", "a name in quotes"}},
      {"at most one of A", properties::PropertyFault::kSyntax, 17, {"the end of the line", "','"}},
      {"1 = 1", properties::PropertyFault::kSyntax, 1, {"'1'", "a location"}},
      {"A implies B within 3 days", properties::PropertyFault::kSyntax, 22, {"'days'", "slow, fast or ms"}},
      {"A implies B within soon", properties::PropertyFault::kSyntax, 20, {"'soon'", "a number of slow, fast or ms"}},
      {"A and B is never stuck", properties::PropertyFault::kSyntax, 1, {"a condition", "one output"}},
      {"W in 3", properties::PropertyFault::kSyntax, 7, {"the end of the line", "'..'"}},
      {"never A and X", properties::PropertyFault::kLocation, 13, {"X"}},
      {"never T = 1", properties::PropertyFault::kNotMemory, 7, {"T", "a text input"}},
      {"never A and W", properties::PropertyFault::kBitNeeded, 13, {"W", "'and'"}},
      {"W is never stuck", properties::PropertyFault::kBitNeeded, 1, {"W", "a property"}},
      {"W = 256", properties::PropertyFault::kNoFit, 5, {"256", "W", "0 to 255"}},
      {"S = 200", properties::PropertyFault::kNoFit, 5, {"200", "S", "-128 to 127"}},
      {"bit 8 of W", properties::PropertyFault::kNoFit, 5, {"8", "a bit of W", "0 to 7"}},
      {"W in 4..3", properties::PropertyFault::kRange, 6, {"4", "3"}},
      {"A implies B within 0 slow", properties::PropertyFault::kTooLong, 20, {"0 slow", "0", "5000"}},
      {"A for 50010 ms", properties::PropertyFault::kTooLong, 7, {"50010 ms", "5001", "5000"}},
  };
  for (const WrongLine& line : kLines) {
    const properties::Properties parsed =
        properties::ParseProperties(std::string("# first\n") + line.text, PropertyContext());
    ASSERT_EQ(parsed.errors.size(), 1U) << line.text;
    const properties::PropertyError& error = parsed.errors.front();
    EXPECT_EQ(error.fault, line.fault) << line.text;
    EXPECT_EQ(error.line, 2U) << line.text;
    EXPECT_EQ(error.column, line.column) << line.text;
    EXPECT_EQ(error.words, line.words) << line.text;
  }
  EXPECT_EQ(properties::ParseProperties("\n# nothing\n", PropertyContext()).errors.front().fault,
            properties::PropertyFault::kNothing);
}

TEST(Properties, NoWordsCrashTheParser) {
  const std::vector<std::string> words = {"never", "A",  "W", "and", "(", ")",    ",",      "in", "..", "1",
                                          "not",   "is", "=", "for", "'", "slow", "within", "of", "bit"};
  uint32_t seed = 1;
  for (int round = 0; round < 20'000; ++round) {
    std::string text;
    for (int i = 0; i < 8; ++i) {
      seed = seed * 1664525 + 1013904223;
      text += words[(seed >> 16) % words.size()] + " ";
    }
    const properties::Properties parsed = properties::ParseProperties(text, PropertyContext());
    EXPECT_EQ(parsed.properties.size() + parsed.errors.size(), 1U) << text;
  }
  EXPECT_EQ(properties::ParseProperties(std::string(100'000, '('), PropertyContext()).errors.size(), 1U);
}

}  // namespace
}  // namespace plcxx::prove
