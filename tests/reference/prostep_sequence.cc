// The sequence rule of dialect prostep as the text decides it (5.3, 6.1.3, 6.1.4).
#include "tests/reference/prostep.h"

namespace plcxx::reference {
namespace {

using prostep::Role;

struct Level {
  bool first = true;
  bool orp = false;
  bool empty = true;  // no logic operation since the operand-less O
};

void FoldText(Level& level, SequenceNote& note) {
  if (!level.orp) return;
  note.folds = true;
  note.empty = level.empty;
  level.orp = false;
  level.first = false;
}

}  // namespace

SequenceNotes ReadSequences(const prostep::Program& program) {
  SequenceNotes notes{.of_instruction = std::vector<SequenceNote>(program.instructions.size()), .of_end = {}};
  for (const prostep::Module& module : program.modules) {
    std::vector<Level> outer;
    Level level;  // MOD starts fresh
    for (uint32_t i = module.begin_of().index; i < module.end_of().index; ++i) {
      const prostep::Instruction& instruction = program.instructions[prostep::InstructionId(i)];
      SequenceNote& note = notes.of_instruction[i];
      const bool outside = outer.empty() && !level.orp;
      switch (prostep::Info(instruction.op).role) {
        case Role::kLogic:
          if (instruction.op == prostep::Op::kOr || instruction.op == prostep::Op::kOrNot) FoldText(level, note);
          note.first = level.first;
          note.asks_flag = outside;
          level.first = false;
          level.empty = false;
          break;
        case Role::kCompare:
          level.orp = false;
          level.first = false;
          break;
        case Role::kString:
          FoldText(level, note);
          note.first = level.first;
          note.asks_flag = outside;
          level = {.first = true, .orp = true, .empty = true};
          break;
        case Role::kOpen:
          if (instruction.op == prostep::Op::kOpenOr) FoldText(level, note);
          note.asks_flag = outside;
          outer.push_back(level);
          level = {};
          break;
        case Role::kClose:
          FoldText(level, note);
          level = outer.back();
          outer.pop_back();
          note.first = level.first;
          note.asks_flag = outer.empty() && !level.orp;  // ')' belongs to the level outside
          level.first = false;
          level.empty = false;
          break;
        case Role::kNeutral:
          break;
        case Role::kJump:
          FoldText(level, note);
          break;
        case Role::kEnds:
          FoldText(level, note);
          level.first = true;
          break;
      }
    }
    FoldText(level, notes.of_end.emplace_back());  // END ends the sequence
  }
  return notes;
}

}  // namespace plcxx::reference
