// Both versions beside each other over some periods: their state, as terms over the inputs so far.
//
// In: two versions, a state they begin with: power-on, or one in which they were seen. Out: the state after each
// period, and which variable each input is. Not its job: what is asked of the state.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "transpiler/prove/diff/compare.h"
#include "transpiler/prove/diff/pairing.h"
#include "transpiler/prove/machine/transition.h"
#include "transpiler/symbolic/terms/justify.h"

namespace plcxx::prove::diff {

/// When inputs may change: before each period, or before the first one alone.
enum class InputsChange : uint8_t { kEachPeriod, kOnce };
/// What is in memory that is kept without power when it comes for the first time.
enum class Kept : uint8_t { kNothing, kAnything };

struct UnrolledVersions {
  const machine::Version& old_version;
  const machine::Version& new_version;
  const Match& match;
  const machine::Uses& old_uses;
  const machine::Uses& new_uses;
  std::vector<execute::CellId> requests;  // old cells that the control clears when it likes; none: it never does
};

class Unrolled {
 public:
  /// What the versions are made of outlives the object.
  Unrolled(terms::Terms& terms, UnrolledVersions versions, InputsChange inputs_change);

  void PowerOn(Kept kept = Kept::kNothing);
  /// `value`: of each cell of one version when `now_ms` have passed.
  void BeginAt(const std::function<uint64_t(Which, execute::CellId)>& value, uint64_t now_ms);
  /// As `run: {ms: ...}` of one period does it: the fast parts that are due, then the period. false: it cannot be
  /// executed, or `is_late`.
  bool Advance(const std::function<bool()>& is_late);

  terms::TermId Old(execute::CellId cell) const { return old_state_[cell.index]; }
  terms::TermId New(execute::CellId cell) const { return new_state_[cell.index]; }
  size_t periods() const { return periods_; }

  /// The old cell that a variable sets; none: it is no input.
  std::optional<uint32_t> CellOf(terms::TermId variable) const;
  /// The inputs that matter, with their values by TermId, each where its level changes.
  Run RunOf(const std::vector<terms::Reason>& reasons, const std::vector<uint64_t>& values) const;

 private:
  struct Inputs {
    std::map<uint32_t, terms::TermId> levels;  // what each input (an old cell) is
    std::map<uint32_t, terms::TermId> done;    // whether the control has done each request (an old cell)
  };

  bool IsInput(execute::CellId old_cell) const;
  bool IsWritten(execute::CellId old_cell) const;
  bool MayBeSet(execute::CellId old_cell) const;
  terms::TermId InputOf(uint32_t old_cell);
  /// What both versions find in a cell when power comes: anything, and the same. None: it is not of both.
  terms::TermId KeptIn(Which which, execute::CellId cell);
  /// One part of one version; what it changed, or nullopt when it cannot be executed.
  std::optional<bool> AdvancePart(Which which, machine::Part part, uint64_t now_ms,
                                  const std::function<bool()>& is_late);
  void ClearDoneRequests();

  terms::Terms& terms_;
  UnrolledVersions versions_;
  InputsChange inputs_change_;
  std::vector<terms::TermId> old_state_, new_state_;  // by cell
  std::vector<Inputs> inputs_;                        // by period
  std::map<uint32_t, terms::TermId> kept_;            // by old cell: what is kept there without power
  std::unordered_map<uint32_t, uint32_t> cell_of_;    // by variable; looked up only
  std::function<uint64_t(uint32_t old_cell)> level_at_begin_;
  uint64_t begin_ms_ = 0;
  size_t periods_ = 0;
};

}  // namespace plcxx::prove::diff
