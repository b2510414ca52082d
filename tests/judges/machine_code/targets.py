"""What is different of the two targets: registers, and the assembler around an instance."""
import os

HERE = os.path.dirname(os.path.abspath(__file__))
FLAGS_OUT = 80
WORDS = "judge_words: .word 0x11223344, 0x8899aabb, 0xfedcba98, 0x7f80ff01, 0x00010203, 0xffffffff\n"


def pattern(i):
    return 0xC0DE00 + 257 * i


def riscv_keeps():
    """Calls a function as C++ does, with known numbers in what is kept and in the words above the stack pointer."""
    kept = [f"s{i}" for i in range(12)]
    lines = [".text", ".globl judge_keeps", "judge_keeps:", "addi sp, sp, -128", "sw ra, 60(sp)"]
    lines += [f"sw {reg}, {64 + 4 * i}(sp)" for i, reg in enumerate(kept)]
    for i in range(15):
        lines += [f"li t0, {pattern(32 + i)}", f"sw t0, {4 * i}(sp)"]
    lines += [f"li {reg}, {pattern(i)}" for i, reg in enumerate(kept)]
    lines += ["la t0, judge_saved", "sw sp, 0(t0)", "mv t0, a0", "mv a0, a1", "mv a1, a2", "mv a2, a3", "jalr t0",
              "la t0, judge_saved", "lw t1, 0(t0)", "sub a0, t1, sp", "mv sp, t1"]
    for i, reg in enumerate(kept):
        lines += [f"li t0, {pattern(i)}", f"xor t0, t0, {reg}", "or a0, a0, t0"]
    for i in range(15):
        lines += [f"li t0, {pattern(32 + i)}", f"lw t1, {4 * i}(sp)", "xor t0, t0, t1", "or a0, a0, t0"]
    lines += ["lw ra, 60(sp)"] + [f"lw {reg}, {64 + 4 * i}(sp)" for i, reg in enumerate(kept)]
    return "\n".join(lines + ["addi sp, sp, 128", "ret", ""])


def arm_keeps():
    """As riscv_keeps."""
    kept = [f"r{i}" for i in range(4, 12)]
    lines = [".text", ".globl judge_keeps", ".thumb_func", "judge_keeps:", "push {r4-r11, lr}", "sub sp, sp, #68"]
    for i in range(16):
        lines += [f"ldr r12, ={pattern(32 + i)}", f"str r12, [sp, #{4 * i}]"]
    lines += [f"ldr {reg}, ={pattern(i)}" for i, reg in enumerate(kept)]
    lines += ["ldr r12, =judge_saved", "str sp, [r12]", "mov r12, r0", "mov r0, r1", "mov r1, r2", "mov r2, r3", "blx r12",
              "ldr r1, =judge_saved", "ldr r1, [r1]", "mov r0, sp", "subs r0, r0, r1", "mov sp, r1"]
    for i, reg in enumerate(kept):
        lines += [f"ldr r1, ={pattern(i)}", f"eors r1, {reg}", "orrs r0, r1"]
    for i in range(16):
        lines += [f"ldr r1, ={pattern(32 + i)}", f"ldr r2, [sp, #{4 * i}]", "eors r1, r2", "orrs r0, r1"]
    return "\n".join(lines + ["add sp, sp, #68", "pop {r4-r11, pc}", ".ltorg", ""])


