// The program's own memory: places of addresses, and instances of timers and counters.
#pragma once

#include <bitset>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Names;

class Cells : Context {
 public:
  Cells(const Context& context, Names& names) : Context(context), names_(names) {}

  ir::PlaceId PlaceOf(const Address& address);
  ir::ValueId Load(const Address& address) { return builder_.Load(PlaceOf(address)); }
  void Store(const Address& address, ir::ValueId value);
  ir::StateId InstanceOf(const Address& timer_or_counter);
  /// Those that were asked for.
  const std::vector<Address>& used() const { return used_; }
  /// By the number of the alarm: whether the program writes its bit.
  const std::bitset<kAlarmCount>& driven_alarms() const { return driven_alarms_; }

 private:
  Names& names_;
  std::unordered_map<uint32_t, ir::PlaceId> places_;     // by KeyOf
  std::unordered_map<uint32_t, ir::StateId> instances_;  // by KeyOf, without attribute
  std::vector<Address> used_;
  std::bitset<kAlarmCount> driven_alarms_;
};

}  // namespace plcxx::host50
