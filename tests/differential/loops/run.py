#!/usr/bin/env python3
"""Loops of dialect hnc over all counters, relations, steps, statements and limits, against exact arithmetic (c16.py).

run.py PLCXX DIRECTORY [--variants N] [--engine E] [--seed S]

Each loop is a function of one line that counts, folds what it sees of its counter into `h`, in the body and after it,
and reads a table with the counter it leaves with. Two demands:
- A loop without annotation is accepted where specification 6.6 says so, and never where it does not end.
- What is accepted, and every loop with an annotation, leaves what exact arithmetic leaves, for several limits.
Exit code 0: all of it holds.
"""
import argparse
import collections
import itertools
import pathlib
import random
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
import c16  # noqa: E402

STEPS = ["+1", "+2", "+3", "+7", "-1", "-2", "-7", "*2", ">>1", "+s"]
RELATIONS = ["<", "<=", ">", ">=", "!=", "!=="]  # the last is !(a == b)
FORMS = ["for", "while", "do", "goto", "after", "before"]  # the last two change the counter in their condition
TABLE = 16
BOUND = 9
LONGEST_COUNT = 65537  # a counter of 16 bits has been everywhere
LONGEST_RUN = 300  # iterations of a loop whose values are compared

Limit = collections.namedtuple("Limit", "name type low high setup text")
LIMITS = [
    Limit("constant", None, None, None, "", None),
    Limit("byte cell", c16.TYPES[1], 0, 255, "", "R[200]"),
    Limit("cell with sign", c16.TYPES[0], -128, 127, "", "R_c[200]"),
    Limit("clamped", c16.INT, -20, 20, "int n = R_i[100]; if (n > 20) n = 20; if (n < -20) n = -20;", "n"),
    Limit("masked", c16.UNSIGNED, 0, 15, "unsigned n = R_ui[100] & 15;", "n"),
    Limit("variable", c16.INT, -32768, 32767, "int n = R_i[100];", "n"),
    Limit("unsigned variable", c16.UNSIGNED, 0, 65535, "unsigned n = R_ui[100];", "n"),
]
CELLS = ["R_c[300]", "R[300]", "R_i[150]", "R_ui[150]", "R_l[75]", "R_ul[75]"]  # counters, as c16.TYPES
SETTINGS = [0, 9, 20, 0x80, 0x7FFF, 0xFFFF]  # of R_ui[100]


def limit_value(limit, setting):
    if limit.name in ("byte cell", "cell with sign"):
        return c16.convert(setting, limit.type)
    value = c16.convert(setting, limit.type)
    if limit.name == "clamped":
        return max(-20, min(20, value))
    return value & 15 if limit.name == "masked" else value


