// What plcxx says of programs with one word changed, and what they become, is as it was when it was kept: for a change
// of a lowering, a check or a pass that shows in programs only that nobody writes. Kept are hashes, in edits.txt; which
// edits they are of is said where one differs, so that the program can be made and printed by another build.
#include "tests/printed/edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "tests/printed/hashes.h"
#include "tests/printed/printed.h"
#include "transpiler/support/fnv1a.h"

namespace plcxx::printed {
namespace {

const fs::path kProject = PLCXX_ROOT;
const fs::path kKept = kProject / "tests/printed/edits.txt";
constexpr size_t kEdits = 8;
constexpr Phase kSaid{"said", SaidOf, ""};

class Edits : public testing::TestWithParam<HashRow> {};

TEST_P(Edits, AreAsKept) {
  const std::string& path = GetParam().name;
  const std::optional<Input> input = InputOf(kProject / path);
  ASSERT_TRUE(input && !input->request.texts.empty()) << "no program that is written in the file";
  const bool is_c = input->request.dialect == "hnc";
  const auto& [name, text] = *input->request.texts.begin();
  const auto edit = [&](size_t number) {
    return EditOf(text, is_c ? Writing::kC : Writing::kLines, support::HashOf64(path) + number);
  };
  HashRow now{path, {}};
  for (size_t number = 0; number < kEdits; ++number) {
    Input edited = *input;
    edited.request.texts[name] = Edited(text, edit(number));
    const std::string said = OwnTextOf(kSaid, edited);
    EXPECT_EQ(said.find(kProject.string()), std::string::npos) << name << ':' << Described(text, edit(number));
    now.hashes.push_back(HashOf(said));
  }
  ExpectKept(kKept, now, [&](size_t number) { return name + ':' + Described(text, edit(number)); });
}

std::string NameOfParameter(const testing::TestParamInfo<HashRow>& info) {
  std::string name = fs::path(info.param.name).replace_extension().generic_string();
  if (fs::path(info.param.name).extension() == ".c") name.insert(0, "hnc_");
  std::ranges::replace_if(name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Corpus, Edits, testing::ValuesIn(ReadHashes(kKept)), NameOfParameter);

/// Whether one of many edits makes it of a text.
bool Makes(std::string_view edited, std::string_view text, Writing writing) {
  for (uint64_t number = 0; number < 4000; ++number) {
    if (Edited(text, EditOf(text, writing, number)) == edited) return true;
  }
  return false;
}

TEST(PrintedEdits, AreOfEachKind) {
  const std::string_view c = "if (a<=b) c = 7; // e f\n";
  for (const char* edited : {"if (a>b) c = 7; // e f\n", "if (a!=b) c = 7; // e f\n", "while (a<=b) c = 7; // e f\n",
                             "if (a<=b) c |= 7; // e f\n", "if (a<=b) c = 8; // e f\n", "if (a<=b) c = 0; // e f\n",
                             "if (c<=b) c = 7; // e f\n", "if (a<=b) ; // e f\n", "if a<=b) c = 7; // e f\n"}) {
    EXPECT_TRUE(Makes(edited, c, Writing::kC)) << edited;
  }
  EXPECT_FALSE(Makes("if (a<=b) c = 7; // f f\n", c, Writing::kC));
  const std::string_view lines = " LD A ; on\n OUT B\n";
  for (const char* edited : {" LD A ; on\n \n", " LD OUT ; on\n OUT B\n", " LD A ; on\n OUT LD\n"}) {
    EXPECT_TRUE(Makes(edited, lines, Writing::kLines)) << edited;
  }
  EXPECT_FALSE(Makes(" LD A ; LD\n OUT B\n", lines, Writing::kLines));
}

TEST(PrintedEdits, AreTheSameForTheSameNumber) {
  const std::string_view text = "a = b + 1;\n";
  EXPECT_EQ(Edited(text, EditOf(text, Writing::kC, 5)), Edited(text, EditOf(text, Writing::kC, 5)));
  EXPECT_EQ(Described(text, {4, 5, "a"}), "1: 'b' -> 'a'");
  EXPECT_EQ(Edited("", EditOf("", Writing::kC, 5)), "");
}

}  // namespace
}  // namespace plcxx::printed
