#!/usr/bin/env python3
"""A fleet against the generated C++ of the same program, in one run.

    fleet.py [--statements N ...] [--build DIRECTORY]

Prints for each program the processor time of a period and machine in ns: the generated code with g++ -O2, and fleets of 64, 256 and 512
machines, as far as the processor has them; how many times as fast the widest is; the share of operations that run
lane by lane; bytes of a lane; seconds to compile. The mix is that of generate_nc110.py.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
WIDTHS = (64, 256, 512)
# Whoever runs the generated code alone: the time of one period, inputs that change now and then.
SCALAR = r"""
#include <stdint.h>
#include <stdio.h>
#include <time.h>
extern "C" { void generated_init(); void generated_scan(uint32_t); void generated_set(uint32_t); uint64_t generated_sum(); }
int main() {
  generated_init();
  double best = 1e18;
  uint32_t t = 0;
  for (int round = 0; round < 7; ++round) {
    timespec a, b;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &a);
    for (int i = 0; i < %d; ++i) {
      if (i %% 16 == 0) generated_set(t * 2654435761u);
      generated_scan(t += 10);
    }
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &b);
    double ns = ((b.tv_sec - a.tv_sec) * 1e9 + (b.tv_nsec - a.tv_nsec)) / %d;
    if (ns < best) best = ns;
  }
  printf("%%f %%llu\n", best, (unsigned long long)generated_sum());
}
"""


def run(command, cwd):
    result = subprocess.run([str(word) for word in command], cwd=cwd, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"{command[0]} failed:\n{result.stdout}{result.stderr}")
    return result.stdout


def scalar_ns(plcxx, directory, periods):
    run([plcxx, "emit", "program.plc", "-o", "."], directory)
    (directory / "main.cpp").write_text(SCALAR % (periods, periods))
    generated = [p.name for p in directory.glob("program*.cpp")]
    run(["g++", "-std=c++17", "-O2", "-fno-exceptions", "-fno-rtti", "-I", ".", "-I", ROOT / "runtime_support", *generated, "glue.cpp",
         "main.cpp", "-o", "scalar"], directory)
    return float(run(["./scalar"], directory).split()[0])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--statements", type=int, nargs="+", default=[1000])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    options = parser.parse_args()
    plcxx, bench = options.build / "bin" / "plcxx", options.build / "tests" / "plcxx_fleet_bench"
    print("| statements | machines | scalar ns/machine | fleet ns/machine | fleet ns/rung | times | per lane | bytes/lane | compile s |")
    print("|---|---|---|---|---|---|---|---|---|")
    for count in options.statements:
        with tempfile.TemporaryDirectory() as base:
            directory = pathlib.Path(base)
            run([sys.executable, HERE / "generate_nc110.py", count, directory], directory)
            periods = max(20, 2_000_000 // count)
            scalar = scalar_ns(plcxx, directory, periods)
            for width in WIDTHS:
                result = subprocess.run([bench, str(width), str(max(20, 400_000 // count)), "program.plc"], cwd=directory,
                                        capture_output=True, text=True, check=False)
                if result.returncode != 0:
                    print(f"| {count} | {width} | {scalar:.1f} | {result.stderr.strip()[:60]} |")
                    continue
                row = json.loads(result.stdout)
                fleet = row["ns_per_period_and_machine"]
                share = row["per_lane"] / (row["per_lane"] + row["sliced"])
                print(f"| {count} | {row['lanes']} | {scalar:.1f} | {fleet:.2f} | {fleet / count:.5f} | {scalar / fleet:.1f} | "
                      f"{share:.1%} | {row['state_bytes_per_lane']:.0f} | {row['compile_s']:.1f} |", flush=True)


if __name__ == "__main__":
    main()
