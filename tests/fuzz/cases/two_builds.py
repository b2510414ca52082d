#!/usr/bin/env python3
"""The tool as two compilers make it says the same bytes: IR, C++, messages and tables of every golden program and sample.

    two_builds.py PLCXX OTHER ROOT [--share N] [--jobs N]

C++ leaves open in which order the arguments of a call are evaluated, and GCC and Clang differ: where two of them add to the
program, values, places and names come in another order. With --share N one case in N.
"""
import argparse
import concurrent.futures
import hashlib
import pathlib
import subprocess
import sys
import tempfile

import commands
import corpus

FORMS = (["print", "ir"], ["print", "cpp"], ["check"], ["report", "--print-symbols"])


def said(plcxx, words, folder):
    run = subprocess.run([plcxx, *words], cwd=folder, capture_output=True, timeout=120, check=False)
    return run.returncode, run.stdout, run.stderr


def first_difference(one, other):
    for number, (line, changed) in enumerate(zip(one.splitlines(), other.splitlines()), 1):
        if line != changed:
            return f"line {number}: {line.decode('utf-8', 'replace')!r}, {changed.decode('utf-8', 'replace')!r}"
    return "one of the two is longer"


def compare(tools, case):
    found = []
    with tempfile.TemporaryDirectory(prefix="plcxx_two_") as scratch:
        folder = pathlib.Path(scratch)
        corpus.write(folder, case.files)
        for form in FORMS:
            words = [*form, *commands.program(case)]
            one, other = (said(tool, words, folder) for tool in tools)
            if one != other:
                found.append(f"plcxx {' '.join(words)}\n    {first_difference(one[1] + one[2], other[1] + other[2])}")
    return case, found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("plcxx", type=pathlib.Path)
    parser.add_argument("other", type=pathlib.Path)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--share", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--dialects", default=",".join(corpus.DIALECTS))
    args = parser.parse_args()
    tools = (args.plcxx.resolve(), args.other.resolve())

    def is_chosen(case):
        return int.from_bytes(hashlib.sha256(str(case.scenario.name).encode()).digest()[:4], "big") % args.share == 0
    cases = [case for case in corpus.cases(args.root, args.dialects.split(",")) if is_chosen(case)]
    faults = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for case, found in pool.map(lambda each: compare(tools, each), cases):
            for what in found:
                faults += 1
                print(f"{case.scenario}: {what}", flush=True)
    print(f"{len(cases)} programs, {faults} differences")
    return 1 if faults or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
