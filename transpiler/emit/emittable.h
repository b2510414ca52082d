// The program as the C++ printer takes it: every decision made, nothing spelled.
//
// Legalize (legalize/) chooses names, storage, which values become named locals, and the chunks and files that the
// statements go into; the printer (print/) only spells. Chunk borders are content-defined (they depend on the
// statements' own texts), so that an inserted statement does not move the borders after it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "transpiler/emit/layout/layout.h"
#include "transpiler/ir/program.h"

namespace plcxx::emit {

/// Debug carries force masks and line enables; release carries none of it. The statements' text is the same.
enum class Flavour : uint8_t { kRelease, kDebug };

struct EmitOptions {
  std::string name = "program";  // of the files and, made safe, of the namespace
  Flavour flavour = Flavour::kRelease;
  /// The release flavour with the routines that only a simulation calls; the debug flavour always has them.
  bool simulated = false;
  bool line_directives = false;
  /// Files of the program's code, kMostParts at most; 0: as many as its size asks for, named by their content. A fixed
  /// number is for build systems that have to know their outputs before: name.cpp, name_2.cpp, ... name_N.cpp.
  uint32_t parts = 0;
  /// By PlaceId: both parts use it, and the fast part may interrupt the slow part (plcxx emit --preemptive). Empty:
  /// none.
  std::vector<bool> shared;
};
inline constexpr uint32_t kMostParts = 64;

/// How the text of its function says what an instruction does.
enum class Form : uint8_t {
  kNowhere,  // not at all: a value that nothing asks for, a way out that leads to what follows anyway
  kInside,   // inside the line of what uses it; of an instruction with an effect there is one such line
  kLocal,    // a named const on a line of its own
  kLine,     // lines of its own
};

/// What a function gets from its caller; what its text does not use has no name in its head.
struct Parameter {
  std::string type;  // "bool&"
  std::string name;
  bool used = false;
};

/// The named locals of a function, each list in the order of the places.
struct Locals {
  struct Declared {
    ir::PlaceId place;
    bool read = false;      // a compiler would report a local that is only written
    ir::InstId first = {};  // the store that gives it its first value; none: 0
  };
  std::vector<Declared> declared;     // of its own
  std::vector<ir::PlaceId> shared;    // of its caller, by reference
  std::vector<ir::PlaceId> values;    // parameters, by value
  std::vector<Parameter> parameters;  // all that the function gets, in the order of its head
};

/// A function of its own for a stretch of statements: small functions compile in linear time and stay in cache.
struct Chunk {
  std::string name;
  ir::RegionId region;
  uint32_t begin = 0, end = 0;  // indices into the region's instructions
  uint32_t part = 0;            // index into Emittable::parts
  uint32_t statements = 0;      // nested ones included
  uint32_t parent = kNoParent;  // the chunk that calls it; none: its routine does
  ir::RoutineId routine;        // what it was cut out of
  uint32_t last_id = 0;         // of its last statement; 0: none
  Locals locals;

