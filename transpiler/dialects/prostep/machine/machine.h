// What a ProStep control has: spaces, operand classes, instructions, functional modules, limits. Data in machine.def.
//
// A new mnemonic is a row of machine.def and its case in the lowering; lexer, parser and `print syntax` follow the row.
// Not its job: the predefined signals (signals.h) and what a program makes of all this.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace plcxx::prostep {

enum class Space : uint8_t {
#define PROSTEP_SPACE(Key, ...) k##Key,
#include "transpiler/dialects/prostep/machine/machine.def"
  kNone,
};
/// 0 for kNone.
uint32_t BytesOf(Space space);
std::string_view Name(Space space);

constexpr uint32_t kTimers = 64;
constexpr uint32_t kCounters = 64;
constexpr uint32_t kModules = 100;         // PM 0 to PM 99
constexpr uint32_t kFirstLoopModule = 9;   // PM 1 to PM 8 are interrupt modules
constexpr uint32_t kFirstSubroutine = 17;  // PM 9 to PM 16 are loop modules
constexpr uint32_t kActivityByte = 250;    // F 250: PM 1 to 8, F 251: PM 9 to 16
constexpr uint32_t kFirstKeptByte = 500;   // D 500 to 999 is retentive; no field lies across this border
constexpr uint32_t kBracketLevels = 8;
constexpr uint32_t kLabelLength = 5;
constexpr uint32_t kInputCountAddress = 496;   // DW 496: bytes of the input refresh
constexpr uint32_t kOutputCountAddress = 498;  // DW 498: bytes of the output refresh
constexpr uint32_t kMostInputBytes = 24;
constexpr uint32_t kMostOutputBytes = 12;
constexpr uint32_t kFirstMessageByte = 213;  // F 213.0 is message 1
constexpr uint32_t kMessages = 64;
constexpr uint32_t kFirstNumberByte = 222;  // F 222 to 237: where the numbers of messages stand in D
constexpr uint32_t kMessagesWithNumber = 16;

/// What an operand class names.
enum class Shape : uint8_t { kBit, kByte, kWord, kDouble, kCounter, kTimer, kConstant, kModule, kFunction };

enum class OperandClass : uint8_t {
#define PROSTEP_CLASS(Key, ...) k##Key,
#include "transpiler/dialects/prostep/machine/machine.def"
  kNone,  // no operand, or one that was not understood (reported)
};
/// As written: "IB"; empty for kNone.
std::string_view Name(OperandClass operand_class);
/// Not for kNone.
Shape ShapeOf(OperandClass operand_class);
Space SpaceOf(OperandClass operand_class);
/// `word` in capitals; kNone when it is no class.
OperandClass ClassByName(std::string_view word);

enum class Access : uint8_t { kNone, kRead, kWrite, kReadWrite };

/// Is there a direct input (kRead) or output (kWrite) at this number? For P, PB and PW (5.1).
bool IsPort(Access access, Shape shape, uint32_t number);
/// The byte of I that the input refresh writes from direct input byte `port` (4.4).
constexpr uint32_t InputByteOfPort(uint32_t port) { return port < 20 ? port : 44 + (port - 20); }

/// Sets of operands that an instruction accepts.
using OperandSet = uint16_t;
constexpr OperandSet kNothing = 0;
constexpr OperandSet kBits = 1;
constexpr OperandSet kBytes = 2;
constexpr OperandSet kWords = 4;
constexpr OperandSet kData = kBytes | kWords;
constexpr OperandSet kCounterSet = 8;
constexpr OperandSet kTimerSet = 16;
constexpr OperandSet kConstants = 32;
constexpr OperandSet kLabels = 64;
constexpr OperandSet kModuleSet = 128;
constexpr OperandSet kFunctions = 256;
bool Accepts(OperandSet set, OperandClass operand_class);

/// On which lines an instruction's operands stand (2.6).
enum class Lines : uint8_t {
  kNone,
  kOwn,
  kOwnAndNext,
  kOneOf,  // on its own line or on the next; what only the next may hold is warned about on its own
};

