// The typed syntax tree of dialect hnc: flat stores with typed ids, in source order.
//
// The parser has resolved every name, computed every layout (specification 5.6), made every conversion a node of its
// own and folded what is constant; lowering needs nothing of the front end after the parser. All ranges are places in
// the files as the user wrote them; what comes from a macro has the range of the macro's use.
// A tree is always whole: what could not be understood is an expression of kind kPoison or is left out, and its fault
// has been reported. Children of an expression have smaller ids than their parent; nesting is at most 127 deep in
// blocks and in parentheses, but a chain `a + b + c + ...` nests on its left side without limit: do not recurse there.
//
// Reported by the front end: everything of 10.2 up to E024, E030, E035 to E045, E048, E053, E054, E055, E058, E059,
// E050 for declarations (pointers in aggregates, pointers to pointers), W18 and W22. Left to lowering: what needs the
// flow of the program (E020 excepted, all of E031 to E034, E046, E047, E049 to E052, E056, E057) and the other
// warnings.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/hnc/machine/control_names.h"
#include "transpiler/source/source.h"
#include "transpiler/support/ids.h"
#include "transpiler/support/rare_list.h"

namespace plcxx::hnc {

using TypeId = support::Id<struct TypeTag>;
using RecordId = support::Id<struct RecordTag>;
using VariableId = support::Id<struct VariableTag>;
using FunctionId = support::Id<struct FunctionTag>;
using LabelId = support::Id<struct LabelTag>;
using ExprId = support::Id<struct ExprTag>;
using StatementId = support::Id<struct SourceStatementTag>;
using MacroId = support::Id<struct MacroTag>;
using MacroUseId = support::Id<struct MacroUseTag>;

// --- types ------------------------------------------------------------------------------------------------

enum class TypeKind : uint8_t {
  kVoid,
  kInteger,  // char, short, int, long, enum and bit-fields' types: bits 8, 16 or 32
  kReal,     // float, double: bits 32 or 64
  kPointer,  // element
  kArray,    // element, count
  kRecord,   // record
  kFunction  // only as the type of a function's name, which set_mst_func takes
};

/// Types are stored once: equal ids are equal types. Qualifiers are no part of a type; enumerations are int, `short` is
/// int, plain char is the type of its sign.
struct Type {
  TypeKind kind = TypeKind::kVoid;
  uint8_t bits = 0;        // kInteger, kReal
  bool is_signed = false;  // kInteger
  TypeId element;          // kPointer, kArray
  uint32_t count = 0;      // kArray: elements; 0 where the size is not known (system areas, parameters never)
  RecordId record;         // kRecord
  uint32_t size = 0;       // bytes; 2 for pointers, 0 for void, functions and arrays of unknown size
  std::string text;        // as C writes it: "unsigned int", "struct axis", "int [4]"
};

struct Member {
  std::string name;  // empty: an unnamed bit-field or an unnamed struct or union
  TypeId type;
  uint32_t offset = 0;  // byte from the record's beginning; for a bit-field that of its unit
  bool is_bit_field = false;
  uint8_t bit_offset = 0;  // of a bit-field, from bit 0 of its unit upwards
  uint8_t bit_width = 0;   // of a bit-field; `type` is the declared type, whose size is that of the unit
  source::Range range;     // the name
};

struct Record {
  std::string name;  // the tag, or the typedef's name; empty: none
  bool is_union = false;
  std::vector<Member> members;
  uint32_t size = 0;  // bytes; no padding (5.6)
  source::Range range;
};

// --- the control's own names --------------------------------------------------------------------------------

/// What a name of the system header is bound to (9.2). `table`: F_T and G_T, whose elements are addresses.
struct SystemView {
  Area area = Area::kX;
  bool table = false;
  TypeId element;      // of the view; of a table: what its pointers point to
  uint32_t count = 0;  // elements (5.2); of a table 256
};

// --- declarations -------------------------------------------------------------------------------------------

enum class Storage : uint8_t {
  kGlobal,       // of the program, with external or internal linkage
  kStaticLocal,  // static inside a function
  kAutomatic,    // local; 0 at each entry of the function where nothing initialises it (5.6)
  kParameter,
  kSystem,     // `view` says which cells
  kPlc1Time,   // the period variables; `initial` holds the program's initialiser
  kPlc2Time,   //
  kUndefined,  // declared extern only and never defined: no expression that lowering sees names it (E059)
};

/// One scalar of an initialiser, or one array of char that a string fills. Elements come in the order of the source,
/// with rising offsets except for unions; bytes that nothing initialises are 0.
struct InitialValue {
  uint32_t offset = 0;  // byte in the variable
  bool is_bit_field = false;
  uint8_t bit_offset = 0, bit_width = 0;
  TypeId type;   // of the part
  ExprId value;  // already converted to `type`; a kString of array type for an array of char; a record's value
};

struct Variable {
  std::string name;
  TypeId type;
  Storage storage = Storage::kGlobal;
  bool is_static = false;    // file level: internal linkage
  bool is_const = false;     // nothing may store into it
  bool is_register = false;  // its address is never taken
  bool initialised = false;  // `initial` holds all of it, the rest is 0
  FunctionId function;       // kStaticLocal, kAutomatic, kParameter: whose
  std::vector<InitialValue> initial;
  std::optional<SystemView> view;  // kSystem
  source::Range range;             // the name in the definition, or in the first declaration
};

struct Label {
  std::string name;
  source::Range range;
  StatementId statement;
  bool used = false;
};

struct Function {
  std::string name;
  TypeId result;
  std::vector<VariableId> parameters;
  std::vector<TypeId> parameter_types;  // also of functions that the product supplies
  std::vector<VariableId> locals;       // automatic and static, in the order of their declarations
  std::vector<LabelId> labels;
  bool is_static = false;
  bool is_defined = false;
  bool has_prototype = false;            // else K&R: arguments come promoted (6.4)
  std::string clang_differs;             // why Clang's own code is no measure of it; empty: it is one
  std::optional<SystemFunction> system;  // supplied by the product, not by the program
  StatementId body;                      // a kCompound, where defined
  source::Range range;                   // the name in the definition
  source::Range head;                    // definition: from its first word to the closing parenthesis or K&R names
};

// --- expressions --------------------------------------------------------------------------------------------

enum class ExprKind : uint8_t {
  kPoison,          // already reported
  kConstant,        // `constant`
  kString,          // bytes: Unit::strings[string], of array type with the closing 0; an lvalue
  kVariable,        // variable; an lvalue
  kFunction,        // function: its name as an argument of set_mst_func; of pointer type
  kLoad,            // a: the value of an lvalue
  kDecay,           // a: an array lvalue as the address of its first element
  kConvert,         // a: number to another type of number (6.1)
  kCast,            // a: pointer to another type of pointer, the same address
  kNull,            // the constant 0 as a pointer
  kUnary,           // unary, a
  kBinary,          // binary, a, b: both already of the common type; shifts and pointers see BinaryOp
  kAnd,             // a && b: int 0 or 1
  kOr,              // a || b
  kConditional,     // a ? b : c
  kComma,           // a, b
  kAssign,          // a = b; b already of a's type; the value is that of a after the store
  kCompoundAssign,  // a op= b: a is converted to `computation`, b already has its type, the result is converted back
  kIncrement,       // increment, a; a pointer moves by one element
  kAddress,         // &a
  kDereference,     // *a: an lvalue
  kIndex,           // a[b]: an lvalue; a is an array lvalue or a pointer, b an integer of any width
  kMember,          // a.member: an lvalue where a is one; a is a record (-> is kMember of kDereference)
  kCall,            // function, arguments
};

enum class UnaryOp : uint8_t { kPlus, kMinus, kComplement, kNot };

enum class BinaryOp : uint8_t {
#define HNC_BINARY(Key, ...) k##Key,
#include "transpiler/dialects/hnc/syntax/binary_operators.def"
};

/// kOrder: < > <= >=; kEquality: == and !=.
enum class BinaryFamily : uint8_t { kArithmetic, kShift, kBitwise, kOrder, kEquality, kPointer };

struct BinaryInfo {
  std::string_view sign;     // in C
  std::string_view printed;  // by `print syntax`: "p+" adds to a pointer
  BinaryFamily family = BinaryFamily::kArithmetic;
};

constexpr BinaryInfo Info(BinaryOp op) {
  constexpr BinaryInfo kBinaryRows[] = {
#define HNC_BINARY(Key, Sign, Printed, Family) {Sign, Printed, BinaryFamily::k##Family},
#include "transpiler/dialects/hnc/syntax/binary_operators.def"
  };
  return kBinaryRows[static_cast<size_t>(op)];
}

constexpr bool IsComparison(BinaryOp op) {
  return Info(op).family == BinaryFamily::kOrder || Info(op).family == BinaryFamily::kEquality;
}

enum class IncrementOp : uint8_t { kPreIncrement, kPreDecrement, kPostIncrement, kPostDecrement };

/// The value of a constant expression in its own type.
struct Constant {
  int64_t integer = 0;  // kInteger: sign- or zero-extended as the type says
  double real = 0;      // kReal
  bool operator==(const Constant&) const = default;
};

struct Expr {
  ExprKind kind = ExprKind::kPoison;
  UnaryOp unary = UnaryOp::kPlus;
  BinaryOp binary = BinaryOp::kAdd;
  IncrementOp increment = IncrementOp::kPreIncrement;
  bool is_lvalue = false;
  bool is_implicit = false;    // a conversion that the program does not write
  bool parenthesized = false;  // stands in parentheses of its own, of the program or of a macro
  bool whole_macro = false;    // it is the complete text of `macro`
  TypeId type;
  TypeId computation;   // kCompoundAssign
  source::Range range;  // with its own parentheses; in a macro: the place of use
  source::Range op;     // the operator's sign, where there is one
  ExprId a, b, c;
  MacroUseId macro;                     // the outermost macro use that wrote a part of it; none: written directly
  support::RareList<ExprId> arguments;  // kCall, left to right, converted as 6.1 and 6.4 say
  VariableId variable;
  FunctionId function;
  uint32_t member = 0;  // kMember: index into Record::members
  uint32_t string = 0;  // kString: index into Unit::strings
  /// Folded by the rules of 6.2; also of kConvert and operators. None where a division by zero stands in it.
  std::optional<Constant> constant;
};

// --- statements ---------------------------------------------------------------------------------------------

enum class StatementKind : uint8_t {
  kCompound,     // body
  kDeclaration,  // variables: those declared here, in order; automatic ones take their initialisers here
  kExpression,   // expression
  kEmpty,
  kIf,      // expression, then, otherwise
  kSwitch,  // expression (promoted selector), then
  kWhile,   // expression, then
  kDo,      // then, expression
  kFor,     // first, expression, step (each may be none), then
  kGoto,    // label
  kContinue,
  kBreak,
  kReturn,         // expression, or none; already of the function's type
  kLabel,          // label, then
  kCase,           // value, then
  kDefault,        // then
  kCriticalEnter,  // asm cli; also disable()
  kCriticalLeave,  // asm sti; also enable()
};

struct LoopBound {
  uint32_t rounds = 0;  // 1..65535
  source::Range range;  // of the annotation
};

struct Statement {
  StatementKind kind = StatementKind::kEmpty;
  ExprId expression, first, step;
  StatementId then, otherwise;
  std::vector<StatementId> body;
  std::vector<VariableId> variables;
  LabelId label;
  int64_t value = 0;       // kCase: converted to the selector's promoted type
  ExprId case_expression;  // kCase: as written, with its value before the conversion
  source::Range range;     // all of it, with the `;`; in a macro: the place of use
  source::Range head;      // if, switch, while, for: keyword to `)`; do: the keyword; label and case: to the `:`;
                           // compound: the `{`; else as `range`
  source::Range keyword;   // the first word
  source::Range close;     // compound: the `}`; do: `while (...)`
  source::Range otherwise_keyword;      // `else`
  std::optional<LoopBound> loop_bound;  // 6.6; loops, and labels of goto loops
  MacroUseId macro;                     // as in Expr
};

// --- macros and comments ------------------------------------------------------------------------------------

struct Macro {
  std::string name;
  bool has_parameters = false;
  bool is_system = false;  // of a header that the product supplies
  source::Range range;     // the name in its #define; no place for the product's own
};

struct MacroUse {
  MacroId macro;
  source::Range range;  // with the arguments
};

/// One comment with its marks. `text` has no marks and no decoration of the left edge; several lines keep their ends.
struct Comment {
  source::Range range;
  std::string text;
};

// --- the program --------------------------------------------------------------------------------------------

struct Unit {
  support::Store<TypeId, Type> types;
  support::Store<RecordId, Record> records;
  support::Store<VariableId, Variable> variables;  // file level and static ones in the order of their declarations
  support::Store<FunctionId, Function> functions;  // in the order of their first declarations
  support::Store<LabelId, Label> labels;
  support::Store<ExprId, Expr> expressions;
  support::Store<StatementId, Statement> statements;
  support::Store<MacroId, Macro> macros;  // those of the program, and those of the product that it uses
  support::Store<MacroUseId, MacroUse> macro_uses;
  std::vector<std::string> strings;     // bytes of literals in the source's encoding, with the closing 0
  std::vector<Comment> comments;        // by place; those in groups that #if left out are not here
  std::vector<FunctionId> definitions;  // functions with bodies in the order of their definitions
  FunctionId init, plc1, plc2;          // none: missing, reported
  source::Range last_token;
  bool char_is_signed = true;
  uint32_t line_count = 0;       // of all files of the program
  uint32_t statement_count = 0;  // that a program writes: no blocks, no empty ones
  bool faulty = false;           // errors were reported: not to be lowered to a program that runs

  const Type& TypeOf(ExprId expr) const { return types[expressions[expr].type]; }
};

/// The comments that begin in [begin, end), by place.
std::vector<const Comment*> CommentsIn(const Unit& unit, source::Range range);
/// The comments directly in front of a statement at `place` (only white space in between), by place; a comment that
/// shares its line with code before it belongs to that code.
std::vector<const Comment*> CommentsBefore(const Unit& unit, const source::SourceManager& sources,
                                           source::Offset place);
/// Those at the head of a file that are about all of it: an empty line or a directive follows.
std::vector<const Comment*> CommentsAtHead(const Unit& unit, const source::SourceManager& sources, source::FileId file);
/// The comment after `place` on the same line; none when there is none.
const Comment* CommentBehind(const Unit& unit, const source::SourceManager& sources, source::Offset place);

inline bool IsInteger(const Type& type) { return type.kind == TypeKind::kInteger; }
inline bool IsArithmetic(const Type& type) { return IsInteger(type) || type.kind == TypeKind::kReal; }
inline bool IsScalar(const Type& type) { return IsArithmetic(type) || type.kind == TypeKind::kPointer; }

}  // namespace plcxx::hnc
