"""Instructions of a scan on a Cortex-M4 and an RV32, counted by QEMU: generated code against the one by hand.

QEMU runs with -icount shift=0: an instruction takes a nanosecond of its clock. On RISC-V instret counts instructions; the
timer of the Cortex-M board counts 25 MHz, so that a reading there is exact to 40 instructions.
"""
import re
import shutil
import subprocess

LINK = """
ENTRY(start)
SECTIONS {
  . = %s;
  .text : { KEEP(*(.start)) *(.text*) *(.rodata*) }
  %s
  .data : { *(.data*) *(.sdata*) }
  .bss : { bss_begin = .; *(.bss*) *(.sbss*) *(COMMON) . = ALIGN(8); bss_end = .; }
  . = ALIGN(16);
  . += 65536;
  stack_top = .;
  /DISCARD/ : { *(.eh_frame*) *(.ARM.exidx*) }
}
"""

# Start, timer and output of both boards: calls Measure() and ends.
PROCESSOR = r"""
#include <stddef.h>
#include <stdint.h>
extern "C" {
extern uint32_t bss_begin[], bss_end[];
void* memset(void* to, int value, size_t size) {
  volatile unsigned char* at = static_cast<unsigned char*>(to);
  while (size-- > 0) *at++ = static_cast<unsigned char>(value);
  return to;
}
void* memcpy(void* to, const void* from, size_t size) {
  volatile unsigned char* at = static_cast<unsigned char*>(to);
  const unsigned char* source = static_cast<const unsigned char*>(from);
  while (size-- > 0) *at++ = *source++;
  return to;
}
[[noreturn]] void run();
}
#if defined(__arm__)
static intptr_t Semihost(uint32_t call, const void* argument) {
  register uint32_t r0 asm("r0") = call;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return static_cast<intptr_t>(r0);
}
static volatile uint32_t* const kTimer = reinterpret_cast<volatile uint32_t*>(0x40000000);
static void StartTicks() { kTimer[2] = 0xFFFFFFFF; kTimer[1] = 0xFFFFFFFF; kTimer[0] = 1; }
static uint32_t Ticks() { return 0xFFFFFFFF - kTimer[1]; }
static const uint32_t kInstructions = 40;  // of a tick
extern "C" uint32_t stack_top[];
extern "C" [[noreturn]] void start() { run(); }
[[gnu::used, gnu::section(".start")]] static const void* const vectors[] = {stack_top, reinterpret_cast<void*>(start)};
#else
static intptr_t Semihost(uint32_t call, const void* argument) {
  register uintptr_t a0 asm("a0") = call;
  register const void* a1 asm("a1") = argument;
  asm volatile(".option push\n.option norvc\n.balign 16\nslli x0, x0, 0x1f\nebreak\nsrai x0, x0, 7\n.option pop"
               : "+r"(a0) : "r"(a1) : "memory");
  return static_cast<intptr_t>(a0);
}
static void StartTicks() {}
static uint32_t Ticks() { uintptr_t count; asm volatile("csrr %0, 0xC02" : "=r"(count)); return static_cast<uint32_t>(count); }
static const uint32_t kInstructions = 1;
asm(".section .start,\"ax\"\n.globl start\nstart:\nla sp, stack_top\ntail run\n");
#endif
static void Print(const char* text) { Semihost(4, text); }
static void Print(uint64_t value) {
  char digits[24];
  char* at = digits + sizeof digits;
  *--at = '\0';
  *--at = ' ';
  do { *--at = static_cast<char>('0' + value % 10); value /= 10; } while (value > 0);
  Print(at);
}
void Measure();
extern "C" void run() {
  for (uint32_t* at = bss_begin; at != bss_end; ++at) *at = 0;
  StartTicks();
  Measure();
#if defined(__arm__)
  Semihost(0x18, reinterpret_cast<void*>(0x20026));
#else
  const uintptr_t done[2] = {0x20026, 0};
  Semihost(0x18, done);
#endif
  for (;;) {}
}
"""

