"""Random small machines of every dialect, and random properties of them.

A machine is a few statements over a few bits and words, so that by chance many properties hold and many do not. All
six generators give the same things: text of the program, bits, numbers with their greatest value, inputs as scenarios
set them, the flag that the program only takes back (somebody else sets it), bits that the control takes back, and the
milliseconds of a period.
"""
import random


class Machine:
    flag = ""  # that the program only takes back
    is_taken = False
    cleared = []  # by the control, when it likes

    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.lines = []

    def one(self, rows):
        return self.rng.choice(rows)

    def chance(self, probability):
        return self.rng.random() < probability

    def bits(self):
        return self.inputs + self.coils + ([self.flag] if self.is_taken else [])

    def taken(self):
        self.is_taken = True
        self.take_back()

    def contacts(self, most=3):
        """(operator, negated, bit): "and" or "or", from left to right; the first operator says nothing."""
        return [(self.one(["and", "and", "or"]), self.chance(0.35), self.one(self.bits()))
                for _ in range(self.rng.randint(1, most))]

    def statements(self, kinds, least=4, most=9):
        for _ in range(self.rng.randint(least, most)):
            getattr(self, self.one(kinds))()


class Nc110(Machine):
    dialect, suffix, period_ms = "nc110", "plc", 10
    inputs = [f"I0A{i}" for i in range(4)]
    coils = [f"U4A{i}" for i in range(6)] + ["T1U", "C1R"]
    targets = [f"U4A{i}" for i in range(6)]
    numbers = {"W30K0": 255, "W30K1": 255, "C1W": 255}
    words = ["W30K0", "W30K1"]
    input_words = []
    flag = "U50K3"

    def take_back(self):
        self.lines.append(f"U50K3=U50K3*/({self.expression()})")

    def expression(self):
        text = ""
        for i, (operator, negated, bit) in enumerate(self.contacts()):
            text += ("*" if operator == "and" else "+") if i else ""
            text += ("/" if negated else "") + bit
        if self.chance(0.2):
            text = f"[{self.one(list(self.numbers))}{self.one('<=>')}{self.rng.randrange(6)}]*({text})"
        return text

    def coil(self):
        self.lines.append(f"{self.one(self.targets)}={self.expression()}")

    def latch(self):
        target = self.one(self.targets)
        self.lines.append(f"{target}=({target}+{self.expression()})*/({self.expression()})")

    def timer(self):
        self.lines.append(f"T1I({self.rng.randint(1, 3)})={self.expression()}")

    def counter(self):
        self.lines.append(f"C1Z={self.expression()}")
        self.lines.append(f"C1I({self.rng.randint(2, 6)})={self.expression()}")

    def pulse(self):
        self.lines.append(f"P1={self.expression()}")
        self.lines.append(f"{self.one(self.targets)}=P1")

    def count(self):
        word = self.one(self.words)
        change = self.one([f"[{word}+1]", f"[{word}-1]", str(self.rng.randrange(6)), f"[{self.one(self.words)}+1]"])
        self.lines.append(f"DOF: {self.expression()}\n  {word}={change}\nENDF")

    def text(self):
        self.statements(["coil", "coil", "latch", "latch", "timer", "counter", "pulse", "count", "count", "taken"])
        split = self.rng.randint(0, len(self.lines)) if self.chance(0.4) else 0
        # A one-shot or a counter of both parts is refused or warned of: they stay together.
        fast = [line for line in self.lines[:split] if line[0] == "U" and "P1" not in line]
        slow = [line for line in self.lines if line not in fast]
        return "\n".join(fast + ["$"] + slow) + "\n"


