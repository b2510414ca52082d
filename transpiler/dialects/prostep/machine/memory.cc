#include "transpiler/dialects/prostep/machine/memory.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "transpiler/ir/zones.h"
#include "transpiler/support/check.h"

namespace plcxx::prostep {
namespace {

struct MemoryRow {
  SpaceKey key;
  std::string_view name;
  std::string_view title;
  ir::Lifetime lifetime;
  bool host_visible;
  ir::Direction direction;
};
constexpr MemoryRow kMemoryRows[] = {
    {SpaceKey::kI, "I", "inputs of the machine and signals of the NC", ir::Lifetime::kVolatile, true,
     ir::Direction::kInput},
    {SpaceKey::kO, "O", "outputs of the machine and signals to the NC", ir::Lifetime::kVolatile, true,
     ir::Direction::kOutput},
    {SpaceKey::kF, "F", "flags", ir::Lifetime::kVolatile, true, ir::Direction::kInternal},
    {SpaceKey::kDBefore, "D", "data", ir::Lifetime::kVolatile, true, ir::Direction::kInternal},
    {SpaceKey::kDKept, "D_kept", "data that survives power-off", ir::Lifetime::kRetentive, true,
     ir::Direction::kInternal},
    {SpaceKey::kDBehind, "D_behind", "data behind the retentive block", ir::Lifetime::kVolatile, true,
     ir::Direction::kInternal},
    {SpaceKey::kLatches, "P", "latches of the direct outputs", ir::Lifetime::kVolatile, true, ir::Direction::kOutput},
    {SpaceKey::kSystem, "system", "times and counts of the scheduler", ir::Lifetime::kVolatile, false,
     ir::Direction::kInternal},
    {SpaceKey::kRegisters, "registers", "status, accumulator, arguments", ir::Lifetime::kRoutine, false,
     ir::Direction::kInternal},
};
/// What the NC writes beside the program (5.1, 8): its signals, or it takes back what the program has set.
enum class NcWrites : uint8_t { kSignals, kValues, kClears };
struct NcRow {
  Space space;
  uint32_t first, last;  // bytes
  NcWrites what;
  uint8_t first_bit = 0, last_bit = 7;  // of the first and the last one
};
constexpr NcRow kNcRows[] = {
    {Space::kF, 200, 212, NcWrites::kSignals},       // M, S, T and E functions
    {Space::kF, 213, 221, NcWrites::kClears},        // messages
    {Space::kF, 252, 255, NcWrites::kSignals},       // soft keys
    {Space::kO, 162, 162, NcWrites::kValues, 0, 1},  // R parameter: done, error
    {Space::kO, 232, 255, NcWrites::kValues},        //
    {Space::kD, 200, 219, NcWrites::kValues},        //
    {Space::kD, 228, 235, NcWrites::kValues},        // path that was travelled
};
constexpr uint32_t kAxes = 9, kFirstAxisWord = 26, kBytesPerAxisWord = 2;
constexpr uint32_t kAxesWithDistance = 4;  // that have a register of the travelled distance
constexpr uint8_t kJogMinus = 6, kJogPlus = 7, kClearDistance = 6;
constexpr uint32_t kPlcAxes = 5, kFirstAxisControl = 106, kBytesPerAxis = 10;  // each two bytes

Space NcSpaceOf(SpaceKey key) {
  switch (key) {
    case SpaceKey::kF:
      return Space::kF;
    case SpaceKey::kO:
      return Space::kO;
    case SpaceKey::kDBefore:
    case SpaceKey::kDKept:
    case SpaceKey::kDBehind:
      return Space::kD;
    case SpaceKey::kI:
    case SpaceKey::kLatches:
    case SpaceKey::kSystem:
    case SpaceKey::kRegisters:
    case SpaceKey::kCount:
      return Space::kNone;
  }
  PLCXX_UNREACHABLE();
}

/// Zones of `space`, from whose byte `begin` on `bytes` are in the IR's one: signals of the NC are inputs; what both
/// write is in a second zone, see execute::ControlWrite.
std::vector<ir::Zone> ZonesOf(Space space, uint32_t begin, uint32_t bytes, ir::Direction direction) {
  std::vector<ir::Zone> zones, shared;
  uint32_t next = 0;
  const auto add = [&](const NcRow& row) {
    const uint32_t from = std::max(row.first, begin) - begin;
    const uint32_t to = std::min(std::max(row.last + 1, begin) - begin, bytes);
    if (row.space != space || from >= to) return;
    if (row.what != NcWrites::kSignals) {
      const bool clears = row.what == NcWrites::kClears;
      shared.push_back({.begin = 8 * from + row.first_bit,
                        .end = 8 * (to - 1) + row.last_bit + 1,
                        .direction = clears ? ir::Direction::kInternal : ir::Direction::kInput});
      return;
    }
    if (next < from) zones.push_back(ir::ZoneOfBytes(next, from, direction));
    zones.push_back(ir::ZoneOfBytes(from, to, ir::Direction::kInput));
    next = to;
  };
  for (const NcRow& row : kNcRows) add(row);
  for (uint32_t axis = 0; axis < kAxes; ++axis) {
    // While a PLC axis is homed the NC uses the jog bits itself (8.7); parameters say which axis it is.
    const uint32_t word = kFirstAxisWord + kBytesPerAxisWord * axis, jog = word + 1;
    add({Space::kO, jog, jog, NcWrites::kValues, kJogMinus, kJogPlus});
    if (axis < kAxesWithDistance) add({Space::kO, word, word, NcWrites::kClears, kClearDistance, kClearDistance});
  }
  for (uint32_t axis = 0; axis < kPlcAxes; ++axis) {
    const uint32_t control = kFirstAxisControl + kBytesPerAxis * axis;
    add({Space::kO, control, control + 1, NcWrites::kClears});
  }
  if (next < bytes) zones.push_back(ir::ZoneOfBytes(next, bytes, direction));
  zones.insert(zones.end(), shared.begin(), shared.end());
  return zones;
}

constexpr uint32_t kSystemBytes = 32, kRegisterBytes = 64;
constexpr uint32_t kSystemSignals = 20;  // I 20
constexpr uint8_t kSystemSignalsOn = 2;  // I 20.1 is 1, already in PM 0

std::string Spelled(Space space, uint32_t address, ir::Type type, uint8_t bit, std::string_view blank,
                    std::string_view dot) {
  std::string text(Name(space));
  switch (type) {
    case ir::Type::kBit:
      return text + std::string(blank) + std::to_string(address) + std::string(dot) + std::to_string(bit);
    case ir::Type::kI8:
      text += 'B';
      break;
    case ir::Type::kI16:
      text += 'W';
      break;
    case ir::Type::kNone:
    case ir::Type::kI32:
    case ir::Type::kI64:
    case ir::Type::kF32:
    case ir::Type::kF64:
      text += 'D';
      break;
  }
  return text + std::string(blank) + std::to_string(address);
}

}  // namespace

std::string AddressText(Space space, uint32_t address, ir::Type type, uint8_t bit) {
  return Spelled(space, address, type, bit, " ", ".");
}

std::string NameText(Space space, uint32_t address, ir::Type type, uint8_t bit) {
  return Spelled(space, address, type, bit, "", "_");
}

Memory::Memory(ir::Program& program, uint32_t first_retentive, uint32_t last_retentive) {
  const uint32_t data = BytesOf(Space::kD);
  parts_[0] = {{}, 0, first_retentive};
  parts_[1] = {{}, first_retentive, last_retentive + 1 - first_retentive};
  parts_[2] = {{}, last_retentive + 1, data - last_retentive - 1};
  for (const MemoryRow& row : kMemoryRows) {
    ir::Space space{.name = std::string(row.name),
                    .title = std::string(row.title),
                    .bytes = 0,
                    .lifetime = row.lifetime,
                    .host_visible = row.host_visible};
    switch (row.key) {
      case SpaceKey::kI:
        space.initial = {{.offset = kSystemSignals, .value = kSystemSignalsOn}};
        space.bytes = BytesOf(Space::kI);
        break;
      case SpaceKey::kO:
        space.bytes = BytesOf(Space::kO);
        break;
      case SpaceKey::kF:
        space.bytes = BytesOf(Space::kF);
        break;
      case SpaceKey::kDBefore:
      case SpaceKey::kDKept:
      case SpaceKey::kDBehind:
        space.bytes = parts_[static_cast<size_t>(row.key) - static_cast<size_t>(SpaceKey::kDBefore)].bytes;
        break;
      case SpaceKey::kLatches:
        space.bytes = kMostOutputBytes;
        break;
      case SpaceKey::kSystem:
        space.bytes = kSystemBytes;
        break;
      case SpaceKey::kRegisters:
        space.bytes = kRegisterBytes;
        break;
      case SpaceKey::kCount:
        PLCXX_UNREACHABLE();
    }
    if (space.bytes == 0) continue;
    if (row.host_visible) {
      const uint32_t first = row.key == SpaceKey::kDKept     ? first_retentive
                             : row.key == SpaceKey::kDBehind ? last_retentive + 1
                                                             : 0;
      space.zones = ZonesOf(NcSpaceOf(row.key), first, space.bytes, row.direction);
      if (NcSpaceOf(row.key) == Space::kD) {
        space.part_of = "D";
        space.part_begin = first;
      }
    }
    spaces_[static_cast<size_t>(row.key)] = program.spaces.Add(std::move(space));
  }
  for (size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].space = spaces_[static_cast<size_t>(SpaceKey::kDBefore) + i];
  }
}

