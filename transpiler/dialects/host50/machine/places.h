// Addresses as places of memory and fields of instances: shared by lowering, which owns a program's places, and locate,
// which names any of them.
//
// Every area is a space of its own: number n at bit n or at byte 4 n. Where a part of an area is retentive (5), it is
// another space with the same numbering, so that it may end inside a byte.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "transpiler/dialects/host50/machine/machine.h"
#include "transpiler/ir/program.h"

namespace plcxx::host50 {

/// The spaces of the control's areas, then that of the scheduler and that of arguments and locals.
void AddSpaces(ir::Program& program, uint32_t channels);
/// Of a program that AddSpaces has begun.
uint32_t ChannelsOf(const ir::Program& program);

/// Not of timers and counters.
ir::SpaceId SpaceOf(const Address& address);
ir::SpaceId SystemSpace();
ir::SpaceId RoutineSpace();

/// A bit, word or float, without name and address.
ir::Place MemoryPlace(const Address& address);

/// What %TMn.Q, %Cn.V ... are; a bare timer or counter is its .Q.
struct InstanceField {
  ir::StateKind kind{};
  ir::Type type{};
  uint8_t field = 0;
};
/// None for memory.
std::optional<InstanceField> FieldOf(const Address& address);

/// The address as maps and scenarios write it: "Q0", "TM3.V".
std::string NameOf(const Address& address);
/// Can a name in C++ be made of this symbol? Else the address stands for it.
bool IsAscii(std::string_view symbol);
/// What names an address in the IR, so that no two addresses have one name: what the source calls it, but the address
/// where that is not ASCII or looks like another address ("TM1" for %TM99).
std::string NameInCode(std::string_view symbol, const Address& address, uint32_t channels);
/// "TM3" of all its attributes.
Address WithoutAttribute(Address address);

}  // namespace plcxx::host50
