// Statements: what a reader sees as one. A logic sequence with all that uses its RLO, a load with what is computed and
// stored, a run of assembler lines that form expressions. Their texts are lines of the source as they are:
//
//   LDR START        // LDR START
//   LA  -STOP        // LA  -STOP
//   WR  MOTOR        // WR  MOTOR
//                    m[MOTOR] = m[START] & !m[STOP];
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/dialects/common/statement_ids.h"
#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class CellPlaces;

class StatementWriter : Context {
 public:
  StatementWriter(const Context& context, CellPlaces& cells) : Context(context), cells_(cells) {}

  /// Before the first routine is lowered.
  void FindTargets();
  /// Of the routine that is lowered: where its statements begin, each label among them. `label_at`: by instruction of
  /// the routine.
  void Cut(const std::vector<bool>& label_at);
  bool BeginsAt(size_t index) const { return begins_[index]; }
  /// The one that begins at the instruction `first` of the routine.
  void Begin(size_t first);
  /// Text above the next statement: comments before an instruction, and lines without one.
  void AddComments(const Span& comments);
  /// Those on a line that is not shown itself.
  void AddTrailingComments(const Span& comments);
  void AddLines(source::Range range);
  /// What is in front of the end of a module belongs to no instruction.
  void End();

 private:
  const Instruction& InstructionAt(size_t index) const {
    return tree_.instructions[frame_.routine->instructions[index]];
  }
  size_t EndOf(size_t first) const;
  bool CanFault(InstructionId id) const;
  uint32_t NumberOf(size_t first, size_t end);
  std::string SubjectOf(size_t first, size_t end) const;
  /// The line that a fault of the statement is reported with.
  uint32_t LineOf(size_t first, size_t end) const;
  /// With the labels in front of its first instruction.
  source::Range LinesOf(size_t first, size_t end) const;

  CellPlaces& cells_;
  std::vector<bool> begins_;       // by instruction of the routine
  std::vector<bool> is_target_;    // by InstructionId: jumped to or called, from any routine
  std::vector<uint32_t> numbers_;  // by InstructionId of the first one; 0: none yet
  dialects::StatementIds ids_;
  std::vector<source::Range> waiting_comments_;
  source::Range last_lines_;  // of the statement before
};

}  // namespace plcxx::technol
