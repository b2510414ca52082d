#include "transpiler/dialects/classicladder/machine/machine.h"

#include <algorithm>
#include <charconv>

#include "transpiler/support/check.h"

namespace plcxx::classicladder {
namespace {

constexpr ElementInfo kElements[] = {
#define CLASSICLADDER_ELEMENT(Kind, Number, Drawn, Left, Below) \
  {ElementKind::k##Kind, Number, #Kind, Drawn, Left, Below},
#include "transpiler/dialects/classicladder/machine/machine.def"
};

constexpr VariableInfo kVariables[] = {
#define CLASSICLADDER_VARIABLE(Kind, Number, Name, Attribute, OfGroup, OfPart, How, Meaning) \
  {VariableKind::k##Kind, Number, Name, Attribute, Group::k##OfGroup, Part::k##OfPart, Access::How, Meaning},
#include "transpiler/dialects/classicladder/machine/machine.def"
};

constexpr SizeInfo kSizes[] = {
#define CLASSICLADDER_SIZE(Member, Parameter, Line, Default, Meaning) {Parameter, Line, Meaning, &Sizes::Member},
#include "transpiler/dialects/classicladder/machine/machine.def"
};

struct PartRow {
  std::string_view name;
  PartKind kind;
};
constexpr PartRow kParts[] = {
#define CLASSICLADDER_PART(Name, Kind) {Name, PartKind::k##Kind},
#include "transpiler/dialects/classicladder/machine/machine.def"
};

uint32_t SystemVariables(const Sizes& sizes) { return sizes.version == LinuxCnc::kTwoNine ? 0 : kSystemVariables; }

/// Where a kind begins in the flat array of its group; 0 where its group has records.
uint32_t BaseOf(VariableKind kind, const Sizes& sizes) {
  const VariableInfo& info = Info(kind);
  if (info.group != Group::kBits && info.group != Group::kWords && info.group != Group::kFloats) return 0;
  const bool bits = info.group == Group::kBits, floats = info.group == Group::kFloats;
  const uint32_t memory = floats ? 0 : bits ? sizes.bits : sizes.words;
  const uint32_t inputs = floats ? sizes.float_inputs : bits ? sizes.inputs : sizes.word_inputs;
  const uint32_t outputs = floats ? sizes.float_outputs : bits ? sizes.outputs : sizes.word_outputs;
  switch (info.part) {
    case Part::kB:
      return 0;
    case Part::kI:
      return memory;
    case Part::kQ:
      return memory + inputs;
    case Part::kS:
      return memory + inputs + outputs;
    case Part::kX:
      return memory + inputs + outputs + SystemVariables(sizes);
    case Part::kE:
      return memory + inputs + outputs + kSteps;  // 2.10 forgets its system bits here: X108 is E0
    case Part::kPreset:
    case Part::kValue:
    case Part::kDone:
    case Part::kRunning:
    case Part::kEmpty:
    case Part::kFull:
      break;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace

const ElementInfo& Info(ElementKind kind) { return kElements[static_cast<size_t>(kind)]; }

std::optional<ElementKind> ElementByNumber(uint32_t number) {
  for (const ElementInfo& info : kElements) {
    if (info.number == number) return info.kind;
  }
  return std::nullopt;
}

bool UsesVariable(ElementKind kind) {
  switch (kind) {
    case ElementKind::kContact:
    case ElementKind::kContactNot:
    case ElementKind::kRising:
    case ElementKind::kFalling:
    case ElementKind::kCoil:
    case ElementKind::kCoilNot:
    case ElementKind::kSet:
    case ElementKind::kReset:
      return true;
    case ElementKind::kFree:
    case ElementKind::kWire:
    case ElementKind::kTimer:
    case ElementKind::kMonostable:
    case ElementKind::kCounter:
    case ElementKind::kTimerIec:
    case ElementKind::kCompare:
    case ElementKind::kJump:
    case ElementKind::kCall:
    case ElementKind::kOperate:
    case ElementKind::kPart:
      return false;
  }
  PLCXX_UNREACHABLE();
}

bool UsesNumber(ElementKind kind) {
  return !UsesVariable(kind) && kind != ElementKind::kFree && kind != ElementKind::kWire && kind != ElementKind::kPart;
}

const VariableInfo& Info(VariableKind kind) { return kVariables[static_cast<size_t>(kind)]; }
std::span<const VariableInfo> Variables() { return kVariables; }

std::optional<VariableKind> VariableByNumber(uint32_t number, LinuxCnc version) {
  if (version == LinuxCnc::kTwoNine) {
    const uint32_t error_bits = Info(VariableKind::kSystem).number;  // a system bit of 2.10
    if (number == error_bits) return VariableKind::kError;
    if (number == Info(VariableKind::kError).number || number == Info(VariableKind::kWordSystem).number)
      return std::nullopt;
  }
  for (const VariableInfo& info : kVariables) {
    if (info.number == number) return info.kind;
  }
  return std::nullopt;
}

bool IsBit(VariableKind kind) {
  constexpr uint32_t kFirstWord = 200;  // as the engine tells them apart
  return Info(kind).number < kFirstWord;
}

std::span<const SizeInfo> SizeInfos() { return kSizes; }

std::string NameOf(const Address& address) {
  const VariableInfo& info = Info(address.kind);
  std::string name = std::string(info.name) + std::to_string(address.number);
  if (!info.attribute.empty()) name += "." + std::string(info.attribute);
  return name;
}

std::optional<Address> AddressByName(std::string_view text) {
  if (text.starts_with('%')) text.remove_prefix(1);
  const size_t letters = std::min(text.find_first_of("0123456789"), text.size());
  const size_t point = std::min(text.find('.'), text.size());
  const std::string_view digits = text.substr(letters, point > letters ? point - letters : 0);
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  const std::string_view attribute = point < text.size() ? text.substr(point + 1) : std::string_view();
  if (point < text.size() && attribute.empty()) return std::nullopt;
  for (const VariableInfo& info : kVariables) {
    if (info.name == text.substr(0, letters) && info.attribute == attribute) return Address{info.kind, number};
  }
  return std::nullopt;
}

uint32_t CountOf(Group group, const Sizes& sizes) {
  switch (group) {
    case Group::kBits:
      return sizes.bits + sizes.inputs + sizes.outputs + kSteps + kErrorBits;
    case Group::kWords:
      return sizes.words + kSteps;  // after it the engine keeps its floats
    case Group::kFloats:
      return sizes.float_inputs + sizes.float_outputs;
    case Group::kTimers:
      return sizes.timers;
    case Group::kMonostables:
      return sizes.monostables;
    case Group::kCounters:
      return sizes.counters;
    case Group::kTimersIec:
      return sizes.timers_iec;
  }
  PLCXX_UNREACHABLE();
}

uint32_t CountOf(VariableKind kind, const Sizes& sizes) {
  const VariableInfo& info = Info(kind);
  const bool bits = info.group == Group::kBits, floats = info.group == Group::kFloats;
  switch (info.part) {
    case Part::kB:
      return bits ? sizes.bits : sizes.words;
    case Part::kI:
      return floats ? sizes.float_inputs : bits ? sizes.inputs : sizes.word_inputs;
    case Part::kQ:
      return floats ? sizes.float_outputs : bits ? sizes.outputs : sizes.word_outputs;
    case Part::kS:
      return SystemVariables(sizes);
    case Part::kX:
      return kSteps;
    case Part::kE:
      return kErrorBits;
    case Part::kPreset:
    case Part::kValue:
    case Part::kDone:
    case Part::kRunning:
    case Part::kEmpty:
    case Part::kFull:
      return CountOf(info.group, sizes);
  }
  PLCXX_UNREACHABLE();
}

uint32_t IndexOf(const Address& address, const Sizes& sizes) { return BaseOf(address.kind, sizes) + address.number; }

std::optional<Address> Resolve(const Address& address, const Sizes& sizes) {
  const Group group = Info(address.kind).group;
  const uint64_t index = uint64_t{BaseOf(address.kind, sizes)} + address.number;
  if (index >= CountOf(group, sizes)) return std::nullopt;
  if (address.number < CountOf(address.kind, sizes)) return address;
  for (const VariableInfo& info : kVariables) {
    const uint32_t base = BaseOf(info.kind, sizes);
    if (info.group == group && index >= base && index - base < CountOf(info.kind, sizes)) {
      return Address{info.kind, static_cast<uint32_t>(index) - base};
    }
  }
  return std::nullopt;
}

PartKind PartByName(std::string_view name, uint32_t& rung) {
  for (const PartRow& row : kParts) {
    if (row.name == name) return row.kind;
  }
  constexpr std::string_view kRungPrefix = "rung_", kRungEnd = ".csv";
  if (name.size() > kRungPrefix.size() + kRungEnd.size() && name.starts_with(kRungPrefix) && name.ends_with(kRungEnd)) {
    const std::string_view digits = name.substr(kRungPrefix.size(), name.size() - kRungPrefix.size() - kRungEnd.size());
    const bool canonical = digits == "0" || digits.front() != '0';
    if (canonical && dialects::Number(digits, 0, 1'000'000, rung)) return PartKind::kRung;
  }
  return PartKind::kIgnored;
}

}  // namespace plcxx::classicladder
