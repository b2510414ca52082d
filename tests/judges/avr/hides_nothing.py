#!/usr/bin/env python3
"""Programs are judged many at a time: one that avr-gcc, the simulator, plcxx or the generator refuses, and one with a wrong
value, fails alone and by its name, wherever it is in its batch; the others are judged.

hides_nothing.py PLCXX RUNNER DIRECTORY
"""
import dataclasses
import pathlib
import shutil
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import random_programs  # noqa: E402
import shares  # noqa: E402
from generate import generate  # noqa: E402
from program import Observed  # noqa: E402

SEEDS = range(31, 40)


def with_text(program, plc="", avr=""):
    name, text = next(iter(program.files.items()))
    return dataclasses.replace(program, files={**program.files, name: text + plc}, avr=program.avr + avr)


def damaged(seed):
    program = generate(seed)
    if seed == 32:
        return with_text(program, avr="this is no C\n")
    if seed == 33:
        return with_text(program, plc="void never(void) { undeclared = 1; }\n")
    if seed == 34:
        head = f"static void plc1_p{seed}(void)\n{{\n"
        return dataclasses.replace(program, avr=program.avr.replace(head, head + "R.uc[767]++;\n"),
                                   observed=[*program.observed, Observed("R.uc[767]", [("R[767]", "unsigned char")])])
    if seed == 35:
        return dataclasses.replace(program, settings=["stop();"])  # nothing of it is shown, nor of those behind it
    if seed == 38:
        return dataclasses.replace(program, settings=["for (;;);"])
    if seed == 36:
        raise ValueError("no program")
    return program


def main():
    plcxx, runner, directory = (pathlib.Path(word) for word in sys.argv[1:])
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    random_programs.generate = damaged
    said = []
    no_shares = shares.Shares(plcxx, None, {name: 0 for name in shares.NAMES}, None)
    failed = random_programs.judge(plcxx, runner, directory, SEEDS, "sim", 1, False, said.append, no_shares)
    told = "\n".join(said)
    wanted = ("p32 (avr-gcc)", "p33.yaml", "p34.yaml", "p35 (avr-gcc)", "seed 36", "p38 (avr-gcc)")
    problems = [f"not told: {name}" for name in wanted if f"FAILED {directory / name if name[0] == 'p' else name}" not in told]
    problems += [f"told: p{seed}" for seed in (31, 37, 39) if f"p{seed}" in told]
    problems += [f"left: {file.name}" for file in directory.iterdir() if "31" in file.stem and file.stem != "elf31" or "37" in file.stem]
    problems += [f"not left: {name}" for name in ("p32.cld", "p33.cld", "p34.cld", "p34.yaml", "p34.c", "p35.cld") if not (directory / name).exists()]
    if failed != len(wanted) or problems:
        print(told, f"{failed} failed", *problems, sep="\n")
        sys.exit(1)


if __name__ == "__main__":
    main()
