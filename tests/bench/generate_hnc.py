#!/usr/bin/env python3
"""Programs of dialect hnc for measurements, and the same C compiled directly: types of 16 and 32 bits by substitution.

The mix is that of programs for this control: bits of register bytes set by conditions, bytes with masks, counters as
timers, arithmetic of words and longs, tables, calls, step sequences in switches. A statement is a line. What is computed
does not depend on the width of int but by what is stored (operands of `>>`, `/` and comparisons are variables), so that
the text is the same for both. The same number of statements always gives the same program.

    generate_hnc.py STATEMENTS DIRECTORY
"""
import json
import pathlib
import random
import sys

PER_FUNCTION = 50  # lines a function
BYTES, INPUTS = 400, 60  # of R and X that are used
COUNTERS, WORDS, INTS, LONGS, STATES = 60, 60, 60, 30, 40

MACROS = """#define x(g,b) (X[g]&(1<<(b)))
#define r(g,b) (R[g]&(1<<(b)))
#define set_r(g,b) (R[g]|=(1<<(b)))
#define clr_r(g,b) (R[g]&=~(1<<(b)))
"""
PLC_HEAD = """#include "plc.h"
typedef unsigned char BYTE;
typedef int INT;
typedef unsigned int WORD;
typedef long LONG;
"""
REFERENCE_HEAD = """#include <stdint.h>
typedef uint8_t BYTE;
typedef int16_t INT;
typedef uint16_t WORD;
typedef int32_t LONG;
BYTE X[128], R[768];
"""


