// The index of a program's names, against what a search through the program finds.

#include "transpiler/ir/name_index.h"

#include <gtest/gtest.h>

#include "transpiler/ir/reader.h"

namespace plcxx::ir {
namespace {

Program Named() {
  Program program = ReadOrDie(R"(program "p" test
space m 8 volatile little
state T1 on_delay_timer
state X one_shot
state T2 ring_counter
place Lamp bit m[0].0
place LAMP bit m[0].1
place Lamp2 bit m[1].0
)");
  // Languages have one name several times; the text form has not.
  program.states[StateId(2)].name = "T1";
  program.places[PlaceId(2)].name = "Lamp";
  program.places[PlaceId(1)].address = "m+0.1";
  program.places[PlaceId(2)].address = "m+0.1";
  program.documentation = {{.address = "U1", .symbols = "PUMP, PUMPS_LONG_A"},
                           {.address = "U2", .symbols = "pump"},
                           {.address = "U3", .symbols = "PUMPS_LONG_B, PUMP"},
                           {.address = "U2", .symbols = ""}};
  program.symbols = {{.name = "v[]"}, {.name = "w"}, {.name = "v[]", .offset = 2}};
  return program;
}

TEST(NameIndex, DocumentationByItsSymbols) {
  const Program program = Named();
  const NameIndex names(program);
  EXPECT_EQ(names.WithSymbols("pump")->address, "U2");
  EXPECT_EQ(names.WithSymbols("PUMP"), nullptr) << "all of them together are the name";
  EXPECT_EQ(names.WithSymbols("PUMP, PUMPS_LONG_A")->address, "U1");
  EXPECT_EQ(names.WithSymbolsOfAnyCase("Pump")->address, "U2");
  EXPECT_EQ(names.WithSymbolsOfAnyCase("pumps"), nullptr);
  EXPECT_EQ(names.WithAddress("U2")->symbols, "pump") << "the first row of two";
  EXPECT_EQ(names.WithAddress("U"), nullptr);
}

TEST(NameIndex, DocumentationByOneSymbol) {
  const Program program = Named();
  const NameIndex names(program);
  EXPECT_EQ(names.WithSymbol("PUMP", 10)->address, "U1");
  EXPECT_EQ(names.WithSymbol("pump", 10)->address, "U2");
  EXPECT_EQ(names.WithSymbol("PUMPS_LONG_B", 12)->address, "U3");
  EXPECT_EQ(names.WithSymbol("PUMPS_LONG_B", 10)->address, "U1") << "ten characters count";
  EXPECT_EQ(names.WithSymbol("PUMPS_LON", 10), nullptr);
  EXPECT_EQ(names.WithSymbol("Z", 10), nullptr);
}

TEST(NameIndex, InstancesSymbolsAndPlaces) {
  const Program program = Named();
  const NameIndex names(program);
  EXPECT_EQ(names.State(StateKind::kOnDelayTimer, "T1"), StateId(0));
  EXPECT_EQ(names.State(StateKind::kRingCounter, "T1"), StateId(2));
  EXPECT_FALSE(names.State(StateKind::kOneShot, "T1").valid());
  ASSERT_EQ(names.Symbols("v[]").size(), 2u);
  EXPECT_EQ(names.Symbols("v[]")[1], &program.symbols[2]);
  EXPECT_TRUE(names.Symbols("v").empty());
  ASSERT_EQ(names.Places("Lamp").size(), 2u);
  EXPECT_EQ(names.Places("Lamp")[1], &program.places[PlaceId(2)]);
  ASSERT_EQ(names.PlacesOfAnyCase("lamp").size(), 3u);
  EXPECT_EQ(names.PlacesOfAnyCase("lamp")[0], &program.places[PlaceId(0)]) << "in the order of the program";
  EXPECT_EQ(names.PlaceAt("m+0.1"), &program.places[PlaceId(1)]);
  EXPECT_EQ(names.PlaceAt("m+0.2"), nullptr);
}

}  // namespace
}  // namespace plcxx::ir
