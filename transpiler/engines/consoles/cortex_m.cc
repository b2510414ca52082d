// The first instructions on Cortex-M4 and M7 of QEMU's boards mps2-an386 and mps2-an500.

#include <processor.h>

extern "C" unsigned char plcxx_stack_top[];

namespace plcxx_console {
namespace {

using Handler = void (*)();

[[noreturn]] void Start() {
  // Full access to coprocessors 10 and 11: the unit of floats (CPACR, ARMv7-M B3.2.20).
  auto* const access = reinterpret_cast<volatile uint32_t*>(0xE000ED88);
  *access = *access | 0xFU << 20;
  asm volatile("dsb\n isb" ::: "memory");
  Run();
}

union Entry {
  const void* stack;
  Handler handler;
};

// Stack, reset, then the fifteen exceptions of the core. No interrupt is ever allowed.
[[gnu::section(".plcxx.vectors"), gnu::used]] const Entry kVectors[16] = {
    {.stack = plcxx_stack_top}, {.handler = Start}, {.handler = Fault}, {.handler = Fault},
    {.handler = Fault},         {.handler = Fault}, {.handler = Fault}, {.handler = Fault},
    {.handler = Fault},         {.handler = Fault}, {.handler = Fault}, {.handler = Fault},
    {.handler = Fault},         {.handler = Fault}, {.handler = Fault}, {.handler = Fault},
};

}  // namespace

intptr_t Semihosting(intptr_t operation, const void* block) {
  register intptr_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = block;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

}  // namespace plcxx_console
