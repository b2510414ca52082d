// The dispatcher of M, S, T, B requests and the E call (specification 7.3).
#pragma once

#include <array>
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
  void Dispatch(ir::PlaceId channel);
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
