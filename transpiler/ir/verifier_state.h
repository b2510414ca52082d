// What the verifier's files share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/ir/verifier.h"

namespace plcxx::ir {

/// What an operand is to its instruction, "argument"; of an argument also its name.
struct OperandName {
  std::string_view role, name = {};
};

struct Verifier {
  const Program& program;
  Stage stage;
  std::vector<std::string> findings;

  RoutineId routine;                            // the one that is being walked
  StatementId statement;                        // whose marker stood last
  std::vector<bool> region_owned;               // by RegionId
  std::vector<bool> region_open;                // by RegionId: it is the walked one or around it
  std::vector<bool> body_open;                  // by InstId: a block or loop around the walked region
  std::vector<bool> marked;                     // by StatementId
  std::vector<uint32_t> position;               // by InstId: in the order of the walk, from 1; 0 before
  std::vector<RegionId> home;                   // by InstId
  std::vector<std::vector<RoutineId>> callees;  // by RoutineId
  uint32_t now = 0;
  struct LabelAt {
    uint32_t label;
    size_t at;  // index into the region's instructions
  };
  struct OpenRegion {
    std::vector<LabelAt> labels;  // ascending
    size_t at = 0;                // of the walked instruction
  };
  std::vector<OpenRegion> labels;  // of the walked region and those around it, outermost first; kLowered only

  explicit Verifier(const Program& verified, Stage at);

  void Report(std::string finding) { findings.push_back(std::move(finding)); }
  /// A finding about an instruction of the walked routine.
  void Report(const Inst& inst, const std::string& finding);

  // verifier_memory.cc
  void VerifyMemory();

  // verifier_routines.cc
  void VerifyRoutine(const Routine& checked);
  void VerifySchedule();
  void VerifyCallGraph();
  void VerifyStatements();

  // verifier_regions.cc: control flow. `floor` is the position of the last marker that ends values' lives here.
  void VerifyRegion(RegionId region, uint32_t floor);
  void VerifyOwned(RegionId region, uint32_t floor, const Inst& owner);
  void VerifyIf(const Inst& inst, uint32_t floor);
  void VerifySwitch(const Inst& inst, uint32_t floor);
  void VerifyLoop(InstId id, const Inst& inst, uint32_t floor);
  void VerifyStep(const Inst& inst, const Loop& loop, uint32_t floor);
  void VerifyBlock(InstId id, const Inst& inst, uint32_t floor);
  void VerifyExit(const Inst& inst, uint32_t floor);
  void VerifyRepeat(const Inst& inst, uint32_t floor);
  void OpenLabels(RegionId region);
  void VerifyJump(const Inst& inst, uint32_t floor);
  void VerifyTarget(const Inst& inst);

  // verifier_insts.cc: one instruction's operands and types.
  void VerifyInst(const Inst& inst, uint32_t floor);
  /// The value of an operand: computed, visible, of this type (kNone: of any type that is not kNone).
  void VerifyUse(const Inst& inst, uint32_t word, Type type, const OperandName& what, uint32_t floor);
};

}  // namespace plcxx::ir
