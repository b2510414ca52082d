// Which bits the control and host functions write.
#pragma once

#include "transpiler/symbolic/execute/execute.h"

namespace plcxx::execute {

/// What the control does to the bits of a byte: no bit is in both.
struct ControlBits {
  uint8_t values = 0, clears = 0;
};
ControlBits BitsControlWrites(const ir::Space& space, uint32_t offset);
/// The same of one bit.
ControlWrite WhatControlWrites(const ir::Space& space, uint32_t offset, uint8_t bit);

/// The bits of a byte that a host function of this access writes, by the table at HostSees.
uint8_t BitsHostWrites(const ir::Program& program, ir::HostAccess access, ir::SpaceId space, uint32_t offset);
/// As BitsHostWrites; but inputs of the machine come with the regular exchange alone: a function that the program calls
/// for something else writes what the control and the program share. And nothing outside of the space that is declared
/// as the only one.
uint8_t BitsMayWrite(const ir::Program& program, const ir::HostFunction& host, ir::SpaceId space, uint32_t offset);

}  // namespace plcxx::execute
