#include "transpiler/dialects/classicladder/lowering/blocks.h"

namespace plcxx::classicladder {

using ir::OpKind;
using ir::ValueId;

void Blocks::Timer(uint32_t x, uint32_t y, uint32_t number) {
  const Signal enabled = grid_.Left(x - 1, y);
  const Signal runs = grid_.Left(x - 1, y + 1);
  const ir::PlaceId value = places_.FieldOf(Group::kTimers, Part::kValue, number);
  const ir::PlaceId done = places_.FieldOf(Group::kTimers, Part::kDone, number);
  const ir::PlaceId running = places_.FieldOf(Group::kTimers, Part::kRunning, number);
  const auto set = [&](uint64_t is_running, uint64_t is_done) {
    builder_.Store(running, builder_.Bit(is_running));
    builder_.Store(done, builder_.Bit(is_done));
  };
  logic_.Choose(
      enabled,
      [&] {
        const ValueId left = builder_.Load(value);
        builder_.Choose(
            builder_.Pure(OpKind::kSignedGreater32, {left, Word(0)}),
            [&] {
              logic_.When(runs, [&] {
                const ValueId period = Word(settings_.period_ms);
                builder_.Store(value, builder_.Pure(OpKind::kSub32, {builder_.Load(value), period}));
                set(1, 0);
              });
            },
            [&] { set(0, 1); });
      },
      [&] {
        set(0, 0);
        builder_.Store(value, builder_.Load(places_.FieldOf(Group::kTimers, Part::kPreset, number)));
      });
  grid_.Put(x, y, Signal::Of(builder_.Load(done)));
  grid_.Put(x, y + 1, Signal::Of(builder_.Load(running)));
}

void Blocks::Monostable(uint32_t x, uint32_t y, uint32_t number) {
  const ValueId input = logic_.ToBit(grid_.Left(x - 1, y));
  const ir::PlaceId value = places_.FieldOf(Group::kMonostables, Part::kValue, number);
  const ir::PlaceId running = places_.FieldOf(Group::kMonostables, Part::kRunning, number);
  const ir::PlaceId input_was = places_.HiddenOf(Group::kMonostables, Hidden::kInputWas, number);
  const ValueId was = builder_.Pure(OpKind::kBitNot, {builder_.Load(input_was)});
  const ValueId rises = builder_.Pure(OpKind::kBitAnd, {input, was});
  const ValueId rests = builder_.Pure(OpKind::kEqual32, {builder_.Load(value), Word(0)});
  builder_.When(builder_.Pure(OpKind::kBitAnd, {rises, rests}), [&] {
    builder_.Store(running, builder_.Bit(1));
    builder_.Store(value, builder_.Load(places_.FieldOf(Group::kMonostables, Part::kPreset, number)));
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
  grid_.Put(x, y, Signal::Of(builder_.Load(running)));
}

void Blocks::Counter(uint32_t x, uint32_t y, uint32_t number) {
  constexpr uint32_t kMost = 9999;
  const Signal reset = grid_.Left(x - 1, y), preset = grid_.Left(x - 1, y + 1);
  const Signal up = grid_.Left(x - 1, y + 2), down = grid_.Left(x - 1, y + 3);
  const ir::PlaceId value = places_.FieldOf(Group::kCounters, Part::kValue, number);
  const ir::PlaceId before = places_.HiddenOf(Group::kCounters, Hidden::kBefore, number);
  const ir::PlaceId preset_place = places_.FieldOf(Group::kCounters, Part::kPreset, number);
  const auto count = [&](Signal signal, Hidden memory, OpKind step, OpKind beyond, uint32_t limit, uint32_t wrapped) {
    const ir::PlaceId was = places_.HiddenOf(Group::kCounters, memory, number);
    const ValueId input = logic_.ToBit(signal);
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
  logic_.When(preset, [&] {
    builder_.Store(before, builder_.Load(value));
    builder_.Store(value, builder_.Load(preset_place));
  });
  logic_.When(reset, [&] {
    builder_.Store(before, builder_.Load(value));
    builder_.Store(value, Word(0));
  });
  const auto went = [&](uint32_t from, uint32_t to) {
    const ValueId is = builder_.Pure(OpKind::kEqual32, {builder_.Load(value), Word(to)});
    const ValueId was = builder_.Pure(OpKind::kEqual32, {builder_.Load(before), Word(from)});
    return builder_.Pure(OpKind::kBitAnd, {is, was});
  };
  const auto output = [&](Part part, uint32_t row, ValueId bit) {
    builder_.Store(places_.FieldOf(Group::kCounters, part, number), bit);
    grid_.Put(x, row, Signal::Of(bit));
  };
  output(Part::kDone, y + 1, builder_.Pure(OpKind::kEqual32, {builder_.Load(value), builder_.Load(preset_place)}));
  output(Part::kEmpty, y, went(0, kMost));
  output(Part::kFull, y + 2, went(kMost, 0));
}

void Blocks::TimerIec(uint32_t x, uint32_t y, uint32_t number) {
  const auto found = tree_.timers_iec.find(number);
  const Preset timer = found == tree_.timers_iec.end() ? Preset{} : found->second;
  const ValueId input = logic_.ToBit(grid_.Left(x - 1, y));
  const ir::PlaceId value = places_.FieldOf(Group::kTimersIec, Part::kValue, number);
  const ir::PlaceId output = places_.FieldOf(Group::kTimersIec, Part::kDone, number);
  const ir::PlaceId preset = places_.FieldOf(Group::kTimersIec, Part::kPreset, number);
  const ir::PlaceId part = places_.HiddenOf(Group::kTimersIec, Hidden::kPartMs, number);
  const ir::PlaceId started = places_.HiddenOf(Group::kTimersIec, Hidden::kStarted, number);
  const ir::PlaceId input_was = places_.HiddenOf(Group::kTimersIec, Hidden::kInputWas, number);
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
  grid_.Put(x, y, Signal::Of(builder_.Load(output)));
}

}  // namespace plcxx::classicladder
