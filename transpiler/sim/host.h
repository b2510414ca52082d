// What a program's host functions answer: the time and the store of retentive memory, and what the caller says.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/engine.h"
#include "transpiler/sim/memory.h"

namespace plcxx::sim {

class Host {
 public:
  explicit Host(const ir::Program& program) : program_(program) {}

  void AnswerWith(HostAnswers answers) { answers_ = std::move(answers); }
  HostAnswer Answer(const ir::Call& call, const std::vector<uint64_t>& arguments, uint32_t now_ms, Memory& memory);
  /// Calls since the last time; those of the regular exchange are none.
  std::vector<HostEvent> TakeEvents() { return std::exchange(events_, {}); }

 private:
  const ir::Program& program_;
  HostAnswers answers_;
  std::vector<HostEvent> events_;
};

}  // namespace plcxx::sim
