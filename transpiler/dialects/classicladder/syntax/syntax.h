// The syntax tree of a ClassicLadder project: what its parts declare, by number, each with its place.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/dialects/classicladder/machine/machine.h"
#include "transpiler/source/source.h"

namespace plcxx::classicladder {

/// A variable, or one at the number plus the value of another one: `%W0[%W9]`.
struct Variable {
  Address address;
  std::optional<Address> index;
  source::Range range;
};

struct Element {
  ElementKind kind = ElementKind::kFree;
  bool joined_above = false;  // its left side, with that of the element above it
  Variable variable;          // of contacts and coils
  uint32_t number = 0;        // of the timer, counter, expression, rung, subroutine
  source::Range range;
};

struct Rung {
  uint32_t number = 0;
  std::string_view label;
  source::Range label_range, comment_range;  // empty: none
  int32_t next = 0;
  std::array<std::array<Element, kRungWidth>, kRungHeight> rows;  // as they are written: row, column
  std::vector<source::Range> lines;                               // of the rows
  source::Range range;                                            // the name of its part
  const Element& At(uint32_t x, uint32_t y) const { return rows[y][x]; }
};

enum class Language : uint8_t { kLadder, kSequential };
struct Section {
  uint32_t number = 0;
  std::string name;
  Language language{};
  int32_t subroutine = -1;  // -1: a main section
  uint32_t first_rung = 0, last_rung = 0, page = 0;
  source::Range range;
  bool is_main() const { return subroutine == -1; }
};

enum class TimerMode : uint8_t { kOn, kOff, kPulse };
/// A timer, monostable, IEC timer or counter: what its line says.
struct Preset {
  uint32_t base_ms = 1000;  // not of counters
  int32_t preset = 0;       // in its base
  TimerMode mode{};         // of IEC timers
  source::Range range;
};

struct Step {
  bool initial = false;
  uint32_t number = 0;  // of its variables
  int32_t page = -1;
  source::Range range;
};
struct Transition {
  std::vector<uint32_t> activates, deactivates;  // steps
  int32_t page = -1;
  Variable condition{.address = {VariableKind::kBit, 0}, .index = {}, .range = {}};
  source::Range range;
};

struct Symbol {
  Address address;     // of a timer or counter as a whole: one of its variables
  bool whole = false;  // "%T0": no attribute
  std::string name, comment;
};

/// Read when an element uses it: by itself it is neither a comparison nor an assignment.
struct ExpressionText {
  std::string_view text;
  source::Range range;
  bool faulty = false;  // reported: not to be read
};

enum class ExprKind : uint8_t {
  kConstant,
  kVariable,
  kNot,
  kPower,
  kMultiply,
  kDivide,
  kModulo,
  kAdd,
  kSubtract,
  kAnd,
  kOr,
  kAbs,
  kMinimum,
  kMaximum,
  kAverage,
};
/// A node; its operands are nodes of the same expression with smaller numbers.
struct ExprNode {
  ExprKind kind{};
  uint32_t value = 0;  // of a constant, its bits
  Variable variable;
  std::vector<uint32_t> operands;
  source::Range range;
};
enum class Relation : uint8_t { kEqual, kNotEqual, kLess, kLessEqual, kGreater, kGreaterEqual };
struct Expression {
  std::vector<ExprNode> nodes;
  Variable target;  // of an operate box
  Relation relation{};
  uint32_t left = 0, right = 0;  // of a comparison; of an operate box: right
  bool empty = false;            // no text, or a comment: a comparison is 0, an operate box does nothing
};

struct Program {
  Sizes sizes;
  std::map<uint32_t, Rung> rungs;
  std::map<uint32_t, Section> sections;
  std::map<uint32_t, Preset> timers, monostables, timers_iec, counters;
  std::map<uint32_t, ExpressionText> expressions;
  std::map<uint32_t, Expression> comparisons, operations;  // by expression: those that elements use
  std::map<uint32_t, Step> steps;
  std::map<uint32_t, Transition> transitions;
  std::vector<Symbol> symbols;
  uint32_t line_count = 0, element_count = 0;
};

/// The rungs of a ladder section in the order of their execution without jumps; whole in a program without errors.
std::vector<uint32_t> ChainOf(const Program& program, const Section& section);
/// The section that a call of this number executes.
const Section* SubroutineOf(const Program& program, uint32_t number);

}  // namespace plcxx::classicladder
