// Executes routines of the typed IR on terms: after it every cell is a term over what the cells were before.
//
// In: a structured program (slices cut or not, as the simulator takes it), a routine. Out: the memory. The semantics is
// that of sim/simulator.h, written down a second time and without runtime_support. Branches are joined with Ite, an
// exit makes what follows conditional, loops are unrolled as far as their conditions are not known to be false.
// Host calls: what a function has been told is one term, calls' = told(calls, arguments), and so is what all were told,
// but for the regular exchange. What a function answers depends on what all were told but for faults, of the exchange
// on its own calls: two programs that call the host alike, in the same order, get the same answers. Not its job:
// whether states are reachable (prove/diff, prove/properties).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/symbolic/execute/cells.h"
#include "transpiler/symbolic/execute/loop_heads.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::execute {

class Memory;

/// A cell and what it becomes.
struct CellChange {
  CellId cell;
  terms::TermId value;
};

/// A part of a program: a routine, or the instructions [begin, end) of one region of it.
struct Stretch {
  ir::RoutineId routine;
  ir::RegionId region;  // none: the whole routine
  uint32_t begin = 0, end = 0;
};

/// Parts of a program that are not executed: what they do is told by somebody who has looked at them alone.
class ReplacedParts {
 public:
  ReplacedParts() = default;
  ReplacedParts(const ReplacedParts&) = delete;
  ReplacedParts& operator=(const ReplacedParts&) = delete;
  virtual ~ReplacedParts() = default;
  /// What a call of a routine does, whose parameters stand in their places; none: it is executed. `when`: execution
  /// comes there.
  virtual std::optional<std::vector<CellChange>> Call(Memory& memory, ir::RoutineId routine, terms::TermId when) = 0;
  /// What the part of a region does that begins at its instruction `at`, which becomes the one after it; none: that
  /// instruction is executed.
  virtual std::optional<std::vector<CellChange>> Part(Memory& memory, ir::RegionId region, uint32_t& at,
                                                      terms::TermId when) = 0;
};

/// What surrounds an execution.
struct Environment {
  /// The value of a cell that nothing has written yet; asked once for each cell that is read.
  std::function<terms::TermId(CellId cell)> initial;
  /// Called at a call of a host function that is given the state, before it writes any, with the memory then and when
  /// it comes there; may be empty.
  std::function<void(Memory& memory, ir::HostFunctionId function, terms::TermId when)> observe;
  /// Called at each call of a host function, with its arguments and when execution comes there (known with a policy for
  /// loops only). true: the call is dealt with, and nothing else follows from it. May be empty.
  std::function<bool(ir::InstId call, std::span<const terms::TermId> arguments, terms::TermId when)> tell;
  /// By which name the host knows a bit that it writes; empty: its own. Two versions that have an input at different
  /// places name it alike.
  struct HostBit {
    std::string space;
    uint32_t offset = 0;
    uint8_t bit = 0;
  };
  std::function<HostBit(CellId cell)> host_bit;
  /// Whether the host, when it writes the state, may leave what the cell has; empty: it writes all that it can. One
  /// version alone sees no difference, for what the host writes may be anything; two versions that have different
  /// values there do.
  std::function<bool(CellId cell)> may_be_left;
  /// Told every value that a cell gets, it gives the one that the cell has from then on; empty: the same.
  std::function<terms::TermId(CellId cell, terms::TermId value)> cut;
  /// Whether `cut` makes anything else of the values of a cell; empty: of all of them, perhaps.
  std::function<bool(CellId cell)> is_cut;
  /// The answer to the schedule's `now`.
  terms::TermId now;
  ReplacedParts* replaced = nullptr;
  /// What the host has of a retentive cell, if it has a copy at all; empty: a copy of which nothing is known.
  std::function<terms::TermId(CellId cell)> stored;
  /// It has one, whatever host_answers says.
  bool has_copy = false;
  /// Cells that follow the program's own, 64 bits each and 0 at first: what `observe` keeps from call to call. Where
  /// branches meet they are joined as memory is.
  uint32_t notes = 0;
  /// false: the host answers 0, gives no second result, and writes nothing.
  bool host_answers = true;
  /// The place whose initial value a call of the host gives, whatever host_answers says; none: another call.
  std::function<const ir::Place*(ir::InstId call)> fetched;
  /// Whether the regular exchange writes a cell; empty: all that the host's access says.
  std::function<bool(CellId cell)> is_exchanged;
  /// Not 0: a loop of which it is not known after so many rounds whether it goes on becomes an unknown function of what
  /// it reads (summary.h): two loops that are written alike are equal then, nothing else is known of them.
  uint32_t summarize_after = 0;
  /// Whether a condition is known never to hold: asked for another round of such a loop, and of one with a policy
  /// (`loops`), which is its end then; empty: nobody knows.
  std::function<bool(ir::InstId loop, terms::TermId condition)> never_holds;
  /// Except a proven loop that executes at most so many instructions in all its rounds: it is unrolled to its bound.
  uint32_t unroll_up_to = 0;
  /// Of these, loops that become functions all the same; may be none.
  const std::set<ir::InstId>* never_unrolled = nullptr;
  /// Whether a condition holds in the one run that is followed; empty: all runs are. Of a loop that would become an
  /// unknown function the rounds of this run are executed, and only what further rounds would do is unknown.
  std::function<bool(terms::TermId condition)> holds;
  /// What is done with a loop of which it is not known after a few rounds whether it goes on; none: it is unrolled.
  LoopPolicy* loops = nullptr;
  /// Rounds that one loop is unrolled, and terms that one execution may make, before it is given up.
  uint32_t most_rounds = 4096;
  uint32_t most_terms = 20'000'000;
  /// Asked at each statement: the execution is given up when it is so; empty: it never is.
  std::function<bool()> is_late;
};

