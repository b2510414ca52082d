"""Random ClassicLadder projects over all elements, variables and expressions, and inputs for them.

The engine is that of LinuxCNC 2.9. What it does not survive is left out: indices beyond its memory, jumps without end.
"""
INPUTS, WORD_INPUTS, OUTPUTS, WORD_OUTPUTS = 12, 3, 15, 10
WIDTH, HEIGHT = 10, 6
# Inputs that index something, by what they reach: the second one 0 to 4, the third one -2 to 2 (`inputs`). Behind the last
# variable of a kind is the next kind; behind the last record (a timer, a counter) is nothing that the engine survives.
FORWARD, BOTH = [(0, 1), (50, 3), (25, 1), (270, 1), (270, 1)], [(270, 2)]
FLAT = {0: 20, 50: 15, 60: 15, 30: 100, 200: 20, 270: 10, 280: 10, 220: 100}
RECORDS = [10, 11, 15, 20, 25, 26, 27, 230, 231, 240, 241, 250, 251, 260, 261]

BITS = [(0, 12), (10, 3), (11, 3), (15, 3), (20, 3), (25, 3), (26, 3), (27, 3), (30, 6), (50, INPUTS), (60, OUTPUTS),
        (70, 4)]
WIDE_COILS = [(11, 3), (15, 3), (20, 3), (25, 3), (26, 3), (27, 3), (50, INPUTS), (200, 9), (230, 3), (240, 3), (250, 3),
              (251, 3), (260, 3), (261, 3), (270, WORD_INPUTS), (280, 5), (310, 3), (231, 3), (220, 4)]
COILS = [(0, 12), (60, OUTPUTS), (0, 12), (60, OUTPUTS), (30, 8), (10, 3), (70, 4)]
WORDS = [(200, 9), (220, 4), (230, 3), (231, 3), (240, 3), (241, 3), (250, 3), (251, 3), (260, 3), (261, 3),
         (270, WORD_INPUTS), (280, 5), (310, 3)]
TARGETS = [(200, 9), (200, 9), (230, 3), (240, 3), (250, 3), (251, 3), (260, 3), (280, 5), (310, 3)]


