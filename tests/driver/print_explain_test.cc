// plcxx print and plcxx explain.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(Print, EveryPhase) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  for (const std::string phase :
       {"source", "tokens", "syntax", "ir", "ir-structured", "ir-optimized", "ir-emittable", "cpp"}) {
    const Ran ran = work.Run("print " + phase + " ok.plc");
    EXPECT_EQ(ran.code, 0) << phase << "\n" << ran;
    EXPECT_THAT(ran.out, Not(IsEmpty())) << phase;
    EXPECT_THAT(ran.errors, IsEmpty()) << phase;
  }
}

TEST(Print, SourceIsUtf8) {
  const Workplace work;
  work.Write("old.plc", "U4A0=I0A0 ; \x84\xA0\n$\n");
  EXPECT_EQ(work.Run("print source old.plc --encoding cp866").out, "U4A0=I0A0 ; \xD0\x94\xD0\xB0\n$\n");
}

TEST(Print, SyntaxIsThereInSpiteOfErrors) {
  const Workplace work;
  work.Write("bad.plc", kBadProgram);
  const Ran ran = work.Run("print syntax bad.plc");
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.out, Not(IsEmpty()));
  EXPECT_THAT(ran.errors, HasSubstr("nc110-1"));
}

TEST(Print, UnknownPhaseNamesThePhases) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  const Ran ran = work.Run("print irr ok.plc");
  EXPECT_EQ(ran.code, 2);
  EXPECT_THAT(ran.errors, HasSubstr("ir-structured"));
}

TEST(Explain, PageByCode) {
  const Workplace work;
  for (const std::string code : {"nc110-41", "NC110-41", "41", "nc110-W356", "w356", "plcxx-5"}) {
    const Ran ran = work.Run("explain " + code);
    EXPECT_EQ(ran.code, 0) << code;
    EXPECT_THAT(ran.out, ::testing::StartsWith("# ")) << code;
    EXPECT_THAT(ran.errors, IsEmpty()) << code;
  }
}

TEST(Explain, UnknownCodeNamesNearOnes) {
  const Workplace work;
  const Ran near = work.Run("explain nc110-W3566");
  EXPECT_EQ(near.code, 2);
  EXPECT_THAT(near.errors, HasSubstr("did you mean nc110-W356"));
  const Ran far = work.Run("explain nonsense");
  EXPECT_EQ(far.code, 2);
  EXPECT_THAT(far.errors, HasSubstr("--list"));
}

TEST(Explain, ListAndWithoutACode) {
  const Workplace work;
  const Ran ran = work.Run("explain --list");
  EXPECT_EQ(work.Run("explain").out, ran.out);
  EXPECT_EQ(ran.code, 0);
  EXPECT_THAT(ran.out, HasSubstr("nc110-41 "));
  EXPECT_THAT(ran.out, HasSubstr("nc110-W356"));
  EXPECT_THAT(ran.out, HasSubstr("plcxx-8"));
}

TEST(Explain, WordsAreLookedForInThePages) {
  const Workplace work;
  const Ran coil = work.Run("explain DOUBLE coil");
  EXPECT_EQ(coil.code, 0);
  EXPECT_THAT(coil.out, HasSubstr("nc110-W356"));
  EXPECT_THAT(coil.out, Not(HasSubstr("nc110-41 ")));
  const Ran none = work.Run("explain double nonsensical");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.errors, HasSubstr("no page speaks of all these words"));
}

}  // namespace
}  // namespace plcxx::driver