class Host50(Machine):
    dialect, suffix, period_ms = "host50", "il", 1
    timers = 0
    inputs = [f"I{i}" for i in range(4)]
    coils = [f"Q{i}" for i in range(5)] + ["B0", "B1"]
    numbers = {"W0": 65535, "W1": 65535}
    input_words = []
    flag = "B600"

    def take_back(self):
        self.expression()
        self.lines.append("RST %B600")

    def expression(self):
        for i, (operator, negated, bit) in enumerate(self.contacts()):
            word = "LD" if i == 0 else ("AND" if operator == "and" else "OR")
            self.lines.append(f"{word}{'I' if negated else ''} %{bit}")
        if self.chance(0.2):
            self.lines.append(f"{self.one(['EQ', 'GE', 'LT', 'NE'])} %{self.one(['W0', 'W1'])}, {self.rng.randrange(6)}")

    def coil(self):
        self.expression()
        self.lines.append(f"OUT %{self.one(self.coils)}")

    def latch(self):
        target = self.one(self.coils)
        for word in self.rng.sample(["SET", "RST"], 2):
            self.expression()
            self.lines.append(f"{word} %{target}")

    def timer(self):
        self.expression()
        self.timers += 1  # each block has one of its own
        self.lines.append(f"{self.one(['TONMS', 'TOFMS', 'TPMS'])} %TM{self.timers}, {self.rng.randint(1, 20)}")
        self.lines.append(f"OUT %{self.one(self.coils)}")

    def counter(self):
        self.expression()
        self.lines.append(f"CNUD %C1, {self.rng.randint(2, 6)}, P=%{self.one(self.inputs)}, M={self.rng.randint(0, 1)}, "
                          f"N={self.rng.randint(0, 1)}")
        self.lines.append(f"OUT %{self.one(self.coils)}")

    def pulse(self):
        self.lines.append(f"{self.one(['LDP', 'LDF'])} %{self.one(self.bits())}")
        self.lines.append(f"{self.one(['OUT', 'SET', 'RST'])} %{self.one(self.coils)}")

    def count(self):
        self.expression()
        word = self.one(["W0", "W1"])
        self.lines.append(self.one([f"ADDW %{word}, 1, %{word}", f"MOV {self.rng.randrange(6)}, %{word}",
                                    "ADDW %W0, 1, %W1", f"SUBW %{word}, 1, %{word}"]))

    def text(self):
        self.lines = [f"SLOWDIV {self.one([1, 2, 4])}", "SLOW", "NETWORK"]
        kinds = ["coil", "coil", "latch", "latch", "timer", "pulse", "count", "count", "taken"]
        self.statements(kinds)
        if self.chance(0.5):
            self.counter()
        return "\n".join(self.lines + ["END_SLOW"]) + "\n"


class Prostep(Machine):
    dialect, suffix, period_ms = "prostep", "plc", 12
    inputs = [f"I 3.{i}" for i in range(4)]
    coils = [f"O 0.{i}" for i in range(5)] + ["F 1.0", "F 1.1"]
    numbers = {"DB 60": 255, "DB 61": 255}
    input_words = []
    flag = "F 100.0"

    def take_back(self):
        self.expression()
        self.lines.append(":R F 100.0")

    def expression(self):
        for i, (operator, negated, bit) in enumerate(self.contacts()):
            word = "A" if i == 0 or operator == "and" else "O"
            self.lines.append(f":{word}{'N' if negated else ''} {bit}")

    def coil(self):
        self.expression()
        self.lines.append(f":= {self.one(self.coils)}")

    def latch(self):
        target = self.one(self.coils)
        for word in self.rng.sample("SR", 2):
            self.expression()
            self.lines.append(f":{word} {target}")

    def timer(self):
        self.expression()
        number = self.rng.randint(1, 2)
        self.lines.append(f":{self.one(['SP', 'SE', 'SR', 'SS', 'SF'])} T {number}")
        self.lines.append(f": K {self.one(['0', '1'])}00{self.rng.randint(1, 6)}D")
        self.lines.append(f":A T {number}")
        self.lines.append(f":= {self.one(self.coils)}")

    def counter(self):
        self.expression()
        self.lines.append(f":{self.one(['CU', 'CD'])} C 1")
        self.expression()
        self.lines.append(":R C 1")
        self.lines.append(f":A C 1")
        self.lines.append(f":= {self.one(self.coils)}")

    def compare(self):
        self.lines += [f":L {self.one(list(self.numbers))}", f":{self.one(['!=', '><', '>', '<'])}",
                       f": K {self.rng.randrange(6)}", f":= {self.one(self.coils)}"]

    def count(self):
        label = f"DAL{len(self.lines)}"
        word = self.one(list(self.numbers))
        flag = "F 2.0"
        self.expression()
        self.lines.append(f":= {flag}")
        self.lines.append(f":AN {flag}")
        self.lines.append(f":JC {label}")
        if self.chance(0.5):
            self.lines += [":L", f": K {self.rng.randrange(6)}", f":T {word}"]
        else:
            self.lines += [f":L {self.one(list(self.numbers))}", f":JU FM {self.one([13, 14])}", f":T {word}"]
        self.lines.append(f"{label} :NOP")

    def text(self):
        self.statements(["coil", "coil", "latch", "latch", "timer", "counter", "compare", "count", "count", "taken"])
        return "\n".join([":MOD PM 0", ":A I 20.1", ":S F 251.0", ":END PM 0", ":MOD PM 9"] + self.lines +
                         [":END PM 9"]) + "\n"


