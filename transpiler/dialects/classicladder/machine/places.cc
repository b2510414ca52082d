#include "transpiler/dialects/classicladder/machine/places.h"

#include <utility>

#include "transpiler/ir/zones.h"
#include "transpiler/support/check.h"

namespace plcxx::classicladder {
namespace {

constexpr Group kGroups[] = {Group::kBits,        Group::kWords,    Group::kFloats,   Group::kTimers,
                             Group::kMonostables, Group::kCounters, Group::kTimersIec};
constexpr uint32_t kSpaces = std::size(kGroups);

struct FieldRow {
  Group group;
  Part part;
  uint32_t offset;
};
constexpr FieldRow kFields[] = {
    {Group::kTimers, Part::kPreset, 0},        {Group::kTimers, Part::kValue, 4},
    {Group::kTimers, Part::kDone, 12},         {Group::kTimers, Part::kRunning, 13},
    {Group::kMonostables, Part::kPreset, 0},   {Group::kMonostables, Part::kValue, 4},
    {Group::kMonostables, Part::kRunning, 13}, {Group::kCounters, Part::kPreset, 0},
    {Group::kCounters, Part::kValue, 4},       {Group::kCounters, Part::kDone, 14},
    {Group::kCounters, Part::kEmpty, 15},      {Group::kCounters, Part::kFull, 16},
    {Group::kTimersIec, Part::kPreset, 0},     {Group::kTimersIec, Part::kValue, 4},
    {Group::kTimersIec, Part::kDone, 13},
};
struct HiddenRow {
  Group group;
  Hidden part;
  uint32_t offset;
  ir::Type type;
};
constexpr HiddenRow kHidden[] = {
    {Group::kTimers, Hidden::kBase, 8, ir::Type::kI32},
    {Group::kMonostables, Hidden::kBase, 8, ir::Type::kI32},
    {Group::kMonostables, Hidden::kInputWas, 12, ir::Type::kBit},
    {Group::kCounters, Hidden::kBefore, 8, ir::Type::kI32},
    {Group::kCounters, Hidden::kUpWas, 12, ir::Type::kBit},
    {Group::kCounters, Hidden::kDownWas, 13, ir::Type::kBit},
    {Group::kTimersIec, Hidden::kPartMs, 8, ir::Type::kI32},
    {Group::kTimersIec, Hidden::kInputWas, 12, ir::Type::kBit},
    {Group::kTimersIec, Hidden::kStarted, 14, ir::Type::kBit},
};

constexpr uint32_t kStepBytes = 8;

ir::Place At(ir::SpaceId space, uint32_t offset, ir::Type type) {
  ir::Place place{.type = type, .space = space, .offset = offset};
  if (type == ir::Type::kBit) place.bit = 0;
  return place;
}

std::pair<std::string_view, std::string_view> NameAndTitle(Group group) {
  switch (group) {
    case Group::kBits:
      return {"bits", "bits: %B, inputs %I, outputs %Q, %S, %X and %E, a byte each"};
    case Group::kWords:
      return {"words", "words of 32 bits: %W, inputs %IW, outputs %QW, %SW and the times of %X"};
    case Group::kFloats:
      return {"floats", "floats as whole numbers: inputs %IF, outputs %QF"};
    case Group::kTimers:
      return {"timers", "timers %T"};
    case Group::kMonostables:
      return {"monostables", "monostables %M"};
    case Group::kCounters:
      return {"counters", "counters %C"};
    case Group::kTimersIec:
      return {"timers_iec", "IEC timers %TM"};
  }
  PLCXX_UNREACHABLE();
}

/// Several arrays one behind the other, so that most of them stand elsewhere in a program with other sizes.
bool StartsElsewhere(Group group) { return group == Group::kBits || group == Group::kWords || group == Group::kFloats; }

/// Inputs and outputs of the flat arrays.
std::vector<ir::Zone> ZonesOf(Group group, const Sizes& sizes, uint32_t bytes) {
  const bool bits = group == Group::kBits, floats = group == Group::kFloats;
  if (!StartsElsewhere(group)) return {ir::ZoneOfBytes(0, bytes, ir::Direction::kInternal)};
  const VariableKind input = floats ? VariableKind::kFloatInput
                             : bits ? VariableKind::kInput
                                    : VariableKind::kWordInput;
  const VariableKind output = floats ? VariableKind::kFloatOutput
                              : bits ? VariableKind::kOutput
                                     : VariableKind::kWordOutput;
  const uint32_t stride = StrideOf(group);
  const uint32_t inputs = stride * IndexOf({input, 0}, sizes), outputs = stride * IndexOf({output, 0}, sizes);
  const uint32_t end = outputs + stride * CountOf(output, sizes);
  std::vector<ir::Zone> zones;
  if (inputs > 0) zones.push_back(ir::ZoneOfBytes(0, inputs, ir::Direction::kInternal));
  zones.push_back(ir::ZoneOfBytes(inputs, outputs, ir::Direction::kInput));
  zones.push_back(ir::ZoneOfBytes(outputs, end, ir::Direction::kOutput));
  // SizesOf tells the version by this zone.
  const uint32_t system = floats ? 0 : stride * CountOf(VariableKind::kSystem, sizes);
  if (system > 0) zones.push_back(ir::ZoneOfBytes(end, end + system, ir::Direction::kInternal));
  if (end + system < bytes) zones.push_back(ir::ZoneOfBytes(end + system, bytes, ir::Direction::kInternal));
  return zones;
}

}  // namespace

void AddSpaces(ir::Program& program, const Sizes& sizes) {
  for (const Group group : kGroups) {
    const auto [name, title] = NameAndTitle(group);
    const uint32_t bytes = CountOf(group, sizes) * StrideOf(group);
    program.spaces.Add({.name = std::string(name),
                        .title = std::string(title),
                        .bytes = bytes,
                        .host_visible = true,
                        .zones_are_arrays = StartsElsewhere(group),
                        .zones = ZonesOf(group, sizes, bytes),
                        .initial = {}});
  }
  program.spaces.Add({.name = "steps",
                      .title = "steps of sequential pages",
                      .bytes = kSteps * kStepBytes,
                      .zones = {},
                      .initial = {}});
  program.spaces.Add({.name = "system", .title = "memory of the scheduler", .zones = {}, .initial = {}});
  program.spaces.Add(
      {.name = "routine", .title = "locals", .lifetime = ir::Lifetime::kRoutine, .zones = {}, .initial = {}});
}

Sizes SizesOf(const ir::Program& program) {
  Sizes sizes;
  const auto count = [&](Group group) { return program.spaces[SpaceOf(group)].bytes / StrideOf(group); };
  const auto zone = [&](Group group, ir::Direction direction) {
    for (const ir::Zone& each : program.spaces[SpaceOf(group)].zones) {
      if (each.direction == direction) return (each.end - each.begin) / 8 / StrideOf(group);
    }
    return uint32_t{0};
  };
  sizes.inputs = zone(Group::kBits, ir::Direction::kInput);
  sizes.outputs = zone(Group::kBits, ir::Direction::kOutput);
  const auto& bits = program.spaces[SpaceOf(Group::kBits)].zones;
  if (bits.size() > 1 && bits[bits.size() - 2].direction == ir::Direction::kInternal) sizes.version = LinuxCnc::kTwoTen;
  sizes.bits = count(Group::kBits) - sizes.inputs - sizes.outputs - kSteps - kErrorBits;
  sizes.words = count(Group::kWords) - kSteps;
  sizes.word_inputs = zone(Group::kWords, ir::Direction::kInput);
  sizes.word_outputs = zone(Group::kWords, ir::Direction::kOutput);
  sizes.float_inputs = zone(Group::kFloats, ir::Direction::kInput);
  sizes.float_outputs = zone(Group::kFloats, ir::Direction::kOutput);
  sizes.timers = count(Group::kTimers);
  sizes.monostables = count(Group::kMonostables);
  sizes.counters = count(Group::kCounters);
  sizes.timers_iec = count(Group::kTimersIec);
  return sizes;
}

ir::SpaceId SpaceOf(Group group) { return ir::SpaceId(static_cast<uint32_t>(group)); }
ir::SpaceId StepSpace() { return ir::SpaceId(kSpaces); }
ir::SpaceId SystemSpace() { return ir::SpaceId(kSpaces + 1); }
ir::SpaceId RoutineSpace() { return ir::SpaceId(kSpaces + 2); }

uint32_t StrideOf(Group group) {
  constexpr uint32_t kTimerBytes = 16, kCounterBytes = 20;
  switch (group) {
    case Group::kBits:
      return 1;
    case Group::kWords:
    case Group::kFloats:
      return 4;
    case Group::kTimers:
    case Group::kMonostables:
    case Group::kTimersIec:
      return kTimerBytes;
    case Group::kCounters:
      return kCounterBytes;
  }
  PLCXX_UNREACHABLE();
}

ir::Place PlaceAt(Group group, Part part, uint32_t index) {
  const uint32_t begin = index * StrideOf(group);
  if (group == Group::kBits) return At(SpaceOf(group), begin, ir::Type::kBit);
  if (group == Group::kWords || group == Group::kFloats) return At(SpaceOf(group), begin, ir::Type::kI32);
  for (const FieldRow& row : kFields) {
    if (row.group != group || row.part != part) continue;
    const bool number = part == Part::kPreset || part == Part::kValue;
    return At(SpaceOf(group), begin + row.offset, number ? ir::Type::kI32 : ir::Type::kBit);
  }
  PLCXX_UNREACHABLE();
}

ir::Place HiddenPlace(Group group, Hidden part, uint32_t index) {
  for (const HiddenRow& row : kHidden) {
    if (row.group == group && row.part == part) {
      return At(SpaceOf(group), index * StrideOf(group) + row.offset, row.type);
    }
  }
  PLCXX_UNREACHABLE();
}

ir::Place StepActive(uint32_t step) { return At(StepSpace(), step * kStepBytes + 4, ir::Type::kBit); }
ir::Place StepMs(uint32_t step) { return At(StepSpace(), step * kStepBytes, ir::Type::kI32); }

}  // namespace plcxx::classicladder
