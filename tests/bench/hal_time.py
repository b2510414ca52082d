#!/usr/bin/python3
"""What a period costs in LinuxCNC's real-time thread: the lathe's program as a module, ClassicLadder with a ladder of as many rungs,
and the same ladder as a module.

    tests/bench/hal_time.py [--plcxx build/bin/plcxx] [--periods 1000]

Wants root and the packages of `dev/install linuxcnc`; LinuxCNC refuses root, so it runs as the user of --user. Each function's own pin
`time` is sampled in each period; inputs change in each. HAL counts a function's time with the clock: what interrupts it counts as well,
so that the middle says what the program costs, and the greatest (`tmax`) what the computer did, too.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODULES = pathlib.Path("/usr/lib/linuxcnc/modules")
FLAGS = ["-std=c++17", "-O2", "-fPIC", "-shared", "-Wl,-Bsymbolic", "-fno-exceptions", "-fno-rtti", "-ffp-contract=off", "-DRTAPI", "-DSIM",
         "-DUSPACE", "-D__MODULE__", "-isystem", "/usr/include/linuxcnc", "-I", str(ROOT / "runtime_support")]
PERIOD_MS = 10


def ladder(rungs):
    """Each rung: four contacts, two of them beside each other, and a coil."""
    parts = {"general.txt": "SIZE_NBR_RUNGS=%d\nSIZE_NBR_BITS=%d\n" % (rungs, rungs + 10), "sections.csv": "000,0,-1,0,%d,0\n" % (rungs - 1)}
    for i in range(rungs):
        bits = [(50, i % 12), (0, (i * 7 + 1) % rungs), (0, (i * 5 + 2) % rungs), (0, (i * 3 + 3) % rungs)]
        first = ["1-0-%d/%d" % bits[0], "2-0-%d/%d" % bits[1], "1-0-%d/%d" % bits[2]] + ["9-0-0/0"] * 6 + ["50-0-0/%d" % i]
        second = ["1-0-%d/%d" % bits[3], "0-1-0/0"] + ["0-0-0/0"] * 8
        follows = "#NEXTRUNG=%d\n" % (i + 1 if i + 1 < rungs else -1)
        parts["rung_%d.csv" % i] = "#VER=2.0\n#LABEL=\n#COMMENT=\n#PREVRUNG=%d\n" % (i - 1) + follows + " , ".join(first) + "\n" + " , ".join(second) + "\n"
    return "_FILES_CLASSICLADDER\n" + "".join("_FILE-%s\n%s_/FILE-%s\n" % (n, t, n) for n, t in parts.items()) + "_/FILES_CLASSICLADDER\n"


def module(plcxx, folder, name, *program):
    out = folder / name
    subprocess.run([plcxx, "emit", *program, "-o", str(out) + "/", "--name", name, "--host", "linuxcnc", "--quiet"], check=True)
    subprocess.run(["c++", *FLAGS, name + ".cpp", name + "_pins.cpp", name + "_linuxcnc.cpp", "-o", name + ".so"], cwd=out, check=True)
    shutil.copy(out / (name + ".so"), MODULES / (name + ".so"))
    return out


def times(folder, user, loads, function, inputs, count):
    """ns of each period."""
    run = folder / function.replace(".", "_")
    run.mkdir()
    for file in folder.glob("*.clp"):
        shutil.copy(file, run)
    depth = count + 10
    bits = inputs[:20]
    rows = "".join(" ".join(str(i * (k + 3) // 7 & 1) for k in range(len(bits))) + "\n" for i in range(count))
    (run / "in.txt").write_text(rows)
    lines = ["loadrt threads name1=t period1=%d" % (PERIOD_MS * 1000000), *loads, "loadrt streamer depth=%d cfg=%s" % (depth, "b" * len(bits)),
             "loadrt sampler depth=%d cfg=s" % depth]
    lines += ["net i%d streamer.0.pin.%d => %s" % (k, k, pin) for k, pin in enumerate(bits)]
    lines += ["loadusr -w halstreamer -c 0 in.txt", "addf streamer.0 t", "addf %s t" % function, "net time %s.time => sampler.0.pin.0" % function,
              "addf sampler.0 t", "start", "loadusr -w halsampler -c 0 -n %d out.txt" % count]
    (run / "run.hal").write_text("\n".join(lines) + "\n")
    subprocess.run(["chown", "-R", user, run], check=True)
    group = subprocess.run(["id", "-gn", user], capture_output=True, text=True, check=True).stdout.strip()
    said = subprocess.run(["unshare", "--ipc", "--pid", "--fork", "--kill-child", "--mount-proc", "setpriv", "--reuid=" + user, "--regid=" + group,
                           "--init-groups", "halrun", "-f", "run.hal"], cwd=run, env={**os.environ, "HOME": str(run), "TMPDIR": str(run)},
                          capture_output=True, text=True, timeout=60 + count * PERIOD_MS / 100)
    assert (run / "out.txt").exists(), said.stdout + said.stderr
    return [int(line.split()[0]) for line in (run / "out.txt").read_text().splitlines()][2:]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plcxx", default=ROOT / "build/bin/plcxx")
    parser.add_argument("--periods", type=int, default=1000)
    parser.add_argument("--user", default="nobody")
    options = parser.parse_args()
    plcxx = str(pathlib.Path(options.plcxx).resolve())
    installed = []
    with tempfile.TemporaryDirectory(prefix="plcxx-bench-") as name:
        folder = pathlib.Path(name)
        os.chmod(folder, 0o755)
        try:
            installed.append("lathe")
            out = module(plcxx, folder, "lathe", "--project", ROOT / "samples/nc110/lathe_16k20/plcxx.yaml")
            rungs = json.loads((out / "lathe.report.json").read_text())["statements"]
            (folder / "rungs.clp").write_text(ladder(rungs))
            installed.append("rungs")
            module(plcxx, folder, "rungs", folder / "rungs.clp", "--set", "period=%d" % PERIOD_MS)
            pins = re.findall(r'\{"([^"]*)",\s*Type::kBit,\s*Direction::kIn,\s*Role::kTerminal', (out / "lathe_pins.hpp").read_text())
            rows = [
                ("the lathe, %d statements, as a module" % rungs, times(folder, options.user, ["loadrt lathe"], "lathe.period", ["lathe." + p for p in pins], options.periods)),
                ("a ladder of %d rungs in ClassicLadder" % rungs,
                 times(folder, options.user, ["loadrt classicladder_rt numRungs=%d numBits=%d" % (rungs, rungs + 10), "loadusr -w classicladder --nogui rungs.clp"],
                       "classicladder.0.refresh", ["classicladder.0.in-%02d" % i for i in range(12)], options.periods)),
                ("the same ladder as a module", times(folder, options.user, ["loadrt rungs"], "rungs.period", ["rungs.i%d" % i for i in range(12)], options.periods)),
            ]
        finally:
            for one in installed:
                (MODULES / (one + ".so")).unlink(missing_ok=True)
    print("| | middle | of 100 periods 99 take at most | `tmax` |\n|---|---|---|---|")
    for what, ns in rows:
        ns.sort()
        print("| %s | %.1f us | %.1f us | %.1f us |" % (what, statistics.median(ns) / 1000, ns[len(ns) * 99 // 100] / 1000, ns[-1] / 1000))


main()