class Technol(Machine):
    dialect, suffix, period_ms = "technol", "plc", 20
    inputs = [f"I{i}" for i in range(4)]
    coils = [f"Q{i}" for i in range(6)] + ["M1", "M2"]
    targets = [f"Q{i}" for i in range(6)]
    numbers = {"N1": 255, "N2": 255}
    input_words = []
    labels = 0
    flag = "NC1"

    def take_back(self):
        self.expression()
        self.lines.append(" FL1 0,NC1")

    def label(self):
        self.labels += 1
        return f"L{self.labels}"

    def expression(self):
        for i, (operator, negated, bit) in enumerate(self.contacts()):
            word = "LDR" if i == 0 else ("LA" if operator == "and" else "LO")
            self.lines.append(f" {word} {'-' if negated else ''}{bit}")

    def coil(self):
        self.expression()
        self.lines.append(f" WR {self.one(self.targets)}")

    def latch(self):
        target = self.one(self.targets)
        for value in self.rng.sample([0, 1], 2):
            self.expression()
            self.lines.append(f" FL1 {value},{target}")

    def change(self):
        number, other = self.one(["N1", "N2"]), self.one(["N1", "N2"])
        self.lines += self.one([[f" LOD CNST.{self.rng.randrange(6)}"], [f" LOD {other}", " AD CNST.1"],
                                [f" LOD {other}", " SU CNST.1"]]) + [f" STO {number}"]

    def count(self):
        label = self.label()
        self.expression()
        self.lines.append(f" JL0 {label}")
        self.change()
        self.lines.append(f"{label}:")

    def compare(self):
        self.lines += [f" LOD {self.one(['N1', 'N2'])}", f" {self.one(['EQ', 'GT', 'LT'])} CNST.{self.rng.randrange(6)}",
                       f" WR {self.one(self.targets)}"]

    def start(self):
        self.expression()
        self.lines.append(f" FL1 1,{self.one(['M1', 'M2'])}")

    def stop(self):
        label = self.label()
        self.expression()
        self.lines += [f" JL0 {label}", f" MECH_INIT {self.one(['M1', 'M2'])}", f"{label}:"]

    def mechanism(self, name):
        self.lines.append(f" MECH_BEGIN {name}")
        for _ in range(self.rng.randint(2, 5)):
            kind = self.rng.randrange(5)
            if kind < 2:
                self.lines.append(f" FL {self.rng.randint(0, 1)},{self.one(self.targets)}")
            elif kind == 2:
                self.lines.append(f" TIM -,{self.rng.randint(1, 4)}")
            elif kind == 3:
                self.lines += [f" LDR {self.one(self.bits())}", f" EX{self.rng.randint(0, 1)}"]
            else:
                self.change()
        self.lines.append(f" MECH_END {name}")

    def text(self):
        self.lines = []
        fast = []
        if self.chance(0.3):
            self.latch()
            fast = [" MODULE_FAST"] + self.lines + [" MODULE_FAST_END"]
            self.lines = []
        self.statements(["coil", "latch", "latch", "count", "compare", "start", "stop", "taken"], 3, 7)
        self.start()
        self.mechanism("M1")
        self.mechanism("M2")
        head = [" DATA", "IN0: DFM I0,I1,I2,I3,,,,", "OUT0: DFM Q0,Q1,Q2,Q3,Q4,Q5,,", "N1: DS 1", "N2: DS 1",
                "FLAGS: DFM NC1,,,,,,,",
                " DATA_END"]
        return "\n".join(head + fast + [" MODULE_MAIN"] + self.lines + [" MODULE_MAIN_END", " STOP"]) + "\n"