class Program:
    def __init__(self, count):
        self.random = random.Random(count)
        self.statements, lines = [], 0  # each is its lines
        while lines < count:
            self.statements.append(self.statement())
            lines += len(self.statements[-1])
        self.names = [f"R[{i}]" for i in range(BYTES)]
        for letter, number in (("t", COUNTERS), ("w", WORDS), ("i", INTS), ("l", LONGS)):
            self.names += [f"{letter}{i}" for i in range(number)]
        self.names += [f"s{i}" for i in range(STATES)]

    def pick(self, letter, count):
        return f"{letter}{self.random.randrange(count)}"

    def bit(self):
        if self.random.random() < 0.4:
            return f"x({self.random.randrange(INPUTS)},{self.random.randrange(8)})"
        return f"r({self.random.randrange(BYTES)},{self.random.randrange(8)})"

    def condition(self):
        terms = [("!" if self.random.random() < 0.3 else "") + self.bit() for _ in range(self.random.choice([1, 2, 2, 3, 4]))]
        text = terms[0]
        for term in terms[1:]:
            text += f" && {term}"
        return text

    def statement(self):
        rest = self.random.random()
        g, b = self.random.randrange(BYTES), self.random.randrange(8)
        if rest < 0.42:
            return [f"if ({self.condition()}) set_r({g},{b}); else clr_r({g},{b});"]
        if rest < 0.50:
            return [f"if ({self.condition()}) set_r({g},{b});"]
        if rest < 0.60:
            mask = self.random.choice([0x0F, 0x3F, 0xF0])
            return [f"R[{g}] = (R[{g}] & {mask ^ 0xFF:#x}) | (X[{self.random.randrange(INPUTS)}] & {mask:#x});"]
        if rest < 0.70:
            t = self.pick("t", COUNTERS)
            return [f"if ({self.bit()}) {{ if ({t} < {self.random.randrange(5, 200)}) {t}++; }} else {t} = 0;"]
        if rest < 0.77:
            w = [self.pick("w", WORDS) for _ in range(3)]
            return [f"{w[0]} = {w[1]} + ({w[2]} >> {self.random.randrange(1, 8)});"]
        if rest < 0.82:
            l, m, i = self.pick("l", LONGS), self.pick("l", LONGS), self.pick("i", INTS)
            return [f"{l} = {m} / 3 + (LONG){i} * {self.random.randrange(2, 90)};"]
        if rest < 0.87:
            i, j = self.pick("i", INTS), self.pick("i", INTS)
            return [f"if ({i} > {j}) set_r({g},{b}); else {i} = {j} - X[{self.random.randrange(INPUTS)}];"]
        if rest < 0.91:
            return [f"table[{self.pick('w', WORDS)} & 31] += {self.pick('i', INTS)};"]
        if rest < 0.95:
            return [f"{self.pick('i', INTS)} = limited({self.pick('i', INTS)}, {self.random.randrange(50, 900)});"]
        s = self.pick("s", STATES)
        return [
            f"switch ({s}) {{",
            f"case 0: if ({self.bit()}) {s}++; break;",
            f"case 1: set_r({g},{b}); {s}++; /* falls through */",
            f"case 2: if ({self.bit()}) {s} = 3; break;",
            f"default: clr_r({g},{b}); {s} = 0;",
            "}",
        ]

    def pieces(self):
        """(Number of the statement, its lines), and (None, lines) around functions of some PER_FUNCTION lines."""
        inside, parts = 0, 0
        for number, statement in enumerate(self.statements):
            if inside == 0:
                yield None, [f"void part{parts}(void)", "{"]
                parts += 1
            yield number, ["    " + line for line in statement]
            inside += len(statement)
            if inside >= PER_FUNCTION or number + 1 == len(self.statements):
                yield None, ["}"]
                inside = 0

    def parts(self):
        return [line for _, lines in self.pieces() for line in lines]

    @staticmethod
    def calls(parts):
        return [f"    {line[len('void ') : -len('(void)')]}();" for line in parts if line.startswith("void ")]

    def variables(self):
        kinds = [("WORD", "t", COUNTERS), ("WORD", "w", WORDS), ("INT", "i", INTS), ("LONG", "l", LONGS), ("BYTE", "s", STATES)]
        out = []
        for kind, letter, count in kinds:
            out.append(f"{kind} " + ", ".join(f"{letter}{k}" for k in range(count)) + ";")
        return [*out, "INT table[32];", "INT limited(INT v, INT most) { return v > most ? most : v < 0 ? 0 : v; }"]

    def plc(self):
        return self.plc_around(self.parts())

    def plc_around(self, parts):
        tail = ["void init() { plc1_time = 16; plc2_time = 32; }", "void plc1()", "{", *self.calls(parts), "}", "void plc2() { }"]
        return PLC_HEAD + MACROS + "\n".join([*self.variables(), *parts, *tail]) + "\n"

    def reference(self):
        parts = self.parts()
        calls = self.calls(parts)
        parts = [f"__attribute__((noinline)) static {line}" if line.startswith("void ") else line for line in parts]
        # Not static: as in the old program anybody may read them, so that no store is left out because nobody here does.
        variables = self.variables()
        scan = ['extern "C" void reference_scan(uint32_t)', "{", *calls, "}"]
        return REFERENCE_HEAD + MACROS + "\n".join([*variables, *parts, *scan, *self.exchange("reference", lambda n: n)]) + "\n"

    def exchange(self, prefix, name):
        out = [f'extern "C" void {prefix}_set(uint32_t seed) {{']
        out += [f"  {name(f'X[{i}]')} = (uint8_t)(seed * {2 * i + 1}u >> {i % 17});" for i in range(INPUTS)]
        out.append(f'}}\nextern "C" uint64_t {prefix}_sum() {{\n  uint64_t sum = 0;')
        out += [f"  sum = sum * 31 + (uint16_t){name(n)};" for n in self.names]
        return [*out, "  return sum;", "}"]

    def glue(self, header, symbols):
        """What the integrator writes: functions of the host that do nothing, and the exchange of signals."""
        names = {}
        for symbol in symbols:
            for key in ("address", "source", "name"):
                names.setdefault(symbol[key], symbol["name"])
        out = ['#include "program.hpp"', "namespace program {", "struct Host {};"]
        for line in header.splitlines():
            if "(Host& host" in line and line.endswith(" noexcept;"):
                out.append(line[:-1].replace("Host& host", "Host&").replace("State& m", "State&").replace("& retentive)", "&)") + " {}")
        out = [line.replace("uint8_t code", "uint8_t").replace("uint32_t statement", "uint32_t") for line in out]
        self.names = [n for n in self.names if n in names]
        out += ["static State m; static Host host;", 'extern "C" void generated_init() { init(m, host); }',
                'extern "C" void generated_scan(uint32_t) { fast(m, host); }']
        exchange = self.exchange("generated", lambda n: f"m[{names.get(n, 'none')}]")
        out += [line for line in exchange if "m[none]" not in line]
        return "\n".join(out) + "\n}\n"


def write(count, directory):
    directory = pathlib.Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    program = Program(count)
    (directory / "program.cld").write_text(program.plc())
    return program


def write_glue(program, directory):
    """After plcxx has written program.hpp and program.map.json into the directory."""
    directory = pathlib.Path(directory)
    symbols = json.loads((directory / "program.map.json").read_text())["symbols"]
    glue = program.glue((directory / "program.hpp").read_text(), symbols)
    (directory / "glue.cpp").write_text(glue)
    (directory / "reference.cpp").write_text(program.reference())  # sums what the program uses, as the glue does


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    write(int(sys.argv[1]), sys.argv[2])
