// What instructions remember for themselves: edges what they saw last, axis blocks what they sent last. Named by what
// they look at, and by their statement where another one looks at the same.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Names;

class OwnInstances : Context {
 public:
  OwnInstances(const Context& context, const Names& names);

  ir::StateId Add(InstructionId id);
  ir::StateId Of(InstructionId id) const { return instances_[id.index]; }
  /// In the order in which they were added.
  const std::vector<InstructionId>& edges() const { return edges_; }

 private:
  std::string NameOf(const Instruction& instruction) const;

  const Names& names_;
  std::vector<ir::StateId> instances_;                // by InstructionId
  std::unordered_map<std::string, uint32_t> wanted_;  // how many instructions want the name
  std::vector<InstructionId> edges_;
};

}  // namespace plcxx::host50
