// The typed IR: one program as a handful of vectors.
//
// After lowering nothing asks which dialect it was: what a control does around its partitions (latching the time,
// exchanging the image, counting cycles, storing retentive memory) is itself a routine of the program, so that the
// simulator executes it and the emitter prints it like any other.
//
// A value is the Inst that computes it. Regions are lists of Insts; If, Switch, Loop and Block own regions. A value
// may be used in its region after its definition and in regions nested there; values never cross a top-level
// statement. Jump and Label are legal between lowering and structuring only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/ir/memory.h"
#include "transpiler/ir/op.h"

namespace plcxx::ir {

using InstId = support::Id<struct InstTag>;
using ValueId = InstId;  // an instruction and the value it gives are one
using RegionId = support::Id<struct RegionTag>;
using RoutineId = support::Id<struct RoutineTag>;
using StatementId = support::Id<struct StatementTag>;
using HostFunctionId = support::Id<struct HostFunctionTag>;
using TextId = support::Id<struct TextTag>;
using SwitchId = support::Id<struct SwitchTag>;
using LoopId = support::Id<struct LoopTag>;
using CallId = support::Id<struct CallTag>;

/// One instruction. The words mean, by Shape of the operation:
///   kPure       a, b, c = operand values
///   kStep       payload = StateId; a, b, c = operand values
///   kConst      a, b = low and high half of the value (type says how many bits count); c = base of its spelling
///   kLoad       payload = PlaceId; a = index value when the place is indexed
///   kStore      payload = PlaceId; a = stored value; b = index value when the place is indexed
///   kText       payload = StateId of a TextFlag; a = StateId of the TextInbox; b = TextId
///   kStatement  payload = StatementId: what follows in this region, up to the next one, is that statement's
///   kIf         a = condition (bit); b = RegionId then; c = RegionId else, or none; payload = IfOrigin
///   kSwitch     payload = SwitchId; a = selector
///   kLoop       payload = LoopId; a = RegionId body (which ends with the condition's value, see Loop)
///   kBlock      a = RegionId body
///   kExit       payload = InstId of an enclosing Block or Loop; a = condition (bit), or none = always
///   kCall       payload = CallId (its routine and arguments)
///   kHostCall   payload = CallId (its host function and arguments)
///   kRepeat     payload = InstId of an enclosing Loop with a budget; a = condition (bit), or none = always;
///               b = RegionId: what happens instead of another round when nothing is left of the budget
///   kJump       payload = label number; a = condition (bit), or none = always; b of a backward jump as of kRepeat,
///               c = PlaceId of its budget
///   kLabel      payload = label number
struct Inst {
  OpKind op{};
  Type type = Type::kNone;
  source::Range range;
  uint32_t payload = support::Id<void>::kNone;
  uint32_t a = support::Id<void>::kNone;
  uint32_t b = support::Id<void>::kNone;
  uint32_t c = support::Id<void>::kNone;
};
static_assert(sizeof(Inst) == 28);

/// Where an If comes from, for the debugging of single statements: one that is switched off is skipped together with
/// the Ifs of its own, but it does not jump over other statements.
enum class IfOrigin : uint32_t {
  kJumps = 1,  // condition 1 was a jump: switched off, the condition counts as 0
  kStays = 2,  // condition 0 was a jump: switched off, the condition counts as 1
  kSource = support::Id<void>::kNone
};

struct Region {
  std::vector<InstId> insts;
};

/// Cases are tried by value; a case runs on into the next one where falls_through says so.
struct SwitchCase {
  std::vector<uint64_t> values;  // empty: default
  RegionId region;
  bool falls_through = false;
  std::vector<uint32_t> bases = {};  // of the values' spellings, as of kConst; of those beyond its end 10

