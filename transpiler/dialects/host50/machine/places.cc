#include "transpiler/dialects/host50/machine/places.h"

#include <algorithm>
#include <array>

#include "transpiler/dialects/host50/machine/addresses.h"
#include "transpiler/ir/zones.h"
#include "transpiler/support/check.h"

namespace plcxx::host50 {
namespace {

constexpr uint32_t kMemoryAreas = static_cast<uint32_t>(Area::kTm);
constexpr uint32_t kNoSpace = 0xFFFFFFFF;

struct SpaceNumbers {
  std::array<uint32_t, kMemoryAreas> volatile_part{}, retentive_part{};
  uint32_t system = 0, routine = 0;
};

/// The order of the spaces: the areas, the retentive parts, the rest.
constexpr SpaceNumbers kSpaces = [] {
  constexpr int32_t kRetentiveLast[] = {
#define HOST50_AREA(Name, Spelling, Type, Writer, Resource, Common, First, Last, Step, Kept) Kept,
#include "transpiler/dialects/host50/machine/machine.def"
  };
  SpaceNumbers numbers;
  uint32_t next = 0;
  for (uint32_t i = 0; i < kMemoryAreas; ++i) numbers.volatile_part[i] = next++;
  for (uint32_t i = 0; i < kMemoryAreas; ++i) numbers.retentive_part[i] = kRetentiveLast[i] >= 0 ? next++ : kNoSpace;
  numbers.system = next++;
  numbers.routine = next++;
  return numbers;
}();

uint32_t BytesUpTo(const AreaInfo& info, uint32_t last) {
  return info.type == Type::kBit ? last / 8 + 1 : 4 * (last + 1);
}

std::string TitleOf(const AreaInfo& info) {
  std::string title;
  switch (info.type) {
    case Type::kBit:
      title = "bits";
      break;
    case Type::kInteger:
      title = "words of 32 bits";
      break;
    case Type::kFloat:
      title = "floating point numbers";
      break;
    case Type::kUnknown:
    case Type::kTimer:
    case Type::kCounter:
      PLCXX_UNREACHABLE();
  }
  switch (info.writer) {
    case Writer::kHost:
      return "inputs: " + title;
    case Writer::kProgram:
      return info.name.starts_with('Q') ? "outputs: " + title : title;
    case Writer::kBlock:
      PLCXX_UNREACHABLE();
  }
  PLCXX_UNREACHABLE();
}

ir::Direction DirectionOf(const AreaInfo& info) {
  if (info.writer == Writer::kHost) return ir::Direction::kInput;
  return info.name.starts_with('Q') ? ir::Direction::kOutput : ir::Direction::kInternal;
}

ir::Space AreaSpace(Area area, uint32_t last, ir::Lifetime lifetime) {
  const AreaInfo& info = Info(area);
  ir::Space space{.name = std::string(info.name), .title = TitleOf(info), .bytes = BytesUpTo(info, last)};
  space.lifetime = lifetime;
  space.host_visible = true;
  if (lifetime == ir::Lifetime::kRetentive) {
    space.title += ", 0 to " + std::to_string(last) + ", retentive";
    space.name += "_retentive";
  }
  space.zones.push_back(ir::ZoneOfBytes(0, space.bytes, DirectionOf(info)));
  return space;
}

struct FieldRow {
  Area area;
  Attribute attribute;
  ir::StateKind kind;
  std::string_view field;
};
constexpr FieldRow kFields[] = {
    {Area::kTm, Attribute::kQ, ir::StateKind::kUnitTimer, "output"},
    {Area::kTm, Attribute::kV, ir::StateKind::kUnitTimer, "value"},
    {Area::kTm, Attribute::kP, ir::StateKind::kUnitTimer, "preset"},
    {Area::kC, Attribute::kQ, ir::StateKind::kPositionCounter, "output"},
    {Area::kC, Attribute::kV, ir::StateKind::kPositionCounter, "value"},
    {Area::kC, Attribute::kP, ir::StateKind::kPositionCounter, "preset"},
};

}  // namespace

void AddSpaces(ir::Program& program, uint32_t channels) {
  for (uint32_t i = 0; i < kMemoryAreas; ++i) {
    const auto area = static_cast<Area>(i);
    program.spaces.Add(AreaSpace(area, LastNumber(area, channels), ir::Lifetime::kVolatile));
  }
  for (uint32_t i = 0; i < kMemoryAreas; ++i) {
    const auto area = static_cast<Area>(i);
    const int32_t last = Info(area).retentive_last;
    if (last >= 0) program.spaces.Add(AreaSpace(area, static_cast<uint32_t>(last), ir::Lifetime::kRetentive));
  }
  program.spaces.Add({.name = "system", .title = "of the scheduler"});
  program.spaces.Add({.name = "routine", .title = "arguments and locals", .lifetime = ir::Lifetime::kRoutine});
  PLCXX_CHECK(program.spaces.size() == kSpaces.routine + 1);
}

uint32_t ChannelsOf(const ir::Program& program) {
  const uint32_t bytes = program.spaces[ir::SpaceId(kSpaces.volatile_part[static_cast<size_t>(Area::kI)])].bytes;
  uint32_t channels = 1;
  while (channels < kMostChannels && BytesUpTo(Info(Area::kI), LastNumber(Area::kI, channels)) < bytes) ++channels;
  return channels;
}

ir::SpaceId SpaceOf(const Address& address) {
  const auto area = static_cast<size_t>(address.area);
  PLCXX_CHECK(area < kMemoryAreas);
  return ir::SpaceId(IsRetentive(address) ? kSpaces.retentive_part[area] : kSpaces.volatile_part[area]);
}

ir::SpaceId SystemSpace() { return ir::SpaceId(kSpaces.system); }
ir::SpaceId RoutineSpace() { return ir::SpaceId(kSpaces.routine); }

ir::Place MemoryPlace(const Address& address) {
  ir::Place place{.space = SpaceOf(address)};
  const Type type = Info(address.area).type;
  if (type == Type::kBit) {
    place.type = ir::Type::kBit;
    place.offset = address.number / 8;
    place.bit = static_cast<uint8_t>(address.number % 8);
  } else {
    place.type = type == Type::kFloat ? ir::Type::kF32 : ir::Type::kI32;
    place.offset = 4 * address.number;
  }
  return place;
}

std::optional<InstanceField> FieldOf(const Address& address) {
  const Attribute attribute = address.attribute == Attribute::kNone ? Attribute::kQ : address.attribute;
  for (const FieldRow& row : kFields) {
    if (row.area != address.area || row.attribute != attribute) continue;
    return InstanceField{.kind = row.kind,
                         .type = attribute == Attribute::kQ ? ir::Type::kBit : ir::Type::kI32,
                         .field = ir::FieldIndex(row.kind, row.field)};
  }
  return std::nullopt;
}

std::string NameOf(const Address& address) { return ToText(address).substr(1); }

bool IsAscii(std::string_view symbol) {
  return std::ranges::all_of(symbol, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::string NameInCode(std::string_view symbol, const Address& address, uint32_t channels) {
  std::string own = NameOf(address);
  if (symbol.empty() || !IsAscii(symbol)) return own;
  const AddressText read = ReadAddressText("%" + std::string(symbol), channels);
  const bool another = read.fault == AddressFault::kNone && NameOf(read.address) != own;
  return another ? own : std::string(symbol);
}

Address WithoutAttribute(Address address) {
  address.attribute = Attribute::kNone;
  return address;
}

}  // namespace plcxx::host50
