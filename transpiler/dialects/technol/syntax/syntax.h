// The syntax tree of dialect technol: flat stores with typed ids.
//
// Includes and macros are expanded, constants evaluated, names resolved, data laid out. A tree is always whole: what
// could not be read is an operand of kind kError or an instruction kUnknown whose fault has been reported. It is only
// meaningful where no error was reported: then every operand has the kind, width and range that its instruction's Form
// asks for (TE001 to TE048, TE052 to TE055, TE059 to TE070, TE073 to TE077 are decided here). What needs paths is not:
// TE049 to TE051, TE056 to TE058, TE071, TE072.
//
// Instructions stand in source order: modules and mechanisms first, then the subprogram area. A mechanism of
// MODULE_MAIN lies inside the module's stretch, from its kMechanismBegin to its kMechanismEnd. Every stretch ends with
// a mark (machine.h), so a label always stands in front of an instruction.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/technol/machine/machine.h"
#include "transpiler/dialects/technol/machine/symbols.h"
#include "transpiler/dialects/technol/machine/technology_table.h"
#include "transpiler/source/source.h"
#include "transpiler/support/ids.h"

namespace plcxx::technol {

using InstructionId = support::Id<struct InstructionTag>;
using ExpansionId = support::Id<struct ExpansionTag>;

/// Memory at a constant offset of an area, plus an index register.
struct Address {
  Area area = Area::kNone;
  int64_t offset = 0;                // without an index the whole access lies in the area; with one it may be anywhere
  Register index = Register::kNone;  // BX, SI, DI: a signed 16-bit number; EBX, ESI, EDI: signed 32 bits
  SymbolId base;                     // the cell or area that is named
  SymbolId field;                    // the last field that is named
};

enum class OperandKind : uint8_t {
  kError,           // reported
  kBit,             // a bit of memory (address, bit), or a mechanism's (mechanism)
  kMemory,          // address, width
  kConstant,        // value, width
  kRegister,        // reg, width
  kLabel,           // label
  kMechanism,       // mechanism: of MECH_INIT
  kAutomaticTimer,  // timer
};

struct Operand {
  OperandKind kind = OperandKind::kError;
  bool negated = false;            // kBit with '-'
  uint8_t bit = 0;                 // kBit of memory
  uint8_t width = 0;               // kMemory, kRegister: 8, 16, 32. kConstant of CNST.: 16 or 32 (6.1); of an assembler
                                   // instruction its operand width
  Register reg = Register::kNone;  //
  Address address;                 // kMemory; kBit of memory: the byte
  int64_t value = 0;               // kConstant: kLeastNumber to kGreatestNumber
  LabelId label;                   //
  UnitId mechanism;                // kMechanism; kBit that is an activation bit
  uint32_t timer = 0;              // kAutomaticTimer: number in its unit, from 0
  SymbolId symbol;                 // what is named: bit, cell, area, mechanism, label; a constant alone
  source::Range range;

  bool is_activation_bit() const { return kind == OperandKind::kBit && mechanism.valid(); }
};

enum class CommentPlace : uint8_t {
  kLeading,   // on lines of its own before what it belongs to
  kTrailing,  // after what it belongs to, on its line
};

struct Comment {
  source::Range range;  // with its ';'; no blanks at the end
  CommentPlace place = CommentPlace::kLeading;
  bool blank_line_before = false;
};

/// One line of a macro's body in one call. What it makes has the call as its range; messages add a note at `body`.
struct Expansion {
  source::Range call;  // the outermost call, in a source
  ExpansionId outer;   // of the call itself, where it stands in a macro
  source::Range body;  // the line of the macro
  std::string text;    // the line as it reads with its arguments
  std::string macro;
};

struct Instruction {
  Op op = Op::kUnknown;
  bool faulty = false;  // an error was reported in it
  source::Range range;  // mnemonic to last operand; in an expansion the call
  source::Range mnemonic;
  UnitId unit;       // the mechanism of kMechanismBegin: Instruction::mechanism; its own unit is the one around it
  UnitId mechanism;  // kMechanismBegin, kMechanismEnd
  ExpansionId expansion;
  Span operands;  // into Program::operands, in the order of the text
  Span labels;    // into Program::labels: those that stand in front of it
  Span comments;  // into Program::comments
};

struct Label {
  SymbolId symbol;
  std::string name;  // as spelled
  source::Range range;
  UnitId unit;  // of the instruction it stands in front of; of MECH_BEGIN the unit around the mechanism
  InstructionId at;
};

enum class UnitKind : uint8_t { kModule, kMechanism, kSubprograms };

/// What jumps do not leave (6.4): a module without its mechanisms, a mechanism, or the subprogram area.
struct Unit {
  UnitKind kind = UnitKind::kModule;
  ModuleKind module = ModuleKind::kOther;  // kModule
  bool faulty = false;
  std::string name;  // "MODULE_MAIN", the mechanism's name; empty: the subprogram area
  SymbolId symbol;   // of a mechanism
  UnitId parent;     // of a mechanism inside a module; not valid: at top level
  source::FileId file;
  source::Range open;   // keyword (and name) of its opening line
  source::Range close;  // of its closing line; empty where it is missing (reported)
  InstructionId first;  // a mechanism: its kMechanismBegin
  InstructionId end;    // its mark: kMechanismEnd, kModuleEnd; of the subprograms: after their last kAreaEnd
  uint32_t timers = 0;  // automatic timers
  Span comments;        // before and on the opening line of a module
};

struct SourceFile {
  source::FileId file;
  Span header;  // comments before anything else, when a blank line follows them
  Span rest;    // comments after everything
};

struct Program {
  std::vector<SourceFile> files;  // of the command line, then included ones, without tables
  bool tables_only = false;       // nothing but a .TCH was given: memory without instructions
  Symbols symbols;
  support::Store<UnitId, Unit>
      units;  // modules and mechanisms in source order, the subprogram area last (always there)
  support::Store<InstructionId, Instruction> instructions;
  support::Store<LabelId, Label> labels;
  support::Store<ExpansionId, Expansion> expansions;
  std::vector<Operand> operands;
  std::vector<Comment> comments;
  std::vector<uint8_t> user_data;  // the user segment as declared, kUserBytes at most
  std::optional<TechnologyTable> table;
  uint32_t line_count = 0;       // of all files
  uint32_t statement_count = 0;  // instructions, expansions included, without marks

  const Operand& OperandOf(const Instruction& instruction, uint32_t index) const {
    return operands[instruction.operands.first + index];
  }
  UnitId subprograms() const { return UnitId(units.size() - 1); }
};

/// The module of this kind; none when the program has none. Not for kOther, of which there may be many.
UnitId FindModule(const Program& program, ModuleKind kind);
/// Bytes of an area in this program.
uint32_t BytesOf(const Program& program, Area area);

}  // namespace plcxx::technol