class Loop:
    def __init__(self, number, counter, of, relation, step, form, limit, constant, start, annotated):
        self.counter = counter
        self.number, self.type, self.relation, self.step, self.form = number, of, relation, step, form
        self.limit, self.constant, self.start, self.annotated = limit, constant, start, annotated
        self.limit_type = constant[1] if constant else limit.type

    def values(self, setting):
        return self.constant[0] if self.constant else limit_value(self.limit, setting)

    def test(self, limit):
        """The condition as a function of the counter."""
        of = c16.common(self.type, self.limit_type)
        relation = c16.RELATIONS["!=" if self.relation == "!==" else self.relation]
        other = c16.convert(limit, of)
        if not self.type.signed or of.signed:
            return lambda value: relation(value, other)  # each value is itself
        size = 1 << of.bits
        return lambda value: relation(value if value >= 0 else value + size, other)

    def next(self, value):
        if self.step == "*2":
            value *= 2
        elif self.step == ">>1":
            value >>= 1
        else:
            value += 1 if self.step == "+s" else int(self.step)
        return c16.convert(value, self.type)

    def fold(self, h, value, limit):
        for x in (value, c16.halve(value), c16.compare("<", value, self.type, limit, self.limit_type),
                  c16.compare("==", value, self.type, limit, self.limit_type), int(value > 10), int(value >= 0)):
            h = (h * 5 + x) & 0xFFFF
        return h

    def execute(self, limit):
        """h, faults; None: more than LONGEST_RUN iterations."""
        h, value, count, faults, first, holds = 0, self.start, 0, 0, True, self.test(limit)
        while True:
            if self.form == "before":
                value = self.next(value)
            if not first or self.form not in ("do", "goto"):
                goes_on = holds(value)
                if self.form == "after":
                    value = self.next(value)
                if not goes_on:
                    break
                if self.annotated and count == BOUND:
                    faults += 1
                    break
            first = False
            count += 1
            if count > LONGEST_RUN:
                return None
            h = self.fold(h, value, limit)
            if self.form not in ("after", "before"):
                value = self.next(value)
        h = self.fold(h, value, limit)
        inside = 0 <= value < TABLE
        return (h * 5 + (value + 1 if inside else 0)) & 0xFFFF, faults + (0 if inside else 1)

    def text(self):
        limit = self.constant[2] if self.constant else self.limit.text
        relation = f"!(v == {limit})" if self.relation == "!==" else f"v {self.relation} {limit}"
        change = f"v = v * 2" if self.step == "*2" else "v >>= 1" if self.step == ">>1" else f"v += {self.step}"
        if self.step == "+s":
            change = "v += s"
        elif self.step in ("+1", "-1"):
            change = "v++" if self.step == "+1" else "v--"
        fold = "".join(f" h = h * 5 + ({x});"
                       for x in ("v", "v / 2", f"v < {limit}", f"v == {limit}", "v > 10", "v >= 0"))
        bound = f"/*@loop_bound {BOUND}@*/ " if self.annotated else ""
        if self.form == "for":
            loop = f"{bound}for (v = {self.start}; {relation}; {change}) {{{fold} }}"
        elif self.form == "while":
            loop = f"v = {self.start}; {bound}while ({relation}) {{{fold} {change}; }}"
        elif self.form == "do":
            loop = f"v = {self.start}; {bound}do {{{fold} {change}; }} while ({relation});"
        elif self.form == "goto":
            loop = f"v = {self.start}; {bound}again:{fold} {change}; if ({relation}) goto again;"
        else:
            sign = "++" if self.step == "+1" else "--"
            counter = f"v{sign}" if self.form == "after" else f"{sign}v"
            loop = f"v = {self.start}; {bound}while ({relation.replace('v', counter, 1)}) {{{fold} }}"
        name = f"f{self.number}"
        body = re.sub(r"\bv\b", self.counter, f"{loop}{fold} return h * 5 + table[v];")
        local = f"{self.type.name} v; " if self.counter == "v" else ""
        return f"unsigned {name}(void) {{ unsigned h = 0; {local}{self.limit.setup} {body} }}"

    def demand(self):
        """True: accepted; False: refused; None: either."""
        if self.step in ("*2", ">>1", "+s"):
            return False
        limits = [self.constant[0]] if self.constant else [self.limit.low, self.limit.high]
        step = int(self.step)
        counts = [self.count(limit) for limit in limits]
        if None in counts:
            return False
        if max(count for count, _ in counts) > LONGEST_COUNT:
            return None
        if self.constant:
            return None if counts[0][1] and self.type.signed else True
        if self.form in ("after", "before") or not self.within(limits):
            return None
        strict = 1 if self.relation in ("<", ">") else 0
        if self.relation in ("<", "<="):
            return True if step > 0 and limits[-1] - strict + step <= c16.high(self.type) else None
        if self.relation in (">", ">="):
            return True if step < 0 and limits[0] + strict + step >= c16.low(self.type) else None
        return True if abs(step) == 1 and self.type.bits <= 16 else None

    def within(self, limits):
        """No conversion changes a value: the limit is one of the counter's type, and no sign is lost."""
        of = c16.common(self.type, self.limit_type)
        return all(c16.low(self.type) <= x <= c16.high(self.type) and c16.convert(x, of) == x for x in limits) and (
            not self.type.signed or of.signed)

    def count(self, limit):
        """Iterations, and whether the counter leaves its type on the way; None: it never ends."""
        holds, step, low, high = self.test(limit), int(self.step), c16.low(self.type), c16.high(self.type)
        ordered = self.relation not in ("!=", "!==")
        if self.type.bits > 16 and ordered and all(holds(x) for x in (low, -1, 0, 1, high) if low <= x <= high):
            return None
        value, count, wraps, size = self.start, 0, False, high - low + 1
        first = self.form in ("do", "goto")
        ahead = step if self.form == "before" else 0
        while first or holds(c16.convert(value + ahead, self.type) if ahead else value):
            first = False
            count += 1
            value += step
            if not low <= value <= high:
                wraps = True
                value += -size if value > high else size
            if count > LONGEST_COUNT:
                return None if self.type.bits <= 16 else (count, wraps)
        if self.form in ("after", "before"):  # the last test changes it, too
            wraps = wraps or not low <= value + step <= high
        return count, wraps


def spelled(value, of):
    suffix = {"unsigned": "u", "long": "L", "unsigned long": "uL"}.get(of.name, "")
    return f"{value}{suffix}" if value >= 0 else f"({value}{suffix})"


def make(seed, variants, share):
    loops = []
    for of, relation, step, form, limit in itertools.product(c16.TYPES, RELATIONS, STEPS, FORMS, LIMITS):
        if form in ("after", "before") and step not in ("+1", "-1"):
            continue
        draw = random.Random(f"{seed} {of.name} {relation} {step} {form} {limit.name}")
        if draw.randrange(share):
            continue
        for variant in range(variants):
            ends = [c16.low(of), c16.high(of)] if of.bits <= 16 else [0, 40000]
            start = draw.choice([0, 1, 5, 10, 12, 30, 120] + [ends[0] + draw.randrange(4), ends[1] - draw.randrange(4)] +
                                ([-1, -7] if of.signed else []))
            if start == -32768:
                start += 1  # -32768 is a long
            constant = None
            if limit.name == "constant":
                limit_type = draw.choice([c16.INT, c16.INT, c16.UNSIGNED, c16.LONG, c16.UNSIGNED_LONG])
                value = draw.choice([0, 1, 5, 10, 15, 100, 127, 128, 255, 32767] +
                                    ([-1, -3, -128] if limit_type.signed else [65535]))
                constant = (value, limit_type, spelled(value, limit_type))
            annotated = step in ("*2", ">>1", "+s") or variant % 2 == 1
            counter = draw.choice(["v", "v", f"global{c16.TYPES.index(of)}", CELLS[c16.TYPES.index(of)]])
            loops.append(Loop(len(loops), counter, of, relation, step, form, limit, constant, start, annotated))
    return loops


