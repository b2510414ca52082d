#!/usr/bin/env python3
"""Programs of the NC-110 for measurements: the PLC source, and the same program as a person would write it in C++.

The mix: 58 % coils, 13 % coils with an 8-bit compare, 10 % on-delay timers, 7 % set, 7 % reset, 5 % counters, 3.3
contacts a statement on average. The same number of statements always gives the same program.

    generate_nc110.py STATEMENTS DIRECTORY     writes program.plc, reference.cpp, compare.cpp
"""
import pathlib
import random
import sys

FIRST_CONNECTOR = 26  # the first free connector of package K behind one process
BITS = [f"U{c}K{b}" for c in range(FIRST_CONNECTOR, 236) for b in range(32)]
WORDS = [f"W{c}K{z}" for c in range(236, 256) for z in range(4)]
INPUTS = [f"I{c}A{b}" for c in (0, 1, 2, 3) for b in range(32)]
TIMERS, COUNTERS = 255, 100
PER_FUNCTION = 250  # statements a function of the reference


class Program:
    """Statements as (kind, target, terms): terms is a list of (operator, negated, operand)."""

    def __init__(self, count):
        rng = random.Random(20_000 + count)
        bits = BITS[: max(64, min(len(BITS), count))]
        self.statements = []
        for i in range(count):
            kind = rng.choices(["coil", "compare", "timer", "set", "reset", "counter"], [58, 13, 10, 7, 7, 5])[0]
            contacts = rng.choices([2, 3, 4, 5], [25, 35, 25, 15])[0]
            terms = []
            for k in range(contacts):
                operand = rng.choice(bits if rng.random() < 0.8 else INPUTS)
                if rng.random() < 0.05:
                    operand = f"T{rng.randrange(TIMERS)}U"
                elif rng.random() < 0.03:
                    operand = f"C{rng.randrange(COUNTERS)}R"
                terms.append((rng.choice("**+") if k else "", rng.random() < 0.3, operand))
            target = bits[i % len(bits)] if rng.random() < 0.5 else rng.choice(bits)
            extra = None
            if kind == "compare":
                extra = (rng.choice(WORDS), rng.choice("<=>"), rng.randrange(256))
            elif kind == "timer":
                target, extra = f"T{rng.randrange(TIMERS)}", rng.randrange(1, 256)
            elif kind == "counter":
                target, extra = f"C{rng.randrange(COUNTERS)}", rng.randrange(2, 256)
            self.statements.append((kind, target, terms, extra))

    @staticmethod
    def statement(kind, target, terms, extra):
        text = "".join(f"{op}{'/' if neg else ''}{name}" for op, neg, name in terms)
        if kind == "coil":
            return f"{target}={text}"
        if kind == "compare":
            word, sign, value = extra
            return f"{target}=[{word}{sign}{value}]*({text})"
        if kind == "set":
            return f"{target}={target}+{text}"
        if kind == "reset":
            return f"{target}={target}*/({text})"
        return f"{target}I({extra})={text}"

    def plc(self):
        lines = ["; a program for measurements", "$ slow part", *(self.statement(*s) for s in self.statements)]
        return "\n".join(lines) + "\n"

    @staticmethod
    def cpp_name(operand):
        if operand[0] == "T" and operand[-1] == "U":
            return f"T{operand[1:-1]}.done"
        if operand[0] == "C" and operand[-1] == "R":
            return f"C{operand[1:-1]}.carry"
        return operand.replace("I", "U", 1) if operand[0] == "I" else operand

    def expression(self, terms):
        groups = [[]]
        for op, neg, name in terms:
            if op == "+":
                groups.append([])
            groups[-1].append(("!" if neg else "") + self.cpp_name(name))
        texts = ["(" + " & ".join(f"({t})" if t[0] == "!" else t for t in g) + ")" for g in groups]
        return " | ".join(texts)

    def reference(self):
        out = ["#include <stdint.h>", "// One byte per bit, straight down, 250 statements a function."]
        out += ["struct Timer { uint32_t elapsed, last; bool input, hold, done, timing; };"]
        out += ["struct Counter { uint32_t stamp; uint8_t count; bool input, down, reset, carry; };"]
        out += ["""static inline void Delay(Timer& t, bool v, uint32_t preset, uint32_t now) {
  if (!v) {
    t.input = t.done = t.timing = false;
    t.elapsed = 0;
  } else {
    if (!t.input) {
      t.input = true;
      t.elapsed = 0;
    } else if (!t.hold) {
      uint32_t sum = t.elapsed + (now - t.last);
      t.elapsed = sum < t.elapsed ? 0xFFFFFFFFu : sum;
    }
    if (!t.done) {
      if (t.elapsed >= preset) { t.done = true; t.timing = false; } else { t.timing = true; }
    }
  }
  t.last = now;
}
static inline void Count(Counter& c, bool v, unsigned modulus, uint32_t cycle) {
  c.carry = false;
  if (c.reset) { c.input = false; return; }
  bool rising = v && !c.input;
  c.input = v;
  if (!rising) return;
  if (!c.down) {
    if (c.count + 1u >= modulus) { c.count = 0; c.carry = true; } else { c.count = (uint8_t)(c.count + 1); }
  } else {
    if (c.count == 0) { c.count = (uint8_t)(modulus - 1); c.carry = true; } else { c.count = (uint8_t)(c.count - 1); }
  }
  if (c.carry) c.stamp = cycle;
}"""]
        used = sorted({self.cpp_name(n) for _, _, ts, _ in self.statements for _, _, n in ts} |
                      {self.cpp_name(t) for _, t, _, _ in self.statements})
        bits = [n for n in used if n[0] == "U"]
        out += [f"bool {n};" for n in bits]
        out += [f"uint8_t {w};" for w in WORDS]
        out += [f"Timer T{i};" for i in range(TIMERS)] + [f"Counter C{i};" for i in range(COUNTERS)]
        out += ["static uint32_t now, cycle;"]
        calls = []
        for start in range(0, len(self.statements), PER_FUNCTION):
            out.append(f"__attribute__((noinline)) static void part{start}() {{")
            calls.append(f"  part{start}();")
            for kind, target, terms, extra in self.statements[start : start + PER_FUNCTION]:
                name, text = self.cpp_name(target), self.expression(terms)
                if kind == "coil":
                    out.append(f"  {name} = {text};")
                elif kind == "compare":
                    word, sign, value = extra
                    out.append(f"  {name} = ({word} {sign.replace('=', '==')} {value}) & ({text});")
                elif kind == "set":
                    out.append(f"  {name} = {name} | ({text});")
                elif kind == "reset":
                    out.append(f"  {name} = {name} & !({text});")
                elif kind == "timer":
                    base = 10 if 48 <= int(target[1:]) <= 63 else 100
                    out.append(f"  Delay({target}, {text}, {extra * base}u, now);")
                else:
                    out.append(f"  Count({target}, {text}, {extra}u, cycle);")
            out.append("}")
        driven = sorted({t for k, t, _, _ in self.statements if k == "counter"}, key=lambda n: int(n[1:]))
        out.append("extern \"C\" void reference_scan(uint32_t t) {\n  now = t;\n  ++cycle;")
        out += calls
        out += [f"  if ({c}.carry && {c}.stamp != cycle) {c}.carry = false;" for c in driven]
        out.append("}")
        out += self.exchange("reference", lambda n: n, lambda n: n)
        return "\n".join(out) + "\n"

    def signals(self):
        """Inputs that are stimulated and outputs that are compared: what both programs have."""
        read = {n for _, _, ts, _ in self.statements for _, _, n in ts}
        inputs = sorted(n for n in read if n[0] == "I")
        words = sorted({e[0] for k, _, _, e in self.statements if k == "compare"})
        outputs = sorted({t for k, t, _, _ in self.statements if t[0] == "U"})
        return inputs, words, outputs

    def exchange(self, prefix, bit, word):
        inputs, words, outputs = self.signals()
        reference = prefix == "reference"
        out = [f"extern \"C\" void {prefix}_set(uint32_t seed) {{"]
        for i, n in enumerate(inputs):
            out.append(f"  {bit(self.cpp_name(n) if reference else n)} = (seed >> {i % 29} ^ {i % 7}) & 1;")
        for i, n in enumerate(words):
            out.append(f"  {word(n)} = (uint8_t)(seed * {2 * i + 1}u >> 16);")
        out.append(f"}}\nextern \"C\" uint64_t {prefix}_sum() {{\n  uint64_t sum = 0;")
        for n in outputs:
            out.append(f"  sum = sum * 31 + {bit(n)};")
        out.append("  return sum;\n}")
        return out

    def glue(self):
        out = ["#include \"program.hpp\"", "namespace program { struct Host { uint32_t now; }; ",
               "uint32_t now_ms(Host& h) noexcept { return h.now; }", "void read_inputs(Host&, State&) noexcept {}",
               "void write_outputs(Host&, const State&) noexcept {}", "void retentive_store(Host&, const Retentive&) noexcept {}",
               "static State m; static Host host;", "extern \"C\" void generated_init() { init(m, host); }",
               "extern \"C\" void generated_scan(uint32_t t) { host.now = t; period(m, host); }"]
        out += self.exchange("generated", lambda n: f"m[{n}]", lambda n: f"m[{n}]")
        return "\n".join(out) + "\n}\n"


