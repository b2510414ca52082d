#!/usr/bin/env python3
"""Each row of plcxx verify --object against a processor: what the lifted instruction does to registers, flags and
memory is what QEMU's processor does, and what a function of the compiler's library does is what libgcc's does.

run.py RUNNER ROWS TARGET DIRECTORY [--each N] [--states N] [--seed N] [--rounds N]

ROWS is the folder of riscv.def, arm.def and library.def. Of each line of riscv.txt or arm.txt N instances are made with
other registers and numbers, in each round with another seed; LLVM's disassembler says which row each is. A row without an
instance is a failure.
"""
import argparse
import os
import random
import re
import shutil
import struct
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from instances import SCRATCH, SCRATCH_END, fill, word  # noqa: E402
from library import library_instance, rows  # noqa: E402
from targets import FLAGS_OUT, HERE, TARGETS  # noqa: E402

BLOCK, HEADER = SCRATCH_END, 76
# a, b of a sum that leaves these flags C and V; then a number whose sign and zero are N and Z.
CARRIES = [(1, 1), (0xFFFFFFFF, 2), (0x7FFFFFFF, 1), (0x80000000, 0x80000001)]
SIGNS = [0, 1, 0xFFFFFFFF]


def run(command, **options):
    result = subprocess.run(command, capture_output=True, **options)
    if result.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{result.stdout.decode()[-2000:]}{result.stderr.decode()[-4000:]}")
    return result.stdout


def accepted_rows(path):
    names = re.findall(r"^PLCXX_\w+\((\w+),", open(path).read(), re.M)
    return [name for name in names if name != "NAME"]


def headers(target, instances, states, rng):
    out = bytearray()
    for instance in instances:
        for k in range(states):
            words = [word(rng) for _ in range(16)]
            if instance.header is not None:
                for reg, value in zip(target.arguments, instance.header(rng)):
                    words[target.order.index(reg)] = value
            for reg, make in instance.values.items():
                words[target.order.index(reg)] = make(rng)
            for reg in instance.bases:
                words[target.order.index(reg)] = 0
            a, b = rng.choice(CARRIES)
            out += struct.pack("<19I", *words, a, b, rng.choice(SIGNS))
    return bytes(out)


def build(target, instances, states, directory):
    path = lambda name: os.path.join(directory, name)  # noqa: E731
    lines = [target.common, ".text"]
    for i, instance in enumerate(instances):
        lines += target.stub(f"t{i}", instance)
    open(path("instances.s"), "w").write("\n".join(lines) + "\n")
    frame = [target.start, ".section .rodata", ".balign 8", ".globl judge_instances", "judge_instances:"]
    frame += [f".word t{i}" for i in range(len(instances))]
    frame += [".globl judge_count", f"judge_count: .word {len(instances)}", ".globl judge_states",
              f"judge_states: .word {states}", ".globl judge_headers", f'judge_headers: .incbin "{path("headers")}"',
              ".globl judge_pattern", f'judge_pattern: .incbin "{path("pattern")}"']
    open(path("start.s"), "w").write("\n".join(frame) + "\n")
    open(path("script.ld"), "w").write(f"""
ENTRY(entry)
MEMORY {{ {target.memory} DATA (rw) : ORIGIN = {target.data}, LENGTH = 1M }}
SECTIONS {{
  .text : {{ KEEP(*(.vectors)) *(.text*) *(.rodata*) *(.srodata*) . = ALIGN(16); }} > RAM
  .data : {{ *(.data*) *(.sdata*) . = ALIGN(16); }} > RAM
  .bss (NOLOAD) : {{ *(.sbss*) *(.bss*) *(COMMON) . = ALIGN(16); . += 65536; judge_stack = .; }} > DATA
  /DISCARD/ : {{ *(.ARM.exidx*) *(.ARM.extab*) *(.eh_frame*) *(.comment) }}
}}
""")
    compiler = [target.compiler] + target.flags
    run(compiler + ["-c", path("instances.s"), "-o", path("instances.o")])
    run(compiler + ["-O2", "-ffreestanding", "-fno-tree-loop-distribute-patterns", f'-DJUDGE_RESULTS="{path("qemu")}"',
                    os.path.join(HERE, "execute.c"), path("start.s"), path("instances.o"), "-nostdlib", "-T",
                    path("script.ld"), "-Wl,--no-warn-rwx-segments", "-Wl,--no-relax"] +
        (["--specs=picolibc.specs"] if target.table == "riscv" else []) + ["-lc", "-lgcc", "-o", path("instances.elf")])


