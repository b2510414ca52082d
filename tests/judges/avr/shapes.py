"""How large a program is and what it is made of: one of three has the usual shape, the others draw their own.

Also the forms of statements that only some programs have: chains of else, selections of other shapes, loops with a part of
their head elsewhere.
"""
import dataclasses

import spelled
from spelled import INTEGERS, SIZES


@dataclasses.dataclass
class Shape:
    depth: int = 3  # of statements in one another
    block: int = 4  # statements in a row, at most one fewer
    expression: int = 3  # operators in one another
    functions: int = 5
    parameters: int = 4
    variables: tuple = (5, 12)
    part: int = 6
    kinds: tuple = INTEGERS  # of variables
    loops: int = 100  # of hundred loops that are drawn
    calls: int = 100


def draw(random):
    if random.randrange(3) == 0:
        return Shape()
    few = tuple(random.sample(INTEGERS, random.randrange(1, 4)))
    depth = random.choice((1, 2, 3, 3, 4, 5, 6))
    return Shape(depth=depth, block=2 if depth > 4 else 3 if depth > 3 else random.choice((2, 3, 4, 6)),
                 expression=random.choice((1, 2, 3, 3, 4)), functions=random.choice((1, 1, 3, 6, 9)), parameters=random.choice((1, 2, 4, 7)),
                 variables=random.choice(((1, 3), (3, 8), (8, 16), (16, 25))), part=random.choice((1, 3, 6, 10)),
                 kinds=random.choice((INTEGERS, few)), loops=random.choice((20, 100, 100)), calls=random.choice((30, 100)))


