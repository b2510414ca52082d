// Executor: loops.
#include <algorithm>
#include <array>
#include <utility>

#include "transpiler/ir/builder.h"
#include "transpiler/support/fnv1a.h"
#include "transpiler/symbolic/execute/executor.h"
#include "transpiler/symbolic/execute/known_here.h"
#include "transpiler/symbolic/execute/summary.h"

namespace plcxx::execute {
namespace {

constexpr uint8_t kRoundWidth = 32;
constexpr uint64_t kMostCounted = 0xFFFFFFFF;
constexpr size_t kMostSamples = 16;  // heads of one loop that are looked at

}  // namespace

bool IsShort(const ir::Program& program, const ir::Loop& loop, uint32_t most) {
  if (loop.kind != ir::LoopBound::kProven || loop.bound > most) return false;
  uint64_t insts = 0;
  for (const ir::RegionId region : {loop.condition, loop.body, loop.step}) {
    if (region.valid()) ir::ForEachInst(program, region, [&insts](ir::InstId) { ++insts; });
  }
  return insts * loop.bound <= most;
}

void Executor::ExecuteLoop(ir::InstId id, const ir::Inst& inst) {
  const ir::Loop& loop = program_.loops[ir::LoopId(inst.payload)];
  if (const LoopPolicy* policy = memory_.environment().loops; policy != nullptr) {
    if (policy->heads != nullptr && sampling_ == 0) {
      ExecuteByHead(id, loop);
    } else {
      UnrollLoop(id, loop, 0, nullptr);
    }
    return;
  }
  const uint32_t most = memory_.environment().summarize_after;
  const std::set<ir::InstId>* const never = memory_.environment().never_unrolled;
  const bool may_unroll = never == nullptr || !never->contains(id);
  const bool is_short = (loop.kind == ir::LoopBound::kProven && loop.bound <= most) ||
                        (may_unroll && IsShort(program_, loop, memory_.environment().unroll_up_to));
  if (most == 0 || is_short) {
    UnrollLoop(id, loop, 0, nullptr);
    return;
  }
  const Flow before = flow_;
  memory_.BeginChanges();
  const Unrolled unrolled = UnrollLoop(id, loop, most, nullptr);
  const std::vector<Memory::Change> changes = memory_.TakeChanges();
  if (unrolled == Unrolled::kWhole) {
    for (const Memory::Change& change : changes) memory_.Write(change.cell, change.value);
    return;
  }
  flow_ = before;
  if (memory_.environment().holds) {
    FollowLoop(id, loop);
  } else {
    ExecuteSummary(id);
  }
}

void Executor::FollowLoop(ir::InstId id, const ir::Loop& loop) {
  const terms::TermId before = flow_.active;
  std::vector<Leaving> outer = std::exchange(flow_.leaving, {});
  terms::TermId done = terms_.Bit(false);
  for (uint64_t round = 0; memory_.environment().holds(Absolute()) && refusal_.empty(); ++round) {
    if (round > memory_.environment().most_rounds) {
      Refuse("a loop goes round more than " + std::to_string(memory_.environment().most_rounds) + " times");
      return;
    }
    flow_.active = ExecuteRound(id, loop, terms_.Const(round, kRoundWidth), done);
  }
  if (!terms_.IsFalse(flow_.active) && refusal_.empty()) {
    // Where there were further rounds, all that the loop writes would be another: what is, is so for there are none.
    const terms::TermId further = std::exchange(flow_.active, terms_.Bit(true));
    const std::vector<Leaving> left = std::exchange(flow_.leaving, {});
    std::vector<Arm> arms;
    arms.push_back(RunArm(further, [&] { ExecuteSummary(id); }));
    const terms::TermId through = std::exchange(arms.back().flow.active, terms_.Bit(true));
    Join(std::move(arms));
    for (const Leaving& leaving : left) Leave(leaving.target, leaving.repeats, leaving.when);
    done = terms_.Or(done, terms_.And(further, through));
  }
  if (refusal_.empty()) flow_.active = flow_.leaving.empty() ? before : done;
  for (const Leaving& leaving : outer) Leave(leaving.target, leaving.repeats, leaving.when);
}

bool Executor::IsKnownNotToGoOn(ir::InstId loop) {
  return memory_.environment().never_holds && memory_.environment().never_holds(loop, Absolute());
}

Executor::Unrolled Executor::UnrollLoop(ir::InstId id, const ir::Loop& loop, uint32_t most_unknown,
                                        std::vector<Sample>* samples) {
  LoopPolicy* policy = memory_.environment().loops;
  const terms::TermId before = flow_.active;
  std::vector<Leaving> outer = std::exchange(flow_.leaving, {});
  terms::TermId done = terms_.Bit(false);
  uint32_t unknown = 0;
  std::set<CellId> rewritten;
  for (uint64_t round = 0; !terms_.IsFalse(flow_.active); ++round) {
    if (round > 0 && flow_.active != before) ++unknown;
    if ((most_unknown != 0 || policy != nullptr) && unknown > 0 && IsKnownNotToGoOn(id)) {
      flow_.active = terms_.Bit(false);
      break;
    }
    if (most_unknown != 0 && unknown > most_unknown) return Unrolled::kGivenUp;
    const bool too_many = round > memory_.environment().most_rounds;
    if (policy != nullptr && (unknown > policy->rounds || too_many)) {
      policy->left_out = terms_.Or(policy->left_out, Absolute());
      flow_.active = terms_.Bit(false);
      break;
    }
    if (too_many) {
      Refuse("a loop may go round more than " + std::to_string(memory_.environment().most_rounds) + " times");
      break;
    }
    const terms::TermId number = terms_.Const(round, kRoundWidth);
    if (samples != nullptr && samples->size() < kMostSamples)
      samples->push_back({terms_.And(Absolute(), terms_.Not(policy->left_out)), memory_.values()});
    flow_.active = ExecuteRound(id, loop, number, done, policy == nullptr ? &rewritten : nullptr);
  }
  if (refusal_.empty()) {
    flow_.active = flow_.leaving.empty() ? before : terms_.Or(done, flow_.active);
  }
  for (const Leaving& leaving : outer) Leave(leaving.target, leaving.repeats, leaving.when);
  return Unrolled::kWhole;
}

void Executor::ExecuteSummary(ir::InstId id) {
  const LoopSummary summary = SummarizeLoop(program_, memory_.cells(), id);
  if (summary.opaque) {
    Refuse(
        "a loop that may go round any number of times calls a function that writes the state, or repeats another loop");
    return;
  }
  // Its arguments, in words of up to 64 bits; one term then stands for all that the loop knows.
  std::vector<terms::TermId> arguments;
  for (const ir::ValueId value : summary.outside) arguments.push_back(ValueOf(value.index));
  terms::TermId word;
  for (size_t i = 0; i < summary.cells.size(); ++i) {
    if (!summary.reads[i]) continue;
    const terms::TermId part = memory_.Read(summary.cells[i]);
    if (word.valid() && terms_.Width(word) + terms_.Width(part) <= 64) {
      word = terms_.Concat(part, word);
      continue;
    }
    if (word.valid()) arguments.push_back(word);
    word = part;
  }
  if (word.valid()) arguments.push_back(word);
  arguments.push_back(memory_.environment().now);
  const std::string name = std::string(kLoopFunction) + std::to_string(support::HashOf64(summary.text)) + "." +
                           std::to_string(summary.text.size());
  const terms::TermId known = terms_.Apply(terms_.Function(name, 64), arguments);
  const auto result = [&](const std::string& what, uint8_t width, terms::TermId before = {}) {
    const std::array<terms::TermId, 2> from = {known, before};
    return terms_.Apply(terms_.Function(name + " " + what, width), {from.data(), before.valid() ? size_t{2} : 1});
  };
  for (const uint32_t number : summary.written) {
    const CellId cell = summary.cells[number];
    const uint8_t width = CellWidth(program_, CellAt(program_, memory_.cells(), cell));
    const terms::TermId before = summary.reads[number] ? terms::TermId() : memory_.Read(cell);
    WriteCell(cell, result("cell " + std::to_string(number), width, before));
  }
  for (size_t i = 0; i < summary.targets.size(); ++i) {
    const terms::TermId leaves = terms_.And(flow_.active, result("leaves " + std::to_string(i), 1));
    Leave(summary.targets[i], false, leaves);
    flow_.active = terms_.And(flow_.active, terms_.Not(leaves));
  }
}

std::map<CellId, terms::TermId> Executor::WriteKnown(terms::TermId when, const std::set<CellId>& cells) {
  std::map<CellId, terms::TermId> written;
  if (terms_.IsTrue(when) || cells.empty()) return written;
  KnownHere known(terms_, when);
  for (const CellId cell : cells) {
    const terms::TermId before = memory_.Read(cell);
    if (terms_.Width(before) != 1 || terms_.IsConst(before)) continue;
    const std::optional<bool> value = known.ValueOf(before);
    if (!value) continue;
    written[cell] = terms_.Bit(*value);
    memory_.Write(cell, written[cell]);
  }
  return written;
}

void Executor::NoteRewritten(std::vector<Memory::Change>& changes, const std::map<CellId, terms::TermId>& known,
                             std::set<CellId>& rewritten) {
  std::erase_if(changes, [&](const Memory::Change& change) {
    const auto at = known.find(change.cell);
    return at != known.end() && at->second == change.value;
  });
  for (const Memory::Change& change : changes) rewritten.insert(change.cell);
}

void Executor::ExecuteKnowing(ir::RegionId region, std::set<CellId>* rewritten) {
  if (rewritten == nullptr) {
    ExecuteRegion(region);
    return;
  }
  const terms::TermId when = flow_.active;
  memory_.BeginChanges();
  const std::map<CellId, terms::TermId> known = WriteKnown(when, *rewritten);
  ExecuteRegion(region);
  std::vector<Memory::Change> changes = memory_.TakeChanges();
  NoteRewritten(changes, known, *rewritten);
  for (const Memory::Change& change : changes) {
    // What is known is so where the region is executed, and nowhere else.
    memory_.Write(change.cell, known.contains(change.cell) ? terms_.Ite(when, change.value, memory_.Read(change.cell))
                                                           : change.value);
  }
}

terms::TermId Executor::ExecuteRound(ir::InstId id, const ir::Loop& loop, terms::TermId number, terms::TermId& done,
                                     std::set<CellId>* rewritten) {
  const auto finish = [&](terms::TermId when) { done = terms_.Or(done, when); };
  if (loop.condition.valid()) {
    ExecuteKnowing(loop.condition, rewritten);
    finish(TakeLeaving(id, false));
    if (terms_.IsFalse(flow_.active)) return flow_.active;
    const terms::TermId condition = ValueOf(program_.regions[loop.condition].insts.back().index);
    finish(terms_.And(flow_.active, terms_.Not(condition)));
    flow_.active = terms_.And(flow_.active, condition);
    if (terms_.IsFalse(flow_.active)) return flow_.active;
  }
  const bool counts = loop.kind != ir::LoopBound::kBudget && loop.bound <= kMostCounted;
  const terms::TermId over = counts ? terms_.Ule(terms_.Const(loop.bound, kRoundWidth), number) : terms_.Bit(false);
  if (loop.kind == ir::LoopBound::kProven) {
    // The front end has shown that nobody comes here.
    finish(terms_.And(flow_.active, over));
    flow_.active = terms_.And(flow_.active, terms_.Not(over));
  }
  if (terms_.IsFalse(flow_.active)) return flow_.active;
  const terms::TermId running = flow_.active;
  const terms::TermId exhausts = loop.kind == ir::LoopBound::kGuard ? over : terms_.Bit(false);
  // The body as an arm of its own: what it computes is not guarded inside, only joined after.
  flow_.active = terms_.Bit(true);
  const std::vector<Leaving> outer = std::exchange(flow_.leaving, {});
  std::vector<Arm> arms;
  const auto run = [&](terms::TermId when, ir::RegionId region) {
    if (terms_.IsFalse(when)) return when;
    std::map<CellId, terms::TermId> known;
    arms.push_back(RunArm(when, [&] {
      if (rewritten != nullptr) known = WriteKnown(when, *rewritten);
      ExecuteRegion(region);
    }));
    if (rewritten != nullptr) NoteRewritten(arms.back().changes, known, *rewritten);
    const terms::TermId fell_through = std::exchange(arms.back().flow.active, terms_.Bit(true));
    return terms_.And(when, fell_through);
  };
  const terms::TermId through = run(terms_.And(running, terms_.Not(exhausts)), loop.body);
  const terms::TermId exhausted = run(terms_.And(running, exhausts), loop.exhausted);
  Join(std::move(arms));
  if (!refusal_.empty()) return terms_.Bit(false);
  finish(TakeLeaving(id, false));
  const terms::TermId next = TakeLeaving(id, true);
  for (const Leaving& leaving : outer) Leave(leaving.target, leaving.repeats, leaving.when);
  finish(exhausted);
  if (loop.kind == ir::LoopBound::kBudget) {
    finish(through);
    return next;
  }
  if (loop.step.valid() && !terms_.IsFalse(through)) {
    flow_.active = through;
    ExecuteKnowing(loop.step, rewritten);
  }
  return terms_.Or(next, through);
}

/// Cells of bytes that are not what they were; of the other bytes what was written is what was there.
void Executor::AddChanged(const std::vector<Memory::Change>& changes, std::vector<CellId>& cells) {
  const auto byte_of = [this](CellId id) {
    const Cell cell = CellAt(program_, memory_.cells(), id);
    return cell.kind == CellKind::kBit ? id.index - cell.bit : id.index;
  };
  std::vector<uint32_t> bytes;  // ascending
  for (const Memory::Change& change : changes) {
    if (change.value != memory_.Read(change.cell)) bytes.push_back(byte_of(change.cell));
  }
  for (const Memory::Change& change : changes) {
    if (std::ranges::binary_search(bytes, byte_of(change.cell))) cells.push_back(change.cell);
  }
}

void Executor::ExecuteByHead(ir::InstId id, const ir::Loop& loop) {
  LoopPolicy& policy = *memory_.environment().loops;
  // The first rounds: if they are all, there is no more to be done.
  const Flow before = flow_;
  const terms::TermId left_out = std::exchange(policy.left_out, terms_.Bit(false));
  std::vector<Sample> samples;
  policy.heads->BeginSamples();
  memory_.BeginChanges();
  ++sampling_;
  UnrollLoop(id, loop, 0, &samples);
  --sampling_;
  const std::vector<Memory::Change> changes = memory_.TakeChanges();
  const bool whole = terms_.IsFalse(policy.left_out);
  policy.left_out = left_out;
  if (whole || !refusal_.empty()) {
    for (const Memory::Change& change : changes) memory_.Write(change.cell, change.value);
    return;
  }
  policy.has_heads = true;
  std::vector<CellId> cells, more;
  AddChanged(changes, cells);
  policy.heads->Open();
  Arm arm;
  do {
    cells.insert(cells.end(), more.begin(), more.end());
    std::ranges::sort(cells);
    more.clear();
    flow_ = before;
    ProgramLoop known{.loop = id, .cells = cells, .bound = loop.kind == ir::LoopBound::kBudget ? 0 : loop.bound};
    for (uint32_t i = 1; i < samples.size(); ++i) {
      ProgramLoop::Head head{.when = samples[i].when, .values = {}, .round = terms_.Const(i, kRoundWidth)};
      for (const CellId cell : cells) head.values.push_back(samples[i].cells[cell.index]);
      known.samples.push_back(std::move(head));
    }
    flow_.active = terms_.Bit(true);
    flow_.leaving.clear();
    arm = RunArm(before.active, [&] { ExecuteOneForAll(id, loop, known, more); });
  } while (!more.empty() && refusal_.empty());
  if (!refusal_.empty()) {
    flow_.active = terms_.Bit(false);
    return;
  }
  const terms::TermId behind = std::exchange(arm.flow.active, terms_.Bit(true));
  flow_.leaving = before.leaving;
  std::vector<Arm> arms;
  arms.push_back(std::move(arm));
  Join(std::move(arms));
  if (refusal_.empty()) flow_.active = terms_.And(before.active, behind);
}

void Executor::ExecuteOneForAll(ir::InstId id, const ir::Loop& loop, ProgramLoop& known, std::vector<CellId>& more) {
  LoopHeads& heads = *memory_.environment().loops->heads;
  known.entry = {.when = context_, .values = {}, .round = terms_.Const(0, kRoundWidth)};
  for (const CellId cell : known.cells) known.entry.values.push_back(memory_.Read(cell));
  known.memory = memory_.values();
  for (ProgramLoop::Head& sample : known.samples) {
    // What nobody had asked for by then is as it was.
    for (size_t i = 0; i < sample.values.size(); ++i) {
      if (!sample.values[i].valid()) sample.values[i] = known.entry.values[i];
    }
  }
  const ProgramLoop::Head head = heads.AtHead(known);
  for (size_t i = 0; i < known.cells.size(); ++i) memory_.Write(known.cells[i], head.values[i]);
  if (known.bound != 0 && known.bound <= kMostCounted)
    heads.Holds(terms_.Ule(head.round, terms_.Const(known.bound, kRoundWidth)));
  memory_.BeginChanges();
  terms::TermId done = terms_.Bit(false);
  const terms::TermId again = ExecuteRound(id, loop, head.round, done);
  for (const Memory::Change& change : memory_.TakeChanges()) {
    if (change.value == memory_.Read(change.cell)) continue;
    if (!std::ranges::binary_search(known.cells, change.cell)) more.push_back(change.cell);
    memory_.Write(change.cell, change.value);
  }
  if (!refusal_.empty() || !more.empty()) return;
  std::vector<terms::TermId> values;
  for (const CellId cell : known.cells) values.push_back(memory_.Read(cell));
  heads.Close(again, values);
  // The round is the last one: who does not leave it for elsewhere goes on after it.
  flow_.active = flow_.leaving.empty() ? terms_.Bit(true) : done;
}

}  // namespace plcxx::execute
