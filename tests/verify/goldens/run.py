#!/usr/bin/env python3
"""Which programs of tests/golden `plcxx verify` proves, and why it does not prove the others.

run.py PLCXX DIALECT... [--target T] [--time 20s] [--only TEXT] [--loops] [--every N] [--jobs N] [--expect TABLE]

Each scenario of tests/golden/DIALECT is one program with its options; those whose program is refused are left out.
--loops takes those alone whose generated C++ has a loop; --every each N-th of them. With a table of expectations, the
programs of the table are verified (and no others), and the exit code is 1 where one is not as the table says.
"""
import argparse
import collections
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile
import time

GOLDEN = pathlib.Path(__file__).resolve().parent.parent.parent / "golden"
LOOP = re.compile(r"^\s*(for|while|do)\b", re.MULTILINE)


def field(text, name, brackets):
    """The words of `name: [a, b]` or `name: {a: b}` at the beginning of a line."""
    found = re.search(rf"^{name}: *{re.escape(brackets[0])}(.*?){re.escape(brackets[1])}", text, re.MULTILINE | re.DOTALL)
    words = re.findall(r"""(?:"[^"]*"|'[^']*'|[^,"'])+""", found.group(1)) if found else []
    return [word.strip().strip("'\"") for word in words if word.strip()]


def program_of(scenario):
    """The words of the command line; none: the program is to be refused."""
    text = scenario.read_text(errors="replace")
    if re.search(r"^expect_error", text, re.MULTILINE):
        return None
    words = []
    dialect = re.search(r"^dialect: *(\w+)", text, re.MULTILINE)
    if dialect:
        words += ["--dialect", dialect.group(1)]
    for option in field(text, "options", "{}"):
        key, value = option.split(":", 1)
        words += ["--set", f"{key.strip()}={value.strip().strip(chr(34)).strip(chr(39))}"]
    sources = field(text, "sources", "[]")
    return words + sources if sources else None


def run(words, folder, seconds):
    try:
        return subprocess.run(words, cwd=folder, capture_output=True, text=True, errors="replace", timeout=seconds)
    except subprocess.TimeoutExpired:
        return None


def proofs_of(said):
    """Without the warnings in front and what is proved."""
    lines = said[max(0, said.find(": not proved")) :].splitlines()
    return "\n".join(line for line in lines[1:] if ": proved (" not in line) if len(lines) > 1 else said


def has_loop(plcxx, words, folder):
    with tempfile.TemporaryDirectory() as into:
        emitted = run([plcxx, "emit", "--quiet", "--name", "program", "-o", into, *words], folder, 60)
        if emitted is None or emitted.returncode != 0:
            return None
        return any(LOOP.search(path.read_text()) for path in pathlib.Path(into).glob("*.cpp"))


def verify(plcxx, scenario, options):
    """(result, detail, seconds); the result is none for a program that is not asked about."""
    words, folder = program_of(scenario), scenario.parent
    if words is None:
        return None
    if options.loops and not has_loop(plcxx, words, folder):
        return None
    began = time.monotonic()
    ran = run([plcxx, "verify", "--name", "program", "--time", options.time, "--target", options.target, *words], folder, 600)
    took = time.monotonic() - began
    if ran is None:
        return "not decided", "no end within 10 min", took
    said = ran.stdout + ran.stderr
    if ran.returncode == 0:
        return "proved", "", took
    if "not decided" in said:
        return "not decided", said.strip(), took
    return ("different" if "differ" in said else "refused"), said.strip(), took


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("plcxx")
    parser.add_argument("dialects", nargs="*")
    parser.add_argument("--time", default="20s")
    parser.add_argument("--target", default="host")
    parser.add_argument("--only", default="")
    parser.add_argument("--loops", action="store_true")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--expect", type=pathlib.Path)
    options = parser.parse_args()
    expected = {}
    if options.expect:
        for line in options.expect.read_text().splitlines():
            if line.strip() and not line.startswith("#"):
                name, result = line.split(None, 1)
                expected[name] = result.strip()
        scenarios = [GOLDEN / f"{name}.yaml" for name in expected]
    else:
        scenarios = [path for dialect in options.dialects for path in sorted((GOLDEN / dialect).rglob("*.yaml"))]
        scenarios = [path for path in scenarios if options.only in str(path)][:: options.every]
    counts, wrong = collections.Counter(), []
    plcxx = str(pathlib.Path(options.plcxx).resolve())
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for scenario, got in zip(scenarios, pool.map(lambda path: verify(plcxx, path, options), scenarios)):
            name = str(scenario.relative_to(GOLDEN).with_suffix(""))
            if got is None:
                if name in expected:
                    wrong.append(f"{name}: there is no such program")
                continue
            result, detail, took = got
            counts[result] += 1
            if name in expected and result != expected[name]:
                wrong.append(f"{name}: {result}, not {expected[name]}\n{detail}")
            if not options.expect and result != "proved":
                print(f"== {name}: {result} ({took:.1f} s)\n{proofs_of(detail)[:700]}", flush=True)
            elif not options.expect and took > 10:
                print(f"== {name}: {result} ({took:.1f} s)", flush=True)
    for result in sorted(counts):
        print(f"{result}: {counts[result]}")
    for text in wrong:
        print("WRONG", text)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
