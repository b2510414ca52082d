// The inner part of Execute: what is known at one point of a routine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/prove/execute/execute.h"

namespace plcxx::prove {

/// How an instruction leaves a block or loop, and when.
struct Leaving {
  ir::InstId target;
  bool repeats = false;  // another round of the loop `target`
  TermId when;
};

/// Which executions of a stretch get to its end, and which leave for where.
struct Flow {
  TermId active;
  std::vector<Leaving> leaving;
};

class Executor {
 public:
  Executor(Memory& memory);

  Refusal Run(ir::RoutineId routine, std::span<const TermId> arguments);
  Refusal RunPart(const Stretch& part);

 private:
  /// What one arm of a branch did, taken back.
  struct Arm {
    TermId when;
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
  Arm RunArm(TermId when, Body&& body);
  /// The arms exclude each other; where none applies, everything stays as it is and goes on.
  void Join(std::vector<Arm> arms);
  /// Where the exits of `target` are collected, the flow goes on again; `before` was active at its head.
  void Land(ir::InstId target, TermId before);
  TermId TakeLeaving(ir::InstId target, bool repeats);
  void Leave(ir::InstId target, bool repeats, TermId when);
  TermId SelectedBy(const ir::SwitchCase& one, TermId selector);
  std::vector<TermId> CaseConditions(const std::vector<ir::SwitchCase>& cases, TermId selector);
  enum class Unrolled : uint8_t { kWhole, kGivenUp };
  Unrolled UnrollLoop(ir::InstId id, const ir::Loop& loop);
  void ExecuteSummary(ir::InstId id);
  /// One round of a loop; gives when another one follows.
  TermId ExecuteRound(ir::InstId id, const ir::Loop& loop, uint64_t round, TermId& done);

  TermId ReadPlace(const ir::Place& place);
  TermId ReadAt(const ir::Place& place, TermId index);
  void WriteAt(const ir::Place& place, TermId index, TermId value);
  /// Of all writes: where execution does not come by, the cell keeps its value.
  void WriteCell(CellId cell, TermId value);
  void WritePlace(const ir::Place& place, TermId value);
  void StepInstance(ir::StateId state, std::span<const TermId> fields);
  std::vector<TermId> Fields(ir::StateId state);
  void ClearLocals();
  TermId ValueOf(uint32_t id) const { return values_[id]; }
  void Refuse(std::string reason);

  Memory& memory_;
  Terms& terms_;
  const ir::Program& program_;
  std::vector<TermId> values_;  // by ValueId
  Flow flow_;
  Refusal refusal_;
  uint32_t first_term_;
};

}  // namespace plcxx::prove