  uint32_t Base(size_t value) const { return value < bases.size() ? bases[value] : 10; }
};
struct Switch {
  std::vector<SwitchCase> cases;
};

/// How a loop is known to end.
enum class LoopBound : uint8_t {
  kProven,  // at most `bound` rounds, shown by the front end
  kGuard,   // at most `bound` rounds for each entry, then the fault's host call and on after the loop
  /// The body runs once and is left at its end; only Repeat goes round. Each Repeat takes 1 from the budget, a place
  /// that several loops and routines may share; when that is 0 already, Repeat executes its own region and goes on
  /// after itself instead. Whoever begins to count stores the number of rounds into the place.
  kBudget
};
struct Loop {
  LoopBound kind = LoopBound::kProven;
  uint64_t bound = 0;  // kProven, kGuard
  PlaceId budget;      // kBudget only, an i32; such a loop has neither a condition nor a region `exhausted`
  RegionId condition;  // computed before each round; its last instruction is a bit. None: only Exit leaves
  RegionId body;
  RegionId step;       // after the body of each round: one store whose value needs no local; may be none
  RegionId exhausted;  // executed when the guard ends the loop; may be none
};

struct Call {
  RoutineId routine;    // kCall
  HostFunctionId host;  // kHostCall
  std::vector<ValueId> arguments;
  PlaceId out;  // kHostCall of a function that gives a second result: a place of lifetime kRoutine that receives it
  bool exchange = false;  // this call is part of the regular exchange, see HostFunction::routine_exchange
};

struct Parameter {
  std::string name;
  Type type = Type::kNone;
  std::vector<std::string> enumerators;  // not empty: the value is spelled as one of these, by index
  /// The value is the id of a statement; scenarios write it as "line", the number of the statement's line.
  bool is_statement = false;
};

/// What a host function gets beside its value parameters.
enum class HostAccess : uint8_t { kNone, kReadsState, kWritesState, kReadsRetentive, kWritesRetentive };

/// A function by which the scan reaches the control. Only those that are called are declared in generated code.
struct HostFunction {
  std::string name;  // "fault"
  std::vector<Parameter> parameters;
  Type result = Type::kNone;
  /// A second result, delivered into a last parameter "T& name"; none: name is empty. When the function does not give
  /// one, the place keeps its value.
  Parameter out;
  HostAccess access = HostAccess::kNone;
  /// Of kWritesState: all that it writes lies in this space; none: it may write whatever the control writes.
  SpaceId only_space;
  /// Part of the regular exchange (time, inputs, outputs, loading): not an event that scenarios list.
  bool routine_exchange = false;
  /// Called in every period while something stands (a request): an event, but scenarios need not list each call.
  bool polled = false;
  std::string comment;  // for the declaration in the generated header
};

enum class RoutineKind : uint8_t { kInit, kFast, kSlow, kInterrupt, kSubroutine, kSchedule };

struct Routine {
  std::string name;  // "init", "fast", "slow", "period"; a subroutine's name in the source
  RoutineKind kind = RoutineKind::kSubroutine;
  std::string comment;       // line by line
  std::string file_comment;  // at the head of the file that begins with it; none in front of the others of that file
  std::vector<Parameter> parameters;  // places of lifetime kRoutine, see parameter_places
  std::vector<PlaceId> parameter_places;
  Type result = Type::kNone;
  PlaceId result_place;
  /// A sliced routine runs as `slices` pieces: prologue before the first, epilogue after the last. The parameter
  /// "slice" selects the piece. Before CutSlices the whole body is one list; see passes/cut_slices.h.
  uint8_t slices = 1;
  bool sliced = false;
  RegionId prologue, body, epilogue;  // prologue and epilogue may be none
  bool simulation_only = false;       // generated code has it in the debug flavour only
};

/// One statement of the source, in the order of the source. Nothing here goes into generated code but texts.
struct Statement {
  source::Range range;                  // the whole statement
  std::vector<source::Range> comments;  // above it and after it, each one line
  std::string subject;                  // what it assigns or heads: "U4A8", "T5"; for names of chunks
  uint32_t id = 0;                      // from the statement's text and a count among equal texts: never a line number
  uint32_t line = 0;                    // where it stands, when run-time faults tell it; for scenarios only
  bool opens_block = false;             // head of a block: switched off it counts as a false condition
  bool closes_block = false;            // end of a block: its comments stand at the closing brace
};

/// A stretch of one bit per message, or a word that holds a number.
struct MessageBits {
  SpaceId space;
  uint32_t offset = 0;  // byte of the first bit; bits ascend from the least significant
  uint32_t first_number = 1;
  uint32_t count = 0;
};
struct MessageWord {
  PlaceId place;  // its value is the number of an active message; 0 is none
};
struct MessageText {
  uint32_t number = 0;
  uint32_t colour = 0;
  std::string text;  // UTF-8
};

/// Constants that a program declares for its control (M functions ...): generated code has them as an array of structs.
struct Table {
  std::string name;
  std::string comment;
  std::vector<Parameter> columns;  // a column of type kNone holds texts
  std::vector<uint64_t> cells;     // row by row; of a text its index in `texts`
  std::vector<std::string> texts;  // UTF-8

