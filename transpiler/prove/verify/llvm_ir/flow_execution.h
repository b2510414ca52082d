// Blocks and calls: which passages there are, and where they meet.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/prove/verify/llvm_ir/code_values.h"
#include "transpiler/prove/verify/llvm_ir/execution.h"
#include "transpiler/prove/verify/llvm_ir/instruction_execution.h"
#include "transpiler/prove/verify/llvm_ir/object_memory.h"
#include "transpiler/prove/verify/llvm_ir/poison.h"

namespace plcxx::prove::verify::llvm_ir {

class LoopExecution;

class FlowExecution : private ExecutionPart {
 public:
  FlowExecution(Execution& execution, CodeValues& values, ObjectMemory& memory, Poison& poison,
                InstructionExecution& instructions, LoopExecution& loops)
      : ExecutionPart(execution),
        values_(values),
        memory_(memory),
        poison_(poison),
        instructions_(instructions),
        loops_(loops) {}

  CodeValue Call(const llvm::Function& function, std::vector<CodeValue> arguments);
  void RunLevel(const FlowLevel& level, Passage entry, terms::TermId context, std::vector<Passage>& leaving);
  /// One passage for several; `conditions` of them are since one node, and one of them holds.
  Passage Join(std::vector<Passage> passages, const std::vector<terms::TermId>& conditions);

 private:
  /// Passages that meet, and one of which is taken when `when` holds since the node that they were joined for.
  struct Meeting {
    Passage passage;
    terms::TermId when;
  };
  /// Branches in branches are joined from inside, as a program with the same branches does: passages that have more
  /// nodes in common than `dominator` meet first. `since_dominator`: by node of the level.
  Meeting JoinSince(const FlowLevel& level, uint32_t dominator, std::vector<Passage> passages,
                    const std::vector<terms::TermId>& since_dominator, uint32_t depth);
  void RunBlock(const llvm::BasicBlock& block, Passage entry, std::vector<Passage>& leaving);
  /// By the instruction that ends the block.
  void LeaveBlock(const llvm::Instruction& inst, std::vector<Passage>& leaving);
  void LeaveByBranch(const llvm::BranchInst& branch, std::vector<Passage>& leaving);
  void LeaveBySwitch(const llvm::SwitchInst& choice, std::vector<Passage>& leaving);
  void LeaveByReturn(const llvm::ReturnInst& back, std::vector<Passage>& leaving);
  void Leave(const llvm::BasicBlock& from, const llvm::BasicBlock* to, terms::TermId when,
             std::vector<Passage>& leaving);

  CodeValues& values_;
  ObjectMemory& memory_;
  Poison& poison_;
  InstructionExecution& instructions_;
  LoopExecution& loops_;
  uint32_t depth_ = 0;  // of calls
};

}  // namespace plcxx::prove::verify::llvm_ir
