// The named locals of partitions: each begins with its own 0, and its caller has them again behind it.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/sim/local_stretches.h"
#include "transpiler/sim/memory.h"

namespace plcxx::sim {

class Locals {
 public:
  void Begin(Memory& memory, const LocalStretches& locals) const;
  /// Those of the caller, while a partition runs that may use the same ones.
  void Keep(Memory& memory, const LocalStretches& locals);
  /// Back to what Keep kept when so many bytes were kept already.
  void PutBack(Memory& memory, const LocalStretches& locals, size_t from);
  size_t kept() const { return kept_.size(); }

 private:
  std::vector<uint8_t> kept_;  // of all callers, the innermost at the end
};

}  // namespace plcxx::sim
