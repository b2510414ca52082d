#!/usr/bin/env python3
"""Measures plcxx on generated programs of each dialect and prints one table; every ratio is taken within this run.

    bench.py [--plcxx build/bin/plcxx] [--quick] [--dialect nc110] ...

Times are processor seconds of one core. Columns: transpiling (time, time per statement, peak memory), g++ -O2 of the generated code, what
the audit adds to `plcxx build`, cost of a scan against the
same program written by hand with one byte per bit and 250 statements a function; code size on x86-64, Cortex-M4, RV32, and
on the latter two the instructions of a scan in the emulator, their ratio, the worst scan against the mean, and the longest path of
`plcxx build` against the worst scan.
"""
import argparse
import json
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import emulated  # noqa: E402
import generate_accumulator  # noqa: E402
import generate_hnc  # noqa: E402
import generate_nc110  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
# A generated program drives few timers from many statements; its warnings are not what is measured.
QUIET = {
    "nc110": ["W313", "W322", "W351", "W356", "W357", "W358"],
    "prostep": generate_accumulator.ProStep.warnings,
    "host50": generate_accumulator.Host50.warnings,
    "technol": generate_accumulator.Technol.warnings,
    "hnc": ["W1"],
}
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


def write_sources(dialect, count, directory):
    """The PLC program and the same one by hand; the source's name, its period in ms, what writes the glue between both."""
    if dialect == "nc110":
        generate_nc110.write(count, directory)
        return "program.plc", 10, lambda: None
    if dialect == "hnc":
        program = generate_hnc.write(count, directory)
        (directory / "compare.cpp").write_text(f"#define STATEMENTS {count}\n" + generate_nc110.COMPARE)
        return "program.cld", 16, lambda: generate_hnc.write_glue(program, directory)
    machine = generate_accumulator.machine_of(dialect)
    program = generate_accumulator.write(machine, count, directory)
    (directory / "compare.cpp").write_text(f"#define STATEMENTS {count}\n#define PERIOD {machine.period_ms}\n" + generate_nc110.COMPARE)
    return f"program.{machine.extension}", machine.period_ms, lambda: generate_accumulator.write_glue(program, directory)


def emit_command(plcxx, dialect, source):
    quiet = [f"-Wno-{code}" for code in QUIET[dialect]]
    return [plcxx, "emit", source, "--dialect", dialect, "--name", "program", "-o", ".", *quiet]


def longest_path(plcxx, source, target, directory):
    """What `plcxx build` says that a period of an NC-110 program takes at most, in instructions."""
    command = emit_command(plcxx, "nc110", source)
    command[command.index("emit")] = "build"
    command[command.index("-o") + 1] = target
    subprocess.run([*command, "--target", target], cwd=directory, check=True, capture_output=True)
    report = json.loads((directory / target / "program.report.json").read_text())
    return next(part["instructions"] for part in report["build"]["partitions"] if part["name"] == "period")


def audit_share(plcxx, dialect, source, directory):
    """What audit, measurement and report add to the time of `plcxx build` for the host, compilers included."""
    command = emit_command(plcxx, dialect, source)
    command[command.index("emit")] = "build"
    times = []
    for name, options in (("plain", ["--no-audit"]), ("audited", [])):
        command[command.index("-o") + 1] = name
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([*command, "--target", "host", "-j", "1", *options], cwd=directory, check=True, capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return times[1] / times[0] - 1


def measure(plcxx, dialect, count, base):
    directory = base / f"{dialect}{count}"
    source, period, write_glue = write_sources(dialect, count, directory)
    emit, peak = timed(emit_command(plcxx, dialect, source), 5, cwd=directory)
    row = {"dialect": dialect, "statements": count, "emit s": emit, "us/stmt": emit / count * 1e6, "peak MB": peak / 1024, "kB/stmt over 60 MB": max(0, peak - 60 * 1024) / count}
    if count > 10_000:
        return row
    write_glue()
    generated = sorted(p for p in directory.glob("program*.cpp"))
    release = ["-std=c++17", "-O2", "-fno-exceptions", "-fno-rtti"]
    row["g++ s"] = compile_all(["g++"], release, generated, directory)
    row["audit share"] = audit_share(plcxx, dialect, source, directory)
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
        ("RV32", "riscv64-unknown-elf-", ["-march=rv32imac", "-mabi=ilp32", "-mcmodel=medany"]),
    ]:
        if shutil.which(tool + "g++") is None:
            continue
        flags = [*release, "-ffreestanding", *flags]
        compile_all([tool + "g++"], flags, generated, directory)
        size = text_size(tool + "size", generated, directory)
        compile_all([tool + "g++"], flags, [reference], directory)
        row[f"{name} B/stmt"] = size / count
        row[f"{name} ratio"] = size / text_size(tool + "size", [reference], directory)
        glue = directory / "glue.cpp"
        compile_all([tool + "g++"], flags, [glue], directory)
        row |= emulated.instructions(name, directory, [*generated, reference, glue], count, period)
        if dialect == "nc110" and f"{name} worst instr" in row:
            target = {"M4": "cortex-m4", "RV32": "rv32imac"}[name]
            row[f"{name} bound/worst"] = longest_path(plcxx, source, target, directory) / row[f"{name} worst instr"]
    return row


