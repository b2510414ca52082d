#include "transpiler/dialects/technol/analysis/flow.h"

#include <algorithm>
#include <map>

namespace plcxx::technol {
namespace {

enum Mark : uint8_t { kNew, kOpen, kDone };

/// Does a path of several instructions come to it?
bool IsLabelled(const Instruction& instruction) { return instruction.labels.count > 0; }

}  // namespace

Flow::Flow(const Program& program) : program_(program) {
  for (uint32_t i = 0; i < program.units.size(); ++i) {
    const Unit& unit = program.units[UnitId(i)];
    if (unit.kind == UnitKind::kModule && unit.first.valid()) roots_.push_back({unit.first, UnitId(i)});
    if (unit.kind == UnitKind::kMechanism && unit.first.valid()) {
      roots_.push_back({InstructionId(unit.first.index + 1), UnitId(i)});
    }
  }
  FindSubprograms();
  FindReached();
  FindWidths();
  FindLive();
  FindPushes();
}

bool Flow::MayWait(const Instruction& instruction) const {
  if (!instruction.unit.valid()) return false;
  const Unit& unit = program_.units[instruction.unit];
  return unit.kind == UnitKind::kMechanism || (unit.kind == UnitKind::kModule && Info(unit.module).waits);
}

std::optional<uint32_t> Flow::CalleeOf(const Instruction& call) const {
  if (call.faulty || call.operands.count == 0) return std::nullopt;
  const Operand& operand = program_.OperandOf(call, 0);
  if (operand.kind != OperandKind::kLabel || !operand.label.valid()) return std::nullopt;
  return subprogram_of_label_[operand.label.index];
}

InstructionId Flow::ResumeOf(InstructionId wait) const {
  const Instruction& instruction = program_.instructions[wait];
  if (instruction.op == Op::kEx) return InstructionId(wait.index + 1);
  if (instruction.op == Op::kTim) return wait;
  InstructionId at = wait;
  while (!IsLabelled(program_.instructions[at]) && at.index > 0) {
    const Instruction& before = program_.instructions[InstructionId(at.index - 1)];
    if (before.unit != instruction.unit || !IsPure(program_, before)) break;
    at = InstructionId(at.index - 1);
  }
  return at;
}

/// Depth first from the first call in source order: cycles show in the order that 10.4 asks for.
void Flow::VisitCalls(InstructionId from, std::vector<uint8_t>& marks, uint32_t level) {
  const std::vector<InstructionId> order = CollectFrom(from);
  for (const InstructionId id : order) {
    const Instruction& call = program_.instructions[id];
    if (call.op != Op::kCall) continue;
    const auto callee = CalleeOf(call);
    if (!callee) continue;
    if (marks[*callee] == kOpen) recursions_.push_back(id);
    if (marks[*callee] != kNew) continue;
    marks[*callee] = kOpen;
    VisitCalls(EntryOf(*callee), marks, level + 1);
    marks[*callee] = kDone;
    calls_first_.push_back(*callee);
  }
}

/// The instructions on paths from `entry`, in source order.
void Flow::CollectFrom(InstructionId entry, std::vector<bool>& seen, std::vector<InstructionId>& order) const {
  std::vector<InstructionId> work = {entry};
  seen[entry.index] = true;
  while (!work.empty()) {
    const InstructionId id = work.back();
    work.pop_back();
    order.push_back(id);
    ForEachSuccessor(id, [&](InstructionId to, Edge) {
      if (seen[to.index]) return;
      seen[to.index] = true;
      work.push_back(to);
    });
  }
  std::sort(order.begin(), order.end());
}

std::vector<InstructionId> Flow::CollectFrom(InstructionId entry) const {
  seen_.resize(program_.instructions.size());
  std::vector<InstructionId> order;
  CollectFrom(entry, seen_, order);
  for (const InstructionId id : order) seen_[id.index] = false;
  return order;
}

void Flow::FindSubprograms() {
  subprogram_of_label_.resize(program_.labels.size());
  std::map<InstructionId, uint32_t> subprogram_at;
  for (uint32_t i = 0; i < program_.instructions.size(); ++i) {
    const Instruction& call = program_.instructions[InstructionId(i)];
    if (call.op != Op::kCall || call.faulty || call.operands.count == 0) continue;
    const Operand& operand = program_.OperandOf(call, 0);
    if (operand.kind != OperandKind::kLabel || !operand.label.valid()) continue;
    std::optional<uint32_t>& number = subprogram_of_label_[operand.label.index];
    if (!number) {
      // Labels of one instruction are one subprogram.
      const auto [known, is_new] =
          subprogram_at.try_emplace(program_.labels[operand.label].at, static_cast<uint32_t>(subprograms_.size()));
      if (!is_new) number = known->second;
    }
    if (!number) {
      number = static_cast<uint32_t>(subprograms_.size());
      subprograms_.push_back({operand.label, 0, {}});
    }
    subprograms_[*number].calls.push_back(InstructionId(i));
  }
  std::vector<uint8_t> marks(subprograms_.size(), kNew);
  for (uint32_t i = 0; i < subprograms_.size(); ++i) {
    if (marks[i] != kNew) continue;
    marks[i] = kOpen;
    VisitCalls(EntryOf(i), marks, 1);
    marks[i] = kDone;
    calls_first_.push_back(i);
  }
  FindLevels();
}

void Flow::FindLevels() {
  const auto raise = [&](InstructionId from, uint32_t level) {
    const std::vector<InstructionId> order = CollectFrom(from);
    for (const InstructionId id : order) {
      if (program_.instructions[id].op != Op::kCall) continue;
      if (const auto callee = CalleeOf(program_.instructions[id])) {
        subprograms_[*callee].level = std::max(subprograms_[*callee].level, level + 1);
      }
    }
  };
  for (const Root& root : roots_) raise(root.at, 0);
  // Callers before the called: backward through the order that has the called first.
  if (!recursions_.empty()) return;
  for (size_t i = calls_first_.size(); i-- > 0;) raise(EntryOf(calls_first_[i]), subprograms_[calls_first_[i]].level);
}

void Flow::FindReached() {
  reached_.resize(program_.instructions.size());
  std::vector<InstructionId> work;
  const auto reach = [&](InstructionId id) {
    if (reached_[id.index]) return;
    reached_[id.index] = true;
    work.push_back(id);
  };
  for (const Root& root : roots_) reach(root.at);
  while (!work.empty()) {
    const InstructionId id = work.back();
    work.pop_back();
    ForEachSuccessor(id, [&](InstructionId to, Edge) { reach(to); });
    const Instruction& instruction = program_.instructions[id];
    if (instruction.op != Op::kCall) continue;
    if (const auto callee = CalleeOf(instruction)) reach(EntryOf(*callee));
  }
}

/// The width after an instruction that is no CALL; 0 where nothing has been loaded.
uint32_t Flow::WidthAfter(InstructionId id) const {
  const Instruction& instruction = program_.instructions[id];
  const uint32_t width = widths_[id.index], before = width == 0 ? 16 : width;
  const Resources writes = EffectsOf(program_, instruction, before).writes;
  const bool loads = (writes & PartsOf(Register::kCx)) != 0 && !instruction.faulty;
  return loads ? WidthBehind(program_, instruction, before) : width;
}

/// bring(to, width) for everything that takes over the width after `id`.
template <class Bring>
void Flow::BringWidths(InstructionId id, const std::vector<uint8_t>& leaves, Bring&& bring) const {
  const Instruction& instruction = program_.instructions[id];
  uint32_t behind = 0;
  if (instruction.op == Op::kCall) {
    if (const auto callee = CalleeOf(instruction)) {
      bring(EntryOf(*callee), widths_[id.index]);
      behind = leaves[*callee];
    }
  } else {
    behind = WidthAfter(id);
  }
  ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
    if (edge == Edge::kOn || edge == Edge::kJump) bring(to, behind);
  });
}

