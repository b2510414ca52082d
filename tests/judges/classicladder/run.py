#!/usr/bin/env python3
"""ClassicLadder's own engine against plcxx, scan by scan.

run.py PLCXX WORK [--programs N] [--seed N] [--scans N] [--period MS] [--jobs N] [--engine sim|host]   random ones
run.py PLCXX WORK --files FILE...                                                      projects that somebody else wrote

The engine is LinuxCNC's (package linuxcnc-uspace): streamer feeds a row of inputs into each period of a thread,
sampler keeps the outputs behind it. The engine counts the period that the thread has, not the clock, so that no slack is needed.
LinuxCNC refuses root: then it runs as the user of --user (nobody). Each run then has its own shared memory and
processes (unshare), so that runs do not meet; as another user one runs at a time.
"""
import argparse
import concurrent.futures
import grp
import os
import pathlib
import pwd
import random
import re
import shutil
import subprocess
import sys

import generate

SIZES = {"SIZE_NBR_RUNGS": "numRungs", "SIZE_NBR_BITS": "numBits", "SIZE_NBR_WORDS": "numWords",
         "SIZE_NBR_TIMERS": "numTimers", "SIZE_NBR_MONOSTABLES": "numMonostables", "SIZE_NBR_COUNTERS": "numCounters",
         "SIZE_NBR_TIMERS_IEC": "numTimersIec", "SIZE_NBR_PHYS_INPUTS": "numPhysInputs",
         "SIZE_NBR_PHYS_OUTPUTS": "numPhysOutputs", "SIZE_NBR_ARITHM_EXPR": "numArithmExpr",
         "SIZE_NBR_SECTIONS": "numSections", "SIZE_NBR_PHYS_WORDS_INPUTS": "numS32in",
         "SIZE_NBR_PHYS_WORDS_OUTPUTS": "numS32out"}
PINS = 20  # of a streamer or sampler


def sizes_of(text):
    """The parameters of loadrt that the project asks for; LinuxCNC takes no notice of them itself."""
    found = re.findall(r"^(SIZE_\w+)=(\d+)", text, re.MULTILINE)
    return {SIZES[line]: int(number) for line, number in found if line in SIZES}


def hal(project, sizes, period, scans, outputs, words):
    ins, word_ins = generate.INPUTS, generate.WORD_INPUTS
    parameters = " ".join(f"{name}={number}" for name, number in sizes.items())
    first, second = outputs, words
    lines = [f"loadrt classicladder_rt {parameters}",
             f"loadrt threads name1=cycle period1={period * 1000000}",
             f"loadrt streamer depth={scans + 2} cfg={'b' * ins + 's' * word_ins}",
             f"loadrt sampler depth={scans + 2},{scans + 2} cfg={'b' * len(first)},{'s' * len(second)}"]
    for i in range(min(ins, sizes.get("numPhysInputs", 15))):
        lines.append(f"net i{i} streamer.0.pin.{i} => classicladder.0.in-{i:02}")
    for i in range(min(word_ins, sizes.get("numS32in", 10))):
        lines.append(f"net iw{i} streamer.0.pin.{ins + i} => classicladder.0.s32in-{i:02}")
    for k, i in enumerate(first):
        lines.append(f"net q{i} classicladder.0.out-{i:02} => sampler.0.pin.{k}")
    for k, i in enumerate(second):
        lines.append(f"net qw{i} classicladder.0.s32out-{i:02} => sampler.1.pin.{k}")
    lines += [f"loadusr -w classicladder --nogui {project}", "loadusr -w halstreamer -c 0 in.txt"]
    lines += [f"addf {function} cycle" for function in ("streamer.0", "classicladder.0.refresh", "sampler.0", "sampler.1")]
    lines += ["start", f"loadusr -w halsampler -c 0 -n {scans} bits.txt", f"loadusr -w halsampler -c 1 -n {scans} words.txt"]
    return "\n".join(lines) + "\n"


def as_user(command, folder, user):
    if os.geteuid() != 0:
        return command
    subprocess.run(["chown", "-R", user, str(folder)], check=True)
    return ["unshare", "--ipc", "--pid", "--fork", "--kill-child", "--mount-proc", "setpriv", f"--reuid={user}", f"--regid={grp.getgrgid(pwd.getpwnam(user).pw_gid).gr_name}", "--init-groups", *command]


