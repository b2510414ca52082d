#!/usr/bin/env python3
"""Whatever names a program, its symbols and its files have, the generated C++ compiles, and every name is its own.

    exported_names.py PLCXX INCLUDE_DIR [--heavy]

Names that C++, its macros, the generated code or the system take; names that become the same one when their characters are
made safe; names in other scripts. As symbols, cells, functions and modules of each language, as file name and as --name;
in several files, in one, in parts; with GCC and Clang; behind the system's headers, whose macros have most names.
"""
import collections
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# Of C++, of macros of usual headers, of the generated code and its runtime.
WORDS = ("int new delete class this bool true false union register operator and or xor not export import module concept final "
         "override asm typeof main std plcxx EOF errno NULL BUFSIZ stdin assert major minor makedev linux unix i386 TRUE FALSE ERROR IN OUT "
         "min max abs INT_MAX INT8_MAX UINT8_C SIZE_MAX CHAR_BIT RAND_MAX M_PI NAN INFINITY HUGE_VAL DOMAIN OVERFLOW signbit isnan "
         "SIGINT SIGTERM SIG_DFL offsetof va_list uint8_t int32_t int_fast8_t size_t st_atime st_mtime sa_handler si_pid P_ALL PRIu8 "
         "State Host Retentive Bit Byte Word16 Float32 m host init fast slow period slice round copy layout At t1 t100 round2 io now "
         "messages menu_texts retentive Clear Input Output Timer Counter Edge Space memory scan value tick cycle OnDelay Add8 "
         "now_ms read_inputs write_outputs retentive_store PM0 PM9 kValues kSymbols I O B W X Y R F G P D T C EAX S "
         "E A_b a_B Ab aB _x x_ __x x__y 1st 0 9 a.b a_b a-b a@b a_atb a#b a_nob a'b a_qb a?b a_isb a+b").split()
SCRIPTS = ["пила", "пила_", "насос", "НАСОС", "锯", "泵", "żółw", "Übung", "čerpadlo", "é"]
SYSTEM = "".join(f"#include <{name}>\n" for name in (
    "assert.h ctype.h errno.h float.h inttypes.h limits.h locale.h math.h setjmp.h signal.h stdarg.h stddef.h stdint.h stdio.h stdlib.h "
    "string.h time.h wchar.h fcntl.h unistd.h pthread.h sched.h poll.h dirent.h sys/types.h sys/stat.h sys/time.h sys/wait.h sys/mman.h sys/sysmacros.h "
    "cmath algorithm string").split())
FLAVOURS = ([], ["--single-file"], ["--parts", "3"], ["--debug"])
COMPILERS = ("g++", "clang++-19")
PIECES = 16


def nc110(names):
    rows = [f"{name}=U{4 + i // 32}A{i % 32}" for i, name in enumerate(names)]
    return {"p.sym": "*\n" + "\n".join(rows) + "\n",
            "p.plc": "$\n" + "".join(f"U{4 + i // 32}A{i % 32}=I0A0\n" for i in range(len(names)))}


def host50(names):
    rows = "".join(f"%B{100 + i} '{name}'\n" for i, name in enumerate(names))
    return {"p.il": f"SYMBOLS\n{rows}END_SYMBOLS\nSLOW\n" +
                    "".join(f"NETWORK\nLD %I0\nOUT %B{100 + i}\n" for i in range(len(names))) + "END_SLOW\n"}


def prostep(names):
    return {"p.plc": ":MOD PM 9\n" + "".join(f":A I {i // 8 % 64}.{i % 8} {name}\n:= O {i // 8 % 64}.{i % 8} {name}\n" for i, name in enumerate(names)) +
                     ":END PM 9\n"}


def technol(names):
    cells = "".join(f"{name}: DS 2\n" for name in names)
    uses = "".join(f" LOD {name}\n AD CNST.1\n STO {name}\n" for name in names)
    parts = "".join(f" MODULE_{name}\n LOD CNST.1\n MODULE_{name}_END\n" for name in names)
    return {"p.plc": f" DATA\n{cells} DATA_END\n MODULE_MAIN\n{uses} MODULE_MAIN_END\n{parts} STOP\n"}


def technol_code(names):
    mechanisms = "".join(f" MECH_BEGIN {name}\n EX\n LOD CNST.1\n MECH_END {name}\n" for name in names[::2])
    calls = "".join(f" CALL {name}\n" for name in names[1::2])
    subs = "".join(f"{name}: LOD CNST.2\n STO N\n RET\n" for name in names[1::2])
    return {"p.plc": f" DATA\nN: DS 2\n DATA_END\n MODULE_MAIN\n{mechanisms}{calls} MODULE_MAIN_END\n{subs} STOP\n"}


