// Which programs may run with their fast part in an interrupt above the slow part: each rule with a program that keeps
// it and one that breaks it.

#include "transpiler/checks/preemption.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "transpiler/ir/reader.h"

namespace plcxx::checks {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view kMemory = R"(
space m 32 volatile little host_visible
space locals 8 routine little
state T5 on_delay_timer
state T6 on_delay_timer
place a bit m[0].0
place b bit m[0].1
place in bit m[0].2
place w i8 m[1]
place w0 bit m[1].0
place word i16 m[2]
place wide i64 m[8]
place now i32 m[16]
place done bit field T5 done
place local bit locals[0].0
host exchange () reads_state routine_exchange "all"
host tell () "an event"
)";

/// Each bit in a byte of its own, but those of `w`; 64 bits in two pieces.
std::vector<StoredPlace> Stored(const ir::Program& program) {
  std::vector<StoredPlace> stored;
  for (const ir::Place& place : program.places) {
    const bool packed = place.type != ir::Type::kBit || place.name == "w0";
    const uint32_t bytes = place.type == ir::Type::kBit ? 1 : ir::Bytes(place.type);
    const uint32_t alone = 100 + static_cast<uint32_t>(stored.size());
    stored.push_back({packed ? place.offset : alone, bytes, (bytes + 3) / 4});
  }
  return stored;
}

std::vector<std::string> Find(std::string_view fast, std::string_view slow, std::string_view more = "") {
  const ir::Program program = ir::ReadOrDie(std::string(kMemory) + "routine fast fast {\n" + std::string(fast) +
                                            "}\nroutine slow slow {\n" + std::string(slow) + "}\n" + std::string(more));
  diag::Engine diagnostics;
  static_cast<void>(CheckPreemption(program, Stored(program), diagnostics));
  std::vector<std::string> texts;
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) texts.push_back(diagnostic.text);
  return texts;
}

constexpr std::string_view kFastWritesA = "%0 = load in\nstore a %0\n";
constexpr std::string_view kFastReadsB = "%0 = load b\nstore w0 %0\n";

TEST(Preemption, OneWriterAndOneAccessInAPassAreSafe) {
  EXPECT_THAT(Find(kFastWritesA, "%0 = load a\nstore b %0\n%1 = load in\nstore b %1\n%2 = load in\nstore b %2\n"),
              ElementsAre());
  EXPECT_THAT(Find(kFastReadsB, "%0 = load a\nstore b %0\n"), ElementsAre());
  EXPECT_THAT(Find("%0 = load in\nstore a %0\nstore a %0\n", ""), ElementsAre()) << "no slow part";
}

TEST(Preemption, WrittenByBoth) {
  EXPECT_THAT(Find(kFastWritesA, "%0 = load in\nstore a %0\n"), ElementsAre(HasSubstr("'a' is written by the slow")));
  // A bit of the word that the other part writes.
  EXPECT_THAT(Find(kFastReadsB, "%0 = const i8 1\nstore w %0\n"), ElementsAre(HasSubstr("'w' is written by the slow")));
}

TEST(Preemption, TellsWhatIsShared) {
  const ir::Program program = ir::ReadOrDie(std::string(kMemory) +
                                            "routine fast fast {\n%0 = load in\nstore a %0\n}\n"
                                            "routine slow slow {\n%0 = load a\n%1 = load in\nstore b %1\n}\n");
  diag::Engine diagnostics;
  const std::vector<bool> shared = CheckPreemption(program, Stored(program), diagnostics);
  EXPECT_EQ(std::vector<bool>(shared.begin(), shared.begin() + 3), (std::vector<bool>{true, false, false}));
}

TEST(Preemption, NeighboursInAByte) {
  ir::Program program = ir::ReadOrDie(std::string(kMemory) +
                                      "routine fast fast {\n%0 = load in\nstore a %0\n}\n"
                                      "routine slow slow {\n%0 = load in\nstore b %0\n}\n");
  diag::Engine apart, together;
  std::vector<StoredPlace> stored = Stored(program);
  static_cast<void>(CheckPreemption(program, stored, apart));
  EXPECT_FALSE(apart.HasErrors());
  stored[1].offset = stored[0].offset;
  static_cast<void>(CheckPreemption(program, stored, together));
  ASSERT_TRUE(together.HasErrors());
  EXPECT_THAT(together.all().front().text, HasSubstr("'b', which the slow part writes, shares a byte with 'a'"));
  EXPECT_EQ(together.all().front().notes.size(), 1U);
}

