#include "transpiler/dialects/nc110/machine/machine.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include "transpiler/ir/zones.h"

namespace plcxx::nc110 {
namespace {

struct PackageRow {
  Package package;
  std::string_view name;
  std::string_view title;
  uint32_t connectors;
  ir::Lifetime lifetime;
};
constexpr PackageRow kPackages[] = {
#define NC110_PACKAGE(Letter, Title, Connectors, Life) \
  {Package::k##Letter, #Letter, Title, Connectors, ir::Lifetime::Life},
#include "transpiler/dialects/nc110/machine/machine.def"
};

struct ZoneRow {
  Package package;
  uint32_t first, last;
  ir::Direction direction;
};
constexpr ZoneRow kZones[] = {
#define NC110_ZONE(Letter, First, Last, Dir) {Package::k##Letter, First, Last, ir::Direction::Dir},
#include "transpiler/dialects/nc110/machine/machine.def"
};
constexpr ZoneRow kProcessZones[] = {
#define NC110_PROCESS_ZONE(Letter, First, Last, Dir) {Package::k##Letter, First, Last, ir::Direction::Dir},
#include "transpiler/dialects/nc110/machine/machine.def"
};

struct SharedRow {
  Package package;
  uint32_t connector, first, last;  // bits
  ir::Direction write;
};
constexpr SharedRow kShared[] = {
#define NC110_SHARED(Letter, Connector, First, Last, Write) \
  {Package::k##Letter, Connector, First, Last, ir::Direction::Write},
#include "transpiler/dialects/nc110/machine/machine.def"
};
constexpr SharedRow kProcessShared[] = {
#define NC110_PROCESS_SHARED(Letter, Connector, First, Last, Write) \
  {Package::k##Letter, Connector, First, Last, ir::Direction::Write},
#include "transpiler/dialects/nc110/machine/machine.def"
};

struct TimerRow {
  uint32_t first, last;
  TimerBase base;
};
constexpr TimerRow kTimers[] = {
#define NC110_TIMERS(First, Last, UnitMs, Ticks) {First, Last, {UnitMs, Ticks}},
#include "transpiler/dialects/nc110/machine/machine.def"
};

struct BitRow {
  uint32_t connector, bit;
};
constexpr BitRow kAcknowledgements[] = {
#define NC110_ACKNOWLEDGEMENT(Connector, Bit) {Connector, Bit},
#include "transpiler/dialects/nc110/machine/machine.def"
};

uint32_t RowOf(Package package) {
  for (uint32_t i = 0; i < std::size(kPackages); ++i) {
    if (kPackages[i].package == package) return i;
  }
  PLCXX_UNREACHABLE();
}

constexpr uint32_t TotalBytes() {
  uint32_t bytes = 0;
  for (const PackageRow& row : kPackages) bytes += row.connectors * kBytesPerConnector;
  return bytes;
}
static_assert(TotalBytes() == kAllPackageBytes);

bool IsShared(Package package) { return package == Package::kK || package == Package::kN; }

/// The connector as process 1 has it; none outside the processes' connectors.
std::optional<uint32_t> InProcess1(Package package, uint32_t connector, uint32_t processes) {
  if (!IsShared(package) || connector >= kProcessConnectors * processes) return std::nullopt;
  return connector % kProcessConnectors;
}

void AddZone(ir::Space& space, const ZoneRow& zone, uint32_t shift) {
  space.zones.push_back(ir::ZoneOfBytes((zone.first + shift) * kBytesPerConnector,
                                        (zone.last + shift + 1) * kBytesPerConnector, zone.direction));
}

/// A second zone, see execute::ControlWrite.
void AddShared(ir::Space& space, const SharedRow& row, uint32_t shift) {
  const uint32_t connector = 8 * kBytesPerConnector * (row.connector + shift);
  space.zones.push_back({.begin = connector + row.first, .end = connector + row.last + 1, .direction = row.write});
}

/// What the control writes beside the program (option `extern`). Where the manual says nobody's, it stays internal.
void AddExternal(ir::Space& space, const Operand& operand) {
  const bool is_word = operand.kind == OperandKind::kWord;
  const uint32_t byte = ByteOf(operand);
  const uint32_t begin = is_word ? 8 * byte : 8 * kBytesPerConnector * operand.number + operand.index;
  uint8_t known = 0;  // bits of the byte that are in a zone
  for (const ir::Zone& zone : space.zones) known = static_cast<uint8_t>(known | ir::BitsOfZone(zone, byte));
  ir::Zone zone{.begin = begin, .end = begin + (is_word ? 8 : 1), .direction = ir::Direction::kInternal};
  if ((BitsOf(operand) & ~known) != 0) space.zones.push_back(zone);
  zone.direction = ir::Direction::kInput;
  space.zones.push_back(zone);
}

}  // namespace

ir::SpaceId SpaceOf(Package package) { return ir::SpaceId(RowOf(package)); }
ir::SpaceId SpaceOf(SpaceIndex space) { return ir::SpaceId(static_cast<uint32_t>(space)); }

uint32_t Bytes(Package package) { return kPackages[RowOf(package)].connectors * kBytesPerConnector; }

uint32_t PackageBase(Package package) {
  uint32_t base = 0;
  for (uint32_t i = 0; i < RowOf(package); ++i) base += kPackages[i].connectors * kBytesPerConnector;
  return base;
}

bool IsMemory(const Operand& operand) {
  return operand.kind == OperandKind::kInput || operand.kind == OperandKind::kOutput ||
         operand.kind == OperandKind::kWord;
}

uint32_t ByteOf(const Operand& operand) {
  const uint32_t byte = operand.kind == OperandKind::kWord ? operand.index : operand.index / 8u;
  return operand.number * kBytesPerConnector + byte;
}

uint8_t BitsOf(const Operand& operand) {
  return operand.kind == OperandKind::kWord ? uint8_t{0xFF} : static_cast<uint8_t>(1u << (operand.index % 8u));
}

ir::Direction DirectionOf(Package package, uint32_t connector, uint32_t processes) {
  for (const ZoneRow& zone : kZones) {
    if (zone.package == package && zone.first <= connector && connector <= zone.last) return zone.direction;
  }
  if (const auto own = InProcess1(package, connector, processes)) {
    for (const ZoneRow& zone : kProcessZones) {
      if (zone.package == package && zone.first <= *own && *own <= zone.last) return zone.direction;
    }
  }
  return ir::Direction::kInternal;
}

bool InBasePart(Package package, uint32_t connector, uint32_t processes) {
  return DirectionOf(package, connector, processes) != ir::Direction::kInternal;
}

bool IsAcknowledgement(const Operand& operand) {
  if (operand.kind != OperandKind::kOutput || operand.package != Package::kK) return false;
  const uint32_t connector = operand.number % kProcessConnectors;
  return std::any_of(std::begin(kAcknowledgements), std::end(kAcknowledgements),
                     [&](const BitRow& row) { return row.connector == connector && row.bit == operand.index; });
}

TimerBase BaseOfTimer(uint32_t number) {
  for (const TimerRow& row : kTimers) {
    if (row.first <= number && number <= row.last) return row.base;
  }
  PLCXX_UNREACHABLE();
}

void AddSpaces(ir::Program& program, uint32_t processes, const std::optional<uint8_t> (&t_initial)[kRetainedBytes],
               std::span<const Operand> external) {
  for (const PackageRow& row : kPackages) {
    ir::Space space{.name = std::string(row.name),
                    .title = std::string(row.title),
                    .bytes = row.connectors * kBytesPerConnector,
                    .lifetime = row.lifetime,
                    .host_visible = true};
    for (uint32_t process = 0; process < processes; ++process) {
      for (const ZoneRow& zone : kProcessZones) {
        if (zone.package == row.package) AddZone(space, zone, process * kProcessConnectors);
      }
    }
    for (const ZoneRow& zone : kZones) {
      if (zone.package == row.package) AddZone(space, zone, 0);
    }
    for (uint32_t process = 0; process < processes; ++process) {
      for (const SharedRow& shared : kProcessShared) {
        if (shared.package == row.package) AddShared(space, shared, process * kProcessConnectors);
      }
    }
    for (const SharedRow& shared : kShared) {
      if (shared.package == row.package) AddShared(space, shared, 0);
    }
    for (const Operand& operand : external) {
      if (IsMemory(operand) && operand.package == row.package) AddExternal(space, operand);
    }
    if (row.lifetime == ir::Lifetime::kRetentive) {
      for (uint32_t i = 0; i < kRetainedBytes; ++i) {
        if (t_initial[i].value_or(0) != 0) space.initial.push_back({.offset = i, .value = *t_initial[i]});
      }
    }
    program.spaces.Add(std::move(space));
  }
  program.spaces.Add({.name = "system", .title = "counts and times of the scheduler", .bytes = 32});
  program.spaces.Add({.name = "arguments", .title = "parameters", .bytes = 4, .lifetime = ir::Lifetime::kRoutine});
  program.spaces.Add({.name = "latched", .title = "inputs as the slow part sees them", .bytes = kAllPackageBytes});
}

}  // namespace plcxx::nc110
