#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <variant>

#include "tests/pairs/pair.h"
#include "tests/reference/host50_reference.h"
#include "tests/reference/nc110_reference.h"
#include "tests/reference/prostep.h"
#include "tests/reference/technol.h"
#include "tests/scenario_texts.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::pairs {
namespace {

namespace fs = std::filesystem;

std::string Content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Scenarios of golden programs that compile.
const std::vector<fs::path>& GoldenScenarios(const std::string& dialect) {
  static std::map<std::string, std::vector<fs::path>> of_dialect;
  static std::mutex filling;  // pairs are made by several threads
  const std::lock_guard lock(filling);
  std::vector<fs::path>& paths = of_dialect[dialect];
  if (!paths.empty()) return paths;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(PLCXX_ROOT) / "tests/golden" / dialect)) {
    const std::string path = entry.path().string();
    if (path.ends_with(".yaml") && !path.ends_with("_bad.yaml")) paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  return paths;
}

ProgramText Golden(const std::string& dialect, Random& random) {
  const std::vector<fs::path>& paths = GoldenScenarios(dialect);
  for (int tries = 0; tries < 50; ++tries) {
    const fs::path& path = paths[Below(random, paths.size())];
    scenarios::ScenarioOrErrors read = scenarios::ReadScenario(path.string());
    auto* const scenario = std::get_if<scenarios::Scenario>(&read);
    if (scenario == nullptr || !scenario->steps || scenario->sources.empty()) continue;
    std::map<std::string, std::string> written = TakeTexts(*scenario);
    ProgramText program{.dialect = dialect,
                        .sources = scenario->sources,
                        .files = std::move(written),
                        .options = scenario->options,
                        .scenario = Content(path)};
    for (const auto& entry : fs::directory_iterator(path.parent_path())) {
      const std::string name = entry.path().filename().string();
      // Files beside it may be included, or named by options; what was printed is not.
      const bool is_printed =
          name.ends_with(".cc") || name.ends_with(".ir") || name.ends_with(".syntax") || name.ends_with(".yaml");
      const bool is_other =
          name.ends_with(".plc") || name.ends_with(".il") || name.ends_with(".cld") || name.ends_with(".clp");
      const bool is_source = std::ranges::find(program.sources, name) != program.sources.end();
      if (entry.is_regular_file() && !is_printed && (!is_other || is_source))
        program.files[name] = Content(entry.path());
    }
    const bool all_here = std::ranges::all_of(
        program.sources, [&program](const std::string& source) { return program.files.contains(source); });
    if (all_here) return program;
  }
  return {};
}

/// None: of hnc and classicladder there is none.
using Generate = reference::RandomProgram (*)(reference::Random& random, reference::ProgramSize size,
                                              reference::Spelling spelling);
Generate GeneratorOf(const std::string& dialect) {
  if (dialect == "nc110") return reference::RandomNc110;
  if (dialect == "host50") return reference::RandomHost50;
  if (dialect == "prostep") return reference::MakeRandomProstep;
  if (dialect == "technol") return reference::MakeRandomTechnol;
  return nullptr;
}

ProgramText Generated(const std::string& dialect, Generate generate, Random& random) {
  reference::Random seeded(random.Next());
  const reference::RandomProgram made = generate(seeded, reference::ProgramSize::kSmall, reference::Spelling::kAny);
  ProgramText program{.dialect = dialect, .sources = {}, .files = {}, .options = made.options, .scenario = {}};
  for (const reference::RenderedFile& file : reference::Render(made, program.dialect)) {
    if (file.name.ends_with(".yaml")) {
      program.scenario = file.text;
    } else {
      const auto of = std::ranges::find(made.files, file.name, &reference::RandomFile::name);
      if (of == made.files.end() || of->is_source) program.sources.push_back(file.name);
      program.files[file.name] = file.text;
    }
  }
  return program;
}

}  // namespace

ProgramText RandomProgramText(const std::string& dialect, Random& random) {
  // Most are small, so that many are decided in a second: a golden program has ten lines, one that is generated
  // hundreds.
  const Generate generate = GeneratorOf(dialect);
  if (generate != nullptr && random.OneIn(4)) return Generated(dialect, generate, random);
  if (dialect == "hnc" && random.OneIn(3)) return RandomHncPair(random).old_program;
  return Golden(dialect, random);
}

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

std::string TextOf(const std::vector<std::string>& lines) {
  std::string text;
  for (size_t i = 0; i < lines.size(); ++i) text += (i == 0 ? "" : "\n") + lines[i];
  return text;
}

}  // namespace plcxx::pairs
