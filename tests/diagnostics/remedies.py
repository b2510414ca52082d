#!/usr/bin/env python3
"""The code inside every help text compiles.

    remedies.py PLCXX EXPLAIN_DIR [-v]

The wrong programs of the explain pages raise their messages; what a message's help gives as code is put into the places
where such code can stand, and must compile without an error in one of them.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

# Where a piece of code can stand; {} is the piece.
SLOTS = {
    "nc110": ["$\n{}\n", "$\nU4A0={}\n", "$\nW4A0={}\n", "$\nU4A0=[W1K0={}]\n", "$\nDOF:I0A0\nU4A0=I0A1\n{}\n",
              "$\nDOF:I0A0\nU4A0=I0A1\nENDF\n{} I0A2\nU4A0=0\nENDE\n", "$\n{}\nU4A0=I0A1\nENDF\n", "{}\n$\n"],
    "host50": ["SLOW\nNETWORK\nLD %I0\nCNUD %C1, 3, {}, M=0, N=0\nEND_SLOW\n",
               "SLOW\nNETWORK\nLD %I0\nTONS %TM1, 5\n{}\nLD %I1\nOUT %Q0\nEND_SLOW\n", "SLOW\nNETWORK\nLD %I0\n{}\nEND_SLOW\n", "SLOW\nNETWORK\nLD %I0\n{} %Q0\nEND_SLOW\n",
               "SLOW\nNETWORK\n{} %I0\nOUT %Q0\nEND_SLOW\n", "SLOW\nNETWORK\nLD %I0\n{} %I1\nOUT %Q0\nEND_SLOW\n",
               "SLOW\nNETWORK\nLD %I0\nMOV {}, %W1\nEND_SLOW\n", "SLOW\nNETWORK\nLD {}\nOUT %Q0\nEND_SLOW\n",
               "SLOW\nNETWORK\nLD %I0\nMOV %W1, {}\nEND_SLOW\n", "SLOW\nNETWORK\nLD %I0\nOUT {}\nEND_SLOW\n",
               "{}\nSLOW\nNETWORK\nLD %I0\nOUT %Q0\nEND_SLOW\n"],
}
BEFORE = {
    "nc110": r"(?:write|compare it:|own:|too:|with H:|is written|close a block with|close it with|close DOF with|digit:)",
    "host50": r"(?:write|such as|as in|from|are the bits)",
}
# Words of a help that stand for what the reader fills in.
PLACEHOLDERS = {
    "nc110": [(r"\ba(?=[<>=])", "W1K0"), (r"(?<=[<>=])b\b", "W1K1"), (r"\bwords\b", "W1K0,W1K1"),
              (r"\bsignals\b", "I0A0,I0A1"), (r"= \.\.\.$", "= I0A0")],
    "host50": [],
}
CODE = {
    "nc110": re.compile(r"[\[\](:=\"]|^[0-9][0-9A-F]*[HDO]?$|^END[A-Z]$|^DOE$"),
    "host50": re.compile(r"^[A-Z]{2,5}$|%[A-Z]+\d|^\$[0-9A-F]+$|\w=\d$"),
}


def programs(folder, dialect):
    for page in sorted(folder.glob("*.md")):
        text = page.read_text()
        if f"```{dialect} file=" in text:
            continue
        for words, program in re.findall(rf"^```{dialect} (wrong[^\n]*)\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
            yield page.stem, re.findall(r"set=(\S+)", words), program


def check(plcxx, folder, dialect, program, settings):
    path = pathlib.Path(folder) / "program.txt"
    path.write_text(program)
    command = [plcxx, "check", str(path), "--dialect", dialect, "--diagnostics", "json"]
    for setting in settings:
        command += ["--set", setting]
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=False).stdout or "[]")


def pieces(dialect, text):
    for match in re.finditer(BEFORE[dialect] + r" '?([^;]*?)'?(?=, | or |; | to | at | behind | in front| for | with | and | between | only| that |: |$)", text):
        piece = match.group(1).strip()
        for pattern, value in PLACEHOLDERS[dialect]:
            piece = re.sub(pattern, value, piece)
        if CODE[dialect].search(piece) and "..." not in piece and "nn=" not in piece:
            yield piece


def main():
    plcxx, explain = sys.argv[1], pathlib.Path(sys.argv[2])
    verbose = "-v" in sys.argv
    faults = tried = 0
    seen = set()
    with tempfile.TemporaryDirectory(prefix="plcxx_remedies_") as folder:
        for dialect, slots in SLOTS.items():
            for page, settings, program in programs(explain, dialect):
                for diagnostic in check(plcxx, folder, dialect, program, settings):
                    for piece in pieces(dialect, diagnostic["help"]):
                        if (dialect, piece) in seen:
                            continue
                        seen.add((dialect, piece))
                        tried += 1
                        works = any(
                            all(other["severity"] != "error"
                                for other in check(plcxx, folder, dialect, slot.format(piece), settings))
                            for slot in slots)
                        faults += not works
                        if verbose or not works:
                            print(f"{'' if works else 'DOES NOT COMPILE: '}{diagnostic['code']} ({page}): "
                                  f"{piece!r} of help '{diagnostic['help']}'", flush=True)
    print(f"{tried} pieces of code, {faults} faults")
    return 1 if faults or not tried else 0


if __name__ == "__main__":
    sys.exit(main())