COMPARE = r"""
#ifndef PERIOD
#define PERIOD 10
#endif
#include <stdint.h>
#include <stdio.h>
#include <time.h>
extern "C" {
void reference_scan(uint32_t); void reference_set(uint32_t); uint64_t reference_sum();
void generated_init(); void generated_scan(uint32_t); void generated_set(uint32_t); uint64_t generated_sum();
}
static double Now() { timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return t.tv_sec * 1e9 + t.tv_nsec; }
int main() {
  generated_init();
  uint32_t t = 0, seed = 1;
  for (int i = 0; i < 300; ++i, t += PERIOD) {
    seed = seed * 1664525u + 1013904223u;
    reference_set(seed); generated_set(seed);
    reference_scan(t); generated_scan(t);
    if (reference_sum() != generated_sum()) { printf("different at scan %d\n", i); return 1; }
  }
  const int scans = 20000000 / STATEMENTS / 4 + 1;
  double best_reference = 1e18, best_generated = 1e18;
  for (int round = 0; round < 9; ++round) {
    double start = Now();
    for (int i = 0; i < scans; ++i, t += PERIOD) { if (i % 16 == 0) reference_set(seed += i); reference_scan(t); }
    double middle = Now();
    for (int i = 0; i < scans; ++i, t += PERIOD) { if (i % 16 == 0) generated_set(seed += i); generated_scan(t); }
    double end = Now();
    if ((middle - start) / scans < best_reference) best_reference = (middle - start) / scans;
    if ((end - middle) / scans < best_generated) best_generated = (end - middle) / scans;
  }
  printf("%.3f %.3f\n", best_reference / STATEMENTS, best_generated / STATEMENTS);
}
"""


def write(count, directory):
    directory = pathlib.Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    program = Program(count)
    (directory / "program.plc").write_text(program.plc())
    (directory / "reference.cpp").write_text(program.reference())
    (directory / "glue.cpp").write_text(program.glue())
    (directory / "compare.cpp").write_text(f"#define STATEMENTS {count}\n" + COMPARE)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    write(int(sys.argv[1]), sys.argv[2])
