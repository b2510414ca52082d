// A program being executed: what the functions of its instructions work on, and how routines and regions are entered.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/changes.h"
#include "transpiler/sim/decoded_program.h"
#include "transpiler/sim/host.h"
#include "transpiler/sim/locals.h"
#include "transpiler/sim/memory.h"
#include "transpiler/sim/write_recorder.h"

namespace plcxx::sim {

/// The statements that are switched off.
class SwitchedOff {
 public:
  explicit SwitchedOff(size_t statements) : off_(statements) {}

  void Set(ir::StatementId statement, bool off);
  bool Has(ir::StatementId statement) const { return off_[statement.index]; }
  bool any() const { return count_ > 0; }

 private:
  std::vector<bool> off_;  // by StatementId
  size_t count_ = 0;
};

/// Since power-on. A control's clock wraps; what is told of last writes does not.
struct Time {
  uint32_t now_ms = 0;
  uint64_t whole_ms = 0;

  void GoTo(uint32_t ms) {
    whole_ms += static_cast<uint32_t>(ms - now_ms);
    now_ms = ms;
  }
};

/// The statement whose instructions are being executed.
struct CurrentStatement {
  ir::StatementId statement;
  bool skipped = false;        // switched off: its instructions have no effect
  bool head_is_false = false;  // the head of a block, switched off: its condition counts as false
};

struct Execution {
  explicit Execution(const ir::Program& structured);
  Execution(const Execution&) = delete;

  const ir::Program& program;
  Memory memory{program};
  const DecodedProgram code{program, memory.instances()};
  Changes changes{program, code};
  Host host{program};
  Locals locals;
  WriteRecorder recorder;
  SwitchedOff switched_off{program.statements.size()};
  Time time;

  std::vector<uint64_t> values;             // by ValueId, raw bits; constants are there from the start
  std::vector<const unsigned char*> bases;  // by BitBase
  CurrentStatement current;
  ir::InstId leaving;    // where an Exit or a Repeat goes; none once it has stopped, so that everything is left
  bool repeats = false;  // what leaves is a Repeat: another round of the loop it names
  std::function<bool()> stop;
  uint32_t regions = 0;  // begun since `stop` was asked
  bool stopped = false;
  std::function<bool(ir::StatementId)> at_statement;
  std::span<uint8_t> given;  // by InstId: what each instruction gave, if somebody asks
  uint64_t executed = 0;     // instructions, those of switched-off statements not counted

  static constexpr uint8_t kGave0 = 1, kGaveOther = 2;
  void NoteGiven(uint32_t id) { given[id] = static_cast<uint8_t>(given[id] | (values[id] != 0 ? kGaveOther : kGave0)); }
};

/// With its named locals 0; nothing for a routine that is none.
void RunPartition(Execution& execution, ir::RoutineId routine);
void Run(Execution& execution, ir::RoutineId routine);
Flow Execute(Execution& execution, ir::RegionId region);
/// Ends the run where it is.
void Stop(Execution& execution);
/// Where bits of rungs stand: after the memory was exchanged.
void FindBases(Execution& execution);

/// Whether some statement is switched off, or somebody is asked at statements or looks for differences.
inline bool IsCareful(const Execution& execution) {
  return execution.switched_off.any() || execution.at_statement || execution.changes.looks_for_differences();
}

/// A write of the host or of a force is noted with no statement.
LastWrite WriteBy(const Execution& execution, Writer writer);
/// The program writes.
void Assign(Execution& execution, const PlaceAccess& access, uint64_t index, uint64_t value);
/// After an operation on an instance: its forces are put back, its fields are written.
void Stepped(Execution& execution, uint32_t instance);

}  // namespace plcxx::sim