def judge(options, number, name, text):
    """None: they agree. Else what differs."""
    folder = options.work / f"{number}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "a.clp").write_text(text, encoding="latin-1")
    numbers = random.Random(f"{options.seed} {name}")
    rows = generate.inputs(numbers, options.scans, small=not options.files)
    (folder / "in.txt").write_text("".join(" ".join(map(str, row)) + "\n" for row in rows))
    sizes = sizes_of(text) | dict(options.size)
    outputs = list(range(min(sizes.get("numPhysOutputs", 15), PINS)))
    words = list(range(min(sizes.get("numS32out", 10), PINS)))
    (folder / "run.hal").write_text(hal("a.clp", sizes, options.period, options.scans, outputs, words))
    environment = {**os.environ, "HOME": str(folder), "TMPDIR": str(folder), "TMP": str(folder)}
    limit = 60 + options.scans * options.period / 1000 * 3
    engine = subprocess.run(as_user(["halrun", "-f", "run.hal"], folder, options.user), cwd=folder, env=environment,
                            capture_output=True, text=True, timeout=limit, errors="replace")
    read = lambda file: [line.split() for line in (folder / file).read_text().splitlines()] if (folder / file).exists() else []
    bits, numbers_out = read("bits.txt"), read("words.txt")
    if len(bits) < options.scans or len(numbers_out) < options.scans:
        return f"{name}: the engine gave {len(bits)} scans of {options.scans}\n{engine.stdout[-2000:]}{engine.stderr[-2000:]}"
    has = [i < sizes.get("numPhysInputs", 15) for i in range(generate.INPUTS)]
    has += [i < sizes.get("numS32in", 10) for i in range(generate.WORD_INPUTS)]
    rows = [[value for value, there in zip(row, has) if there] for row in rows]
    step = lambda names, values: "{" + ", ".join(f"{n}: {v}" for n, v in zip(names, values)) + "}"
    ins = [f"I{i}" for i in range(generate.INPUTS)] + [f"IW{i}" for i in range(generate.WORD_INPUTS)]
    ins = [name for name, there in zip(ins, has) if there]
    outs = [f"Q{i}" for i in outputs] + [f"QW{i}" for i in words]
    lines = ["dialect: classicladder", "sources: [a.clp]", f"options: {{{', '.join([f'period: {options.period}'] + [f'{n}: {v}' for n, v in options.size])}}}", "steps:"]
    before_in = None
    for row, bit_row, word_row in zip(rows, bits, numbers_out):
        if row != before_in:
            lines.append(f"- set: {step(ins, row)}")
        lines.append("- run: {slow: 1}")
        # In each scan, whether something changes in it or not: plcxx must not do what the engine does not.
        lines.append(f"- expect: {step(outs, bit_row + word_row)}")
        before_in = row
    (folder / "a.yaml").write_text("\n".join(lines) + "\n")
    tested = subprocess.run([options.plcxx, "test", "--engine", options.engine, "a.yaml"], cwd=folder, capture_output=True, text=True)
    if tested.returncode != 0:
        return f"{name}: in {folder}\n{tested.stdout[-3000:]}{tested.stderr[-3000:]}"
    if not options.keep:
        shutil.rmtree(folder)
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plcxx", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("work", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--programs", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--scans", type=int, default=400)
    parser.add_argument("--period", type=int, default=10)
    parser.add_argument("--jobs", type=int, default=8)
    parser.add_argument("--engine", default="sim")
    parser.add_argument("--user", default="nobody")
    parser.add_argument("--size", action="append", default=[], metavar="numTimers=20", help="parameter of loadrt, for all projects",
                        type=lambda text: (text.split("=")[0], int(text.split("=")[1])))
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--files", nargs="*", default=[])
    options = parser.parse_args()
    if os.geteuid() != 0:
        options.jobs = 1
    if options.files:
        programs = [(file, pathlib.Path(file).read_text(encoding="latin-1")) for file in options.files]
    else:
        programs = [(f"program {options.seed + i}", generate.Program(random.Random(options.seed + i)).text())
                    for i in range(options.programs)]
    differ = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        results = [pool.submit(judge, options, i, name, text) for i, (name, text) in enumerate(programs)]
        for result in concurrent.futures.as_completed(results):
            difference = result.result()
            if difference is not None:
                differ += 1
                print(difference, flush=True)
    print(f"{len(programs)} programs of {options.scans} scans, {differ} disagree")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
