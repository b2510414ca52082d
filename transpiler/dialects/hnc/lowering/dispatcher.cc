#include "transpiler/dialects/hnc/lowering/dispatcher.h"

#include <iterator>
#include <utility>

#include "transpiler/dialects/hnc/lowering/handlers.h"
#include "transpiler/dialects/hnc/lowering/locals.h"
#include "transpiler/dialects/hnc/lowering/memory.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint8_t kIdle = 0, kActive = 1, kDone = 2;
constexpr uint16_t kCancel = 0x8000, kHold = 0x2000, kAnyActive = 0x0010, kM00 = 0x1000, kM01 = 0x2000;
constexpr uint32_t kStrobeWord = 163, kAckWord = 163, kFlagsWord = 174, kChannelBytes = 40;

struct KindRow {
  uint16_t strobe;
  uint32_t code_word;  // in F
  uint16_t ack;
  uint32_t mod_word;  // in G
  uint16_t busy, hold_disabled;
  std::string_view code_name, mod_name;
};
constexpr KindRow kRows[] = {
    {0x0100, 164, 0x0001, 170, 0x0001, 0x0100, "M_code", "mod_M"},
    {0x0200, 167, 0x0002, 171, 0x0002, 0x0200, "S_code", "mod_S"},
    {0x0400, 165, 0x0004, 172, 0x0004, 0x0400, "T_code", "mod_T"},
    {0x0800, 166, 0x0008, 173, 0x0008, 0x0800, "B_code", "mod_B"},
};

}  // namespace

/// A word of the channel that an index names.
ir::PlaceId Dispatcher::ChannelWord(Area area, uint32_t word, std::string_view name) {
  ir::PlaceId& place = places_[std::string(name)];
  if (place.valid()) return place;
  const ir::SpaceId space = memory_.SpaceOf(area);
  place = program_.places.Add({.name = std::string(name),
                               .address = {},
                               .type = ir::Type::kI16,
                               .space = space,
                               .offset = 2 * word,
                               .bit = ir::kNoBit,
                               .indexed = true,
                               .stride = kChannelBytes,
                               .low = 0,
                               .high = program_.spaces[space].bytes});
  return place;
}

/// Four bytes of the runtime, one for each channel.
ir::PlaceId Dispatcher::ChannelByte(ir::PlaceId first, const std::string& name) {
  ir::PlaceId& place = places_[name];
  if (place.valid()) return place;
  const uint32_t begin = program_.places[first].offset;
  place = program_.places.Add({.name = name,
                               .address = {},
                               .type = ir::Type::kI8,
                               .space = program_.places[first].space,
                               .offset = begin,
                               .bit = ir::kNoBit,
                               .indexed = true,
                               .stride = 1,
                               .low = begin,
                               .high = begin + 4});
  return place;
}

ir::PlaceId Dispatcher::StateOf(uint32_t kind) {
  return ChannelByte(states_[0][kind], "state_" + std::string(1, kHandlerKinds[kind]));
}

ValueId Dispatcher::Mask(uint32_t bits) { return builder_.Constant(ir::Type::kI16, bits & 0xFFFF, 16); }

ir::RoutineId Dispatcher::AddChannelRoutine(const std::string& name, std::string comment, ir::PlaceId& channel) {
  const ir::RoutineId id = builder_.AddRoutine(name, ir::RoutineKind::kSubroutine, std::move(comment));
  locals_.Begin(name);
  channel = locals_.Add("channel", ir::Type::kI32);
  program_.routines[id].parameters.push_back({.name = "channel", .type = ir::Type::kI32, .enumerators = {}});
  program_.routines[id].parameter_places.push_back(channel);
  builder_.SetRegion(program_.routines[id].body);
  return id;
}

/// What the channel has of a word becomes `op` of it and the mask.
void Dispatcher::ChangeBits(ir::PlaceId word, OpKind op, uint32_t mask, ir::PlaceId channel) {
  const ValueId at = builder_.Load(channel);
  const ValueId changed = Pure(op, {builder_.Load(word, builder_.Load(channel)), Mask(mask)});
  builder_.Store(word, changed, at);
}

void Dispatcher::Put(ir::PlaceId byte, uint8_t value, ir::PlaceId channel) {
  const ValueId at = builder_.Load(channel);
  const ValueId number = builder_.Constant(ir::Type::kI8, value);
  builder_.Store(byte, number, at);
}

