#include "transpiler/review/diff/confirm.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <future>
#include <variant>

#include "transpiler/engines/compiled_program.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/scenarios/suite.h"

namespace plcxx::review::diff {
namespace {

bool IsReplayed(const DiffItem& item) {
  return item.counterexample && item.counterexample->replay == Replay::kSimulator;
}

int SecondsUntil(std::chrono::steady_clock::time_point end) {
  return static_cast<int>(
      std::chrono::duration_cast<std::chrono::seconds>(end - std::chrono::steady_clock::now()).count());
}

/// Both versions as generated code, compiled beside each other; why not, otherwise.
std::string CompileBoth(const std::shared_ptr<const engines::Platform>& platform, std::array<DiffSide*, 2> sides,
                        std::array<scenarios::ScenarioProgram, 2>& programs,
                        std::chrono::steady_clock::time_point end) {
  const int seconds = SecondsUntil(end);
  if (seconds < 1) return "the time was over";
  const auto compile = [&platform, seconds](const DiffSide* side) {
    return engines::CompileFor(platform, side->compilation.program, *side->compilation.sources, emit::Flavour::kRelease,
                               seconds);
  };
  std::future<engines::CompiledOrFailure> other = std::async(std::launch::async, compile, sides[1]);
  std::array<engines::CompiledOrFailure, 2> built{compile(sides[0]), other.get()};
  for (size_t i = 0; i < built.size(); ++i) {
    if (const auto* const failure = std::get_if<engines::CompileFailure>(&built[i])) {
      return SecondsUntil(end) < 1 ? "the time was over" : failure->message;
    }
    programs[i].Give(*platform, emit::Flavour::kRelease, std::move(built[i]));
  }
  return {};
}

}  // namespace

void ConfirmCompiled(DiffSide& old_side, DiffSide& new_side, const DiffOptions& options,
                     std::chrono::steady_clock::time_point end, Diff& diff) {
  if (std::ranges::none_of(diff.items, IsReplayed)) return;
  if (options.progress) options.progress("runs as generated code");
  engines::PlatformOrFailure made = engines::MakeHostPlatform(options.compiler);
  if (const auto* const failure = std::get_if<engines::CompileFailure>(&made)) {
    diff.not_compiled = failure->message;
    return;
  }
  const auto platform = std::get<std::shared_ptr<const engines::Platform>>(std::move(made));
  std::array<scenarios::ScenarioProgram, 2> programs{scenarios::ScenarioProgram(old_side.compilation),
                                                     scenarios::ScenarioProgram(new_side.compilation)};
  diff.not_compiled = CompileBoth(platform, {&old_side, &new_side}, programs, end);
  if (!diff.not_compiled.empty()) return;
  scenarios::SuiteOptions suite;
  suite.simulator = true;  // the code follows it from batch to batch of periods; alone it would be asked after each one
  suite.explains = false;
  suite.platforms = {{.platform = platform}};
  const std::string path = (std::filesystem::path(options.scenario_directory) / "counterexample.yaml").string();
  std::chrono::steady_clock::duration greatest{};  // that a replay took
  for (DiffItem& item : diff.items) {
    if (!IsReplayed(item)) continue;
    const std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    if (begin + std::max(greatest, 2 * item.counterexample->cost) >= end) {
      diff.not_compiled = "the time was over";
      return;
    }
    const scenarios::ScenarioOrErrors read = scenarios::ParseScenario(path, item.counterexample->scenario);
    const auto outcome = [&](scenarios::ScenarioProgram& program) {
      return scenarios::TestScenario(std::get<scenarios::Scenario>(read), suite, program).test.outcome;
    };
    if (outcome(programs[0]) == scenarios::TestOutcome::kPassed &&
        outcome(programs[1]) == scenarios::TestOutcome::kFailed) {
      item.counterexample->replay = Replay::kCompiled;
    } else {
      item.verdict = ItemVerdict::kUndecided;
      item.reason = "the simulator shows a difference that the generated code does not";
      item.counterexample.reset();
    }
    greatest = std::max(greatest, std::chrono::steady_clock::now() - begin);
  }
}

}  // namespace plcxx::review::diff
