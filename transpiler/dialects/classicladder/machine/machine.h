// What ClassicLadder's engine has (machine.def): elements of a rung, variables and where they are in its memory, sizes.
//
// The engine keeps bits in one array and words in another, one kind of variable after the other, and looks at no
// bound: a number beyond its own kind is a variable of the next one. Where that is, is decided here (Resolve).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "transpiler/dialects/common/option_values.h"

namespace plcxx::classicladder {

constexpr uint32_t kRungWidth = 10, kRungHeight = 6;
constexpr uint32_t kMostExpression = 49;  // characters; the engine cuts the rest
constexpr uint32_t kMostLine = 298;       // bytes; the engine takes more for another line
constexpr uint32_t kSteps = 128, kTransitions = 256, kSwitches = 10, kPages = 5, kComments = 50;
constexpr uint32_t kSystemVariables = 20, kErrorBits = 10;  // system variables of 2.10 only
constexpr uint32_t kMostSymbol = 9;                         // characters of a symbol's name, and of the variable's
constexpr uint32_t kMostJumps = 99'999;                     // of one execution of a section
constexpr uint32_t kMostSeqRounds = 50;                     // of one execution of a sequential page

enum class ElementKind : uint8_t {
#define CLASSICLADDER_ELEMENT(Kind, Number, Drawn, Left, Below) k##Kind,
#include "transpiler/dialects/classicladder/machine/machine.def"
};

struct ElementInfo {
  ElementKind kind{};
  uint32_t number = 0;
  std::string_view name;   // "CoilNot"
  std::string_view drawn;  // "-(/)-"
  uint32_t left = 0, below = 0;
};
const ElementInfo& Info(ElementKind kind);
std::optional<ElementKind> ElementByNumber(uint32_t number);
/// A contact or coil: it has a variable.
bool UsesVariable(ElementKind kind);
/// A block, jump or call: it has a number.
bool UsesNumber(ElementKind kind);
/// Tools of the editor that it leaves behind in rungs: nothing is there for the engine.
constexpr bool IsEditorsLeftover(uint32_t number) { return number >= 100 && number <= 105; }

enum class VariableKind : uint8_t {
#define CLASSICLADDER_VARIABLE(Kind, Number, Name, Attribute, Group, Part, Access, Meaning) k##Kind,
#include "transpiler/dialects/classicladder/machine/machine.def"
};
enum class Group : uint8_t { kBits, kWords, kFloats, kTimers, kMonostables, kCounters, kTimersIec };
/// Of a flat array the stretch, of an array of records the field.
enum class Part : uint8_t { kB, kI, kQ, kS, kX, kE, kPreset, kValue, kDone, kRunning, kEmpty, kFull };
enum class Access : uint8_t { kRead, kWritten };

struct VariableInfo {
  VariableKind kind{};
  uint32_t number = 0;
  std::string_view name, attribute;
  Group group{};
  Part part{};
  Access access{};
  std::string_view meaning;
};
const VariableInfo& Info(VariableKind kind);
std::span<const VariableInfo> Variables();
/// Is a bit: kBits, and the outputs of timers, monostables and counters.
bool IsBit(VariableKind kind);

/// ClassicLadder 0.7.124 and 0.8.10.
enum class LinuxCnc : uint8_t { kTwoNine, kTwoTen };

struct Sizes {
  LinuxCnc version = LinuxCnc::kTwoNine;
#define CLASSICLADDER_SIZE(Member, Parameter, Line, Default, Meaning) uint32_t Member = Default;
#include "transpiler/dialects/classicladder/machine/machine.def"
};
/// None: the engine of this version has no such type.
std::optional<VariableKind> VariableByNumber(uint32_t number, LinuxCnc version);

struct SizeInfo {
  std::string_view parameter, line, meaning;
  uint32_t Sizes::* member;
};
std::span<const SizeInfo> SizeInfos();

/// A variable with its number, as the source has it.
struct Address {
  VariableKind kind{};
  uint32_t number = 0;
  bool operator==(const Address&) const = default;
};
/// "B3", "T0.D": as ClassicLadder writes it, without its '%'.
std::string NameOf(const Address& address);
/// With or without '%'.
std::optional<Address> AddressByName(std::string_view text);

/// How many elements the array of a group has.
uint32_t CountOf(Group group, const Sizes& sizes);
/// How many of its kind there are.
uint32_t CountOf(VariableKind kind, const Sizes& sizes);
/// The element of its array; may be beyond it.
uint32_t IndexOf(const Address& address, const Sizes& sizes);
/// What the engine reads and writes under this address: itself, or the variable of the next kind where its number is
/// too great; none beyond the engine's memory.
std::optional<Address> Resolve(const Address& address, const Sizes& sizes);

enum class PartKind : uint8_t {
#define CLASSICLADDER_PART(Name, Kind) k##Kind,
#include "transpiler/dialects/classicladder/machine/machine.def"
  kRung,
  kIgnored,
};
/// `rung`: the number of "rung_7.csv".
PartKind PartByName(std::string_view name, uint32_t& rung);

}  // namespace plcxx::classicladder
