// The change with which a program is executed, and those of which is looked for where they would make a difference.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/changed_inst.h"
#include "transpiler/sim/decoded_program.h"

namespace plcxx::sim {

/// A changed instruction as it is executed.
struct Changed {
  ChangedInst what;
  ir::Inst inst;
  std::optional<ir::Call> call;  // of a call with a changed argument
  uint32_t operand = 0;          // kOperand: the value that stands there in the program
  bool wanted = true;            // is looked for
};

class Changes {
 public:
  Changes(const ir::Program& program, const DecodedProgram& code) : program_(program), code_(code) {}

  /// From now on the program is executed with this change; none: as it is. A loop that has a proven bound and comes to
  /// it is then ended as StopWhen of the simulator ends it.
  void Change(const std::optional<ChangedInst>& changed);
  /// From now on it is noted where one of these would make a difference: of what is computed, the result; of what is
  /// not stored, the memory; of all else, that it is executed with another operand. By number; costs time.
  void LookForDifferences(const std::vector<ChangedInst>& changes);
  /// Only those that are looked for are found; all are at first, and none of those that were found.
  void LookFor(uint32_t change, bool wanted) { differences_[change].wanted = wanted; }
  /// Found since the last call, each once.
  std::vector<uint32_t> TakeDifferences() { return std::exchange(found_, {}); }

  bool is_changed() const { return changed_.has_value(); }
  const Changed& changed() const { return *changed_; }
  /// The region that is executed with the change; none: as the program is.
  ir::RegionId region() const { return region_; }
  /// What of DecodedProgram::ready executes the changed instruction.
  uint32_t entry() const { return entry_; }
  /// The call of an instruction, be it the changed one.
  const ir::Call& CallOf(const ir::Inst& inst) const {
    return inst.payload == program_.calls.size() ? *changed_->call : program_.calls[ir::CallId(inst.payload)];
  }

  bool looks_for_differences() const { return looks_for_differences_; }
  /// The changes of an instruction, by number.
  std::span<const uint32_t> Of(ir::InstId id) const;
  const Changed& difference(uint32_t number) const { return differences_[number]; }
  void Found(uint32_t number);

  // Two values behind those of the program: the number that a change puts in, what a changed instruction gives.
  static constexpr uint32_t kValues = 2;
  uint32_t NumberValue() const { return static_cast<uint32_t>(program_.insts.size()); }
  uint32_t OtherResult() const { return NumberValue() + 1; }

 private:
  Changed Made(const ChangedInst& what) const;

  const ir::Program& program_;
  const DecodedProgram& code_;
  std::optional<Changed> changed_;
  ir::RegionId region_;
  uint32_t entry_ = 0;
  std::vector<Changed> differences_;  // by number
  std::vector<uint32_t> begin_;       // by InstId: in in_order_
  std::vector<uint32_t> in_order_;
  std::vector<uint32_t> found_;
  bool looks_for_differences_ = false;
};

}  // namespace plcxx::sim