TEST(Preemption, ReadAgain) {
  EXPECT_THAT(Find(kFastWritesA, "%0 = load a\nstore b %0\n%1 = load a\nstore w0 %1\n"),
              ElementsAre(HasSubstr("the slow part reads 'a' more than once")));
  // In one arm or the other is once; in a loop, or in a subroutine that is called twice, it is not.
  EXPECT_THAT(
      Find(kFastWritesA, "%0 = load in\nif %0 {\n%1 = load a\nstore b %1\n} else {\n%2 = load a\nstore b %2\n}\n"),
      ElementsAre());
  EXPECT_THAT(Find(kFastWritesA, "%0 = load in\nif %0 {\n%1 = load a\nstore b %1\n}\n%2 = load a\nstore b %2\n"),
              ElementsAre(HasSubstr("reads 'a' more than once")));
  constexpr std::string_view kSubroutine = "routine sub subroutine {\n%0 = load a\nstore b %0\n}\n";
  EXPECT_THAT(Find(kFastWritesA, "call sub ()\n", kSubroutine), ElementsAre());
  EXPECT_THAT(Find(kFastWritesA, "call sub ()\ncall sub ()\n", kSubroutine),
              ElementsAre(HasSubstr("reads 'a' more than once")));
  // The word and a bit of it are the same memory.
  EXPECT_THAT(Find("%0 = const i8 1\nstore w %0\n", "%0 = load w\n%1 = load w0\nstore b %1\n"),
              testing::Contains(HasSubstr("more than once")));
}

TEST(Preemption, WrittenAgain) {
  EXPECT_THAT(Find(kFastReadsB, "%0 = load in\nstore b %0\n%1 = load a\nstore b %1\n"),
              ElementsAre(HasSubstr("the slow part writes 'b' more than once")));
}

TEST(Preemption, Pieces) {
  EXPECT_THAT(Find("%0 = const i64 1\nstore wide %0\n", "%0 = load wide\n"),
              ElementsAre(HasSubstr("reaches 'wide' in 2 pieces")));
  EXPECT_THAT(Find("%0 = load wide\n", "%0 = const i64 1\nstore wide %0\n"),
              ElementsAre(HasSubstr("reaches 'wide' in 2 pieces")));
  EXPECT_THAT(Find("%0 = const i16 1\nstore word %0\n", "%0 = load word\n"), ElementsAre());
}

TEST(Preemption, InstancesBelongToOnePart) {
  constexpr std::string_view kRuns = "%0 = load in\n%1 = const i32 30\n%2 = load now\nstep.on_delay T5 %0 %1 %2\n";
  EXPECT_THAT(Find(kRuns, "%0 = load done\nstore b %0\n"), ElementsAre()) << "one field, once";
  EXPECT_THAT(Find(kRuns, "%0 = load done\nstore b %0\n%1 = load done\nstore w0 %1\n"),
              ElementsAre(HasSubstr("reads 'done' more than once")));
  EXPECT_THAT(Find(kRuns, kRuns), ElementsAre(HasSubstr("'T5' is run by the slow part")));
  EXPECT_THAT(Find("%0 = load done\nstore a %0\n", kRuns), ElementsAre(HasSubstr("'T5' is run by the slow part")));
  EXPECT_THAT(Find(kRuns, "%0 = load in\nstore done %0\n"), ElementsAre(HasSubstr("'done' is written by the slow")));
}

TEST(Preemption, HostFunctionsThatGetAll) {
  EXPECT_THAT(Find(kFastWritesA, "host exchange ()\n"), ElementsAre(HasSubstr("'exchange' gets all places at once")));
  EXPECT_THAT(Find("host exchange ()\n", "%0 = load a\nstore b %0\n"), ElementsAre(HasSubstr("'exchange' gets all")));
  EXPECT_THAT(Find(kFastWritesA, "host tell ()\n%0 = load a\nstore b %0\n"), ElementsAre());
}

TEST(Preemption, LocalsAreNotShared) {
  EXPECT_THAT(Find("%0 = load in\nstore local %0\n%1 = load local\nstore a %1\n",
                   "%0 = load a\nstore local %0\n%1 = load local\nstore b %1\n%2 = load local\nstore b %2\n"),
              ElementsAre());
}

}  // namespace
}  // namespace plcxx::checks
