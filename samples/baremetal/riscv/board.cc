// Start-up code and machine timer of a RISC-V; the addresses of devices are those of QEMU's board virt, whose interrupt
// controller of the core (CLINT) most vendors have, too. It has no watchdog. Your machine: the vendor's.

#include "../common/board.h"

#include <stddef.h>

extern "C" {
extern unsigned char data_begin[], data_end[], data_image[], bss_begin[], bss_end[];
}

// A name for the instructions of control registers, which GCC's rv32imac does not say.
#define BOARD_CSR(instruction) ".option push\n.option arch, +zicsr\n" instruction "\n.option pop\n"

namespace {

constexpr uint32_t kTimerHz = 10'000'000;
constexpr uintptr_t kCompareLow = 0x02004000, kCompareHigh = 0x02004004;
constexpr uintptr_t kTimeLow = 0x0200BFF8, kTimeHigh = 0x0200BFFC;

// The serial port, a 16550: data, and state (1 received, 32 room to send).
constexpr uintptr_t kSerialData = 0x10000000, kSerialState = 0x10000005;

volatile uint8_t& ByteRegister(uintptr_t address) { return *reinterpret_cast<volatile uint8_t*>(address); }
volatile uint32_t& Register(uintptr_t address) { return *reinterpret_cast<volatile uint32_t*>(address); }

uint32_t ticks_of_period = 0;
uint64_t next_tick = 0;

uint64_t Now() {
  for (;;) {
    const uint32_t high = Register(kTimeHigh);
    const uint32_t low = Register(kTimeLow);
    if (high == Register(kTimeHigh)) return static_cast<uint64_t>(high) << 32 | low;
  }
}

void SetCompare(uint64_t time) {
  Register(kCompareHigh) = 0xFFFFFFFF;  // no interrupt while the halves do not belong together
  Register(kCompareLow) = static_cast<uint32_t>(time);
  Register(kCompareHigh) = static_cast<uint32_t>(time >> 32);
}

intptr_t Semihosting(intptr_t operation, const void* block) {
  register intptr_t a0 asm("a0") = operation;
  register const void* a1 asm("a1") = block;
  asm volatile(
      ".balign 16\n.option push\n.option norvc\n"
      "slli zero, zero, 0x1f\nebreak\nsrai zero, zero, 7\n"
      ".option pop"
      : "+r"(a0)
      : "r"(a1)
      : "memory");
  return a0;
}

}  // namespace

extern "C" {

[[gnu::used, gnu::interrupt("machine"), gnu::aligned(4)]] void Trap() {
  uintptr_t cause = 0;
  asm volatile(BOARD_CSR("csrr %0, mcause") : "=r"(cause));
  constexpr uintptr_t kInterrupt = static_cast<uintptr_t>(1) << (8 * sizeof(uintptr_t) - 1), kMachineTimer = 7;
  if (cause != (kInterrupt | kMachineTimer)) FaultHook(FaultKind::kException);
  next_tick += ticks_of_period;
  SetCompare(next_tick);
  TimerTick();
}

[[gnu::used, noreturn]] void Reset() {
#ifdef __riscv_flen
  asm volatile(BOARD_CSR("csrs mstatus, %0")::"r"(0x6000) : "memory");  // FS: the unit of floats is in use
#endif
  // Bytes by volatile, so that it becomes no call of a library that needs initialised data itself.
  for (ptrdiff_t i = 0; i < data_end - data_begin; ++i)
    const_cast<volatile unsigned char*>(data_begin)[i] = data_image[i];
  for (ptrdiff_t i = 0; i < bss_end - bss_begin; ++i) const_cast<volatile unsigned char*>(bss_begin)[i] = 0;
  main();
  board::End("main came back", 1);
}
}

asm(R"(
  .section .vectors, "ax"
  .globl entry
entry:
  .option push
  .option norelax
  la gp, __global_pointer$
  .option pop
  la sp, stack_top
  la t0, Trap
)" BOARD_CSR("csrw mtvec, t0") R"(
  j Reset
  .text
)");

namespace board {

void StartTimer(uint32_t period_us) {
  ticks_of_period = kTimerHz / 1'000'000 * period_us;
  next_tick = Now() + ticks_of_period;
  SetCompare(next_tick);
  asm volatile(BOARD_CSR("csrs mie, %0")::"r"(1U << 7) : "memory");      // the machine timer
  asm volatile(BOARD_CSR("csrs mstatus, %0")::"r"(1U << 3) : "memory");  // interrupts
}

void StartWatchdog() {}
void FeedWatchdog() {}

void WaitForInterrupt() { asm volatile("wfi" ::: "memory"); }

void StartLink() {}  // QEMU's needs no rate

bool LinkReceive(uint8_t& byte) {
  if ((ByteRegister(kSerialState) & 1) == 0) return false;
  byte = ByteRegister(kSerialData);
  return true;
}

bool LinkCanSend() { return (ByteRegister(kSerialState) & 32) != 0; }
void LinkSend(uint8_t byte) { ByteRegister(kSerialData) = byte; }

void End(const char* word, int code) {
  constexpr intptr_t kWriteText = 0x04, kExitExtended = 0x20, kApplicationExit = 0x20026;
  Semihosting(kWriteText, word);
  Semihosting(kWriteText, "\n");
  const intptr_t block[] = {kApplicationExit, code};
  for (;;) Semihosting(kExitExtended, block);
}

}  // namespace board
