#!/usr/bin/env python3
"""Typical slips of people who know other languages: each gets these messages, at these places, and no others.

    slips.py PLCXX DIRECTORY [-v]

A file of the directory is named as its dialect. It holds programs, each behind a line `## what it shows`, and behind a
program what `plcxx check` must say of it, a message a line, in order:

    => 2:12 nc110-19 | comparison sign | write /[W1K0<3]

The words behind the bars stand in the message or its remedy. `=> nothing`: no error and no warning. -v prints what is said.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile


def cases(text):
    for block in re.split(r"^## ", text, flags=re.MULTILINE)[1:]:
        title, _, rest = block.partition("\n")
        program, expected = [], []
        for line in rest.rstrip("\n").split("\n"):
            (expected if line.startswith("=> ") else program).append(line)
        while program and not program[-1]:
            program.pop()
        yield title, "\n".join(program) + "\n", [line[3:] for line in expected if line != "=> nothing"]


def messages(plcxx, folder, dialect, program):
    path = pathlib.Path(folder) / "program.txt"
    path.write_text(program)
    command = [plcxx, "check", str(path), "--dialect", dialect, "--diagnostics", "json"]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode not in (0, 1):
        return [{"line": 0, "column": 0, "code": "exit", "message": result.stderr, "help": ""}]
    return json.loads(result.stdout or "[]")


def main():
    plcxx, directory = sys.argv[1], pathlib.Path(sys.argv[2])
    verbose = "-v" in sys.argv
    failures = count = 0
    with tempfile.TemporaryDirectory() as folder:
        for file in sorted(directory.iterdir()):
            for title, program, expected in cases(file.read_text()):
                count += 1
                said = [(f"{m['line']}:{m['column']} {m['code']}", m["message"] + "\n" + m.get("help", ""))
                        for m in messages(plcxx, folder, file.stem, program)]
                wanted = [line.split(" | ") for line in expected]
                right = len(said) == len(wanted) and all(
                    place == words[0] and all(word in text for word in words[1:])
                    for (place, text), words in zip(said, wanted))
                if not right or verbose:
                    print(f"{file.name}: {title}")
                    for place, text in said:
                        print(f"  {place} | " + text.replace("\n", " | "))
                if not right:
                    failures += 1
                    print("  expected:", *expected, sep="\n    ")
    print(f"{count} programs, {failures} wrong")
    return 1 if failures or count < 50 else 0


if __name__ == "__main__":
    sys.exit(main())
