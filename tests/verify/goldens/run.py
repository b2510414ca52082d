#!/usr/bin/env python3
"""Which programs of tests/golden `plcxx verify` proves, and why it does not prove the others.

run.py PLCXX DIALECT... [--target T] [--time 20s] [--only TEXT] [--loops] [--every N] [--jobs N] [--expect TABLE | --all]

Each scenario of tests/golden/DIALECT is one program with its options; those whose program is refused are left out, and
scenarios of one program with the same options count once. --loops takes those alone whose generated C++ has a loop;
--every each N-th of them. With a table of expectations, the programs of the table are verified (and no others), and the
exit code is 1 where one is not as the table says. With --all it is 1 where a program is different, where plcxx ends
with a fault of its own, and where fewer than nine in ten are proved. At its end it prints a table by dialect and reason.
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
LEAST_PROVED = 0.9
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
        key, value = (part.strip().strip("'\"") for part in option.split(":", 1))
        words += ["--encoding", value] if key == "encoding" else ["--set", f"{key}={value}"]
    if re.search(r"^sources: *$", text, re.MULTILINE):
        return [scenario.name]  # the program and its options are written in it
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


def reason_of(said):
    """Why a program is not proved, without what is its own: names and numbers."""
    lines = [line for line in said.splitlines() if re.search(r": (not decided: |different$|not verified: )", line)]
    causes = [line for line in lines if "all is proved but" not in line] or lines or said.splitlines()[-1:]
    text = re.sub(r"^.*?: (not decided|not verified): ", "", causes[0]) if causes else ""
    text = re.sub(r"\bloop \d+ \([^)]*\)", "a loop", text)
    text = re.sub(r"not within the time: .*", "not within the time", text)
    text = re.sub(r"(no numbers show a difference, and no proof that there are none): .*", r"\1", text)
    text = re.sub(r"\bloop \d+ ", "a loop ", re.sub(r"(?<=: )[\w:]*::\w+, [\w.]+|\d{6,}", "...", text))
    return text.strip()


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
    ran = run([plcxx, "verify", "--name", "program", "--time", options.time, "-j1", "--target", options.target, *words], folder, 600)
    took = time.monotonic() - began
    if ran is None:
        return "not decided", "no end within 10 min", took
    said = ran.stdout + ran.stderr
    if ran.returncode == 0:
        return "proved", "", took
    if ran.returncode not in (0, 1):
        return "broken", f"exit code {ran.returncode}\n" + said.strip()[-2000:], took
    if "not decided" in said:
        return "not decided", said.strip(), took
    return ("different" if re.search(r": different$", said, re.MULTILINE) else "refused"), said.strip(), took


def table(reasons):
    """Of how many programs of a dialect what is so."""
    dialects = sorted({dialect for dialect, _, _ in reasons})
    rows = collections.Counter()
    for (_, result, reason), count in reasons.items():
        rows[result, reason] += count
    print("\n| result | reason | " + " | ".join(dialects) + " |\n|---|---|" + "---|" * len(dialects))
    for result, reason in sorted(rows, key=lambda row: (row[0] != "proved", -rows[row])):
        counts = [str(reasons.get((dialect, result, reason), "")) for dialect in dialects]
        print(f"| {result} | {reason} | " + " | ".join(counts) + " |")


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
    parser.add_argument("--all", action="store_true")
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
        programs = {}
        for path in scenarios:
            programs.setdefault((path.parent, tuple(program_of(path) or [])), path)
        scenarios = [path for path in programs.values() if options.only in str(path)][:: options.every]
    counts, reasons, wrong = collections.Counter(), collections.Counter(), []
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
            reason = "" if result in ("proved", "different", "broken") else reason_of(detail)
            reasons[name.split("/")[0], result, reason] += 1
            if options.all and result in ("different", "broken"):
                wrong.append(f"{name}: {result}\n{detail}")
            if name in expected and result != expected[name]:
                wrong.append(f"{name}: {result}, not {expected[name]}\n{detail}")
            if not options.expect and result != "proved":
                print(f"== {name}: {result} ({took:.1f} s)\n{proofs_of(detail)[:700]}", flush=True)
            elif not options.expect and took > 10:
                print(f"== {name}: {result} ({took:.1f} s)", flush=True)
    for result in sorted(counts):
        print(f"{result}: {counts[result]}")
    if not options.expect:
        table(reasons)
    if options.all and counts["proved"] < LEAST_PROVED * max(1, sum(counts.values())):
        wrong.append(f"only {counts['proved']} of {sum(counts.values())} are proved")
    for text in wrong:
        print("WRONG", text)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
