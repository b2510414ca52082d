#!/usr/bin/env python3
"""Measures the commands of a review on generated programs of each dialect and prints one table.

    review.py [--plcxx build/bin/plcxx] [--dialect nc110] ... [--statements 10000] [--verified 1000]

Processor seconds of one core, and in brackets how many times that is of transpiling the same program in this run. Columns:
transpiling; `report` (one page of HTML) and its size; `diff` of the program with itself written anew, with one in which ten
statements have another operand, and what it says of the locations: proved alike, different, not decided; `verify` of a
program with --verified statements. The time of `diff` and `verify` is bounded by --time, their own limit.
"""
import argparse
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "locality"))
import bench  # noqa: E402
import edited_programs  # noqa: E402

CHANGED = 10


def language_of(dialect, count):
    if dialect in ("nc110", "hnc"):
        return {"nc110": edited_programs.Nc110, "hnc": edited_programs.Hnc}[dialect](count)
    return (edited_programs.Host50 if dialect == "host50" else edited_programs.Accumulator)(dialect, count)


def with_changes(language, count):
    """The program's text with another operand in count statements."""
    rng = random.Random(count)
    pieces = list(language.pieces())
    places = [at for at, (number, _) in enumerate(pieces) if number is not None]
    left = count
    for at in rng.sample(places, len(places)):
        lines = language.with_other_operand(rng, pieces[at][0])
        if lines is not None and lines != pieces[at][1]:
            pieces[at] = (pieces[at][0], lines)
            left -= 1
        if left == 0:
            break
    return language.join(pieces)


def write_programs(dialect, count, directory):
    """OLD, the same in another file, and NEW with CHANGED statements; their paths."""
    language = language_of(dialect, count)
    paths = [directory / f"{name}{count}" / f"program.{language.extension}" for name in ("old", "same", "new")]
    text = language.join(list(language.pieces()))
    for path, content in zip(paths, (text, text, with_changes(language, CHANGED))):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content)
    return paths


def run(command, directory, allowed=(0,)):
    """Processor seconds and what was printed, messages last."""
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as errors:
        process = subprocess.Popen(list(map(str, command)), cwd=directory, stdout=out, stderr=errors)
        _, status, usage = os.wait4(process.pid, 0)
        out.seek(0)
        errors.seek(0)
        if os.waitstatus_to_exitcode(status) not in allowed:
            sys.exit(f"failed: {' '.join(map(str, command))}\n{errors.read()[:2000]}")
        return usage.ru_utime + usage.ru_stime, out.read() + errors.read()


def verdicts_of(text):
    counts = {}
    answer, _ = json.JSONDecoder().raw_decode(text)
    counts = {"proved": answer["equal"]}
    for item in answer["items"]:
        counts[item["verdict"]] = counts.get(item["verdict"], 0) + 1
    return ", ".join(f"{verdict} {count}" for verdict, count in sorted(counts.items()))


def measure(plcxx, dialect, options, base):
    base = base / dialect
    old, same, new = write_programs(dialect, options.statements, base)
    quiet = [f"-Wno-{name}" for name in bench.QUIET[dialect]]
    common = [*quiet, "--dialect", dialect]
    emit, _ = run([plcxx, "emit", *common, old, "-o", base / "out"], base)
    report, _ = run([plcxx, "report", *common, old, "-o", base], base)
    page = (base / "program.html").stat().st_size
    limit = f"--time={options.time}s"
    alike, _ = run([plcxx, "diff", *common, limit, old, same], base)
    changed, answer = run([plcxx, "diff", *common, limit, "--format", "json", old, new], base, allowed=(0, 1))
    verified, *_ = write_programs(dialect, options.verified, base)
    verify, certificate = run([plcxx, "verify", *common, limit, verified], base, allowed=(0, 1))

    def ratio(seconds):
        return f"{seconds:.2f} s ({seconds / emit:.0f})"

    return {
        "dialect": dialect, "statements": options.statements, "transpile": f"{emit:.2f} s", "report": ratio(report),
        "page": f"{page / 1e6:.1f} MB", "diff, same": ratio(alike), "diff, 10 changed": ratio(changed),
        "of it": verdicts_of(answer), f"verify {options.verified}": f"{verify:.1f} s",
        "proved": f"{certificate.count(': proved')}",
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plcxx", default=str(bench.ROOT / "build/bin/plcxx"))
    parser.add_argument("--dialect", action="append", choices=list(bench.QUIET), help="only these")
    parser.add_argument("--statements", type=int, default=10_000)
    parser.add_argument("--verified", type=int, default=1_000)
    parser.add_argument("--time", type=int, default=60, help="limit of one diff or verify in seconds")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as base:
        for dialect in options.dialect or list(bench.QUIET):
            bench.print_row(measure(pathlib.Path(options.plcxx).resolve(), dialect, options, pathlib.Path(base)))


if __name__ == "__main__":
    main()
