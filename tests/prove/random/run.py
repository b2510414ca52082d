#!/usr/bin/env python3
"""Random machines with random properties: what is proved holds in long random runs, what is violated can be replayed.

run.py PLCXX DIRECTORY [--machines N] [--seed S] [--dialects nc110,hnc] [--time 2s] [--properties N] [--periods N]

Exit code 0: nothing was proved wrongly, and each counterexample fails in `plcxx test`. The seeds are fixed, so a failure
comes again; its program and properties stay in DIRECTORY.
"""
import argparse
import collections
import concurrent.futures
import json
import pathlib
import random
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import generate  # noqa: E402

RUNS = 4  # of each machine, to look for what violates a proof
# Every other machine runs in slices, between which the scenarios change inputs.
SLICED = {"nc110": lambda slices: {"slices": slices},
          "host50": lambda slices: {"SLICES": "SLICED", "SLOWDIV": slices}}


def options_of(dialect, seed):
    return SLICED[dialect](2 + seed % 5) if dialect in SLICED and seed % 2 == 1 else {}


def tool(plcxx, directory, *arguments):
    return subprocess.run([plcxx, *arguments], cwd=directory, capture_output=True, text=True, timeout=900)


def check(plcxx, root, dialect, seed, options):
    """What is wrong with the verdicts of one machine, and their number by verdict."""
    machine = generate.MACHINES[dialect](f"{dialect} {seed}")
    directory = root / f"{dialect}{seed}"
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    source = f"m.{machine.suffix}"
    (directory / source).write_text(machine.text())
    wanted = generate.properties(machine, options.properties)
    (directory / "m.prop").write_text("\n".join(wanted) + "\n")
    machine_options = options_of(dialect, seed)
    settings = [word for key, value in machine_options.items() for word in ("--set", f"{key}={value}")]
    ran = tool(plcxx, directory, "prove", source, "--dialect", dialect, "--property", "m.prop", "--time", options.time,
               "--depth", "12", "--format", "json", "--counterexamples", "found", *settings)
    verdicts = collections.Counter()
    if ran.returncode not in (0, 1) or not ran.stdout.startswith("{"):
        return [f"{directory}: prove: {ran.stderr or ran.stdout}"], verdicts
    wrong, held = [], []
    for number, one in enumerate(json.loads(ran.stdout)["properties"], 1):
        verdicts[one["verdict"]] += 1
        stuck = "never stuck" in one["property"]
        if one["verdict"] == "proved" and not stuck:
            held.append(one["property"])
        if one["verdict"] == "not decided":
            verdicts[f"   {one.get('reason', '')}"] += 1
        if one["verdict"] != "violated":
            continue
        again = tool(plcxx, directory, "test", "--engine", "sim", f"found/property-{number}.yaml")
        shows = again.returncode == 0 if stuck else again.returncode == 1 and "does not hold" in again.stdout
        if not shows:
            wrong.append(f"{directory}: the counterexample of '{one['property']}' cannot be replayed: {again.stdout}")
    rng = random.Random(f"runs {dialect} {seed}")
    names = []
    for run in range(RUNS if held else 0):
        names.append(f"run{run}.yaml")
        (directory / names[-1]).write_text(generate.scenario(machine, source, held, rng, options.periods, machine_options))
    if names:
        ran = tool(plcxx, directory, "test", "--engine", "sim", *names)
        if ran.returncode != 0:
            wrong.append(f"{directory}: what was proved does not hold: {ran.stdout}{ran.stderr}")
    if not wrong:
        shutil.rmtree(directory)
    return wrong, verdicts


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("plcxx", type=pathlib.Path)
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--machines", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--dialects", default=",".join(generate.MACHINES))
    parser.add_argument("--time", default="2s")
    parser.add_argument("--properties", type=int, default=8)
    parser.add_argument("--periods", type=int, default=400)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    wrong, total = [], collections.defaultdict(collections.Counter)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        jobs = {}
        for dialect in options.dialects.split(","):
            for seed in range(options.seed, options.seed + options.machines):
                arguments = (options.plcxx.resolve(), options.directory.resolve(), dialect, seed, options)
                jobs[pool.submit(check, *arguments)] = dialect
        for job in concurrent.futures.as_completed(jobs):
            faults, verdicts = job.result()
            wrong += faults
            total[jobs[job]].update(verdicts)
            for fault in faults:
                print(fault, flush=True)
    for dialect, verdicts in sorted(total.items()):
        print(dialect, ", ".join(f"{count} {verdict}" for verdict, count in sorted(verdicts.items())))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
