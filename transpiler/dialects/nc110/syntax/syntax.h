// The syntax tree of dialect nc110: flat stores with typed ids, in source order.
//
// The parser has decoded every operand, resolved every symbol, matched every block with its end and linked
// the chains; lowering reads `items` from first to last. A tree is always whole: what could not be read is an
// expression of kind kError, an operand of kind kNone or an item of kind kError, and its fault has been reported.
// Children of an expression have smaller ids than their parent. Depth: an expression has at most 1,024 operands
// and 32 levels of parentheses, chains of NOT are folded, so recursion over expressions is safe.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/nc110/machine/operands.h"
#include "transpiler/source/source.h"
#include "transpiler/support/ids.h"

namespace plcxx::nc110 {

using ItemId = support::Id<struct ItemTag>;
using ExprId = support::Id<struct ExprTag>;
using AssignmentId = support::Id<struct AssignmentTag>;
using BlockId = support::Id<struct BlockTag>;
using BlockEndId = support::Id<struct BlockEndTag>;
using MessageId = support::Id<struct MessageTag>;
using SymbolId = support::Id<struct SymbolTag>;
using LiteralId = support::Id<struct LiteralTag>;
using MuxId = support::Id<struct MuxTag>;

/// One mention of an operand in the source; `symbol` is valid where it was spelled by a symbolic name.
struct OperandUse {
  Operand operand;
  SymbolId symbol;
  source::Range range;
};

enum class ExprKind : uint8_t {
  kError,     // already reported
  kOperand,   // operand, symbol
  kConstant,  // value: 0..255 as a word, 0 or 1 as a signal
  kAscii,     // literal; a signal
  kNot,       // left; complement of a bit or of 8 bits, by `type` (as the following three)
  kAnd,       // left, right
  kOr,
  kXor,
  kAdd,  // left, right: 8-bit arithmetic
  kSubtract,
  kLess,  // left, right: unsigned comparison of two words, gives a signal
  kEqual,
  kGreater,
// left: word functions
#define PLCXX_WORD_FUNCTION(Kind, ...) k##Kind,
#include "transpiler/dialects/nc110/machine/functions.def"
  kSgn,  // left: a signal
};

struct Expr {
  ExprKind kind = ExprKind::kError;
  Type type = Type::kUnknown;
  uint8_t value = 0;    // kConstant
  source::Range range;  // with its own parentheses or brackets
  Operand operand;      // kOperand
  ExprId left, right;
  SymbolId symbol;    // kOperand spelled by a symbol
  LiteralId literal;  // kAscii
};

/// A distinct ASCII literal; equal texts share one.
struct Literal {
  source::Range range;  // the first use, without the quotes
};

struct MuxInput {
  ExprId word;
  ExprId selector;
};

struct Mux {
  uint32_t first = 0;  // into Program::mux_inputs
  uint32_t count = 0;  // 0 where a fault was reported
  source::Range range;
};

struct Assignment {
  OperandUse target;
  bool inverted = false;  // "/U1K0=..."
  ExprId parameter;       // TnI(...), CnI(...): kConstant, kOperand (a word: the low byte of the pair) or kError
  ExprId value;           // not valid where `mux` is
  MuxId mux;
};

enum class BlockKind : uint8_t { kDof, kDoe, kDow };

struct Block {
  BlockKind kind = BlockKind::kDof;
  uint8_t level = 1;         // 1 = outermost
  bool unreachable = false;  // a DOE after an unconditional DOE
  source::Range keyword;
  source::Range name;  // empty where none is written
  ExprId condition;    // not valid: an unconditional DOE
  ItemId head;
  ItemId end;              // not valid: never closed (reported)
  BlockId parent;          // the enclosing block
  BlockId previous, next;  // the neighbours in its DOF/DOE chain
};

struct BlockEnd {
  BlockId block;  // not valid: END without a block (reported)
  BlockKind kind = BlockKind::kDof;
  source::Range name;
};

/// MSG n text (legacy): fills the message table, generates no code.
struct Message {
  uint16_t number = 0;  // 1..255; 0 where a fault was reported
  source::Range text;   // without quotes
};

struct Symbol {
  std::string name;  // as defined; the first 10 characters are significant
  Operand operand;
  source::Range range;    // the name in its definition
  source::Range comment;  // the comment on its line with ';', or empty
};

enum class ItemKind : uint8_t { kError, kCycleMark, kAssignment, kBlockHead, kBlockEnd, kMessage };

struct Item {
  ItemKind kind = ItemKind::kError;
  bool faulty = false;         // an error was reported inside: say nothing more about it
  uint32_t first_comment = 0;  // comments[first_comment ...]: leading, inside and trailing ones, in order
  uint32_t comment_count = 0;
  source::Range range;           // first to last token; a head up to the end of its condition; '$' without its remark
  uint32_t detail = 0xFFFFFFFF;  // index into the store of its kind

  AssignmentId assignment() const { return AssignmentId(detail); }
  BlockId block() const { return BlockId(detail); }
  BlockEndId block_end() const { return BlockEndId(detail); }
  MessageId message() const { return MessageId(detail); }
};

enum class CommentPlace : uint8_t {
  kHeader,    // before the first item of a file, and a blank line follows: belongs to the file
  kLeading,   // between the previous item and its own
  kInside,    // between two tokens of its item
  kTrailing,  // on the last line of its item; also the remark after '$'
  kRest,      // after the last item of a file
};

struct Comment {
  source::Range range;  // from ';' (or the first character of a remark) to the line end, blanks at the end removed
  CommentPlace place = CommentPlace::kLeading;
  bool blank_line_before = false;
};

struct Span {
  uint32_t first = 0;
  uint32_t count = 0;
};

struct SourceFile {
  source::FileId file;
  bool is_symbol_file = false;
  uint32_t line_count = 0;
  Span items;
  Span header;  // comments
  Span rest;    // comments
};

struct Program {
  std::vector<SourceFile> files;
  support::Store<ItemId, Item> items;
  support::Store<AssignmentId, Assignment> assignments;
  support::Store<BlockId, Block> blocks;
  support::Store<BlockEndId, BlockEnd> block_ends;
  support::Store<MessageId, Message> messages;
  support::Store<ExprId, Expr> exprs;
  support::Store<MuxId, Mux> muxes;
  std::vector<MuxInput> mux_inputs;
  support::Store<LiteralId, Literal> literals;
  support::Store<SymbolId, Symbol> symbols;  // in the order of definition
  std::vector<Comment> comments;
  ItemId first_cycle_mark;       // items before it are the fast part; not valid: everything is fast
  uint32_t line_count = 0;       // of all files
  uint32_t statement_count = 0;  // assignments, block heads and ends, MSG; not '$'
};

}  // namespace plcxx::nc110
