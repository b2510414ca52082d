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

TEST(NamespaceOf, NoWordOfCppNoMacroAndNoTypeOfStdint) {
  EXPECT_EQ(NamespaceOf("lamp"), "lamp");
  EXPECT_EQ(NamespaceOf("class"), "class_program");
  EXPECT_EQ(NamespaceOf("NULL"), "NULL_program");
  EXPECT_EQ(NamespaceOf("int8_t"), "int8_t_program");
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
  EXPECT_EQ(names.Allocate("t", "U4A14"), "t");
  EXPECT_EQ(names.Allocate("uint8_t", "U4A21"), "uint8_t_U4A21");
  EXPECT_EQ(names.Allocate("int_fast7_t", "U4A22"), "int_fast7_t_U4A22");
  EXPECT_EQ(names.Allocate("UINT9_MAX", "U4A23"), "UINT9_MAX_U4A23");
  EXPECT_EQ(names.Allocate("INTPTR_WIDTH", "U4A24"), "INTPTR_WIDTH_U4A24");
  EXPECT_EQ(names.Allocate("uint", "U4A25"), "uint");
  EXPECT_EQ(names.Allocate("MY_MAX", "U4A26"), "MY_MAX");
  EXPECT_EQ(names.Allocate("round2", "U4A16"), "round2_U4A16");
  EXPECT_EQ(names.Allocate("OnDelayTimer", "U4A17"), "OnDelayTimer_U4A17");
  EXPECT_EQ(names.Allocate("OnDelayTimerTag", "U4A18"), "OnDelayTimerTag_U4A18");
  EXPECT_EQ(names.Allocate("on_delay_timer", "U4A19"), "on_delay_timer_U4A19");
  EXPECT_EQ(names.Allocate("OnDelayTimer_done", "U4A20"), "OnDelayTimer_done_U4A20");
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
