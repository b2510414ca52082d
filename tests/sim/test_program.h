// What the tests of the simulator share: programs from text, places by name.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "transpiler/ir/reader.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::sim {

inline const ir::Place& PlaceNamed(const ir::Program& program, std::string_view name) {
  for (const ir::Place& place : program.places) {
    if (place.name == name) return place;
  }
  ADD_FAILURE() << "no place " << name;
  return *program.places.begin();
}

/// A program and its simulator, already powered on.
struct Machine {
  ir::Program program;
  Simulator simulator;

  explicit Machine(std::string_view text) : program(ir::ReadOrDie(text)), simulator(program) { simulator.PowerOn(); }

  uint64_t Get(std::string_view name) { return simulator.Read(PlaceNamed(program, name)); }
  void Set(std::string_view name, uint64_t value) { simulator.Write(PlaceNamed(program, name), value); }
  void Force(std::string_view name, uint64_t value) { simulator.Force(PlaceNamed(program, name), value); }
  void Release(std::string_view name) { simulator.Release(PlaceNamed(program, name)); }
  void Run(uint32_t now_ms = 0) { simulator.RunPeriod(now_ms); }
};

}  // namespace plcxx::sim
