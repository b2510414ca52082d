// The lines that the phases print of a program's own statements are as kept: for a change of a lowering, of a pass or
// of the emitter that no run shows, and for the generated code, which is a product.
#include "tests/printed/printed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "tests/printed/groups.h"

namespace plcxx::printed {
namespace {

const fs::path kRoot = PLCXX_ROOT;
const fs::path kPlace = kRoot / "tests/printed";

std::string ReadFile(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// "tests/golden/hnc/loops/do_while.yaml" -> "hnc_loops_do_while", "tests/printed/programs/loops.c" ->
/// "hnc_programs_loops".
std::string NameOf(const Row& row) {
  const fs::path path(row.path);
  std::string name = fs::path(path).replace_extension().generic_string();
  for (const std::string_view place : {"tests/golden/", "tests/judges/avr/", "tests/printed/"}) {
    if (name.starts_with(place)) name.erase(0, place.size());
  }
  if (path.extension() == ".c") name.insert(0, "hnc_");
  if (path.extension() == ".ir") name.insert(0, "ir_");
  std::ranges::replace_if(name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

fs::path KeptOf(const Row& row) { return kPlace / "kept" / (NameOf(row) + ".txt"); }

class Printed : public testing::TestWithParam<Row> {};

TEST_P(Printed, IsAsKept) {
  const char* const update = std::getenv("PLCXX_UPDATE_GOLDEN");
  const std::string now = PrintedText(kRoot, GetParam());
  if (update != nullptr && *update == '1') {
    fs::create_directories(kPlace / "kept");
    std::ofstream(KeptOf(GetParam()), std::ios::binary) << now;
  }
  EXPECT_EQ(ReadFile(KeptOf(GetParam())), now) << "PLCXX_UPDATE_GOLDEN=1 rewrites " << KeptOf(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Corpus, Printed, testing::ValuesIn(ReadCorpus(kPlace / "corpus.txt")),
                         [](const auto& row) { return NameOf(row.param); });

TEST(PrintedCorpus, NothingIsKeptOfOtherPrograms) {
  std::set<std::string> wanted;
  for (const Row& row : ReadCorpus(kPlace / "corpus.txt")) wanted.insert(KeptOf(row).filename());
  ASSERT_TRUE(fs::exists(kPlace / "kept"));
  for (const auto& file : fs::directory_iterator(kPlace / "kept")) {
    EXPECT_TRUE(wanted.contains(file.path().filename())) << file.path() << ": no row of corpus.txt";
  }
}

TEST(PrintedCorpus, EachPhaseIsKeptOfSomeProgram) {
  std::set<std::string, std::less<>> kept;
  for (const Row& row : ReadCorpus(kPlace / "corpus.txt")) kept.insert(row.phases.begin(), row.phases.end());
  for (const std::string_view phase : PhaseNames()) EXPECT_TRUE(kept.contains(phase)) << phase;
}

TEST(PrintedGroups, OwnLinesAreThoseThatOthersDoNotHave) {
  const std::string known = "space m 8\nroutine a {\n  x\n  y\n}\nroutine b {\n  x\n}\n";
  EXPECT_EQ(OwnLines(known, {known}), "");
  EXPECT_EQ(OwnLines("space m 8\nspace n 8\nroutine a {\n  x\n  x\n}\nroutine c {\n  y\n}\n", {known}),
            "space n 8\nroutine a {\n  x\nroutine c {\n  y\n");
  EXPECT_EQ(OwnLines("routine a {\n  x\n\n  y\n}\n\nroutine b {\n  x\n}\n", {known}), "routine a {\n\n  y\n");
  // Of several the one that has a line most often counts.
  EXPECT_EQ(OwnLines("f {\n  x\n  x\n  x\n}\n", {"f {\n  x\n}\n", "f {\n  x\n  x\n}\n"}), "f {\n  x\n");
}

TEST(PrintedGroups, ValuesHaveNoNumbers) {
  EXPECT_EQ(WithoutNumbers("  %12 = and.bit %s1f.0 %3\n  store a %12\n"), "  % = and.bit % %\n  store a %\n");
}

TEST(PrintedGroups, HeadingsAreThoseOfFunctions) {
  EXPECT_EQ(Headings("#include <a>\nvoid f() {\n  if (x) {\n  }\n}\n\nvoid g() {\n}\n"), "void f() {\nvoid g() {\n");
}

}  // namespace
}  // namespace plcxx::printed
