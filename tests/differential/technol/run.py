#!/usr/bin/env python3
"""Random TECHNOL programs through plcxx and through models of the specification: the same memory after every pass.

run.py PLCXX DIRECTORY [--programs N] [--compiled N] [--seed S]

Each program becomes DIRECTORY/<kind><number>.plc with a scenario whose expectations the model has computed. All run in
the simulator, the first ones of each kind as compiled C++, too. Exit code 0: all memory is as the models say. The seeds
are fixed, so a failure comes again, and its program and scenario stay in DIRECTORY.
"""
import argparse
import pathlib
import random
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import assembler  # noqa: E402
import mechanisms  # noqa: E402

KINDS = {"assembler": assembler.make, "mechanisms": mechanisms.make}


def mapping(values):
    return "{" + ", ".join(f"{key}: {value}" for key, value in values.items()) + "}"


def write(directory, kind, number, seed):
    program, options, steps = KINDS[kind](random.Random(f"{seed} {kind} {number}"))
    name = f"{kind}{number:03}"
    (directory / f"{name}.plc").write_text(program)
    scenario = ["dialect: technol", f"sources: [{name}.plc]"]
    scenario += [f"options: {mapping(options)}"] if options else []
    scenario += ["steps:", *[f"- {step}: {mapping(values)}" for step, values in steps], ""]
    path = directory / f"{name}.yaml"
    path.write_text("\n".join(scenario))
    return str(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plcxx")
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=150, help="of each kind")
    parser.add_argument("--compiled", type=int, default=12, help="of each kind, as compiled C++, too")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    shutil.rmtree(arguments.directory, ignore_errors=True)
    arguments.directory.mkdir(parents=True)
    failed = False
    for kind in KINDS:
        paths = [write(arguments.directory, kind, n, arguments.seed) for n in range(arguments.programs)]
        for engine, chosen in (("sim", paths[arguments.compiled:]), ("all", paths[:arguments.compiled])):
            if not chosen:
                continue
            result = subprocess.run([arguments.plcxx, "test", "--engine", engine, *chosen], capture_output=True,
                                    text=True, check=False)
            print(f"{kind}, {engine}: {result.stdout.strip().splitlines()[-1]}")
            if result.returncode != 0:
                failed = True
                print("\n".join(line for line in result.stdout.splitlines() if not line.startswith("passed")))
                print(result.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
