// What a runtime header may contain: an opening comment, and no directive but inclusions of the freestanding headers
// and of each other. Each rule has a fixture that breaks it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace plcxx {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::filesystem::path kHeaders = std::filesystem::path(PLCXX_ROOT) / "runtime_support" / "plcxx";
const std::filesystem::path kFixtures = std::filesystem::path(PLCXX_ROOT) / "tests" / "runtime_support" / "fixtures";

bool IsAllowed(const std::string& directive) {
  static const std::set<std::string> kAllowed = {"#pragma once", "#include <stdint.h>", "#include <stddef.h>"};
  const std::string own = "#include \"plcxx/";
  if (directive.starts_with(own) && directive.ends_with('"')) {
    return std::filesystem::exists(kHeaders / directive.substr(own.size(), directive.size() - own.size() - 1));
  }
  return kAllowed.contains(directive);
}

/// What is wrong with a header; empty when nothing is.
std::vector<std::string> Faults(const std::filesystem::path& header) {
  std::vector<std::string> faults;
  std::ifstream file(header);
  EXPECT_TRUE(file) << header;
  size_t opening = 0;
  bool in_opening = true;
  for (std::string line; std::getline(file, line);) {
    in_opening = in_opening && line.starts_with("//");
    if (in_opening) ++opening;
    const size_t first = line.find_first_not_of(" \t");
    if (first != std::string::npos && line[first] == '#' && !IsAllowed(line.substr(first))) faults.push_back(line);
  }
  if (opening < 3 || opening > 10) faults.push_back("the opening comment has " + std::to_string(opening) + " lines");
  return faults;
}

TEST(Headers, ContainOnlyWhatFreestandingCodeMay) {
  int headers = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kHeaders)) {
    EXPECT_EQ(entry.path().extension(), ".h");
    EXPECT_THAT(Faults(entry.path()), IsEmpty()) << entry.path();
    ++headers;
  }
  EXPECT_GE(headers, 11);
}

TEST(Headers, FaultsAreFound) {
  EXPECT_THAT(Faults(kFixtures / "forbidden_include.h"), ElementsAre("#include <cstdint>"));
  EXPECT_THAT(Faults(kFixtures / "defines_macro.h"), ElementsAre(HasSubstr("#define")));
  EXPECT_THAT(Faults(kFixtures / "no_opening.h"), ElementsAre("the opening comment has 1 lines"));
}

}  // namespace
}  // namespace plcxx
