// The first instructions on RISC-V with 32 or 64 bits of QEMU's board virt.

#include <processor.h>

namespace plcxx_console {
namespace {

extern "C" {
/// With a stack, after the first instructions.
[[noreturn, gnu::used]] void plcxx_start() {
#ifdef __riscv_flen
  asm volatile("csrs mstatus, %0" ::"r"(0x6000) : "memory");  // FS: the unit of floats is in use
#endif
  Run();
}

/// mtvec wants an address that four divides.
[[noreturn, gnu::used, gnu::aligned(4)]] void plcxx_trap() { Fault(); }
}

}  // namespace

asm(R"(
  .section .plcxx.vectors, "ax"
  .globl plcxx_entry
plcxx_entry:
  .option push
  .option norelax
  la gp, __global_pointer$
  .option pop
  la sp, plcxx_stack_top
  la t0, plcxx_trap
  .option push
  .option arch, +zicsr
  csrw mtvec, t0
  .option pop
  j plcxx_start
  .text
)");

// The three instructions are one request; they must not be compressed, and lie in one page.
intptr_t Semihosting(intptr_t operation, const void* block) {
  register intptr_t a0 asm("a0") = operation;
  register const void* a1 asm("a1") = block;
  asm volatile(
      ".balign 16\n"
      ".option push\n"
      ".option norvc\n"
      "slli zero, zero, 0x1f\n"
      "ebreak\n"
      "srai zero, zero, 7\n"
      ".option pop"
      : "+r"(a0)
      : "r"(a1)
      : "memory");
  return a0;
}

}  // namespace plcxx_console
