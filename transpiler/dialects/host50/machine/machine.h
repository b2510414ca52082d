// What a HOST 50 control has: areas, instructions with their operands and pins, limits. Data in machine.def.
//
// Not its job: the predefined signals (signals.h) and what a program makes of all that.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace plcxx::host50 {

enum class Type : uint8_t { kUnknown, kBit, kInteger, kFloat, kTimer, kCounter };
/// "bit", "integer" ...
std::string_view Name(Type type);

/// Lines of the resource report.
enum class Resource : uint8_t {
#define HOST50_RESOURCE(Name, ...) k##Name,
#include "transpiler/dialects/host50/machine/machine.def"
  kNone
};
std::string_view Name(Resource resource);
uint32_t Available(Resource resource);

// --- memory (5) ---

enum class Area : uint8_t {
#define HOST50_AREA(Name, ...) k##Name,
#include "transpiler/dialects/host50/machine/machine.def"
};
constexpr Area kLastArea = Area::kC;

/// Of a timer or counter: done, current value, preset. kNone: the thing itself, or an area without attributes.
enum class Attribute : uint8_t { kNone, kQ, kV, kP };

struct Address {
  Area area = Area::kI;
  Attribute attribute = Attribute::kNone;
  uint16_t number = 0;
  bool operator==(const Address&) const = default;
};

enum class Writer : uint8_t { kHost, kProgram, kBlock };

struct AreaInfo {
  std::string_view name;  // "IW"
  Type type;
  Writer writer;
  Resource resource;
  uint32_t common_last;  // addresses 0 .. common_last exist once
  uint32_t channel_first, channel_last, channel_step;
  int32_t retentive_last;  // -1: nothing of it is kept
};
const AreaInfo& Info(Area area);
/// Without regard to case; "T" is TM.
std::optional<Area> AreaByName(std::string_view name);
/// Does the address exist with this number of channels?
bool Exists(Area area, uint32_t number, uint32_t channels);
/// The greatest number of the area.
uint32_t LastNumber(Area area, uint32_t channels);
/// Channel 1's address of the same signal (section 5).
Address InChannel1(Address address);
bool IsRetentive(const Address& address);
/// kBit for .Q, kInteger for .V and .P, else the area's.
Type TypeOf(const Address& address);

constexpr uint32_t kMostChannels = 8;
constexpr uint32_t kFirstAlarm = 400;  // of %Q
constexpr uint32_t kAlarmCount = 100;
constexpr uint32_t kFirstNcBit = 500;       // %I and %Q from here on belong to the NC
constexpr uint32_t kMostAddressDigits = 5;  // of an address
constexpr uint32_t kGreatestLabel = 9999;
constexpr uint32_t kGreatestMCode = 999;
constexpr uint32_t kLastRegularMCode = 99;
constexpr uint32_t kMostFastNetworks = 10;
constexpr uint32_t kMostCallDepth = 25;
constexpr uint32_t kMostBlockDepth = 32, kUsualBlockDepth = 8;
constexpr uint32_t kMostBranchDepth = 16, kUsualBranchDepth = 11;
constexpr uint32_t kMostRows = 50, kMostCells = 9;
constexpr uint32_t kMostSymbolName = 30, kMostSymbolComment = 30, kMostRowComment = 50, kMostSubroutineName = 20;
constexpr uint32_t kMostSlowdiv = 1000;
constexpr uint32_t kMostBits = 32;  // of BTOW and WTOB

// --- instructions (3, 6) ---

enum class Op : uint8_t {
#define HOST50_INSTRUCTION(Name, ...) k##Name,
#include "transpiler/dialects/host50/machine/machine.def"
};

enum class Form : uint8_t { kBasic, kBlock };

/// What an instruction does to the rung (6.1).
enum class RungEffect : uint8_t {
  kLoad,          // LD
  kSeries,        // AND
  kParallel,      // OR
  kJoinSeries,    // ANB
  kJoinParallel,  // ORB
  kBranchOpen,    // MPS
  kBranchNext,    // MRD
  kBranchLast,    // MPP
  kOutput,        // coils and blocks without Q
  kCompare,       // a block with Q and nothing else: its Q must be used
  kElement,       // a block with Q and a state or result of its own: may end a rung
  kClose,         // RUNG
  kNothing,       // REMARK
};

