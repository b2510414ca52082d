// Measures a fleet of a program: processor time of a period, of compiling, and memory, as one line of JSON.
//
// plcxx_fleet_bench LANES PERIODS SOURCE...       LANES: 64, 256, 512, or 0 for what the processor has
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/engines/platform.h"
#include "transpiler/fleet/fleet.h"
#include "transpiler/ir/zones.h"

namespace {

using namespace plcxx;

constexpr uint32_t kPeriodsOfAnInput = 16;

double ProcessorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

int Measure(unsigned lanes, uint32_t periods, char** sources, int count) {
  compilation::CompilationRequest request;
  for (int i = 0; i < count; ++i) request.sources.emplace_back(sources[i]);
  const compilation::Compilation compiled = compilation::Compile(request);
  if (!compiled.ok()) {
    std::fprintf(stderr, "the program has errors\n");
    return 1;
  }
  const auto start = std::chrono::steady_clock::now();
  const fleet::LibraryOrFailure built =
      fleet::CompileFleet(compiled.program, {.compiler = engines::FindCompiler(), .level = "2", .lanes = lanes});
  if (const auto* failure = std::get_if<std::string>(&built)) {
    std::fprintf(stderr, "%s\n", failure->c_str());
    return 1;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const auto& library = std::get<std::shared_ptr<const fleet::Library>>(built);
  fleet::Fleet fleet(library);
  std::mt19937_64 random(1);
  fleet.PowerOn();
  // What the control writes differs from lane to lane, so that no branch is taken by all, and changes now and then: in
  // the same periods in which the generated code alone is given new inputs.
  std::vector<std::span<uint64_t>> inputs;
  for (uint32_t s = 0; s < compiled.program.spaces.size(); ++s) {
    const ir::Space& space = compiled.program.spaces[ir::SpaceId(s)];
    if (!space.host_visible) continue;
    for (uint32_t offset = 0; offset < space.bytes; ++offset) {
      const uint8_t changes = ir::BitsInZones(space, offset, ir::Direction::kInput);
      for (uint8_t bit = 0; bit < 8; ++bit) {
        const std::span<uint64_t> words = fleet.PlaneOf(ir::SpaceId(s), offset, bit);
        for (uint64_t& word : words) word = random();
        if ((changes >> bit & 1) != 0 && !words.empty()) inputs.push_back(words);
      }
    }
  }
  const uint32_t period_ms = compiled.program.schedule.period_ms;
  double best = 1e9;
  uint32_t now_ms = 0;
  for (int round = 0; round < 5; ++round) {
    const double before = ProcessorSeconds();
    for (uint32_t i = 0; i < periods; ++i) {
      if (i % kPeriodsOfAnInput == 0) {
        for (const std::span<uint64_t> words : inputs) {
          for (uint64_t& word : words) word = random();
        }
      }
      fleet.Run(fleet::Piece::kPeriod, now_ms += period_ms);
    }
    best = std::min(best, (ProcessorSeconds() - before) / periods);
  }
  std::printf(
      "{\"lanes\": %u, \"ns_per_period_and_machine\": %.4f, \"compile_s\": %.2f, \"state_bytes_per_lane\": %.1f, "
      "\"sliced\": %u, \"per_lane\": %u}\n",
      library->lanes, best * 1e9 / library->lanes, seconds.count(),
      static_cast<double>(library->state_bytes) / library->lanes, library->share.sliced, library->share.per_lane);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "plcxx_fleet_bench LANES PERIODS SOURCE...\n");
    return 2;
  }
  return Measure(static_cast<unsigned>(std::atoi(argv[1])), static_cast<uint32_t>(std::atoi(argv[2])), argv + 3,
                 argc - 3);
}