def sliced_against_atomic(plcxx, count, base):
    """HOST 50: the slow section in eight slices against the same in one piece; eight ticks of each."""
    times = {}
    for name, sliced in (("atomic", False), ("sliced", True)):
        directory = base / f"host50{name}{count}"
        machine = generate_accumulator.machine_of("host50", slow_div=8, sliced=sliced)
        program = generate_accumulator.write(machine, count, directory)
        subprocess.run(emit_command(plcxx, "host50", "program.il"), cwd=directory, check=True, capture_output=True)
        generate_accumulator.write_glue(program, directory)
        (directory / "ticks.cpp").write_text(f"#define STATEMENTS {count}\n" + TICKS)
        sources = [*sorted(directory.glob("program*.cpp")), directory / "glue.cpp", directory / "ticks.cpp"]
        compile_all(["g++"], ["-std=c++17", "-O2", "-fno-exceptions", "-fno-rtti"], sources, directory)
        subprocess.run(["g++", *[p.stem + ".o" for p in sources], "-o", "ticks"], cwd=directory, check=True)
        times[name] = directory / "ticks"
    # In turns, so that both meet the same weather.
    best = {name: 1e18 for name in times}
    for _ in range(7):
        for name, path in times.items():
            best[name] = min(best[name], float(subprocess.run([path], check=True, capture_output=True, text=True).stdout))
    return {"dialect": "host50", "statements": count, "atomic ns/stmt": best["atomic"], "sliced ns/stmt": best["sliced"], "sliced ratio": best["sliced"] / best["atomic"]}


TICKS = r"""
#include <stdint.h>
#include <stdio.h>
#include <time.h>
extern "C" { void generated_init(); void generated_scan(uint32_t); void generated_set(uint32_t); }
static double Now() { timespec t; clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t); return t.tv_sec * 1e9 + t.tv_nsec; }
int main() {
  generated_init();
  uint32_t t = 0, seed = 1;
  const int cycles = 8000000 / STATEMENTS + 1;
  double best = 1e18;
  for (int round = 0; round < 5; ++round) {
    const double start = Now();
    for (int i = 0; i < cycles; ++i) {
      if (i % 16 == 0) generated_set(seed = seed * 1664525u + 1013904223u);
      for (int k = 0; k < 8; ++k, ++t) generated_scan(t);
    }
    const double time = (Now() - start) / cycles / STATEMENTS;
    if (time < best) best = time;
  }
  printf("%.4f\n", best);
}
"""


def print_row(row):
    text = [f"{value:.3g}" if isinstance(value, float) else f"{value:,}" if isinstance(value, int) else value for value in row.values()]
    print("  ".join(f"{key} {value}" for key, value in zip(row, text)), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plcxx", default=str(ROOT / "build/bin/plcxx"))
    parser.add_argument("--quick", action="store_true", help="1,000 statements only")
    parser.add_argument("--dialect", action="append", choices=list(QUIET), help="only these")
    options = parser.parse_args()
    plcxx = str(pathlib.Path(options.plcxx).resolve())
    start, _ = timed([plcxx, "--version"], 20)
    print(f"plcxx --version: {start * 1000:.1f} ms")
    with tempfile.TemporaryDirectory() as base:
        for dialect in options.dialect or list(QUIET):
            for count in [1_000] if options.quick else [1_000, 10_000, 100_000]:
                print_row(measure(plcxx, dialect, count, pathlib.Path(base)))
            if dialect == "host50":
                print_row(sliced_against_atomic(plcxx, 1_000 if options.quick else 10_000, pathlib.Path(base)))


if __name__ == "__main__":
    main()