std::vector<std::vector<uint32_t>> Flow::OwnersOfReturns() const {
  std::vector<std::vector<uint32_t>> owners(program_.instructions.size());
  for (uint32_t k = 0; k < subprograms_.size(); ++k) {
    const std::vector<InstructionId> order = CollectFrom(EntryOf(k));
    for (const InstructionId id : order) {
      if (program_.instructions[id].op == Op::kRet) owners[id.index].push_back(k);
    }
  }
  return owners;
}

/// Over the whole program at once: a subprogram begins with what all its calls bring, and after a call is what all
/// its RETs leave (6.1). Widths only grow.
void Flow::FindWidths() {
  const size_t count = program_.instructions.size();
  widths_.assign(count, 0);
  const std::vector<std::vector<uint32_t>> owners = OwnersOfReturns();
  std::vector<uint8_t> leaves(subprograms_.size(), 0);
  bool changed = true;
  const auto grow = [&changed](uint8_t& known, uint32_t width) {
    if (width <= known) return;
    known = static_cast<uint8_t>(width);
    changed = true;
  };
  while (changed) {
    changed = false;
    for (uint32_t i = 0; i < count; ++i) {
      const InstructionId id(i);
      for (const uint32_t k : owners[i]) grow(leaves[k], widths_[i]);
      BringWidths(id, leaves, [&](InstructionId to, uint32_t width) { grow(widths_[to.index], width); });
    }
  }
  std::vector<uint8_t> narrow(count), returns_narrow(subprograms_.size());  // some path brings 16 bits
  for (uint32_t i = 0; i < count; ++i) {
    if (!reached_[i]) continue;
    BringWidths(InstructionId(i), leaves, [&](InstructionId to, uint32_t width) { narrow[to.index] |= width == 16; });
    for (const uint32_t k : owners[i]) returns_narrow[k] |= widths_[i] == 16;
  }
  for (uint32_t k = 0; k < subprograms_.size(); ++k) {
    if (leaves[k] != 32 || returns_narrow[k] == 0) continue;
    for (const InstructionId call : subprograms_[k].calls) narrow[call.index + 1] = 1;
  }
  for (uint32_t i = 0; i < count; ++i) {
    if (narrow[i] != 0 && widths_[i] == 32) width_joins_.push_back(InstructionId(i));
  }
}

