#!/usr/bin/env python3
"""Random C programs through plcxx and through borland.h: memory must be the same after every cycle.

run.py PLCXX CXX DIRECTORY [--programs N] [--seed S]

Each program becomes DIRECTORY/pNNN.cld with a scenario whose expectations the reference has computed; `plcxx test` runs
all of them in the simulator and as compiled C++. Exit code 0: all traces are equal. The seeds are fixed, so a failure
comes again, and its program and scenario stay in DIRECTORY.
"""
import argparse
import concurrent.futures
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import generate  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS_PER_UNIT = 25
AREAS = (("X", 128), ("Y", 128), ("R", 768), ("F", 512), ("G", 512), ("P", 200))


def reference(number, generator, inputs):
    """The program over borland.h, and a function that runs its cycles and prints what a scenario expects."""
    rows = [f"namespace p{number} {{", "uint8_t memory[70000];"]
    at = 0
    for name, size in [*AREAS, *generator.objects]:
        rows.append(f"const Object {name}{{memory + {at}, {size}}};")
        at += size
    rows += generator.cpp
    rows += ["void run()", "{", "fault_code = 0;"] + generator.initial
    for cycle, (x, p, f) in enumerate(inputs):
        rows += [f"Store(At(X, Type::kUchar, {i}), Whole(Type::kInt, {v}));" for i, v in enumerate(x)]
        rows += [f"Store(At(P, Type::kUnsigned, {2 * i}), Whole(Type::kLong, {v}));" for i, v in enumerate(p)]
        rows += [f"Store(At(F, Type::kUnsigned, {2 * (generate.F_FIRST + i)}), Whole(Type::kLong, {v}));"
                 for i, v in enumerate(f)]
        rows += ["plc1();"] + (["plc2();"] if cycle % 2 == 0 else [])
        rows += [f'Show("{name}", Read({place}));' for name, place in generator.observed]
        rows += ['Show("FAULT.code", Whole(Type::kInt, fault_code));']
    return "\n".join(rows + ["}", f"}}  // p{number}", ""])


def run_unit(compiler, directory, unit, programs):
    """Compiles and runs some programs; their values in order of printing."""
    source, binary = directory / f"unit{unit}.cc", directory / f"unit{unit}"
    text = '#include "borland.h"\n#include <cstdio>\nusing namespace borland;\n'
    text += 'void Show(const char*, const Value& v) { std::printf("%lld\\n", static_cast<long long>(v.whole)); }\n'
    text += "".join(reference(*program) for program in programs)
    text += "int main() {\n" + "".join(f'std::puts("p{n}"); p{n}::run();\n' for n, _, _ in programs) + "}\n"
    source.write_text(text)
    subprocess.run([compiler, "-std=c++17", "-O0", "-w", "-I", HERE, source, "-o", binary], check=True)
    output = subprocess.run([binary], check=True, capture_output=True, text=True, timeout=120).stdout
    return {int(block.split("\n")[0]): block.split()[1:] for block in output.split("p")[1:]}


def flow(pairs):
    return "{" + ", ".join(f'"{key}": {value}' for key, value in pairs) + "}"


def scenario(number, generator, inputs, values):
    rows = ["dialect: hnc", f"sources: [p{number:03}.cld]", "steps:"]
    values = iter(values)
    for x, p, f in inputs:
        rows.append("- set: " + flow([(f"X[{i}]", v) for i, v in enumerate(x)] + [(f"P[{i}]", v) for i, v in enumerate(p)] +
                                     [(f"F[{generate.F_FIRST + i}]", v) for i, v in enumerate(f)]))
        rows.append("- run: {fast: 1}")
        expected = [(name, next(values)) for name, _ in generator.observed] + [("FAULT.code", next(values))]
        rows.append("- expect: " + flow(expected))
    return "\n".join(rows) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plcxx", type=pathlib.Path)
    parser.add_argument("compiler")
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()

    directory = arguments.directory
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    programs = []
    for number in range(arguments.programs):
        generator = generate.Generator(arguments.seed + number)
        (directory / f"p{number:03}.cld").write_text(generator.program())
        programs.append((number, generator, generator.inputs()))

    units = [programs[i:i + PROGRAMS_PER_UNIT] for i in range(0, len(programs), PROGRAMS_PER_UNIT)]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(run_unit, arguments.compiler, directory, i, unit) for i, unit in enumerate(units)]
        values = {}
        for job in jobs:
            values.update(job.result())
    for number, generator, inputs in programs:
        (directory / f"p{number:03}.yaml").write_text(scenario(number, generator, inputs, values[number]))
    print(f"{len(programs)} programs, {sum(len(v) for v in values.values())} values")
    sys.stdout.flush()
    sys.exit(subprocess.run([arguments.plcxx, "test", directory], check=False).returncode)


if __name__ == "__main__":
    main()