# A scan of generated code against the same by hand.
COMPARISON = r"""
extern "C" {
void reference_scan(uint32_t); void reference_set(uint32_t); uint64_t reference_sum();
void generated_init(); void generated_scan(uint32_t); void generated_set(uint32_t); uint64_t generated_sum();
}
static uint64_t total[2], worst[2];
static void Note(int which, uint32_t ticks) {
  const uint64_t count = static_cast<uint64_t>(ticks) * kInstructions;
  total[which] += count;
  if (count > worst[which]) worst[which] = count;
}
void Measure() {
  generated_init();
  uint32_t t = 0, seed = 1;
  const uint32_t scans = 200;
  for (uint32_t i = 0; i < scans; ++i, t += PERIOD) {
    seed = seed * 1664525u + 1013904223u;
    reference_set(seed); generated_set(seed);
    const uint32_t begin = Ticks();
    reference_scan(t);
    const uint32_t middle = Ticks();
    generated_scan(t);
    const uint32_t end = Ticks();
    Note(0, middle - begin);
    Note(1, end - middle);
    if (reference_sum() != generated_sum()) Print("different ");
  }
  for (int which = 0; which < 2; ++which) { Print(total[which] / scans); Print(worst[which]); }
}
"""

BOARDS = {
    "M4": {
        "prefix": "arm-none-eabi-",
        "flags": ["-mcpu=cortex-m4", "-mthumb"],
        "link": ("0", ". = 0x20000000;"),
        "qemu": ["qemu-system-arm", "-machine", "mps2-an386"],
    },
    "RV32": {
        "prefix": "riscv64-unknown-elf-",
        "flags": ["-march=rv32imac", "-mabi=ilp32", "-mcmodel=medany"],
        "main": ["-march=rv32imac_zicsr", "-mabi=ilp32", "-mcmodel=medany", "-mno-relax"],
        "link": ("0x80000000", ""),
        "qemu": ["qemu-system-riscv32", "-machine", "virt", "-bios", "none", "-m", "64M"],
    },
}


def execute(name, directory, main, objects, flags=()):
    """What `main`, behind PROCESSOR and linked with the objects, prints on that board; None without tools."""
    board = BOARDS[name]
    if shutil.which(board["prefix"] + "g++") is None or shutil.which(board["qemu"][0]) is None:
        return None
    (directory / "emulated.cpp").write_text(PROCESSOR + main)
    (directory / "emulated.ld").write_text(LINK % board["link"])
    release = ["-std=c++17", "-O2", "-fno-exceptions", "-fno-rtti", "-ffreestanding", "-fno-tree-loop-distribute-patterns"]
    compiler = [board["prefix"] + "g++", *release]
    subprocess.run([*compiler, *board.get("main", board["flags"]), *flags, "-c", "emulated.cpp", "-o", "emulated.o"], cwd=directory, check=True)
    subprocess.run([*compiler, *board["flags"], "-nostartfiles", "-nostdlib", "-Wl,--no-warn-rwx-segments", "-T", "emulated.ld", "emulated.o",
                    *objects, "-lgcc", "-o", "emulated.elf"], cwd=directory, check=True)
    run = subprocess.run([*board["qemu"], "-icount", "shift=0", "-nographic", "-monitor", "none", "-serial", "none",
                          "-semihosting-config", "enable=on,target=native", "-kernel", "emulated.elf"],
                         cwd=directory, capture_output=True, text=True, timeout=600)
    return run.stdout + run.stderr


def instructions(name, directory, sources, count, period):
    """{"M4 instr/stmt": of the generated scan, its ratio to the one by hand, its worst scan to its mean}; {} without tools."""
    text = execute(name, directory, f"#define PERIOD {period}\n" + COMPARISON, [s.stem + ".o" for s in sources])
    if text is None:
        return {}
    if "different" in text:
        raise SystemExit(f"{name}: generated code and the one by hand differ in {directory}")
    numbers = re.findall(r"\d+", text)
    if len(numbers) != 4:
        raise SystemExit(f"{name}: no figures from the emulator: {text}")
    by_hand, _, mean, worst = map(int, numbers)
    return {f"{name} instr/stmt": mean / count, f"{name} instr ratio": mean / by_hand, f"{name} worst/mean": worst / mean,
            f"{name} worst instr": worst}