void Flow::FindPushes() {
  const size_t count = program_.instructions.size();
  pushes_.assign(count, 0);
  States<uint32_t> depths(program_);
  const auto from = [&](InstructionId entry) {
    Spread(
        *this, entry, 0U, depths,
        [&](InstructionId id, uint32_t depth, Edge) {
          const Op op = program_.instructions[id].op;
          return op == Op::kPush ? depth + 1 : op == Op::kPop && depth > 0 ? depth - 1 : depth;
        },
        [](uint32_t&, uint32_t) { return false; });
    for (const InstructionId id : depths.Reached()) pushes_[id.index] = *depths[id];
  };
  for (const Root& root : roots_) from(root.at);
  for (uint32_t k = 0; k < subprograms_.size(); ++k) from(EntryOf(k));
}

Resources Flow::LiveBeforeSubprogram(uint32_t subprogram) const { return live_before_[EntryOf(subprogram).index]; }

void Flow::FindLive() {
  const size_t count = program_.instructions.size();
  live_before_.assign(count, 0);
  live_behind_.assign(count, 0);
  std::vector<Resources> behind_ret(subprograms_.size(), 0);
  const std::vector<std::vector<uint32_t>> owners = OwnersOfReturns();
  for (bool changed = true; changed;) {
    changed = false;
    for (size_t i = count; i-- > 0;) {
      const InstructionId id(static_cast<uint32_t>(i));
      const Instruction& instruction = program_.instructions[id];
      Resources behind = 0;
      ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
        if (edge == Edge::kOn || edge == Edge::kJump) behind |= live_before_[to.index];
      });
      for (const uint32_t k : owners[i]) behind |= behind_ret[k];
      const uint32_t width = widths_[i] == 0 ? 16 : widths_[i];
      const Effects effects = EffectsOf(program_, instruction, width);
      Resources before = (behind & ~(effects.writes | effects.undefines)) | effects.reads;
      before |= behind & effects.may_keep;
      if (instruction.op == Op::kCall) {
        if (const auto callee = CalleeOf(instruction)) {
          behind_ret[*callee] |= behind;
          before = live_before_[EntryOf(*callee).index];  // what it does not touch lives through it
        }
      }
      if (before == live_before_[i] && behind == live_behind_[i]) continue;
      live_before_[i] = before;
      live_behind_[i] = behind;
      changed = true;
    }
  }
}

}  // namespace plcxx::technol
