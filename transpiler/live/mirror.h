// The State of a running machine in a simulator of its program, so that it is shown as a simulated one is.
//
// In: bytes of State as they come. Out: the memory and instances of the simulator, and by one part that is computed
// again from them what each statement gives, for the power flow; the memory that this part writes is thrown away. What
// the program asks of its host meanwhile gives 0. Not its job: the wire (linked_machine.h).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "transpiler/emit/layout/layout.h"
#include "transpiler/live/machine.h"

namespace plcxx::live {

class Mirror {
 public:
  /// Both outlive it. What State does not have stays as it is in the machine.
  Mirror(const ir::Program& program, const emit::layout::Layout& layout, Machine& machine);

  /// Bytes of State from `offset` on; those after its end are left out.
  void Take(uint32_t offset, std::span<const uint8_t> bytes);
  /// The machine becomes what was taken.
  void Show();
  /// The faults that the part computed again reports, each as its host call.
  std::vector<sim::HostEvent> ComputeAgain();

 private:
  /// What a byte of State is.
  enum class Kind : uint8_t { kNothing, kByte, kBit, kField };
  struct Home {
    Kind kind = Kind::kNothing;
    uint8_t bit = 0;     // of kBit
    uint8_t field = 0;   // of kField
    uint8_t bytes = 1;   // of an element of the field
    uint32_t owner = 0;  // space or instance
    uint32_t at = 0;     // byte of the space, or element of the field
    uint32_t first = 0;  // of kField: the byte of State in which the element begins
  };

  void FindFields(const ir::Program& program, const emit::layout::Layout& layout);
  void Put(const Home& home, uint32_t offset);
  /// The time that the machine's timers had last.
  uint32_t NowMs() const;

  const ir::Program& program_;
  Machine& machine_;
  std::vector<Home> homes_;     // by byte of State
  std::vector<uint8_t> state_;  // as it came
  sim::Simulator::Saved saved_;
};

}  // namespace plcxx::live
