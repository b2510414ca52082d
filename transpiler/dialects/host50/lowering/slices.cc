#include "transpiler/dialects/host50/lowering/slices.h"

#include <utility>

#include "transpiler/dialects/host50/lowering/jumps.h"
#include "transpiler/dialects/host50/lowering/network_writer.h"
#include "transpiler/dialects/host50/lowering/own_places.h"
#include "transpiler/dialects/host50/lowering/routines.h"
#include "transpiler/dialects/host50/lowering/statement_writer.h"

namespace plcxx::host50 {

using ir::OpKind;
using ir::ValueId;

Slices::Slices(const Context& context, OwnPlaces& own_places, Routines& routines, Jumps& jumps,
               StatementWriter& statements, NetworkWriter& networks)
    : Context(context),
      own_places_(own_places),
      routines_(routines),
      jumps_(jumps),
      statements_(statements),
      networks_(networks) {}

Slices::SliceOfNetwork Slices::SliceOfNetworks(const Section& section) const {
  uint64_t all = 0, before = 0;
  for (uint32_t i = 0; i < section.networks.count; ++i) all += WeightOf(tree_, NetworkId(section.networks.first + i));
  SliceOfNetwork slices;
  for (uint32_t i = 0; i < section.networks.count; ++i) {
    slices.push_back(static_cast<uint32_t>(settings_.slowdiv * before / all));
    before += WeightOf(tree_, NetworkId(section.networks.first + i));
  }
  return slices;
}

/// Whether an LBL goes to another slice, or back: then a refused one would end the whole pass.
bool Slices::JumpsLeaveSlices(const Section& section, const SliceOfNetwork& slices) const {
  for (uint32_t i = 0; i < section.networks.count; ++i) {
    const Span& instructions = tree_.networks[NetworkId(section.networks.first + i)].instructions;
    for (uint32_t k = 0; k < instructions.count; ++k) {
      const Instruction& instruction = tree_.instructions[InstructionId(instructions.first + k)];
      if (instruction.op != Op::kLbl) continue;
      const uint32_t target = OperandOf(instruction, 0).network.index - section.networks.first;
      if (target <= i || slices[target] != slices[i]) return true;
    }
  }
  return false;
}

void Slices::ByChoice(const Section& section, const SliceOfNetwork& slices) {
  ir::Switch choice;
  for (uint32_t i = 0; i < section.networks.count;) {
    const uint32_t slice = slices[i];
    const ir::RegionId region = builder_.RegionOf([&] {
      for (; i < section.networks.count && slices[i] == slice; ++i) {
        networks_.Begin(NetworkId(section.networks.first + i));
        networks_.Lower(NetworkId(section.networks.first + i));
      }
    });
    choice.cases.push_back({.values = {slice}, .region = region});
  }
  builder_.SetRange({});
  if (!choice.cases.empty()) builder_.SwitchOn(builder_.Load(routines_.slice()), std::move(choice));
}

void Slices::ByCursor(const Section& section, const SliceOfNetwork& slices) {
  const uint32_t count = section.networks.count, first = section.networks.first;
  cursor_ = own_places_.System("next_network", ir::Type::kI32);
  if (jumps_.HasWayBack(now_.section)) jumps_.Count(ir::Lifetime::kVolatile);
  const ValueId slice = builder_.Load(routines_.slice()), zero = Word(0);
  const ValueId begins = builder_.Pure(OpKind::kEqual32, {slice, zero});
  builder_.If(begins, builder_.RegionOf([&] {
    builder_.Store(cursor_, Word(0));
    if (now_.jumps_left.valid()) jumps_.AllowAll();
  }));
  // Where no network ends this tick's part below, the pass is over until slice 0 begins the next one.
  const ValueId next = builder_.Load(cursor_), behind = Word(count);
  builder_.Store(cursor_, behind);
  // A slice's part may end in front of its successor's first network and of each target of a jump.
  const auto may_end_at = [&](uint32_t i) {
    return i > 0 && (slices[i] != slices[i - 1] || jumps_.IsTarget(NetworkId(first + i)));
  };
  for (uint32_t i = 1; i < count; ++i) {
    if (may_end_at(i)) builder_.Jump(first + i, builder_.Pure(OpKind::kEqual32, {next, Word(i)}));
  }
  jumps_.ToEnd(builder_.Pure(OpKind::kEqual32, {next, behind}));
  for (uint32_t i = 0; i < count; ++i) {
    const NetworkId network(first + i);
    const bool asks = may_end_at(i);
    if (asks) jumps_.MakeTarget(network);
    networks_.Begin(network);
    if (asks && slices[i] > 0) EndSliceBefore(i, slices[i]);
    networks_.Lower(network);
  }
}

/// A statement of its own: the one before must be free to be switched off.
void Slices::EndSliceBefore(uint32_t index, uint32_t slice) {
  const source::Range range = statements_.TakeLastComment();  // the NETWORK line
  statements_.Add(range, {});
  const ValueId now = builder_.Load(routines_.slice()), own = Word(slice);
  const ValueId later = builder_.Pure(OpKind::kLess32, {now, own});
  builder_.If(later, builder_.RegionOf([&] {
    builder_.Store(cursor_, Word(index));
    jumps_.ToEnd();
  }));
}

void Slices::Lower(const Section& section) {
  const SliceOfNetwork slices = SliceOfNetworks(section);
  if (JumpsLeaveSlices(section, slices)) return ByCursor(section, slices);
  ByChoice(section, slices);
}

}  // namespace plcxx::host50
