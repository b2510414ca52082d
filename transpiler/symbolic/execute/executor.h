// The inner part of Execute: what is known at one point of a routine.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/symbolic/execute/execute.h"

namespace plcxx::execute {

/// How an instruction leaves a block or loop, and when.
struct Leaving {
  ir::InstId target;
  bool repeats = false;  // another round of the loop `target`
  terms::TermId when;
};

/// Which executions of a stretch get to its end, and which leave for where.
struct Flow {
  terms::TermId active;
  std::vector<Leaving> leaving;
};

class Executor {
 public:
  Executor(Memory& memory);

  Refusal Run(ir::RoutineId routine, std::span<const terms::TermId> arguments);
  Refusal RunPart(const Stretch& part);

 private:
  /// What one arm of a branch did, taken back.
  struct Arm {
    terms::TermId when;
    std::vector<Memory::Change> changes;
    Flow flow;
  };

  void ExecuteRoutine(const ir::Routine& routine);
  void ExecuteRegion(ir::RegionId region);
  /// Whether somebody else has told what happens here.
  bool IsReplaced(ir::RegionId region, uint32_t& at);
  void ExecuteInst(ir::InstId id, const ir::Inst& inst);
  // One for each operation that is the IR's own.
#define PLCXX_PURE(...)
#define PLCXX_STEP(...)
#define PLCXX_CORE(Kind, ...) void Execute##Kind(ir::InstId id, const ir::Inst& inst);
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE

  /// Executes a stretch as if nothing came before it but the memory: active, no exits; and takes it back.
  template <class Body>
  Arm RunArm(terms::TermId when, Body&& body);
  /// The arms exclude each other; where none applies, everything stays as it is and goes on.
  void Join(std::vector<Arm> arms);
  /// Where the exits of `target` are collected, the flow goes on again; `before` was active at its head.
  void Land(ir::InstId target, terms::TermId before);
  terms::TermId TakeLeaving(ir::InstId target, bool repeats);
  void Leave(ir::InstId target, bool repeats, terms::TermId when);
  terms::TermId SelectedBy(const ir::SwitchCase& one, terms::TermId selector);
  std::vector<terms::TermId> CaseConditions(const std::vector<ir::SwitchCase>& cases, terms::TermId selector);
  // Loops (execute_loops.cc).
  enum class Unrolled : uint8_t { kWhole, kGivenUp };
  /// What was at the head of a round: all cells.
  struct Sample {
    terms::TermId when;
    std::vector<terms::TermId> cells;
  };
  /// The rounds of the run that is followed, then the unknown function of a loop, under the condition of a further
  /// round.
  void FollowLoop(ir::InstId id, const ir::Loop& loop);
  /// `most_unknown`: rounds of which it is not known whether they are executed; after them it is given up. 0: never.
  /// `samples`: to be filled; may be none.
  Unrolled UnrollLoop(ir::InstId id, const ir::Loop& loop, uint32_t most_unknown, std::vector<Sample>* samples);
  bool IsKnownNotToGoOn(ir::InstId loop);
  void ExecuteSummary(ir::InstId id);
  void AddChanged(const std::vector<Memory::Change>& changes, std::vector<CellId>& cells);
  void ExecuteByHead(ir::InstId id, const ir::Loop& loop);
  /// From the entry through a round that stands for each; `more`: cells that the round writes and nobody knew.
  void ExecuteOneForAll(ir::InstId id, const ir::Loop& loop, ProgramLoop& known, std::vector<CellId>& more);
  /// One round of a loop; gives when another one follows. `number`: of rounds before this one.
  /// `rewritten`: cells that earlier rounds wrote, and then this one; none: nobody asks what is known of them.
  terms::TermId ExecuteRound(ir::InstId id, const ir::Loop& loop, terms::TermId number, terms::TermId& done,
                             std::set<CellId>* rewritten = nullptr);
  /// The condition or the step of a loop, with what is known where it is executed.
  void ExecuteKnowing(ir::RegionId region, std::set<CellId>* rewritten);
  /// Begins an arm with what is known of cells where it is executed; gives what was written.
  std::map<CellId, terms::TermId> WriteKnown(terms::TermId when, const std::set<CellId>& cells);
  /// Takes the changes away that only say what was known; the cells of the others are rewritten.
  static void NoteRewritten(std::vector<Memory::Change>& changes, const std::map<CellId, terms::TermId>& known,
                            std::set<CellId>& rewritten);
  /// When execution comes to this point of the routine; known with a policy for loops, or somebody who knows what never
  /// holds.
  terms::TermId Absolute() { return terms_.And(context_, flow_.active); }

  terms::TermId ReadPlace(const ir::Place& place);
  terms::TermId InitialOf(const ir::Place& place);
  terms::TermId ReadAt(const ir::Place& place, terms::TermId index);
  void WriteAt(const ir::Place& place, terms::TermId index, terms::TermId value);
  /// Of all writes: where execution does not come by, the cell keeps its value.
  void WriteCell(CellId cell, terms::TermId value);
  void WritePlace(const ir::Place& place, terms::TermId value);
  void StepInstance(ir::StateId state, std::span<const terms::TermId> fields);
  std::vector<terms::TermId> Fields(ir::StateId state);
  void ClearLocals();
  terms::TermId ValueOf(uint32_t id) const { return values_[id]; }
  void Refuse(std::string reason);

  Memory& memory_;
  terms::Terms& terms_;
  const ir::Program& program_;
  std::vector<terms::TermId> values_;  // by ValueId
  Flow flow_;
  Refusal refusal_;
  uint64_t statements_ = 0;  // that were executed
  uint32_t first_term_;
  terms::TermId context_;  // when the stretch of `flow_` begins
  uint32_t sampling_ = 0;  // loops around this point whose first rounds are looked at
};

template <class Body>
Executor::Arm Executor::RunArm(terms::TermId when, Body&& body) {
  const Flow outer = std::exchange(flow_, {.active = terms_.Bit(true), .leaving = {}});
  const terms::TermId context = context_;
  if (memory_.environment().loops != nullptr || memory_.environment().never_holds)
    context_ = terms_.And(context, terms_.And(outer.active, when));
  memory_.BeginChanges();
  body();
  Arm arm{.when = when, .changes = memory_.TakeChanges(), .flow = std::move(flow_)};
  flow_ = outer;
  context_ = context;
  return arm;
}

}  // namespace plcxx::execute
