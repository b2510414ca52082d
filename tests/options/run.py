#!/usr/bin/env python3
"""Every option of every dialect changes something: a scenario that sets it fails without it.

run.py PLCXX DIRECTORY [KEY...]

The options are those that `plcxx emit --help` lists. Scenarios are those of tests/golden, the current directory: one
that sets the option (in `options:`, or in a line OPTION of its source) passes, and fails when only that is taken away.
What no scenario can show is a row of PROGRAMS: what `plcxx emit` says and writes, or the program itself (`plcxx print
ir`), differs with the option. Exit code 1: an option
has neither, so that nobody knows whether anything uses it.
"""
import collections
import pathlib
import re
import shutil
import subprocess
import sys

# Option: (value, source file, its text). What it changes is in no run of a simulator, but in messages or files.
PROGRAMS = {
    ("nc110", "ladder-lint"): ("on", "a.plc", "$\nU4A0=I0A0*I0A1*I0A2*I0A3*I0A4*I0A5*I0A6*I0A7*I0A8\n"),
    ("nc110", "slice_ms"): ("5", "a.plc", "$\nU4A0=I0A0\n"),
    ("nc110", "stop-on-error"): ("on", "a.plc", "$\nU4A0=\nU4A1=\n"),
    ("prostep", "text-encoding"): ("mazovia", "a.plc", "DM 1 .ŻÓŁW\n:MOD PM 0\n:END PM 0\n"),
}


def project_of_classicladder(rung="1-0-50/0 , 50-0-60/0", expression="0000,@200/0@=1", name="rung_0.csv", sections=1):
    parts = {"sections.csv": "".join(f"00{number},0,-1,0,0,0\n" for number in range(sections)),
             "arithmetic_expressions.csv": f"#VER=2.0\n{expression}\n", name: f"{rung}\n"}
    text = "".join(f"_FILE-{part}\n{lines}_/FILE-{part}\n" for part, lines in parts.items())
    return f"_FILES_CLASSICLADDER\n{text}_/FILES_CLASSICLADDER\n"


def operate(expression):
    return project_of_classicladder(rung="1-0-50/0 , 99-0-0/0 , 99-0-0/0 , 60-0-0/0", expression=f"0000,{expression}")


# Number 5 of each kind: a size of 3 has none.
PROGRAMS.update({("classicladder", key): ("3", "a.clp", text) for key, text in {
    "numRungs": project_of_classicladder(name="rung_5.csv"),
    "numWords": operate("@200/5@:=7"),
    "numTimers": project_of_classicladder(rung="1-0-10/5 , 50-0-60/0"),
    "numMonostables": project_of_classicladder(rung="1-0-20/5 , 50-0-60/0"),
    "numCounters": project_of_classicladder(rung="1-0-25/5 , 50-0-60/0"),
    "numTimersIec": project_of_classicladder(rung="1-0-15/5 , 50-0-60/0"),
    "numPhysInputs": project_of_classicladder(rung="1-0-50/5 , 50-0-60/0"),
    "numPhysOutputs": project_of_classicladder(rung="1-0-50/0 , 50-0-60/5"),
    "numArithmExpr": project_of_classicladder(expression="0005,@200/0@:=1"),
    "numSections": project_of_classicladder(sections=5),
    "numS32in": operate("@200/0@:=@270/5@"),
    "numS32out": operate("@280/5@:=7"),
    "numFloatIn": operate("@200/0@:=@300/5@"),
    "numFloatOut": operate("@310/5@:=7"),
}.items()})
MOST_TRIES = 12


def options(plcxx):
    """(dialect, key) of all."""
    help_text = subprocess.run([plcxx, "emit", "--help"], capture_output=True, text=True).stdout
    table = re.search(r"^Options of the dialects .*\n((?:  .*\n)+)", help_text, re.M).group(1)
    rows = re.sub(r"\n {5,}", " ", table).splitlines()  # a long list goes on in the next line
    return [(row.split()[0], key) for row in rows if row.split()[0] != "all" for key in row.split(maxsplit=1)[1].split(", ")]