/// How a contact looks at its operand.
enum class Contact : uint8_t { kNone, kPlain, kInverted, kRising, kFalling };
constexpr bool IsEdge(Contact contact) { return contact == Contact::kRising || contact == Contact::kFalling; }

enum class State : uint8_t { kStateless, kEdge, kTimer, kCounter, kAxis };

enum class OperandRole : uint8_t {
  kBit,
  kBitOrConstant,
  kCoil,
  kIntSource,
  kIntDivisor,
  kIntResult,
  kFloatSource,
  kFloatDivisor,
  kFloatResult,
  kNumberSource,
  kNumberResult,
  kNumberInPlace,  // read and written
  kFieldSource,    // the first bit of a field
  kFieldResult,
  kBitCount,
  kTimer,
  kCounter,
  kUnit,
  kSubroutine,
  kJumpTarget,
  kAxisNumber,
  kHomingMethod,
  kPosition,
  kComparison,
  kAssignment,  // gives two operands: kNumberResult, then kAssignment with the expression
  kText,
};
/// What an instruction needs there: "a bit", "a destination".
std::string_view Name(OperandRole role);
bool Reads(OperandRole role);
bool Writes(OperandRole role);

constexpr size_t kMostOperands = 4;

struct InstructionInfo {
  std::string_view name;
  Form form;
  RungEffect effect;
  Contact contact;
  State state;
  Resource resource;
  std::string_view pins;  // their letters, in the order of 3.4
  uint8_t operand_count;
  OperandRole operands[kMostOperands];
};
const InstructionInfo& Info(Op op);

enum class TimerUnit : uint8_t { kHundredMs, kSecond, kMinute };
/// In ms.
uint32_t Duration(TimerUnit unit);
std::optional<TimerUnit> UnitByName(std::string_view word);

struct Mnemonic {
  Op op;
  std::optional<TimerUnit> unit;  // of TONS and the like: the operand kUnit is left out
};
/// Without regard to case, all spellings of 3.1; none for a word that is no instruction.
std::optional<Mnemonic> MnemonicByName(std::string_view word);
/// The mnemonic that is spelled nearly so; empty when none is.
std::string_view NearMnemonic(std::string_view word);

/// "TONS": the spelling with its unit.
std::string_view TimerName(Op op, TimerUnit unit);

/// What a bracket of a drawing with this prefix (' ': none) is; none when it has no such prefix.
std::optional<Op> DrawnOp(char bracket, char prefix);

// --- PLC axes (6.8): numbers of channel 1 ---

constexpr uint32_t kAxes = 10;
constexpr uint32_t kAxisMove = 1000, kAxisPositionMode = 1020, kAxisAbsolute = 1030, kAxisHoming = 1040;  // %Q
constexpr uint32_t kAxisMethod = 0;                                                                       // %QW
constexpr uint32_t kAxisSpeed = 0, kAxisPosition = 10;                                                    // %QF

enum class AxisValue : uint8_t { kNotWritten, kGiven, kNegated };

struct AxisBlock {
  Op op;
  bool position_mode, absolute, homing;
  AxisValue method, position, speed;
};
/// None for other instructions.
const AxisBlock* AxisBlockOf(Op op);
/// 1, 2, 17, 18, 33, 34, 35.
bool IsHomingMethod(int32_t method);

// --- tables (9) ---

enum class TitleKey : uint8_t {
#define HOST50_TITLE_KEY(Name, ...) k##Name,
#include "transpiler/dialects/host50/machine/machine.def"
};
struct TitleKeyInfo {
  TitleKey key;
  std::string_view name;
  uint32_t most_characters;
};
std::span<const TitleKeyInfo> TitleKeys();

enum class Severity : uint8_t {
#define HOST50_SEVERITY(Name, ...) k##Name,
#include "transpiler/dialects/host50/machine/machine.def"
};
struct SeverityInfo {
  Severity severity;
  std::string_view keyword;
  std::string_view prefix;  // of a text, in front of '-'
};
std::span<const SeverityInfo> Severities();

// --- letters ---

constexpr char Upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
constexpr bool IsDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool IsLetter(char c) { return Upper(c) >= 'A' && Upper(c) <= 'Z'; }
bool EqualIgnoringCase(std::string_view a, std::string_view b);

}  // namespace plcxx::host50