  static constexpr uint32_t kNoParent = 0xFFFFFFFF;
};

/// One generated .cpp file; part 0 holds the partitions themselves.
struct Part {
  std::string suffix;             // "" or "_slow_U4A8": the file is <name><suffix>.cpp
  std::vector<bool> called = {};  // by RoutineId: subroutines that its functions call
};

/// Chunks of one file that a partition in part 0 calls directly after each other, by one function.
struct ChunkRun {
  std::string name;
  uint32_t part = 0;
  std::vector<uint32_t> chunks;
  Locals locals;
};

/// How an Exit or a Repeat gets to where it goes.
enum class Leave : uint8_t { kFallsThrough, kReturn, kBreak, kContinue, kGoto };

/// What a Block or Loop has beside its body.
struct Landing {
  std::string behind;              // label after it; empty: nothing goes there by goto
  std::string again;               // label at a loop's head, likewise
  std::string counter;             // local that counts the iterations of a guarded loop
  bool braces = false;             // of a block: around locals that a goto would jump over
  bool condition_in_head = false;  // of a loop: all of the condition is one expression
  bool ends_with_break = false;    // of a loop that only Repeat repeats: its body's end is reached
};

/// How an If's else arm is written.
struct ElseArm {
  enum class Kind : uint8_t {
    kNone,    // there is none, or nothing in it
    kBlock,   // else { ... }
    kBehind,  // none: the other arm leaves by `leave`, and the text of this one follows the If
    kIf,      // else if (...) { ... }: `chained` goes on with the chain
    kAlways,  // else { ... }: the arms of `chained`, whose condition is constant
  };
  Kind kind = Kind::kNone;
  ir::InstId chained;                  // of kIf and kAlways: the arm's own If
  ir::StatementId statement;           // whose comments are between; none: "} else if" on one line
  Leave leave = Leave::kFallsThrough;  // of kBehind: the last line of the first arm; kFallsThrough: it has left before
};

/// What follows the text of a switch's arm.
enum class ArmEnd : uint8_t { kBreak, kFallsThrough, kLeaves };

/// How the text of an operation differs from its row in the table of operations.
enum class Wording : uint8_t {
  kTable,       // it does not
  kFunction,    // of a comparison whose outcome compilers see, and report: a call of its function
  kComplement,  // of a negation: the comparison that it negates, with the opposite sign
  kDiscard,     // of a store that gives a local its own value: no assignment, which compilers report
  kNegative,    // of a constant: Minus32 of its complement, "Minus32(1)"
  kSubtract,    // of an addition of such a constant: a subtraction of the complement
};

/// The debug flavour: instructions [begin, end) of a list are text inside of `if (m.on(statement)) {`.
struct Guard {
  uint32_t begin = 0, end = 0;
  ir::StatementId statement;
};

/// The debug flavour: how the text of an instruction asks itself whether its statement is switched on.
struct Switch {
  enum class Joint : uint8_t {
    kAnd,        // m.on(1) & condition: both are always computed
    kOnlyIfOn,   // m.on(1) && condition
    kUnlessOff,  // !m.on(1) || condition
    kValue,      // m.on(1) ? value : bool{}
    kLoop,       // in the head as kAnd; else on a line of its own before the condition's
  };
  Joint joint = Joint::kAnd;
  ir::StatementId statement;
};

struct Emittable {
  const ir::Program* program = nullptr;
  EmitOptions options;
  layout::Layout layout;
  std::string namespace_name;
  std::vector<std::string> place_names;    // by PlaceId; empty: nothing uses it
  std::vector<std::string> state_names;    // by StateId
  std::vector<std::string> routine_names;  // by RoutineId
  /// By Storage (of arrays that are not retentive) and index: the name of the element. Of a stretch the first byte
  /// always has one.
  std::map<std::pair<layout::Storage, uint32_t>, std::string> element_names;
  std::vector<Form> forms;               // by InstId
  std::vector<bool> changes_nothing;     // by InstId: an effect that would do nothing where it is; it has no text
  std::vector<Wording> wordings;         // by InstId
  std::vector<std::string> value_names;  // by InstId: of those of Form::kLocal
  std::vector<Locals> routine_locals;    // by RoutineId
  std::vector<Chunk> chunks;             // nested ones before the ones that call them
  /// By RegionId: what of the region was cut out, ascending; the rest is printed in place.
  std::vector<std::vector<uint32_t>> region_chunks;
  std::vector<Part> parts;
  std::vector<uint32_t> routine_parts;  // by RoutineId: index into `parts`; other than 0 for subroutines only
  std::vector<ChunkRun> runs;
  std::unordered_map<uint32_t, Leave> leaves;  // by InstId, of every Exit and Repeat
  /// By InstId, of an If whose first arm ends in a jump of the source to where the function, iteration or switch arm
  /// ends: the word for it.
  std::unordered_map<uint32_t, Leave> early_leaves;
  /// By InstId, of those of Form::kLocal that a goto jumps over where brackets would be too deep: not initialized where
  /// they are declared.
  std::unordered_set<uint32_t> loose_locals;
  std::unordered_map<uint32_t, Landing> landings;   // by InstId, of all loops, and of blocks that have anything
  std::unordered_map<uint32_t, ElseArm> else_arms;  // by InstId, of every If that has text
  /// By InstId, of stores of a result: they are `return value;`, and so is this Exit, if any, that follows.
  std::unordered_map<uint32_t, ir::InstId> returns;
  std::vector<bool> returns_at_end;  // by RoutineId: the text's end is reached, and returns the result's variable
  std::vector<std::vector<ArmEnd>> arm_ends;      // by SwitchId, in the order of its cases
  std::vector<std::vector<Guard>> guards;         // by RegionId, ascending; of the debug flavour
  std::unordered_map<uint32_t, Switch> switches;  // by InstId, likewise
  std::vector<std::string> functions;             // of runtime_support that expressions call, sorted
  std::vector<std::string> headers;               // of runtime_support that the program's header includes, sorted
  std::vector<bool> host_used;                    // by HostFunctionId
  std::vector<bool> called_by_slice;              // by RoutineId: a piece of a sliced routine calls it
};

/// Whether the generated code has a routine.
bool IsPrinted(const ir::Routine& routine, const EmitOptions& options);
/// The instructions of the routines that this flavour of the generated code has, in their order.
std::vector<ir::InstId> PrintedInsts(const ir::Program& program, const EmitOptions& options);
/// Whether it has anything to print or to execute of its own; values are spelled where they are used.
bool IsEffect(const Emittable& emittable, ir::InstId id);
/// Whether a number has a literal in C++; others (infinities, NaNs) are spelled by their bits.
bool HasLiteral(ir::Type type, uint64_t value);
/// Whether another routine shares its callers' locals when it calls this one.
constexpr bool SharesLocals(ir::RoutineKind kind) { return kind == ir::RoutineKind::kSubroutine; }

}  // namespace plcxx::emit
