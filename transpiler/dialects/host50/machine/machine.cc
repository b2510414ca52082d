#include "transpiler/dialects/host50/machine/machine.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "transpiler/support/check.h"
#include "transpiler/support/near_words.h"

namespace plcxx::host50 {
namespace {

constexpr AreaInfo kAreas[] = {
#define HOST50_AREA(Id, Spelling, Ty, By, Res, Common, First, Last, Step, Kept) \
  {Spelling, Type::Ty, Writer::By, Resource::Res, Common, First, Last, Step, Kept},
#include "transpiler/dialects/host50/machine/machine.def"
};

struct AreaAlias {
  std::string_view name;
  Area area;
};
constexpr AreaAlias kAreaAliases[] = {
#define HOST50_AREA_ALIAS(Spelling, Id) {Spelling, Area::k##Id},
#include "transpiler/dialects/host50/machine/machine.def"
};

template <class... Roles>
constexpr InstructionInfo Row(std::string_view name, Form form, RungEffect effect, Contact contact, State state,
                              Resource resource, std::string_view pins, Roles... roles) {
  static_assert(sizeof...(Roles) <= kMostOperands);
  return {name, form, effect, contact, state, resource, pins, sizeof...(Roles), {roles...}};
}

constexpr auto kInstructions = [] {
  using enum OperandRole;  // the rest of a row are roles
  return std::array{
#define HOST50_INSTRUCTION(Id, Spelling, How, What, Looks, Keeps, Counts, Pins, ...)         \
  Row(Spelling, Form::How, RungEffect::What, Contact::Looks, State::Keeps, Resource::Counts, \
      Pins __VA_OPT__(, ) __VA_ARGS__),
#include "transpiler/dialects/host50/machine/machine.def"
  };
}();

struct SpellingRow {
  std::string_view name;
  Mnemonic mnemonic;
};
constexpr SpellingRow kSpellings[] = {
#define HOST50_INSTRUCTION(Id, Spelling, ...) {Spelling, {Op::k##Id, {}}},
#define HOST50_SPELLING(Spelling, Id) {Spelling, {Op::k##Id, {}}},
#define HOST50_TIMER_SPELLING(Spelling, Id, Unit) {Spelling, {Op::k##Id, TimerUnit::Unit}},
#include "transpiler/dialects/host50/machine/machine.def"
};

struct UnitRow {
  std::string_view word;
  TimerUnit unit;
};
constexpr UnitRow kUnits[] = {
#define HOST50_UNIT(Word, Unit) {Word, TimerUnit::Unit},
#include "transpiler/dialects/host50/machine/machine.def"
};

struct DrawnSpelling {
  char bracket, prefix;
  Op op;
};
constexpr DrawnSpelling kDrawn[] = {
#define HOST50_DRAWN(Bracket, Prefix, Id) {Bracket, Prefix, Op::k##Id},
#include "transpiler/dialects/host50/machine/machine.def"
};

constexpr AxisBlock kAxisBlocks[] = {
#define HOST50_AXIS_BLOCK(Id, PositionMode, Absolute, Homing, Method, Position, Speed) \
  {Op::k##Id, PositionMode, Absolute, Homing, AxisValue::Method, AxisValue::Position, AxisValue::Speed},
#include "transpiler/dialects/host50/machine/machine.def"
};

constexpr TitleKeyInfo kTitleKeys[] = {
#define HOST50_TITLE_KEY(Id, Word, Characters) {TitleKey::k##Id, Word, Characters},
#include "transpiler/dialects/host50/machine/machine.def"
};

constexpr SeverityInfo kSeverities[] = {
#define HOST50_SEVERITY(Id, Keyword, Prefix) {Severity::k##Id, Keyword, Prefix},
#include "transpiler/dialects/host50/machine/machine.def"
};

struct ResourceRow {
  std::string_view name;
  uint32_t available;
};
constexpr ResourceRow kResources[] = {
#define HOST50_RESOURCE(Id, Title, Most) {Title, Most},
#include "transpiler/dialects/host50/machine/machine.def"
};

constexpr int32_t kHomingMethods[] = {1, 2, 17, 18, 33, 34, 35};

}  // namespace

std::string_view Name(Type type) {
  switch (type) {
    case Type::kUnknown:
      return "unknown";
    case Type::kBit:
      return "bit";
    case Type::kInteger:
      return "integer";
    case Type::kFloat:
      return "float";
    case Type::kTimer:
      return "timer";
    case Type::kCounter:
      return "counter";
  }
  PLCXX_UNREACHABLE();
}

std::string_view Name(Resource resource) { return kResources[static_cast<size_t>(resource)].name; }
uint32_t Available(Resource resource) { return kResources[static_cast<size_t>(resource)].available; }

const AreaInfo& Info(Area area) { return kAreas[static_cast<size_t>(area)]; }

std::optional<Area> AreaByName(std::string_view name) {
  for (size_t i = 0; i < std::size(kAreas); ++i) {
    if (EqualIgnoringCase(kAreas[i].name, name)) return static_cast<Area>(i);
  }
  for (const AreaAlias& alias : kAreaAliases) {
    if (EqualIgnoringCase(alias.name, name)) return alias.area;
  }
  return std::nullopt;
}

bool Exists(Area area, uint32_t number, uint32_t channels) {
  const AreaInfo& info = Info(area);
  if (number <= info.common_last) return true;
  if (info.channel_step == 0) return false;
  for (uint32_t k = 0; k < channels; ++k) {
    const uint32_t shift = info.channel_step * k;
    if (info.channel_first + shift <= number && number <= info.channel_last + shift) return true;
  }
  return false;
}

uint32_t LastNumber(Area area, uint32_t channels) {
  const AreaInfo& info = Info(area);
  return info.channel_step == 0 ? info.common_last : info.channel_last + info.channel_step * (channels - 1);
}

Address InChannel1(Address address) {
  const AreaInfo& info = Info(address.area);
  if (info.channel_step != 0 && address.number > info.common_last) {
    address.number =
        static_cast<uint16_t>(info.channel_first + (address.number - info.channel_first) % info.channel_step);
  }
  return address;
}

bool IsRetentive(const Address& address) { return address.number <= Info(address.area).retentive_last; }

Type TypeOf(const Address& address) {
  switch (address.attribute) {
    case Attribute::kNone:
      return Info(address.area).type;
    case Attribute::kQ:
      return Type::kBit;
    case Attribute::kV:
    case Attribute::kP:
      return Type::kInteger;
  }
  PLCXX_UNREACHABLE();
}

std::string_view Name(OperandRole role) {
  switch (role) {
    case OperandRole::kBit:
      return "a bit";
    case OperandRole::kBitOrConstant:
      return "a bit, 0 or 1";
    case OperandRole::kCoil:
      return "the bit to write";
    case OperandRole::kIntSource:
    case OperandRole::kIntDivisor:
      return "an integer";
    case OperandRole::kFloatSource:
    case OperandRole::kFloatDivisor:
      return "a float";
    case OperandRole::kIntResult:
    case OperandRole::kFloatResult:
    case OperandRole::kNumberResult:
    case OperandRole::kNumberInPlace:
      return "a destination";
    case OperandRole::kNumberSource:
    case OperandRole::kPosition:
      return "a number";
    case OperandRole::kFieldSource:
    case OperandRole::kFieldResult:
      return "the first bit of a field";
    case OperandRole::kBitCount:
      return "a number of bits";
    case OperandRole::kTimer:
      return "a timer";
    case OperandRole::kCounter:
      return "a counter";
    case OperandRole::kUnit:
      return "a unit of time";
    case OperandRole::kSubroutine:
      return "the name of a subroutine";
    case OperandRole::kJumpTarget:
      return "a jump target";
    case OperandRole::kAxisNumber:
      return "the number of an axis";
    case OperandRole::kHomingMethod:
      return "a homing method";
    case OperandRole::kComparison:
    case OperandRole::kAssignment:
      return "an expression";
    case OperandRole::kText:
      return "a text";
  }
  PLCXX_UNREACHABLE();
}

bool Writes(OperandRole role) {
  switch (role) {
    case OperandRole::kCoil:
    case OperandRole::kIntResult:
    case OperandRole::kFloatResult:
    case OperandRole::kNumberResult:
    case OperandRole::kNumberInPlace:
    case OperandRole::kFieldResult:
      return true;
    case OperandRole::kBit:
    case OperandRole::kBitOrConstant:
    case OperandRole::kIntSource:
    case OperandRole::kIntDivisor:
    case OperandRole::kFloatSource:
    case OperandRole::kFloatDivisor:
    case OperandRole::kNumberSource:
    case OperandRole::kFieldSource:
    case OperandRole::kBitCount:
    case OperandRole::kTimer:
    case OperandRole::kCounter:
    case OperandRole::kUnit:
    case OperandRole::kSubroutine:
    case OperandRole::kJumpTarget:
    case OperandRole::kAxisNumber:
    case OperandRole::kHomingMethod:
    case OperandRole::kPosition:
    case OperandRole::kComparison:
    case OperandRole::kAssignment:
    case OperandRole::kText:
      return false;
  }
  PLCXX_UNREACHABLE();
}

bool Reads(OperandRole role) {
  switch (role) {
    case OperandRole::kBit:
    case OperandRole::kBitOrConstant:
    case OperandRole::kIntSource:
    case OperandRole::kIntDivisor:
    case OperandRole::kFloatSource:
    case OperandRole::kFloatDivisor:
    case OperandRole::kNumberSource:
    case OperandRole::kNumberInPlace:
    case OperandRole::kFieldSource:
    case OperandRole::kAxisNumber:
    case OperandRole::kHomingMethod:
    case OperandRole::kPosition:
    case OperandRole::kComparison:
    case OperandRole::kAssignment:
      return true;
    case OperandRole::kCoil:
    case OperandRole::kIntResult:
    case OperandRole::kFloatResult:
    case OperandRole::kNumberResult:
    case OperandRole::kFieldResult:
    case OperandRole::kBitCount:
    case OperandRole::kTimer:
    case OperandRole::kCounter:
    case OperandRole::kUnit:
    case OperandRole::kSubroutine:
    case OperandRole::kJumpTarget:
    case OperandRole::kText:
      return false;
  }
  PLCXX_UNREACHABLE();
}

const InstructionInfo& Info(Op op) { return kInstructions[static_cast<size_t>(op)]; }

uint32_t Duration(TimerUnit unit) {
  switch (unit) {
    case TimerUnit::kHundredMs:
      return 100;
    case TimerUnit::kSecond:
      return 1000;
    case TimerUnit::kMinute:
      return 60'000;
  }
  PLCXX_UNREACHABLE();
}

std::optional<TimerUnit> UnitByName(std::string_view word) {
  for (const UnitRow& row : kUnits) {
    if (EqualIgnoringCase(row.word, word)) return row.unit;
  }
  return std::nullopt;
}

std::optional<Mnemonic> MnemonicByName(std::string_view word) {
  static const std::vector<SpellingRow> rows = [] {
    std::vector<SpellingRow> sorted(std::begin(kSpellings), std::end(kSpellings));
    std::ranges::sort(sorted, {}, &SpellingRow::name);
    return sorted;
  }();
  const auto less = [](std::string_view a, std::string_view b) {
    return std::ranges::lexicographical_compare(a, b, {}, Upper, Upper);
  };
  const auto row = std::ranges::lower_bound(rows, word, less, &SpellingRow::name);
  if (row == rows.end() || !EqualIgnoringCase(row->name, word)) return std::nullopt;
  return row->mnemonic;
}

std::string_view NearMnemonic(std::string_view word) {
  std::vector<std::string_view> names;
  for (const SpellingRow& row : kSpellings) names.push_back(row.name);
  for (const std::string_view keyword :
       {"NETWORK", "LADDER", "SLOWDIV", "CHANNELS", "OPTION", "TITLE", "SYMBOLS", "ALARMS", "MCODES", "FAST", "SLOW"}) {
    names.push_back(keyword);
  }
  return support::NearestWord(word, names);
}

std::string_view TimerName(Op op, TimerUnit unit) {
  for (const SpellingRow& row : kSpellings) {
    if (row.mnemonic.op == op && row.mnemonic.unit == unit) return row.name;
  }
  PLCXX_UNREACHABLE();
}

std::optional<Op> DrawnOp(char bracket, char prefix) {
  for (const DrawnSpelling& row : kDrawn) {
    if (row.bracket == bracket && row.prefix == Upper(prefix)) return row.op;
  }
  return std::nullopt;
}

const AxisBlock* AxisBlockOf(Op op) {
  const auto* row = std::ranges::find(kAxisBlocks, op, &AxisBlock::op);
  return row == std::end(kAxisBlocks) ? nullptr : row;
}

bool IsHomingMethod(int32_t method) { return std::ranges::find(kHomingMethods, method) != std::end(kHomingMethods); }

std::span<const TitleKeyInfo> TitleKeys() { return kTitleKeys; }
std::span<const SeverityInfo> Severities() { return kSeverities; }

bool EqualIgnoringCase(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, Upper, Upper); }

}  // namespace plcxx::host50
