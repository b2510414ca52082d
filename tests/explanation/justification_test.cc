// Explanations are justifications: what they name forces the signal, whatever everything else is. Judged over the
// golden programs and the samples of all languages.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "tests/explanation/explained_part.h"
#include "tests/volume.h"

namespace plcxx::explanation {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> ScenariosBelow(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().string();
    if (path.ends_with(".yaml") && entry.path().filename() != "plcxx.yaml") paths.push_back(path);
  }
  std::ranges::sort(paths);
  return paths;
}

struct Count {
  uint32_t machines = 0, explained = 0, refused = 0, leaves = 0, moved = 0;
};

/// Signals of the program that are written, spread over it.
std::vector<std::vector<execute::CellId>> SignalsOf(const Subject& subject, size_t most) {
  std::vector<std::vector<execute::CellId>> all;
  for (const ir::Place& place : subject.program.places) {
    if (place.indexed || !execute::IsInside(subject.program, place)) continue;
    if (!place.is_field() && subject.program.spaces[place.space].lifetime == ir::Lifetime::kRoutine) continue;
    all.push_back(execute::CellsOf(subject.program, subject.cells, place));
  }
  if (all.size() <= most) return all;
  std::vector<std::vector<execute::CellId>> some;
  for (size_t i = 0; i < most; ++i) some.push_back(all[i * all.size() / most]);
  return some;
}

void JudgeMachine(const std::string& path, size_t signals, Count& count) {
  const std::optional<Machine> machine = LoadMachine(path);
  if (!machine) return;
  const uint32_t parts = PartsOf(*machine);
  if (parts == 0) return;
  const Subject subject(machine->compilation.program);
  const std::optional<Frame> frame = FrameOf(*machine, parts - 1);
  ASSERT_TRUE(frame) << path;
  ++count.machines;
  uint64_t seed = 1;
  for (const std::vector<execute::CellId>& cells : SignalsOf(subject, signals)) {
    const Explanation explanation = Explain(subject, *frame, cells, "signal");
    if (!explanation.refusal.empty()) {
      ++count.refused;
      continue;
    }
    ++count.explained;
    const Judged judged = Judge(subject, *frame, cells, explanation, ++seed);
    EXPECT_EQ(judged.refuted, "") << path << ", "
                                  << execute::CellName(subject.program,
                                                       execute::CellAt(subject.program, subject.cells, cells.front()));
    count.leaves += judged.leaves;
    count.moved += judged.moved;
  }
}

class Justification : public ::testing::TestWithParam<const char*> {};

TEST_P(Justification, TheLeavesForceTheSignal) {
  const std::string dialect = GetParam();
  Count count;
  const std::vector<std::string> golden = ScenariosBelow(PLCXX_ROOT "/tests/golden/" + dialect);
  const size_t every = testing_support::Volume<size_t>(40, 1);
  for (size_t i = 0; i < golden.size(); i += every) JudgeMachine(golden[i], 6, count);
  for (const auto& entry : fs::directory_iterator(PLCXX_ROOT "/samples/" + dialect)) {
    if (!entry.is_directory()) continue;
    const std::vector<std::string> sample = ScenariosBelow(entry.path().string());
    for (size_t i = 0; i < sample.size(); i += testing_support::Volume<size_t>(sample.size(), 3)) {
      JudgeMachine(sample[i], testing_support::Volume<size_t>(4, 60), count);
    }
  }
  RecordProperty("explained", std::to_string(count.explained));
  std::cout << dialect << ": " << count.machines << " machines, " << count.explained << " explained, " << count.refused
            << " refused, " << count.moved << " of " << count.leaves << " leaves change the signal alone\n";
  EXPECT_GT(count.explained, count.refused);
  // Small: most of what is named is needed where everything else stays as it is.
  EXPECT_GE(count.moved * 3, count.leaves);
}

INSTANTIATE_TEST_SUITE_P(Languages, Justification,
                         ::testing::Values("nc110", "technol", "host50", "prostep", "hnc", "classicladder"),
                         [](const auto& named) { return std::string(named.param); });

}  // namespace
}  // namespace plcxx::explanation
