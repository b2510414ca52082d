// Who reads and writes what, by the bits that places cover.
#include "transpiler/report/cross_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/report/program_fixture.h"

namespace plcxx::report {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

const Signal& Named(const CrossReference& uses, std::string_view name) {
  for (const Signal& signal : uses.signals) {
    if (signal.name == name) return signal;
  }
  ADD_FAILURE() << "no signal " << name;
  return uses.signals.front();
}

constexpr std::string_view kReferenced = R"(
routine sub subroutine {
body {
stmt s2
%1 = load w
store v %1
}
}
routine slow slow {
body {
stmt s1
%a = load a
store x %a
call sub ()
stmt s3
%b = load both
%x = load x
store x %x
}
}
)";

TEST(CrossReference, ReadersAndWritersWithTheirRoutines) {
  ProgramFixture fixture(std::string(kMemory) + std::string(kReferenced), {"one", "two", "three"});
  const CrossReference uses = MakeCrossReference(fixture.input());
  const Signal& x = Named(uses, "x");
  ASSERT_THAT(x.occurrences, SizeIs(3));
  EXPECT_EQ(x.occurrences[0].use, Use::kWrite);
  EXPECT_EQ(x.occurrences[1].use, Use::kRead);
  EXPECT_THAT(Writers(x), SizeIs(2));
  EXPECT_EQ(x.lifetime, ir::Lifetime::kRetentive);
  EXPECT_EQ(uses.parts[0], "slow") << "a subroutine runs where it is called";
  EXPECT_EQ(uses.parts[1], "slow");
}

TEST(CrossReference, PlacesThatShareBits) {
  ProgramFixture fixture(std::string(kMemory) + std::string(kReferenced), {"one", "two", "three"});
  const CrossReference uses = MakeCrossReference(fixture.input());
  const Signal& v = Named(uses, "v");
  EXPECT_TRUE(v.written);
  EXPECT_TRUE(v.read) << "as a part of `both`";
  ASSERT_THAT(v.overlaps, SizeIs(1));
  EXPECT_EQ(uses.signals[v.overlaps[0]].name, "both");
  const Signal& a = Named(uses, "a");
  EXPECT_TRUE(a.read);
  EXPECT_FALSE(a.written);
  EXPECT_THAT(uses.used[1], ElementsAre(std::pair<uint64_t, uint64_t>(0, 1), std::pair<uint64_t, uint64_t>(8, 24)));
}

TEST(CrossReference, NamesThatNothingUsesAndMeanings) {
  ProgramFixture fixture(std::string(kMemory) + std::string(kReferenced), {"one", "two", "three"});
  fixture.program().documentation = {{"in0.0", "START", "", "cycle start", ""}, {"m0.2", "LAMP", "", "", ""}};
  for (const ir::Place& place : fixture.program().places) {
    if (place.name == "a" || place.name == "z") fixture.input().documented.emplace_back(place);
  }
  const CrossReference uses = MakeCrossReference(fixture.input());
  const Signal& a = Named(uses, "a");
  EXPECT_EQ(a.words, "cycle start; also START");
  EXPECT_EQ(a.address, "in0.0");
  const Signal& lamp = Named(uses, "LAMP");
  EXPECT_TRUE(lamp.documented_only);
  EXPECT_THAT(lamp.occurrences, SizeIs(0));
}

}  // namespace
}  // namespace plcxx::report
