#!/usr/bin/env python3
"""A report of a sanitizer is a fault of everything.py and of run.py, which runs without one are not.

    reported.py COMPILER ROOT

In place of plcxx they get a program (reported.cc) that does what the address sanitizer, the one of undefined behaviour and
that of leaks must each report.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
FLAGS = ("-std=c++20", "-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
JUDGES = {"everything.py": ("--share", "3000"), "run.py": ("--seconds", "0.1", "--dear", "0")}


def main():
    compiler, root = sys.argv[1:]
    wrong = 0
    with tempfile.TemporaryDirectory(prefix="plcxx_reported_") as scratch:
        program = pathlib.Path(scratch) / "reported"
        subprocess.run([compiler, *FLAGS, str(HERE / "reported.cc"), "-o", str(program)], check=True)
        for judge, words in JUDGES.items():
            for fault in ("none", "address", "undefined", "leak"):
                result = subprocess.run([sys.executable, str(HERE / judge), str(program), root, "--dialects", "prostep", *words,
                                         "--sanitized"], capture_output=True, text=True, check=False,
                                        env={**os.environ, "PLCXX_FAULT": fault})
                is_seen = result.returncode == 1 and "sanitizer: " in result.stdout
                is_clean = result.returncode == 0 and " 0 faults" in result.stdout
                if not (is_clean if fault == "none" else is_seen):
                    wrong += 1
                    print(f"{judge}, fault '{fault}': exit {result.returncode}\n{result.stdout}{result.stderr}")
    print(f"reports of {len(JUDGES)} judges, {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