class Forms:
    def chain(self, depth):
        """if ... else if ... else, with and without braces."""
        from statements import Lines, both
        made = Lines()
        for number in range(self.random.randrange(2, 5)):
            test = self.condition(1)
            head = "if" if number == 0 else "else if"
            braces = self.chance(60)
            inner = self.several(depth - 1, 2) if braces else self.unbraced()
            made += Lines([f"{head} ({test.plc})" + " {" * braces], [f"{head} ({test.avr})" + " {" * braces]) + inner + both("}" if braces else "")
        if self.chance(60):
            made += both("else") + self.unbraced()
        return made

    def unbraced(self):
        return self.simple(self.assigned(2))

    def dangling(self):
        """The else belongs to the inner if."""
        from statements import Lines, both
        one, other = self.condition(1), self.condition(1)
        return Lines([f"if ({one.plc}) if ({other.plc})"], [f"if ({one.avr}) if ({other.avr})"]) + self.unbraced() + both("else") + self.unbraced()

    def odd_selection(self, depth):
        """switch without braces, with nothing in it, with labels in ifs and blocks, over long, with cases beyond int."""
        from statements import Lines, both
        kind = self.random.choice(("int", "unsigned", "long", "unsigned long"))
        selector = self.integer(2)
        if selector.kind != kind:
            selector = spelled.cast(kind, selector)
        if self.chance(50):
            selector = spelled.binary("&", selector, spelled.literal(self.random.choice(("3", "1", "7"))))
        self.note(selector)
        head = Lines([f"switch ({selector.plc})"], [f"switch ({selector.avr})"])
        values = ["0", "1", "2", "3", "-1", "1 + 3", "'c'", "sizeof(long) * 2", "~1", "(char) 200", "1 ? 5 : 6"] + self.enumerators_apart
        if "long" in kind:
            values += ["65535", "-1L", "70000", "0x80000000", "-32768"]
        if kind in ("unsigned", "unsigned long"):
            values += ["65535u", "0x8000"]
        pick = self.random.randrange(4)
        if pick == 0:
            label = self.random.choice(("default", f"case {self.random.choice(values)}"))
            return head + both(f"{label}:") + self.unbraced()
        value = iter(self.distinct(values, kind))
        if pick == 1:
            return head + both(f"{{ default: case {next(value)}: case {next(value)}:") + self.unbraced() + both("}")
        self.loops.append("switch for" if self.loops and "for" in self.loops[-1] else "switch")
        test = self.condition(1)
        made = head + both("{") + both(f"case {next(value)}:") + Lines([f"if ({test.plc}) {{"], [f"if ({test.avr}) {{"])
        made += self.several(depth - 1, 2) + both(f"case {next(value)}:") + self.several(depth - 1, 2)
        if self.chance(50):
            made += both("break;")
        made += both("}") + both("else {") + both(f"default: {{ case {next(value)}:") + self.several(depth - 1, 2) + both("}") + both("}")
        made += both(f"case {next(value)}:") + self.several(depth - 1, 2) + both("}")
        self.loops.pop()
        return made

    def distinct(self, values, kind):
        """Constants that are different numbers in the type."""
        known = {"1 + 3": 4, "'c'": 99, "sizeof(long) * 2": 8, "~1": -2, "(char) 200": 200 if self.options.get("char") else -56, "1 ? 5 : 6": 5,
                 "-1L": -1, "65535u": 65535, **self.enumerator_values}
        bits = 8 * SIZES[kind]
        taken, made = set(), []
        for text in self.random.sample(values, len(values)):
            number = known[text] if text in known else int(text, 0)
            if (number & (1 << bits) - 1) not in taken:
                taken.add(number & (1 << bits) - 1)
                made.append(text)
        return made

    def odd_loop(self, depth):
        """A loop whose head lacks a part, or whose counter changes in its test."""
        from statements import Lines, MOST_ROUNDS, block, both
        most = self.random.randrange(2, 8)
        if self.rounds * (most + 2) > MOST_ROUNDS:
            return both(";")
        counter, declaration = self.counter()
        name, form = counter.name, self.random.randrange(6)
        self.protected.add(name)
        self.rounds *= most + 2
        self.body.rounds = max(self.body.rounds, self.rounds)
        self.loops.append("for" if form in (1, 3, 4) else "loop")
        inner = self.several(depth - 1, self.shape.block)
        if form == 2 and "continue" not in self.loops[-1] and self.chance(50):
            test = self.condition(1)
            inner += Lines([f"if ({test.plc}) break;"], [f"if ({test.avr}) break;"])
        if form in (3, 4, 1) and self.chance(40):
            test = self.condition(1)
            word = self.random.choice(("continue", "break"))
            inner = Lines([f"if ({test.plc}) {word};"], [f"if ({test.avr}) {word};"]) + inner
        self.loops.pop()
        self.rounds //= most + 2
        real = self.real_condition(1) if self.has_reals and self.chance(50) else self.condition(1)
        self.protected -= {name}
        also = real.at(6)
        if form == 0:
            made = both(f"for ({name} = 0; {name} < {most};) {{") + inner + both(f"{name}++; }}")
        elif form == 1:
            made = both(f"{name} = 0; for (; {name} < {most}; {name}++) {{") + inner + both("}")
        elif form == 2:
            made = both(f"for ({name} = {most}; ; {name}--) {{") + inner + both("break; }")
        elif form == 3:
            made = both(f"{name} = {most}; do {{") + inner + Lines([f"}} while (--{name} > 0 && {also.plc});"], [f"}} while (--{name} > 0 && {also.avr});"])
        elif form == 4:
            made = both(f"{name} = {most}; while ({name}--) {{") + inner + both("}")
        else:
            guard, bound, test = self.fresh("n"), self.random.randrange(1, 5), real
            self.body.hoisted.append(f"int {guard} = 0;")
            self.body.writes |= {"FAULT"}
            note = self.random.choice((f"#pragma plcxx loop_bound({bound})", f"/*@loop_bound {bound}@*/", f"//@loop_bound {bound}"))
            made = Lines([note, "do {"], [f"{guard} = 0;", "do {"]) + inner
            made += Lines([f"}} while ({test.plc});"], [f"}} while (({test.avr}) && (++{guard} < {bound} || (fault(3), 0)));"])
        return block(declaration + made) if declaration.plc else made
