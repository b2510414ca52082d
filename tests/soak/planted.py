#!/usr/bin/env python3
"""plcxx soak finds faults that were planted in copies of the samples (planted.txt), each with a fixed seed.

planted.py PLCXX ROOT [--few] [--length TIME] [--engine ENGINE] [NAME...]

--few: those that are found soon
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

# What is found in the first minutes of machine time; the rest needs hours, and is looked for by dev/test --all.
SOON = {"nc110-chuck-opens-and-clamps", "host50-conveyor-both-ways", "host50-chuck-opens-and-clamps",
        "technol-coolant-without-level", "prostep-wrong-lamp", "hnc-table-too-short", "classicladder-turret-never-turns"}


def read(path):
    faults = []
    for line in path.read_text(encoding="utf-8").splitlines():
        word, _, rest = line.partition(" ")
        if word == "fault":
            name, sample = rest.split()
            faults.append({"name": name, "sample": sample, "find": "", "edits": []})
        elif word == "find":
            faults[-1]["find"] = rest
        elif word == "in":
            faults[-1]["edits"].append((rest, [], []))
        elif word == "-":
            faults[-1]["edits"][-1][1].append(rest)
        elif word == "+":
            faults[-1]["edits"][-1][2].append("" if rest == "_" else rest)
    return faults


def plant(fault, folder):
    for name, old, new in fault["edits"]:
        path = folder / name
        data = path.read_bytes()
        end = b"\r\n" if b"\r\n" in data else b"\n"
        # The rest of the last line, a comment perhaps, stays.
        before = end.join(line.encode() for line in old)
        after = end.join(line.encode() for line in new)
        if data.count(before) != 1:
            raise SystemExit(f"{fault['name']}: {name} has {data.count(before)} times {old}")
        path.write_bytes(data.replace(before, after))


def main():
    arguments = sys.argv[1:]
    few = "--few" in arguments
    length, engine = "20min", "sim"
    if "--length" in arguments:
        at = arguments.index("--length")
        length = arguments[at + 1]
        del arguments[at:at + 2]
    if "--engine" in arguments:
        at = arguments.index("--engine")
        engine = arguments[at + 1]
        del arguments[at:at + 2]
    arguments = [word for word in arguments if word != "--few"]
    plcxx, root, *names = arguments
    root = pathlib.Path(root)
    faults = read(root / "tests/soak/planted.txt")
    unknown = SOON - {fault["name"] for fault in faults}
    if unknown:
        raise SystemExit(f"no such faults: {unknown}")
    missed = 0
    for fault in faults:
        if names and fault["name"] not in names:
            continue
        if few and fault["name"] not in SOON:
            continue
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place) / "machine"
            shutil.copytree(root / "samples" / fault["sample"], folder, ignore=shutil.ignore_patterns("generated"))
            plant(fault, folder)
            begin = time.monotonic()
            ran = subprocess.run([plcxx, "soak", str(folder), "--engine", engine, "--for", length, "--time", "60s", "--until", fault["find"]],
                                 capture_output=True, text=True, timeout=600)
            took = time.monotonic() - begin
            found = fault["find"] in ran.stdout
            missed += not found
            hours = re.search(r"[\d.,]+ machine-\w+", ran.stdout)
            print(f"{'found' if found else 'MISSED'} {fault['name']}: {took:.1f} s, {hours and hours[0]}", flush=True)
            if not found:
                print(ran.stdout[:3000] + ran.stderr[:2000])
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
