// Which of two places that want one name gets it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::legalize {
namespace {

struct Wanted {
  std::string name, address;
};

/// The names of bits in the order of their places, all of which are stored.
std::vector<std::string> NamesOf(const std::vector<Wanted>& places) {
  ir::Program program;
  program.name = "p";
  const ir::SpaceId space = program.spaces.Add({.name = "A", .title = "memory", .bytes = 100});
  const ir::RegionId body = program.regions.Add({});
  program.routines.Add({.name = "slow", .kind = ir::RoutineKind::kSlow, .body = body});
  ir::Builder builder(program);
  builder.SetRegion(body);
  for (uint32_t i = 0; i < places.size(); ++i) {
    const ir::PlaceId place = program.places.Add({.name = places[i].name,
                                                  .address = places[i].address,
                                                  .type = ir::Type::kBit,
                                                  .space = space,
                                                  .offset = i,
                                                  .bit = 0});
    builder.Store(place, builder.Bit(1));
  }
  return Legalize(program, {.name = "p"}).place_names;
}

using Names = std::vector<std::string>;

// The user chose the symbol, at a lower address; not the name of the control's own bit, nor the spelling of an address.
TEST(PlaceNames, WhatTheUserDidNotChooseKeepsItsName) {
  EXPECT_EQ(NamesOf({{"now", "U4A0"}, {"now", ""}}), (Names{"now_U4A0", "now"}));
  EXPECT_EQ(NamesOf({{"U4A1", "U4A0"}, {"U4A1", "U4A1"}}), (Names{"U4A1_U4A0", "U4A1"}));
}

// A local may be handed from function to function: in each of them no other one has its name.
TEST(PlaceNames, LocalsOfOneFunctionDiffer) {
  const ir::Program program = ir::ReadOrDie(R"(
space one 8 routine little own
space two 8 routine little own
space three 8 routine little own
place x bit one[0].0
place x~2 bit two[0].0 named x
place x~3 bit three[0].0 named x
routine f subroutine {
  body {
    %0 = const bit 1
    store x %0
  }
}
routine g subroutine {
  body {
    %0 = const bit 1
    store x %0
    store x~2 %0
  }
}
routine h subroutine {
  body {
    %0 = const bit 1
    store x~3 %0
  }
}
)");
  const Names names = Legalize(program, {.name = "p"}).place_names;
  ASSERT_EQ(names.size(), 3u);
  EXPECT_EQ(names[0], "x");
  EXPECT_NE(names[1], "x");
  EXPECT_EQ(names[2], "x");
}

TEST(PlaceNames, OfTwoSymbolsTheLowerAddressHasTheName) {
  EXPECT_EQ(NamesOf({{"PUMP.", "U4A0"}, {"PUMP.", "U4A1"}}), (Names{"PUMP_", "PUMP_U4A1"}));
}

}  // namespace
}  // namespace plcxx::emit::legalize