Memory::Memory(const ir::Program& program) {
  for (const MemoryRow& row : kMemoryRows) {
    for (uint32_t i = 0; i < program.spaces.size(); ++i) {
      if (program.spaces[ir::SpaceId(i)].name == row.name) spaces_[static_cast<size_t>(row.key)] = ir::SpaceId(i);
    }
  }
  uint32_t first = 0;
  for (size_t i = 0; i < parts_.size(); ++i) {
    const ir::SpaceId space = spaces_[static_cast<size_t>(SpaceKey::kDBefore) + i];
    parts_[i] = {space, first, space.valid() ? program.spaces[space].bytes : 0};
    first += parts_[i].bytes;
  }
}

std::array<Memory::Part, 3> Memory::DataParts() const { return parts_; }

Cell Memory::At(Space space, uint32_t address) const {
  PLCXX_CHECK(address < BytesOf(space));
  switch (space) {
    case Space::kI:
      return {(*this)[SpaceKey::kI], address, BytesOf(space) - address};
    case Space::kO:
      return {(*this)[SpaceKey::kO], address, BytesOf(space) - address};
    case Space::kF:
      return {(*this)[SpaceKey::kF], address, BytesOf(space) - address};
    case Space::kD:
      for (const Part& part : parts_) {
        if (address < part.first + part.bytes) {
          return {part.space, address - part.first, part.first + part.bytes - address};
        }
      }
      break;
    case Space::kP:
    case Space::kNone:
      break;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::prostep
