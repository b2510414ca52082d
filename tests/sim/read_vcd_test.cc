#include "transpiler/sim/read_vcd.h"

#include <gmock/gmock.h>

#include <bit>
#include <string>

namespace plcxx::sim {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

/// "5 a=1"
std::vector<std::string> TextsOf(const Vcd& trace) {
  std::vector<std::string> texts;
  for (const VcdChange& change : trace.changes) {
    const VcdSignal& signal = trace.signals[change.signal];
    const std::string value = !change.is_known ? "x"
                              : signal.is_real ? std::to_string(std::bit_cast<double>(change.value))
                                               : std::to_string(change.value);
    texts.push_back(std::to_string(change.time_ms) + " " + signal.name + "=" + value);
  }
  return texts;
}

std::vector<std::string> ChangesOf(const std::string& text) {
  const auto read = ReadVcd(text);
  if (const auto* error = std::get_if<VcdError>(&read)) {
    return {std::to_string(error->line) + ": " + error->message};
  }
  return TextsOf(std::get<Vcd>(read));
}

std::string OneBit(const std::string& changes) {
  return "$timescale 1 ms $end\n$var wire 1 ! a $end\n$enddefinitions $end\n" + changes;
}

TEST(ReadVcd, BitsVectorsAndReals) {
  EXPECT_THAT(ChangesOf("$date today $end $version a logger $end\n$timescale 10ms $end\n$scope module top $end\n"
                        "$var wire 1 ! a $end\n$var reg 8 \" w [7:0] $end\n$var real 64 # r $end\n$upscope $end\n"
                        "$enddefinitions $end\n#0\n$dumpvars\n0!\nb101 \"\nr-1.5 #\n$end\n#3\n1!\n$comment 0! $end\n"
                        "bX1 \"\n"),
              ElementsAre("0 a=0", "0 w=5", "0 r=-1.500000", "30 a=1", "30 w=x"));
}

TEST(ReadVcd, TimeScales) {
  const auto at = [](const std::string& scale, const std::string& time) {
    return ChangesOf("$timescale " + scale + " $end $var wire 1 ! a $end $enddefinitions $end #" + time + " 1!");
  };
  EXPECT_THAT(at("1 s", "2"), ElementsAre("2000 a=1"));
  EXPECT_THAT(at("100us", "25"), ElementsAre("2 a=1"));
  EXPECT_THAT(at("1 ns", "1999999"), ElementsAre("1 a=1"));
  EXPECT_THAT(at("100 fs", "20000000000"), ElementsAre("2 a=1"));
  EXPECT_THAT(at("7 ms", "1"), ElementsAre(HasSubstr("'7ms' is no time scale")));
  EXPECT_THAT(at("1 s", "18446744073709551615"), ElementsAre(HasSubstr("beyond what can be counted")));
}

TEST(ReadVcd, OneCodeForSeveralNames) {
  EXPECT_THAT(ChangesOf("$timescale 1ms $end $var wire 1 ! a $end $var wire 1 ! b $end $enddefinitions $end #1 1!"),
              ElementsAre("1 a=1", "1 b=1"));
}

TEST(ReadVcd, WiderThanANumberHasNoChanges) {
  const auto read = ReadVcd("$timescale 1ms $end $var wire 65 ! a $end $enddefinitions $end #1 b1 ! #9");
  const Vcd& trace = std::get<Vcd>(read);
  EXPECT_THAT(trace.signals, ElementsAre(Field(&VcdSignal::width, 65)));
  EXPECT_TRUE(trace.changes.empty());
  EXPECT_EQ(trace.first_ms, 1u);
  EXPECT_EQ(trace.last_ms, 9u);
}

TEST(ReadVcd, WhatIsWrongHasItsLine) {
  EXPECT_THAT(ChangesOf(""), ElementsAre(HasSubstr("1: the file ends before $enddefinitions")));
  EXPECT_THAT(ChangesOf("time,a\n0,1\n"), ElementsAre(HasSubstr("1: 'time,a' where a declaration")));
  EXPECT_THAT(ChangesOf("$scope module a"), ElementsAre(HasSubstr("1: $scope has no $end")));
  EXPECT_THAT(ChangesOf("\n$var wire 0 ! a $end"), ElementsAre(HasSubstr("2: $var without")));
  EXPECT_THAT(ChangesOf("\n$var wire 1 ! $end"), ElementsAre(HasSubstr("2: $var without")));
  EXPECT_THAT(ChangesOf(OneBit("#0\n1?\n")), ElementsAre("5: '?' is the code of no $var"));
  EXPECT_THAT(ChangesOf(OneBit("#5\n#4\n")), ElementsAre("5: the time goes back at #4"));
  EXPECT_THAT(ChangesOf(OneBit("#five\n")), ElementsAre("4: '#five' is no time"));
  EXPECT_THAT(ChangesOf(OneBit("#0\nb012 !\n")), ElementsAre("5: 'b012' is no change of a value"));
  EXPECT_THAT(ChangesOf(OneBit("#0\nrx !\n")), ElementsAre("5: 'rx' is no change of a value"));
}

}  // namespace
}  // namespace plcxx::sim
