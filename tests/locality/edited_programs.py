#!/usr/bin/env python3
"""A program for measurements and single edits of it, for locality_test.cc: how far does an edit reach in the C++?

    edited_programs.py DIALECT STATEMENTS EDITS DIRECTORY

Writes base.<ext>, edit000.<ext> ... and edits.txt: a line for each edit, its file, its kind and what was done, between
tabs. The kinds in turn: another operand, a statement inserted, one deleted, another constant, a symbol renamed that one
statement uses (nc110: it gets another address; prostep, which has no names: another operand again). What is inserted and
deleted is one statement, not a sequence of them: no switch of C, and none of the sequences with jumps that a timer of
technol is. The same call always writes the same bytes.
"""
import pathlib
import random
import re
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "bench"))
import generate_accumulator  # noqa: E402
import generate_hnc  # noqa: E402
import generate_nc110  # noqa: E402

RENAMED = 40  # symbols that one statement uses
NEW = 1_000_000  # numbers of inserted statements


class Terms:
    """Programs whose statements are (kind, target, terms, extra)."""

    has_names = True

    def __init__(self, count):
        self.program, donor = self.generate(count), self.generate(count + 1)
        self.inserted = [statement for statement in donor.statements if self.is_single(statement)]
        bits = self.bits()
        self.operands = bits[:count]
        self.statements = self.program.statements
        rng = random.Random(count)
        unused = bits[-2 * RENAMED :]
        self.renames = list(zip(self.names(unused[:RENAMED]), self.fresh(unused[RENAMED:]))) if self.has_names else []
        for name, _ in self.renames:
            terms = [("" if k == 0 else "*", False, rng.choice(self.operands)) for k in range(3)]
            self.statements.insert(rng.randrange(len(self.statements)), ("coil", name, terms, None))

    def names(self, unused):
        return unused

    def fresh(self, unused):
        return unused

    def is_single(self, statement):
        return True

    def is_single_at(self, number):
        return self.is_single(self.statements[number])

    def join(self, pieces):
        return "\n".join(line for _, lines in pieces for line in lines) + "\n"

    def new_statement(self, rng, number):
        return self.lines(number, rng.choice(self.inserted))

    def with_other_operand(self, rng, number):
        kind, target, terms, extra = self.statements[number]
        terms = list(terms)
        at = rng.randrange(len(terms))
        others = [name for name in self.operands if name not in {operand for _, _, operand in terms}]
        terms[at] = (*terms[at][:2], rng.choice(others))
        return self.lines(number, (kind, target, terms, extra))

    def with_other_constant(self, rng, number):
        kind, target, terms, extra = self.statements[number]
        if extra is None:
            return None
        value = extra[2] if kind == "compare" else extra
        value = (value + rng.randrange(1, 200)) % 200 + 2
        return self.lines(number, (kind, target, terms, (*extra[:2], value) if kind == "compare" else value))


class Accumulator(Terms):
    def __init__(self, dialect, count):
        self.machine = generate_accumulator.machine_of(dialect)
        self.extension = self.machine.extension
        self.has_names = dialect != "prostep"
        super().__init__(count)

    def generate(self, count):
        return generate_accumulator.Program(self.machine, count)

    def bits(self):
        return self.machine.bits

    def fresh(self, unused):  # technol declares names
        return [f"N{name[1:]}" for name in unused] if self.machine.name == "technol" else unused

    def is_single(self, statement):
        return self.machine.name != "technol" or statement[0] in ("coil", "set", "reset")

    def lines(self, number, statement):
        return self.machine.statement(number, statement)

    def pieces(self):
        return self.machine.pieces(self.statements)


class Host50(Accumulator):
    """With a table of symbols."""

    def names(self, unused):
        self.symbols = {address: f"only_{address[2:]}" for address in unused}
        return list(self.symbols.values())

    def fresh(self, unused):
        return [f"other_{address[2:]}" for address in unused]

    def pieces(self):
        rows = [f"  {address} {name}" for address, name in self.symbols.items()]
        yield None, ["SYMBOLS", *rows, "END_SYMBOLS"]
        yield from super().pieces()


class Nc110(Terms):
    extension = "plc"

    def generate(self, count):
        return generate_nc110.Program(count)

    def bits(self):
        return generate_nc110.BITS

    def lines(self, _, statement):
        return [self.program.statement(*statement)]

    def pieces(self):
        yield None, ["; a program for measurements", "$ slow part"]
        for number, statement in enumerate(self.statements):
            yield number, self.lines(number, statement)


