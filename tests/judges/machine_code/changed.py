#!/usr/bin/env python3
"""Wrong machine code is not proved: one instruction of the compiler's assembler is changed at a time, and what
plcxx verify --object proves all the same is executed in QEMU beside the original, on random states.

changed.py PLCXX TARGET DIRECTORY [--share N] [--all-emulated]

--share takes each N-th change of a kind. A change that is proved and that a run shows to be different is a failure. One that
is proved and that no run shows is printed, as not judged: it may be code without an effect. --all-emulated runs also what
is not proved, and counts how many of those the runs show.
"""
import argparse
import collections
import os
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from changes import changes  # noqa: E402
from targets import HERE, TARGETS  # noqa: E402

FLAGS = ["-std=c++17", "-O2", "-ffreestanding", "-fno-exceptions", "-fno-rtti", "-fno-unwind-tables",
         "-fno-asynchronous-unwind-tables", "-fno-threadsafe-statics", "-fno-stack-protector", "-fno-jump-tables",
         "-fomit-frame-pointer", "-ffunction-sections", "-fdata-sections", "-ffp-contract=off",
         "-fno-reorder-blocks-and-partition", "-fno-ipa-icf", "-g0"]
STATES = 3000
ROUTINES = ("init", "fast", "slow", "period")


def run(command, **options):
    result = subprocess.run(command, capture_output=True, text=True, **options)
    if result.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{result.stdout[-2000:]}{result.stderr[-4000:]}")


