// The table of keys, the schema and the page of the documents say the same.
#include "transpiler/project/schema.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "transpiler/project/globs.h"
#include "transpiler/project/keys.h"

namespace plcxx::project {
namespace {

using ::testing::HasSubstr;

std::string Text(const std::string& name) {
  std::ifstream file(PLCXX_ROOT "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ProjectSchema, IsTheOneInTheDocuments) {
  constexpr const char* kFile = "docs/plcxx.schema.json";
  if (std::getenv("PLCXX_UPDATE_GOLDEN") != nullptr) std::ofstream(PLCXX_ROOT "/" + std::string(kFile)) << Schema();
  EXPECT_EQ(Text(kFile), Schema());
}

TEST(ProjectSchema, HasEveryKeyInItsSection) {
  const nlohmann::json schema = nlohmann::json::parse(Schema());
  for (const KeyRow& row : Keys()) {
    const std::string key(row.text);
    const nlohmann::json& section = row.section == Section::kFile       ? schema
                                    : row.section == Section::kProgram  ? schema["definitions"]["program"]
                                    : row.section == Section::kWarnings ? schema["definitions"]["warnings"]
                                                                        : schema["definitions"]["target"];
    EXPECT_THAT(section["properties"][key]["description"], HasSubstr(row.meaning)) << key;
    EXPECT_EQ(section["additionalProperties"], false);
    if (row.section == Section::kProgram) {
      EXPECT_TRUE(schema["properties"].contains(key)) << key;
    }
  }
}

TEST(ProjectSchema, ThePageHasEveryKey) {
  const std::string page = Text("docs/project.md");
  for (const KeyRow& row : Keys()) {
    const std::string line =
        "| `" + std::string(row.text) + "` | " + std::string(row.meaning) + " | " + std::string(row.when_absent) + " |";
    EXPECT_THAT(page, HasSubstr(line));
  }
}

TEST(Globs, StarsAndQuestionMarks) {
  EXPECT_TRUE(MatchesName("b.plc", "*.plc"));
  EXPECT_TRUE(MatchesName("b.plc", "?.plc"));
  EXPECT_TRUE(MatchesName("aXbXc", "a*b*c"));
  EXPECT_TRUE(MatchesName("", "*"));
  EXPECT_FALSE(MatchesName("b.plcx", "*.plc"));
  EXPECT_FALSE(MatchesName("bb.plc", "?.plc"));
  EXPECT_FALSE(MatchesName("a", ""));
  EXPECT_FALSE(MatchesName(std::string(5000, 'a'), "*a*a*a*a*a*a*a*a*b"));
}

}  // namespace
}  // namespace plcxx::project
