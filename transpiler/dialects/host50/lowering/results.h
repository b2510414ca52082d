// Results of instructions: computed where they are used, and before something that would change them.
#pragma once

#include <vector>

#include "transpiler/dialects/host50/lowering/context.h"
#include "transpiler/dialects/host50/lowering/effects.h"

namespace plcxx::host50 {

class Contacts;
class Logic;
class Numbers;

class Results : Context {
 public:
  Results(const Context& context, Contacts& contacts, Logic& logic, Numbers& numbers);

  /// A network's instructions come: none has a result yet, and each will be used as often as others take it.
  void BeginNetwork(Span instructions);
  void BeginRung() { pending_.clear(); }
  /// The instruction was reached; its result is computed where the first one takes it.
  void Await(InstructionId id) { pending_.push_back(id); }
  /// It has a result from here on.
  void Set(InstructionId id, ir::ValueId value) { results_[id.index].value = value; }
  ir::ValueId TakeInput(const Input& input);
  ir::ValueId TakeOne(InstructionId id);
  /// Computes the results that later instructions use and that `writes` would change.
  void KeepFrom(const WriteSet& writes) { Keep(Endangered(writes)); }
  /// Takes the input's results without computing them, unless `writes` would change one that is still used: false.
  bool Release(const Input& input, const WriteSet& writes);

 private:
  /// What is known of an instruction's result while its network is lowered.
  struct Result {
    ir::ValueId value;  // in this statement; none: computed where it is used
    uint32_t uses = 0;  // by instructions still to come
  };

  ir::ValueId Take(InstructionId id);
  void Compute(std::vector<InstructionId> wanted);
  ir::ValueId ComputeOne(InstructionId id);
  void Keep(const std::vector<InstructionId>& results);
  std::vector<InstructionId> Endangered(const WriteSet& writes);
  bool ReadsAny(InstructionId id, const WriteSet& writes);

  Contacts& contacts_;
  Logic& logic_;
  Numbers& numbers_;
  std::vector<Result> results_;         // by InstructionId
  std::vector<InstructionId> pending_;  // of the statement: not yet computed, and used by instructions still to come
};

}  // namespace plcxx::host50