class Riscv:
    name = "rv32imac"
    processor = "sifive-e31"
    table = "riscv"
    compiler = "riscv64-unknown-elf-gcc"
    flags = ["-march=rv32imac", "-mabi=ilp32", "-mcmodel=medany"]
    emulator = ["qemu-system-riscv32", "-M", "virt", "-m", "64M", "-bios", "none"]
    disassembler = ["llvm-mc-19", "--disassemble", "--show-inst", "--triple=riscv32", "--mattr=+m,+c"]
    memory = "RAM (rwx) : ORIGIN = 0x80000000, LENGTH = 60M"
    data = "0x83c00000"
    order = ["ra", "t0", "t1", "t2", "s0", "s1", "a0", "a1", "a2", "a3", "a4", "a5", "sp"]
    registers = order[:-1]
    low = ["s0", "s1", "a0", "a1", "a2", "a3", "a4", "a5"]
    zero = "zero"
    has_flags = False
    keeps = riscv_keeps()
    results = ["a0", "a1"]
    arguments = ["a0", "a1", "a2", "a3"]
    scratched = ["ra", "t0", "t1", "t2", "a0", "a1", "a2", "a3", "a4", "a5"]

    start = f"""
.section .vectors, "ax"
.globl entry
entry:
  .option push
  .option norelax
  .weak __global_pointer$
  la gp, __global_pointer$
  .option pop
  la sp, judge_stack
  call main
.text
.option norelax
.option norvc
.balign 16
.globl judge_semihosting
judge_semihosting:
  slli x0, x0, 0x1f
  ebreak
  srai x0, x0, 7
  ret
.option rvc
.globl judge_call
judge_call:
  addi sp, sp, -64
  sw ra, 0(sp); sw s0, 4(sp); sw s1, 8(sp); sw s2, 12(sp); sw s3, 16(sp); sw s4, 20(sp); sw s5, 24(sp)
  sw s6, 28(sp); sw s7, 32(sp); sw s8, 36(sp); sw s9, 40(sp); sw s10, 44(sp); sw s11, 48(sp)
  la t0, judge_saved
  sw sp, 0(t0)
  mv t0, a0
  mv a0, a1
  jalr t0
  la t0, judge_saved
  lw sp, 0(t0)
  lw ra, 0(sp); lw s0, 4(sp); lw s1, 8(sp); lw s2, 12(sp); lw s3, 16(sp); lw s4, 20(sp); lw s5, 24(sp)
  lw s6, 28(sp); lw s7, 32(sp); lw s8, 36(sp); lw s9, 40(sp); lw s10, 44(sp); lw s11, 48(sp)
  addi sp, sp, 64
  ret
.bss
judge_saved: .skip 16
"""
    # Every few microseconds; a handler has the stack below the pointer.
    interrupts = """
.option arch, +zicsr
.text
.globl judge_interrupts
judge_interrupts:
  la t0, judge_tick
  csrw mtvec, t0
  li t0, 0x2004000
  sw zero, 4(t0)
  sw zero, 0(t0)
  li t0, 0x80
  csrs mie, t0
  csrsi mstatus, 8
  ret
.balign 4
judge_tick:
  addi sp, sp, -32
  sw t0, 24(sp)
  sw t1, 28(sp)
  li t0, 0x200bff8
  lw t1, 0(t0)
  addi t1, t1, 40
  li t0, 0x2004000
  sw t1, 0(t0)
  lw t0, 24(sp)
  lw t1, 28(sp)
  addi sp, sp, 32
  mret
"""
    common = f"""
.section .rodata
.balign 16
.globl judge_words
{WORDS}
.text
.globl judge_function
.type judge_function, @function
judge_function: addi a0, a0, 5; sub a1, a1, a0; ret
.size judge_function, . - judge_function
.globl judge_jumps
.type judge_jumps, @function
judge_jumps: addi a0, a0, 7; tail judge_function
.size judge_jumps, . - judge_jumps
.globl judge_far
.type judge_far, @function
judge_far: beq a0, a1, 1f; addi a0, a0, 1; jr ra; 1: addi a1, a1, 3; jalr zero, 0(ra)
.size judge_far, . - judge_far
"""

    def set_base(self, reg, offset):
        if -2048 <= offset < 2048:
            return [f"addi {reg}, s11, {offset}"]
        return [f"li t4, {offset}", f"add {reg}, s11, t4"]

    def stub(self, name, instance):
        lines = [f".globl {name}", f".type {name}, @function", f"{name}:", "mv s11, a0", "mv s10, ra"]
        loaded = self.registers + (["sp"] if "sp" in instance.bases else [])
        lines += [f"lw {reg}, {4 * self.order.index(reg)}(s11)" for reg in loaded if reg not in instance.bases]
        for reg, offset in instance.bases.items():
            lines += self.set_base(reg, offset)
        compressed = instance.lines[0].startswith("c.")
        lines += [f"{name}_b:"] + ([] if compressed else [".option push", ".option norvc"]) + instance.lines
        lines += ([] if compressed else [".option pop"]) + [f"{name}_e:"]
        lines += [f"sub {reg}, {reg}, s11" for reg in list(instance.bases) + instance.results if reg not in instance.zeroed]
        lines += [f"sw {reg}, {4 * self.order.index(reg)}(s11)" for reg in loaded]
        return lines + ["mv ra, s10", "ret", f".size {name}, . - {name}"]

    def clear(self, reg):
        return f"li {reg}, 0"

    def number(self, reg, value):
        return f"li {reg}, {value}"

    def call(self, symbol):
        return f"call {symbol}"

    def after_call(self):
        return []

    def truth(self, kind):
        """Of what comparisons of floats give only a part is promised."""
        return {"kTruth": [], "kZero": ["seqz a0, a0"], "kBelow": ["slti a0, a0, 0"], "kNotAbove": ["sgtz a0, a0"],
                "kAbove": ["sgtz a0, a0"], "kNotBelow": ["slti a0, a0, 0"]}[kind]


