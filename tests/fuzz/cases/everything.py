#!/usr/bin/env python3
"""Every subcommand, in every form, over every golden program and sample: no crash, no exit 3, no hang.

    everything.py PLCXX ROOT [--share N] [--jobs N] [--sanitized]

With --share N one run in N, chosen by the bytes of the case and the command: the same ones everywhere.
"""
import argparse
import concurrent.futures
import hashlib
import pathlib
import re
import sys
import tempfile
import time

import commands
import corpus
import invoke


def chosen(case, share):
    """Of the commands of the case."""
    files = hashlib.sha256(repr(sorted(case.files.items())).encode()).digest()

    def is_chosen(words):
        digest = hashlib.sha256(files + repr(words).encode()).digest()
        return int.from_bytes(digest[:4], "big") % share == 0
    return [command for command in (*commands.of(case), *commands.dear(case)) if is_chosen(command[0])]


def properties(folder, case):
    """A property of the first location that the scenario sets, and the old version that `diff` compares with: the case
    without its last line that is a statement."""
    text = case.files[case.scenario.name].decode("utf-8", "replace")
    location = re.search(r"set: *\{ *('[^']*'|[^:,}]*):", text)
    (folder / "properties").write_text(f"never {location[1] if location else 'X'} and {location[1] if location else 'X'}\n")
    for name, data in case.files.items():
        lines = data.splitlines(keepends=True)
        path = folder / "old" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b"".join(lines[:-2] + lines[-1:]) if name == case.sources[-1] else data)


def attempt(plcxx, case, chosen_commands):
    found = []
    with tempfile.TemporaryDirectory(prefix="plcxx_every_") as scratch:
        folder = pathlib.Path(scratch)
        corpus.write(folder, case.files)
        properties(folder, case)
        for words, messages, seconds in chosen_commands:
            problem, _ = invoke.run([plcxx, *words], folder, 4 * seconds, messages)
            if problem:
                found.append((problem, words))
    return case, len(chosen_commands), found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("plcxx", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--share", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--dialects", default=",".join(corpus.DIALECTS))
    parser.add_argument("--sanitized", action="store_true", help="PLCXX is built with sanitizers")
    args = parser.parse_args()
    invoke.sanitized = args.sanitized
    ran = faults = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        futures = []
        for case in corpus.cases(args.root, args.dialects.split(",")):
            if picked := chosen(case, args.share):
                futures.append(pool.submit(attempt, args.plcxx, case, picked))
        said = time.monotonic()
        for number, future in enumerate(futures):
            case, count, found = future.result()
            ran += count
            if args.sanitized and time.monotonic() - said > 60:  # it takes an hour
                said = time.monotonic()
                print(f"{number} of {len(futures)} cases, {ran} runs", flush=True)
            for problem, words in found:
                faults += 1
                print(f"{case.scenario}: plcxx {' '.join(words)}\n    {problem}", flush=True)
    print(f"{ran} runs, {faults} faults")
    return 1 if faults or not ran else 0


if __name__ == "__main__":
    sys.exit(main())