class Hnc(Machine):
    dialect, suffix, period_ms = "hnc", "cld", 8
    inputs = [f"X0.{i}" for i in range(4)]
    coils = [f"Y0.{i}" for i in range(5)]
    numbers = {"n": (-32768, 32767), "k": 255, "row[1]": 255, "step": 255}
    input_words = ["X[1]"]

    def bit(self, name):
        return f"({name[0]}[0] >> {name[3]} & 1)"

    def expression(self):
        text = ""
        for i, (operator, negated, bit) in enumerate(self.contacts()):
            text += (" && " if operator == "and" else " || ") if i else ""
            text += ("!" if negated else "") + self.bit(bit)
        if self.chance(0.25):
            text = f"({text}) && {self.one(['n', 'k', 'step', 'X[1]', 'row[k & 3]'])} {self.one(['<', '==', '>'])} " \
                   f"{self.rng.randrange(6)}"
        return text

    def put(self, coil, value):
        mask = 1 << int(coil[3])
        return f"Y[0] |= {mask};" if value else f"Y[0] &= ~{mask};"

    def coil(self):
        coil = self.one(self.coils)
        self.lines.append(f"if ({self.expression()}) {self.put(coil, 1)} else {self.put(coil, 0)}")

    def latch(self):
        coil = self.one(self.coils)
        for value in self.rng.sample([0, 1], 2):
            self.lines.append(f"if ({self.expression()}) {self.put(coil, value)}")

    def count(self):
        number = self.one(["n", "k", "row[k & 3]", "row[n & 3]"])
        change = self.one([f"{number}++", f"{number}--", f"{number} = {self.rng.randrange(6)}", "n = k + 1",
                           "n = row[1] - row[2]", f"k = (k + 1) % {self.rng.randint(2, 6)}"])
        self.lines.append(f"if ({self.expression()}) {change};")

    def chain(self):
        cases = ""
        steps = self.rng.randint(2, 4)
        for i in range(steps):
            cases += f" case {i}: {self.put(self.one(self.coils), self.rng.randint(0, 1))} if ({self.expression()}) " \
                     f"step = {(i + 1) % steps}; break;"
        self.lines.append("switch (step) {" + cases + " }")

    def loop(self):
        self.lines.append(f"for (i = 0; i < {self.rng.randint(2, 4)}; i++) "
                          + self.one(["row[i] = row[i] + (X[0] >> i & 1);", "if (row[i] > 3) row[i] = 0;",
                                      "if (row[i] == k) n = i;"]))

    def text(self):
        self.statements(["coil", "coil", "latch", "latch", "count", "count", "loop"])
        if self.chance(0.6):
            self.chain()
        split = self.rng.randint(0, len(self.lines)) if self.chance(0.5) else 0
        fast, slow = "\n    ".join(self.lines[:split]), "\n    ".join(self.lines[split:])
        return ('#include "plc.h"\nint n;\nunsigned char k, step, row[4];\n'
                "void init() { plc1_time = 8; plc2_time = 8; }\n"
                f"void plc1()\n{{\n    int i;\n    i = 0;\n    {fast}\n}}\n"
                f"void plc2()\n{{\n    int i;\n    i = 0;\n    {slow}\n}}\n")


