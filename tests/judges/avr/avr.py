"""C through avr-gcc and libsimavr: the bytes that a program shows, in the order of showing."""
import pathlib
import subprocess

import children

HERE = pathlib.Path(__file__).resolve().parent
# The data memory is 64 KiB (runner.cc), of which crt and linker must know.
FLAGS = ["-std=gnu89", "-mmcu=atmega2560", "-fwrapv", "-fsigned-char", "-fsigned-bitfields", "-fno-strict-aliasing",
         "-fno-delete-null-pointer-checks", "-ffunction-sections", "-fno-jump-tables", "-w", "-I", str(HERE),
         "-Wl,--gc-sections", "-Wl,--defsym=__stack=0xffff", "-Wl,--defsym=__DATA_REGION_LENGTH__=0xf800"]

MOST_CYCLES = 4_000_000_000
SECONDS = 600  # for the compiler and for the simulator


class NotRun(Exception):
    """avr-gcc or the simulator did not take the program."""
    shown = None  # how many times it had shown something before the simulator ended it


def run(source, runner, compiler="avr-gcc", level="-Os", cycles=MOST_CYCLES):
    """Compiles the file and runs it, for so many cycles at most; the shown blocks of bytes."""
    binary = source.with_suffix(".elf")
    made = called([compiler, *FLAGS, level, source, "-o", binary])
    if made.returncode != 0:
        raise NotRun(f"{source}: {made.stderr[:3000]}")
    result = called([runner, binary, cycles])
    if result.returncode != 0:
        stopped = NotRun(f"{binary}: the simulated program ended with {result.returncode} {result.stderr[:500]}")
        stopped.shown = result.stdout.count("\n")
        raise stopped
    return [bytes.fromhex(line) for line in result.stdout.split()]


def called(words):
    try:
        return children.run(words, SECONDS)
    except subprocess.TimeoutExpired as late:
        raise NotRun(f"{words[0]}: {late}") from late
