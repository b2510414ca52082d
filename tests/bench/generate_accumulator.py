#!/usr/bin/env python3
"""Programs of the accumulator languages for measurements, with the same program as a person would write it in C++.

The mix is that of generate_nc110.py: 58 % coils, 13 % coils with a compare, 10 % on-delay timers, 7 % set, 7 % reset,
5 % counters, 3.3 contacts a statement on average. A statement is a rung or a sequence. The same number of statements
always gives the same program.

    generate_accumulator.py prostep|host50|technol STATEMENTS DIRECTORY [--sliced]
"""
import json
import pathlib
import random
import re
import sys

PER_FUNCTION = 250  # statements a function of the reference

HEAD = """#include <stdint.h>
// One byte per bit, straight down, 250 statements a function.
"""


class Machine:
    """A language: `pieces` gives (number of the statement, its lines), and (None, lines) for what stands around them."""

    def source(self, statements):
        return "\n".join(line for _, lines in self.pieces(statements) for line in lines) + "\n"


class ProStep(Machine):
    """Sequences in the loop modules PM 9 to PM 16; the timers' time passes once a tick."""

    name, extension, options = "prostep", "plc", []
    warnings = ["W16", "W17", "W18", "W19", "W36", "W37", "W33"]
    bits = [f"F {n}.{d}" for n in range(200) for d in range(8)]
    inputs = [f"I {n}.{d}" for n in range(20) for d in range(8)]
    words = [f"DW {n}" for n in range(0, 160, 2)]
    timers, counters, period_ms = 64, 64, 12
    scan = "tick(m, 12, host); slow_pass(m, host);"
    compares = {"<": "<", "=": "!=", ">": ">"}

    def timer_contact(self, n):
        return f"T {n}"

    def counter_contact(self, n):
        return f"C {n}"

    def statement(self, number, statement):
        kind, target, terms, extra = statement
        lines = [f":L {extra[0]}"] if kind == "compare" else []
        for op, negated, operand in terms:
            lines.append(f":{'O' if op == '+' else 'A'}{'N' if negated else ''} {operand}")
        if kind == "compare":
            lines += [":A(", f":{self.compares[extra[1]]}", f": K {extra[2]}", ":)"]
        if kind in ("coil", "compare"):
            lines.append(f":= {target}")
        elif kind in ("set", "reset"):
            lines.append(f":{'S' if kind == 'set' else 'R'} {target}")
        elif kind == "timer":
            lines += [f":SR T {target}", f": K 2{extra:03d}D"]
        else:
            lines.append(f":CU C {target}")
        return lines

    def pieces(self, statements):
        yield None, [":MOD PM 0", ":L", ": K 255", ":T FB 251", ":END PM 0"]
        per_module = -(-len(statements) // 8)
        for k in range(8):
            yield None, [f":MOD PM {9 + k}"]
            for number in range(k * per_module, min((k + 1) * per_module, len(statements))):
                yield number, self.statement(number, statements[number])
            yield None, [f":END PM {9 + k}"]

    types = """
struct Timer { uint32_t left; bool running, edge, output; };
struct Counter { uint16_t value; bool edge; };
static inline void Delay(Timer& t, bool v, uint32_t preset) {
  if (!v) {
    t.output = t.running = false;
    t.left = 0;
  } else if (!t.edge) {
    t.left = preset;
    t.running = preset > 0;
    t.output = !t.running;
  }
  t.edge = v;
}
static inline void Pass(Timer& t, uint32_t ms) {
  if (!t.running) return;
  if (ms < t.left) { t.left -= ms; return; }
  t.left = 0;
  t.running = false;
  t.output = true;
}
static inline void Count(Counter& c, bool v) {
  if (v && !c.edge && c.value < 999) c.value = (uint16_t)(c.value + 1);
  c.edge = v;
}
"""
    word_type = "int16_t"

    def variable(self, operand):
        if operand[0] == "T":
            return f"T{operand[2:]}.output"
        if operand[0] == "C":
            return f"(C{operand[2:]}.value != 0)"
        return operand.replace(" ", "").replace(".", "_")

    def timer(self, target, text, extra):
        return f"Delay(T{target}, {text}, {extra * 100}u);"

    def counter(self, target, text, extra):
        return f"Count(C{target}, {text});"

    def before_scan(self, timers):
        return [f"  Pass(T{n}, 12);" for n in timers]


class Host50(Machine):
    """Rungs of the slow section, 100 a network or more; one slow cycle is one tick."""

    name, extension = "host50", "il"
    warnings = ["W01", "W02", "W04", "W14", "W15", "W07"]
    bits = [f"%B{n}" for n in range(501, 2001)]
    inputs = [f"%I{n}" for n in range(200)]
    words = [f"%W{n}" for n in range(101, 201)]
    timers, counters, period_ms = 101, 101, 1
    scan = "period(m, host);"
    compares = {"<": "LT", "=": "EQ", ">": "GT"}

    def __init__(self, slow_div=1, sliced=False):
        self.slow_div, self.sliced = slow_div, sliced

    def timer_contact(self, n):
        return f"%TM{n}"

    def counter_contact(self, n):
        return f"%C{n}"

    def statement(self, number, statement):
        kind, target, terms, extra = statement
        lines = []
        for k, (op, negated, operand) in enumerate(terms):
            word = "LD" if k == 0 else "OR" if op == "+" else "AND"
            lines.append(f"{word}{'I' if negated else ''} {operand}")
        if kind == "compare":
            lines.append(f"{self.compares[extra[1]]} {extra[0]}, {extra[2]}")
        if kind in ("coil", "compare"):
            lines.append(f"OUT {target}")
        elif kind in ("set", "reset"):
            lines.append(f"{'SET' if kind == 'set' else 'RST'} {target}")
        elif kind == "timer":
            lines += [f"TONMS %TM{target}, {extra}", "RUNG"]
        else:
            lines += [f"CNUD %C{target}, {extra}, P=0, M=0, N=0", "RUNG"]
        return lines

    def pieces(self, statements):
        yield None, [f"SLOWDIV {self.slow_div}"] + (["OPTION SLICES=SLICED"] if self.sliced else []) + ["SLOW"]
        per_network = max(20, -(-len(statements) // 450))
        for number, statement in enumerate(statements):
            if number % per_network == 0:
                yield None, ["NETWORK"]
            yield number, self.statement(number, statement)
        yield None, ["END_SLOW"]

    types = """
struct Timer { uint64_t elapsed; uint32_t value, preset; bool previous, output; };
struct Counter { int32_t value, preset; bool loaded, previous, output; };
static inline void Delay(Timer& t, bool v, uint32_t preset, uint32_t period) {
  const uint64_t all = uint64_t{preset} * 100;
  if (!v) {
    t.elapsed = 0;
    t.output = false;
  } else if (!t.output) {
    t.elapsed = t.previous ? t.elapsed + period : 0;
    if (t.elapsed >= all) { t.output = true; t.elapsed = all; }
  }
  t.previous = v;
  t.preset = preset;
  t.value = (uint32_t)((t.elapsed < all ? t.elapsed : all) / 100);
}
static inline void Count(Counter& c, bool v, int32_t preset) {
  if (!c.loaded) {
    c.value = 0;
    c.loaded = true;
  } else if (v && !c.previous) {
    c.value = c.value >= preset ? 0 : c.value + 1;
  }
  c.previous = v;
  c.preset = preset;
  c.output = c.value >= preset;
}
"""
    word_type = "int32_t"

    def variable(self, operand):
        if operand.startswith("%TM"):
            return f"TM{operand[3:]}.output"
        if operand.startswith("%C"):
            return f"C{operand[2:]}.output"
        return operand[1:]

    def timer(self, target, text, extra):
        return f"Delay(TM{target}, {text}, {extra}u, {self.slow_div});"

    def counter(self, target, text, extra):
        return f"Count(C{target}, {text}, {extra});"

    def before_scan(self, timers):
        return []


class Technol(Machine):
    """The main module; timers and counters are words that the program counts, as the language has none."""

    name, extension = "technol", "plc"
    warnings = ["TW004", "TW006", "TW007", "TW008", "TW009", "TW011", "TW020", "TW025"]
    bits = [f"B{n}" for n in range(1600)]
    inputs = [f"I{n}" for n in range(160)]
    words = [f"W{n}" for n in range(80)]
    timers, counters, period_ms = 64, 64, 20
    scan = "period(m, host);"
    compares = {"<": "LT", "=": "EQ", ">": "GT"}

    def timer_contact(self, n):
        return f"TO{n}"

    def counter_contact(self, n):
        return f"CO{n}"

    def data(self):
        flags = [*self.bits, *self.inputs, "HELP", *(f"{k}{n}" for k in ("TO", "CO", "CE") for n in range(64))]
        rows = [f"F{i}: DFM {','.join(flags[i : i + 8])}" for i in range(0, len(flags), 8)]
        return ["DATA", *rows, *(f"{k}: DW 0" for k in [*self.words, *(f"{k}{n}" for k in ("TC", "CC") for n in range(64))]), "DATA_END"]

    def statement(self, number, statement):
        kind, target, terms, extra = statement
        lines = []
        if kind == "compare":
            lines += [f"LOD WORD.{extra[0]}", f"{self.compares[extra[1]]} CNST.{extra[2]}", "WR HELP"]
        for k, (op, negated, operand) in enumerate(terms):
            lines.append(f"{'LDR' if k == 0 else 'LO' if op == '+' else 'LA'} {'-' if negated else ''}{operand}")
        if kind == "compare":
            lines.append("LA HELP")
        zero, go_on = f"Z{number}", f"K{number}"
        if kind in ("coil", "compare"):
            lines.append(f"WR {target}")
        elif kind in ("set", "reset"):
            lines.append(f"FL1 {1 if kind == 'set' else 0},{target}")
        elif kind == "timer":
            lines += [f"JL0 {zero}", f"LOD TC{target}", "AD CNST.1", f"STO TC{target}", f"JUM {go_on}"]
            lines += [f"{zero}: LOD CNST.0", f"STO TC{target}", f"{go_on}: LOD TC{target}", f"GE CNST.{extra}", f"WR TO{target}"]
        else:
            lines += ["WR HELP", f"LA -CE{target}", f"JL0 {zero}", f"LOD CC{target}", "AD CNST.1", f"STO CC{target}"]
            lines += [f"{zero}: LDR HELP", f"WR CE{target}", f"LOD CC{target}", f"GE CNST.{extra}", f"WR CO{target}"]
        return lines

    def pieces(self, statements):
        yield None, [*self.data(), "MODULE_INIT", "MODULE_INIT_END", "MODULE_MAIN"]
        for number, statement in enumerate(statements):
            yield number, self.statement(number, statement)
        tail = ["MODULE_MAIN_END"]
        for module in ("MODULE_FAST", "MODULE_CLEAR", "MODULE_HALT", "PRIPRAVNE_FUNKCE", "ZAVERECNE_FUNKCE"):
            tail += [module, module + "_END"]
        yield None, [*tail, "STOP"]

    types = """
struct Timer { uint16_t value; bool output; };
struct Counter { uint16_t value; bool edge, output; };
static inline void Delay(Timer& t, bool v, uint32_t preset) {
  t.value = v ? (uint16_t)(t.value + 1) : 0;
  t.output = t.value >= preset;
}
static inline void Count(Counter& c, bool v, uint32_t preset) {
  if (v && !c.edge) c.value = (uint16_t)(c.value + 1);
  c.edge = v;
  c.output = c.value >= preset;
}
"""
    word_type = "uint16_t"

    def variable(self, operand):
        if operand.startswith(("TO", "CO")):
            return f"{operand[0]}{operand[2:]}.output"
        return operand

    def timer(self, target, text, extra):
        return f"Delay(T{target}, {text}, {extra}u);"

    def counter(self, target, text, extra):
        return f"Count(C{target}, {text}, {extra}u);"

    def before_scan(self, timers):
        return []


class Program:
    """Statements as (kind, target, terms, extra); a term is (operator, negated, operand)."""

    def __init__(self, machine, count):
        self.machine = machine
        rng = random.Random(20_000 + count)
        bits = machine.bits[: max(64, min(len(machine.bits), count))]
        self.statements = []
        for i in range(count):
            kind = rng.choices(["coil", "compare", "timer", "set", "reset", "counter"], [58, 13, 10, 7, 7, 5])[0]
            terms = []
            for k in range(rng.choices([2, 3, 4, 5], [25, 35, 25, 15])[0]):
                operand = rng.choice(bits if rng.random() < 0.8 else machine.inputs)
                if rng.random() < 0.05:
                    operand = machine.timer_contact(rng.randrange(machine.timers))
                elif rng.random() < 0.03:
                    operand = machine.counter_contact(rng.randrange(machine.counters))
                terms.append((rng.choice("**+") if k else "", rng.random() < 0.3, operand))
            target = bits[i % len(bits)] if rng.random() < 0.5 else rng.choice(bits)
            extra = None
            if kind == "compare":
                extra = (rng.choice(machine.words), rng.choice("<=>"), rng.randrange(256))
            elif kind == "timer":
                target, extra = rng.randrange(machine.timers), rng.randrange(1, 256)
            elif kind == "counter":
                target, extra = rng.randrange(machine.counters), rng.randrange(2, 256)
            self.statements.append((kind, target, terms, extra))
        self.timers = sorted({t for k, t, _, _ in self.statements if k == "timer"} | self.contacts("timer"))
        self.counters = sorted({t for k, t, _, _ in self.statements if k == "counter"} | self.contacts("counter"))

    def contacts(self, kind):
        machine = self.machine
        name = {"timer": machine.timer_contact, "counter": machine.counter_contact}[kind]
        count = {"timer": machine.timers, "counter": machine.counters}[kind]
        numbers = {name(n): n for n in range(count)}
        return {numbers[o] for _, _, terms, _ in self.statements for _, _, o in terms if o in numbers}

    def expression(self, terms):
        """Left to right, as an accumulator computes."""
        text = ""
        for op, negated, operand in terms:
            name = ("!" if negated else "") + self.machine.variable(operand)
            text = name if not op else f"({text}) {'|' if op == '+' else '&'} ({name})"
        return text

    def signals(self):
        read = {o for _, _, terms, _ in self.statements for _, _, o in terms}
        inputs = sorted(read & set(self.machine.inputs))
        words = sorted({e[0] for k, _, _, e in self.statements if k == "compare"})
        outputs = sorted({t for k, t, _, _ in self.statements if k in ("coil", "compare", "set", "reset")})
        return inputs, words, outputs

    def reference(self):
        machine = self.machine
        inputs, words, outputs = self.signals()
        read = {o for _, _, terms, _ in self.statements for _, _, o in terms} & set(machine.bits)
        out = [HEAD, machine.types]
        out += [f"bool {machine.variable(b)};" for b in sorted(set(inputs) | read | set(outputs))]
        out += [f"{machine.word_type} {machine.variable(w)};" for w in words]
        timer = machine.variable(machine.timer_contact(0)).split("0")[0]
        out += [f"Timer {timer}{n};" for n in self.timers] + [f"Counter C{n};" for n in self.counters]
        calls = []
        for start in range(0, len(self.statements), PER_FUNCTION):
            out.append(f"__attribute__((noinline)) static void part{start}() {{")
            calls.append(f"  part{start}();")
            for kind, target, terms, extra in self.statements[start : start + PER_FUNCTION]:
                text = self.expression(terms)
                if kind == "coil":
                    out.append(f"  {machine.variable(target)} = {text};")
                elif kind == "compare":
                    sign = extra[1].replace("=", "==")
                    out.append(f"  {machine.variable(target)} = ({text}) & ({machine.variable(extra[0])} {sign} {extra[2]});")
                elif kind == "set":
                    out.append(f"  if ({text}) {machine.variable(target)} = true;")
                elif kind == "reset":
                    out.append(f"  if ({text}) {machine.variable(target)} = false;")
                elif kind == "timer":
                    out.append(f"  {machine.timer(target, text, extra)}")
                else:
                    out.append(f"  {machine.counter(target, text, extra)}")
            out.append("}")
        out.append('extern "C" void reference_scan(uint32_t) {')
        out += machine.before_scan(self.timers) + calls + ["}"]
        out += self.exchange("reference", machine.variable)
        return "\n".join(out) + "\n"

    def exchange(self, prefix, name):
        inputs, words, outputs = self.signals()
        out = [f'extern "C" void {prefix}_set(uint32_t seed) {{']
        for i, n in enumerate(inputs):
            out.append(f"  {name(n)} = (seed >> {i % 29} ^ {i % 7}) & 1;")
        for i, n in enumerate(words):
            out.append(f"  {name(n)} = (uint8_t)(seed * {2 * i + 1}u >> 16);")
        out.append(f'}}\nextern "C" uint64_t {prefix}_sum() {{\n  uint64_t sum = 0;')
        out += [f"  sum = sum * 31 + {name(n)};" for n in outputs]
        return [*out, "  return sum;", "}"]

    def glue(self, header, symbols):
        """What the integrator writes: the host functions that the header declares, and the exchange of signals."""
        names = {}
        for symbol in symbols:
            for key in ("source", "address", "name"):
                names.setdefault(re.sub(r"[ %]", "", symbol[key]), symbol["name"])
        out = ['#include "program.hpp"', "namespace program {", "struct Host { uint32_t now; };"]
        for line in re.findall(r"^(\w+ \w+\(Host& host.*\) noexcept;)$", header, re.M):
            body = "{ return host.now; }" if "now" in line else "{ return {}; }"
            if line.startswith("void"):
                body = "{}"
            out.append(re.sub(r"(\w+[&]?) (\w+)(?=[,)])", lambda m: m[0] if m[2] == "host" and "now" in line else m[1], line[:-1]) + " " + body)
        out += ["static State m; static Host host;", 'extern "C" void generated_init() { init(m, host); }',
                'extern "C" void generated_scan(uint32_t t) { host.now = t; %s }' % self.machine.scan]
        out += self.exchange("generated", lambda n: f"m[{names[re.sub(r'[ %]', '', n)]}]")
        return "\n".join(out) + "\n}\n"


def machine_of(dialect, **options):
    return {"prostep": ProStep, "host50": Host50, "technol": Technol}[dialect](**options)


def write(machine, count, directory):
    directory = pathlib.Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    program = Program(machine, count)
    (directory / f"program.{machine.extension}").write_text(machine.source(program.statements))
    (directory / "reference.cpp").write_text(program.reference())
    return program


def write_glue(program, directory):
    """After plcxx has written program.hpp and program.map.json into the directory."""
    directory = pathlib.Path(directory)
    header = (directory / "program.hpp").read_text()
    symbols = json.loads((directory / "program.map.json").read_text())["symbols"]
    (directory / "glue.cpp").write_text(program.glue(header, symbols))


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    options = {"slow_div": 8, "sliced": True} if "--sliced" in sys.argv else {}
    write(machine_of(sys.argv[1], **options), int(sys.argv[2]), sys.argv[3])