class Classicladder(Machine):
    dialect, suffix, period_ms = "classicladder", "clp", 1
    inputs = [f"I{i}" for i in range(4)]
    coils = [f"Q{i}" for i in range(5)] + ["B0", "B1"]
    numbers = {"W0": 255, "W1": 255}
    input_words = []
    flag = "B9"
    kinds = {"I": 50, "Q": 60, "B": 0}

    def element(self, kind, name):
        return f"{kind}-0-{self.kinds[name[0]]}/{name[1:]}"

    def rung(self, end, width=1):
        """Rows of contacts in series, joined; behind them `end`, `width` cells."""
        rows = [[]]
        for operator, negated, bit in self.contacts():
            if operator == "or" and rows[-1]:
                rows.append([])
            edge = self.rng.choice([3, 4]) if self.chance(0.1) else 0
            rows[-1].append(self.element(edge or (2 if negated else 1), bit))
        lines = []
        for i, row in enumerate(rows):
            cells = row + ["9-0-0/0"] * (3 - len(row))
            if i == 0:
                lines.append(cells + ["9-0-0/0"] * (7 - width) + end)
            else:
                lines.append(cells + ["0-1-0/0"] + ["0-0-0/0"] * 6)
        self.lines.append([" , ".join(cells) for cells in lines])

    def coil(self):
        self.rung([self.element(50, self.one(self.coils))])

    def latch(self):
        coil = self.one(self.coils)
        for kind in self.rng.sample([52, 53], 2):
            self.rung([self.element(kind, coil)])

    def take_back(self):
        self.rung([self.element(53, self.flag)])

    def block(self, kind, expression):
        self.expressions.append(expression)
        return ["99-0-0/0", "99-0-0/0", f"{kind}-0-0/{len(self.expressions) - 1}"]

    def count(self):
        word, other = self.one([0, 1]), self.one([0, 1])
        change = self.one([f"@200/{word}@+1", f"(@200/{word}@+1)%{self.rng.randint(2, 6)}", str(self.rng.randrange(6)),
                           f"@200/{other}@+1", f"@200/{word}@-1"])
        self.rung(self.block(60, f"@200/{word}@:={change}"), 3)

    def compare(self):
        cells = ["9-0-0/0"] + self.block(20, f"@200/{self.one([0, 1])}@{self.one(['<', '=', '>'])}{self.rng.randrange(6)}")
        self.lines.append([" , ".join(cells + ["9-0-0/0"] * 5 + [self.element(50, self.one(self.coils))])])

    def text(self):
        self.expressions = []
        self.statements(["coil", "coil", "latch", "latch", "count", "compare", "taken"])
        parts = {"sections.csv": ["#VER=1.0", f"000,0,-1,0,{len(self.lines) - 1},0"],
                 "arithmetic_expressions.csv": ["#VER=2.0"] + [f"{i:04d},{one}" for i, one in enumerate(self.expressions)]}
        for i, rows in enumerate(self.lines):
            parts[f"rung_{i}.csv"] = ["#VER=2.0", f"#NEXTRUNG={i + 1 if i + 1 < len(self.lines) else -1}"] + rows
        text = "".join(f"_FILE-{name}\n" + "\n".join(lines) + f"\n_/FILE-{name}\n" for name, lines in parts.items())
        return f"_FILES_CLASSICLADDER\n{text}_/FILES_CLASSICLADDER\n"


MACHINES = {machine.dialect: machine for machine in (Nc110, Host50, Prostep, Technol, Hnc, Classicladder)}


def quoted(location):
    return f"'{location}'"


