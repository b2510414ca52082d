// Runs the generated code on random states, in QEMU: what each routine leaves of State, what it tells the host, and
// whether it keeps what its callers rely on, is written to a file of the host's.
#include <stdarg.h>

#include "turret.hpp"

struct turret::Host {
  uint32_t told;  // of calls, in order, with what State was then
};

extern "C" {
intptr_t judge_semihosting(intptr_t operation, const void* block);
/// From here on the processor is interrupted again and again.
void judge_interrupts();
/// Calls it with three arguments and known numbers in all registers that are kept; 0: they are, and the stack, too.
uint32_t judge_keeps(const void* function, void* a, uintptr_t b, void* c);
void* memcpy(void* to, const void* from, size_t bytes) {
  for (size_t i = 0; i < bytes; ++i) static_cast<volatile uint8_t*>(to)[i] = static_cast<const uint8_t*>(from)[i];
  return to;
}
void* memset(void* to, int byte, size_t bytes) {
  for (size_t i = 0; i < bytes; ++i) static_cast<volatile uint8_t*>(to)[i] = static_cast<uint8_t>(byte);
  return to;
}
}

namespace {

uint32_t random_state = 1;

uint32_t Random() {
  random_state ^= random_state << 13;
  random_state ^= random_state >> 17;
  random_state ^= random_state << 5;
  return random_state;
}

/// Small, at an end of the range, or anything.
uint32_t Number() {
  const uint32_t kind = Random() % 8;
  if (kind < 3) return Random() % 6;
  if (kind == 3) return 0U - Random() % 4;
  if (kind == 4) return 995 + Random() % 10;
  if (kind == 5) return 0x80000000U - 2 + Random() % 4;
  return Random();
}
bool Bit() { return (Random() >> 7 & 1) != 0; }
uint8_t Byte() { return static_cast<uint8_t>(Bit() ? Random() % 24 : Bit() ? 0x2F + Random() % 8 : Random()); }

void Fill(turret::State& m) {
  for (uint8_t& byte : m.retentive.bytes) byte = Byte();
  m.retentive.layout = Bit() ? turret::kRetentiveLayout : Number();
  const uint32_t near = Number();
  const auto about = [near] { return Bit() ? near + Random() % 5 - 2 : Number(); };
  for (uint32_t& word : m.word32) word = about();
  for (plcxx::OnDelayTimer& t : m.on_delay_timer) t = {about(), about(), Bit(), Bit(), Bit(), Bit()};
  for (plcxx::RingCounter& c : m.ring_counter)
    c = {about(), Byte(), Bit(), Bit(), Bit(), Bit(), static_cast<uint8_t>(Random() % 3)};
  for (plcxx::OneShot& o : m.one_shot) o = {about(), about(), Bit(), Bit(), Bit()};
  for (uint8_t& byte : m.byte) byte = Byte();
  for (bool& bit : m.bit) bit = Bit();
}

void Tell(turret::Host& host, uint32_t what) { host.told = (host.told ^ what) * 0x01000193U + 7; }
void Tell(turret::Host& host, const void* bytes, size_t count) {
  for (size_t i = 0; i < count; ++i) Tell(host, static_cast<const uint8_t*>(bytes)[i]);
}

/// Counts on what a host may count on: variables of its own, and that numbers on the stack are aligned.
uint32_t calls = 3, limits = 77;
[[gnu::noinline]] uint32_t Sum(int count, ...) {
  va_list list;
  va_start(list, count);
  uint32_t sum = 0;
  for (int i = 1; i < 8; ++i) sum += va_arg(list, uint32_t);
  sum += static_cast<uint32_t>(va_arg(list, uint64_t)) * 3;
  va_end(list);
  return sum;
}

}  // namespace

namespace turret {
uint32_t now_ms(Host& host) noexcept {
  Tell(host, 1);
  Tell(host, ++calls * limits);
  Tell(host, Sum(1, 2, 3, 4, 5, 6, 7, 8, uint64_t{66} + calls));
  return host.told;
}
void read_inputs(Host& host, State& m) noexcept {
  Tell(host, 2);
  m[I0A0] = (host.told & 2) != 0;
  m[I0A4] = (host.told & 4) != 0;
  m[W3K0] = static_cast<uint8_t>(host.told >> 8);
}
void write_outputs(Host& host, const State& m) noexcept { Tell(host, &m, offsetof(State, bit) + sizeof m.bit); }
void retentive_store(Host& host, const Retentive& retentive) noexcept { Tell(host, &retentive, sizeof retentive); }
}  // namespace turret

int main() {
  static const char name[] = JUDGE_RESULTS;
  const intptr_t open[] = {(intptr_t)name, 5 /* wb */, sizeof name - 1};
  const intptr_t file = judge_semihosting(1, open);
  static struct {
    turret::State before, m;
    turret::Host host;
    uint32_t broken;
  } all;
  judge_interrupts();
  using namespace turret;
  const void* const routines[] = {reinterpret_cast<const void*>(&init), reinterpret_cast<const void*>(&fast),
                                  reinterpret_cast<const void*>(&slow), reinterpret_cast<const void*>(&period)};
  for (int i = 0; i < JUDGE_STATES; ++i) {
    Fill(all.before);
    for (size_t which = 0; which < 4; ++which) {
      memcpy(&all.m, &all.before, sizeof all.m);
      all.host.told = static_cast<uint32_t>(i);
      const bool sliced = which == 2;
      void* const host = &all.host;
      all.broken = judge_keeps(routines[which], &all.m, sliced ? 0 : reinterpret_cast<uintptr_t>(host), host);
      uint32_t sum = all.broken;
      for (size_t at = 0; at < offsetof(State, bit) + sizeof all.m.bit; ++at)
        sum = (sum ^ reinterpret_cast<const uint8_t*>(&all.m)[at]) * 0x01000193U + 1;
      const uint32_t result[] = {sum, all.host.told, all.broken};
      const intptr_t write[] = {file, (intptr_t)result, sizeof result};
      judge_semihosting(5, write);
    }
  }
  const intptr_t close[] = {file};
  judge_semihosting(2, close);
  const intptr_t end[] = {0x20026, 0};  // ADP_Stopped_ApplicationExit
  judge_semihosting(0x20, end);
  judge_semihosting(0x18, (const void*)0x20026);
  for (;;) {
  }
}
