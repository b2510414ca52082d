#!/usr/bin/env python3
"""The world around the tool is wrong: what is written is there whole, or not at all, and the exit code says so.

    world.py PLCXX

Full disks (a limit of the size of files), places that cannot be written, directories where files are meant, closed and full
standard output, several runs into one directory, signals in the middle, names of files that hold everything a name can.
"""
import argparse
import concurrent.futures
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SOURCE = "$\n" + "".join(f"U{i % 16}K{10 + i // 16 % 16}=I{i % 16}A{i % 4}*I1A1\n" for i in range(3000))
SCENARIO = "dialect: nc110\nsources: [p.plc]\nsteps:\n- run: {ms: 100}\n- expect: {U4A0: 0}\n"
WRITERS = (
    (["emit", "p.plc", "-o", "out"], "out"),
    (["emit", "p.plc", "-o", "out", "--single-file", "--depfile", "out/d"], "out"),
    (["report", "p.plc", "-o", "out"], "out"),
    (["sim", "p.plc", "--for", "100ms", "--watch", "U4A0", "--vcd", "out/t.vcd"], "out"),
    (["test", "p.yaml", "--engine", "sim", "--junit", "out/r.xml"], "out"),
)
NAMES = ("a b.plc", "x'y.plc", 'x"y.plc', "x\\y.plc", "x\ny.plc", "-x.plc", "--help.plc", "x\x1b[31m.plc", "пила.plc", "锯.plc", "$(x).plc", "%s.plc",
         "x#y.plc", "x:y.plc", "*.plc", "x" * 240 + ".plc", "\udcff.plc", "\u202ex.plc", "int.plc", "1.plc", ".plc", "...plc")

faults = []


def check(right, *what):
    if not right:
        faults.append(" ".join(str(each) for each in what))


class Place:
    """A folder with a program, and how the tool runs in it."""

    def __init__(self, plcxx, folder):
        self.plcxx, self.folder = plcxx, pathlib.Path(folder)
        (self.folder / "p.plc").write_text(SOURCE)
        (self.folder / "p.yaml").write_text(SCENARIO)
        (self.folder / "out").mkdir()

    def run(self, words, **extra):
        return subprocess.run([self.plcxx, *words], cwd=self.folder, capture_output=True, timeout=300, **extra)

    def files(self, name="out"):
        root = self.folder / name
        return {str(path.relative_to(root)): path.read_bytes() for path in root.rglob("*") if path.is_file()}


def small_disk():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))


def full_disk(place):
    for words, _ in WRITERS:
        shutil.rmtree(place.folder / "out")
        (place.folder / "out").mkdir()
        run = place.run(words, preexec_fn=small_disk)
        if run.returncode == 0:
            continue  # what it writes is small
        check(run.returncode == 2, "full disk: exit", run.returncode, words, run.stderr)
        check(b"too large" in run.stderr, "full disk: no cause", words, run.stderr)
        check(not place.files(), "full disk: left", list(place.files()), words)


def keeps_the_old(place):
    """What was there stays as it was when the new one cannot be written."""
    place.run(WRITERS[0][0])
    before = place.files()
    (place.folder / "p.plc").write_text(SOURCE.replace("I1A1", "I1A2"))
    run = place.run(WRITERS[0][0], preexec_fn=small_disk)
    check(run.returncode == 2 and place.files() == before, "full disk: the old files changed", run.returncode)
    (place.folder / "p.plc").write_text(SOURCE)


def wrong_places(place):
    (place.folder / "file").write_text("")
    (place.folder / "taken" / "p.cpp").mkdir(parents=True)
    for target in ("file", "file/below", "/proc/nosuch", "taken", "/dev/null", "x" * 300):
        for command in ("emit", "report"):
            if target == "taken" and command == "report":
                continue
            run = place.run([command, "p.plc", "-o", target])
            check(run.returncode in (1, 2), "wrong place: exit", run.returncode, command, target[:20], run.stderr[:300])
            check(len(run.stderr) > 20, "wrong place: no message", command, target[:20])
    check(place.files("taken") == {}, "wrong place: left", place.files("taken").keys())
    for source in (".", "nosuch.plc", "p.plc/x", "/proc/self/mem", ""):
        run = place.run(["check", source, "--dialect", "nc110"])
        check(run.returncode in (1, 2) and run.stderr, "no source: exit", run.returncode, repr(source), run.stderr[:200])


