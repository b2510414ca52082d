#!/usr/bin/env python3
"""Mutates whole cases (sources, scenario, options, names of files) and gives them to every subcommand.

    run.py PLCXX ROOT --seconds 60 [--seed N] [--jobs N] [--keep DIR]

No crash, no exit 3, no hang, no memory above 1 GB, and no byte in a message that acts on a terminal. What breaks this
is kept in DIR: the files, and the command in `command`.
"""
import argparse
import concurrent.futures
import dataclasses
import pathlib
import random
import shutil
import sys
import tempfile
import time

import commands
import corpus
import invoke
import mutate

NAMES = ("пила", "锯", "a b", "-x", "x'y", "x\ny", "$(x)", "x" * 200, "\x1b[31m", "\u202ex", "con")


def mutated(rng, case, pool):
    files = dict(case.files)
    others = pool[case.dialect]
    for name in rng.sample(sorted(files), min(len(files), rng.choice((1, 1, 2)))):
        files[name] = mutate.several(rng, files[name], others)
    options = list(case.options)
    if options and rng.random() < 0.3:
        at = rng.randrange(len(options))
        options[at] = mutate.one(rng, options[at].encode(), others).decode("utf-8", "replace").replace("\0", "")
    sources = list(case.sources)
    if rng.random() < 0.05:
        old = sources[0]
        sources[0] = rng.choice(NAMES) + pathlib.Path(old).suffix
        files[sources[0]] = files[old]
    return dataclasses.replace(case, files=files, options=options, sources=sources)


def write(folder, files):
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def attempt(number, args, cases, pool):
    rng = random.Random(f"{args.seed}-{number}")
    case = mutated(rng, rng.choice(cases), pool)
    found = []
    with tempfile.TemporaryDirectory(prefix="plcxx_fuzz_") as scratch:
        folder = pathlib.Path(scratch)
        write(folder, case.files)
        every = list(commands.of(case))
        for words, messages, seconds in rng.sample(every, 3):
            problem, _ = invoke.run([args.plcxx, *words], folder, 2 * seconds, messages)
            if problem:
                found.append((problem, words))
                if args.keep:
                    kept = pathlib.Path(args.keep) / f"{args.seed}-{number}"
                    shutil.rmtree(kept, ignore_errors=True)
                    kept.mkdir(parents=True)
                    write(kept, case.files)
                    (kept / "command").write_text(f"{words}\n{problem}\n")
    return number, case, found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("plcxx")
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep")
    parser.add_argument("--dialects", default=",".join(corpus.DIALECTS))
    args = parser.parse_args()
    cases = [case for case in corpus.cases(args.root) if case.dialect in args.dialects.split(",")]
    pool = {dialect: [data for case in cases if case.dialect == dialect for data in case.files.values()] or [b""]
            for dialect in corpus.DIALECTS}
    end = time.monotonic() + args.seconds
    done = faults = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool_of_threads:
        running = set()
        number = args.first
        while time.monotonic() < end or running:
            while time.monotonic() < end and len(running) < args.jobs * 2:
                running.add(pool_of_threads.submit(attempt, number, args, cases, pool))
                number += 1
            ready, running = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
            for future in ready:
                tried, case, found = future.result()
                done += 1
                for problem, words in found:
                    faults += 1
                    print(f"attempt {tried} of seed {args.seed} ({case.scenario}): plcxx {' '.join(words)}\n    {problem}",
                          flush=True)
    print(f"{done} cases of {len(cases)} mutated, {faults} faults")
    return 1 if faults or not done else 0


if __name__ == "__main__":
    sys.exit(main())