def passes(plcxx, scenario):
    run = subprocess.run([plcxx, "test", scenario.name, "--engine", "sim"], cwd=scenario.parent, capture_output=True)
    return run.returncode == 0


def without(text, key):
    """The scenario without the option; None where it does not set it."""
    name = "".join("[-_]" if letter in "-_" else re.escape(letter) for letter in key)
    value = r"""(?:"[^"]*"|'[^']*'|\[[^]]*\]|[^,}\n]*)"""
    line = re.search(r"^options: *\{.*\}.*$", text, re.M)
    if not line:
        return None
    changed = re.sub(rf"(?<=[{{ ,])({name}) *: *{value},? *", "", line.group(0), count=1, flags=re.I)
    if changed == line.group(0):
        return None
    return text.replace(line.group(0), "" if re.fullmatch(r"options: *\{ *\}.*", changed) else changed)


def shows(plcxx, place, folder, scenario, edits):
    """Does the scenario pass, and fail with the edited files?"""
    shutil.rmtree(place, ignore_errors=True)
    shutil.copytree(folder, place / folder.name, ignore=shutil.ignore_patterns("*.cc", "*.ir*"))
    copy = place / folder.name / scenario.name
    if not passes(plcxx, copy):
        return False
    for name, data in edits.items():
        (place / folder.name / name).write_bytes(data)
    return not passes(plcxx, copy)


def candidates(dialect, key):
    """(folder, scenario, edits) for each scenario that sets the option."""
    for scenario in sorted(pathlib.Path(dialect).glob("*/*.yaml")):
        text = scenario.read_bytes().decode("utf-8", "surrogateescape")
        changed = without(text, key)
        if changed is not None:
            yield scenario.parent, scenario, {scenario.name: changed.encode("utf-8", "surrogateescape")}
    for source in sorted(pathlib.Path(dialect).glob("*/*")):
        if source.suffix in (".cc", ".ir") or not source.is_file():
            continue
        data = source.read_bytes()
        changed = re.sub(rb"(?im)^[ \t]*OPTION[ \t]+" + key.encode() + rb"[ \t]*=[^\r\n]*", b"", data)
        scenario = source.with_suffix(".yaml")
        if changed != data and scenario.exists():
            yield source.parent, scenario, {source.name: changed}


def said(plcxx, place, name, extra):
    """What is said, written and made of the program."""
    shutil.rmtree(place / "out", ignore_errors=True)
    emit = subprocess.run([plcxx, "emit", name, "-o", "out", *extra], cwd=place, capture_output=True)
    ir = subprocess.run([plcxx, "print", "ir", name, *extra], cwd=place, capture_output=True)
    files = {path.name: path.read_bytes() for path in (place / "out").glob("*")}
    return emit.returncode, emit.stdout, emit.stderr, ir.stdout, files


def program_differs(plcxx, place, dialect, key):
    if (dialect, key) not in PROGRAMS:
        return False
    value, name, text = PROGRAMS[dialect, key]
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir(parents=True)
    (place / name).write_text(text, encoding="utf-8")
    extra = ["--dialect", dialect]
    return said(plcxx, place, name, extra) != said(plcxx, place, name, [*extra, "--set", f"{key}={value}"])


def main():
    plcxx, place, wanted = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:]
    count, silent = collections.Counter(), []
    for dialect, key in options(plcxx):
        if wanted and key not in wanted:
            continue
        count[dialect] += 1
        if program_differs(plcxx, place, dialect, key):
            continue
        tries = [candidate for _, candidate in zip(range(MOST_TRIES), candidates(dialect, key))]
        if not any(shows(plcxx, place, *candidate) for candidate in tries):
            silent.append(f"{dialect} {key}: {len(tries)} scenarios set it, none fails without it")
    print("\n".join(silent) if silent else "every option changes something: " + ", ".join(
        f"{dialect} {number}" for dialect, number in sorted(count.items())))
    if not count:
        print("no option is listed")
    return 1 if silent or not count else 0


if __name__ == "__main__":
    sys.exit(main())
