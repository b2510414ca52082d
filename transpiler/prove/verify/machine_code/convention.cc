#include "transpiler/prove/verify/machine_code/convention.h"

namespace plcxx::prove::verify::machine_code {
namespace {

/// Integer calling convention of RISC-V's psABI: a0-a7 are x10-x17, s0-s11 are x8, x9, x18-x27; gp and tp stay, and the
/// stack pointer is aligned throughout.
Convention Riscv(unsigned bits) {
  return {.bits = bits,
          .registers = 32,
          .stack = 2,
          .link = 1,
          .arguments = {10, 11, 12, 13, 14, 15, 16, 17},
          .results = {10, 11},
          .kept = {2, 3, 4, 8, 9, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27},
          .platform = {3, 4},
          .linkers = {},
          .stack_align = 16,
          .least_stack_align = 16};
}

}  // namespace

const Convention& RiscvConvention(unsigned bits) {
  static const Convention k32 = Riscv(32), k64 = Riscv(64);
  return bits == 64 ? k64 : k32;
}

/// AAPCS, integers only: r0-r3, kept r4-r11 and sp; N, Z, C, V are flags 0 to 3. The processor has no two lowest bits
/// of sp, and a veneer between a call and its callee uses r12.
const Convention& ArmConvention() {
  static const Convention kArm = {.bits = 32,
                                  .registers = 15,
                                  .flags = 4,
                                  .stack = 13,
                                  .link = 14,
                                  .arguments = {0, 1, 2, 3},
                                  .results = {0, 1},
                                  .kept = {4, 5, 6, 7, 8, 9, 10, 11, 13},
                                  .platform = {},
                                  .linkers = {12},
                                  .pairs_are_even = true,
                                  .stack_align = 8,
                                  .least_stack_align = 4};
  return kArm;
}

}  // namespace plcxx::prove::verify::machine_code
