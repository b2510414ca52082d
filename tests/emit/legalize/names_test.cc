// The one rule by which names of the source become C++ identifiers.

#include "transpiler/emit/legalize/names.h"

#include <gtest/gtest.h>

namespace plcxx::emit::legalize {
namespace {

TEST(SafeIdentifier, KeepsLettersAndDigits) {
  EXPECT_EQ(SafeIdentifier("U4A8"), "U4A8");
  EXPECT_EQ(SafeIdentifier("cOMU"), "cOMU");
}

TEST(SafeIdentifier, SpellsTheOtherCharacters) {
  EXPECT_EQ(SafeIdentifier("PUMP.ON"), "PUMP_ON");
  EXPECT_EQ(SafeIdentifier("A@B"), "A_atB");
  EXPECT_EQ(SafeIdentifier("A#1"), "A_no1");
  EXPECT_EQ(SafeIdentifier("A'"), "A_q");
  EXPECT_EQ(SafeIdentifier("READY?"), "READY_is");
}

TEST(SafeIdentifier, NeverGivesAReservedName) {
  EXPECT_EQ(SafeIdentifier("1ST"), "n_1ST");
  EXPECT_EQ(SafeIdentifier(".A"), "n_A");
  EXPECT_EQ(SafeIdentifier("A..B"), "A_B");  // two underscores in a row are the compiler's
  EXPECT_EQ(SafeIdentifier(""), "n_");
}

TEST(NameTable, TellsEqualNamesApartByTheirAddress) {
  NameTable names;
  EXPECT_EQ(names.Allocate("PUMP.", "U4A8"), "PUMP_");
  EXPECT_EQ(names.Allocate("PUMP#", "U4A9"), "PUMP_no");
  EXPECT_EQ(names.Allocate("PUMP.", "U5A0"), "PUMP_U5A0");
}

TEST(NameTable, KnowsTheWordsOfCppAndOfTheGeneratedCode) {
  NameTable names;
  EXPECT_EQ(names.Allocate("new", "U4A8"), "new_U4A8");
  EXPECT_EQ(names.Allocate("State", "U4A9"), "State_U4A9");
  EXPECT_EQ(names.Allocate("Add8", "U4A10"), "Add8_U4A10");
  EXPECT_EQ(names.Allocate("NULL", "U4A11"), "NULL_U4A11");
  EXPECT_EQ(names.Allocate("t1", "U4A12"), "t1_U4A12");
  EXPECT_EQ(names.Allocate("t1a", "U4A13"), "t1a");
}

TEST(NameTable, KnowsTheMacrosOfUsualHeaders) {
  NameTable names;
  EXPECT_EQ(names.Allocate("BUFSIZ", "U4A8"), "BUFSIZ_U4A8");
  EXPECT_EQ(names.Allocate("major", "U4A9"), "major_U4A9");
  EXPECT_EQ(names.Allocate("st_atime", "U4A10"), "st_atime_U4A10");
}

TEST(NameTable, NumbersGoOnWhereTheLastOneWas) {
  NameTable names;
  EXPECT_EQ(names.Allocate("A", "1"), "A");
  EXPECT_EQ(names.Allocate("A", "1"), "A_1");
  EXPECT_EQ(names.Allocate("A_1_3", "x"), "A_1_3");
  EXPECT_EQ(names.Allocate("A", "1"), "A_1_2");
  EXPECT_EQ(names.Allocate("A", "1"), "A_1_4");
}

TEST(NameTable, ALocalHasTheFirstNumberThatIsFreeInAllItsFunctions) {
  const NameTable names;
  FunctionNames one, other;
  EXPECT_EQ(names.AllocateIn({&one}, "i"), "i");
  EXPECT_EQ(names.AllocateIn({&one}, "i"), "i_local");
  EXPECT_EQ(names.AllocateIn({&one}, "i"), "i_local_2");
  EXPECT_EQ(names.AllocateIn({&one, &other}, "i"), "i_local_3");
  EXPECT_EQ(names.AllocateIn({&other}, "i"), "i");
  EXPECT_EQ(names.AllocateIn({&other}, "i"), "i_local");
  EXPECT_EQ(names.AllocateIn({&other}, "i"), "i_local_2");
  EXPECT_EQ(names.AllocateIn({&other}, "i"), "i_local_4");
}

}  // namespace
}  // namespace plcxx::emit::legalize
