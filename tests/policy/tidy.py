#!/usr/bin/env python3
"""Runs clang-tidy over sources with a build's compile commands; exits with 1 when it finds something.

tidy.py BUILD [SOURCE...]     all of transpiler/ when no source is named

A file that was clean is not checked again while the file, the headers of this project that it includes, its compile
command and .clang-tidy are what they were: the marks are in BUILD/tidy.
"""
import concurrent.futures
import hashlib
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
JOBS = 2
INCLUDE = re.compile(rb'^\s*#\s*include\s*["<]((?:transpiler|plcxx|tests)/[^">]+)[">]', re.MULTILINE)


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


def mark_of(source, command, build):
    seen = {}
    add_with_headers(source, seen)
    digest = hashlib.sha256(command.encode())
    for folder in (ROOT, *source.parents):
        if (folder / ".clang-tidy").is_file():
            digest.update((folder / ".clang-tidy").read_bytes())
    for path in sorted(seen):
        digest.update(seen[path])
    return build / "tidy" / (digest.hexdigest() + ".clean")


def check(source, command, build):
    mark = mark_of(source, command, build)
    if mark.exists():
        return ""
    run = subprocess.run(["clang-tidy-19", "-p", str(build), "--quiet", str(source)], capture_output=True, text=True)
    findings = run.stdout
    if run.returncode != 0 and not findings:
        findings = run.stderr
    if run.returncode == 0:
        mark.parent.mkdir(parents=True, exist_ok=True)
        mark.touch()
    return findings


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    commands = {pathlib.Path(entry["file"]): entry["command"]
                for entry in json.loads((build / "compile_commands.json").read_text())}
    sources = [pathlib.Path(name).resolve() for name in sys.argv[2:]]
    if not sources:
        sources = sorted(path for path in commands if path.is_relative_to(ROOT / "transpiler"))
    with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
        findings = list(pool.map(lambda source: check(source, commands.get(source, ""), build), sources))
    failed = 0
    for text in findings:
        if text.strip():
            failed += 1
            print(text)
    print(f"{len(sources)} files, {failed} with findings")
    return 1 if failed or not sources else 0


if __name__ == "__main__":
    sys.exit(main())