class Arm:
    name = "cortex-m4"
    processor = "cortex-m4"
    table = "arm"
    compiler = "arm-none-eabi-gcc"
    flags = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=soft"]
    emulator = ["qemu-system-arm", "-M", "mps2-an386"]
    disassembler = ["llvm-mc-19", "--disassemble", "--show-inst", "--triple=thumbv7em-none-eabi", "--mcpu=cortex-m4"]
    memory = "RAM (rwx) : ORIGIN = 0x00000000, LENGTH = 4M"
    data = "0x20000000"
    order = [f"r{i}" for i in range(13)] + ["sp", "lr"]
    registers = [f"r{i}" for i in range(10)] + ["lr"]
    low = [f"r{i}" for i in range(8)]
    zero = "r0"
    has_flags = True
    keeps = arm_keeps()
    results = ["r0", "r1", "r2", "r3"]
    arguments = ["r0", "r1", "r2", "r3"]
    scratched = ["r0", "r1", "r2", "r3", "lr"]

    start = """
.syntax unified
.section .vectors, "a"
.globl entry
entry:
  .word judge_stack, judge_start, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, judge_tick
.weak judge_tick
.text
.thumb_func
judge_start:
  bl main
.globl judge_semihosting
.thumb_func
judge_semihosting:
  bkpt 0xab
  bx lr
.globl judge_call
.thumb_func
judge_call:
  push {r4-r11, lr}
  ldr r2, =judge_saved
  str sp, [r2]
  mov r2, r0
  mov r0, r1
  blx r2
  ldr r2, =judge_saved
  ldr sp, [r2]
  pop {r4-r11, pc}
.ltorg
.bss
.balign 16
judge_saved: .skip 16
"""
    # Every few microseconds; the processor itself writes below the stack pointer.
    interrupts = """
.syntax unified
.text
.globl judge_interrupts
.thumb_func
judge_interrupts:
  ldr r0, =0xE000E010
  ldr r1, =200
  str r1, [r0, #4]
  movs r1, #0
  str r1, [r0, #8]
  movs r1, #7
  str r1, [r0]
  bx lr
.ltorg
.globl judge_tick
.thumb_func
.type judge_tick, %function
judge_tick:
  bx lr
"""
    common = f"""
.syntax unified
.section .rodata
.balign 16
.globl judge_words
{WORDS}
.text
.balign 4
.globl judge_function
.thumb_func
.type judge_function, %function
judge_function: adds r0, #5; subs r1, r1, r0; bx lr
.size judge_function, . - judge_function
.globl judge_returns
.thumb_func
.type judge_returns, %function
judge_returns: push {{r4, lr}}; cmp r0, r1; it eq; popeq {{r4, pc}}; adds r0, #9; bl judge_function; pop {{r4, pc}}
.size judge_returns, . - judge_returns
"""

    def set_base(self, reg, offset):
        if reg == "sp":
            return self.set_base("r12", offset) + ["mov sp, r12"]
        return [f"{'addw' if offset >= 0 else 'subw'} {reg}, r11, #{abs(offset)}"]

    def stub(self, name, instance):
        lines = [".balign 4", f".globl {name}", ".thumb_func", f".type {name}, %function", f"{name}:", "mov r11, r0",
                 "mov r10, lr", "ldr.w r0, [r11, #64]", "ldr.w r1, [r11, #68]", "adds.w r0, r0, r1",
                 "ldr.w r0, [r11, #72]", "tst.w r0, r0"]
        loaded = [reg for reg in self.registers if reg not in instance.bases]
        lines += [f"ldr.w {reg}, [r11, #{4 * self.order.index(reg)}]" for reg in loaded]
        for reg, offset in instance.bases.items():
            lines += self.set_base(reg, offset)
        lines += [f"{name}_b:"] + instance.lines + [f"{name}_e:"]
        for reg in list(instance.bases) + instance.results:
            if reg == "sp":
                lines += ["mov r12, sp", "sub.w r12, r12, r11", "str.w r12, [r11, #52]"]
            elif reg not in instance.zeroed:
                lines += [f"sub.w {reg}, {reg}, r11"]
        lines += [f"str.w {reg}, [r11, #{4 * self.order.index(reg)}]" for reg in self.registers]
        for i, (yes, no) in enumerate([("mi", "pl"), ("eq", "ne"), ("cs", "cc"), ("vs", "vc")]):
            lines += [f"ite {yes}", f"mov{yes} r12, #1", f"mov{no} r12, #0", f"str.w r12, [r11, #{FLAGS_OUT + 4 * i}]"]
        return lines + ["mov lr, r10", "bx lr", f".size {name}, . - {name}"]

    def clear(self, reg):
        return f"mov.w {reg}, #0"

    def number(self, reg, value):
        return f"movw {reg}, #{value}"

    def call(self, symbol):
        return f"bl {symbol}"

    def after_call(self):
        return ["cmp r11, r11"]  # flags, whatever they were

    def truth(self, kind):
        condition = {"kZero": "eq", "kBelow": "lt", "kNotAbove": "gt", "kAbove": "gt", "kNotBelow": "lt"}
        if kind == "kTruth":
            return []
        yes = condition[kind]
        no = {"eq": "ne", "lt": "ge", "gt": "le"}[yes]
        return ["cmp r0, #0", f"ite {yes}", f"mov{yes} r0, #1", f"mov{no} r0, #0"]


TARGETS = {"rv32imac": Riscv(), "cortex-m4": Arm()}
