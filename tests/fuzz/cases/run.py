#!/usr/bin/env python3
"""Mutates whole cases (sources, scenario, options, names of files) and gives them to every subcommand.

    run.py PLCXX ROOT --seconds 60 [--seed N] [--jobs N] [--keep DIR]
    run.py PLCXX ROOT --cases 2000 ...

Also whole files (encodings, line ends, 100,000 brackets, endless lines) and options that nobody meant. No crash, no exit 3,
no hang, no memory above 1 GB, and no byte in a message that acts on a terminal. What breaks this
is kept in DIR: the files, and the command in `command`.
"""
import argparse
import concurrent.futures
import dataclasses
import math
import pathlib
import random
import resource
import shutil
import sys
import tempfile
import time

import commands
import corpus
import invoke
import mutate
import whole_files
import words

NAMES = ("пила", "锯", "a b", "-x", "--help", "x'y", 'x"y', "x\\y", "x\ny", "x\ty", "$(x)", "%s", "x" * 200, "\x1b[31m", "\u202ex",
         "con", "#x", "x:y", "x=y", "x,y", "{x}", "*", "?", "~", "&x", "é", "int", "main", "std", "1", ".x", "...")
OWN_MB = 512  # more than that is a fault of the fuzzer: a command begins as a copy of it
PROPERTIES = ("never {a} and {b}", "always {a} or not {a}", "{a} => {b} within 100ms", "never {a}\n# x\nalways {b}")


def mutated(rng, case, pool):
    files = dict(case.files)
    others = pool[case.dialect]
    for name in rng.sample(sorted(files), min(len(files), rng.choice((1, 1, 2)))):
        language = "yaml" if name.endswith((".yaml", ".yml")) else case.dialect
        if rng.random() < 0.25:
            files[name] = whole_files.change(rng, files[name], language)
        else:
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
    if rng.random() < 0.02:  # a directory where a file is meant
        name = rng.choice(sorted(files))
        files = {other: data for other, data in files.items() if other != name} | {name + "/x": b""}
    names = [data[begin:end].decode("utf-8", "replace").replace("\0", "")
             for data in case.files.values() for begin, end in [rng.choice(mutate.tokens(data))]]
    text = rng.choice(PROPERTIES).format(a=rng.choice(names), b=rng.choice(names)).encode()
    files["properties"] = mutate.several(rng, text, others) if rng.random() < 0.5 else text
    maps = f"{rng.choice(names)}={rng.choice(names)}"
    return dataclasses.replace(case, files=files, options=options, sources=sources, maps=maps), names


def attempt(number, args, cases, pool):
    rng = random.Random(f"{args.seed}-{number}")
    original = rng.choice(cases)
    case, names = mutated(rng, original, pool)
    case.files.update({f"old/{name}": data for name, data in original.files.items()})
    found = []
    with tempfile.TemporaryDirectory(prefix="plcxx_fuzz_") as scratch:
        folder = pathlib.Path(scratch)
        corpus.write(folder, case.files)
        chosen = rng.sample(list(commands.of(case)), 3)
        if rng.random() < args.dear:
            chosen.append(rng.choice(list(commands.dear(case))))
        for line, messages, seconds in chosen:
            if rng.random() < 0.15:
                line, messages = words.wrong(rng, args.table, line, names), messages and "-o" not in line
            line = [word.replace("\0", "") for word in line]
            problem, _ = invoke.run([args.plcxx, *line], folder, 2 * seconds, messages)
            if problem:
                found.append((problem, line))
                if args.keep:
                    kept = pathlib.Path(args.keep) / f"{args.seed}-{number}"
                    shutil.rmtree(kept, ignore_errors=True)
                    kept.mkdir(parents=True)
                    corpus.write(kept, case.files)
                    (kept / "command").write_text(f"{line}\n{problem}\n")
    return number, case, found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("plcxx", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--seconds", type=float, help="else 60, or as long as --cases take")
    parser.add_argument("--cases", type=int, help="so many: the same ones on every machine")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep")
    parser.add_argument("--dialects", default=",".join(corpus.DIALECTS))
    parser.add_argument("--dear", type=float, default=0.1, help="share of cases that call compilers or solvers")
    parser.add_argument("--sanitized", action="store_true", help="PLCXX is built with sanitizers")
    args = parser.parse_args()
    invoke.sanitized = args.sanitized
    names = ("check", "emit", "print", "report", "sim", "test", "why", "soak", "mutate", "diff", "prove", "verify", "build", "identify", "explain", "init")
    args.table = {"options": {name: words.options(args.plcxx, name) for name in names}, "keys": words.keys(args.plcxx)}
    cases = list(corpus.cases(args.root, args.dialects.split(",")))
    pool = {dialect: [data for case in cases if case.dialect == dialect for data in case.files.values()] or [b""]
            for dialect in corpus.DIALECTS}
    end = time.monotonic() + (args.seconds or (math.inf if args.cases else 60))
    last = args.first + args.cases if args.cases else math.inf
    done = faults = 0
    too_large = False
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool_of_threads:
        running = set()
        number = args.first
        while running or (time.monotonic() < end and number < last):
            while time.monotonic() < end and number < last and len(running) < args.jobs * 2:
                running.add(pool_of_threads.submit(attempt, number, args, cases, pool))
                number += 1
            ready, running = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
            for future in ready:
                tried, case, found = future.result()
                done += 1
                own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
                if own > OWN_MB and not too_large:
                    found.append((f"the fuzzer itself took {own} MB, here or in an attempt beside it", ["none"]))
                    too_large = True
                for problem, line in found:
                    faults += 1
                    print(f"attempt {tried} of seed {args.seed} ({case.scenario}): plcxx {' '.join(line)[:2000]!r}\n    {problem}",
                          flush=True)
    print(f"{done} cases of {len(cases)} mutated, {faults} faults; most memory {invoke.most['MB']} MB, most time of the "
          f"processor {invoke.most['seconds']:.1f} s")
    return 1 if faults or not done else 0


if __name__ == "__main__":
    sys.exit(main())
