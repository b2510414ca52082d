// Start-up code, SysTick and watchdog of a Cortex-M4; the addresses of devices are those of Arm's MPS2 board with the
// FPGA image AN386, which QEMU has as mps2-an386. Your machine: the vendor's watchdog and clock.

#include "../common/board.h"

#include <stddef.h>

extern "C" {
extern unsigned char stack_top[], data_begin[], data_end[], data_image[], bss_begin[], bss_end[];
}

namespace {

constexpr uint32_t kClockHz = 25'000'000;

volatile uint32_t& Register(uintptr_t address) { return *reinterpret_cast<volatile uint32_t*>(address); }

// ARMv7-M, B3.2 and B3.3.
constexpr uintptr_t kCoprocessorAccess = 0xE000ED88;
constexpr uintptr_t kSysTickControl = 0xE000E010, kSysTickReload = 0xE000E014, kSysTickValue = 0xE000E018;
// CMSDK watchdog: the first time out is an NMI, the second one resets.
constexpr uintptr_t kWatchdogLoad = 0x40008000, kWatchdogControl = 0x40008008, kWatchdogClear = 0x4000800C,
                    kWatchdogLock = 0x40008C00;
// CMSDK serial port: data, state (1 full to send, 2 received), control (1 sends, 2 receives), clocks of a bit.
constexpr uintptr_t kSerialData = 0x40004000, kSerialState = 0x40004004, kSerialControl = 0x40004008,
                    kSerialDivider = 0x40004010;

int Semihosting(int operation, const void* block) {
  register int r0 asm("r0") = operation;
  register const void* r1 asm("r1") = block;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

void Reset() {
  Register(kCoprocessorAccess) = Register(kCoprocessorAccess) | 0xFU << 20;  // the unit of floats
  asm volatile("dsb\n isb" ::: "memory");
  // Bytes by volatile, so that it becomes no call of a library that needs initialised data itself.
  for (ptrdiff_t i = 0; i < data_end - data_begin; ++i)
    const_cast<volatile unsigned char*>(data_begin)[i] = data_image[i];
  for (ptrdiff_t i = 0; i < bss_end - bss_begin; ++i) const_cast<volatile unsigned char*>(bss_begin)[i] = 0;
  main();
  board::End("main came back", 1);
}

void Exception() { FaultHook(FaultKind::kException); }

void NonMaskable() { FaultHook(FaultKind::kWatchdog); }

using Handler = void (*)();
union Vector {
  const void* stack;
  Handler handler;
};

[[gnu::section(".vectors"), gnu::used]] const Vector kVectors[16] = {
    {.stack = stack_top},   {.handler = Reset},     {.handler = NonMaskable}, {.handler = Exception},
    {.handler = Exception}, {.handler = Exception}, {.handler = Exception},   {.handler = Exception},
    {.handler = Exception}, {.handler = Exception}, {.handler = Exception},   {.handler = Exception},
    {.handler = Exception}, {.handler = Exception}, {.handler = Exception},   {.handler = TimerTick},
};

}  // namespace

namespace board {

void StartTimer(uint32_t period_us) {
  Register(kSysTickReload) = kClockHz / 1'000'000 * period_us - 1;  // 24 bits: up to 0.67 s
  Register(kSysTickValue) = 0;
  Register(kSysTickControl) = 7;  // processor's clock, interrupt, on
}

void StartWatchdog() {
  Register(kWatchdogLock) = 0x1ACCE551;
  Register(kWatchdogLoad) = kClockHz / 10;
  Register(kWatchdogControl) = 3;  // count and interrupt, reset
}

void FeedWatchdog() { Register(kWatchdogClear) = 1; }

void WaitForInterrupt() { asm volatile("wfi" ::: "memory"); }

void StartLink() {
  Register(kSerialDivider) = kClockHz / 115200;
  Register(kSerialControl) = 3;
}

bool LinkReceive(uint8_t& byte) {
  if ((Register(kSerialState) & 2) == 0) return false;
  byte = static_cast<uint8_t>(Register(kSerialData));
  return true;
}

bool LinkCanSend() { return (Register(kSerialState) & 1) == 0; }
void LinkSend(uint8_t byte) { Register(kSerialData) = byte; }

void End(const char* word, int code) {
  constexpr int kWriteText = 0x04, kExitExtended = 0x20, kApplicationExit = 0x20026;
  Semihosting(kWriteText, word);
  Semihosting(kWriteText, "\n");
  const int block[] = {kApplicationExit, code};
  for (;;) Semihosting(kExitExtended, block);
}

}  // namespace board