def properties(machine, count):
    rng = machine.rng
    bits, numbers = machine.bits(), list(machine.numbers)
    outputs = machine.coils

    def bit(rows=bits):
        return quoted(rng.choice(rows)) + (" is 0" if rng.random() < 0.3 else "")

    def number():
        name = rng.choice(numbers)
        low = rng.randrange(5)
        return rng.choice([f"{quoted(name)} in {0 if rng.random() < 0.7 else low}..{low + rng.randrange(8)}",
                           f"{quoted(name)} != {low}", f"{quoted(name)} <= {low}",
                           f"{quoted(name)} is {low} implies {bit()}", f"{bit()} implies {quoted(name)} < {low + 1}"])

    def pair(word):
        return f"{word} " + ", ".join(quoted(one) for one in rng.sample(outputs, rng.randint(2, 3)))

    def condition(depth):
        """Anything of the grammar that is no count of several."""
        if depth == 0 or rng.random() < 0.2:
            return rng.choice([bit, bit, comparison])()
        one, other = condition(depth - 1), condition(depth - 1)
        return rng.choice([f"({one} and {other})", f"({one} or {other})", f"not ({one})", f"({one})",
                           f"({one}) for {rng.randint(1, 3)} slow",
                           f"(at most one of ({one}), {bit()}, not {bit()})",
                           f"(exactly one of {bit()}, ({other}))"])

    def comparison():
        one, other = quoted(rng.choice(numbers)), quoted(rng.choice(numbers))
        relation = rng.choice(["=", "!=", "<", "<=", ">", ">="])
        return rng.choice([f"{one} {relation} {rng.randrange(6)}", f"{one} {relation} {other}",
                           f"{rng.randrange(6)} {relation} {one}", f"{one} in {rng.randrange(3)}..{rng.randint(3, 9)}",
                           f"bit {rng.randrange(4)} of {one}"])

    def one():
        return rng.choice([
            lambda: f"never {condition(2)} and {bit(outputs)}",
            lambda: f"always {condition(3)}",
            lambda: f"{condition(2)} implies {condition(2)}",
            lambda: f"{condition(1)} implies {condition(1)} within {rng.randint(1, 3) * machine.period_ms} ms",
            lambda: f"never {bit(outputs)} and {bit()}",
            lambda: f"never {bit(outputs)} and {bit()}",
            lambda: f"never {bit()} and {bit()} and {bit(outputs)}",
            lambda: f"{bit(outputs)} implies {bit()}",
            lambda: f"{bit(outputs)} implies {bit()}",
            lambda: f"{bit()} and {bit()} implies {bit(outputs)}",
            lambda: f"{bit()} implies {bit(outputs)} within {rng.randint(1, 3)} slow",
            lambda: f"{bit()} implies {bit(outputs)} or {bit()}",
            lambda: f"({bit()} or {bit()}) and {bit()} implies {bit(outputs)}",
            lambda: f"not ({bit()} and {bit(outputs)}) or {bit()}",
            lambda: f"{bit()} for {rng.randint(2, 4)} slow implies {bit(outputs)}",
            lambda: pair("at most one of"),
            lambda: pair("exactly one of"),
            lambda: f"{quoted(rng.choice(outputs))} is never stuck within {rng.randint(1, 4)} slow",
            number, number, number])()

    return [one() for _ in range(count)]


def scenario(machine, source, held, rng, periods, options):
    """A long random run that watches properties: inputs, what the program only takes back, what the control takes back,
    power failures."""
    text = f"dialect: {machine.dialect}\nsources: [{source}]\nproperties:\n"
    text += "".join("- \"" + one + "\"\n" for one in held)
    if options:
        text += "options: {" + ", ".join(f"{key}: {value}" for key, value in options.items()) + "}\n"
    text += "steps:\n"
    one_in = rng.choice([1, 2, 4, 8, 16])
    density = rng.choice([0.2, 0.5, 0.8])
    inputs = machine.inputs + ([machine.flag] if machine.is_taken else [])
    done = 0
    while done < periods:
        changes = {name: int(rng.random() < density) for name in inputs if rng.randrange(one_in) == 0}
        changes.update({name: rng.randrange(8) for name in machine.input_words if rng.randrange(one_in) == 0})
        changes.update({name: 0 for name in machine.cleared if rng.randrange(4 * one_in) == 0})
        if changes:
            text += "- set: {" + ", ".join(f"'{name}': {value}" for name, value in changes.items()) + "}\n"
        wait = 1 if rng.random() < 0.8 else rng.randint(1, 40)
        text += f"- run: {{ms: {wait * machine.period_ms}}}\n"
        if rng.random() < 0.01:
            text += "- power_cycle: {}\n"
        done += wait
    return text
