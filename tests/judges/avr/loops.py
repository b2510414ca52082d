"""The matrix of loops: counter's type and place x relation x step x form x limit, as one function a loop.

A loop shows how many rounds it made, the counter behind it, comparisons of the counter in the body and behind it, and an
element that the counter chooses.
"""
import dataclasses
import itertools
import random
import re

from counting import Count, TYPES, Verdict, bounds, in_range, verdict

AREAS = re.compile(r"\b([XYRPB])(?:_(uc|c|ui|i|ul|l))?\[")
VIEW = {"char": "c", "unsigned char": "uc", "int": "i", "unsigned": "ui", "long": "l", "unsigned long": "ul"}
SIZE = {"c": 1, "uc": 1, "i": 2, "ui": 2, "l": 4, "ul": 4}
STEPS = (1, 2, 3, 7, -1, -2, -3, -7, "*=", ">>=", "+=")
FORMS = ("for", "while", "do", "goto", "goto_first", "prefix", "postfix", "do_prefix", "do_postfix")
LIMITS = ("constant", "edge", "masked", "clamped", "full", "byte", "cell")
PLACES = ("local", "global", "static", "parameter", "cell")
EXTRAS = ("none", "break", "and", "and_behind", "continue", "inner", "forward", "call")
ELEMENTS = 12
INPUTS = ({"P": 0}, {"P": 9}, {"P": 14}, {"P": 0xFFFF}, {"P": 0x8003})


@dataclasses.dataclass
class Loop:
    serial: int
    slot: int
    kind: str
    place: str
    relation: str
    step: object
    form: str
    limit: str
    extra: str
    bound: int  # annotation, 0 without
    start: int = 0
    value: int = 0  # a constant limit

    def name(self):
        step = self.step if isinstance(self.step, str) else f"{self.step:+}"
        return f"{self.form} {self.kind} {self.place} {self.relation} {self.limit} {step} {self.extra}" + (
            f" bound {self.bound}" if self.bound else "")

    def limit_kind(self):
        if self.limit in ("constant", "edge"):
            for kind in ("int", "long", "unsigned long"):
                if bounds(kind)[0] <= self.value <= bounds(kind)[1]:
                    return kind
        return {"masked": "int", "clamped": "int", "byte": "unsigned char"}.get(self.limit, self.kind)

    def limit_range(self):
        if self.limit in ("constant", "edge"):
            return self.value, self.value
        return {"masked": (0, 15), "clamped": (0, 20)}.get(self.limit) or bounds(self.limit_kind())

    def count(self):
        when = {"for": "first", "while": "first", "goto_first": "first", "do": "last", "goto": "last", "prefix": "prefix",
                "do_prefix": "prefix", "postfix": "postfix", "do_postfix": "postfix"}[self.form]
        return Count(self.kind, self.start, self.relation, self.limit_kind(), self.step, when, not self.form.startswith("do_"))

    def verdict(self):
        if self.bound:
            return Verdict.ACCEPT
        if isinstance(self.step, str):
            return Verdict.REFUSE
        told = verdict(self.count(), *self.limit_range())
        if self.place == "parameter":
            # Nothing is known of the start.
            known = self.count().when == "first" and self.relation != "!=" and TYPES[self.kind][0] < 32
            known = known and in_range(self.count(), *self.limit_range())
            return told if told is Verdict.REFUSE or known else Verdict.OPEN
        return told


def choose(loop, seed):
    """Start and constant limit, the same ones in each run."""
    pick = random.Random(f"{seed} {loop.name()}")
    low, high = bounds(loop.kind)
    up = loop.step in ("*=", "+=") or (loop.step != ">>=" and loop.step > 0)
    starts = (0, 1, 3, 5) if up else (10, 20, 17, 100)
    loop.start = pick.choice([s for s in starts + ((-5, -20) if low < 0 else (2,)) if low <= s <= high])
    if loop.limit == "edge":
        # At most a few hundred rounds, so close to the end that counting further leaves the type.
        off = pick.choice((0, 0, 1, 2, 5))
        loop.value = high - off if up else low + off
        loop.start = max(low, high - pick.choice((10, 200, 90))) if up else min(high, low + pick.choice((10, 200, 90)))
    else:
        loop.value = pick.choice((10, 12, 14, 50, 100) if up else (0, 1, 5, -3, 3))
        if not low <= loop.value <= high:
            loop.value = 2
    if loop.relation == "!=" and loop.limit in ("constant", "edge") and not isinstance(loop.step, str) and pick.random() < 0.7:
        loop.start = loop.value - loop.step * pick.randrange(1, 12)
        if not low <= loop.start <= high:
            loop.start = loop.value
    return loop


