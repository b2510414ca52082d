#!/usr/bin/env python3
"""dev/affected names tests and targets that there are: for each file of the project, by a build directory.

affected.py BUILD
"""
import importlib.machinery
import importlib.util
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True  # the source tree stays clean


def load():
    loader = importlib.machinery.SourceFileLoader("affected", str(ROOT / "dev" / "affected"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("affected", loader))
    loader.exec_module(module)
    return module


def files():
    for folder in ("cmake", "dev", "docs", "grammars", "runtime_support", "samples", "tests", "transpiler"):
        for path in (ROOT / folder).rglob("*"):
            if path.is_file():
                yield path.relative_to(ROOT).as_posix()


def main():
    build = pathlib.Path(sys.argv[1])
    shown = subprocess.run(["ctest", "--test-dir", str(build), "--show-only=json-v1"], check=True, capture_output=True,
                           text=True).stdout
    entries = [test["name"] for test in json.loads(shown[shown.index("{"):])["tests"]]
    listed = subprocess.run(["ninja", "-C", str(build), "-t", "targets", "all"], check=True, capture_output=True,
                            text=True).stdout
    targets = {line.split(":")[0] for line in listed.splitlines()}
    affected = load()
    chosen = {}
    for name in sorted(files()):
        built, run = affected.choose([name])
        chosen.setdefault((tuple(built), tuple(run)), name)
    faults = []
    for (built, run), name in chosen.items():
        faults += [f"{name}: no target '{target}'" for target in built if target not in targets]
        faults += [f"{name}: no test is '{pattern}'" for pattern in run
                   if not any(re.fullmatch(pattern, entry) for entry in entries)]
    print("\n".join(faults) if faults else f"{len(chosen)} kinds of files have their tests")
    return 1 if faults or not chosen else 0


if __name__ == "__main__":
    sys.exit(main())