def hnc(names):
    return {"p.cld": '#include "plc.h"\n' + "".join(f"int {name};\n" for name in names) +
                     "void init(void) { plc1_time = 8; plc2_time = 16; }\nvoid plc2(void) {}\nvoid plc1(void) {\n" +
                     "".join(f"{name}++;\n" for name in names) + "}\n"}


def hnc_code(names):
    return {"p.cld": '#include "plc.h"\n' + "".join(f"struct {{ int {name}; }} s_{i};\n" for i, name in enumerate(names)) +
                     "".join(f"static int {name}(int {names[i - 1]}) {{ return {names[i - 1]} + s_{i}.{name}++; }}\n"
                             for i, name in enumerate(names)) +
                     "void init(void) { plc1_time = 8; plc2_time = 16; }\nvoid plc2(void) {}\nvoid plc1(void) {\n" +
                     "".join(f"Y[1] = {name}(1);\n" for name in names) + "}\n"}


CARRIERS = {"nc110": (nc110, "nc110"), "host50": (host50, "host50"), "prostep": (prostep, "prostep"), "technol": (technol, "technol"),
            "technol code": (technol_code, "technol"), "hnc": (hnc, "hnc"), "hnc code": (hnc_code, "hnc")}
SMALL = {"nc110": "$\nU4A0=I0A0\n", "host50": "SLOW\nNETWORK\nLD %I0\nOUT %Q0\nEND_SLOW\n", "prostep": ":MOD PM 9\n:A I 0.0\n:= O 0.0\n:END PM 9\n",
         "technol": " DATA\nN: DS 2\n DATA_END\n MODULE_MAIN\n LOD N\n STO N\n MODULE_MAIN_END\n STOP\n", "hnc": hnc(["a"])["p.cld"]}
SUFFIX = {"nc110": ".plc", "host50": ".il", "prostep": ".plc", "technol": ".plc", "hnc": ".cld"}


# A program's namespace is a global name: beside a header that declares the same one (time, read) no namespace of that
# name is possible, and the program is given another one by --name. Words and macros are.
MACROS = "#include <inttypes.h>\n#include <limits.h>\n#include <stddef.h>\n#include <stdint.h>\n"


def named(line, column, names):
    """Which of the names an error at this column is about: the longest one there, else the last before, else the next."""
    found = [(at.start(), at.end(), name) for name in names
             for at in re.finditer(rf"(?<!\w)(?:MODULE_)?{re.escape(name)}(?!\w)", line)]
    there = [at for at in found if at[0] <= column < at[1]]
    before = [at for at in found if at[1] <= column]
    if there:
        return max(there, key=lambda at: at[1] - at[0])[2]
    if before:
        return max(before, key=lambda at: at[1])[2]
    return min(found)[2] if found else None


