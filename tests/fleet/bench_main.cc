// Measures a fleet of a program: processor time of a period, of compiling, and memory, as one line of JSON.
//
// plcxx_fleet_bench LANES PERIODS SOURCE... | plcxx.yaml       LANES: 64, 256, 512, or 0 for what the processor has
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scalar_time.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/engines/platform.h"
#include "transpiler/fleet/fleet.h"
#include "transpiler/ir/zones.h"
#include "transpiler/project/project.h"
#include "transpiler/sim/place_access.h"
#include "transpiler/sim/simulator.h"

namespace {

using namespace plcxx;

double ProcessorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// What one command line means: sources, or the file of a project with one program.
std::optional<compilation::CompilationRequest> RequestOf(std::span<char* const> sources) {
  if (sources.size() == 1 && std::string_view(sources.front()).ends_with(project::kProjectFile)) {
    const project::ProjectOrErrors read = project::ReadProject(sources.front());
    const auto* const found = std::get_if<project::Project>(&read);
    if (found == nullptr || found->programs.size() != 1) return std::nullopt;
    return project::RequestOf(found->programs.front());
  }
  compilation::CompilationRequest request;
  for (const char* const source : sources) request.sources.emplace_back(source);
  return request;
}

struct Simulated {
  double ns = 0, instructions = 0;  // of a period
};

/// The same program in the simulator, with inputs as those of ScalarNs.
Simulated MeasureSimulator(const ir::Program& program, const std::vector<bench::BitPlace>& seen,
                           const std::vector<bench::BitPlace>& inputs, uint32_t periods) {
  sim::Simulator simulator(program);
  std::mt19937_64 random(1);
  const auto set = [&](const std::vector<bench::BitPlace>& bits) {
    for (const bench::BitPlace& bit : bits) {
      ir::Place place{.type = ir::Type::kBit, .space = bit.space};
      place.offset = bit.offset;
      place.bit = bit.bit;
      simulator.Write(place, random() & 1);
    }
  };
  simulator.PowerOn();
  set(seen);
  Simulated best{.ns = 1e18};
  uint32_t now_ms = 0;
  for (int round = 0; round < 5; ++round) {
    const double before = ProcessorSeconds();
    const uint64_t executed = simulator.executed();
    for (uint32_t i = 0; i < periods; ++i) {
      if (i % bench::kPeriodsOfAnInput == 0) set(inputs);
      simulator.RunPeriod(now_ms += program.schedule.period_ms);
      simulator.TakeEvents();
    }
    const double ns = (ProcessorSeconds() - before) * 1e9 / periods;
    if (ns < best.ns) best = {ns, static_cast<double>(simulator.executed() - executed) / periods};
  }
  return best;
}

/// By space: bytes that an index may reach are tables and buffers, not what a control changes from period to period.
std::vector<std::vector<bool>> IndexedBytes(const ir::Program& program) {
  std::vector<std::vector<bool>> indexed;
  for (const ir::Space& space : program.spaces) indexed.emplace_back(space.bytes, false);
  for (const ir::Place& place : program.places) {
    const sim::PlaceAccess access = sim::AccessTo(program, place);
    if (!access.indexed || access.kind == sim::AccessKind::kAbsent) continue;
    for (uint32_t at = access.low; at < access.high; ++at) indexed[access.owner][at] = true;
  }
  return indexed;
}

int Measure(unsigned lanes, uint32_t periods, std::span<char* const> sources) {
  const std::optional<compilation::CompilationRequest> request = RequestOf(sources);
  if (!request) {
    std::fprintf(stderr, "no project of one program: %s\n", sources.front());
    return 1;
  }
  const compilation::Compilation compiled = compilation::Compile(*request);
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
  std::vector<bench::BitPlace> seen_bits, input_bits;
  const std::vector<std::vector<bool>> indexed = IndexedBytes(compiled.program);
  for (uint32_t s = 0; s < compiled.program.spaces.size(); ++s) {
    const ir::Space& space = compiled.program.spaces[ir::SpaceId(s)];
    if (!space.host_visible) continue;
    for (uint32_t offset = 0; offset < space.bytes; ++offset) {
      if (indexed[s][offset]) continue;
      const uint8_t changes = ir::BitsInZones(space, offset, ir::Direction::kInput);
      for (uint8_t bit = 0; bit < 8; ++bit) {
        const std::span<uint64_t> words = fleet.PlaneOf(ir::SpaceId(s), offset, bit);
        for (uint64_t& word : words) word = random();
        if (words.empty()) continue;
        seen_bits.push_back({ir::SpaceId(s), offset, bit});
        if ((changes >> bit & 1) == 0) continue;
        inputs.push_back(words);
        input_bits.push_back({ir::SpaceId(s), offset, bit});
      }
    }
  }
  const uint32_t period_ms = compiled.program.schedule.period_ms;
  double best = 1e9;
  uint32_t now_ms = 0;
  for (int round = 0; round < 5; ++round) {
    const double before = ProcessorSeconds();
    for (uint32_t i = 0; i < periods; ++i) {
      if (i % bench::kPeriodsOfAnInput == 0) {
        for (const std::span<uint64_t> words : inputs) {
          for (uint64_t& word : words) word = random();
        }
      }
      fleet.Run(fleet::Piece::kPeriod, now_ms += period_ms);
    }
    best = std::min(best, (ProcessorSeconds() - before) / periods);
  }
  const std::optional<double> scalar = bench::ScalarNs(compiled, seen_bits, input_bits, 16 * periods);
  if (!scalar) return 1;
  const Simulated simulated = MeasureSimulator(compiled.program, seen_bits, input_bits, periods);
  std::printf(
      "{\"lanes\": %u, \"ns_per_period_and_machine\": %.4f, \"scalar_ns\": %.4f, \"simulator_ns\": %.1f, "
      "\"instructions\": %.1f, \"compile_s\": %.2f, "
      "\"state_bytes_per_lane\": %.1f, \"inputs\": %zu, \"sliced\": %u, \"per_lane\": %u}\n",
      library->lanes, best * 1e9 / library->lanes, *scalar, simulated.ns, simulated.instructions, seconds.count(),
      static_cast<double>(library->state_bytes) / library->lanes, inputs.size(), library->share.sliced,
      library->share.per_lane);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "plcxx_fleet_bench LANES PERIODS SOURCE... | plcxx.yaml\n");
    return 2;
  }
  return Measure(static_cast<unsigned>(std::atoi(argv[1])), static_cast<uint32_t>(std::atoi(argv[2])),
                 {argv + 3, static_cast<size_t>(argc - 3)});
}
