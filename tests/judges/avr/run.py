#!/usr/bin/env python3
"""C programs through plcxx and through avr-gcc with libsimavr: every value must be the same.

run.py PLCXX RUNNER DIRECTORY [--loops THIN] [--written] [--programs N] [--hours H] [--csmith N]
       [--seed S] [--engine sim,host]

--loops runs each THIN-th loop of the matrix (1: all), --written the programs in written/, --programs so many random programs,
--hours programs for so long, --csmith so many programs of Csmith, which must be installed.
What failed stays in DIRECTORY. With --soak (the executable of tests/reference) a part of the programs is also run as
generated C++ by GCC and Clang, on emulated machines, and proved by plcxx verify; --compiled-every 50 is two of 100
programs, in batches. The row at the end is one of dev/soak's table; SIGTERM or Ctrl-C prints it for what was judged.
"""
import argparse
import pathlib
import shutil
import signal
import sys
import time

sys.dont_write_bytecode = True  # the source tree stays clean
import csmith_programs  # noqa: E402
import matrix  # noqa: E402
import random_programs  # noqa: E402
import shares  # noqa: E402
import written  # noqa: E402


def report(text):
    print(text, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plcxx", type=pathlib.Path)
    parser.add_argument("runner", type=pathlib.Path)
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--loops", type=int, default=0)
    parser.add_argument("--written", action="store_true")
    parser.add_argument("--programs", type=int, default=0)
    parser.add_argument("--hours", type=float, default=0)
    parser.add_argument("--csmith", type=int, default=0)
    parser.add_argument("--soak", type=pathlib.Path)
    for share in shares.NAMES:
        parser.add_argument(f"--{share}-every", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--engine", default="sim")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", action="store_true")
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as Ctrl-C
    shutil.rmtree(arguments.directory, ignore_errors=True)
    arguments.directory.mkdir(parents=True)
    findings = 0
    if arguments.loops:
        findings += matrix.judge(arguments.plcxx, arguments.runner, arguments.directory, arguments.loops, arguments.engine,
                                 arguments.jobs, report)
    if arguments.written:
        findings += written.judge(arguments.plcxx, arguments.runner, arguments.directory, arguments.engine, arguments.jobs, report)
    if arguments.csmith:
        findings += csmith_programs.judge(arguments.plcxx, arguments.runner, arguments.directory.resolve(),
                                          range(arguments.seed, arguments.seed + arguments.csmith), arguments.engine, arguments.jobs,
                                          arguments.keep, report)
    if arguments.programs or arguments.hours:
        # Without end where only a time is given.
        seeds = range(arguments.seed, arguments.seed + (arguments.programs or 1 << 40))
        deadline = time.monotonic() + 3600 * arguments.hours if arguments.hours else None
        further = shares.Shares(arguments.plcxx, arguments.soak.resolve() if arguments.soak else None,
                                {name: getattr(arguments, f"{name}_every") for name in shares.NAMES}, deadline)
        findings += random_programs.judge(arguments.plcxx, arguments.runner, arguments.directory, seeds, arguments.engine,
                                          arguments.jobs, arguments.keep, report, further)
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main()
