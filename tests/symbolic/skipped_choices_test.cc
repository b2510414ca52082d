// A choice that a condition rules out is none, whatever order the choices are in.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/random.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove {
namespace {

/// As the cases of a switch over a byte in memory are: each writes, and the others leave it.
TEST(SkippedChoices, ACaseThatIsTakenOutOfASwitchIsOneTerm) {
  terms::Terms terms;
  const terms::TermId state = terms.Variable("state", 8), now = terms.Variable("now", 1);
  const terms::TermId x = terms.Variable("x", 1), enable = terms.Variable("enable", 1);
  const auto is = [&](uint64_t value) { return terms.And(enable, terms.Eq(state, terms.Const(value, 8))); };
  const terms::TermId as_switch = terms.Ite(is(3), x, terms.Ite(is(4), terms.Not(x), now));
  // case 2 writes nothing, and asks first.
  EXPECT_EQ(terms.Ite(is(2), now, as_switch), as_switch);
  EXPECT_EQ(terms.Ite(terms.Not(is(2)), as_switch, now), as_switch);
  // What may hold together is none of it.
  EXPECT_NE(terms.Ite(enable, now, as_switch), as_switch);
  EXPECT_NE(terms.Ite(terms.Variable("other", 1), now, as_switch), as_switch);
}

TEST(SkippedChoices, ABitThatIsSetAndOneThatIsNotExcludeEachOther) {
  terms::Terms terms;
  const terms::TermId a = terms.Variable("a", 1), b = terms.Variable("b", 1), c = terms.Variable("c", 1);
  const terms::TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8);
  const terms::TermId chosen = terms.Ite(terms.And(a, b), x, y);
  EXPECT_EQ(terms.Ite(terms.And(c, terms.Not(a)), y, chosen), chosen);
  EXPECT_NE(terms.Ite(terms.And(c, terms.Not(a)), x, chosen), chosen);
}

/// Whatever is found out about them, choices have the value that they have.
TEST(SkippedChoices, RandomOnesKeepTheirValue) {
  constexpr int kLanes = 64, kSteps = 60;
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    terms::Random random(seed * 7919);
    terms::Terms terms;
    const terms::TermId state = terms.Variable("state", 8), mode = terms.Variable("mode", 8);
    std::vector<terms::TermId> conditions, words = {terms.Variable("x", 8), terms.Variable("y", 8)};
    std::vector<std::vector<uint64_t>> of_conditions, of_words(2, std::vector<uint64_t>(kLanes));
    std::vector<std::vector<uint64_t>> inputs(kLanes);
    for (int lane = 0; lane < kLanes; ++lane) {
      inputs[lane] = {random.Next() % 5, random.Next() % 5, random.Next() % 256, random.Next() % 256};
      of_words[0][lane] = inputs[lane][2];
      of_words[1][lane] = inputs[lane][3];
    }
    for (uint64_t value = 0; value < 5; ++value) {
      for (const auto& [variable, number] : {std::pair(state, 0), std::pair(mode, 1)}) {
        conditions.push_back(terms.Eq(variable, terms.Const(value, 8)));
        of_conditions.emplace_back();
        for (const std::vector<uint64_t>& input : inputs)
          of_conditions.back().push_back(input[number] == value ? 1 : 0);
      }
    }
    const auto any = [&random](const auto& of) { return static_cast<size_t>(random.Next() % of.size()); };
    for (int step = 0; step < kSteps; ++step) {
      const size_t a = any(conditions), b = any(conditions);
      std::vector<uint64_t> values;
      switch (random.Next() % 5) {
        case 0:
          conditions.push_back(terms.Not(conditions[a]));
          for (int lane = 0; lane < kLanes; ++lane) values.push_back(of_conditions[a][lane] ^ 1);
          of_conditions.push_back(values);
          break;
        case 1:
          conditions.push_back(terms.And(conditions[a], conditions[b]));
          for (int lane = 0; lane < kLanes; ++lane) values.push_back(of_conditions[a][lane] & of_conditions[b][lane]);
          of_conditions.push_back(values);
          break;
        case 2:
          conditions.push_back(terms.Or(conditions[a], conditions[b]));
          for (int lane = 0; lane < kLanes; ++lane) values.push_back(of_conditions[a][lane] | of_conditions[b][lane]);
          of_conditions.push_back(values);
          break;
        default: {
          const size_t then = any(words), otherwise = random.OneIn(2) ? words.size() - 1 : any(words);
          const terms::TermId word = terms.Ite(conditions[a], words[then], words[otherwise]);
          for (int lane = 0; lane < kLanes; ++lane)
            values.push_back(of_conditions[a][lane] != 0 ? of_words[then][lane] : of_words[otherwise][lane]);
          words.push_back(word);
          of_words.push_back(values);
        }
      }
    }
    for (size_t i = 0; i < words.size(); ++i) {
      for (int lane = 0; lane < kLanes; ++lane)
        ASSERT_EQ(terms::Evaluate(terms, words[i], inputs[lane]), of_words[i][lane]) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace plcxx::prove