class Names:
    def __init__(self, plcxx, include, compilers):
        self.plcxx, self.include, self.compilers = plcxx, include, compilers
        self.faults, self.programs, self.compiled = [], 0, 0

    def run(self, folder, words):
        return subprocess.run([self.plcxx, *words], cwd=folder, capture_output=True, text=True, errors="replace", check=False)

    def check(self, folder, dialect, files, *options):
        for name, text in files.items():
            (folder / name).write_text(text)
        return self.run(folder, ["check", *files, "--dialect", dialect, *options])

    def accepted(self, folder, dialect, carrier, names):
        """Those of the names that the language allows: what its errors point at goes, until there is none. An error may
        come of the one before it, so what went is asked for again, a few names of it at a time."""
        left = self.pointed(folder, dialect, carrier, names)
        gone = [name for name in names if name not in left]
        for first in range(PIECES):
            if gone[first::PIECES]:
                left = max(left, self.pointed(folder, dialect, carrier, left + gone[first::PIECES]), key=len)
        return left

    def pointed(self, folder, dialect, carrier, names):
        while names:
            files = carrier(names)
            run = self.check(folder, dialect, files)
            if run.returncode == 0:
                return names
            refused = {named(files[file].split("\n")[int(line) - 1], int(column) - 1, names)
                       for file, line, column in re.findall(r"^([^:\n]+):(\d+):(\d+): error", run.stderr, re.M)} - {None}
            if not refused:  # an error that points at none
                return self.halved(folder, dialect, carrier, names)
            names = [name for name in names if name not in refused]
        return names

    def halved(self, folder, dialect, carrier, names):
        """The same for any error: found by halves, which costs hundreds of runs."""
        if self.check(folder, dialect, carrier(names), "--max-messages", "1").returncode == 0:
            return names
        if len(names) == 1:
            return []
        half = len(names) // 2
        left, right = self.halved(folder, dialect, carrier, names[:half]), self.halved(folder, dialect, carrier, names[half:])
        together = left + right
        if not right or self.check(folder, dialect, carrier(together), "--max-messages", "1").returncode == 0:
            return together
        for name in right:  # refused beside another one only
            if self.check(folder, dialect, carrier(left + [name]), "--max-messages", "1").returncode == 0:
                left = left + [name]
        return left

    def compile(self, what, folder, flavour, headers):
        sources = sorted(path.name for path in folder.glob("*.cpp")) or sorted(path.name for path in folder.glob("*.hpp"))
        (folder / "all.cc").write_text(headers + "".join(f'#include "{name}"\n' for name in sources))
        for compiler in self.compilers[:1] if flavour else self.compilers:
            build = subprocess.run([compiler, "-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Wshadow", "-Wno-unused-function",
                                    "-Werror", "-I", ".", "-I", self.include, "all.cc"], cwd=folder, capture_output=True, text=True, check=False)
            self.compiled += 1
            if build.returncode:
                self.fault(f"{what}: {compiler}: {build.stderr[:600]}")

    def fault(self, text):
        self.faults.append(text)
        print(text, flush=True)

    def distinct(self, what, folder):
        """Members of one struct, constants and functions of one scope: the compiler tells. Files are told here."""
        names = collections.Counter(path.name.lower() for path in folder.iterdir())
        for name, count in names.items():
            if count > 1:
                self.fault(f"{what}: two files {name}")
        for path in folder.iterdir():
            if not re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9_.-]*", path.name):
                self.fault(f"{what}: file {path.name!r}")

    def emit(self, what, folder, words, headers=None):
        out = folder / "out"
        shutil.rmtree(out, ignore_errors=True)
        run = self.run(folder, ["emit", *words, "-o", "out", "--quiet"])
        self.programs += 1
        if run.returncode:
            self.fault(f"{what}: exit {run.returncode}: {run.stderr[-300:]}")
            return
        self.distinct(what, out)
        self.compile(what, out, "--parts" in words or "--debug" in words, SYSTEM if headers is None else headers)

    def symbols(self, carrier):
        make, dialect = CARRIERS[carrier]
        with tempfile.TemporaryDirectory(prefix="plcxx_names_") as scratch:
            folder = pathlib.Path(scratch)
            names = self.accepted(folder, dialect, make, list(dict.fromkeys(WORDS + SCRIPTS)))
            if len(names) < 120:  # of 172; else the test is about names that nobody can write
                self.fault(f"{carrier}: only {len(names)} names are allowed: {names}")
            files = make(names)
            for name, text in files.items():
                (folder / name).write_text(text)
            for flavour in FLAVOURS:
                self.emit(f"{carrier} {' '.join(flavour)}", folder, [*files, "--dialect", dialect, *flavour])
        return f"{carrier}: {len(names)} names"

    def files(self, dialect, share):
        words = [word for i, word in enumerate(WORDS + SCRIPTS) if (i + len(dialect)) % share == 0]
        with tempfile.TemporaryDirectory(prefix="plcxx_names_") as scratch:
            folder = pathlib.Path(scratch)
            for word in words:
                source = word + SUFFIX[dialect]
                (folder / source).write_text(SMALL[dialect])
                self.emit(f"{dialect} file {source}", folder, [source, "--dialect", dialect], MACROS)
                run = self.run(folder, ["emit", source, "--dialect", dialect, f"--name={word}", "-o", "out", "--quiet"])
                if run.returncode == 0:
                    self.emit(f"{dialect} --name {word}", folder, [source, "--dialect", dialect, f"--name={word}"], MACROS)
                elif run.returncode != 2 or not run.stderr:
                    self.fault(f"{dialect} --name {word}: exit {run.returncode} {run.stderr[:200]}")
                (folder / source).unlink()
        return f"{dialect}: {len(words)} names of files"


def main():
    plcxx, include = str(pathlib.Path(sys.argv[1]).resolve()), str(pathlib.Path(sys.argv[2]).resolve())
    share = 1 if "--heavy" in sys.argv else 40
    only = [word for word in sys.argv[3:] if not word.startswith("--")]
    tried = Names(plcxx, include, [name for name in COMPILERS if shutil.which(name)])
    for carrier, (_, dialect) in CARRIERS.items():
        if not only or dialect in only:
            print(tried.symbols(carrier), flush=True)
    for dialect in SMALL:
        if not only or dialect in only:
            print(tried.files(dialect, share), flush=True)
    print(f"{tried.programs} programs, {tried.compiled} compiled, {len(tried.faults)} faults")
    return 1 if tried.faults or not tried.compiled else 0


if __name__ == "__main__":
    sys.exit(main())
