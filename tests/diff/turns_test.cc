// The way of searching that found most in its time has the next turn, until it finds fewer than another one did.
#include "transpiler/review/diff/turns.h"

#include <gtest/gtest.h>

namespace plcxx::review::diff {
namespace {

using std::chrono::seconds;

TEST(Turns, EachWayHasOneFirst) {
  Turns turns;
  const Way first = turns.Next();
  turns.Took(first, seconds(1), 1000);
  EXPECT_NE(turns.Next(), first);
}

TEST(Turns, TheOneThatFindsMostUntilItFindsFewer) {
  Turns turns;
  turns.Took(Way::kWide, seconds(5), 400);
  turns.Took(Way::kAtWork, seconds(5), 100);
  EXPECT_EQ(turns.Next(), Way::kWide);
  turns.Took(Way::kWide, seconds(10), 300);
  EXPECT_EQ(turns.Next(), Way::kWide) << "in twice the time fewer a second, and still more than the other one";
  turns.Took(Way::kWide, seconds(5), 90);
  EXPECT_EQ(turns.Next(), Way::kAtWork);
  turns.Took(Way::kAtWork, seconds(5), 80);
  EXPECT_EQ(turns.Next(), Way::kWide);
}

TEST(Turns, WhatTakesNoTimeFindsNothing) {
  Turns turns;
  turns.Took(Way::kWide, seconds(0), 0);
  turns.Took(Way::kAtWork, seconds(5), 1);
  EXPECT_EQ(turns.Next(), Way::kAtWork);
}

}  // namespace
}  // namespace plcxx::review::diff