class Program:
    def __init__(self, random):
        self.random = random
        self.expressions = []
        self.rungs = {}
        self.sections = []
        self.subroutines = random.choice([0, 0, 1, 2])
        self.wide = random.random() < 0.6  # indices into everything, coils of words, seconds, large numbers
        self.make()

    def pick(self, rows):
        kind, count = self.random.choice(rows)
        return kind, self.random.randrange(count)

    # --- expressions
    def variable(self):
        if self.wide and self.random.random() < 0.3:
            return "@%s@" % self.indexed()
        kind, number = self.pick(self.random.choice([WORDS, WORDS, BITS]))
        index = ""
        if kind in (0, 50, 60, 200, 230, 251) and self.random.random() < 0.25:
            index = "[%d/%d]" % self.random.choice([(0, 1), (50, 3), (270, 1)])
            number = min(number, 1)
        return "@%d/%d%s@" % (kind, number, index)

    def indexed(self, flat=tuple(FLAT), records=RECORDS):
        """Near the ends of its kind, too."""
        both = self.random.random() < 0.3
        if self.random.random() < 0.5:
            kind = self.random.choice(flat)
            number = self.random.choice([0, 1, FLAT[kind] - 1, FLAT[kind] - 3, self.random.randrange(FLAT[kind])])
            number = max(number, 2) if both else number
        else:
            kind = self.random.choice(records)
            number = self.random.choice([0, 1, 5]) + (2 if both else 0)
        return "%d/%d[%d/%d]" % ((kind, number) + self.random.choice(BOTH if both else FORWARD))

    def term(self, depth):
        choice = self.random.random()
        if self.wide and choice < 0.1:
            return self.random.choice(["2147483647", "$FFFF", "-2147483647", "10000", "256", "$7FFFFFFF", "-1", "9998"])
        if choice < 0.25:
            return self.random.choice([str(self.random.randrange(30)), "$1F", "-3", "70000"])
        if choice < 0.7 or depth == 0:
            return self.variable()
        if choice < 0.78:
            return "!" + self.variable()
        if choice < 0.9:
            name = self.random.choice(["ABS", "MINI", "MAXI", "MOY", "AVG"])
            count = 1 if name == "ABS" else self.random.randint(1, 3 if self.wide else 2)
            return "%s(%s)" % (name, ",".join(self.variable() for _ in range(count)))
        return "(%s)" % self.arithmetic(depth - 1)

    def arithmetic(self, depth):
        text = self.term(depth)
        for _ in range(self.random.choice([0, 1, 1, 2])):
            sign = self.random.choice("+-*&|^/%")
            if sign in "/%":
                text += sign + self.random.choice([str(self.random.randint(1, 9)), self.variable()])
            elif sign == "^":
                text += "^" + self.random.choice(["1", "2", "0", self.variable()])
            else:
                text += sign + self.term(depth)
        return text

    def expression(self, make):
        while True:
            text = make()
            if len(text) <= 49:
                self.expressions.append(text)
                return len(self.expressions) - 1

    def comparison(self):
        relation = self.random.choice(["<", "<=", "=", "<>", ">", ">="])
        return self.arithmetic(1) + relation + self.random.choice([self.arithmetic(0), str(self.random.randrange(9))])

    def operation(self):
        assign = self.random.choice([":=", "=", " := "])
        if self.random.random() < 0.15:
            if self.wide and self.random.random() < 0.5:
                bits = [kind for kind in RECORDS if kind < 200]
                return "@%s@" % self.indexed((0, 50, 60, 30), bits) + assign + "!" + self.variable()
            return "@%d/%d@" % self.pick(COILS) + assign + "!" + self.variable()
        if self.wide and self.random.random() < 0.3:
            words = [kind for kind in RECORDS if kind >= 200]
            target = self.indexed((200, 280, 220), words)
            right = self.arithmetic(1 if len(target) < 14 else 0)
            small = self.random.random() < 0.7 and not target.startswith(("200/", "280/"))
            return "@%s@" % target + assign + ("(%s)%%6" % right if small else right)
        kind, number = self.pick(TARGETS)
        if kind == 200 and self.random.random() < 0.3:
            return "@200/1[270/1]@" + assign + self.arithmetic(1)
        # Presets stay small, so that times come to their ends.
        right = self.arithmetic(1)
        return "@%d/%d@" % (kind, number) + assign + ("(%s)%%6" % right if kind in (230, 240, 250, 251, 260) else right)

    # --- rungs
    def rung(self, own, targets, calls):
        cells = [["0-0-0/0"] * WIDTH for _ in range(HEIGHT)]
        taken = [[False] * WIDTH for _ in range(HEIGHT)]
        rows = self.random.randint(1, HEIGHT)
        joined = lambda y: 1 if y > 0 and self.random.random() < 0.3 else 0

        def put(x, y, text):
            cells[y][x], taken[y][x] = text, True

        def block(kind, value, x, y, left, below):
            if x < left or y + below >= HEIGHT:
                return
            area = [(i, k) for i in range(x - left, x + 1) for k in range(y, y + below + 1)]
            if any(taken[k][i] for i, k in area):
                return
            for i, k in area:
                put(i, k, "99-%d-0/0" % joined(k))
            put(x, y, "%d-%d-0/%d" % (kind, joined(y), value))

        if self.random.random() < 0.5:
            kind, left, below = self.random.choice([(10, 1, 1), (11, 1, 1), (12, 1, 3), (13, 1, 1)])
            block(kind, self.random.randrange(3), self.random.randint(1, 6), self.random.randrange(HEIGHT), left, below)
        if self.random.random() < 0.4:
            block(20, self.expression(self.comparison), self.random.randint(2, 6), self.random.randrange(rows), 2, 0)
        if self.random.random() < 0.4:
            block(60, self.expression(self.operation), self.random.randint(2, 9), self.random.randrange(rows), 2, 0)
        for y in range(rows):
            for x in range(WIDTH):
                if taken[y][x]:
                    continue
                if self.random.random() < 0.1:
                    put(x, y, "0-%d-0/0" % joined(y))  # free, and joined
                    continue
                index = "[%d/%d]" % self.random.choice([(0, 1), (270, 1)]) if self.random.random() < 0.05 else ""
                choice = self.random.random()
                if x > 2 and choice < 0.22:
                    kind, number = self.pick(WIDE_COILS if self.wide and self.random.random() < 0.4 else COILS)
                    put(x, y, "%d-%d-%d/%d%s" % (self.random.choice([50, 50, 51, 52, 53]), joined(y), kind, number, index))
                elif choice < 0.45:
                    put(x, y, "9-%d-0/0" % joined(y))
                else:
                    kind, number = self.pick(self.random.choice([BITS, BITS, BITS, WORDS]))
                    put(x, y, "%d-%d-%d/%d%s" % (self.random.choice([1, 1, 2, 2, 3, 4]), joined(y), kind, number,
                                                  index if kind in (0, 50, 60, 200) else ""))
        if targets and self.random.random() < 0.15:
            put(self.random.randint(2, 9), self.random.randrange(rows), "54-0-0/%d" % self.random.choice(targets))
        if calls and self.random.random() < 0.3:
            put(self.random.randint(2, 9), self.random.randrange(rows), "55-0-0/%d" % self.random.choice(calls))
        self.rungs[own] = cells

    def section(self, subroutine, calls):
        numbers = list(range(len(self.rungs), len(self.rungs) + self.random.randint(1, 3)))
        for i, number in enumerate(numbers):
            self.rung(number, numbers[i + 1:] + [90], calls)
        self.sections.append((0, subroutine, numbers[0], numbers[-1], 0))

    def watch(self):
        """Everything that is kept becomes an output."""
        words = ["@280/5@:=@251/0@*9999+@251/1@*7+@251/2@", "@280/6@:=@231/0@+9*@231/1@+99*@241/0@",
                 "@280/7@:=@261/0@+9*@261/1@+99*@261/2@", "@280/8@:=@30/0@+2*@30/1@+4*@30/2@+8*@220/0@",
                 "@280/9@:=@200/0@+3*@200/1@+5*@200/2@", "@280/4@:=@30/3@+2*@30/4@+4*@0/9@+8*@70/2@"]
        number = len(self.rungs)
        cells = [["0-0-0/0"] * WIDTH for _ in range(HEIGHT)]
        for y, text in enumerate(words):
            assert len(text) <= 49, text
            self.expressions.append(text)
            cells[y] = ["9-0-0/0", "99-0-0/0", "99-0-0/0", "60-0-0/%d" % (len(self.expressions) - 1)] + ["0-0-0/0"] * 6
        self.rungs[number] = cells
        self.sections.append((0, -1, number, number, 0))

    def page(self):
        lines = ["#VER=1.0"]
        steps = self.random.randint(2, 6)
        for i in range(steps):
            number = i if not self.wide else self.random.choice([i, i + 1, 5 - i, i * 3])
            lines.append("S%d,%d,%d,0,1,1" % (i, 1 if i == 0 or self.random.random() < 0.2 else 0, number))
        pick = lambda most: self.random.sample(range(steps), min(steps, self.random.randint(0 if most > 1 else 1, most)))
        pad = lambda chosen: ",".join(str(s) for s in chosen + [-1] * (10 - len(chosen)))
        for i in range(self.random.randint(1, 6)):
            lines.append("T%d,%s,%s,%s,0,1,1" % (i, pad(pick(2)), pad(pick(1)), ",".join(["-1"] * 20)))
            lines.append("C%d,0,%d/%d" % ((i,) + self.pick(WORDS if self.wide and self.random.random() < 0.2 else BITS)))
        return lines

    def make(self):
        random = self.random
        for subroutine in reversed(range(self.subroutines)):
            self.section(subroutine, list(range(subroutine + 1, self.subroutines)) + [7])
        self.has_page = random.random() < 0.5
        if self.has_page:
            self.sections.append((1, -1, 0, 0, 0))
        for _ in range(random.randint(1, 2)):
            self.section(-1, list(range(self.subroutines)) + [7])
        self.watch()

    def text(self):
        out = ["_FILES_CLASSICLADDER"]

        def part(name, lines):
            out.append("_FILE-" + name)
            out.extend(lines)
            out.append("_/FILE-" + name)

        def base():
            if not self.wide:
                return "2,%d" % self.random.randrange(5)
            return "%d,%d" % self.random.choice([(2, self.random.randrange(5)), (2, self.random.randrange(-2, 12)),
                                                 (1, self.random.randrange(3)), (0, self.random.randrange(2))])
        part("timers.csv", [base() for _ in range(10)])
        part("monostables.csv", [base() for _ in range(10)])
        part("counters.csv", [str(self.random.choice([9999, 10000, -1, 9998]) if self.wide and self.random.random() < 0.2
                                   else self.random.randrange(5)) for _ in range(10)])
        part("timers_iec.csv", ["%s,%d" % (base(), self.random.randrange(3)) for _ in range(10)])
        part("arithmetic_expressions.csv", ["#VER=2.0"] + ["%04d,%s" % (i, t) for i, t in enumerate(self.expressions)])
        part("sequential.csv", self.page() if self.has_page else ["#VER=1.0"])
        part("sections.csv", ["#VER=1.0"] + ["%03d,%d,%d,%d,%d,%d" % ((i,) + s) for i, s in enumerate(self.sections)])
        last = {s[3] for s in self.sections if s[0] == 0}
        for number, cells in self.rungs.items():
            follows = -1 if number in last else number + 1
            part("rung_%d.csv" % number, ["#VER=2.0", "#NEXTRUNG=%d" % follows] + [" , ".join(row) for row in cells])
        out.append("_/FILES_CLASSICLADDER")
        return "\n".join(out) + "\n"


def inputs(random, scans, word_inputs=WORD_INPUTS, small=True):
    """A row for each scan; most inputs stay for a while. Numbers are small where they are indices."""
    rows, row = [], [0] * INPUTS + [0] * word_inputs
    for _ in range(scans):
        for i in range(INPUTS):
            if random.random() < 0.12:
                row[i] = 1 - row[i]
        for i in range(word_inputs):
            if random.random() < 0.1:
                if i == 2:
                    row[INPUTS + i] = random.randint(-2, 2)
                elif i == 1 or small and random.random() < 0.7:
                    row[INPUTS + i] = random.randrange(5)
                else:
                    row[INPUTS + i] = random.choice([random.randint(-400, 400), random.randint(-2**31, 2**31 - 1)])
        rows.append(list(row))
    return rows
