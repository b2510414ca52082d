#!/usr/bin/env python3
"""Of each C function in tests/golden/hnc and samples/hnc: whether plcxx verify proves it equal to Clang's own compilation.

front_end.py PLCXX [--time 10s] [--only TEXT] [--every N] [--jobs N] [--list] [--check]

Prints how many functions are proved, not decided and not compared, the latter two by reason, as docs/verify.md has it.
Programs with the same sources and options count once. --list names each function that is not proved, with its program.
--check makes the exit code 1 where a function is different, a program cannot be compared, or nothing was looked at.
"""
import argparse
import collections
import concurrent.futures
import pathlib
import re
import sys

from run import GOLDEN, program_of, run

SAMPLE = GOLDEN.parent.parent / "samples" / "hnc" / "mill_xk7132"
LINE = re.compile(r"^  (.+), front end: (proved|not decided|different|not compared)(?:[^:\n]*: )?(.*)$", re.MULTILINE)
WHOLE = re.compile(r"^  front end: not compared: (.*)$", re.MULTILINE)


def reason_of(text):
    """Without what is a program's own: names and numbers."""
    text = re.sub(r"\(plcxx::[^)]*\)|\([a-z_0-9]+, [^)]*\)", "", text)
    text = re.sub(r"^a call of \w+, ", "a call of a function with ", text)
    text = re.sub(r"\bloop \d+ ", "a loop ", text)
    text = re.sub(r"(not within the time|not constant|no loop|is not found|goes round|behind its loops): .*", r"\1", text)
    text = re.sub(r"^(all is proved but) .*", r"\1 what it calls", text)
    return re.sub(r"\s+", " ", text).strip()


def compare(plcxx, words, folder, seconds):
    ran = run([plcxx, "verify", "--front-end=only", "--name", "program", "--time", seconds, "--jobs", "1", *words], folder, 600)
    if ran is None:
        return [("", "not decided", "no end within 10 min")]
    said = ran.stdout + ran.stderr
    whole = WHOLE.search(said)
    if whole:
        return [("", "not compared", whole.group(1))]
    found = LINE.findall(said)
    return found or [("", "refused", said.strip()[-300:])]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plcxx")
    parser.add_argument("--time", default="10s")
    parser.add_argument("--only", default="")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    plcxx = str(pathlib.Path(options.plcxx).resolve())
    programs = {}  # by folder and words
    for scenario in sorted((GOLDEN / "hnc").rglob("*.yaml")):
        words = program_of(scenario)
        if words is not None:
            programs.setdefault((scenario.parent, tuple(words)), scenario.relative_to(GOLDEN).with_suffix(""))
    programs[SAMPLE, ("mill.cld",)] = "samples/hnc/mill_xk7132"
    chosen = [(key, name) for key, name in programs.items() if options.only in str(name)][:: options.every]
    counts, reasons = collections.Counter(), collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        compared = pool.map(lambda one: compare(plcxx, one[0][1], one[0][0], options.time), chosen)
        for (_, name), functions in zip(chosen, compared):
            for function, result, rest in functions:
                counts[result] += 1
                reason = reason_of(rest) if result not in ("proved", "different") else ""
                reasons[result, reason] += 1
                if options.list and result != "proved":
                    print(f"{name}: {function}: {result}: {rest}", flush=True)
    print(f"{len(chosen)} programs, {sum(counts.values())} functions\n\n| result | reason | functions |\n|---|---|---|")
    for (result, reason), count in sorted(reasons.items(), key=lambda one: (one[0][0] != "proved", -one[1])):
        print(f"| {result} | {reason} | {count} |")
    return 1 if options.check and (counts["different"] or counts["refused"] or not counts["proved"]) else 0


if __name__ == "__main__":
    sys.exit(main())
