// Loops, unrolled, or by one round that is taken for each.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "transpiler/prove/verify/llvm_ir/code_values.h"
#include "transpiler/prove/verify/llvm_ir/execution.h"
#include "transpiler/prove/verify/llvm_ir/flow_execution.h"
#include "transpiler/prove/verify/llvm_ir/object_memory.h"
#include "transpiler/prove/verify/llvm_ir/poison.h"

namespace plcxx::prove::verify::llvm_ir {

class LoopExecution : private ExecutionPart {
 public:
  LoopExecution(Execution& execution, ObjectMemory& memory, Poison& poison, FlowExecution& flow)
      : ExecutionPart(execution), memory_(memory), poison_(poison), flow_(flow) {}

  void RunLoop(const FlowLevel& level, Passage entry, terms::TermId context, std::vector<Passage>& leaving);

 private:
  /// One that is not unrolled: what is at its heads.
  struct LoopState {
    std::vector<CodeLoop::Item> items;
    std::vector<const llvm::PHINode*> phis;  // of the items in front
    std::vector<uint32_t> objects;           // of phis that are pointers, else 0
    std::vector<std::pair<terms::TermId, Passage>> heads;
  };
  /// Whether it is whole: nothing was left out.
  void UnrollLoop(const FlowLevel& level, Passage entry, terms::TermId context, std::vector<Passage>& leaving,
                  LoopState* state);
  void RunByHead(const FlowLevel& level, const Passage& entry, terms::TermId context, LoopState& state,
                 std::vector<Passage>& leaving);
  /// The passage into a round that is taken for each: items have the values that the environment gives them.
  Passage StartOf(const Passage& entry, const LoopState& state, const std::vector<terms::TermId>& values);
  /// Those that go back to the head as one, the others to `leaving`; none goes back: no passage.
  std::optional<Passage> JoinRepeats(const llvm::BasicBlock* head, std::vector<Passage> passages, terms::TermId active,
                                     std::vector<Passage>& leaving);
  bool FindItems(const llvm::BasicBlock& head, LoopState& state);
  void AddSlots(const Slots& a, const Slots& b, LoopState& state);
  /// At a loop's head there is nothing but values: what is poison must not come there.
  void RequireAtHead(const LoopState& state, const Passage& passage, terms::TermId when);
  std::vector<terms::TermId> ItemsOf(const Passage& passage, const LoopState& state);

  ObjectMemory& memory_;
  Poison& poison_;
  FlowExecution& flow_;
  uint32_t sampling_ = 0;  // loops around this point whose first rounds are looked at
};

}  // namespace plcxx::prove::verify::llvm_ir
