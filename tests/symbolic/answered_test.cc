#include "transpiler/symbolic/solver/answered.h"

#include <gtest/gtest.h>

namespace plcxx::solver {
namespace {

TEST(AnsweredForms, BeginWithWhatTheNearestOfThoseBeforeKnows) {
  AnsweredForms first;
  first["a"] = {.answer = Answer::kNever, .milliseconds = 1};
  first["b"] = {.answer = Answer::kUnknown, .milliseconds = 2};
  AnsweredForms second(&first);
  second["b"] = {.answer = Answer::kPossible, .milliseconds = 3};
  AnsweredForms third(&second);
  EXPECT_EQ(third["a"].answer, Answer::kNever);
  EXPECT_EQ(third["b"].milliseconds, 3U);
  EXPECT_EQ(third["c"].answer, Answer::kUnknown);
  EXPECT_EQ(third["c"].milliseconds, 0U);
}

TEST(AnsweredForms, ThoseBeforeStayAsTheyAre) {
  AnsweredForms first;
  first["a"].milliseconds = 1;
  AnsweredForms second(&first);
  second["a"].milliseconds = 2;
  second["b"].milliseconds = 3;
  EXPECT_EQ(first["a"].milliseconds, 1U);
  EXPECT_EQ(first["b"].milliseconds, 0U);
  EXPECT_EQ(second["a"].milliseconds, 2U);
}

}  // namespace
}  // namespace plcxx::solver
