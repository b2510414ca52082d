#include "transpiler/soak/goals.h"

#include <algorithm>
#include <bit>

#include "transpiler/ir/bit_logic.h"
#include "transpiler/ir/builder.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/support/hex.h"

namespace plcxx::soak {
namespace {

bool GivesCondition(const ir::Inst& inst) {
  if (inst.type != ir::Type::kBit || inst.op == ir::OpKind::kPoison) return false;
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kPure:
    case ir::Shape::kStep:
    case ir::Shape::kLoad:
    case ir::Shape::kText:
    case ir::Shape::kCall:
    case ir::Shape::kHostCall:
      return true;
    case ir::Shape::kConst:
    case ir::Shape::kStore:
    case ir::Shape::kStatement:
    case ir::Shape::kIf:
    case ir::Shape::kSwitch:
    case ir::Shape::kLoop:
    case ir::Shape::kBlock:
    case ir::Shape::kExit:
    case ir::Shape::kRepeat:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      return false;
  }
  return false;
}

}  // namespace

void GoalSet::Add(const GoalSet& other) {
  for (size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
}

void GoalSet::Remove(const GoalSet& other) {
  for (size_t i = 0; i < words_.size(); ++i) words_[i] &= ~other.words_[i];
}

size_t GoalSet::Count() const {
  size_t count = 0;
  for (const uint64_t word : words_) count += static_cast<size_t>(std::popcount(word));
  return count;
}

size_t GoalSet::CountShared(const GoalSet& other) const {
  size_t count = 0;
  for (size_t i = 0; i < words_.size(); ++i) count += static_cast<size_t>(std::popcount(words_[i] & other.words_[i]));
  return count;
}

std::string GoalSet::ToHex() const {
  std::string digits;
  for (const uint64_t word : words_) {
    for (unsigned nibble = 0; nibble < kBits / 4; ++nibble) digits += support::kHexDigits[word >> 4 * nibble & 15];
  }
  return digits;
}

bool GoalSet::FromHex(const std::string& digits, size_t goals) {
  *this = GoalSet(goals);
  constexpr size_t kNibbles = kBits / 4;
  if (digits.size() != kNibbles * words_.size()) return false;
  for (size_t i = 0; i < digits.size(); ++i) {
    const std::optional<uint8_t> value = support::HexValue(digits[i]);
    if (!value) return false;
    words_[i / kNibbles] |= uint64_t{*value} << 4 * (i % kNibbles);
  }
  for (size_t i = goals; i < kBits * words_.size(); ++i) {
    if (Has(i)) return false;
  }
  return true;
}

Goals::Goals(const ir::Program& program)
    : program_(program), statement_of_(program.insts.size()), is_decision_(program.insts.size()) {
  for (const ir::Routine& routine : program.routines) {
    if (routine.simulation_only) continue;
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) Walk(region, {});
  }
  std::vector<std::vector<ir::InstId>> marks(program.statements.size());
  for (uint32_t i = 0; i < program.insts.size(); ++i) {
    const ir::InstId id(i);
    if (program[id].op == ir::OpKind::kStatement && statement_of_[i].valid()) {
      marks[program[id].payload].push_back(id);
    }
  }
  constexpr uint8_t kAny = sim::Simulator::kGave0 | sim::Simulator::kGaveOther;
  for (uint32_t i = 0; i < marks.size(); ++i) {
    if (marks[i].empty()) continue;
    goals_.push_back({GoalKind::kStatement, ir::StatementId(i), std::move(marks[i]), kAny});
  }
  for (uint32_t i = 0; i < program.insts.size(); ++i) {
    const ir::InstId id(i);
    const ir::Inst& inst = program[id];
    const ir::StatementId statement = statement_of_[i];
    if (!statement.valid()) continue;
    if (GivesCondition(inst) && (is_decision_[i] || !ir::IsBitLogic(inst))) {
      goals_.push_back({GoalKind::kCondition, statement, {id}, sim::Simulator::kGave0});
      goals_.push_back({GoalKind::kCondition, statement, {id}, sim::Simulator::kGaveOther});
    }
    if (inst.op != ir::OpKind::kSwitch) continue;
    for (const ir::SwitchCase& one : program.switches[ir::SwitchId(inst.payload)].cases) {
      if (!one.region.valid() || program.regions[one.region].insts.empty()) continue;
      goals_.push_back({GoalKind::kCase, statement, {program.regions[one.region].insts.front()}, kAny});
    }
  }
  std::ranges::stable_sort(goals_, {}, [](const Goal& goal) { return goal.statement.index; });
  statement_of_.clear();
  is_decision_.clear();
}

void Goals::MarkDecision(uint32_t value) {
  if (value < is_decision_.size()) is_decision_[value] = true;
}

void Goals::Walk(ir::RegionId region, ir::StatementId statement) {
  if (!region.valid()) return;
  for (const ir::InstId id : program_.regions[region].insts) {
    const ir::Inst& inst = program_[id];
    if (inst.op == ir::OpKind::kStatement) statement = ir::StatementId(inst.payload);
    statement_of_[id.index] = statement;
    switch (ir::Info(inst.op).shape) {
      case ir::Shape::kStore:
      case ir::Shape::kIf:
      case ir::Shape::kExit:
      case ir::Shape::kRepeat:
        MarkDecision(inst.a);
        break;
      case ir::Shape::kLoop: {
        const ir::RegionId condition = program_.loops[ir::LoopId(inst.payload)].condition;
        if (condition.valid() && !program_.regions[condition].insts.empty()) {
          MarkDecision(program_.regions[condition].insts.back().index);
        }
        break;
      }
      case ir::Shape::kPure:
      case ir::Shape::kStep:
      case ir::Shape::kConst:
      case ir::Shape::kLoad:
      case ir::Shape::kText:
      case ir::Shape::kStatement:
      case ir::Shape::kSwitch:
      case ir::Shape::kBlock:
      case ir::Shape::kCall:
      case ir::Shape::kHostCall:
      case ir::Shape::kJump:
      case ir::Shape::kLabel:
        break;
    }
    if (ir::Info(inst.op).effect != ir::Effect::kControl) continue;
    for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) Walk(owned, statement);
  }
}

GoalSet Goals::Reached(std::span<const uint8_t> given) const {
  GoalSet reached(goals_.size());
  for (size_t i = 0; i < goals_.size(); ++i) {
    for (const ir::InstId inst : goals_[i].insts) {
      if ((given[inst.index] & goals_[i].given) != 0) {
        reached.Add(i);
        break;
      }
    }
  }
  return reached;
}

}  // namespace plcxx::soak
