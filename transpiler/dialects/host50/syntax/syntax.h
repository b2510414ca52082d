// The syntax tree of dialect host50: flat stores with typed ids.
//
// The parser has resolved every address, symbol, jump target and subroutine; lowering reads sections, networks and
// instructions from first to last. A tree is always whole: what could not be read is a node of kind kError whose fault
// has been reported, and `faulty` says that a program has errors, so that nothing after the parser need handle them.
//
// Both forms of a network come out as one: a list of instructions in the order in which they are executed. The rung
// machine (6.1) and the rules of a drawing (3.6 rule 8) have been evaluated: every instruction names what it takes.
//   `input`    what the instruction gets as ACC: the left rail (true), or the OR of the results of instructions that
//              stand before it in the same network. LD, RUNG, REMARK, MPS, MRD, MPP take nothing.
//   `other`    ANB, ORB only: the result that came from the block stack, the left operand; `input` is the right one.
//   pins       what is loaded from the block stack or named; see Pin.
// The result of an instruction, by RungEffect (machine.h):
//   kLoad                        its contact
//   kSeries, kParallel           input AND / OR its contact
//   kJoinSeries, kJoinParallel   other AND / OR input
//   kCompare, kElement           Q
//   kOutput                      its input (only a drawing refers to it: a block without Q conducts)
// In a drawing every contact is a kSeries instruction (AND, ANDI, ANDP, ANDF); with the rail as its input it is the
// contact alone. An instruction of a list has one result as input at most. So lowering needs no stack, and one function
// for each effect serves lists and drawings.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/dialects/host50/machine/machine.h"
#include "transpiler/dialects/host50/machine/options.h"
#include "transpiler/source/source.h"
#include "transpiler/support/ids.h"

