#!/usr/bin/env python3
"""What `plcxx diff` says of changes to the sample machines that a reviewer may have to judge. Prints one table.

    sample_changes.py [--plcxx build/bin/plcxx] [--time 10] [--only TEXT] [--keep DIR] [--check]

Each change is made in a copy of the sample, beside the scenarios. Columns: wall seconds; differences that were shown on
outputs, and the first of them; lines of the text that say 'not decided'; all lines; what is wrong. Wrong is: a rewriting
that is called different, a change that is called equal, a scenario of --counterexamples that does not pass on the old
version and fail on the new one, more than a tenth over the time. With --check the exit code is 1 when something is wrong,
a real change is not shown on an output, or more than ten lines are undecided.
"""
import argparse
import dataclasses
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_UNDECIDED_LINES = 10


@dataclasses.dataclass(frozen=True)
class Change:
    name: str
    sample: str
    file: str  # '*': every source
    old: str
    new: str
    shown: str  # what must be seen: 'alike', 'text', or an output


LATHE, MCV, CK, FND, XK = ("nc110/lathe_16k20", "technol/mcv_750", "host50/ck6150", "prostep/mill_fnd32",
                           "hnc/mill_xk7132")

CHANGES = [
    Change("nc110 comment", LATHE, "turret.plc", "; and stay for 3 s", "; and stay for three seconds", "alike"),
    Change("nc110 rename", LATHE, "*", "TVALID", "TOOLOK", "alike"),
    Change("technol operands swapped", MCV, "main.plc", "LDR  I_NOUZ\n          LA   I_JISTIC\n",
           "LDR  I_JISTIC\n          LA   I_NOUZ\n", "alike"),
    Change("hnc if inverted", XK, "spindle.h", "if (HIT_SP_STOP)\n        start_spindle(SPINDLE_STOPPED);",
           "if (!HIT_SP_STOP)\n        return;\n    start_spindle(SPINDLE_STOPPED);", "alike"),
    Change("prostep text of a message", FND, "texts.plc", "DM 5 .NISKI POZIOM OLEJU", "DM 5 .NISKI STAN OLEJU", "text"),
    # The step counter alone keeps the contactors apart: the other contactor is on in step 3 only.
    Change("nc110 contactor interlock", LATHE, "turret.plc", "[C20W=1]*!TPERM*/!TURREV", "[C20W=1]*!TPERM", "alike"),
    Change("nc110 T24 3 s to 5 s", LATHE, "turret.plc", "T24I(30)", "T24I(50)", "output"),
    Change("nc110 T50 1 s to 9.9 s", LATHE, "turret.plc", "T50I(10)", "T50I(99)", "output"),
    Change("host50 brake 2 s to 3 s", CK, "spindle.il", "TOFS T_BRAKE, 2", "TOFS T_BRAKE, 3", "output"),
    Change("host50 chuck without standstill", CK, "units.il", "ANI  CHUCK_CMD\n  AND  SPEED_ZERO\n",
           "ANI  CHUCK_CMD\n", "output"),
    Change("prostep limit switch dropped", FND, "fast.plc", ":A I 1.3\n", "", "output"),
    Change("technol breaker dropped", MCV, "main.plc", "LDR  I_NOUZ\n          LA   I_JISTIC\n          WR   BEZPECNO",
           "LDR  I_NOUZ\n          WR   BEZPECNO", "output"),
    Change("hnc spindle key without clamp", XK, "spindle.h", "HIT_SPINDLE && CLAMPED && machine_on",
           "HIT_SPINDLE && machine_on", "output"),
]


