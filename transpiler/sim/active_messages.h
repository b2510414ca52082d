// The operator messages that a program shows: which are active, and which have become so.
//
// In: Program::message_bits and message_words, read through an engine. Out: numbers, ascending. Not its job: their
// texts (Program::messages), or how long a display shows each of them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/engine.h"

namespace plcxx::sim {

/// The numbers of the active messages, ascending, each once.
std::vector<uint32_t> ActiveMessages(const ir::Program& program, Engine& engine);

/// Follows the set of active messages from period to period.
class MessageTracker {
 public:
  /// `program` must outlive the tracker.
  explicit MessageTracker(const ir::Program& program) : program_(program) {}

  /// After each period.
  void Observe(Engine& engine);
  /// At power-on the set is empty again; what was shown before stays to be taken.
  void PowerOn() { active_.clear(); }

  const std::vector<uint32_t>& active() const { return active_; }
  /// The set as it was at a moment to which a simulation goes back; what was shown before stays to be taken.
  void Become(std::vector<uint32_t> active) { active_ = std::move(active); }
  /// The numbers that entered the set since the last call, in order of entry, the lower number first in one period.
  std::vector<uint32_t> TakeEntered();

 private:
  const ir::Program& program_;
  std::vector<uint32_t> active_, entered_;
};

}  // namespace plcxx::sim