void Dispatcher::AddRoutines() {
  ir::PlaceId channel;
  dispatch_ =
      AddChannelRoutine("dispatch", "Requests of one channel: hands M, S, T, B codes to their handlers.", channel);
  Dispatch(channel);
  complete_ = AddChannelRoutine("complete", "Requests of one channel that are done are acknowledged.", channel);
  Complete(channel);
}

Dispatcher::Kind Dispatcher::KindOf(uint32_t number) {
  const KindRow& row = kRows[number];
  Kind kind{.number = number, .state = StateOf(number)};
  kind.code = ChannelWord(Area::kF, row.code_word, row.code_name);
  kind.mod = ChannelWord(Area::kG, row.mod_word, row.mod_name);
  if (settings_.handler_calls == HandlerCallsOption::kOnce)
    kind.called = ChannelByte(called_[0][number], "called_" + std::string(1, kHandlerKinds[number]));
  return kind;
}

ValueId Dispatcher::Masked(const Channel& channel, ir::PlaceId word, uint16_t mask) {
  return Pure(OpKind::kAnd16, {builder_.Load(word, builder_.Load(channel.index)), Mask(mask)});
}

ValueId Dispatcher::Has(const Channel& channel, ir::PlaceId word, uint16_t mask) {
  return Pure(OpKind::kNotEqual16, {Masked(channel, word, mask), Word(0)});
}

ValueId Dispatcher::Lacks(const Channel& channel, ir::PlaceId word, uint16_t mask) {
  return Pure(OpKind::kEqual16, {Masked(channel, word, mask), Word(0)});
}

void Dispatcher::GiveUp(const Channel& channel, const Kind& kind) {
  const ValueId at = builder_.Load(channel.index);
  const ValueId minus_one = Pure(OpKind::kMinus16, {Word(1)});
  builder_.Store(kind.mod, minus_one, at);
}

void Dispatcher::WhenIn(const Channel& channel, const Kind& kind, uint8_t state,
                        const std::function<ValueId()>& condition, const std::function<void()>& body) {
  const ValueId is_state = Pure(OpKind::kEqual8, {builder_.Load(kind.state, builder_.Load(channel.index)),
                                                  builder_.Constant(ir::Type::kI8, state)});
  builder_.When(is_state, [&] { builder_.When(condition(), body); });
}

void Dispatcher::Begin(const Channel& channel, const Kind& kind) {
  const KindRow& row = kRows[kind.number];
  const auto index = [&] { return builder_.Load(channel.index); };
  const auto requested = [&] {
    const ValueId not_cancelled = Lacks(channel, channel.strobes, kCancel);
    const ValueId asked = Has(channel, channel.strobes, row.strobe);
    return Pure(OpKind::kBitAnd, {asked, not_cancelled});
  };
  WhenIn(channel, kind, kIdle, requested, [&] {
    const ValueId at = index();
    const ValueId asked = builder_.Load(kind.code, index());
    builder_.Store(kind.mod, asked, at);
    ChangeBits(channel.flags, OpKind::kOr16, row.busy, channel.index);
    Put(kind.state, kActive, channel.index);
    if (kind.called.valid()) Put(kind.called, 0, channel.index);
    if (kHandlerKinds[kind.number] != 'M' || settings_.m00_flags == M00FlagsOption::kOff) return;
    const auto when_code = [&](uint16_t code, uint16_t flag) {
      builder_.When(Pure(OpKind::kEqual16, {builder_.Load(kind.code, index()), Word(code)}),
                    [&] { ChangeBits(channel.flags, OpKind::kOr16, flag, channel.index); });
    };
    when_code(0, kM00);
    when_code(1, kM01);
  });
}

void Dispatcher::Withdraw(const Channel& channel, const Kind& kind) {
  const KindRow& row = kRows[kind.number];
  const auto withdrawn = [&] {
    return Pure(OpKind::kBitOr, {Lacks(channel, channel.strobes, row.strobe), Has(channel, channel.strobes, kCancel)});
  };
  WhenIn(channel, kind, kActive, withdrawn, [&] {
    GiveUp(channel, kind);
    ChangeBits(channel.flags, OpKind::kAnd16, ~uint32_t{row.busy}, channel.index);
    Put(kind.state, kDone, channel.index);
  });
}

