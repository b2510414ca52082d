#!/usr/bin/env python3
"""The code inside every help text compiles.

    remedies.py PLCXX EXPLAIN_DIR [-v] [DIALECT...]

The wrong programs of the explain pages raise their messages; what a message's help gives as code is put into the places
where such code can stand, and must compile without an error in one of them.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

TECHNOL = " DATA\nF: DFM A,B,Q\nN: DS 2\n DATA_END\n MODULE_MAIN\n@\n MODULE_MAIN_END\n STOP\n"
HNC = ('#include "plc.h"\nint n, a, b, c;\ndouble d;\nvoid init(void) {{ plc1_time = 8; plc2_time = 16; }}\nvoid plc2(void) {{}}\n'
       "void plc1(void) {{\n@\n}}\n")
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
    "prostep": [":MOD PM 9\n{}\n:END PM 9\n", ":MOD PM 9\n:A I 0.0\n:{}\n:END PM 9\n", ":MOD PM 9\n:{}\n:= O 0.0\n:END PM 9\n",
                ":MOD PM 9\n:A {}\n:= O 0.0\n:END PM 9\n", ":MOD PM 9\n:{}\n:A I 0.0\n:)\n:= O 0.0\n:END PM 9\n",
                ":MOD PM 9\n:A(\n:A I 0.0\n:{}\n:= O 0.0\n:END PM 9\n", ":MOD PM 9\n:L IB 30\n:!=\n: K {}\n:= O 0.0\n:END PM 9\n",
                ":MOD PM 9\n:L {}\n:T OB 3\n:END PM 9\n", "{} 4\n:MOD PM 9\n:A I 0.0\n:= O 0.0\n:END PM 9\n",
                "{}\n:A I 0.0\n:= O 0.0\n:END PM 9\n", ":MOD PM 9\n:A I 0.0\n:= O 0.0\n{}\n",
                "{}\n:MOD PM 9\n:A I 0.0\n:= O 0.0\n:END PM 9\n", ":MOD PM 9\n:A I 0.0\n:= O 0.0\n:END PM 9\n{}\n:END PM 20\n"],
    "technol": [TECHNOL.replace("@", " {}"), TECHNOL.replace("@", " LDR {}\n WR Q"), TECHNOL.replace("@", " LOD {}\n STO N"),
                TECHNOL.replace("@", " LDR A\n {} 1,Q"), TECHNOL.replace("@", " MOV AX,{}\n MOV N,AX"), TECHNOL.replace("@", " LDR A\n {}\n"),
                TECHNOL.replace("@", " MECH_BEGIN M\n EX\n {}\n"), TECHNOL.replace("@", " MOV {} LABEL_MEM,5"), TECHNOL.replace("@", " {} N\n STO N"), TECHNOL.replace("DS 2", "DS 4").replace("@", " LOD {}N\n STO N"),
                "OFS EQU 5\n" + TECHNOL.replace("@", " LOD {}\n STO N"), TECHNOL.replace("@", " MECH_BEGIN M1\n EX\n {}\n"),
                TECHNOL.replace("@", " MECH_BEGIN M\n EX\n {}\n MECH_END M\n"), TECHNOL.replace("@", " LOD {}N\n STO N"),
                "NASTROJ STRUC\nCISLO DW ?\n{}\n" + TECHNOL.replace("@", ""), TECHNOL.replace("@", " CALL P").replace(" STOP", "P: LDR A\n WR Q\n {}\n STOP"),
                TECHNOL.replace("@", " MOV AX,N{}\n"), TECHNOL.replace(" DATA\n", " DATA\nX: DS {}\n").replace("@", "")],
    "hnc": [HNC.replace("@", "{};"), HNC.replace("@", "{}"), HNC.replace("@", "n = {};"), HNC.replace("@", "Y[1] = {};"), HNC.replace("@", "{} x = 1; Y[1] = x;"),
            HNC.replace("@", "switch (n) {{ case 1: n = 2; {}; case 2: n = 3; }}"), HNC.replace("@", "switch (n) {{ case 1: n = 2; {}\n case 2: n = 3; }}"),
            HNC.replace("@", "if ({}) n = 1;"), HNC.replace("@", "if (n {} 1) n = 2;"), HNC.replace("@", "n = {}F_i[1];"),
            HNC.replace("@", "int i; for (i = X[0]; i != 3; i = X[1]) n++;").replace("int i; for", "int i;\n{}\nfor"), HNC.replace("@", "int i; {}\n for (i = X[0]; i != 3; i = X[1]) n++;"),
            "{}\n" + HNC.replace("@", ""), HNC.replace("@", "int i; for (i = 0; i < 3; i++) {}"), HNC.replace("@", "n = {}(n);"),
            "#include <stdlib.h>\n#include <string.h>\n#include <math.h>\n" + HNC.replace("@", "d = {}(d);")],
}
BEFORE = {
    "nc110": r"(?:write|compare it:|own:|too:|with H:|is written|close a block with|close it with|close DOF with|digit:)",
    "host50": r"(?:write|such as|as in|from|are the bits)",
    "prostep": r"(?:write|such as|as in|with|hexadecimal|BCD|decimal|use|remove it or open the bracket with|or)",
    "technol": r"(?:write|such as|as in|in front:|or|a bit:)",
    "hnc": r"(?:write|such as|as in|in front:|it:|compare the result:|parentheses:|or|says|to set it)",
}
# Words of a help that stand for what the reader fills in.
PLACEHOLDERS = {
    "nc110": [(r"\ba(?=[<>=])", "W1K0"), (r"(?<=[<>=])b\b", "W1K1"), (r"\bwords\b", "W1K0,W1K1"),
              (r"\bsignals\b", "I0A0,I0A1"), (r"= \.\.\.$", "= I0A0")],
    "host50": [],
    "prostep": [(r"\bn\b", "20")],
    "technol": [],
    "hnc": [(r"\bN\b", "10"), (r"\.\.\d+", ""), (r"\b0\.\.3\b", "0")],
}
CODE = {
    "nc110": re.compile(r"[\[\](:=\"]|^[0-9][0-9A-F]*[HDO]?$|^END[A-Z]$|^DOE$"),
    "host50": re.compile(r"^[A-Z]{2,5}$|%[A-Z]+\d|^\$[0-9A-F]+$|\w=\d$"),
    "prostep": re.compile(r"^:|^[A-Z]{1,3} \d|^0?[0-9A-F]+[DH]$|^[AO]\($|^\)$|^DD[BWD] "),
    "technol": re.compile(r"^[A-Z_]{2,}[. ]?[\w.,']*$|\[|^\d+[DHhbq]?$|^[0-9A-F]+h$|^CNST\."),
    "hnc": re.compile(r"[()=\[\]{}#;*]|^[a-z]{2,6}$|^unsigned"),
}
# What looks like code in a help and is none: a word of English, or a form with letters for what the reader knows.
PROSE = {
    "nc110": re.compile(r"$^"),
    "host50": re.compile(r"$^"),
    "prostep": re.compile(r"$^"),
    "technol": re.compile(r"^(?:PLC|TCH|ASCII|DATA)$|^\$TCH"),
    "hnc": re.compile(r"^--set|^0\)|^set_mst_func\(0$|^(?:switch|union|it|them|the|one|two|more|less|asm|function|type|member|cast|block)\b|\bf\(int\)|\bfunction\b"),
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
        piece = match.group(1).strip().removeprefix("write ")
        for pattern, value in PLACEHOLDERS[dialect]:
            piece = re.sub(pattern, value, piece)
        if PROSE[dialect].search(piece):
            continue
        if CODE[dialect].search(piece) and "..." not in piece and "nn=" not in piece:
            yield piece


def main():
    plcxx, explain = sys.argv[1], pathlib.Path(sys.argv[2])
    verbose = "-v" in sys.argv
    only = [word for word in sys.argv[3:] if word in SLOTS]
    faults = tried = 0
    seen = set()
    with tempfile.TemporaryDirectory(prefix="plcxx_remedies_") as folder:
        for dialect, slots in SLOTS.items():
            if only and dialect not in only:
                continue
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
