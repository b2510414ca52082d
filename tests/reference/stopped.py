#!/usr/bin/env python3
"""A soak that is stopped ends at once, with its table and without children.

    stopped.py SOAK AVR_JUDGE PLCXX_AVR_RUNNER     the last two may be empty: not built

Each gets a judge that would take an hour, and SIGTERM in the middle.
"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

MOST_SECONDS = 300  # until the judge is called
SOON_SECONDS = 20


def lives(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def stopped(name, words, folder, expected):
    """What is wrong with how it ends. The judge writes its number, starts a child, and waits."""
    numbers = folder / "numbers"
    with subprocess.Popen([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=folder,
                          env={**os.environ, "TMPDIR": str(folder / "temporary")}) as process:
        end = time.monotonic() + MOST_SECONDS
        while not numbers.exists() and process.poll() is None and time.monotonic() < end:
            time.sleep(0.05)
        time.sleep(0.3)
        process.send_signal(signal.SIGTERM)
        begin = time.monotonic()
        try:
            output, _ = process.communicate(timeout=SOON_SECONDS)
        except subprocess.TimeoutExpired:
            process.kill()
            output, _ = process.communicate()
            return [f"{name}: goes on {time.monotonic() - begin:.0f} s after SIGTERM: {output}"]
    time.sleep(0.3)
    found = [f"{name}: no '{text}' in: {output}" for text in expected if text not in output]
    left = [pid for pid in numbers.read_text().split() if lives(pid)] if numbers.exists() else ["of no judge that was called"]
    for pid in left:
        found.append(f"{name}: its child lives: {pid}")
        if pid.isdigit():
            os.kill(int(pid), signal.SIGKILL)
    rest = sorted(path.name for path in (folder / "temporary").iterdir())
    if rest:
        found.append(f"{name}: left in its temporary directory: {rest}")
    return found


def main():
    soak, avr_judge, runner = (pathlib.Path(word).resolve() if word else None for word in sys.argv[1:4])
    found = []
    with tempfile.TemporaryDirectory(prefix="plcxx_stopped_") as scratch:
        for name in ("soak", "avr"):
            folder = pathlib.Path(scratch) / name
            (folder / "temporary").mkdir(parents=True)
            judge = folder / "judge"
            judge.write_text("#!/bin/sh\nsleep 3600 &\necho $$ $! > numbers.new\nmv numbers.new " + str(folder / "numbers") + "\nwait\n")
            judge.chmod(0o700)
            if name == "soak":
                words = [soak, "--dialect", "nc110", "--dialect", "prostep", "--hours", "1", "--jobs", "1", "--compiled-every", "0", "--verified-every",
                         "1", "--plcxx", judge]
                found += stopped(name, words, folder, ("stopped before its end", "disagreements", "nc110  ", "verify: 0 functions"))
            elif avr_judge:
                words = [sys.executable, avr_judge, judge, runner, folder / "programs", "--programs", "1000", "--soak", soak]
                found += stopped(name, words, folder, ("stopped before its end", "0 programs failed", "hnc  "))
    print("\n".join(found) or "both end at once")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
