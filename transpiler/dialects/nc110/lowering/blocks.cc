#include "transpiler/dialects/nc110/lowering/blocks.h"

#include "transpiler/dialects/nc110/lowering/expressions.h"
#include "transpiler/dialects/nc110/lowering/faults.h"
#include "transpiler/dialects/nc110/lowering/statement_writer.h"

namespace plcxx::nc110 {
namespace {

constexpr uint64_t kMostRounds = 255;

}  // namespace

void Blocks::LeaveChain() {
  if (!waiting_.block.valid()) return;
  builder_.SetRegion(waiting_.behind);
  waiting_ = {};
}

void Blocks::CloseAll() {
  LeaveChain();
  if (!open_.empty()) builder_.SetRegion(open_.front().behind);
  open_.clear();
}

void Blocks::Loop(const Block& block, ir::StatementId statement) {
  const ir::RegionId behind = builder_.region();
  ir::Loop loop{.kind = ir::LoopBound::kGuard,
                .bound = kMostRounds,
                .budget = {},
                .condition = builder_.NewRegion(),
                .body = builder_.NewRegion(),
                .exhausted = builder_.NewRegion()};
  builder_.SetRegion(loop.condition);
  expressions_.Evaluate(block.condition, ir::Type::kBit);
  builder_.SetRegion(loop.exhausted);
  faults_.Call(Fault::kLoopLimit, program_.statements[statement].id);
  builder_.SetRegion(behind);
  builder_.LoopWith(loop);
  open_.push_back({.block = tree_.items[block.head].block(), .behind = behind, .otherwise = {}});
  builder_.SetRegion(loop.body);
}

void Blocks::Head(ItemId id) {
  const BlockId block_id = tree_.items[id].block();
  const Block& block = tree_.blocks[block_id];
  ir::RegionId behind;
  if (block.previous.valid() && waiting_.block == block.previous) {
    behind = waiting_.behind;
    builder_.SetRegion(waiting_.otherwise);
    waiting_ = {};
  } else {
    LeaveChain();
    behind = builder_.region();
  }
  const ir::StatementId statement = statements_.Begin(id);
  if (block.kind == BlockKind::kDow) return Loop(block, statement);
  const bool faulty = tree_.items[id].faulty;
  const ir::ValueId condition = faulty                    ? builder_.Poison(ir::Type::kBit)
                                : block.condition.valid() ? expressions_.Evaluate(block.condition, ir::Type::kBit)
                                                          : builder_.Bit(1);
  const ir::RegionId then = builder_.NewRegion();
  const ir::RegionId otherwise = block.next.valid() ? builder_.NewRegion() : ir::RegionId();
  builder_.If(condition, then, otherwise);
  open_.push_back({.block = block_id, .behind = behind, .otherwise = otherwise});
  builder_.SetRegion(then);
}

void Blocks::End(ItemId id) {
  const BlockId block = tree_.block_ends[tree_.items[id].block_end()].block;
  statements_.Begin(id);
  if (!block.valid() || open_.empty() || open_.back().block != block) return;  // reported by the parser
  const OpenBlock closed = open_.back();
  open_.pop_back();
  if (closed.otherwise.valid()) {
    waiting_ = closed;
  } else {
    builder_.SetRegion(closed.behind);
  }
}

}  // namespace plcxx::nc110