class Hnc:
    extension = "cld"

    def __init__(self, count):
        self.program = generate_hnc.Program(count)
        self.inserted = [lines for lines in generate_hnc.Program(count + 1).statements if len(lines) == 1]
        self.renames = [(f"only{k}", f"other{k}") for k in range(RENAMED)]
        rng = random.Random(count)
        self.statements = self.program.statements
        for name, _ in self.renames:
            line = f"{name} = X[{rng.randrange(60)}] & 0x3F;"
            self.statements.insert(rng.randrange(len(self.statements)), [line])

    def pieces(self):
        return self.program.pieces()

    def join(self, pieces):
        variables = [f"BYTE {name};" for name, _ in self.renames]
        return self.program.plc_around([*variables, *(line for _, lines in pieces for line in lines)])

    def is_single_at(self, number):
        return len(self.statements[number]) == 1

    def new_statement(self, rng, _):
        return ["    " + line for line in rng.choice(self.inserted)]

    def edited(self, rng, number, pattern, other):
        """The statement with one match of `pattern` replaced; None when it has none."""
        lines = ["    " + line for line in self.statements[number]]
        found = [(k, match) for k, line in enumerate(lines) for match in re.finditer(pattern, line)]
        if not found:
            return None
        k, match = rng.choice(found)
        lines[k] = lines[k][: match.start(1)] + other(match.group(1)) + lines[k][match.end(1) :]
        return lines

    def with_other_operand(self, rng, number):
        def other(name):
            return re.sub(r"\d+", lambda digits: str((int(digits[0]) + rng.randrange(1, 7)) % 8), name, count=1)

        return self.edited(rng, number, r"\b([xr]\(\d+,\d\)|[wli]\d+|X\[\d+\])", other)

    def with_other_constant(self, rng, number):
        return self.edited(rng, number, r"(?:[<*,] |>> |= )(\d+)\b", lambda text: str(int(text) % 7 + 1))


def edits_of(language, count):
    """(Kind, what was done, the program's text), count of them; the kinds take turns."""
    rng = random.Random(7)
    base = list(language.pieces())
    places = [at for at, (number, _) in enumerate(base) if number is not None]
    single = [at for at in places if language.is_single_at(base[at][0])]
    text = language.join(base)

    def changed(make):
        while True:
            at = rng.choice(places)
            lines = make(rng, base[at][0])
            if lines is not None and lines != base[at][1]:
                what = f"{' '.join(base[at][1]).strip()} -> {' '.join(lines).strip()}"
                return what, language.join([*base[:at], (base[at][0], lines), *base[at + 1 :]])

    for k in range(count):
        kind = ("operand", "insert", "delete", "constant", "rename")[k % 5]
        if kind == "rename" and not language.renames:
            kind = "operand"
        if kind == "operand":
            yield kind, *changed(language.with_other_operand)
        elif kind == "constant":
            yield kind, *changed(language.with_other_constant)
        elif kind == "insert":
            at, lines = rng.choice(places), language.new_statement(rng, NEW + k)
            yield kind, " ".join(lines).strip(), language.join([*base[:at], (NEW + k, lines), *base[at:]])
        elif kind == "delete":
            at = rng.choice(single)
            yield kind, " ".join(base[at][1]).strip(), language.join([*base[:at], *base[at + 1 :]])
        else:
            old, new = rng.choice(language.renames)
            yield kind, f"{old} -> {new}", re.sub(rf"(?<![\w.]){re.escape(old)}(?![\w.])", new, text)


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    dialect, count, edits, directory = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), pathlib.Path(sys.argv[4])
    if dialect in ("nc110", "hnc"):
        language = {"nc110": Nc110, "hnc": Hnc}[dialect](count)
    else:
        language = (Host50 if dialect == "host50" else Accumulator)(dialect, count)
    directory.mkdir(parents=True, exist_ok=True)
    (directory / f"base.{language.extension}").write_text(language.join(list(language.pieces())))
    rows = []
    for k, (kind, what, text) in enumerate(edits_of(language, edits)):
        name = f"edit{k:03}.{language.extension}"
        (directory / name).write_text(text)
        rows.append("\t".join([name, kind, what]))
    (directory / "edits.txt").write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
