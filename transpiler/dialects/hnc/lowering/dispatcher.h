// The dispatcher of M, S, T, B requests and the E call (specification 7.3).
#pragma once

#include <array>
#include <functional>
#include <string>
#include <unordered_map>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Handlers;
class Locals;
class Memory;

class Dispatcher : Context {
 public:
  Dispatcher(const Context& context, Memory& memory, Locals& locals, Handlers& handlers)
      : Context(context), memory_(memory), locals_(locals), handlers_(handlers) {}

  void AddRoutines();
  void AddScalars();
  ir::RoutineId dispatch() const { return dispatch_; }
  ir::RoutineId complete() const { return complete_; }

 private:
  ir::PlaceId ChannelWord(Area area, uint32_t word, std::string_view name);
  ir::PlaceId ChannelByte(ir::PlaceId first, const std::string& name);
  ir::PlaceId StateOf(uint32_t kind);
  ir::ValueId Mask(uint32_t bits);
  void ChangeBits(ir::PlaceId word, ir::OpKind op, uint32_t mask, ir::PlaceId channel);
  void Put(ir::PlaceId byte, uint8_t value, ir::PlaceId channel);
  ir::RoutineId AddChannelRoutine(const std::string& name, std::string comment, ir::PlaceId& channel);

  /// Where the words of the channel are that `index` has the number of.
  struct Channel {
    ir::PlaceId index, strobes, acks, flags;
  };
  /// One of M, S, T, B: what the channel has of it.
  struct Kind {
    uint32_t number = 0;
    ir::PlaceId state, code, mod;
    ir::PlaceId called;  // where its handler is called once for each request; else none
  };
  Kind KindOf(uint32_t number);
  ir::ValueId Masked(const Channel& channel, ir::PlaceId word, uint16_t mask);
  ir::ValueId Has(const Channel& channel, ir::PlaceId word, uint16_t mask);
  ir::ValueId Lacks(const Channel& channel, ir::PlaceId word, uint16_t mask);
  void GiveUp(const Channel& channel, const Kind& kind);
  /// The state is asked alone and first: in most cycles there is no request, and asking for it is all that happens.
  void WhenIn(const Channel& channel, const Kind& kind, uint8_t state, const std::function<ir::ValueId()>& condition,
              const std::function<void()>& body);
  /// What a request goes through: it is asked for, taken back before it is done, executed, and its end is acknowledged.
  void Begin(const Channel& channel, const Kind& kind);
  void Withdraw(const Channel& channel, const Kind& kind);
  void Continue(const Channel& channel, const Kind& kind);
  void End(const Channel& channel, const Kind& kind);
  void Dispatch(ir::PlaceId index);
  void Complete(ir::PlaceId channel);

  Memory& memory_;
  Locals& locals_;
  Handlers& handlers_;
  ir::RoutineId dispatch_, complete_;
  std::array<std::array<ir::PlaceId, 4>, 4> states_, called_;
  std::array<ir::PlaceId, 4> modal_;
  std::unordered_map<std::string, ir::PlaceId> places_;  // by name: indexed by the channel
};

}  // namespace plcxx::hnc
