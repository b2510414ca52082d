// What a TECHNOL control has: areas, registers, modules, instructions, limits. Data in machine.def.
//
// A new mnemonic is a row of machine.def and its case in the lowering; lexer, parser and `print syntax` follow the row.
// Not its job: the predefined cells and bits (signals.h) and what a program makes of all this.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace plcxx::technol {

/// Stretches of memory that no access leaves (5.1). kUser is the segment of the program's own cells.
enum class Area : uint8_t {
#define TECHNOL_AREA(Key, ...) k##Key,
#include "transpiler/dialects/technol/machine/machine.def"
  kUser,
  kNone,
};
/// "LABEL_MEM"; "DATA" for kUser.
std::string_view Name(Area area);
/// Of a system area; 0 for kUser (the program decides) and kNone.
uint32_t BytesOf(Area area);
std::optional<Area> AreaByName(std::string_view name);

constexpr uint32_t kNameLength = 31;
constexpr uint32_t kLineBytes = 512;             // longer: TW001
constexpr uint32_t kUserBytes = 65'535;          // of all data blocks together
constexpr uint32_t kBitsOfDfm = 8;               // names in one DFM
constexpr uint32_t kIncludeDepth = 8;            // T_INCLUDE inside T_INCLUDE
constexpr uint32_t kMacroDepth = 16;             // calls inside calls
constexpr uint32_t kCallDepth = 16;              // CALL inside CALL
constexpr uint32_t kStackWords = 16;             // PUSH
constexpr uint32_t kTimerLimit = 65'535;         // passes
constexpr uint32_t kTableColumns = 20;           // of a technology table
constexpr uint32_t kTableRows = 400;             //
constexpr uint32_t kTableItems = 400;            // columns times rows
constexpr uint32_t kTableNameBytes = 16;         // TCH_FILENAME, with the zero at its end
constexpr uint32_t kTableFirstItem = 32;         // offset of TCH_DATA
constexpr int64_t kLeastNumber = -0x80000000LL;  // of constant expressions
constexpr int64_t kGreatestNumber = 0xFFFFFFFFLL;

enum class Register : uint8_t {
#define TECHNOL_REGISTER(Key, ...) k##Key,
#include "transpiler/dialects/technol/machine/machine.def"
  kNone,
};
struct RegisterInfo {
  Register key = Register::kNone;
  std::string_view name;
  uint8_t width = 0;                 // 8, 16, 32
  Register whole = Register::kNone;  // the 32-bit register of which it is a part; of EAX: EAX
  uint8_t shift = 0;                 // where it begins in there: 8 for AH
};
/// Not for kNone.
const RegisterInfo& Info(Register reg);
/// `word` in capitals; kNone when it is none of the supported ones.
Register RegisterByName(std::string_view word);
/// A register that the language has not (SP, DS, ST ...), `word` in capitals.
bool IsForeignRegister(std::string_view word);

enum class ModuleKind : uint8_t {
#define TECHNOL_MODULE(Key, ...) k##Key,
#include "transpiler/dialects/technol/machine/machine.def"
  kOther,  // MODULE_xxx: host-callable
};
struct ModuleInfo {
  ModuleKind kind = ModuleKind::kOther;
  std::string_view keyword;
  bool standard = false;    // missing: TW011
  bool waits = false;       // may hold waits: a mechanism of its own (7.4)
  bool mechanisms = false;  // may hold MECH_BEGIN
  bool completion = false;  // TW030
};
/// In the order of ModuleKind, kOther last.
std::span<const ModuleInfo> Modules();
const ModuleInfo& Info(ModuleKind kind);

/// Which operands an instruction takes (section 3).
enum class Form : uint8_t {
  kNone,
  kBit,         // [-] bit
  kWriteBit,    // bit
  kFlag,        // 0 or 1, bit
  kJump,        // label; of assembler jumps with an optional SHORT
  kCall,        // label
  kWaitLimit,   // timer cell, time, label
  kDelay,       // timer cell, time
  kMechanism,   // name
  kData,        // memory or CNST.
  kNarrowData,  // as kData: 8 bits, or CNST.0 to 255
  kWideData,    // as kData: 8 or 16 bits, or CNST.0 to 65535
  kStore,       // memory
  kRotation,    // CNST. or a byte
  kError,       // constant [, constant]
  kTwo,         // assembler: register or memory, register, memory or constant
  kOne,         // assembler: register or memory
  kMultiply,    // as kOne: MUL, IMUL, DIV, IDIV
  kShift,       // assembler: register or memory, constant or CL
  kExchange,    // assembler: register or memory, register or memory
  kExtend,      // assembler: register, narrower register or memory
  kStack,       // assembler: register of 16 or 32 bits
};

enum class Access : uint8_t { kNone, kRead, kWrite, kReadWrite };

/// Where a mnemonic is attested (6.0).
enum class Evidence : uint8_t { kAttested, kCompletion };

/// What an instruction does to a wait that follows it (6.7): kPure is evaluated again with it, kActs is not. Assembler
/// instructions of kPure that write memory act, too.
enum class Purity : uint8_t { kPure, kActs };

/// The meanings of the mnemonics; AND, OR and XOR have two each, told by the number of their operands.
enum class Op : uint8_t {
#define TECHNOL_INSTRUCTION(Key, ...) k##Key,
#include "transpiler/dialects/technol/machine/machine.def"
  // Marks, not instructions: they have no mnemonic in machine.def and no operands.
  kMechanismBegin,  // MECH_BEGIN m
  kMechanismEnd,    // MECH_END m
  kModuleEnd,       // MODULE_x_END
  kAreaEnd,         // the end of a stretch of subprograms: who gets here has lost its RET (TE049)
  kUnknown,         // reported
};

struct InstructionInfo {
  Op op = Op::kUnknown;
  std::string_view mnemonic;
  Form form = Form::kNone;
  Access first = Access::kNone;  // to its bit, cell, register or timer cell
  Evidence evidence = Evidence::kAttested;
  Purity purity = Purity::kActs;
  bool assembler = false;
};
/// In the order of Op, with the marks; kUnknown last.
std::span<const InstructionInfo> Instructions();
const InstructionInfo& Info(Op op);
/// `word` in capitals, synonyms included; of AND, OR and XOR the one-operand form. kUnknown when it is no mnemonic.
Op OpByMnemonic(std::string_view word);
/// The one that is spelled nearly so; empty when there is none.
std::string_view NearMnemonic(std::string_view word);
/// kAnd -> kAsmAnd, kOr -> kAsmOr, kXor -> kAsmXor; anything else: itself.
Op AssemblerForm(Op op);
/// An assembler instruction outside the subset: INT, MOVSB, FLD ... (TE070). LEA is none: it is TE065.
bool IsForeignInstruction(std::string_view word);
/// What a mnemonic of other controls is in TECHNOL, as a remedy; empty: nobody knows. In capitals.
std::string_view ForeignHint(std::string_view word);
/// Words that may not be names (TE005), `word` in capitals.
bool IsReserved(std::string_view word);

}  // namespace plcxx::technol