def write_versions(change, directory):
    """The sample, and the sample with the change."""
    for side in ("old", "new"):
        shutil.copytree(ROOT / "samples" / change.sample, directory / side, ignore=shutil.ignore_patterns("generated"))
    changed = 0
    for path in sorted((directory / "new").iterdir()):
        if change.file not in ("*", path.name) or path.suffix == ".yaml":
            continue
        # Latin-1 keeps every byte; line ends are the file's own.
        text = path.read_bytes().decode("latin-1")
        ends = "\r\n" if "\r\n" in text else "\n"
        edited = text.replace(change.old.replace("\n", ends), change.new.replace("\n", ends))
        changed += edited != text
        path.write_bytes(edited.encode("latin-1"))
    if not changed:
        sys.exit(f"'{change.name}' finds nothing to change: the sample is another one now")


def run(command, directory):
    return subprocess.run(list(map(str, command)), cwd=directory, capture_output=True, text=True, check=False)


def wrong_scenarios(plcxx, change, directory):
    """Names of counterexamples that do not pass on the old version, or do not fail on the new one."""
    wrong = []
    for scenario in sorted((directory / "found").glob("*.yaml")):
        for side, expected in (("old", 0), ("new", 1)):
            copy = directory / side / f"found_{scenario.name}"
            copy.write_text(scenario.read_text().replace("../old/", "").replace("old/", ""))
            if run([plcxx, "test", copy.name], directory / side).returncode != expected:
                wrong.append(f"{scenario.name} on {side}")
            copy.unlink()
    return wrong


def measure(plcxx, change, seconds, directory):
    write_versions(change, directory)
    # Sources and options are those of the scenarios.
    common = ["diff", "old", "new", f"--time={seconds}s"]
    begin = time.monotonic()
    answered = run([plcxx, *common, "--format", "json", "--counterexamples", "found"], directory)
    took = time.monotonic() - begin
    if answered.returncode not in (0, 1):
        sys.exit(f"'{change.name}': {answered.stderr[:2000]}")
    answer = json.loads(answered.stdout)
    text = run([plcxx, *common], directory).stdout
    shown = [item["name"] for item in answer["items"] if item["kind"] == "output" and item["verdict"] == "different"]
    undecided = sum("not decided" in line for line in text.splitlines())
    faults = wrong_scenarios(plcxx, change, directory)
    if took > seconds * 1.1 + 0.2:
        faults.append("too late")
    differs = any(item["verdict"] == "different" for item in answer["items"])
    if change.shown == "alike" and differs:
        faults.append("called different")
    if change.shown != "alike" and not answer["items"]:
        faults.append("called equal")
    met = {"alike": not answer["items"], "text": differs, "output": bool(shown)}[change.shown]
    return {"change": change.name, "s": f"{took:.1f}", "shown": str(len(shown)), "first": shown[0] if shown else "-",
            "undecided": str(undecided), "lines": str(len(text.splitlines())), "wrong": ", ".join(faults) or "-",
            "met": "yes" if met and undecided <= MOST_UNDECIDED_LINES and not faults else "NO"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plcxx", default=str(ROOT / "build/bin/plcxx"))
    parser.add_argument("--time", type=int, default=10, help="limit of one diff in seconds")
    parser.add_argument("--only", default="", help="changes with this text in their names")
    parser.add_argument("--keep", help="a directory for the versions and the scenarios that were found")
    parser.add_argument("--check", action="store_true", help="exit code 1 when a change is not judged as it should be")
    options = parser.parse_args()
    plcxx = pathlib.Path(options.plcxx).resolve()
    fails = False
    with tempfile.TemporaryDirectory() as temporary:
        base = pathlib.Path(options.keep or temporary).resolve()
        for index, change in enumerate(CHANGES):
            if options.only not in change.name:
                continue
            directory = base / change.name.replace(" ", "_")
            shutil.rmtree(directory, ignore_errors=True)
            row = measure(plcxx, change, options.time, directory)
            if index == 0 or options.only:
                print("| " + " | ".join(row) + " |\n" + "|---" * len(row) + "|")
            print("| " + " | ".join(row.values()) + " |", flush=True)
            fails = fails or row["met"] != "yes"
    return int(options.check and fails)


if __name__ == "__main__":
    sys.exit(main())