def change(loop, counter, pick):
    if isinstance(loop.step, str):
        return {"*=": f"{counter} *= 2", ">>=": f"{counter} >>= 1", "+=": f"{counter} += by"}[loop.step]
    size = abs(loop.step)
    sign = "+" if loop.step > 0 else "-"
    forms = [f"{counter} {sign}= {size}", f"{counter} = {counter} {sign} {size}", f"{counter} {sign}= {size}"]
    if loop.step > 0:
        forms.append(f"{counter} = {size} + {counter}")
    if size == 1:
        forms += [f"{counter}{sign}{sign}", f"{sign}{sign}{counter}"] * 2
    return pick.choice(forms)


def constant(value):
    """Written so that its type is the smallest that holds it, and the most negative one is itself."""
    if value == -32768:
        return "(-32767 - 1)"
    if value == -2147483648:
        return "(-2147483647L - 1)"
    return str(value)


class Text:
    """The loop's function; what is to be found again in it is its keyword."""

    def __init__(self, loop):
        self.loop, self.pick = loop, None
        self.cell = f"R_{VIEW[loop.kind]}[{400 // SIZE[VIEW[loop.kind]] + loop.serial % 8}]"
        self.counter = self.cell if loop.place == "cell" else f"g{loop.serial}" if loop.place == "global" else "i"
        self.rows, self.annotated = [], None

    def limit(self):
        loop = self.loop
        if loop.limit in ("constant", "edge"):
            return constant(loop.value), []
        view = VIEW[loop.kind]
        if loop.limit == "byte":
            return "P_uc[0]" if loop.serial % 2 else "X[7]", []
        if loop.limit == "cell":
            return f"P_{view}[0]", []
        if loop.limit == "masked":
            return "n", ["int n = P_i[0] & 15;"]
        if loop.limit == "clamped":
            return "n", ["int n = P_i[0];", "if (n > 20) n = 20;", "if (n < 0) n = 0;"]
        return "n", [f"{loop.kind} n = P_{view}[0];"]

    def body(self, limit):
        loop, i = self.loop, self.counter
        rows = ["c++;", f"s += {i};", f"if ({i} {self.pick.choice(('<', '<=', '>', '>=', '==', '!='))} {limit}) h++;"]
        if loop.extra == "break":
            rows.append(f"if ({i} == {self.pick.choice((4, 6, 7, 11))}) break;" if "goto" not in loop.form else
                        f"if ({i} == {self.pick.choice((4, 6, 7, 11))}) goto out;")
        elif loop.extra == "continue" and loop.form == "for":
            rows.append(f"if ({i} & 1) continue;")
        elif loop.extra == "inner":
            rows.append("for (k = 0; k <= 4; k += 2) { if (X[k] & 1) continue; h++; }")
        elif loop.extra == "forward":
            rows += [f"if ({i} & 2) goto skip;", "h += 2;", "skip: h++;"]
        elif loop.extra == "call":
            rows.append("other();")
        return rows

    def condition(self, counter, limit):
        own = f"{counter} {self.loop.relation} {limit}"
        if self.loop.relation == "!=" and limit == "0" and self.pick.random() < 0.5:
            own = counter
        if self.loop.extra == "and":
            return f"X[5] == 0 && {own}"
        if self.loop.extra == "and_behind":
            return f"{own} && X[6] < 50"
        return own

    def lines(self, side):
        """`side` is plc or avr: there an annotation is a guard that leaves the loop with fault 3."""
        loop, i = self.loop, self.counter
        self.pick = random.Random(f"text {loop.serial} {loop.name()}")
        limit, setup = self.limit()
        declarations = [row for row in setup if not row.startswith("if")]
        head = []
        if loop.place in ("local", "static"):
            head.append(f"{'static ' if loop.place == 'static' else ''}{loop.kind} i;")
        rows = [f"unsigned c = 0, h = 0, u = 0; long s = 0; int k, by = {1 + loop.serial % 3}, guard = 0;"]
        rows += declarations + [row for row in setup if row.startswith("if")]
        step = change(loop, i, self.pick)
        body = self.body(limit)
        guard, note = [], []
        if loop.bound and side == "plc":
            note = [f"//@loop_bound {loop.bound}"]
        elif loop.bound:
            guard = [f"if (guard++ == {loop.bound}) {{ fault(3); goto out; }}"]
        start = f"{i} = {constant(loop.start)};" if loop.place != "parameter" else ""
        self.keyword = {"for": "for (", "while": "while (", "goto": "goto again", "goto_first": "goto again"}.get(
            loop.form, "do" if loop.form.startswith("do") else "while (")
        condition = self.condition(i, limit)
        operator = "++" if loop.step in (1,) else "--"
        fixed = self.condition(f"{operator}{i}" if "prefix" in loop.form else f"{i}{operator}", limit)
        # for a guard at the end of the body the bound is compared with the rounds made
        late = [row.replace("guard++ ==", "++guard ==") for row in guard]
        if loop.form == "for" and self.pick.random() < 0.6 and start:
            rows += note + [f"for ({start[:-1]}; {condition}; {step}) {{ /*loop*/"] + guard + body + ["}"]
        elif loop.form == "for":
            rows += [start] + note + [f"for (; {condition}; {step}) {{ /*loop*/"] + guard + body + ["}"]
        elif loop.form == "while":
            rows += [start] + note + [f"while ({condition}) {{ /*loop*/"] + guard + body + [step + ";", "}"]
        elif loop.form == "prefix" or loop.form == "postfix":
            rows += [start] + note + [f"while ({fixed}) {{ /*loop*/"] + guard + body + ["}"]
        elif loop.form == "do":
            if late:
                rows += [start, "do {"] + body + [step + ";", f"if (!({condition})) goto out;", *late, "} while (1);"]
            else:
                rows += [start] + note + ["do { /*loop*/"] + body + [step + ";", f"}} while ({condition});"]
        elif loop.form in ("do_prefix", "do_postfix"):
            if late:
                rows += [start, "do {"] + body + [f"if (!({fixed})) goto out;", *late, "} while (1);"]
            else:
                rows += [start] + note + ["do { /*loop*/"] + body + [f"}} while ({fixed});"]
        elif loop.form == "goto":
            rows += [start] + note + ["again:"] + body + [step + ";"]
            if late:
                rows += [f"if (!({condition})) goto out;", *late, "goto again;"]
            else:
                rows += [f"if ({condition})", "goto again; /*loop*/"]
        else:
            rows += [start] + note + ["again:", f"if ({condition}) {{"] + body + [step + ";", *late, "goto again; /*loop*/", "}"]
        rows += ["out: k = 0;"] if any("goto out" in row for row in rows) else []
        rows += self.uses(i, limit)
        parameter = f"{loop.kind} i" if loop.place == "parameter" else "void"
        rows = [f"void loop{loop.serial}({parameter})", "{"] + head + rows + ["}"]
        return [spell(row, side) for row in rows if row]

    def uses(self, i, limit):
        loop = self.loop
        size = 1 if isinstance(loop.step, str) else loop.step
        rows = [f"if ({i} {relation} {limit}) u |= {1 << bit};" for bit, relation in enumerate(("<", "<=", ">", ">=", "==", "!="))]
        constants = {loop.value, loop.value + size, loop.value + 1, loop.value - 1, 10} if limit != "n" else {15, 20 + size, size, 0}
        low, high = bounds(loop.kind)
        for bit, value in enumerate(sorted(v for v in constants if low <= v <= high)):
            rows.append(f"if ({i} {self.pick.choice(('<', '>', '==', '>=', '<='))} {constant(value)}) u |= {hex(1 << (6 + bit))};")
        slot = loop.slot
        return rows + [f"cnt[{slot}] = c; hit[{slot}] = h; use[{slot}] = u; sum[{slot}] = s; end[{slot}] = {i};",
                       f"if ({i} < 1000 && {i} > -1000) got[{slot}] = AT(table, {i});" if TYPES[loop.kind][1] else
                       f"if ({i} < 1000) got[{slot}] = AT(table, {i});"]


def spell(row, side):
    if side == "plc":
        return re.sub(r"AT\((\w+), (.*)\);", r"\1[\2];", row)
    return AREAS.sub(lambda m: f"{m[1]}.{m[2] or ('ui' if m[1] in 'PB' else 'uc')}[", row)


def matrix(thin=1):
    """The loops, each `thin`-th of the full matrix; what is not a dimension of it rotates."""
    number = 0
    for relation, step, form, limit, kind in itertools.product(("<", "<=", ">", ">=", "!="), STEPS, FORMS, LIMITS, TYPES):
        if "fix" in form and step not in (1, -1):
            continue
        number += 1
        rotating = random.Random(number)
        place, extra = rotating.choice(PLACES), rotating.choice(EXTRAS + ("none",) * 4)
        if rotating.randrange(thin):
            continue
        bound = rotating.choice((2, 5, 40)) if isinstance(step, str) and rotating.random() < 0.6 or rotating.random() < 0.08 else 0
        yield choose(Loop(number, 0, kind, place, relation, step, form, limit, extra, bound), number)
