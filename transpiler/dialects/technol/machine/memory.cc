#include "transpiler/dialects/technol/machine/memory.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "transpiler/ir/zones.h"
#include "transpiler/support/check.h"

namespace plcxx::technol {
namespace {

struct SpaceRow {
  SpaceKey key;
  std::string_view name;
  std::string_view title;
  ir::Lifetime lifetime;
  bool host_visible;
  ir::Direction direction;
};
using ir::Lifetime;
constexpr SpaceRow kSpaceRows[] = {
    {SpaceKey::kIn, "IN", "inputs of the machine", Lifetime::kVolatile, true, ir::Direction::kInput},
    {SpaceKey::kOut, "OUT", "outputs to the machine", Lifetime::kVolatile, true, ir::Direction::kOutput},
    {SpaceKey::kSys, "SYS", "system cells and request bits", Lifetime::kVolatile, true,
     ir::Direction::kInternal},  // kSystemZones
    {SpaceKey::kBukon, "BUKON", "machine constants", Lifetime::kVolatile, true, ir::Direction::kInput},
    {SpaceKey::kLabelMem, "LABEL_MEM", "backed-up area", Lifetime::kRetentive, true, ir::Direction::kInternal},
    {SpaceKey::kTabTechnol, "TAB_TECHNOL", "technology table", Lifetime::kRetentive, true, ir::Direction::kInternal},
    {SpaceKey::kSetNctab, "SET_NCTAB", "item for a table of the NC", Lifetime::kVolatile, true, ir::Direction::kOutput},
    {SpaceKey::kUser, "DATA", "cells of the program", Lifetime::kVolatile, true, ir::Direction::kInternal},
    {SpaceKey::kMechanisms, "mechanisms", "activation bits of mechanisms", Lifetime::kVolatile, true,
     ir::Direction::kInternal},
    {SpaceKey::kSteps, "steps", "where mechanisms wait, and how long", Lifetime::kVolatile, false,
     ir::Direction::kInternal},
    {SpaceKey::kRegisters, "registers", "RLO, registers, flags, arguments", Lifetime::kRoutine, false,
     ir::Direction::kInternal},
};
/// Who writes the system cells (5.2). The requests are the program's, the NC takes them back; the starts of functions
/// are the NC's, the scheduler takes them back.
constexpr ir::Zone kSystemZones[] = {
    ir::ZoneOfBytes(0, 1, ir::Direction::kInput),     // MATTL
    ir::ZoneOfBytes(1, 4, ir::Direction::kOutput),    // BZH11, BZH21, BZH22
    ir::ZoneOfBytes(4, 5, ir::Direction::kInput),     // UPS_STAT
    ir::ZoneOfBytes(5, 6, ir::Direction::kOutput),    // UPS_CMD
    ir::ZoneOfBytes(6, 7, ir::Direction::kInput),     // UPS_FAULT
    ir::ZoneOfBytes(7, 8, ir::Direction::kInternal),  // SYSREQ
    ir::ZoneOfBytes(8, 9, ir::Direction::kInput),     // SYSNC
};
constexpr uint32_t kRegisterBytes = 4096;

uint32_t BytesOf(SpaceKey key, const Memory::Sizes& sizes) {
  switch (key) {
    case SpaceKey::kUser:
      return sizes.user;
    case SpaceKey::kMechanisms:
      return sizes.mechanisms;
    case SpaceKey::kSteps:
      return sizes.steps;
    case SpaceKey::kRegisters:
      return kRegisterBytes;
#define TECHNOL_AREA(Key, ...) case SpaceKey::k##Key:
#include "transpiler/dialects/technol/machine/machine.def"
      return technol::BytesOf(static_cast<Area>(key));
    case SpaceKey::kCount:
      break;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace

Memory::Memory(ir::Program& program, const Sizes& sizes) {
  for (const SpaceRow& row : kSpaceRows) {
    ir::Space space{.name = std::string(row.name),
                    .title = std::string(row.title),
                    .bytes = BytesOf(row.key, sizes),
                    .lifetime = row.lifetime,
                    .host_visible = row.host_visible};
    if (space.bytes == 0) continue;
    if (row.host_visible) space.zones = {ir::ZoneOfBytes(0, space.bytes, row.direction)};
    if (row.key == SpaceKey::kSys) space.zones.assign(std::begin(kSystemZones), std::end(kSystemZones));
    // The loader writes another table, and the operator chooses a row of it, while the program runs (5.1, 5.4): a
    // second zone, see execute::ControlWrite.
    if (row.key == SpaceKey::kTabTechnol) space.zones.push_back(ir::ZoneOfBytes(0, space.bytes, ir::Direction::kInput));
    spaces_[static_cast<size_t>(row.key)] = program.spaces.Add(std::move(space));
  }
}

Memory::Memory(const ir::Program& program) {
  // They are the first ones; after them each mechanism may have its own.
  const auto most = static_cast<uint32_t>(std::min<size_t>(program.spaces.size(), std::size(kSpaceRows)));
  for (const SpaceRow& row : kSpaceRows) {
    for (uint32_t i = 0; i < most; ++i) {
      if (program.spaces[ir::SpaceId(i)].name == row.name) spaces_[static_cast<size_t>(row.key)] = ir::SpaceId(i);
    }
  }
}

std::string BitAddress(Area area, uint32_t offset, uint8_t bit) {
  return std::string(Name(area)) + "+" + std::to_string(offset) + "." + std::to_string(bit);
}

std::string CellAddress(Area area, uint32_t offset, uint32_t width) {
  return std::string(Name(area)) + "+" + std::to_string(offset) + ":" + std::to_string(width);
}

}  // namespace plcxx::technol