  uint64_t AddText(std::string text) {
    texts.push_back(std::move(text));
    return texts.size() - 1;
  }
};

/// A name of the source for data that need not be a place of the program: scenarios and reports reach every element.
struct Symbol {
  struct Index {
    uint32_t count = 0, stride = 0;  // elements, bytes from one to the next
  };
  std::string name;  // "axes[].speed"
  Type type = Type::kNone;
  SpaceId space;
  uint32_t offset = 0;         // where all indices are 0
  uint8_t bit = kNoBit;        // when type is kBit
  std::vector<Index> indices;  // one for each "[]"
  bool has_sign = false;       // people read the integer as two's complement
};

/// What is known of a place or instance beside its use: for maps and reports.
struct Documentation {
  std::string address;     // "U10K20"
  std::string symbols;     // names of the source, ", " between them
  std::string predefined;  // the control's own name of the signal, "RSPEPN"
  std::string meaning;     // in words
  std::string help;        // from the machine's own files
};

/// What the stepping of a simulation needs to know of the schedule.
struct Schedule {
  RoutineId init;
  RoutineId period;     // everything that one period of the control does
  RoutineId fast_only;  // `run: {fast: n}`
  /// Executed when time has passed without a period (the end of `run: {ms: n}`); none: nothing happens then.
  RoutineId elapse;
  bool elapses_every_ms = false;      // the same at every whole millisecond that is not a period's
  bool period_ends_its_time = false;  // the first period is at t = period_ms, each one at the end of its time
  uint32_t period_ms = 10;
  uint32_t slot_ms = 2;  // of each period, for the slow part; what automatic slicing divides by
  /// Not 0: `period` is the slow part alone, run every period_ms, and `fast_only` the fast part, run every fast_ms and
  /// before a slow part of the same time. `run: {slow: n}` and `run: {fast: n}` then are n of them, and no time passes.
  uint32_t fast_ms = 0;
  bool slices_by_cost = false;  // the number of slices is to be found from the cost model
  PlaceId slow_done;            // i32, counts completed slow cycles
  /// i32, counts the fast parts that were due; `run: {fast: n}` then is whole periods until n were. None: fast_only.
  PlaceId fast_done;
  /// The longest time that the program sets from one call of a part to the next, where that is not a period; 0: it is,
  /// or is not known before the program runs.
  uint32_t fast_every_ms = 0, slow_every_ms = 0;
  uint32_t most_periods = 1000;                    // that one part may wait for its turn
  HostFunctionId now;                              // the host function that gives the time in ms
  HostFunctionId retentive_load, retentive_store;  // none when the dialect has no retentive memory
  PlaceId retain_at_power_off;  // a bit: 1 = the host stores the retentive memory when power fails; none = always
  bool retention = false;
};

struct Program {
  std::string name = "program";
  std::string dialect;  // for maps and headings only

  support::Store<SpaceId, Space> spaces;
  support::Store<PlaceId, Place> places;
  support::Store<StateId, StateInstance> states;
  support::Store<HostFunctionId, HostFunction> host_functions;
  support::Store<TextId, std::string> texts;
  support::Store<RoutineId, Routine> routines;
  support::Store<InstId, Inst> insts;
  support::Store<RegionId, Region> regions;
  support::Store<SwitchId, Switch> switches;
  support::Store<LoopId, Loop> loops;
  support::Store<CallId, Call> calls;
  support::Store<StatementId, Statement> statements;

  Schedule schedule;
  StateId text_inbox;  // where the operator's texts arrive; none when the program compares none
  source::Encoding text_encoding = source::Encoding::kUtf8;  // of messages and menu texts in generated code
  std::vector<MessageText> messages;
  std::vector<MessageText> menu_texts;
  std::vector<MessageBits> message_bits;
  std::vector<MessageWord> message_words;
  std::vector<Table> tables;
  std::vector<Symbol> symbols;
  std::vector<Documentation> documentation;  // ascending by address as the dialect orders them

  const Inst& operator[](InstId id) const { return insts[id]; }
  Inst& operator[](InstId id) { return insts[id]; }
};

constexpr uint64_t ConstantValue(const Inst& inst) { return (static_cast<uint64_t>(inst.b) << 32) | inst.a; }

}  // namespace plcxx::ir
