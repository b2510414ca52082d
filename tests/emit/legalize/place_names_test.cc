// Which of two places that want one name gets it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/ir/builder.h"

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

TEST(PlaceNames, OfTwoSymbolsTheLowerAddressHasTheName) {
  EXPECT_EQ(NamesOf({{"PUMP.", "U4A0"}, {"PUMP.", "U4A1"}}), (Names{"PUMP_", "PUMP_U4A1"}));
}

}  // namespace
}  // namespace plcxx::emit::legalize
