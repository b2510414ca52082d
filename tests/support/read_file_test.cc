#include "transpiler/support/read_file.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "tests/temporary_directory.h"
#include "transpiler/support/sized_text.h"

namespace plcxx::support {
namespace {

TEST(ReadFile, GivesTheBytesAsTheyAre) {
  const testing_support::TemporaryDirectory folder;
  const std::string bytes("a\r\n\0\xFF", 5);
  EXPECT_EQ(ReadFile(folder.Write("bytes", bytes)), bytes);
  EXPECT_EQ(ReadFile(folder.Write("empty", "")), "");
}

TEST(ReadFile, WhatIsNoFileGivesNothing) {
  const testing_support::TemporaryDirectory folder;
  EXPECT_EQ(ReadFile(folder.path()), std::nullopt);
  EXPECT_EQ(ReadFile(folder.File("none")), std::nullopt);
}

TEST(SizedText, TellsPartsApart) {
  std::string one, other;
  AddSized(one, "ab");
  AddSized(one, "c");
  AddSized(other, "a");
  AddSized(other, "bc");
  EXPECT_EQ(one, "2:ab1:c");
  EXPECT_NE(one, other);
}

}  // namespace
}  // namespace plcxx::support