def outputs(place):
    with open("/dev/full", "wb") as full:
        for words in (["--help"], ["emit", "--help"], ["--version"], ["print", "syntax", "p.plc"], ["report", "p.plc", "-o", "-"],
                      ["explain", "nc110-41"], ["sim", "p.plc", "--for", "1s", "--watch", "U4A0"]):
            run = subprocess.run([place.plcxx, *words], cwd=place.folder, stdout=full, stderr=subprocess.PIPE, timeout=300)
            check(run.returncode == 2, "full output: exit", run.returncode, words)
            check(run.stderr, "full output: no message", words)
    for words in (["print", "syntax", "p.plc"], ["report", "p.plc", "-o", "-"], ["sim", "p.plc", "--for", "9s", "--watch", "U4A0"]):
        process = subprocess.Popen([place.plcxx, *words], cwd=place.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.read(10)
        process.stdout.close()
        process.stderr.read()
        check(process.wait(300) in (0, 1, 2, -signal.SIGPIPE), "closed pipe: exit", process.returncode, words)
        process.stderr.close()
    for closed in (0, 1, 2):
        run = subprocess.run([place.plcxx, "check", "p.plc"], cwd=place.folder, timeout=300, close_fds=True, stderr=subprocess.PIPE if closed != 2 else None,
                             preexec_fn=lambda closed=closed: os.close(closed))
        check(run.returncode in (0, 2), "closed descriptor: exit", run.returncode, closed)
        run = subprocess.run([place.plcxx, "emit", "p.plc", "-o", "closed"], cwd=place.folder, timeout=300, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                             preexec_fn=lambda closed=closed: os.close(closed))
        text = (place.folder / "closed/p.cpp").read_bytes() if (place.folder / "closed/p.cpp").exists() else b""
        check(b"warning" not in text[:200] and b"p.plc: " not in text, "closed descriptor: messages in a file", closed)


def together(place):
    """Eight runs at the same time into one directory, over and over: always one whole program."""
    expected = {}
    for letter in ("a", "b"):
        shutil.copy(place.folder / "p.plc", place.folder / f"{letter}.plc")
    (place.folder / "b.plc").write_text(SOURCE.replace("I1A1", "I1A2"))
    for letter in ("a", "b"):
        place.run(["emit", f"{letter}.plc", "--name", "p", "-o", f"only_{letter}", "--single-file"])
        expected[letter] = {name: data for name, data in place.files(f"only_{letter}").items() if name == "p.hpp"}
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        runs = list(pool.map(lambda i: place.run(["emit", f"{'ab'[i % 2]}.plc", "--name", "p", "-o", "both/deep/er", "--single-file"]), range(24)))
    for run in runs:
        check(run.returncode == 0, "together: exit", run.returncode, run.stderr[-300:])
    left = place.files("both/deep/er")
    check(not [name for name in left if name.endswith((".new", ".old"))], "together: left", left.keys())
    check({"p.hpp": left.get("p.hpp")} in expected.values(), "together: a torn file")


def killed(place):
    """SIGTERM and SIGINT at any time: files are whole, and nothing hidden is left."""
    place.run(["emit", "p.plc", "-o", "term"])
    whole = place.files("term")
    begin = time.monotonic()
    place.run(["emit", "p.plc", "-o", "term2"])
    length = time.monotonic() - begin
    rng = random.Random(1)
    for i in range(100):
        shutil.rmtree(place.folder / "term", ignore_errors=True)
        process = subprocess.Popen([place.plcxx, "emit", "p.plc", "-o", "term"], cwd=place.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        time.sleep(rng.random() * length * 1.1)
        process.send_signal((signal.SIGTERM, signal.SIGINT)[i % 2])
        process.wait(300)
        for name, data in (place.files("term") if (place.folder / "term").exists() else {}).items():
            check(name in whole, "killed: left", name)
            check(whole.get(name, data) == data, "killed: torn", name)


def leftovers(place):
    """A signal in the middle of a compiler's work: neither its temporary files nor what it has started stay."""
    (place.folder / "o.plc").write_text("$\nU4A0=I0A0\n")
    (place.folder / "n.plc").write_text("$\nU4A0=I0A1\n")
    (place.folder / "o.yaml").write_text("dialect: nc110\nsources: [o.plc]\nsteps:\n- run: {slow: 1}\n")
    slow = place.folder / "slow"  # a compiler that has begun and does not end, in a process of its own
    slow.write_text('#!/bin/sh\ncase "$*" in *--version*) exec c++ --version;; esac\nsleep 1000 & echo $! >> children\n: > "$TMPDIR/mine"\nwait\n')
    slow.chmod(0o755)
    for words in (["test", "o.yaml", "--cxx", "./slow"], ["diff", "o.plc", "n.plc"], ["build", "o.plc", "--target", "host", "-o", "kept", "--compiler", str(slow)],
                  ["soak", "o.plc", "--engine", "fleet", "--for", "1min", "--cxx", "./slow"]):
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGPIPE):
            temporary, children = place.folder / "temporary", place.folder / "children"
            temporary.mkdir()
            children.write_text("")
            process = subprocess.Popen([place.plcxx, *words], cwd=place.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                       env={**os.environ, "TMPDIR": str(temporary), "CXX": str(slow)})
            end = time.monotonic() + 60
            while not children.read_text().endswith("\n") and process.poll() is None and time.monotonic() < end:
                time.sleep(0.02)
            time.sleep(0.05)
            process.send_signal(number)
            process.wait(60)
            check(process.returncode == -number, "leftovers: exit", process.returncode, words[0], number)
            end = time.monotonic() + 10
            while True:
                left = list(temporary.rglob("*"))
                alive = [child for child in children.read_text().split() if is_running(child)]
                if (not left and not alive) or time.monotonic() > end:
                    break
                time.sleep(0.05)
            check(not left, "leftovers: files", words[0], number, [str(path.relative_to(temporary)) for path in left])
            check(not alive, "leftovers: processes", words[0], number)
            for child in alive:
                os.kill(int(child), signal.SIGKILL)
            shutil.rmtree(temporary)
    check(not (place.folder / "kept").exists(), "leftovers: output of build")


def is_running(process):
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def names(place):
    for name in NAMES:
        try:
            (place.folder / name).write_text("$\nU4A0=I0A0\n")
        except (OSError, UnicodeError):
            continue
        for command in (["check"], ["emit", "-o", "named", "--depfile", "named/d"], ["print", "syntax"], ["report", "-o", "named"], ["sim", "--for", "20ms"]):
            run = place.run([*command, "--dialect", "nc110", "--", name] if name.startswith("-") else [*command, name, "--dialect", "nc110"])
            check(run.returncode in (0, 1, 2), "names: exit", run.returncode, command[0], ascii(name)[:60], run.stderr[:300])
            check(run.returncode == 0 or b"name" in run.stderr, "names: no cause", command[0], ascii(name)[:60], run.stderr[:300])
        (place.folder / name).unlink()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("plcxx")
    args = parser.parse_args()
    attempts = (full_disk, keeps_the_old, wrong_places, outputs, together, killed, leftovers, names)
    for attempt in attempts:
        with tempfile.TemporaryDirectory(prefix="plcxx_world_") as folder:
            attempt(Place(str(pathlib.Path(args.plcxx).resolve()), folder))
    for fault in faults:
        print(ascii(fault)[:400])
    print(f"{len(attempts)} kinds of wrong worlds, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