/// The cells of one program in the middle of an execution.
class Memory {
 public:
  Memory(terms::Terms& terms, const ir::Program& program, const Cells& cells, Environment environment);

  terms::TermId Read(CellId cell);
  void Write(CellId cell, terms::TermId value);
  /// Whether the execution has written the cell since the memory was made; Read of others gives the initial value.
  bool IsWritten(CellId cell) const { return written_[cell.index]; }

  /// By CellId, of those that were asked for or written.
  const std::vector<terms::TermId>& values();

  /// A place that is not indexed; width of its type.
  terms::TermId ReadPlace(const ir::Place& place);
  void WritePlace(const ir::Place& place, terms::TermId value);

  /// From here on changed cells are remembered; TakeChanges ends the innermost Begin: it gives the changed cells with
  /// their values, ascending, and puts the values before it back.
  using Change = CellChange;
  void BeginChanges();
  std::vector<Change> TakeChanges();

  terms::Terms& terms() { return *terms_; }
  const ir::Program& program() const { return *program_; }
  const Cells& cells() const { return *cells_; }
  const Environment& environment() const { return environment_; }
  Environment& environment() { return environment_; }

 private:
  /// The bit of a word that was written as one. Taking words apart costs more than anything else in a program with
  /// tables, and most are read as they were written; so it is done when somebody asks for the bit.
  struct WordBit {
    terms::TermId word;  // none: the cell was written alone, or never
    uint8_t bit = 0;
  };
  struct Undo {
    CellId cell;
    terms::TermId before;
    WordBit word_before;
    bool was_written;
    uint32_t stamp;
  };

  /// What the cell is, for TakeChanges; to be called before each change of it.
  void NoteBefore(CellId cell);
  /// The word of which the cells are all bits, from the least significant one on; none: they are not.
  terms::TermId WholeWord(std::span<const CellId> bits) const;

  terms::Terms* terms_;
  const ir::Program* program_;
  const Cells* cells_;
  Environment environment_;
  std::vector<terms::TermId> values_;  // invalid: not asked for yet
  std::vector<WordBit> words_;         // what an invalid value was written as, and a valid one may have been
  std::vector<bool> written_;
  std::vector<uint32_t> stamps_;  // the Begin during which the cell's value was noted last
  std::vector<std::vector<Undo>> undo_;
  std::vector<uint32_t> open_stamps_;
  uint32_t next_stamp_ = 1;
};

/// Why an execution was given up; empty: it was not. The memory is of no use then.
using Refusal = std::string;

/// Executes a routine whose parameters get `arguments`, as a call of it from outside does: named locals are 0.
Refusal Execute(Memory& memory, ir::RoutineId routine, std::span<const terms::TermId> arguments = {});

/// Executes a part of a program where it stands: named locals are what `memory` says.
Refusal ExecutePart(Memory& memory, const Stretch& part);

/// The functions that stand for host calls; compiled code is executed with the same ones. `function` is the name of
/// the host function.
terms::TermId CallsAfter(terms::Terms& terms, std::string_view function, terms::TermId calls,
                         std::span<const terms::TermId> arguments);
/// Its result after that call.
terms::TermId AnswerOf(terms::Terms& terms, std::string_view function, terms::TermId calls, uint8_t width);
/// Whether it gave a second result, and which.
terms::TermId GivesSecond(terms::Terms& terms, std::string_view function, terms::TermId calls);
terms::TermId SecondAnswerOf(terms::Terms& terms, std::string_view function, terms::TermId calls, uint8_t width);
/// A byte of a space after a call that writes the state: of `space` by its name.
terms::TermId ByteFromHost(terms::Terms& terms, std::string_view function, terms::TermId calls, std::string_view space,
                           uint32_t offset);
/// Which bits of that byte the call wrote; it left the others.
terms::TermId BitsWrittenByHost(terms::Terms& terms, std::string_view function, terms::TermId calls,
                                std::string_view space, uint32_t offset);
/// Whether it has a copy of the retentive memory; without one it leaves the memory alone.
terms::TermId HasCopy(terms::Terms& terms, std::string_view function, terms::TermId calls);
/// What a host function of an access looks at and writes at each call: the one table of that. Memory that the host
/// cannot reach (automatic variables, registers, what the runtime keeps) it neither sees nor writes, although State has
/// it: where that lies changes with each translation. What it writes is BitsHostWrites in host_writes.h.
///
/// | access          | sees                            | writes                          |
/// |---|---|---|
/// | kNone           |                                 |                                 |
/// | kReadsState     | host-visible spaces             |                                 |
/// | kWritesState    | host-visible spaces, as before  | what BitsControlWrites gives    |
/// | kReadsRetentive | retentive spaces                |                                 |
/// | kWritesRetentive|                                 | retentive spaces                |
bool HostSees(ir::HostAccess access, const ir::Space& space);

/// What the control does to a bit beside the program. The first zone that has it says whose it is; another one what the
/// control does there besides: kInput, it writes values; kInternal, it clears what is set.
enum class ControlWrite : uint8_t { kNothing, kClears, kValues };

}  // namespace plcxx::execute
