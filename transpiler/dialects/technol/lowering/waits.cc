#include "transpiler/dialects/technol/lowering/waits.h"

#include <algorithm>

#include "transpiler/dialects/technol/lowering/exits.h"
#include "transpiler/dialects/technol/lowering/jumps.h"
#include "transpiler/dialects/technol/lowering/mechanism_places.h"
#include "transpiler/dialects/technol/lowering/operands.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::ValueId;

/// To where the wait resumes.
void Waits::Leave() {
  const std::vector<InstructionId>& entries = frame_.routine->entries;
  const InstructionId resume = flow_.ResumeOf(frame_.now);
  const auto at = std::ranges::lower_bound(entries, resume);
  const bool begins = at == entries.end() || *at != resume;  // as if nothing had run
  if (!entries.empty()) {
    const auto step = begins ? 0 : static_cast<uint64_t>(at - entries.begin()) + 1;
    builder_.Store(mechanisms_.Step(frame_.routine->unit), builder_.Constant(step, 16));
  }
  exits_.ToEnd();
}

void Waits::OnePass() {
  Leave();
  registers_.Forget();  // nothing survives
}

void Waits::UntilRlo(uint64_t rlo) {
  const ValueId value = registers_.rlo().Get();
  registers_.Spill();
  builder_.When(rlo == 1 ? builder_.Not(value) : value, [&] { Leave(); });
  registers_.rlo().Know(rlo);
}

ValueId Waits::LimitOf(const Instruction& instruction) { return operands_.ReadAs(OperandOf(instruction, 1), 16); }

ValueId Waits::Compare(OpKind comparison, ValueId count, ValueId limit) {
  return Pure(comparison, {builder_.ToWidth(count, 32), builder_.ToWidth(limit, 32)});
}

void Waits::UntilRloAtMost(const Instruction& instruction, uint64_t rlo) {
  const ValueId value = registers_.rlo().Get();
  const Operands::Reach timer = operands_.ReachOf(OperandOf(instruction, 0));
  const ValueId limit = LimitOf(instruction);
  const ValueId zero = builder_.Constant(0, 16), one = builder_.Constant(1, 16);
  registers_.Spill();
  builder_.When(rlo == 1 ? builder_.Not(value) : value, [&] {
    const auto expire = [&] {
      builder_.Store(timer.place, zero, timer.index);
      jumps_.Always(instruction);
    };
    if (builder_.KnownValue(limit) == 0) return expire();
    const ValueId count = builder_.Load(timer.place, timer.index);
    builder_.When(Compare(OpKind::kGreaterEqual32, count, limit), expire);
    builder_.Store(timer.place, Pure(OpKind::kAdd16, {count, one}), timer.index);
    Leave();
  });
  builder_.Store(timer.place, zero, timer.index);
  registers_.rlo().Know(rlo);
}

void Waits::Delay(const Instruction& instruction) {
  const Operands::Reach timer = operands_.ReachOf(OperandOf(instruction, 0));
  const ValueId limit = LimitOf(instruction);
  registers_.Spill();
  if (builder_.KnownValue(limit) != 0) {
    const ValueId count = builder_.Load(timer.place, timer.index);
    builder_.When(Compare(OpKind::kLess32, count, limit), [&] {
      builder_.Store(timer.place, Pure(OpKind::kAdd16, {count, builder_.Constant(1, 16)}), timer.index);
      Leave();
    });
  }
  builder_.Store(timer.place, builder_.Constant(0, 16), timer.index);
}

}  // namespace plcxx::technol
