#!/usr/bin/env python3
"""Runs clang-tidy over sources with a build's compile commands; exits with 1 when it finds something.

tidy.py BUILD [SOURCE...]     all of transpiler/ when no source is named
tidy.py BUILD --changed       what changed in transpiler/ and runtime_support/ since the commit in tidy_clean.txt, at
                              which all was clean: a changed header counts by one source that includes it. All, where
                              the rules changed or this clone does not have that commit
tidy.py BUILD --record        all; when they are clean, the commit is written into tidy_clean.txt

Files that the build compiles together are checked together, which takes a fifth of the time. What was clean is not
checked again while the files, the headers of this project that they include, the compile command and the rules are what
they were: the marks are in BUILD/tidy.
"""
import concurrent.futures
import dataclasses
import hashlib
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
JOBS = 2
CLEAN = pathlib.Path(__file__).resolve().parent / "tidy_clean.txt"
INCLUDE = re.compile(rb'^\s*#\s*include\s*["<]((?:transpiler|plcxx|tests)/[^">]+)[">]', re.MULTILINE)
MEMBER = re.compile(r'^#include "(.+)"$', re.MULTILINE)


@dataclasses.dataclass(frozen=True)
class Unit:
    """What one run of clang-tidy looks at: a file, or the files that the build compiles as one."""
    file: pathlib.Path
    members: tuple  # the sources of this project; the file itself, or those that it includes
    command: str


def units_of(build):
    units = []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = pathlib.Path(entry["file"])
        members = (file,)
        if file.parent.name == "Unity":
            members = tuple(pathlib.Path(name) for name in MEMBER.findall(file.read_text()))
        units.append(Unit(file, members, entry["command"]))
    return units


def resolve(include):
    for folder in (ROOT, ROOT / "runtime_support"):
        if (folder / include).is_file():
            return folder / include
    return None


def add_with_headers(path, seen):
    if path in seen:
        return
    text = path.read_bytes()
    seen[path] = text
    for include in INCLUDE.findall(text):
        header = resolve(include.decode())
        if header:
            add_with_headers(header, seen)


def rules_of(source, build):
    """The rules of the source's folder: clang-tidy looks for them around the file that it is given."""
    rules = subprocess.run(["clang-tidy-19", "-p", str(build), "--dump-config", str(source)], capture_output=True,
                           text=True, check=True).stdout
    # What it shows of these, it does not take itself.
    return "\n".join(line for line in rules.splitlines() if "HungarianPrefix" not in line)


def mark_of(unit, rules, build):
    seen = {}
    for member in unit.members:
        add_with_headers(member, seen)
    digest = hashlib.sha256((unit.command + rules).encode())
    for path in sorted(seen):
        digest.update(seen[path])
    return build / "tidy" / (digest.hexdigest() + ".clean")


def check(unit, build):
    rules = rules_of(unit.members[0], build)
    mark = mark_of(unit, rules, build)
    if mark.exists():
        return ""
    # What holds several files includes them.
    run = subprocess.run(["clang-tidy-19", "-p", str(build), "--quiet", f"--config={rules}",
                          "--checks=-bugprone-suspicious-include", str(unit.file)], capture_output=True, text=True)
    findings = run.stdout
    if run.returncode != 0 and not findings:
        findings = run.stderr
    if run.returncode == 0:
        mark.parent.mkdir(parents=True, exist_ok=True)
        mark.touch()
    return findings


def git(*arguments):
    run = subprocess.run(["git", "-c", f"safe.directory={ROOT}", *arguments], cwd=ROOT, capture_output=True, text=True)
    return run.stdout if run.returncode == 0 else None


def without_includes(text):
    return [line for line in text.split("\n") if not line.startswith("#include")]


def is_what_it_was(commit, old, new):
    """Did a file only move, or names of files that it includes change? No rule looks at either."""
    before = git("show", f"{commit}:{old}")
    return before is not None and without_includes(before) == without_includes((ROOT / new).read_text())


def changed_since_clean():
    """None: not known."""
    commit = CLEAN.read_text().strip()
    edited = git("diff", "--find-renames", "--diff-filter=d", "--name-status", commit)
    added = git("ls-files", "--others", "--exclude-standard")
    if edited is None or added is None:
        return None
    names = set(added.splitlines())
    for state, *paths in (line.split("\t") for line in edited.splitlines()):
        old, new = paths[0], paths[-1]
        is_code = new.startswith(("transpiler/", "runtime_support/")) and new.endswith((".cc", ".h", ".def", ".clang-tidy"))
        if not is_code or (state != "A" and is_what_it_was(commit, old, new)):
            continue
        names.add(new)
    if any(name.endswith(".clang-tidy") for name in names) or git("diff", "--name-only", commit, "--", ".clang-tidy"):
        return None
    return {ROOT / name for name in names}


def units_of_changed(units, changed):
    """The units that show the changed files: those that they are in; for headers one each, one of these if possible."""
    found = [unit for unit in units if changed.intersection(unit.members)]
    includes = {}

    def includes_of(unit):
        if unit not in includes:
            seen = {}
            for member in unit.members:
                add_with_headers(member, seen)
            includes[unit] = seen.keys()
        return includes[unit]

    for header in sorted(path for path in changed if path.suffix in (".h", ".def")):
        near = sorted(units, key=lambda unit: (unit not in found, header.parent not in unit.members[0].parents, unit.file))
        shows = next((unit for unit in near if header in includes_of(unit)), None)
        if shows and shows not in found:
            found.append(shows)
    return found


def chosen(units, names):
    if not names or names[0].startswith("--"):
        everything = sorted((unit for unit in units if unit.members[0].is_relative_to(ROOT / "transpiler")),
                            key=lambda unit: unit.file)
        changed = changed_since_clean() if names == ["--changed"] else None
        return everything if changed is None else units_of_changed(everything, changed)
    found = []
    for name in names:
        source = pathlib.Path(name).resolve()
        having = [unit for unit in units if source in unit.members]
        for unit in having or [Unit(source, (source,), "")]:
            if unit not in found:
                found.append(unit)
    return found


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    units = chosen(units_of(build), sys.argv[2:])
    with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
        findings = list(pool.map(lambda unit: check(unit, build), units))
    failed = sum(1 for text in findings if text.strip())
    for text in findings:
        if text.strip():
            print(text)
    files = sum(len(unit.members) for unit in units)
    print(f"{files} files, {failed} of {len(units)} runs with findings")
    if sys.argv[2:] == ["--record"] and not failed:
        CLEAN.write_text(git("rev-parse", "HEAD"))
    return 1 if failed or not (units or sys.argv[2:] == ["--changed"]) else 0


if __name__ == "__main__":
    sys.exit(main())
