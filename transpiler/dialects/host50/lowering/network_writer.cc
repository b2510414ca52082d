#include "transpiler/dialects/host50/lowering/network_writer.h"

#include <algorithm>

#include "transpiler/dialects/host50/lowering/instruction_set.h"
#include "transpiler/dialects/host50/lowering/jumps.h"
#include "transpiler/dialects/host50/lowering/results.h"
#include "transpiler/dialects/host50/lowering/statement_writer.h"

namespace plcxx::host50 {

void NetworkWriter::Begin(NetworkId id) {
  now_.network = id;
  const Network& network = tree_.networks[id];
  builder_.SetRange(network.range);
  if (jumps_.IsTarget(id)) builder_.Label(id.index);
  statements_.AddComments(network.comments);
  statements_.AddComment(network.range);
}

bool NetworkWriter::Acts(const Instruction& instruction) {
  const RungEffect effect = Info(instruction.op).effect;
  return effect != RungEffect::kNothing && effect != RungEffect::kClose;
}

uint32_t NetworkWriter::LineOf(InstructionId id) const {
  return sources_.Locate(tree_.instructions[id].range.begin).line;
}

/// A rung ends where no instruction after it uses a result of it; in a drawing also not inside a row, and not above
/// a row that it has reached already.
std::vector<Span> NetworkWriter::RungsOf(const Network& network) const {
  const uint32_t first = network.instructions.first, end = first + network.instructions.count;
  std::vector<uint32_t> last_use(network.instructions.count), lowest_line(network.instructions.count + 1, 0xFFFFFFFF);
  for (uint32_t i = end; i-- > first;) {
    last_use[i - first] = std::max(last_use[i - first], i);
    ForEachTaken(tree_.instructions[InstructionId(i)], [&](InstructionId taken) {
      last_use[taken.index - first] = std::max(last_use[taken.index - first], i);
    });
    const uint32_t line = network.is_drawing ? LineOf(InstructionId(i)) : 0;
    lowest_line[i - first] = std::min(line, lowest_line[i - first + 1]);
  }
  std::vector<Span> rungs;
  uint32_t reach = 0, line = 0;
  for (uint32_t i = first; i < end; ++i) {
    const bool apart = !network.is_drawing || line < lowest_line[i - first];
    if (rungs.empty() || (i > reach && apart)) rungs.push_back({i, 0});
    ++rungs.back().count;
    reach = std::max(reach, last_use[i - first]);
    if (network.is_drawing) line = std::max(line, LineOf(InstructionId(i)));
  }
  return rungs;
}

void NetworkWriter::LowerRung(Span rung) {
  // Remarks and RUNG at its begin belong to the next rung, and at its end there are none.
  while (rung.count > 0 && !Acts(tree_.instructions[InstructionId(rung.first)])) {
    const Instruction& text = tree_.instructions[InstructionId(rung.first)];
    statements_.AddComments(text.comments);
    if (text.op == Op::kRemark) statements_.AddComment(OperandOf(text, 0).range);
    ++rung.first, --rung.count;
  }
  if (rung.count == 0) return;
  statements_.Begin(rung);
  instructions_.BeginRung();
  for (uint32_t i = 0; i < rung.count; ++i) instructions_.Execute(InstructionId(rung.first + i));
}

void NetworkWriter::Lower(NetworkId id) {
  const Network& network = tree_.networks[id];
  results_.BeginNetwork(network.instructions);
  for (const Span rung : RungsOf(network)) LowerRung(rung);
}

}  // namespace plcxx::host50
