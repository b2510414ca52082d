// Where a fleet keeps what each machine of it has: a bit as a plane (a bit for each lane), or, where it is the same in
// every machine, a byte as one for all.
//
// In: a program. Out: for each byte of each space and for each field of each state instance its planes. Bytes that an
// index may reach are planes one after the other; what SameEverywhere proves is a scalar. Bits that the program does
// not name have no place here: they are the host's own business. Not its job: the code that uses them (write_code.h).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "transpiler/fleet/same_everywhere.h"
#include "transpiler/ir/program.h"
#include "transpiler/sim/place_access.h"

namespace plcxx::fleet {

inline constexpr uint32_t kNowhere = 0xFFFFFFFF;

struct ByteHome {
  uint32_t scalar = kNowhere;
  std::array<uint32_t, 8> planes{kNowhere, kNowhere, kNowhere, kNowhere, kNowhere, kNowhere, kNowhere, kNowhere};

  bool is_scalar() const { return scalar != kNowhere; }
  bool holds(uint8_t bit) const { return is_scalar() || planes[bit] != kNowhere; }
};

struct Layout {
  std::vector<std::vector<ByteHome>> bytes;   // by SpaceId and offset
  std::vector<std::vector<uint32_t>> fields;  // by StateId and field: its first plane
  std::vector<uint32_t> clocks;               // by StateId: of an on-delay timer that has one
  uint32_t planes = 0, scalars = 0, clock_count = 0;
  uint32_t retentive_planes = 0;  // the first ones: those of retentive memory

  const ByteHome& At(uint32_t space, uint32_t offset) const { return bytes[space][offset]; }
};

Layout LayOut(const ir::Program& program, const SameEverywhere& same);

}  // namespace plcxx::fleet
