// Local output (invariant 4 of the design): single edits of a large program change a few lines of its C++.
//
// 200 edits of each language by edited_programs.py. The fixture that must fail: the same output with its lines numbered
// through, as a printer writes that counts temporaries or statements over the whole program.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/locality/line_changes.h"
#include "tests/temporary_directory.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/compile/child_process.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"

namespace plcxx::locality {
namespace {

using Files = std::vector<emit::OutputFile>;

constexpr uint32_t kStatements = 1000;
constexpr uint32_t kEdits = 200;

struct Edit {
  std::string file, kind, what;
};

/// The program of a language and its edits, in a directory of their own.
class EditedPrograms {
 public:
  explicit EditedPrograms(std::string dialect, uint32_t edits) : dialect_(std::move(dialect)) {
    const std::string script = std::string(PLCXX_ROOT) + "/tests/locality/edited_programs.py";
    const compile::ProcessResult made = compile::RunProcess(
        {"python3", script, dialect_, std::to_string(kStatements), std::to_string(edits), directory_.path().string()},
        120);
    EXPECT_EQ(made.exit_code, 0) << made.output;
    std::ifstream rows(directory_.File("edits.txt"));
    for (std::string row; std::getline(rows, row);) {
      std::istringstream fields(row);
      Edit& edit = edits_.emplace_back();
      std::getline(fields, edit.file, '\t');
      std::getline(fields, edit.kind, '\t');
      std::getline(fields, edit.what);
    }
    EXPECT_EQ(edits_.size(), edits);
  }

  const std::vector<Edit>& edits() const { return edits_; }
  Files Base() const {
    for (const auto& entry : std::filesystem::directory_iterator(directory_.path()))
      if (entry.path().stem() == "base") return Emit(entry.path().filename().string());
    ADD_FAILURE() << "no base program of " << dialect_;
    return {};
  }
  /// The generated C++ of one of them.
  Files Emit(const std::string& file) const {
    compilation::CompilationRequest request;
    request.sources = {file};
    request.dialect = dialect_;
    request.base_directory = directory_.path().string();
    request.name = "program";
    const compilation::Compilation compilation = compilation::Compile(request);
    std::string errors;
    for (const diag::Diagnostic& diagnostic : compilation.diagnostics.all())
      if (diagnostic.severity == diag::Severity::kError) errors += diagnostic.text + "\n";
    EXPECT_TRUE(compilation.ok()) << dialect_ << ", " << file << ": " << errors;
    if (!compilation.ok()) return {};
    const emit::Emittable emittable = emit::legalize::Legalize(compilation.program, {.name = "program"});
    return emit::print::PrintCpp(emittable, *compilation.sources);
  }

 private:
  testing_support::TemporaryDirectory directory_;
  std::string dialect_;
  std::vector<Edit> edits_;
};

class Locality : public testing::TestWithParam<const char*> {};

TEST_P(Locality, ASingleEditChangesAFewLines) {
  const EditedPrograms programs(GetParam(), kEdits);
  const Files base = programs.Base();
  struct Measured {
    LineChanges changes;
    const Edit* edit;
  };
  std::vector<Measured> all;
  for (const Edit& edit : programs.edits()) {
    all.push_back({CompareFiles(base, programs.Emit(edit.file)), &edit});
    EXPECT_GT(all.back().changes.changed, 0u) << edit.file << ": " << edit.kind << ": " << edit.what;
  }
  std::vector<size_t> changed;
  for (const Measured& measured : all) changed.push_back(measured.changes.changed);
  const Distribution distribution = DistributionOf(changed);
  std::cout << GetParam() << ": median " << distribution.median << ", 99th percentile " << distribution.percentile99
            << ", most " << distribution.most << " changed lines\n";
  std::ranges::sort(all, std::greater(), [](const Measured& measured) { return measured.changes.changed; });
  std::string costliest;
  for (size_t i = 0; i < 5; ++i) {
    const auto& [changes, edit] = all[i];
    costliest += std::to_string(changes.changed) + " lines (" + std::to_string(changes.removed) + " removed, " +
                 std::to_string(changes.added) + " added): " + edit->kind + ": " + edit->what + "\n";
  }
  EXPECT_TRUE(IsLocal(distribution)) << costliest;
}

INSTANTIATE_TEST_SUITE_P(Dialects, Locality, testing::Values("nc110", "prostep", "host50", "technol", "hnc"),
                         [](const auto& test) { return std::string(test.param); });

/// Numbers every line of code through the file.
Files Numbered(Files files) {
  for (emit::OutputFile& file : files) {
    std::istringstream lines(file.text);
    std::string text;
    uint32_t number = 0;
    for (std::string line; std::getline(lines, line);)
      text += line.empty() ? "\n" : line + "  // " + std::to_string(++number) + "\n";
    file.text = text;
  }
  return files;
}

TEST(LocalityFixture, OutputThatIsNumberedThroughIsNotLocal) {
  const EditedPrograms programs("nc110", 10);
  const Files base = Numbered(programs.Base());
  std::vector<size_t> changed;
  for (const Edit& edit : programs.edits())
    changed.push_back(CompareFiles(base, Numbered(programs.Emit(edit.file))).changed);
  EXPECT_FALSE(IsLocal(DistributionOf(changed)));
}

TEST(LineChanges, AreThoseOfAShortestDifference) {
  const auto compare = [](std::string_view before, std::string_view after) {
    const LineChanges changes = CompareLines(before, after);
    return std::vector<size_t>{changes.removed, changes.added, changes.changed};
  };
  using Counts = std::vector<size_t>;
  EXPECT_EQ(compare("a\nb\nc\n", "a\nb\nc\n"), (Counts{0, 0, 0}));
  EXPECT_EQ(compare("", "a\nb\n"), (Counts{0, 2, 2}));
  EXPECT_EQ(compare("a\nb\n", ""), (Counts{2, 0, 2}));
  EXPECT_EQ(compare("a\nb\nc\n", "a\nx\nc\n"), (Counts{1, 1, 1}));
  EXPECT_EQ(compare("a\nb\nc\nd\n", "x\nb\nc\ny\nz\n"), (Counts{2, 3, 3}));
  EXPECT_EQ(compare("a\nb\nc\nd\ne\n", "c\na\nb\nd\nf\n"), (Counts{2, 2, 3}));
}

TEST(LineChanges, OfAFileThatOneVersionHasAreAllItsLines) {
  const Files before = {{"a.cpp", "1\n2\n"}, {"b.cpp", "1\n2\n3\n"}};
  const Files after = {{"a.cpp", "1\n2\n"}, {"c.cpp", "1\n2\n3\n"}};
  EXPECT_EQ(CompareFiles(before, after).changed, 6u);
}

TEST(Distributions, AreJudgedByMedianAndPercentile) {
  std::vector<size_t> changed(200, 3);
  EXPECT_TRUE(IsLocal(DistributionOf(changed)));
  changed[0] = changed[1] = 4000;
  EXPECT_TRUE(IsLocal(DistributionOf(changed)));
  EXPECT_EQ(DistributionOf(changed).most, 4000u);
  changed[2] = 21;
  EXPECT_FALSE(IsLocal(DistributionOf(changed)));
  EXPECT_FALSE(IsLocal(DistributionOf(std::vector<size_t>(200, 4))));
}

}  // namespace
}  // namespace plcxx::locality
