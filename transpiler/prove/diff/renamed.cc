#include "transpiler/prove/diff/renamed.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>

#include "transpiler/prove/machine/inputs.h"
#include "transpiler/support/low_bits.h"
#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::prove::diff {
namespace {

constexpr size_t kMostCells = 400;             // of one version
constexpr size_t kMostTermsOfParts = 100'000;  // of which the parts are made
constexpr uint64_t kSamples = 24;
constexpr int kMostRounds = 8;

uint64_t Mixed(uint64_t a, uint64_t b) {
  uint64_t value = (a ^ (b + 0x9E3779B97F4A7C15)) * 0xBF58476D1CE4E5B9;
  value = (value ^ (value >> 29)) * 0x94D049BB133111EB;
  return value ^ (value >> 32);
}

/// A cell that one version alone has.
struct OwnCell {
  Which which;
  execute::CellId cell;
  uint32_t variable = 0;  // that its value is, or a bit of it
  uint8_t bit = 0, width = 1;
  uint64_t kind = 0;                // the class so far: cells of two classes are not the same
  std::vector<terms::TermId> next;  // by part
  bool is_needed = false;           // something is computed from what it was before
};

class OwnCells {
 public:
  explicit OwnCells(Comparison& comparison) : comparison_(comparison), terms_(comparison.terms) {
    Add(Which::kOld, comparison.one_sided.old_only, comparison.old_uses);
    Add(Which::kNew, comparison.one_sided.new_only, comparison.new_uses);
  }

  bool AreOnBothSides() const {
    const auto is_old = [](const OwnCell& own) { return own.which == Which::kOld; };
    return !own_.empty() && is_old(own_.front()) && !is_old(own_.back());
  }
  /// false: not in time.
  bool AddParts();
  /// By the part that was executed last, the period.
  void FindNeeded();
  void Refine();
  std::vector<std::pair<execute::CellId, execute::CellId>> Pairs() const;

 private:
  void Add(Which which, const std::vector<execute::CellId>& cells, const machine::Uses& uses);
  /// By variable.
  std::vector<uint64_t> Sample(uint64_t sample) const;
  size_t ClassCount() const {
    std::set<uint64_t> kinds;
    for (const OwnCell& own : own_) kinds.insert(own.kind);
    return kinds.size();
  }