def names_of(target, instances, directory):
    """The row of each instruction of each instance, as LLVM's disassembler names it."""
    tools = target.compiler.removesuffix("gcc")
    elf = os.path.join(directory, "instances.o")
    place = {}
    for line in run([tools + "nm", elf]).decode().splitlines():
        address, _, symbol = line.split()[-3:] if len(line.split()) == 3 else ("0", "", "")
        place[symbol] = int(address, 16)
    text = os.path.join(directory, "text")
    run([tools + "objcopy", "-O", "binary", "--only-section=.text", elf, text])
    code = open(text, "rb").read()
    lines = []
    # Returns are at the ends of functions, and of those that instances call.
    parts = [(0, place["t0"] & ~1), (place["t0_e"] & ~1, place["t1"] & ~1)]
    parts += [(place[f"t{i}_b"] & ~1, place[f"t{i}_e"] & ~1) for i in range(len(instances))]
    for begin, end in parts:
        lines.append(" ".join(f"0x{byte:02x}" for byte in code[begin:end]))
    listing = subprocess.run(target.disassembler, input="\n".join(lines).encode(), capture_output=True).stdout.decode()
    return [name.removeprefix("C_") for name in re.findall(r"<MCInst #\d+ (\w+)", listing)]


def is_nan(block, target, bits):
    at = 4 * target.order.index(target.arguments[0])
    number = int.from_bytes(block[at:at + bits // 8], "little")
    fraction = 23 if bits == 32 else 52
    exponent = (1 << (bits - 1 - fraction)) - 1
    return number >> fraction & exponent == exponent and number & ((1 << fraction) - 1) != 0


def judge(target, instances, states, directory, runner):
    """Messages of what differs, and what was refused by its name."""
    path = lambda name: os.path.join(directory, name)  # noqa: E731
    if os.path.exists(path("qemu")):
        os.remove(path("qemu"))
    run(target.emulator + ["-nodefaults", "-display", "none", "-semihosting-config", "enable=on,target=native", "-kernel",
                           path("instances.elf")], timeout=60)
    said = run([runner, path("instances.o"), target.processor, path("headers"), path("pattern"), str(len(instances)),
                str(states), path("lifted")]).decode()
    refusals = dict(line[1:].split(": ", 1) for line in said.splitlines())
    qemu, lifted = open(path("qemu"), "rb").read(), open(path("lifted"), "rb").read()
    given = open(path("headers"), "rb").read()
    if len(qemu) != len(instances) * states * BLOCK:
        return [f"the processor ended after {len(qemu) // BLOCK} of {len(instances) * states}: " +
                instances[min(len(qemu) // BLOCK // states, len(instances) - 1)].text], refusals
    wrong = []
    for i, instance in enumerate(instances):
        for k in range(states):
            n = i * states + k
            status, mine = lifted[n * (BLOCK + 1)], lifted[n * (BLOCK + 1) + 1:(n + 1) * (BLOCK + 1)]
            processor = qemu[n * BLOCK:(n + 1) * BLOCK]
            if status == 1:
                break
            if mine == processor and (status == 0 or instance.may_demand):
                continue
            # Which NaN it is no language says.
            if status == 0 and instance.is_float and all(is_nan(x, target, instance.is_float) for x in (mine, processor)):
                continue
            before = struct.unpack("<19I", given[n * HEADER:(n + 1) * HEADER])
            what = []
            for r, reg in enumerate(target.order):
                a, b = (int.from_bytes(x[4 * r:4 * r + 4], "little") for x in (mine, processor))
                if a != b:
                    what.append(f"{reg} {a:#x} instead of {b:#x}")
            if mine[FLAGS_OUT:FLAGS_OUT + 16] != processor[FLAGS_OUT:FLAGS_OUT + 16]:
                what.append("flags NZCV " + " instead of ".join(
                    "".join(str(x[FLAGS_OUT + 4 * f]) for f in range(4)) for x in (mine, processor)))
            if mine[SCRATCH:] != processor[SCRATCH:]:
                what.append("memory")
            if status == 2:
                what.append("it demands what is not so")
            registers = " ".join(f"{reg}={before[r]:#x}" for r, reg in enumerate(target.order))
            wrong.append(f"{instance.text}: {', '.join(what)}\n    with {registers}, {[hex(x) for x in before[16:]]}")
            break
    return wrong, refusals


def main():
    parser = argparse.ArgumentParser()
    for name in ("runner", "rows", "target", "directory"):
        parser.add_argument(name)
    parser.add_argument("--each", type=int, default=6)
    parser.add_argument("--states", type=int, default=4)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--rounds", type=int, default=1)
    settings = parser.parse_args()
    target = TARGETS[settings.target]
    for tool in (target.compiler, target.emulator[0], target.disassembler[0]):
        if shutil.which(tool) is None:
            print(f"not judged: there is no {tool}")
            return 77
    os.makedirs(settings.directory, exist_ok=True)
    return max(judge_once(target, settings, settings.seed + i) for i in range(settings.rounds))


def judge_once(target, settings, seed):
    rng = random.Random(seed)
    instances = []
    for line in open(os.path.join(HERE, target.table + ".txt")):
        if line.strip() and not line.startswith("#"):
            instances += [fill(line.strip(), target, rng) for _ in range(settings.each)]
    of_instructions = len(instances)
    libraries = [run([target.compiler] + target.flags + ["-print-file-name=" + name]).decode().strip()
                 for name in ("libgcc.a",)]
    libc = run([target.compiler] + target.flags + (["--specs=picolibc.specs"] if target.table == "riscv" else []) +
               ["-print-file-name=libc.a"]).decode().strip()
    if not os.path.isabs(libc):  # the specification of the library has its own folder
        libc = next(iter(subprocess.run(["find", "/usr/lib/picolibc", "-path", "*rv32imac/ilp32/libc.a"],
                                        capture_output=True, text=True).stdout.split()), libc)
    defined = set()
    for library in libraries + [libc]:
        listing = subprocess.run([target.compiler.removesuffix("gcc") + "nm", "--defined-only", library],
                                 capture_output=True, text=True).stdout
        defined |= {line.split()[2] for line in listing.splitlines() if len(line.split()) == 3}
    missing = []
    for row in rows(os.path.join(settings.rows, "library.def")):
        if row[1] in defined:
            instances += [library_instance(target, row, rng) for _ in range(settings.each)]
        else:
            missing.append(row[1])
    open(os.path.join(settings.directory, "headers"), "wb").write(headers(target, instances, settings.states, rng))
    open(os.path.join(settings.directory, "pattern"), "wb").write(
        bytes((i * 37 + 11) & 255 ^ i >> 3 for i in range(BLOCK - SCRATCH)))
    build(target, instances, settings.states, settings.directory)
    names = names_of(target, instances[:of_instructions], settings.directory)
    wrong, refusals = judge(target, instances, settings.states, settings.directory, settings.runner)
    accepted = accepted_rows(os.path.join(settings.rows, target.table + ".def"))
    for name in accepted:
        if name not in names:
            wrong.append(f"no instance of row {name}")
    refused = {}
    for number, why in refusals.items():
        refused.setdefault(why, []).append(instances[int(number)].text)
    for why, texts in refused.items():
        named = re.match(r"instruction '(?:C_)?(\w+)'", why)
        if named is None or named.group(1) in accepted:
            wrong.append(f"{why}: {texts[0]}")
        else:
            print(f"no row: {why}, {texts[0]}")
    if missing:
        print(f"not in {target.name}'s libraries: {' '.join(missing)}")
    for one in wrong:
        print(one)
    print(f"{settings.target}: {len(set(names) & set(accepted))} of {len(accepted)} rows, {of_instructions} instances; "
          f"{(len(instances) - of_instructions) // settings.each} functions of the library; "
          f"{settings.states} states each; {len(wrong)} faults")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
