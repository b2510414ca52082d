#include "transpiler/support/read_file.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "transpiler/support/sized_text.h"

namespace plcxx::support {
namespace {

class ReadFileTest : public testing::Test {
 protected:
  ~ReadFileTest() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / "plcxx_read_file_test";
};

TEST_F(ReadFileTest, GivesTheBytesAsTheyAre) {
  std::filesystem::create_directories(folder_);
  const std::string bytes("a\r\n\0\xFF", 5);
  std::ofstream(folder_ / "bytes", std::ios::binary) << bytes;
  EXPECT_EQ(ReadFile(folder_ / "bytes"), bytes);
  std::ofstream(folder_ / "empty", std::ios::binary).close();
  EXPECT_EQ(ReadFile(folder_ / "empty"), "");
}

TEST_F(ReadFileTest, WhatIsNoFileGivesNothing) {
  std::filesystem::create_directories(folder_);
  EXPECT_EQ(ReadFile(folder_), std::nullopt);
  EXPECT_EQ(ReadFile(folder_ / "none"), std::nullopt);
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