class Bench:
    def __init__(self, plcxx, target, directory):
        self.plcxx, self.target, self.directory = plcxx, target, directory
        self.compiler = [target.compiler.removesuffix("gcc") + "g++"] + target.flags
        shutil.copy(os.path.join(HERE, "changed.plc"), self.path("turret.plc"))
        run([plcxx, "build", "turret.plc", "--target", target.name, "--quiet", "-o", "built"], cwd=directory)
        run(self.compiler + FLAGS + ["-I", self.path("built"), "-S", self.path("built/turret.cpp"), "-o", self.path("turret.s")])
        open(self.path("frame.s"), "w").write(target.start + target.keeps + target.interrupts)
        open(self.path("script.ld"), "w").write(f"""
ENTRY(entry)
MEMORY {{ {target.memory} DATA (rw) : ORIGIN = {target.data}, LENGTH = 1M }}
SECTIONS {{
  .text : {{ KEEP(*(.vectors)) *(.text*) *(.rodata*) *(.srodata*) . = ALIGN(16); }} > RAM
  .bss : {{ __global_pointer$ = . + 0x100; *(.sdata*) *(.sbss*) *(.data*) *(.bss*) *(COMMON)
           . = ALIGN(16); . += 65536; judge_stack = .; }} > DATA
  /DISCARD/ : {{ *(.ARM.exidx*) *(.ARM.extab*) *(.eh_frame*) *(.comment) }}
}}
""")
        run(self.compiler + FLAGS + ["-I", self.path("built"), f'-DJUDGE_RESULTS="{self.path("results")}"',
                                     f"-DJUDGE_STATES={STATES}", "-c", os.path.join(HERE, "states.cc"), "-o", self.path("states.o")])
        self.lines = open(self.path("turret.s")).read().split("\n")
        self.object = self.assemble(self.lines)
        self.expected = self.execute()

    def path(self, name):
        return os.path.join(self.directory, name)

    def assemble(self, lines):
        """The object's bytes; none: that is no instruction."""
        open(self.path("changed.s"), "w").write("\n".join(lines))
        result = subprocess.run(self.compiler + ["-c", self.path("changed.s"), "-o", self.path("changed.o")], capture_output=True)
        return open(self.path("changed.o"), "rb").read() if result.returncode == 0 else None

    def verdict(self, routine):
        said = subprocess.run([self.plcxx, "verify", "turret.plc", "--target", self.target.name, "--object", "changed.o",
                               "--routine", routine, "--time", "10s"], cwd=self.directory, capture_output=True, text=True)
        found = re.findall(r"^  (\w+): (proved|different|not decided)", said.stdout + said.stderr, re.M)
        if said.returncode == 0:
            return "proved"
        return next((result for name, result in found if name == routine and result != "proved"), "refused")

    def execute(self):
        if os.path.exists(self.path("results")):
            os.remove(self.path("results"))
        run(self.compiler + [self.path("states.o"), self.path("frame.s"), self.path("changed.o"), "-nostdlib", "-T",
                             self.path("script.ld"), "-Wl,--no-warn-rwx-segments", "-lgcc", "-o",
                             self.path("changed.elf")])
        try:
            # Its clock counts instructions: interrupts come between the same ones in each run.
            subprocess.run(self.target.emulator + ["-icount", "shift=3,sleep=off", "-nodefaults", "-display", "none", "-semihosting-config",
                                                   "enable=on,target=native", "-kernel", self.path("changed.elf")],
                           capture_output=True, timeout=20)
        except subprocess.TimeoutExpired:
            pass  # it does not come back: what it has written is less
        return open(self.path("results"), "rb").read() if os.path.exists(self.path("results")) else b""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("plcxx", "target", "directory"):
        parser.add_argument(name)
    parser.add_argument("--share", type=int, default=1)
    parser.add_argument("--all-emulated", action="store_true")
    settings = parser.parse_args()
    target = TARGETS[settings.target]
    for tool in (target.compiler, target.emulator[0]):
        if shutil.which(tool) is None:
            print(f"not judged: there is no {tool}")
            return 77
    os.makedirs(settings.directory, exist_ok=True)
    bench = Bench(os.path.abspath(settings.plcxx), target, os.path.abspath(settings.directory))
    if len(bench.expected) != STATES * len(ROUTINES) * 12 or any(bench.expected[8 + 12 * i:12 + 12 * i] != bytes(4) for i in
                                                                 range(STATES * len(ROUTINES))):
        print("the original does not run, or does not keep what callers rely on")
        return 1
    for routine in ROUTINES:
        if bench.verdict(routine) != "proved":
            print(f"the original is not proved: {routine}")
            return 1
    counts, seen, wrong, quiet, shown, skipped = collections.Counter(), collections.Counter(), [], [], 0, 0
    routine = None
    routine_at = []
    for line in bench.lines:
        found = re.match(r"_ZN6turret\d+(\w+?)ERNS_5State\w*:", line)
        routine = found.group(1) if found else routine
        routine_at.append(routine)
    for what, at, instead, count in changes(bench.lines, target.has_flags):
        if routine_at[at] not in ROUTINES:
            continue
        seen[what] += 1
        if (seen[what] + len(what)) % settings.share != 0 and not (seen[what] == 1 and settings.share > 1):
            continue
        code = bench.assemble(bench.lines[:at] + instead + bench.lines[at + count:])
        if code is None or code == bench.object:
            skipped += 1
            continue
        verdict = bench.verdict(routine_at[at])
        counts[verdict] += 1
        if verdict != "proved" and not settings.all_emulated:
            continue
        differs = bench.execute() != bench.expected
        shown += differs and verdict != "proved"
        text = f"{what}, {routine_at[at]}, line {at + 1}: {bench.lines[at].strip()} -> {' '.join(x.strip() for x in instead)}"
        text = text.replace("\t", " ")
        if verdict == "proved" and differs:
            wrong.append("proved, and a run differs: " + text)
        elif verdict == "proved":
            quiet.append("proved, and no run differs: " + text)
    for one in quiet + wrong:
        print(one)
    print(f"{target.name}: {sum(counts.values())} changes of {len(seen)} kinds: {counts['different']} different, "
          f"{counts['not decided']} not decided, {counts['refused']} refused, {counts['proved']} proved"
          + (f"; of those not proved {shown} differ in {STATES} states" if settings.all_emulated else "")
          + f"; {skipped} are no other code; {len(wrong)} faults")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
