#!/usr/bin/env python3
"""A fleet against the generated C++ of the same program, and against the simulator, in one run.

    fleet.py [--statements N ...] [--samples] [--build DIRECTORY]

Prints for each program the processor time of a period and machine in ns: the generated code with g++ -O2, the simulator, and
fleets of 64, 256 and 512 machines, as far as the processor has them; how many times as fast as the generated code a fleet is; what two
fleets at once do, in fleets alone; the share of operations that run lane by lane; bytes of a lane; seconds to compile. The
mix is that of generate_nc110.py; --samples takes the machines of samples/, too.
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
SAMPLES = ("nc110/lathe_16k20", "technol/mcv_750", "host50/ck6150", "prostep/mill_fnd32", "hnc/mill_xk7132")


def measure(command, directory, at_once=1):
    """A row of each of the processes that run at once, or what one of them says when it fails."""
    processes = [subprocess.Popen(command, cwd=directory, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                 for _ in range(at_once)]
    results = [(process, *process.communicate()) for process in processes]
    failed = [error.strip()[:60] for process, _, error in results if process.returncode != 0]
    return failed[0] if failed else [json.loads(output) for _, output, _ in results]


def report(name, bench, directory, periods, source):
    for lanes in WIDTHS:
        command = [str(bench), str(lanes), str(periods), source]
        alone, both = measure(command, directory), measure(command, directory, at_once=2)
        if isinstance(alone, str) or isinstance(both, str):
            print(f"| {name} | {lanes} | {alone if isinstance(alone, str) else both} |")
            continue
        row = alone[0]
        scalar, fleet = row["scalar_ns"], row["ns_per_period_and_machine"]
        two = sum(fleet / one["ns_per_period_and_machine"] for one in both)
        share = row["per_lane"] / (row["per_lane"] + row["sliced"])
        print(f"| {name} | {row['lanes']} | {scalar:.1f} | {row['simulator_ns']:.0f} | {fleet:.2f} | {scalar / fleet:.1f} | {two:.2f} | "
              f"{share:.1%} | {row['state_bytes_per_lane']:.0f} | {row['compile_s']:.1f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--statements", type=int, nargs="*", default=[1000])
    parser.add_argument("--samples", action="store_true")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    options = parser.parse_args()
    bench = (options.build / "tests" / "plcxx_fleet_bench").resolve()
    print("| program | machines | scalar ns | simulator ns | fleet ns/machine | times | two at once | per lane | bytes/lane | compile s |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for count in options.statements:
        with tempfile.TemporaryDirectory() as directory:
            subprocess.run([sys.executable, str(HERE / "generate_nc110.py"), str(count), directory], check=True)
            report(f"{count} statements", bench, directory, max(20, 400_000 // count), "program.plc")
    for sample in SAMPLES if options.samples else ():
        report(sample, bench, ROOT / "samples" / sample, 2000, "plcxx.yaml")


if __name__ == "__main__":
    main()
