// What an NC-110 control has: packages, zones, timer ranges. Data in machine.def.
//
// Not its job: the predefined signals (signals.h) and what a program makes of them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "transpiler/dialects/nc110/machine/operands.h"
#include "transpiler/ir/program.h"

namespace plcxx::nc110 {

constexpr uint32_t kBytesPerConnector = 4;
constexpr uint32_t kProcessConnectors = 26;  // of packages K and N, for each process
constexpr uint32_t kMostProcesses = 5;
constexpr uint32_t kRetainedBytes = 64;

/// The spaces of every program of this dialect; the packages stand first.
enum class SpaceIndex : uint8_t { kA, kT, kK, kN, kSystem, kArguments, kLatched };

ir::SpaceId SpaceOf(Package package);
ir::SpaceId SpaceOf(SpaceIndex space);
uint32_t Bytes(Package package);
/// Of package bytes laid one after the other in the order of the spaces.
uint32_t PackageBase(Package package);
constexpr uint32_t kAllPackageBytes = 2240;

/// The byte of an I, U or W operand in its package.
uint32_t ByteOf(const Operand& operand);
/// Its bits in that byte: one for I and U, all for W.
uint8_t BitsOf(const Operand& operand);
bool IsMemory(const Operand& operand);

/// Who writes a connector, as the manual draws it; kInternal for memory without a direction.
ir::Direction DirectionOf(Package package, uint32_t connector, uint32_t processes);
/// Connectors that belong to the control's interface, used or not.
bool InBasePart(Package package, uint32_t connector, uint32_t processes);
/// A signal of the control that the program clears (U9K17, U9K18 and their copies in other processes).
bool IsAcknowledgement(const Operand& operand);

struct TimerBase {
  uint32_t constant_unit_ms = 0;
  uint32_t parametric_ticks = 0;  // of TIM
};
TimerBase BaseOfTimer(uint32_t number);

/// Adds the spaces of SpaceIndex to an empty program. `external` is memory that the control writes (option `extern`).
void AddSpaces(ir::Program& program, uint32_t processes, const std::optional<uint8_t> (&t_initial)[kRetainedBytes],
               std::span<const Operand> external);

}  // namespace plcxx::nc110