/// What an instruction does to the sequence (5.3).
enum class Role : uint8_t {
  kLogic,
  kCompare,  // replaces S, leaves the sequence open, drops a pending OR
  kString,   // operand-less O
  kOpen,
  kClose,
  kNeutral,
  kJump,  // neutral, but folds a pending OR
  kEnds,
};

/// What S decides of an instruction.
enum class SUse : uint8_t {
  kNone,
  kAssigns,  // what is assigned
  kActs,     // whether it acts: with S = 0 it does nothing
  kSteps,    // the same, of what looks at the edges of S
  kGoes,     // whether it goes elsewhere
};

/// What an instruction or a functional module (6.9) does with AX. JU FM reads it as far as its module does.
enum class AxUse : uint8_t { kNone, kReads, kChanges, kLoadsByte, kLoadsWord };

/// The meanings of the mnemonics; a mnemonic whose operand decides (S, R, L, LD, O, JU, JC) has several.
enum class Op : uint8_t {
#define PROSTEP_INSTRUCTION(Key, ...) k##Key,
#include "transpiler/dialects/prostep/machine/machine.def"
  kUnknown,  // reported; neutral
};

struct InstructionInfo {
  Op op = Op::kUnknown;
  std::string_view mnemonic;
  Lines lines = Lines::kNone;
  OperandSet own = kNothing;
  OperandSet next = kNothing;
  Access access = Access::kNone;  // to the memory that its operand names (of OwnAndNext: the next line's)
  Role role = Role::kNeutral;
  SUse s_use = SUse::kNone;
  AxUse ax_use = AxUse::kNone;
};
/// In the order of Op, kUnknown last.
std::span<const InstructionInfo> Instructions();
const InstructionInfo& Info(Op op);

enum class ModuleMark : uint8_t {
#define PROSTEP_MODULE_MARK(Key, ...) k##Key,
#include "transpiler/dialects/prostep/machine/machine.def"
};
std::optional<ModuleMark> ModuleMarkByName(std::string_view word);

/// What a constant means in an argument of a functional module (6.9).
enum class Constant : uint8_t {
  kTaken,     // its value
  kExpected,  // everything else is warned about
  kRefused,   // an error
  kDisables,  // accepted; the module then does nothing but S = 1
};

enum class ArgumentShape : uint8_t {
#define PROSTEP_SHAPE(Key, ...) k##Key,
#include "transpiler/dialects/prostep/machine/machine.def"
};

struct ShapeInfo {
  uint8_t field_bytes = 0;  // 0: a plain byte or word operand. Else only the operand's space and number count
  Access access = Access::kNone;
  Constant constant = Constant::kTaken;
};
const ShapeInfo& Info(ArgumentShape shape);

/// The functional modules; synonyms (FM 30 and 60, FM 71 and 75 ...) are one.
enum class Function : uint8_t {
#define PROSTEP_FUNCTION(Key, ...) k##Key,
#include "transpiler/dialects/prostep/machine/machine.def"
};

constexpr uint32_t kMostArguments = 3;
struct FunctionInfo {
  std::string_view name;
  AxUse ax_use = AxUse::kNone;
  uint8_t fewest = 0;  // operand lines; with fewer than `count` the last one serves twice (FM 64-66)
  uint8_t count = 0;
  ArgumentShape arguments[kMostArguments] = {};
};
const FunctionInfo& Info(Function function);
std::optional<Function> FunctionByNumber(uint32_t number);

enum class VariableUse : uint8_t { kRead, kWritten };
/// The name of a system variable (FM 41-54); empty when the table has none of this index.
std::string_view VariableName(uint32_t index);
/// Does the table list it with this width (1, 2 or 4 bytes) in this direction?
bool IsVariable(uint32_t index, uint32_t width, VariableUse use);

/// What to write instead of a mnemonic of STEP 5 or 7; empty when nothing is known. `word` in capitals.
std::string_view ForeignHint(std::string_view word);
/// The same for operands of STEP 5: E, A, M.
std::string_view ForeignOperandHint(std::string_view word);

}  // namespace plcxx::prostep