namespace plcxx::host50 {

using SectionId = support::Id<struct SectionTag>;
using NetworkId = support::Id<struct NetworkTag>;
using InstructionId = support::Id<struct InstructionTag>;
using ExprId = support::Id<struct ExprTag>;
using SymbolId = support::Id<struct SymbolTag>;

/// A stretch of one of the stores.
struct Span {
  uint32_t first = 0;
  uint32_t count = 0;
};

enum class OperandKind : uint8_t {
  kError,       // already reported
  kAddress,     // address; a bare timer or counter in the place of a bit has attribute kQ
  kConstant,    // bits: an int32, the pattern of a binary32 or 0/1, by type
  kSubroutine,  // section
  kNetwork,     // network
  kCount,       // bits: 1..32, of BTOW and WTOB
  kText,        // of a REMARK: its range, with the quotes where it has them
  kExpression,  // expr: a comparison or the right side of an assignment
};

struct Operand {
  OperandKind kind = OperandKind::kError;
  Type type = Type::kUnknown;  // of what it gives or takes: kBit, kInteger, kFloat, kTimer, kCounter
  OperandRole role{};
  bool inverted = false;  // a named pin with '!'
  Address address;
  uint32_t bits = 0;
  SymbolId symbol;  // kAddress spelled by a symbol
  SectionId section;
  NetworkId network;
  ExprId expr;
  source::Range range;
};

/// P, M, N of CNUD and M of ROT. The parser has one entry for each pin of the block, in the table's order.
struct Pin {
  char name = ' ';
  bool from_stack = false;
  InstructionId result;  // from_stack: the instruction whose result it is
  Operand operand;       // else: a bit (perhaps inverted) or the constant 0 or 1, read when the block executes
  source::Range range;   // of "P=%I1"; empty when from the stack
};

enum class ExprKind : uint8_t {
  kError,
  kConstant,  // bits: int32 or the pattern of a binary32
  kAddress,   // address, symbol; a bit counts as the integer 0 or 1 (type kInteger)
  kNegate,    // left
  kMultiply,  // left, right: int32 with wrap when `type` is kInteger, else both converted to binary32
  kDivide,    // by zero: the dividend
  kAdd,
  kSubtract,
  kAnd,  // bitwise, integers only
  kOr,
  kGreater,  // left, right: type kBit; a comparison of binary32 when one side is kFloat
  kLess,
  kGreaterEqual,
  kLessEqual,
  kEqual,
  kNotEqual,
};

/// Children have smaller ids than their parent. At most 1,024 operands and 64 levels of parentheses: recursion is safe.
struct Expr {
  ExprKind kind = ExprKind::kError;
  Type type = Type::kUnknown;
  Address address;
  uint32_t bits = 0;
  SymbolId symbol;
  ExprId left, right;
  source::Range range;  // with its own parentheses
};

enum class InputKind : uint8_t { kNone, kRail, kResults };

struct Input {
  InputKind kind = InputKind::kNone;
  Span results;  // kResults: of Program::results, at least one; their OR
};

struct Instruction {
  Op op = Op::kRemark;
  bool unknown = false;                    // E101: no instruction at all
  bool faulty = false;                     // an error was reported here: nothing more is said about it
  TimerUnit unit = TimerUnit::kHundredMs;  // of TON, TOF, TP: written or of the mnemonic; never an operand
  NetworkId network;
  source::Range range;     // the statement without its comment; an element with its brackets
  source::Range mnemonic;  // as written; of an element of a drawing its opening bracket with the prefix
  Span operands;           // of Program::operands
  Span pins;               // of Program::pins
  Input input;
  InstructionId other;
  Span comments;  // of Program::comments: those above it, then its row comment
};

struct Network {
  uint32_t number = 0;
  bool has_label = false;  // written, not implied by its position
  bool is_drawing = false;
  bool is_stray = false;  // no NETWORK was written (reported)
  SectionId section;
  source::Range range;    // the line of NETWORK
  source::Range keyword;  // the word alone
  std::string comment;
  Span instructions;  // in the order of execution; the weight of 4.3 is WeightOf(program, id)
  Span comments;      // above NETWORK and on its line
};

enum class SectionKind : uint8_t { kFast, kSlow, kSubroutine, kNone };

/// FAST, SLOW or a SUB. kNone: instructions that stand outside of a section (reported).
struct Section {
  SectionKind kind = SectionKind::kNone;
  bool duplicate = false;  // reported: the first one is meant by every CALL
  uint32_t number = 0;     // of a SUB; kNoNumber when it could not be read
  source::Range range;     // the line of its keyword
  source::Range keyword;
  std::string name;  // the string after the keyword
  source::Range name_range;
  Span networks;      // of Program::networks
  Span comments;      // above the keyword and on its line
  Span end_comments;  // in front of END_x and on its line
};
constexpr uint32_t kNoNumber = 0xFFFFFFFF;

enum class CommentPlace : uint8_t { kAbove, kRow };

struct Comment {
  source::Range range;  // from ';' on, blanks at the end removed
  CommentPlace place = CommentPlace::kAbove;
};

/// A statement of several physical lines: its diagnostics stand in the first one (2.2).
struct Continuation {
  source::Range first;  // what the first line holds
  source::Range rest;   // from the second line on
};

struct TitleField {
  TitleKey key{};
  std::string text;
  source::Range range;
};

struct Symbol {
  std::string name;  // empty: the entry has a comment only
  Address address;
  std::string comment;
  source::Range range;  // the line; empty where the control predefines it
  source::Range name_range, comment_range;
  bool predefined = false;  // of signals.csv, option PREDEFINED
};

struct Alarm {
  uint32_t index = 0;  // of %Q400 + index
  Severity severity = Severity::kNotice;
  std::string text;
  source::Range range;
};

struct MCode {
  uint32_t number = 0;
  std::string text;
  source::Range range;
};

struct Program {
  std::vector<source::FileId> files;
  Settings settings;  // directives of the source, overruled by the command line
  bool faulty = false;
  std::vector<TitleField> title;
  support::Store<SymbolId, Symbol> symbols;  // in source order; with PREDEFINED=ON then all signals of the control
  std::vector<Alarm> alarms;
  std::vector<MCode> mcodes;
  support::Store<SectionId, Section> sections;  // in source order
  support::Store<NetworkId, Network> networks;
  support::Store<InstructionId, Instruction> instructions;
  std::vector<Operand> operands;
  std::vector<Pin> pins;
  std::vector<InstructionId> results;
  support::Store<ExprId, Expr> exprs;
  std::vector<Comment> comments;
  std::vector<Continuation> continuations;  // in source order
  uint32_t line_count = 0;
  uint32_t statement_count = 0;  // instructions and elements
};

/// The first FAST or SLOW section; not valid when there is none.
SectionId FindSection(const Program& program, SectionKind kind);
/// w(i) of 4.3: instructions without REMARK and RUNG, at least 1.
uint32_t WeightOf(const Program& program, NetworkId network);
/// "%I7", "%TM3.V", "%QW10": canonical, without leading zeros.
std::string ToText(const Address& address);
/// "SR4".
std::string SubroutineName(uint32_t number);

}  // namespace plcxx::host50
