#include "tests/fleet/lanes_beside.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "transpiler/engines/lockstep_snapshot.h"
#include "transpiler/fleet/fleet.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/sim/value_text.h"

namespace plcxx::fleet {
namespace {

/// The same answer for the same machine, call and moment, whoever asks first.
uint64_t Hash(uint64_t a, uint64_t b) {
  uint64_t z = a * 0x9E3779B97F4A7C15 + b + 0x632BE59BD9B4E019;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

struct Machine {
  unsigned lane = 0;
  std::unique_ptr<sim::Simulator> simulator;
  uint64_t calls = 0, fleet_calls = 0;
  std::vector<sim::HostEvent> events;
};

class Comparison {
 public:
  Comparison(std::shared_ptr<const Library> library, uint64_t seed, Hosts hosts)
      : fleet_(std::move(library)), program_(fleet_.program()), seed_(seed), hosts_(hosts) {
    for (const unsigned lane : {0u, 1u, 31u, 63u, 64u, 130u, 255u, 256u, 511u}) {
      if (lane >= fleet_.lanes()) continue;
      Machine& machine = machines_.emplace_back();
      machine.lane = lane;
      machine.simulator = std::make_unique<sim::Simulator>(program_);
    }
    for (Machine& machine : machines_) {
      machine.simulator->AnswerHostCalls([this, &machine](ir::HostFunctionId function, std::span<const uint64_t>) {
        return AnswerOf(function, machine.lane, machine.calls++);
      });
    }
    fleet_.AnswerHostCalls([this](const FleetCall& call) { Answer(call); });
    for (uint32_t s = 0; s < program_.spaces.size(); ++s) nothing_.emplace_back(program_.spaces[ir::SpaceId(s)].bytes);
  }

  std::string Run(uint32_t periods) {
    fleet_.PowerOn();
    for (Machine& machine : machines_) machine.simulator->PowerOn();
    for (const auto& space : program_.spaces) {
      for (const ir::InitialByte& initial : space.initial)
        nothing_[static_cast<size_t>(&space - &*program_.spaces.begin())][initial.offset] = initial.value;
    }
    std::string difference = Compare(0);
    uint32_t now_ms = hosts_ == Hosts::kWild ? 0xFFFF0000u : 0;
    for (uint32_t period = 1; difference.empty() && period <= periods; ++period) {
      SetInputs(period);
      now_ms += program_.schedule.period_ms + LeapAt(period);
      fleet_.Run(Piece::kPeriod, now_ms);
      for (Machine& machine : machines_) machine.simulator->RunPeriod(now_ms);
      difference = Compare(period);
    }
    return difference;
  }

 private:
  /// Time stands still, goes on for weeks, or back.
  uint32_t LeapAt(uint32_t period) const {
    if (hosts_ != Hosts::kWild || period % 41 != 0) return 0;
    constexpr uint32_t kStill = 0u - 10, kBack = 0u - 35, kWeek = 0x1FFFFFFF;
    constexpr uint32_t kLeaps[] = {kStill, 100'000, kWeek, kWeek, kWeek, kWeek, kWeek,      kWeek,
                                   kWeek,  kWeek,   kWeek, kBack, kBack, kBack, 0xFFFFF000, 0x60000000};
    return kLeaps[(period / 41 - 1) % std::size(kLeaps)];
  }
  bool Writes(const ir::Place& place) const {
    if (place.is_field()) return hosts_ == Hosts::kWild;
    return !place.indexed && program_.spaces[place.space].host_visible;
  }

  /// Few bits of a result are 1 at most, so that answers are numbers that programs can use, too.
  sim::HostAnswer AnswerOf(ir::HostFunctionId function, unsigned lane, uint64_t number) const {
    const uint64_t random = Hash(seed_ + lane * 1000003ull + function.index, number);
    const uint64_t value = (random >> 60) < 4 ? random & 0xFF : random & 3;
    sim::HostAnswer answer{.result = Fitting(program_.host_functions[function].result, value), .out = {}};
    if ((random >> 40 & 1) != 0) answer.out = Fitting(program_.host_functions[function].out.type, value >> 1);
    return answer;
  }
  static uint64_t Fitting(ir::Type type, uint64_t value) { return type == ir::Type::kBit ? value & 1 : value; }

  void Answer(const FleetCall& call) {
    const ir::Schedule& schedule = program_.schedule;
    const ir::HostFunction& function = program_.host_functions[call.function];
    for (Machine& machine : machines_) {
      if (!call.calls(machine.lane)) continue;
      std::vector<uint64_t> arguments;
      for (size_t i = 0; i < function.parameters.size(); ++i)
        arguments.push_back(call.arguments[i * call.lanes + machine.lane]);
      if (!function.routine_exchange) machine.events.push_back({call.function, arguments});
      if (call.function == schedule.retentive_load || call.function == schedule.retentive_store) continue;
      const sim::HostAnswer answer = AnswerOf(call.function, machine.lane, machine.fleet_calls++);
      if (call.results != nullptr) call.results[machine.lane] = answer.result;
      if (call.seconds != nullptr) call.seconds[machine.lane] = answer.out.value_or(0);
      if (answer.out) call.has_second[machine.lane / 64] |= uint64_t{1} << (machine.lane % 64);
    }
  }

  void SetInputs(uint32_t period) {
    if (hosts_ == Hosts::kWild && period % 16 > 3) return;  // or some lane would start in every step
    for (uint32_t p = 0; p < program_.places.size(); ++p) {
      const ir::Place& place = program_.places[ir::PlaceId(p)];
      if (!Writes(place) || (place.is_field() && period % 16 != 3)) continue;  // or no clock would ever run
      const bool is_float = place.type == ir::Type::kF32 || place.type == ir::Type::kF64;
      for (unsigned lane = 0; lane < fleet_.lanes(); ++lane) {
        const uint64_t random = Hash(seed_ + 7919ull * lane + period, p);
        if (is_float || random % (place.is_field() ? 64 : 16) != 0) continue;
        uint64_t value = (random >> 60) < 8 ? random >> 32 & 7 : random >> 8;
        if (place.is_field()) value &= place.type == ir::Type::kBit ? 1 : 3;
        fleet_.Write(lane, place, value);
        for (Machine& machine : machines_) {
          if (machine.lane == lane) machine.simulator->Write(place, value);
        }
      }
    }
  }

  std::string Compare(uint32_t period) {
    for (Machine& machine : machines_) {
      const std::string where = "lane " + std::to_string(machine.lane) + ", period " + std::to_string(period) + ": ";
      const std::vector<uint8_t> expected = machine.simulator->Snapshot();
      const std::vector<uint8_t> found = fleet_.Snapshot(machine.lane, nothing_);
      if (expected.size() != found.size()) return where + "the size of the state";
      for (size_t at = 0; at < expected.size(); ++at) {
        if (expected[at] == found[at]) continue;
        const engines::SnapshotCell cell =
            engines::CellAt(program_, at, static_cast<uint8_t>(expected[at] ^ found[at]));
        const uint64_t left = engines::CellValue(cell, expected), right = engines::CellValue(cell, found);
        if (!sim::SameValue(cell.type, left, right))
          return where + cell.name + " is " + std::to_string(left) + " in the simulator, " + std::to_string(right) +
                 " in the fleet";
      }
      const std::vector<sim::HostEvent> events = machine.simulator->TakeEvents();
      if (events.size() != machine.events.size()) return where + "the number of host calls";
      machine.events.clear();
    }
    return {};
  }

  Fleet fleet_;
  const ir::Program& program_;
  uint64_t seed_;
  Hosts hosts_;
  std::vector<Machine> machines_;
  std::vector<std::vector<uint8_t>> nothing_;  // what is not held: as after power-on
};

}  // namespace

std::string CompareLanes(std::shared_ptr<const Library> library, uint64_t seed, uint32_t periods, Hosts hosts) {
  return Comparison(std::move(library), seed, hosts).Run(periods);
}

}  // namespace plcxx::fleet
