#!/usr/bin/python3
"""The lathe's program in LinuxCNC's real-time thread: scenarios scan by scan, wrong threads, retentive memory, and
samples/linuxcnc with its five tool changes.

    linuxcnc.py PLCXX [--keep]

Wants root (a module goes where loadrt looks for it) and the packages of `dev/install linuxcnc`; LinuxCNC itself refuses
root, so it runs as a user that is made for it.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import scenario_replay

ROOT = pathlib.Path(__file__).resolve().parents[2]
LATHE = ROOT / "samples/nc110/lathe_16k20"
MODULES = pathlib.Path("/usr/lib/linuxcnc/modules")
INCLUDE = "/usr/include/linuxcnc"
USER = "plcxx-linuxcnc"


def as_user(command, folder, seconds):
    """Its output and errors as a terminal shows them: LinuxCNC writes to files where there is none. There is one HAL in a
    machine's shared memory: this one gets memory and processes of its own."""
    shell = "cd %s && export HOME=%s && script -qec %s /dev/null" % (folder, folder, json.dumps(command))
    ran = subprocess.run(["unshare", "--ipc", "--pid", "--fork", "--mount-proc", "su", USER, "-s", "/bin/bash", "-c", shell], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, timeout=seconds)
    return ran.returncode, ran.stdout.decode("utf-8", "replace").replace("\r\n", "\n")


def build(plcxx, folder):
    out = folder / "generated"
    subprocess.run([plcxx, "emit", "--project", LATHE / "plcxx.yaml", "-o", str(out) + "/", "--host", "linuxcnc", "--quiet"], check=True)
    subprocess.run(["c++", "-std=c++17", "-O2", "-fPIC", "-shared", "-Wl,-Bsymbolic", "-fno-exceptions", "-fno-rtti", "-ffp-contract=off", "-Wall",
                    "-Wextra", "-Werror", "-DRTAPI", "-DSIM", "-DUSPACE", "-D__MODULE__", "-isystem", INCLUDE, "-I", ROOT / "runtime_support",
                    "lathe.cpp", "lathe_pins.cpp", "lathe_linuxcnc.cpp", "-o", "lathe.so"], cwd=out, check=True)
    shutil.copy(out / "lathe.so", MODULES / "lathe.so")
    return out


def pins_of(out):
    """Of each pin: name, type, direction, role, address."""
    row = re.compile(r'^\s*\{"([^"]*)",\s*Type::k(\w+),\s*Direction::k(\w+),\s*Role::k(\w+),\s*"([^"]*)"', re.M)
    return [match.groups() for match in row.finditer((out / "lathe_pins.hpp").read_text())]


def halrun(folder, lines, seconds=120):
    (folder / "test.hal").write_text("\n".join(lines) + "\n")
    return as_user("halrun -s -f test.hal", folder, seconds)[1]


def wrong_thread(folder):
    said = halrun(folder, ["loadrt threads name1=t period1=7000000", "loadrt lathe", "addf lathe.period t", "setp lathe.estok 1", "start",
                           "loadusr -w sleep 0.3", "getp lathe.host.running", "getp lathe.host.period-fault", "getp lathe.u10k0"])
    assert "the period of the thread does not fit, outputs stay 0: thread us 7000, program us 10000" in said, said
    assert re.search(r"^FALSE\nTRUE\nFALSE$", said, re.M), said


def long_instance(folder):
    said = halrun(folder, ["loadrt lathe names=" + "i" * 44])
    assert "characters, and HAL takes 47: name the instance shorter" in said, said


def retentive(folder):
    kept = folder / "kept"
    kept.mkdir()
    os.chmod(kept, 0o777)
    begin = ["loadrt threads name1=t period1=10000000", "loadrt lathe retentive=%s names=north,south" % kept, "addf north.period t",
             "addf south.period t"]
    said = halrun(folder, begin + ["start", "loadusr -w sleep 0.5", "getp north.host.running", "getp south.host.running", "unload lathe"])
    assert re.search(r"^TRUE\nTRUE$", said, re.M), said
    files = sorted(path.name for path in kept.iterdir())
    assert files == ["north.a", "south.a"], files  # U10K0 rose: the machine is off
    for path in kept.iterdir():
        path.write_bytes(b"damaged")
    said = halrun(folder, begin + ["getp north.host.retentive-fault"])
    assert "both files of the retentive memory are damaged" in said and "\nTRUE\n" in said, said


def scenarios(folder, out):
    """The lathe's scenarios, scan by scan."""
    pins = scenario_replay.Pins(pins_of(out))
    replayed = compared = periods = 0
    for path in sorted(LATHE.glob("*.yaml")):
        if not scenario_replay.is_scenario(path):
            continue  # the project, its properties, plant and panel
        try:
            replay = scenario_replay.Replay(path, pins)
        except scenario_replay.NotReplayed as reason:
            print("  %s: not through pins: %s" % (path.name, reason))
            continue
        run = folder / path.stem
        run.mkdir()
        os.chmod(run, 0o777)
        said = halrun(run, replay.hal_lines(run))
        try:
            count = replay.compare(run)
        except (AssertionError, OSError) as wrong:
            sys.exit("%s: %s\n%s" % (path.name, wrong, said))
        print("  %s: %d periods, %d values as expected (%d have no pin); tmax %s ns" % (
            path.name, len(replay.frames), count, replay.without_pin, re.findall(r"^(\d+)$", said, re.M)[-1:]))
        replayed, compared, periods = replayed + 1, compared + count, periods + len(replay.frames)
    print("  %d scenarios, %d periods, %d values" % (replayed, periods, compared))
    assert replayed >= 5 and compared >= 150, "too few were replayed to say anything"


def five_tool_changes(folder):
    sample = folder / "sample"
    shutil.copytree(ROOT / "samples/linuxcnc", sample)
    subprocess.run(["chown", "-R", USER, sample], check=True)
    code, said = as_user("timeout 120 linuxcnc lathe.ini", sample, 180)
    print(said)
    changes = re.findall(r"^T(\d) M6: ([\d.]+) s, turret at (\d), LinuxCNC has (\d)$", said, re.M)
    assert [change[0] for change in changes] == ["5", "2", "8", "3", "1"], said
    assert all(tool == turret == known for tool, _, turret, known in changes), said
    assert "M3: the converter is on (1)" in said and "M5: standstill" in said, said
    return code


def main():
    if os.geteuid() != 0 or not MODULES.is_dir() or not pathlib.Path(INCLUDE, "hal.h").exists():
        print("wants root, linuxcnc-uspace and linuxcnc-uspace-dev (dev/install linuxcnc)")
        sys.exit(77)
    if subprocess.run(["id", USER], capture_output=True).returncode != 0:
        subprocess.run(["useradd", "--system", "--no-create-home", USER], check=True)
    with tempfile.TemporaryDirectory(prefix="plcxx-test-") as name:
        folder = pathlib.Path(name)
        os.chmod(folder, 0o777)
        out = build(sys.argv[1], folder)
        try:
            scenarios(folder, out)
            for check in (wrong_thread, long_instance, retentive, five_tool_changes):
                check(folder)
                print("%s: as it should be" % check.__name__, flush=True)
        finally:
            (MODULES / "lathe.so").unlink()


main()
