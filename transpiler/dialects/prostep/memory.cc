#include "transpiler/dialects/prostep/memory.h"

#include <string_view>

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
    if (row.host_visible) space.zones = {{.begin = 0, .end = space.bytes, .direction = row.direction}};
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