void Dispatcher::Continue(const Channel& channel, const Kind& kind) {
  const auto goes_on = [&] {
    const ValueId may_hold = Lacks(channel, channel.flags, kRows[kind.number].hold_disabled);
    const ValueId held = Has(channel, channel.strobes, kHold);
    return Pure(OpKind::kBitNot, {Pure(OpKind::kBitAnd, {held, may_hold})});
  };
  const auto call = [&] { handlers_.Call(kind.number, channel.index, [&] { GiveUp(channel, kind); }); };
  WhenIn(channel, kind, kActive, goes_on, [&] {
    if (!kind.called.valid()) return call();
    const ValueId called = builder_.Load(kind.called, builder_.Load(channel.index));
    builder_.When(Pure(OpKind::kEqual8, {called, builder_.Constant(ir::Type::kI8, 0)}), [&] {
      Put(kind.called, 1, channel.index);
      call();
    });
  });
}

void Dispatcher::End(const Channel& channel, const Kind& kind) {
  const KindRow& row = kRows[kind.number];
  const auto is_taken_back = [&] { return Lacks(channel, channel.strobes, row.strobe); };
  WhenIn(channel, kind, kDone, is_taken_back, [&] {
    ChangeBits(channel.acks, OpKind::kAnd16, ~uint32_t{row.ack}, channel.index);
    Put(kind.state, kIdle, channel.index);
  });
}

void Dispatcher::Dispatch(ir::PlaceId index) {
  const ir::PlaceId modal = ChannelByte(modal_[0], "modal");
  const ValueId is_asked =
      Pure(OpKind::kNotEqual8, {builder_.Load(modal, builder_.Load(index)), builder_.Constant(ir::Type::kI8, 0)});
  builder_.When(is_asked, [&] {
    Put(modal, 0, index);
    handlers_.Call(4, index, {});
  });
  Channel channel{.index = index};
  channel.strobes = ChannelWord(Area::kF, kStrobeWord, "mst_strobes");
  channel.acks = ChannelWord(Area::kG, kAckWord, "mst_acks");
  channel.flags = ChannelWord(Area::kG, kFlagsWord, "mst_flags");
  for (uint32_t number = 0; number < std::size(kRows); ++number) {
    const Kind kind = KindOf(number);
    Begin(channel, kind);
    Withdraw(channel, kind);
    Continue(channel, kind);
    End(channel, kind);
  }
}

void Dispatcher::Complete(ir::PlaceId channel) {
  const auto index = [&] { return builder_.Load(channel); };
  const ir::PlaceId acks = ChannelWord(Area::kG, kAckWord, "mst_acks"),
                    flags = ChannelWord(Area::kG, kFlagsWord, "mst_flags");
  const auto state_is = [&](uint32_t k, uint8_t value) {
    return Pure(OpKind::kEqual8, {builder_.Load(StateOf(k), index()), builder_.Constant(ir::Type::kI8, value)});
  };
  for (uint32_t k = 0; k < 4; ++k) {
    const KindRow& row = kRows[k];
    const ir::PlaceId mod = ChannelWord(Area::kG, row.mod_word, row.mod_name);
    builder_.When(state_is(k, kActive), [&] {
      builder_.When(Pure(OpKind::kEqual16, {builder_.Load(mod, index()), Pure(OpKind::kMinus16, {Word(1)})}), [&] {
        ChangeBits(flags, OpKind::kAnd16, ~uint32_t{row.busy}, channel);
        ChangeBits(acks, OpKind::kOr16, row.ack, channel);
        Put(StateOf(k), kDone, channel);
      });
    });
  }
  ValueId any = state_is(0, kActive);
  for (uint32_t k = 1; k < 4; ++k) any = Pure(OpKind::kBitOr, {any, state_is(k, kActive)});
  builder_.Choose(
      any, [&] { ChangeBits(acks, OpKind::kOr16, kAnyActive, channel); },
      [&] { ChangeBits(acks, OpKind::kAnd16, ~uint32_t{kAnyActive}, channel); });
}

void Dispatcher::AddScalars() {
  // One after the other, so that an index reaches them.
  modal_ = memory_.AddInputs("modal", "MODAL", ir::Type::kI8);
  for (uint32_t k = 0; k < 4; ++k) {
    for (uint32_t c = 0; c < 4; ++c) {
      states_[c][k] = memory_.AddScalar("state_" + std::string(1, kHandlerKinds[k]) + std::to_string(c), ir::Type::kI8);
    }
  }
  if (settings_.handler_calls == HandlerCallsOption::kOnce) {
    for (uint32_t k = 0; k < 4; ++k) {
      for (uint32_t c = 0; c < 4; ++c) {
        called_[c][k] =
            memory_.AddScalar("called_" + std::string(1, kHandlerKinds[k]) + std::to_string(c), ir::Type::kI8);
      }
    }
  }
}

}  // namespace plcxx::hnc
