#!/usr/bin/env python3
"""A module against the headers of LinuxCNC's sources, for a version that is not packaged yet (2.10): does it compile, and
with which pins?

    linuxcnc_headers.py PLCXX [SOURCES]

SOURCES is a clone of LinuxCNC, bare or not; or LINUXCNC_SOURCES in the environment. Without one nothing is done.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = "$\nU4A0=I0A0*/I0A1\nW0T0=W1A0\nU10N4=I0A2\n"


def main():
    plcxx, sources = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else os.environ.get("LINUXCNC_SOURCES")
    if not sources:
        print("wants a clone of LinuxCNC in LINUXCNC_SOURCES")
        sys.exit(77)
    git = lambda *words: subprocess.run(["git", "-C", sources, *words], capture_output=True, text=True, check=True).stdout
    with tempfile.TemporaryDirectory(prefix="plcxx-test-") as name:
        work = pathlib.Path(name)
        headers = work / "headers"
        headers.mkdir()
        for path in git("ls-tree", "-r", "--name-only", "HEAD", "src/hal", "src/rtapi").split():
            if re.fullmatch(r"src/(hal/hal|rtapi/rtapi\w*)\.h", path):
                (headers / pathlib.Path(path).name).write_text(git("show", "HEAD:" + path))
        (work / "fan.plc").write_text(PROGRAM)
        subprocess.run([plcxx, "emit", "fan.plc", "--host", "linuxcnc", "-o", "out", "--quiet"], cwd=work, check=True)
        subprocess.run(["c++", "-std=c++17", "-O2", "-fPIC", "-shared", "-Wl,-Bsymbolic", "-fno-exceptions", "-fno-rtti", "-Wall", "-Wextra", "-Werror",
                        "-DRTAPI", "-DSIM", "-DUSPACE", "-D__MODULE__", "-isystem", headers, "-I", ROOT / "runtime_support",
                        "fan.cpp", "fan_pins.cpp", "fan_linuxcnc.cpp", "-o", "fan.so"], cwd=work / "out", check=True)
        symbols = subprocess.run(["nm", "-D", "fan.so"], cwd=work / "out", capture_output=True, text=True, check=True).stdout
        used = sorted(set(re.findall(r" U (hal_pin\w+)", symbols)))
        print("LinuxCNC %s: %s" % (git("show", "HEAD:VERSION").strip(), ", ".join(used)))
        expected = "hal_pin_new_bool" if "hal_pin_new_bool" in (headers / "hal.h").read_text() else "hal_pin_bit_newf"
        assert expected in used, used


main()
