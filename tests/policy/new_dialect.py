#!/usr/bin/env python3
"""dev/new-dialect makes a dialect that builds, refuses everything by its name, and keeps the rules.

new_dialect.py COMPILER POLICY_TEST WORK            generated into a copy of the project, judged by the rules about
                                                    sources, its sources read by the compiler
new_dialect.py COMPILER POLICY_TEST WORK --build    the copy is built with its tests, which are run
"""
import os
import pathlib
import re
import subprocess
import sys

from copied_tree import build_copy, check_sources, copy_to

# The rules that look at files; the others need the tool that was built from them.
RULES = ("Coverage*:Layers.SourcesKeepThem:Layers.DrawingIsTheTable:Namespaces.ATypeIsDefinedOnce:"
         "Namespaces.AFolderHasOne:Sizes.FilesAreSmall:Names.SayWhatTheyMean:Defaults.NoneOverAnEnumOfOurs:Rows.*:"
         "Leftovers.TestsLeaveNothingBehind:NamedFiles.AreThere")
# A short name and a long one: where lines break depends on it.
NAMES = ("plc6", "sixthdialectofall")


def new_dialect(tree, name):
    return subprocess.run([sys.executable, str(tree / "dev" / "new-dialect"), name], capture_output=True, text=True)


def run_rules(policy_test, tree, rules, faults):
    done = subprocess.run([policy_test, f"--gtest_filter={rules}", "--gtest_brief=1"], capture_output=True, text=True,
                          env={**os.environ, "PLCXX_POLICY_ROOT": str(tree)})
    if done.returncode != 0:
        faults += [line for line in done.stdout.splitlines() if not re.match(r"[A-Z0-9]+-\d{3} |.*: \d+ lines$", line)]
    return done.stdout


def refusals(tree, faults):
    """What is no name, or is taken already, changes nothing and says why."""
    for name, words in (("nc110", "is there already"), ("Sixth", "is no name for a dialect"), ("6th", "is no name")):
        done = new_dialect(tree, name)
        if done.returncode == 0 or words not in done.stderr:
            faults.append(f"new-dialect {name}: exit code {done.returncode}, {done.stderr}")


def generate(tree, faults):
    for name in NAMES:
        done = new_dialect(tree, name)
        if done.returncode != 0:
            faults.append(f"new-dialect {name}: {done.stderr}")
            return
        sources = [str(tree / path) for path in done.stdout.split() if path.endswith((".cc", ".h"))]
        form = subprocess.run(["clang-format-19", "--dry-run", "-Werror", *sources], capture_output=True, text=True)
        if form.returncode != 0 or len(sources) < 20:
            faults.append(f"of {len(sources)} sources some are not formatted: {form.stderr}")
    again = new_dialect(tree, NAMES[0])
    if again.returncode == 0 or "is there already" not in again.stderr:
        faults.append(f"new-dialect {NAMES[0]} a second time: exit code {again.returncode}, {again.stderr}")


def read_sources(compiler, tree, faults):
    sources = ["transpiler/dialects/registry.cc"]
    for name in NAMES:
        sources += sorted(path.relative_to(tree).as_posix()
                          for path in (tree / "transpiler/dialects" / name).rglob("*.cc"))
    said = check_sources(compiler, tree, sources)
    if said:
        faults.append(said)


def build_and_run(compiler, tree, faults):
    fuzz = [f"{name}_parser_fuzz" for name in NAMES]
    said = build_copy(compiler, tree, "plcxx", "policy_test", "dialects_test", *fuzz)
    if said:
        faults.append(said)
        return
    run_rules(str(tree / "build/tests/policy_test"), tree, "*", faults)
    filters = ":".join(f"{name.capitalize()}*" for name in NAMES)
    run_rules(str(tree / "build/tests/dialects_test"), tree, filters, faults)
    commands = [["build/bin/plcxx", "test", *(f"tests/golden/{name}" for name in NAMES)]]
    commands += [[f"build/tests/{name}_parser_fuzz", f"tests/golden/{name}", f"tests/fuzz/{name}_parser"] for name in NAMES]
    for command in commands:
        done = subprocess.run(command, cwd=tree, capture_output=True, text=True)
        if done.returncode != 0:
            faults.append(f"{' '.join(command)}: {done.stdout}{done.stderr}")


def main():
    compiler, policy_test, work = sys.argv[1:4]
    tree = copy_to(pathlib.Path(work))
    faults = []
    refusals(tree, faults)
    generate(tree, faults)
    if not faults:
        shown = run_rules(policy_test, tree, RULES, faults)
        for name in NAMES:
            if f"{name.upper()}-001" not in shown:
                faults.append(f"the checklist of {name} was not looked at")
        read_sources(compiler, tree, faults)
    if not faults and "--build" in sys.argv:
        build_and_run(compiler, tree, faults)
    print("\n".join(faults) if faults else f"{' and '.join(NAMES)} are dialects")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
