#!/usr/bin/env python3
"""What `plcxx lsp` takes on a program of N statements of each language: diagnostics after a key, hover, memory.

    editor.py PLCXX [STATEMENTS] [--most-mb N]
        the median of ten keys, and of ten hovers; time of the process and on the clock; fails when one has taken more
        than so much memory

C is measured twice: after a key in a function, when only that one is read again, and after one outside of them, when
those are whose names may mean something else.
The time of the process is what the server works; on the clock the client's reading of thousands of messages comes in, and
whatever else the machine does. The targets are those of 10,000 statements: 100 ms, 20 ms, 200 MB.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "lsp"))
from client import Client  # noqa: E402

KEYS = 10


def statement_lines(dialect, statements):
    """Statements of the accumulator languages are instructions; the generators count rungs of about five of them."""
    return statements // 5 if dialect in ("prostep", "host50", "technol") else statements


def generate(dialect, statements, directory):
    count = str(statement_lines(dialect, statements))
    if dialect in ("nc110", "hnc"):
        command = [f"generate_{dialect}.py", count, directory]
    else:
        command = ["generate_accumulator.py", dialect, count, directory]
    subprocess.run([sys.executable, HERE / command[0], *command[1:]], check=True)
    return next(path for path in pathlib.Path(directory).iterdir() if path.suffix in (".plc", ".il", ".cld"))


def cpu_seconds(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def measured(client, action):
    cpu, clock = cpu_seconds(client.process.pid), time.monotonic()
    action()
    return 1000 * (cpu_seconds(client.process.pid) - cpu), 1000 * (time.monotonic() - clock)


def medians(rows):
    return "/".join(f"{statistics.median(column):.0f}" for column in zip(*rows))


def in_the_middle(lines):
    return next(number for number in range(len(lines) // 2, len(lines)) if len(lines[number].strip()) > 8)


def in_a_declaration(lines):
    return next(number for number, line in enumerate(lines) if line.startswith("INT table"))


def bench(plcxx, dialect, statements, line_of=in_the_middle):
    with tempfile.TemporaryDirectory(prefix="plcxx-test-") as directory:
        path = generate(dialect, statements, directory)
        text = path.read_text()
        options = {"programs": [{"sources": [str(path)], "dialect": dialect}]}
        client = Client(plcxx, options)
        client.open(path, text)
        found = client.wait_for(path, 1)
        lines = text.splitlines()
        middle = line_of(lines)
        keys, hovers = [], []
        for version in range(2, 2 + KEYS):
            change = {"range": {"start": {"line": middle, "character": len(lines[middle])},
                                "end": {"line": middle, "character": len(lines[middle])}}, "text": " "}

            def key():
                client.change(path, [change], version)
                client.wait_for(path, version)
            keys.append(measured(client, key))
        client.request("textDocument/hover", client.at(path, middle, 1))  # the index of names is made at the first question
        for number in range(KEYS):
            line = middle + number
            place = client.at(path, line, len(lines[line]) - 2 if lines[line].strip() else 0)
            hovers.append(measured(client, lambda: client.request("textDocument/hover", place)))
        status = pathlib.Path(f"/proc/{client.process.pid}/status").read_text()
        peak = next(int(line.split()[1]) for line in status.splitlines() if line.startswith("VmHWM"))
        print(f"{dialect:8} {len(lines):6} lines {len(found):6} messages   key {medians(keys):>9} ms   "
              f"hover {medians(hovers):>7} ms   peak {peak // 1024:4} MB", flush=True)
        client.shut_down()
        return peak // 1024


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("plcxx")
    arguments.add_argument("statements", type=int, nargs="?", default=10_000)
    arguments.add_argument("--most-mb", type=int)
    given = arguments.parse_args()
    print("median of the process / on the clock")
    peaks = {dialect: bench(given.plcxx, dialect, given.statements)
             for dialect in ("nc110", "prostep", "host50", "technol", "hnc")}
    peaks["hnc, outside of functions"] = bench(given.plcxx, "hnc", given.statements, in_a_declaration)
    large = {dialect: peak for dialect, peak in peaks.items() if given.most_mb and peak > given.most_mb}
    if large:
        sys.exit(f"more than {given.most_mb} MB: {large}")


if __name__ == "__main__":
    main()
