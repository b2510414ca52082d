// Elements of a rung: contacts, coils, timers, monostables, counters (calc.c's rules, docs/dialects/classicladder.md
// 6).

#include "transpiler/dialects/classicladder/lowering/internal.h"

namespace plcxx::classicladder {

using ir::OpKind;
using ir::ValueId;

ValueId Lowering::ToBit(Signal signal) {
  if (signal.kind == Signal::Kind::kValue) return signal.value;
  return builder_.Bit(signal.kind == Signal::Kind::kOne ? 1 : 0);
}

Signal Lowering::And(Signal a, Signal b) {
  if (a.kind == Signal::Kind::kZero || b.kind == Signal::Kind::kZero) return {};
  if (a.kind == Signal::Kind::kOne) return b;
  if (b.kind == Signal::Kind::kOne) return a;
  return Signal::Of(builder_.Pure(OpKind::kBitAnd, {a.value, b.value}));
}

Signal Lowering::Or(Signal a, Signal b) {
  if (a.kind == Signal::Kind::kOne || b.kind == Signal::Kind::kOne) return Signal::One();
  if (a.kind == Signal::Kind::kZero) return b;
  if (b.kind == Signal::Kind::kZero || a.value == b.value) return a;
  return Signal::Of(builder_.Pure(OpKind::kBitOr, {a.value, b.value}));
}

Signal Lowering::Not(Signal a) {
  if (a.kind == Signal::Kind::kZero) return Signal::One();
  if (a.kind == Signal::Kind::kOne) return {};
  return Signal::Of(builder_.Pure(OpKind::kBitNot, {a.value}));
}

Signal Lowering::Left(uint32_t x, uint32_t y) {
  if (x == 0) return Signal::One();
  uint32_t top = y, bottom = y;
  while (top > 0 && now_.rung->At(x, top).joined_above) --top;
  while (bottom + 1 < kRungHeight && now_.rung->At(x, bottom + 1).joined_above) ++bottom;
  Signal& left = now_.lefts[x][top];
  if (now_.knows_left[x][top]) return left;
  now_.knows_left[x][top] = true;
  left = {};
  for (uint32_t row = top; row <= bottom; ++row) left = Or(left, now_.outputs[x - 1][row]);
  return left;
}

/// Each element has a memory of its own, as it has in the engine; named by what it looks at.
ir::StateId Lowering::EdgeOf(const Element& element) {
  const auto [found, is_new] = edges_.try_emplace(element.range.begin);
  if (is_new) {
    std::string name = NameInCode(element.variable.address) + "_edge";
    const uint32_t count = ++edge_names_[name];
    if (count > 1) name += "_" + std::to_string(count);
    found->second = program_.states.Add({.kind = ir::StateKind::kEdgeMemory, .name = std::move(name)});
    edge_elements_.push_back(&element);
  }
  return found->second;
}

/// The variable is read whatever comes from the left: an edge takes notice of it, and an index may be outside.
void Lowering::Contact(uint32_t x, uint32_t y, const Element& element) {
  const bool edge = element.kind == ElementKind::kRising || element.kind == ElementKind::kFalling;
  const Signal left = Left(x, y);
  Signal state = Signal::Of(ReadBit(element.variable));
  if (edge) {
    const OpKind step = element.kind == ElementKind::kRising ? OpKind::kRising : OpKind::kFalling;
    state = Signal::Of(builder_.Step(step, EdgeOf(element), {state.value}));
  } else if (element.kind == ElementKind::kContactNot) {
    state = Not(state);
  }
  now_.outputs[x][y] = And(left, state);
}

void Lowering::Coil(uint32_t x, uint32_t y, const Element& element) {
  const Signal left = Left(x, y);
  if (element.kind == ElementKind::kCoil) return WriteBit(element.variable, ToBit(left));
  if (element.kind == ElementKind::kCoilNot) return WriteBit(element.variable, ToBit(Not(left)));
  const uint64_t value = element.kind == ElementKind::kSet ? 1 : 0;
  When(left, [&] { WriteBit(element.variable, builder_.Bit(value)); });
}

/// Counts down while both inputs are 1; an expired one is done in the next scan only.
void Lowering::Timer(uint32_t x, uint32_t y, uint32_t number) {
  const Signal enabled = Left(x - 1, y);
  const Signal runs = Left(x - 1, y + 1);
  const ir::PlaceId value = FieldOf(Group::kTimers, Part::kValue, number);
  const ir::PlaceId done = FieldOf(Group::kTimers, Part::kDone, number);
  const ir::PlaceId running = FieldOf(Group::kTimers, Part::kRunning, number);
  const auto set = [&](uint64_t is_running, uint64_t is_done) {
    builder_.Store(running, builder_.Bit(is_running));
    builder_.Store(done, builder_.Bit(is_done));
  };
  Choose(
      enabled,
      [&] {
        const ValueId left = builder_.Load(value);
        builder_.Choose(
            builder_.Pure(OpKind::kSignedGreater32, {left, Word(0)}),
            [&] {
              When(runs, [&] {
                const ValueId period = Word(settings_.period_ms);
                builder_.Store(value, builder_.Pure(OpKind::kSub32, {builder_.Load(value), period}));
                set(1, 0);
              });
            },
            [&] { set(0, 1); });
      },
      [&] {
        set(0, 0);
        builder_.Store(value, builder_.Load(FieldOf(Group::kTimers, Part::kPreset, number)));
      });
  now_.outputs[x][y] = Signal::Of(builder_.Load(done));
  now_.outputs[x][y + 1] = Signal::Of(builder_.Load(running));
}

/// Starts at exactly 0 only, counts in the scan that starts it, and is over one scan after its time.
void Lowering::Monostable(uint32_t x, uint32_t y, uint32_t number) {
  const ValueId input = ToBit(Left(x - 1, y));
  const ir::PlaceId value = FieldOf(Group::kMonostables, Part::kValue, number);
  const ir::PlaceId running = FieldOf(Group::kMonostables, Part::kRunning, number);
  const ir::PlaceId input_was = HiddenOf(Group::kMonostables, Hidden::kInputWas, number);
  const ValueId was = builder_.Pure(OpKind::kBitNot, {builder_.Load(input_was)});
  const ValueId rises = builder_.Pure(OpKind::kBitAnd, {input, was});
  const ValueId rests = builder_.Pure(OpKind::kEqual32, {builder_.Load(value), Word(0)});
  builder_.When(builder_.Pure(OpKind::kBitAnd, {rises, rests}), [&] {
    builder_.Store(running, builder_.Bit(1));
    builder_.Store(value, builder_.Load(FieldOf(Group::kMonostables, Part::kPreset, number)));
  });
  const ValueId left = builder_.Load(value);
  builder_.Choose(
      builder_.Pure(OpKind::kSignedGreater32, {left, Word(0)}),
      [&] {
        const ValueId before = builder_.Load(value);
        builder_.Store(value, builder_.Pure(OpKind::kSub32, {before, Word(settings_.period_ms)}));
      },
      [&] { builder_.Store(running, builder_.Bit(0)); });
  builder_.Store(input_was, input);
  now_.outputs[x][y] = Signal::Of(builder_.Load(running));
}

/// Up, down, preset, reset, in this order; each keeps the value before it for the outputs empty and full.
void Lowering::Counter(uint32_t x, uint32_t y, uint32_t number) {
  constexpr uint32_t kMost = 9999;
  const Signal reset = Left(x - 1, y), preset = Left(x - 1, y + 1);
  const Signal up = Left(x - 1, y + 2), down = Left(x - 1, y + 3);
  const ir::PlaceId value = FieldOf(Group::kCounters, Part::kValue, number);
  const ir::PlaceId before = HiddenOf(Group::kCounters, Hidden::kBefore, number);
  const ir::PlaceId preset_place = FieldOf(Group::kCounters, Part::kPreset, number);
  const auto count = [&](Signal signal, Hidden memory, OpKind step, OpKind beyond, uint32_t limit, uint32_t wrapped) {
    const ir::PlaceId was = HiddenOf(Group::kCounters, memory, number);
    const ValueId input = ToBit(signal);
    if (signal.kind == Signal::Kind::kZero) return builder_.Store(was, input);  // not connected: it counts nothing
    const ValueId was_not = builder_.Pure(OpKind::kBitNot, {builder_.Load(was)});
    builder_.When(builder_.Pure(OpKind::kBitAnd, {input, was_not}), [&] {
      builder_.Store(before, builder_.Load(value));
      builder_.Store(value, builder_.Pure(step, {builder_.Load(value), Word(1)}));
      const ValueId outside = builder_.Pure(beyond, {builder_.Load(value), Word(limit)});
      builder_.When(outside, [&] { builder_.Store(value, Word(wrapped)); });
    });
    builder_.Store(was, input);
  };
  count(up, Hidden::kUpWas, OpKind::kAdd32, OpKind::kSignedGreater32, kMost, 0);
  count(down, Hidden::kDownWas, OpKind::kSub32, OpKind::kSignedLess32, 0, kMost);
  When(preset, [&] {
    builder_.Store(before, builder_.Load(value));
    builder_.Store(value, builder_.Load(preset_place));
  });
  When(reset, [&] {
    builder_.Store(before, builder_.Load(value));
    builder_.Store(value, Word(0));
  });
  const auto went = [&](uint32_t from, uint32_t to) {
    const ValueId is = builder_.Pure(OpKind::kEqual32, {builder_.Load(value), Word(to)});
    const ValueId was = builder_.Pure(OpKind::kEqual32, {builder_.Load(before), Word(from)});
    return builder_.Pure(OpKind::kBitAnd, {is, was});
  };
  const auto output = [&](Part part, uint32_t row, ValueId bit) {
    builder_.Store(FieldOf(Group::kCounters, part, number), bit);
    now_.outputs[x][row] = Signal::Of(bit);
  };
  output(Part::kDone, y + 1, builder_.Pure(OpKind::kEqual32, {builder_.Load(value), builder_.Load(preset_place)}));
  output(Part::kEmpty, y, went(0, kMost));
  output(Part::kFull, y + 2, went(kMost, 0));
}

/// The part of a unit that has passed stays when the input falls: the next time begins with it.
void Lowering::TimerIec(uint32_t x, uint32_t y, uint32_t number) {
  const auto found = tree_.timers_iec.find(number);
  const Preset timer = found == tree_.timers_iec.end() ? Preset{} : found->second;
  const ValueId input = ToBit(Left(x - 1, y));
  const ir::PlaceId value = FieldOf(Group::kTimersIec, Part::kValue, number);
  const ir::PlaceId output = FieldOf(Group::kTimersIec, Part::kDone, number);
  const ir::PlaceId preset = FieldOf(Group::kTimersIec, Part::kPreset, number);
  const ir::PlaceId part = HiddenOf(Group::kTimersIec, Hidden::kPartMs, number);
  const ir::PlaceId started = HiddenOf(Group::kTimersIec, Hidden::kStarted, number);
  const ir::PlaceId input_was = HiddenOf(Group::kTimersIec, Hidden::kInputWas, number);
  const auto time_passes = [&] {
    const ValueId passed = builder_.Pure(OpKind::kAdd32, {builder_.Load(part), Word(settings_.period_ms)});
    builder_.Store(part, passed);
    const ValueId whole = builder_.Pure(OpKind::kSignedGreaterEqual32, {builder_.Load(part), Word(timer.base_ms)});
    builder_.When(whole, [&] {
      builder_.Store(value, builder_.Pure(OpKind::kAdd32, {builder_.Load(value), Word(1)}));
      builder_.Store(part, builder_.Pure(OpKind::kSub32, {builder_.Load(part), Word(timer.base_ms)}));
    });
  };
  const auto is_below = [&] {
    return builder_.Pure(OpKind::kSignedLess32, {builder_.Load(value), builder_.Load(preset)});
  };
  const auto end = [&](uint64_t bit) {
    builder_.Store(output, builder_.Bit(bit));
    builder_.Store(value, Word(0));
  };
  switch (timer.mode) {
    case TimerMode::kOn:
      builder_.Choose(
          input, [&] { builder_.Choose(is_below(), time_passes, [&] { builder_.Store(output, builder_.Bit(1)); }); },
          [&] { end(0); });
      break;
    case TimerMode::kOff:
      builder_.Choose(
          input,
          [&] {
            end(1);
            builder_.Store(started, builder_.Bit(0));
          },
          [&] { builder_.When(builder_.Load(input_was), [&] { builder_.Store(started, builder_.Bit(1)); }); });
      break;
    case TimerMode::kPulse: {
      const ValueId was_not = builder_.Pure(OpKind::kBitNot, {builder_.Load(input_was)});
      const ValueId rises = builder_.Pure(OpKind::kBitAnd, {input, was_not});
      const ValueId rests = builder_.Pure(OpKind::kBitNot, {builder_.Load(started)});
      builder_.When(builder_.Pure(OpKind::kBitAnd, {rises, rests}), [&] {
        end(1);
        builder_.Store(started, builder_.Bit(1));
      });
      break;
    }
  }
  if (timer.mode != TimerMode::kOn) {
    builder_.When(builder_.Load(started), [&] {
      builder_.Choose(is_below(), time_passes, [&] {
        end(0);
        builder_.Store(started, builder_.Bit(0));
      });
    });
  }
  builder_.Store(input_was, input);
  now_.outputs[x][y] = Signal::Of(builder_.Load(output));
}

}  // namespace plcxx::classicladder
