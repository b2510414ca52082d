#!/usr/bin/env python3
"""Compilers take what is generated of long programs without a warning, in no more memory than its size explains.

    compiled.py PLCXX ROOT COMPILER... [--dialects NAMES] [--lines N]

So many lines of each picked kind (picked_kinds.py), and one expression of so many operations, are generated and compiled.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

import picked_kinds

MOST_MB = 400  # a short program takes them 30 to 90


def memory(command):
    """Megabytes, and what was told where it failed."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    told = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    process.stderr.close()
    return usage.ru_maxrss // 1024, told.decode("utf-8", "replace")[:1000] if process.returncode else ""


def faults_of(args, text, suffix, dialect):
    """None where the tool refuses the program."""
    with tempfile.TemporaryDirectory(prefix="plcxx_compiled_") as scratch:
        folder = pathlib.Path(scratch)
        (folder / f"p{suffix}").write_text(text, encoding="utf-8")
        made = subprocess.run([args.plcxx, "emit", f"p{suffix}", "--dialect", dialect, "-o", "out", "--quiet"], cwd=folder,
                              capture_output=True, check=False)
        if made.returncode:
            return None
        files = [str(path) for path in sorted(folder.glob("out/*.cpp"))]
        found = []
        for compiler in args.compilers:
            took, told = memory([compiler, "-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Werror",
                                 "-I", str(args.root / "runtime_support"), *files])
            if told or took > MOST_MB or not files:
                found.append(f"{compiler}: {took} MB {told}")
        return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("plcxx")
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("compilers", nargs="+")
    parser.add_argument("--dialects", default=",".join(picked_kinds.KINDS))
    parser.add_argument("--lines", type=int, default=2000)
    args = parser.parse_args()
    args.plcxx = str(pathlib.Path(args.plcxx).resolve())
    compiled = faults = 0
    for dialect in args.dialects.split(","):
        suffix, kinds = picked_kinds.KINDS[dialect]
        for name, program in kinds.items():
            found = faults_of(args, program(args.lines), suffix, dialect)
            if found is None and not name.startswith("wrong-"):
                found = ["refused"]
            compiled += found is not None
            for fault in found or []:
                faults += 1
                print(f"{dialect}.{name}, {args.lines} lines: {fault}", flush=True)
    print(f"{compiled} kinds generated, {faults} faults")
    return 1 if faults or not compiled else 0


if __name__ == "__main__":
    sys.exit(main())
