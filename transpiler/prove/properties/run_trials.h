// Runs that are tried instead of computed: by the caller, one after the other, and here, many side by side.
//
// A run counts when the machine shows it.
#pragma once

#include <functional>
#include <memory>

#include "transpiler/prove/properties/checked_program.h"
#include "transpiler/prove/properties/wide_search.h"

namespace plcxx::prove::properties {

/// Of the time for a few runs: a fortieth, but not much.
inline constexpr uint32_t kQuickShare = 40, kMostFirstMs = 200;

class RunTrials {
 public:
  explicit RunTrials(CheckedProgram& checked) : checked_(checked) {}

  /// Another property is checked.
  void Begin() { replays_ = 0; }
  void BeginSearch();

  // True: `result` has the verdict.
  bool Try(const Property& property, uint64_t milliseconds, bool thorough, PropertyResult& result);
  /// Many of them side by side; what is found counts when it was repeated.
  bool TryWide(const Property& property, uint64_t milliseconds, PropertyResult& result);
  /// A run without the plant violates it: one with the plant takes its place where a short search finds one.
  void PreferPlanted(const Property& property, PropertyResult& result);
  /// A run has been found: whether the machine shows it. `violated`: the term by which it was computed, or none.
  void Conclude(const Property& property, PropertyResult found, terms::TermId violated, PropertyResult& result);

  /// Some states to which the last runs side by side came; none: there were no such runs.
  invariants::SeenStates SeenStates() const;

 private:
  bool TryPlanted(const Property& property, RunSearch search, PropertyResult& result);
  bool TryFound(const Property& property, std::optional<PropertyRun> run, PropertyResult& result);
  /// Inputs and requests on which the cells depend.
  void AddInputsBehind(const std::vector<execute::CellId>& cells, RunSearch& search);

  CheckedProgram& checked_;
  std::unique_ptr<WideSearch> wide_;  // of the present check, once it was needed
  uint32_t not_repeated_ = 0;         // runs of it
  uint32_t replays_ = 0;              // runs of this check that were asked why they are not shown
};

}  // namespace plcxx::prove::properties
