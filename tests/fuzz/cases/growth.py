#!/usr/bin/env python3
"""Nothing grows with the square of a program: so many lines of every kind of statement, and ten times as many.

    growth.py PLCXX ROOT [--dialects NAMES] [--commands NAMES] [--only KIND] [--picked] [--share N] [--few N] [--most EXPONENT]

The kinds are those of the languages' tables and grammars (kinds.py), the golden programs with errors and the wrong lines of
these (with `check`), and picked ones (picked_kinds.py). The time is that of the processor, without the start of the tool. Other work only adds to it:
what seems to grow too much is measured again, and the least counts.
"""
import argparse
import concurrent.futures
import hashlib
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import commands
import corpus
import kinds
import picked_kinds

TIMES = 10
NOISE_SECONDS = 0.02  # what a run of the small program may be off by
MOST_SECONDS = 120
MOST_BYTES = 1 << 30
COMMANDS = {
    "check": lambda words: ["check", *words],
    "emit": lambda words: ["emit", *words, "-o", "out", "--quiet"],
    "sim": lambda words: ["sim", *words, "--for", "100ms", "--time-limit", "60"],
    "report": lambda words: ["report", *words, "-o", "out", "--quiet"],
    "cross-reference": lambda words: ["report", *words, "--cross-reference"],
    "tokens": lambda words: ["print", "tokens", *words],
    "syntax": lambda words: ["print", "syntax", *words],
    "ir": lambda words: ["print", "ir", *words],
    "cpp": lambda words: ["print", "cpp", *words],
    "diff": lambda words: ["diff", words[0], *words, "--time", "60s"],
    "verify": lambda words: ["verify", *words, "--time", "60s", "--jobs", "1"],
    "json": lambda words: ["check", *words, "--diagnostics", "json", "--max-messages", "0"],
}
ANSWERS = (0, 1, 2)
OPEN = ("diff", "verify")  # these answer 1 where something is not decided, 2 for a program that is refused


def seconds(plcxx, words, folder, tries, answers=ANSWERS):
    """The least of the tries; infinite when it ends otherwise than it may."""
    best = math.inf
    for _ in range(tries):
        begin = time.monotonic()
        process = subprocess.Popen([plcxx, *words], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while True:
            done, status, usage = os.wait4(process.pid, os.WNOHANG)
            if done:
                break
            if time.monotonic() - begin > 10 * MOST_SECONDS:
                process.kill()
            time.sleep(0.001)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode not in answers or usage.ru_maxrss * 1024 > 3 * MOST_BYTES:
            return math.inf
        best = min(best, usage.ru_utime + usage.ru_stime)
    return best


def exponent(few, many):
    return math.log(many / (few + NOISE_SECONDS), TIMES) if max(few, many) < math.inf else math.inf


def measure(args, start, folder, path, program, words, answers):
    """Seconds of the small and the large program."""
    times = [math.inf, math.inf]
    for tries in (1, 2, 3):
        for place, count in enumerate((args.few, TIMES * args.few)):
            path.write_bytes(program(count))
            times[place] = min(times[place], max(seconds(args.plcxx, words, folder, tries, answers) - start, 0.001))
        if exponent(*times) <= args.most:
            break
    return times


def jobs(args):
    """(name, command, files beside the program, name of the program, program of n lines, words of the command, exit codes)"""
    for dialect in args.dialects.split(","):
        suffix, picked = picked_kinds.KINDS[dialect]
        shown, _ = ([], None) if args.picked else kinds.kinds(args.root, dialect)
        for command in args.commands.split(","):
            for name, program in picked.items():
                answers = ANSWERS[:1 + name.startswith("wrong-") + (command in OPEN)]
                yield (f"{dialect}.{name}", command, {}, f"p{suffix}", lambda n, program=program: program(n).encode(),
                       [f"p{suffix}", "--dialect", dialect], answers)
            of_errors = kinds.errors(args.root, dialect) if command in ("check", "json") and not args.picked else []
            for kind in shown + of_errors:
                name = f"{dialect}.{kind.case.scenario.parent.name}/{kind.case.scenario.stem}"
                yield (name, command, kind.case.files, kind.source, lambda n, kind=kind: kinds.copies(kind, n).encode(),
                       commands.program(kind.case), ANSWERS)
            if command == "check" and not args.picked:
                for case, file, wrong in kinds.wrong_lines(args.root, dialect):
                    name = f"{dialect}.{case.scenario.parent.name}/{case.scenario.stem}-line"
                    yield name, command, case.files, file, wrong, commands.program(case), ANSWERS


def chosen(name, command, share):
    return int.from_bytes(hashlib.sha256(f"{name} {command}".encode()).digest()[:4], "big") % share == 0


def attempt(args, start, job):
    name, command, files, source, program, words, answers = job
    with tempfile.TemporaryDirectory(prefix="plcxx_growth_") as scratch:
        folder = pathlib.Path(scratch)
        corpus.write(folder, files)
        return name, command, measure(args, start, folder, folder / source, program, COMMANDS[command](words), answers)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("plcxx")
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--dialects", default=",".join(picked_kinds.KINDS))
    parser.add_argument("--commands", default=",".join(COMMANDS))
    parser.add_argument("--only", default="", help="kinds whose names have this")
    parser.add_argument("--picked", action="store_true", help="the picked kinds alone, not those of tables and grammars")
    parser.add_argument("--share", type=int, default=1, help="one kind in N of each command")
    parser.add_argument("--few", type=int, default=4000)
    parser.add_argument("--most", type=float, default=1.1)
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    args.plcxx = str(pathlib.Path(args.plcxx).resolve())
    start = seconds(args.plcxx, ["--version"], ".", 5)
    measured, faults, worst = 0, 0, {}
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        todo = [job for job in jobs(args) if args.only in job[0] and chosen(job[0], job[1], args.share)]
        for name, command, (few, many) in pool.map(lambda job: attempt(args, start, job), todo):
            value = exponent(few, many)
            measured += 1
            faults += value > args.most
            worst[command] = max(worst.get(command, (-math.inf, "")), (value, name))
            if value > args.most or args.share == 1:
                print(f"{name} {command}: {few:.3f} s, {many:.3f} s, exponent {value:.2f}{'  TOO MUCH' if value > args.most else ''}",
                      flush=True)
    for command, (value, name) in worst.items():
        print(f"{command}: at most {value:.2f} ({name})")
    print(f"{measured} kinds measured, {faults} grow too much")
    return 1 if faults or not measured else 0


if __name__ == "__main__":
    sys.exit(main())
