// The reference grammar of properties is executed: its sentences are read, and what is no sentence is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "tests/dialects/grammar.h"
#include "transpiler/prove/properties/property.h"

namespace plcxx::prove {
namespace {

using testing_support::Contents;
using testing_support::Grammar;
using testing_support::Numbers;

const Grammar& TheGrammar() {
  static const Grammar grammar = testing_support::GrammarOf("property");
  return grammar;
}

/// Conditions in conditions multiply: a few lines, two or three conditions in one another say it all.
constexpr Grammar::Shape kShape{.top = 1, .deep = 13, .top_rounds = 4, .rounds = 2};

const std::vector<std::string>& Bits() {
  static const std::vector<std::string> bits{"A", "B1", "U4A8", "!NAME", "'or'", "'O 4.1'", "'12'", "Ж"};
  return bits;
}
const std::vector<std::string>& Words() {
  static const std::vector<std::string> words{"W", "W4K3", "MW[3]", "'of'", "x..y"};
  return words;
}

bool IsNumber(std::string_view word) {
  return !word.empty() && std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
}
std::string Unquoted(const std::string& word) { return word[0] == '\'' ? word.substr(1, word.size() - 2) : word; }
bool IsOneOf(const std::vector<std::string>& words, std::string_view text) {
  return std::ranges::any_of(words, [text](const std::string& word) { return Unquoted(word) == text; });
}

std::string Special(const std::string& name, Numbers& numbers) {
  if (name == "bit") return Bits()[numbers.Below(Bits().size())];
  if (name == "word") return Words()[numbers.Below(Words().size())];
  if (name == "number") return std::to_string(1 + numbers.Below(8));
  return name == "EOL" ? "\n" : "W is ( never";
}
bool IsSpecial(const std::string& name, const std::string& terminal) {
  if (name == "bit") return std::ranges::find(Bits(), terminal) != Bits().end();
  if (name == "word") return std::ranges::find(Words(), terminal) != Words().end();
  if (name == "number") return IsNumber(terminal);
  return name == "EOL" ? terminal == "\n" : terminal == "W is ( never";
}

properties::PropertyContext AnyNumberFits() {
  properties::PropertyContext context;
  context.locate = [](std::string_view word) -> std::optional<properties::LocatedOperand> {
    const bool is_bit = IsOneOf(Bits(), word);
    if (!is_bit && !IsOneOf(Words(), word)) return std::nullopt;
    properties::PropertyOperand operand{.text = std::string(word), .cells = {}};
    operand.is_bit = is_bit;
    operand.width = 16;  // every number fits: that is not the grammar's
    return operand;
  };
  context.number = [](std::string_view word) -> std::optional<int64_t> {
    if (!IsNumber(word)) return std::nullopt;
    int64_t number = 0;
    std::from_chars(word.data(), word.data() + word.size(), number);
    return number;
  };
  return context;
}

std::string Joined(const std::vector<std::string>& terminals) {
  std::string text;
  for (const std::string& terminal : terminals) text += terminal == "\n" ? terminal : " " + terminal;
  return text;
}

/// What a grammar cannot say: how large numbers are. Lines without a property are no file, but they are sentences.
bool IsBeyondGrammar(const properties::PropertyError& error) {
  switch (error.fault) {
    case properties::PropertyFault::kNoFit:
    case properties::PropertyFault::kRange:
    case properties::PropertyFault::kTooLong:
    case properties::PropertyFault::kNothing:
      return true;
    case properties::PropertyFault::kSyntax:
    case properties::PropertyFault::kLocation:
    case properties::PropertyFault::kNotMemory:
    case properties::PropertyFault::kBitNeeded:
      return false;
  }
  return false;
}

TEST(PropertyGrammar, IsWhole) { EXPECT_THAT(TheGrammar().Problems(), testing::IsEmpty()); }

TEST(PropertyGrammar, EveryProductionHasAReader) {
  std::string parser;
  for (const char* const name : {"parse.cc", "words.cc"})
    parser += Contents(std::filesystem::path(PLCXX_ROOT) / "transpiler/prove/properties" / name);
  for (const std::string& name : TheGrammar().Names()) {
    const std::string definition = " " + TheGrammar().ReaderOf(name) + "(";
    EXPECT_NE(parser.find(definition), std::string::npos) << name << " is read by" << definition;
  }
}

TEST(PropertyGrammar, SentencesAreRead) {
  size_t properties = 0;
  for (uint64_t seed = 0; seed < 600; ++seed) {
    Numbers numbers(seed);
    const std::vector<std::string> terminals = TheGrammar().Sentence(numbers, Special, kShape);
    ASSERT_TRUE(TheGrammar().Accepts(terminals, IsSpecial));
    const properties::Properties parsed = properties::ParseProperties(Joined(terminals), AnyNumberFits());
    for (const properties::PropertyError& error : parsed.errors) {
      EXPECT_TRUE(IsBeyondGrammar(error))
          << error.line << ":" << error.column << ": " << testing::PrintToString(error.words) << "\n"
          << Joined(terminals);
    }
    properties += parsed.properties.size();
  }
  EXPECT_GT(properties, 300U);
}

// One symbol left out, doubled, exchanged or replaced: the grammar says whether it is a sentence still.
TEST(PropertyGrammar, WhatIsNoSentenceIsRefused) {
  const std::vector<std::string> symbols{"never", "always", "and",     "or",  "not",  "implies", "within", "for", "in",
                                         "is",    "stuck",  "(",       ")",   ",",    "..",      "<=",     "=",   "at",
                                         "of",    "one",    "exactly", "bit", "slow", "A",       "W",      "3"};
  size_t refused = 0, accepted = 0;
  for (uint64_t seed = 0; seed < 4000; ++seed) {
    Numbers numbers(seed);
    std::vector<std::string> terminals = TheGrammar().Sentence(numbers, Special, kShape);
    if (terminals.size() < 2 || terminals.size() > 60) continue;
    const auto at = static_cast<ptrdiff_t>(numbers.Below(terminals.size()));
    if (terminals[static_cast<size_t>(at)] == "#" || terminals[static_cast<size_t>(at)] == "W is ( never") continue;
    switch (numbers.Below(4)) {
      case 0:
        terminals.erase(terminals.begin() + at);
        break;
      case 1:
        terminals.insert(terminals.begin() + at, terminals[static_cast<size_t>(at)]);
        break;
      case 2:
        terminals.insert(terminals.begin() + at, symbols[numbers.Below(symbols.size())]);
        break;
      default:
        terminals[static_cast<size_t>(at)] = symbols[numbers.Below(symbols.size())];
        break;
    }
    if (terminals.back() != "\n") terminals.emplace_back("\n");
    // Behind a comment's sign everything is comment, also what was put there.
    const bool has_comment = std::ranges::find(terminals, "#") != terminals.end();
    if (has_comment) continue;
    const properties::Properties parsed = properties::ParseProperties(Joined(terminals), AnyNumberFits());
    const bool is_sentence = TheGrammar().Accepts(terminals, IsSpecial);
    // A number that is wrong ends the reading of its line.
    if (std::ranges::any_of(parsed.errors, IsBeyondGrammar)) continue;
    const bool is_read = parsed.errors.empty();
    EXPECT_EQ(is_read, is_sentence) << Joined(terminals);
    ++(is_sentence ? accepted : refused);
  }
  EXPECT_GT(refused, 200U);
  EXPECT_GT(accepted, 20U);
}

}  // namespace
}  // namespace plcxx::prove