  Comparison& comparison_;
  const terms::Terms& terms_;
  std::vector<OwnCell> own_;  // the old version's first
  std::vector<terms::TermId> cone_;
};

void OwnCells::Add(Which which, const std::vector<execute::CellId>& cells, const machine::Uses& uses) {
  const machine::Version& version = comparison_.pairing.version(which);
  size_t count = 0;
  for (const execute::CellId cell : cells) {
    // What is only written decides nothing.
    if (!uses.reads[cell.index] || ++count > kMostCells) continue;
    const terms::TermId initial = comparison_.pairing.Initial(which, cell);
    OwnCell own{.which = which, .cell = cell, .width = terms_.Width(initial), .next = {}};
    const terms::Term& term = terms_[initial];
    const bool is_part = term.kind == terms::TermKind::kExtract;
    const terms::Term& variable = is_part ? terms_[terms::TermId(term.a)] : term;
    if (variable.kind != terms::TermKind::kVariable) continue;  // it never changes
    own.variable = variable.a;
    own.bit = is_part ? static_cast<uint8_t>(term.b) : uint8_t{0};
    own.kind = Mixed(own.width, machine::PowerOnValue(version, cell) ? 1 : 0);
    own_.push_back(std::move(own));
  }
}

bool OwnCells::AddParts() {
  std::vector<terms::TermId> roots;
  for (const machine::Part part : PartsOf(comparison_)) {
    if (!ExecutePart(comparison_, part)) return false;
    for (OwnCell& own : own_) {
      own.next.push_back(own.which == Which::kOld ? comparison_.NextOld(own.cell) : comparison_.NextNew(own.cell));
      roots.push_back(own.next.back());
    }
  }
  cone_ = terms::ConeOf(terms_, roots);
  if (cone_.size() > kMostTermsOfParts) return false;
  FindNeeded();
  return true;
}

void OwnCells::FindNeeded() {
  std::vector<terms::TermId> computed;
  for (const OwnCell& own : own_) {
    const terms::TermId before = comparison_.pairing.Initial(own.which, own.cell);
    std::ranges::copy_if(own.next, std::back_inserter(computed),
                         [before](terms::TermId next) { return next != before; });
  }
  for (const PairResult& result : comparison_.results) {
    for (const terms::TermId next : {comparison_.NextOld(result.old_cell), comparison_.NextNew(result.new_cell)}) {
      if (next != comparison_.pairing.Initial(Which::kOld, result.old_cell)) computed.push_back(next);
    }
  }
  const std::vector<terms::TermId> cone = terms::ConeOf(terms_, computed);
  for (OwnCell& own : own_) {
    const terms::TermId before = comparison_.pairing.Initial(own.which, own.cell);
    const terms::Term& term = terms_[before];
    const terms::TermId whole = term.kind == terms::TermKind::kExtract ? terms::TermId(term.a) : before;
    own.is_needed = std::ranges::binary_search(cone, before) || std::ranges::binary_search(cone, whole);
  }
}

std::vector<uint64_t> OwnCells::Sample(uint64_t sample) const {
  std::vector<uint64_t> variables(terms_.variable_count());
  for (uint64_t i = 0; i < variables.size(); ++i) variables[i] = Mixed(i, sample);
  for (const OwnCell& own : own_) {
    const uint64_t mask = support::LowBits(own.width) << own.bit;
    uint64_t& variable = variables[own.variable];
    variable = (variable & ~mask) | (Mixed(own.kind, ~sample) << own.bit & mask);
  }
  return variables;
}

void OwnCells::Refine() {
  std::vector<uint64_t> values(terms_.size());
  const auto value = [&values](terms::TermId id) { return values[id.index]; };
  for (int round = 0; round < kMostRounds && !comparison_.Late(); ++round) {
    const size_t before = ClassCount();
    std::vector<uint64_t> kinds;
    for (const OwnCell& own : own_) kinds.push_back(own.kind);
    for (uint64_t sample = 0; sample < kSamples; ++sample) {
      const std::vector<uint64_t> variables = Sample(sample);
      for (const terms::TermId id : cone_) {
        values[id.index] =
            terms::EvaluateTerm(terms_, terms_[id], value, [&](uint32_t number) { return variables[number]; });
      }
      for (size_t i = 0; i < own_.size(); ++i) {
        for (const terms::TermId next : own_[i].next) kinds[i] = Mixed(kinds[i], values[next.index]);
      }
    }
    for (size_t i = 0; i < own_.size(); ++i) own_[i].kind = kinds[i];
    if (ClassCount() == before) return;
  }
}

std::vector<std::pair<execute::CellId, execute::CellId>> OwnCells::Pairs() const {
  std::map<uint64_t, std::array<std::vector<execute::CellId>, 2>> classes;
  // Of some that hold the same those count whose last value is looked at: a flag that is written anew before it is read
  // is nobody's memory.
  for (const bool is_needed : {true, false}) {
    for (const OwnCell& own : own_) {
      if (own.is_needed == is_needed) classes[own.kind][own.which == Which::kOld ? 0 : 1].push_back(own.cell);
    }
  }
  std::vector<std::pair<execute::CellId, execute::CellId>> pairs;
  for (const auto& [kind, cells] : classes) {
    for (size_t i = 0; i < std::min(cells[0].size(), cells[1].size()); ++i)
      pairs.emplace_back(cells[0][i], cells[1][i]);
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace

std::vector<std::pair<execute::CellId, execute::CellId>> GuessRenamed(Comparison& comparison) {
  OwnCells own(comparison);
  if (!own.AreOnBothSides() || !own.AddParts()) return {};
  own.Refine();
  return own.Pairs();
}

}  // namespace plcxx::prove::diff
