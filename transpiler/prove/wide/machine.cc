#include "transpiler/prove/wide/machine.h"

#include <algorithm>

namespace plcxx::prove::wide {
namespace {

constexpr uint8_t kTimeWidth = 32;

}  // namespace

std::vector<execute::CellId> DependedOn(const terms::Terms& terms, const machine::Relation& relation,
                                        std::span<const execute::CellId> wanted) {
  std::vector<bool> has_cell(relation.version().cells.count), has_term(terms.size());
  std::vector<execute::CellId> open(wanted.begin(), wanted.end());
  std::vector<terms::TermId> open_terms;
  for (const execute::CellId cell : open) has_cell[cell.index] = true;
  while (!open.empty() || !open_terms.empty()) {
    if (open_terms.empty()) {
      const execute::CellId cell = open.back();
      open.pop_back();
      relation.ForEachNext(cell, [&](terms::TermId term) { open_terms.push_back(term); });
      continue;
    }
    const terms::TermId id = open_terms.back();
    open_terms.pop_back();
    if (has_term[id.index]) continue;
    has_term[id.index] = true;
    if (terms[id].kind != terms::TermKind::kVariable) {
      terms.ForEachOperand(terms[id], [&](terms::TermId operand) { open_terms.push_back(operand); });
      continue;
    }
    const execute::CellId cell = relation.CellOf(id);
    if (!cell.valid() || has_cell[cell.index]) continue;
    has_cell[cell.index] = true;
    open.push_back(cell);
  }
  std::vector<execute::CellId> cells;
  for (uint32_t i = 0; i < has_cell.size(); ++i) {
    if (has_cell[i]) cells.emplace_back(i);
  }
  return cells;
}

machine::Transition PowerOnAlone(terms::Terms& terms, const machine::Version& version,
                                 const std::function<bool()>& is_late) {
  return machine::RunInit(terms, version,
                          {.initial = [&terms](execute::CellId) { return terms.Const(0, 64); },
                           .now = terms.Const(0, kTimeWidth),
                           .answers = machine::HostAnswers::kNothing,
                           .observed = {},
                           .is_late = is_late});
}

WideMachine::WideMachine(const terms::Terms& terms, machine::Relation& relation,
                         const std::vector<execute::CellId>& cells, const machine::Transition& init)
    : schedule_(relation.version().program->schedule),
      cells_(cells),
      first_plane_(relation.version().cells.count, kNowhere),
      width_(relation.version().cells.count) {
  const machine::Version& version = relation.version();
  for (const execute::CellId cell : cells) {
    const uint8_t width = execute::CellWidth(*version.program, execute::CellAt(*version.program, version.cells, cell));
    first_plane_[cell.index] = now_plane_;
    width_[cell.index] = width;
    now_plane_ += width;
    // What a host function answers at power-on is 0 here.
    const terms::TermId begins = init.next[cell.index];
    const uint64_t value = begins.valid() && terms.IsConst(begins) ? terms.Value(begins) : 0;
    for (uint8_t i = 0; i < width; ++i) at_power_on_.emplace_back().Fill((value >> i & 1) != 0);
  }
  at_power_on_.resize(now_plane_ + kTimeWidth);
  std::vector<terms::LaneProgram::VariableAt> variables;
  for (const execute::CellId cell : cells) {
    variables.push_back({relation.VariableOf(cell), first_plane_[cell.index]});
  }
  variables.push_back({relation.now(), now_plane_});
  const auto compile = [&](const std::vector<terms::TermId>& next, std::optional<PartProgram>& part) {
    std::vector<terms::TermId> roots;
    std::vector<execute::CellId> written;
    for (const execute::CellId cell : cells) {
      if (cell.index >= next.size() || !next[cell.index].valid()) continue;
      roots.push_back(next[cell.index]);
      written.push_back(cell);
    }
    if (roots.empty()) return;
    part.emplace(PartProgram{terms::LaneProgram(terms, variables, roots), std::move(written)});
  };
  compile(relation.fast(), fast_);
  compile(relation.period(), period_);
  PowerOn();
}

void WideMachine::PowerOn() { state_ = at_power_on_; }

void WideMachine::Load(uint32_t word, const std::function<uint64_t(execute::CellId)>& value) {
  for (const execute::CellId cell : cells_) {
    const uint64_t begins = value(cell);
    for (uint8_t i = 0; i < width_[cell.index]; ++i)
      state_[first_plane_[cell.index] + i].words[word] = (begins >> i & 1) != 0 ? ~uint64_t{0} : 0;
  }
}

std::span<terms::Plane> WideMachine::Planes(execute::CellId cell) {
  return {&state_[first_plane_[cell.index]], width_[cell.index]};
}
std::span<const terms::Plane> WideMachine::Planes(execute::CellId cell) const {
  return {&state_[first_plane_[cell.index]], width_[cell.index]};
}

void WideMachine::Run(machine::Part part, const Times& now_ms) {
  std::optional<PartProgram>& executed = part == machine::Part::kFast ? fast_ : period_;
  if (!executed) return;
  for (uint8_t i = 0; i < kTimeWidth; ++i) {
    state_[now_plane_ + i] =
        terms::MakePlane([&](uint32_t word) { return (now_ms[word] >> i & 1) != 0 ? ~uint64_t{0} : 0; });
  }
  executed->program.Run(state_);
  // A cell that keeps another one's value is that one's planes: all are read before any is written.
  next_.clear();
  for (size_t root = 0; root < executed->written.size(); ++root) {
    const std::span<const terms::Plane> planes = executed->program.Root(root);
    next_.insert(next_.end(), planes.begin(), planes.end());
  }
  size_t at = 0;
  for (const execute::CellId cell : executed->written) {
    std::copy_n(next_.begin() + static_cast<std::ptrdiff_t>(at), width_[cell.index],
                state_.begin() + first_plane_[cell.index]);
    at += width_[cell.index];
  }
}

void WideMachine::RunPeriod(const Times& begin_ms, uint32_t period_ms) {
  const auto after = [&begin_ms](uint32_t ms) {
    Times now = begin_ms;
    for (uint64_t& one : now) one += ms;
    return now;
  };
  const uint32_t fast_ms = schedule_.fast_ms;
  for (uint32_t ms = fast_ms; fast_ms != 0 && ms <= schedule_.period_ms; ms += fast_ms)
    Run(machine::Part::kFast, after(ms));
  const bool ends = schedule_.period_ends_its_time || fast_ms != 0;
  Run(machine::Part::kPeriod, after(ends ? period_ms : 0));
}

void WideMachine::Store(execute::CellId bit, const terms::Plane& where, const terms::Plane& value) {
  if (!Has(bit)) return;
  terms::Plane& plane = state_[first_plane_[bit.index]];
  plane = terms::Choice(where, value, plane);
}

void SpreadTimes(Times& times, const CopyOf& copy_of) {
  const Times before = times;
  for (uint32_t word = 0; word < terms::Plane::kWords; ++word) {
    if (copy_of[word] != kNoLane) times[word] = before[copy_of[word] / 64];
  }
}

void SpreadLanes(std::span<terms::Plane> planes, const CopyOf& copy_of) {
  for (terms::Plane& plane : planes) {
    const terms::Plane before = plane;
    for (uint32_t word = 0; word < terms::Plane::kWords; ++word) {
      if (copy_of[word] != kNoLane) plane.words[word] = before.Get(copy_of[word]) ? ~uint64_t{0} : 0;
    }
  }
}

}  // namespace plcxx::prove::wide
