// A fast part in a real timer's interrupt above the slow part: at the end of every pass U101K1 and U101K2 must differ,
// because the program makes both of the same value. EXPECTS_MIXTURE: of a program that --preemptive refuses.

#include "samples/baremetal/common/board.h"

#include PROGRAM_HEADER

namespace {

#ifndef EXPECTS_MIXTURE
#define EXPECTS_MIXTURE 0
#endif

constexpr uint32_t kPasses = 4'000;
constexpr uint32_t kTickUs = 20;  // some thousand instructions: it meets many passes in their middle

}  // namespace

namespace program {

struct Host {};

uint32_t now_ms(Host&) noexcept { return 0; }
void read_inputs(Host&, State&) noexcept {}
void write_outputs(Host&, const State&) noexcept {}
void retentive_load(Host&, Retentive&) noexcept {}
void retentive_store(Host&, const Retentive&) noexcept {}

}  // namespace program

namespace {

program::State machine;
program::Host host;
volatile bool in_pass = false;
volatile uint32_t ticks_in_passes = 0;

}  // namespace

void TimerTick() {
  if (in_pass) ticks_in_passes = ticks_in_passes + 1;
  program::fast(machine, host);
}

void FaultHook(FaultKind) { board::End("fault", 3); }

int main() {
  program::init(machine, host);
  board::StartTimer(kTickUs);
  uint32_t mixtures = 0;
  for (uint32_t i = 0; i < kPasses; ++i) {
    in_pass = true;
    program::slow(machine, 0, host);
    in_pass = false;
    const bool first = machine[program::U101K1], second = machine[program::U101K2];
    if (first == second) ++mixtures;
  }
  if (ticks_in_passes < 100) board::End("too few interrupts in the middle of a pass", 2);
  if (EXPECTS_MIXTURE == 1) board::End(mixtures > 0 ? "a pass saw two values" : "every pass saw one value", 0);
  board::End(mixtures == 0 ? "every pass saw one value" : "a pass saw two values", mixtures == 0 ? 0 : 1);
}
