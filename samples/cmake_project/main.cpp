// A test bench of the station: no terminals, a clock that counts periods.
#include <cstdio>

#include "coolant.hpp"

struct coolant::Host {
  uint32_t ms = 0;
  bool start = false, filter = false;
};

namespace coolant {
uint32_t now_ms(Host& host) noexcept { return host.ms; }
void read_inputs(Host& host, State& m) noexcept {
  m[START] = host.start;
  m[STOP] = true;
  m[FILTER] = host.filter;
}
void write_outputs(Host&, const State&) noexcept {}
void retentive_store(Host&, const Retentive&) noexcept {}
}  // namespace coolant

int main() {
  coolant::Host host;
  coolant::State state;
  coolant::init(state, host);
  unsigned blinks = 0;
  bool lamp = false;
  for (; host.ms < 10'000; host.ms += 10) {
    host.start = host.ms == 100;
    host.filter = host.ms >= 1000;
    coolant::period(state, host);
    blinks += state[coolant::LAMP] && !lamp ? 1 : 0;
    lamp = state[coolant::LAMP];
  }
  std::printf("pump 1: %d, pump 2: %d, the lamp came on %u times\n", static_cast<int>(state[coolant::PUMP1]),
              static_cast<int>(state[coolant::PUMP2]), blinks);
  return state[coolant::PUMP1] != state[coolant::PUMP2] && blinks > 0 ? 0 : 1;
}
