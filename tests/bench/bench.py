#!/usr/bin/env python3
"""Measures plcxx on generated NC-110 programs and prints one table; every ratio is taken within this run.

    bench.py [--plcxx build/bin/plcxx] [--quick]

Times are processor seconds of one core. Columns: transpiling (time, time per statement, peak memory), g++ -O2 of the generated code, cost of a scan against the
same program written by hand with one byte per bit and 250 statements a function, code size on x86-64, Cortex-M4, RV32.
"""
import argparse
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import generate_nc110  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
# A generated program drives few timers from many statements; its warnings are not what is measured.
QUIET = ["-Wno-W313", "-Wno-W322", "-Wno-W351", "-Wno-W356", "-Wno-W357", "-Wno-W358"]
RUNTIME = ROOT / "runtime_support"


def timed(command, runs, **kwargs):
    """The least processor time of several runs and the peak memory of the process in kB."""
    best, peak = 1e9, 0
    for _ in range(runs):
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **kwargs)
        _, status, usage = os.wait4(process.pid, 0)
        best = min(best, usage.ru_utime + usage.ru_stime)
        peak = max(peak, usage.ru_maxrss)
        if status != 0:
            sys.exit(f"failed: {' '.join(map(str, command))}")
    return best, peak


def compile_all(compiler, flags, sources, directory):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    for source in sources:
        subprocess.run([*compiler, *flags, "-I", str(RUNTIME), "-c", source.name, "-o", source.stem + ".o"], cwd=directory, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def text_size(tool, sources, directory):
    out = subprocess.run([tool, *[s.stem + ".o" for s in sources]], cwd=directory, check=True, capture_output=True, text=True).stdout
    return sum(int(line.split()[0]) for line in out.splitlines()[1:])


def measure(plcxx, count, base):
    directory = base / str(count)
    generate_nc110.write(count, directory)
    emit, peak = timed([plcxx, "emit", "program.plc", "--name", "program", "-o", ".", *QUIET], 5, cwd=directory)
    row = {"statements": count, "emit s": emit, "us/stmt": emit / count * 1e6, "peak MB": peak / 1024, "kB/stmt over 60 MB": max(0, peak - 60 * 1024) / count}
    if count > 10_000:
        return row
    generated = sorted(p for p in directory.glob("program*.cpp"))
    release = ["-std=c++17", "-O2", "-fno-exceptions", "-fno-rtti"]
    row["g++ s"] = compile_all(["g++"], release, generated, directory)
    row["x86 B/stmt"] = text_size("size", generated, directory) / count
    reference = directory / "reference.cpp"
    row["ref g++ s"] = compile_all(["g++"], release, [reference], directory)
    compile_all(["g++"], release, [directory / "glue.cpp", directory / "compare.cpp"], directory)
    objects = [p.stem + ".o" for p in [*generated, reference, directory / "glue.cpp", directory / "compare.cpp"]]
    subprocess.run(["g++", *objects, "-o", "compare"], cwd=directory, check=True)
    out = subprocess.run(["./compare"], cwd=directory, check=True, capture_output=True, text=True).stdout
    row["ref ns/stmt"], row["ns/stmt"] = map(float, out.split())
    row["scan ratio"] = row["ns/stmt"] / row["ref ns/stmt"]
    for name, tool, flags in [
        ("M4", "arm-none-eabi-", ["-mcpu=cortex-m4", "-mthumb"]),
        ("RV32", "riscv64-unknown-elf-", ["-march=rv32imac", "-mabi=ilp32"]),
    ]:
        if shutil.which(tool + "g++") is None:
            continue
        flags = [*release, "-ffreestanding", *flags]
        compile_all([tool + "g++"], flags, generated, directory)
        size = text_size(tool + "size", generated, directory)
        compile_all([tool + "g++"], flags, [reference], directory)
        row[f"{name} B/stmt"] = size / count
        row[f"{name} ratio"] = size / text_size(tool + "size", [reference], directory)
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plcxx", default=str(ROOT / "build/bin/plcxx"))
    parser.add_argument("--quick", action="store_true", help="1,000 statements only")
    options = parser.parse_args()
    plcxx = str(pathlib.Path(options.plcxx).resolve())
    start, _ = timed([plcxx, "--version"], 20)
    print(f"plcxx --version: {start * 1000:.1f} ms")
    with tempfile.TemporaryDirectory() as base:
        for count in [1_000] if options.quick else [1_000, 10_000, 100_000]:
            row = measure(plcxx, count, pathlib.Path(base))
            print("  ".join(f"{key} {value:.3g}" if isinstance(value, float) else f"{key} {value:,}" for key, value in row.items()), flush=True)


if __name__ == "__main__":
    main()
