// Which locals a call of a partition has to make 0 and to put back: a partition begins with its named locals 0, and its
// caller finds its own as they were.
//
// In: a program. Out: for each routine the bytes of lifetime kRoutine that it and what it calls use, and those that may
// be in use by routines which wait for it. A space whose places are stored before they are read (Space::own) needs
// neither.
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::fleet {

using LocalByte = std::pair<uint32_t, uint32_t>;  // space, offset

class LocalBytes {
 public:
  explicit LocalBytes(const ir::Program& program);
  /// By the routine and everything that it calls.
  const std::set<LocalByte>& UsedFrom(ir::RoutineId routine) const { return from_[routine.index]; }
  /// Of those of `callee`, the ones that a routine uses which may be waiting while `caller` calls it.
  std::set<LocalByte> Kept(ir::RoutineId caller, ir::RoutineId callee) const;

 private:
  std::vector<std::set<LocalByte>> from_;     // by RoutineId
  std::vector<std::set<LocalByte>> waiting_;  // likewise: by the routine and all its callers
};

}  // namespace plcxx::fleet
