#!/usr/bin/python3
"""How punctual the loop of `--host posix` is: idle, and beside processes that compute, write to the disk and take memory.

    tests/bench/jitter.py [--plcxx build/bin/plcxx] [--seconds 10] [--load 4]

With the right to a real-time priority (root, or limits rtprio and memlock) and without it; the loop says itself how late its periods
began. The lathe of samples/nc110 is the program.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PERIOD_MS = 10
IO = """#include <plcxx_host/posix.h>
namespace plcxx::host {
bool io_open(int, char**) noexcept { return true; }
void io_read(Value*) noexcept {}
void io_write(const Value*) noexcept {}
void io_close() noexcept {}
}
"""
LOADS = {
    "computing": "while True: sum(i * i for i in range(10000))",
    "memory": "while True: bytearray(1 << 26)",
    "disk": "import os\nf = open('load', 'wb')\nwhile True:\n  f.seek(0)\n  f.write(bytes(1 << 22))\n  f.flush()\n  os.fsync(f.fileno())",
}


def build(plcxx, folder):
    subprocess.run([plcxx, "emit", "--project", ROOT / "samples/nc110/lathe_16k20/plcxx.yaml", "-o", folder + "/", "--host", "posix", "--quiet"], check=True)
    pathlib.Path(folder, "io.cpp").write_text(IO)
    subprocess.run(["c++", "-std=c++17", "-O2", "-I", ROOT / "runtime_support", "lathe.cpp", "lathe_pins.cpp", "lathe_posix.cpp", "io.cpp", "-lpthread",
                    "-o", "loop"], cwd=folder, check=True)


def measure(folder, name, seconds, load, before):
    loads = [subprocess.Popen([sys.executable, "-c", text], cwd=folder, stderr=subprocess.DEVNULL) for _ in range(load) for text in LOADS.values()]
    try:
        ran = subprocess.run(before + ["./loop", "--periods", str(int(seconds * 1000 / PERIOD_MS))], cwd=folder, capture_output=True, text=True, check=True)
    finally:
        for process in loads:
            process.kill()
            process.wait()
    lines = ran.stderr.splitlines()
    print("%-28s %s%s" % (name, lines[-1].partition(": ")[2], " (no real-time priority)" if any("not real-time" in line for line in lines) else ""), flush=True)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--plcxx", default=str(ROOT / "build/bin/plcxx"))
    options.add_argument("--seconds", type=float, default=10)
    options.add_argument("--load", type=int, default=2, help="processes of each kind")
    asked = options.parse_args()
    with tempfile.TemporaryDirectory(prefix="plcxx-bench-") as folder:
        build(os.path.abspath(asked.plcxx), folder)
        plain = ["prlimit", "--rtprio=0:0"] if os.geteuid() != 0 else ["setpriv", "--bounding-set=-sys_nice", "--inh-caps=-sys_nice", "prlimit", "--rtprio=0:0"]
        for name, before in (("real-time", []), ("as any process", plain)):
            measure(folder, name + ", idle", asked.seconds, 0, before)
            measure(folder, name + ", under load", asked.seconds, asked.load, before)


main()
