#include "transpiler/dialects/hnc/lowering/dispatcher.h"

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

void Dispatcher::Dispatch(ir::PlaceId channel) {
  const auto index = [&] { return builder_.Load(channel); };
  const ir::PlaceId modal = ChannelByte(modal_[0], "modal");
  builder_.When(Pure(OpKind::kNotEqual8, {builder_.Load(modal, index()), builder_.Constant(ir::Type::kI8, 0)}), [&] {
    Put(modal, 0, channel);
    handlers_.Call(4, channel, {});
  });
  const ir::PlaceId strobes = ChannelWord(Area::kF, kStrobeWord, "mst_strobes");
  const ir::PlaceId acks = ChannelWord(Area::kG, kAckWord, "mst_acks"),
                    flags = ChannelWord(Area::kG, kFlagsWord, "mst_flags");
  const auto has = [&](ir::PlaceId place, uint16_t mask) {
    return Pure(OpKind::kNotEqual16, {Pure(OpKind::kAnd16, {builder_.Load(place, index()), Mask(mask)}), Word(0)});
  };
  const auto lacks = [&](ir::PlaceId place, uint16_t mask) {
    return Pure(OpKind::kEqual16, {Pure(OpKind::kAnd16, {builder_.Load(place, index()), Mask(mask)}), Word(0)});
  };
  const auto set = [&](ir::PlaceId word, uint16_t mask) { ChangeBits(word, OpKind::kOr16, mask, channel); };
  const auto clear = [&](ir::PlaceId word, uint16_t mask) {
    ChangeBits(word, OpKind::kAnd16, ~uint32_t{mask}, channel);
  };
  const auto both = [&](ValueId a, ValueId b) { return Pure(OpKind::kBitAnd, {a, b}); };
  for (uint32_t k = 0; k < 4; ++k) {
    const KindRow& row = kRows[k];
    const std::string letter(1, kHandlerKinds[k]);
    const ir::PlaceId state = StateOf(k);
    const ir::PlaceId code = ChannelWord(Area::kF, row.code_word, row.code_name);
    const ir::PlaceId mod = ChannelWord(Area::kG, row.mod_word, row.mod_name);
    const bool once = settings_.handler_calls == HandlerCallsOption::kOnce;
    const ir::PlaceId called = once ? ChannelByte(called_[0][k], "called_" + letter) : ir::PlaceId();
    const auto is = [&](uint8_t value) {
      return Pure(OpKind::kEqual8, {builder_.Load(state, index()), builder_.Constant(ir::Type::kI8, value)});
    };
    const auto become = [&](uint8_t value) { Put(state, value, channel); };
    const auto give_up = [&] {
      const ValueId at = index();
      const ValueId minus_one = Pure(OpKind::kMinus16, {Word(1)});
      builder_.Store(mod, minus_one, at);
    };
    // The state is asked alone and first: in most cycles there is no request, and a look at it is all that happens.
    const auto when = [&](uint8_t value, const std::function<ValueId()>& condition, const std::function<void()>& body) {
      builder_.When(is(value), [&] { builder_.When(condition(), body); });
    };
    const auto requested = [&] {
      const ValueId not_cancelled = lacks(strobes, kCancel);
      const ValueId asked = has(strobes, row.strobe);
      return both(asked, not_cancelled);
    };
    when(kIdle, requested, [&] {
      const ValueId at = index();
      const ValueId asked = builder_.Load(code, index());
      builder_.Store(mod, asked, at);
      set(flags, row.busy);
      become(kActive);
      if (once) Put(called, 0, channel);
      if (k != 0 || settings_.m00_flags == M00FlagsOption::kOff) return;
      builder_.When(Pure(OpKind::kEqual16, {builder_.Load(code, index()), Word(0)}), [&] { set(flags, kM00); });
      builder_.When(Pure(OpKind::kEqual16, {builder_.Load(code, index()), Word(1)}), [&] { set(flags, kM01); });
    });
    const auto withdrawn = [&] { return Pure(OpKind::kBitOr, {lacks(strobes, row.strobe), has(strobes, kCancel)}); };
    when(kActive, withdrawn, [&] {
      give_up();
      clear(flags, row.busy);
      become(kDone);
    });
    const auto goes_on = [&] {
      const ValueId may_hold = lacks(flags, row.hold_disabled);
      const ValueId held = has(strobes, kHold);
      return Pure(OpKind::kBitNot, {both(held, may_hold)});
    };
    when(kActive, goes_on, [&] {
      if (!once) {
        handlers_.Call(k, channel, give_up);
        return;
      }
      const ValueId first =
          Pure(OpKind::kEqual8, {builder_.Load(called, index()), builder_.Constant(ir::Type::kI8, 0)});
      builder_.When(first, [&] {
        Put(called, 1, channel);
        handlers_.Call(k, channel, give_up);
      });
    });
    when(
        kDone, [&] { return lacks(strobes, row.strobe); },
        [&] {
          clear(acks, row.ack);
          become(kIdle);
        });
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
