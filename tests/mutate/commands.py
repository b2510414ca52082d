#!/usr/bin/env python3
"""plcxx mutate from the outside: what is noticed, the same bytes, wrong use.

commands.py PLCXX
"""
import json
import pathlib
import subprocess
import sys
import tempfile

PLCXX = str(pathlib.Path(sys.argv[1]).resolve())
DOOR = """$
; two valves, and a lock
U4A0 = I0A0*/I0A1
U4A1 = I0A0*I0A1
T50I(30) = U4A0
U4A3 = T50U
"""
GOOD = """dialect: nc110
sources: [door.plc]
steps:
  - set: {I0A0: 1}
  - run: {slow: 1}
  - expect: {U4A0: 1, U4A1: 0}
  - set: {I0A1: 1}
  - run: {slow: 1}
  - expect: {U4A0: 0, U4A1: 1}
  - set: {I0A0: 0}
  - run: {slow: 1}
  - expect: {U4A0: 0, U4A1: 0}
  - set: {I0A1: 0}
  - run: {slow: 1}
  - expect: {U4A0: 0}
"""


def mutate(folder, *arguments):
    return subprocess.run([PLCXX, "mutate", *arguments], cwd=folder, capture_output=True, text=True, timeout=100)


def expect(condition, what, ran):
    if not condition:
        raise SystemExit(f"{what}\n{ran.args}\nexit code {ran.returncode}\n{ran.stdout}{ran.stderr}")


def main():
    with tempfile.TemporaryDirectory() as place:
        work = pathlib.Path(place)
        (work / "door.plc").write_text(DOOR)
        (work / "good.yaml").write_text(GOOD)

        # Both valves are looked at from all sides; nothing looks at what the timer does.
        ran = mutate(work, "good.yaml", "--format", "json")
        expect(ran.returncode == 0, "it does not pass", ran)
        (program,) = json.loads(ran.stdout)
        by_line = {}
        for change in program["changes"]:
            by_line.setdefault(change["line"], []).append(change)
        for line in (3, 4):
            missed = [change["text"] for change in by_line[line] if change["outcome"] != "noticed"]
            expect(by_line[line] and not missed, f"line {line}: not noticed: {missed}", ran)
        noticed = [change["text"] for change in by_line[6] if change["outcome"] == "noticed"]
        expect(noticed == [], f"nobody looks at U4A3, and yet: {noticed}", ran)
        expect(any("30" in change["text"] for change in by_line[5]), "the timer's preset is not changed", ran)
        count = sum(change["outcome"] == "noticed" for change in program["changes"])
        expect(program["noticed"] == count and program["found"] == len(program["changes"]), "counts", ran)

        # The same whatever runs at a time; text names statement and change.
        text = mutate(work, "good.yaml", "--jobs", "1")
        expect(text.stdout == mutate(work, "good.yaml", "--jobs", "3").stdout, "--jobs changes what is said", text)
        expect("door.plc:6: U4A3 = T50U\n    T50U is always 0\n" in text.stdout, "what was not noticed", text)
        expect(not [path for path in work.iterdir() if path.name not in ("door.plc", "good.yaml")], "files written", text)

        # A share that is asked for, and a part of the changes.
        share = 100 * program["noticed"] // program["found"]
        expect(mutate(work, "good.yaml", "--least", str(share)).returncode == 0, "--least of what there is", text)
        expect(mutate(work, "good.yaml", "--least", str(share + 1)).returncode == 1, "--least of more", text)
        few = json.loads(mutate(work, "good.yaml", "--most", "5", "--format", "json").stdout)[0]
        expect(len(few["changes"]) == 5 and few["found"] == program["found"], "--most", text)

        # A scenario that fails before, none at all, a program with errors.
        (work / "bad.yaml").write_text(GOOD.replace("U4A0: 1, U4A1: 0", "U4A0: 0, U4A1: 0"))
        bad = mutate(work, "bad.yaml")
        expect(bad.returncode == 1 and "bad.yaml fails before anything is changed" in bad.stderr, "a failing scenario", bad)
        expect("last writes to U4A0" in bad.stderr, "who wrote it is not told, though the simulator ran it", bad)
        (work / "none.yaml").write_text("dialect: nc110\nsources: [door.plc]\nwarnings: []\n")
        none = mutate(work, "none.yaml")
        expect(none.returncode == 2 and "nothing that could notice" in none.stderr, "no steps", none)
        (work / "alone.yaml").write_text("steps:\n- run: {slow: 1}\n")
        alone = mutate(work, "alone.yaml")
        expect(alone.returncode == 2 and "alone.yaml: no 'sources': the scenario names no program" in alone.stderr, "no sources", alone)
        (work / "door.plc").write_text("$\nU4A0 = \n")
        wrong = mutate(work, "good.yaml")
        expect(wrong.returncode == 1 and "door.plc:2" in wrong.stderr, "a program with errors", wrong)


main()
