// The syntax tree of dialect prostep: flat stores with typed ids, in source order.
//
// The parser has decoded every operand, attached every operand line to its instruction, matched every module with its
// end and resolved every label and call; lowering reads the modules and their instructions from first to last. A tree
// is always whole, but it is only meaningful where no error was reported: then no operand is kNone, no Op is kUnknown,
// all targets are valid, brackets are balanced, and calls form no ring.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/prostep/machine/machine.h"
#include "transpiler/source/source.h"
#include "transpiler/support/ids.h"

namespace plcxx::prostep {

using ModuleId = support::Id<struct ModuleTag>;
using InstructionId = support::Id<struct InstructionTag>;
using LabelId = support::Id<struct LabelTag>;

struct Span {
  uint32_t first = 0;
  uint32_t count = 0;
};

enum class NumberForm : uint8_t { kDecimal, kHexadecimal, kBcd };

struct Operand {
  OperandClass kind = OperandClass::kNone;
  uint8_t bit = 0;                         // kI, kO, kF, kP
  uint16_t number = 0;                     // byte address, timer, counter or module
  uint16_t value = 0;                      // kK: the sixteen bits
  NumberForm form = NumberForm::kDecimal;  // kK
  bool has_minus = false;                  // kK, as written
  source::Range range;

  bool exists() const { return kind != OperandClass::kNone; }
  /// Not for kNone.
  Shape shape() const { return ShapeOf(kind); }
  Space space() const { return SpaceOf(kind); }
};

/// With one blank, without leading zeros: "I 10.1", "DB 20", "T 5", "PM 33"; constants as decimal numbers: "K 40".
std::string ToText(const Operand& operand);

enum class CommentPlace : uint8_t {
  kLeading,   // on lines of its own before what it belongs to
  kInside,    // between an instruction and its operand lines, and after the instruction when lines follow
  kTrailing,  // after what it belongs to, on its last line
};

struct Comment {
  source::Range range;  // with its ';' or '*' if it has one; no blanks at either end
  CommentPlace place = CommentPlace::kLeading;
  bool blank_line_before = false;
};

/// An instruction with its operand lines.
struct Instruction {
  Op op = Op::kUnknown;
  bool faulty = false;  // an error was reported in it
  source::Range range;  // mnemonic to operand on its own line
  source::Range whole;  // mnemonic to the end of its last operand line
  source::Range mnemonic;
  /// Bit, data, counter, timer, module or functional module; of kOneOf (L, comparisons) the operand of either line.
  /// kNone for jumps to labels, brackets, EM ...
  Operand operand;
  LabelId target;                    // kJump, kJumpIf
  ModuleId module;                   // kCall, kCallIf
  std::optional<Function> function;  // kPerform, kPerformIf
  /// Into Program::arguments: preset or time (kOwnAndNext), or what the functional module takes: always
  /// Info(function).count of them (FM 64-66 with two lines: the second one twice).
  Span arguments;
  Span comments;
};

/// Stands in front of an instruction, or at the end of its module.
struct Label {
  std::string name;  // in capitals
  source::Range range;
  ModuleId module;
  InstructionId at;  // the instruction after it; the module's end: the one after its last (end_of)
  uint32_t uses = 0;
};

struct Module {
  uint8_t number = 0;
  bool faulty = false;   // its own MOD or END line, or its number
  bool numbered = true;  // its MOD line has a legal number
  source::FileId file;
  source::Range open;   // "MOD PM 20"
  source::Range close;  // "END PM 20"; empty where it is missing (reported)
  Span instructions;
  Span labels;
  Span comments;      // before and on the MOD line
  Span end_comments;  // before and on the END line

  InstructionId begin_of() const { return InstructionId(instructions.first); }
  InstructionId end_of() const { return InstructionId(instructions.first + instructions.count); }
};

/// DDB, DDW, DDD.
struct DataDeclaration {
  uint16_t address = 0;  // D 0 to 499
  uint8_t bytes = 1;     // 1, 2 or 4
  uint32_t value = 0;
  source::Range range;
  Span comments;
};

/// DMF.
struct MFunction {
  uint8_t number = 0;
  bool after_move = false;  // P, or one of M00 M01 M02 M05 M30
  uint8_t static_bit = 0;   // 1 to 24; 0: none
  uint8_t dynamic_bit = 0;  // 1 to 16; 0: none
  source::Range range;
  Span comments;
};

/// DM or DT.
struct Text {
  uint8_t number = 0;
  std::string text;  // UTF-8, leading blanks kept
  source::Range range;
  Span comments;
};

struct SourceFile {
  source::FileId file;
  Span header;  // comments before anything else, when a blank line follows them
  Span rest;    // comments after everything
};

struct Program {
  std::vector<SourceFile> files;
  support::Store<ModuleId, Module> modules;  // in the order of the text
  support::Store<InstructionId, Instruction> instructions;
  support::Store<LabelId, Label> labels;
  std::vector<Operand> arguments;
  std::vector<Comment> comments;
  std::vector<DataDeclaration> data;           // in the order of the text: a later one overwrites an earlier one
  std::vector<MFunction> m_functions;          // numbers are unique
  std::vector<Text> messages;                  // DM
  std::vector<Text> menu_texts;                // DT
  std::array<ModuleId, kModules> module_of{};  // by number; not valid: the program has none
  uint32_t line_count = 0;                     // of all files
  uint32_t statement_count = 0;                // instructions

  const Operand& Argument(const Instruction& instruction, uint32_t index) const {
    return arguments[instruction.arguments.first + index];
  }
};

/// What DDB, DDW and DDD leave in D 0 to 499.
std::array<uint8_t, kFirstKeptByte> InitialData(const Program& program);

}  // namespace plcxx::prostep