def program(loops):
    calls = [f"\tr{loop.number} = f{loop.number}();" for loop in loops]
    table = ", ".join(str(i + 1) for i in range(TABLE))
    counters = " ".join(f"{of.name} global{i};" for i, of in enumerate(c16.TYPES))
    return "\n".join(['#include "plc.h"', f"unsigned table[{TABLE}] = {{{table}}}; unsigned s = 1; {counters}",
                      *[loop.text() for loop in loops], *[f"unsigned r{loop.number};" for loop in loops],
                      "void init(void) { plc1_time = 16; plc2_time = 1000; }", "void plc1(void) {", *calls, "}",
                      "void plc2(void) { }", ""])


def refused(plcxx, path, loops):
    """The messages of the loops that are refused. No run reports all of them: again without those that it has named."""
    messages = {}
    while True:
        asked = [loop for loop in loops if loop.number not in messages]
        path.write_text(program(asked))
        result = subprocess.run([plcxx, "check", str(path), "--set", "loop-warn=10000000"], capture_output=True, text=True,
                                check=False)
        found = re.findall(r":(\d+):\d+: error: (.*)", result.stdout + result.stderr)
        if result.returncode not in (0, 1) or (result.returncode == 1 and not found):
            sys.exit(f"{path}: check ends with {result.returncode}:\n{result.stderr[-2000:]}")
        for line, message in found:
            messages.setdefault(asked[int(line) - 3].number, []).append(message)
        if not found:
            return messages


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plcxx")
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--variants", type=int, default=2, help="of each combination; every second one is annotated")
    parser.add_argument("--share", type=int, default=8, help="one combination of so many, drawn by the seed")
    parser.add_argument("--engine", default="sim")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--size", type=int, default=600, help="functions of a program")
    arguments = parser.parse_args()
    shutil.rmtree(arguments.directory, ignore_errors=True)
    arguments.directory.mkdir(parents=True)
    loops = make(arguments.seed, arguments.variants, arguments.share)
    failures, runs, accepted, rejected = [], [], 0, 0
    for begin in range(0, len(loops), arguments.size):
        chosen = loops[begin:begin + arguments.size]
        path = arguments.directory / f"all{begin:05}.cld"
        errors = refused(arguments.plcxx, path, chosen)
        kept = []
        for loop in chosen:
            messages = errors.get(loop.number, [])
            if any("loop" not in message for message in messages):
                failures.append(f"{messages}: {loop.text()}")
            demand = None if loop.annotated else loop.demand()
            if loop.annotated and messages or demand is not None and demand == bool(messages):
                failures.append(f"{'refused' if messages else 'accepted'}: {loop.text()}")
            rejected += bool(messages)
            accepted += not messages
            if not messages:
                kept.append(loop)
        # Values of those that do not take too long.
        steps, counted, known = [], 0, {}
        for loop in kept:
            results = {limit: loop.execute(limit) for limit in {loop.values(setting) for setting in SETTINGS}}
            known |= {(loop.number, setting): results[loop.values(setting)] for setting in SETTINGS}
        kept = [loop for loop in kept if all(known[loop.number, s] for s in SETTINGS)]
        for setting in SETTINGS:
            expected = {f"r{loop.number}": known[loop.number, setting][0] for loop in kept}
            counted += sum(known[loop.number, setting][1] for loop in kept)
            expected["FAULT.count"] = counted
            steps += [f"- set: {{'R_ui[100]': {setting}}}", "- run: {fast: 1}",
                      "- expect: {" + ", ".join(f"{name}: {value}" for name, value in expected.items()) + "}"]
        name = f"loops{begin:05}"
        (arguments.directory / f"{name}.cld").write_text(program(kept))
        scenario = arguments.directory / f"{name}.yaml"
        scenario.write_text("\n".join(["dialect: hnc", f"sources: [{name}.cld]", "options: {loop-warn: 10000000}",
                                       "steps:", *steps, ""]))
        runs.append(str(scenario))
    # Once with what ranges and bounds have decided as assertions beside the code.
    for checked in ([], ["--checked"]):
        result = subprocess.run([arguments.plcxx, "test", "--engine", arguments.engine, *checked, *runs],
                                capture_output=True, text=True, check=False)
        output = (result.stdout + result.stderr).strip().splitlines()
        print(f"{accepted} loops accepted, {rejected} refused; {' '.join(checked)} {output[-1] if output else 'no output'}")
        if result.returncode != 0:
            failures.append("\n".join(line for line in output if not line.startswith("passed"))[:4000])
    print("\n".join(failures[:40]))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
