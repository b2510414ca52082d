"""Random assembler programs of dialect technol: registers in, registers and cells out.

Flags are read only where they are defined on every path, as 6.9 wants it.
"""
import i8086

R32 = ["EAX", "EBX", "ECX", "EDX", "ESI", "EDI"]
R16 = [name[1:] for name in R32]
R8 = ["AL", "BL", "CL", "DL", "AH", "BH", "CH", "DH"]
REGISTERS = {8: R8, 16: R16, 32: R32}
CELLS = {"B1": 8, "B2": 8, "W1": 16, "W2": 16, "D1": 32, "D2": 32}
SHIFTS = ("SHL", "SHR", "SAR")
JUMPS = {
    "JE": ("Z", lambda f: f["Z"]), "JNE": ("Z", lambda f: not f["Z"]), "JC": ("C", lambda f: f["C"]),
    "JNC": ("C", lambda f: not f["C"]), "JA": ("CZ", lambda f: not f["C"] and not f["Z"]),
    "JBE": ("CZ", lambda f: f["C"] or f["Z"]), "JG": ("ZSO", lambda f: not f["Z"] and f["S"] == f["O"]),
    "JGE": ("SO", lambda f: f["S"] == f["O"]), "JL": ("SO", lambda f: f["S"] != f["O"]),
    "JLE": ("ZSO", lambda f: f["Z"] or f["S"] != f["O"]), "JS": ("S", lambda f: f["S"]),
    "JNS": ("S", lambda f: not f["S"]), "JO": ("O", lambda f: f["O"]), "JNO": ("O", lambda f: not f["O"]),
}


class Generator:
    """Makes a list of (name, width, destination, source) and ("IF", jump, label, body)."""

    def __init__(self, rng):
        self.rng = rng
        self.labels = 0

    def source(self, width, memory):
        kind = self.rng.random()
        if kind < 0.5:
            return self.rng.choice(REGISTERS[width])
        if kind < 0.7 and memory:
            return self.rng.choice([cell for cell, size in CELLS.items() if size == width])
        top = i8086.MASK[width]
        return self.rng.choice((0, 1, top, top // 2, top // 2 + 1, self.rng.randint(0, top)))

    def body(self, count, depth, defined):
        """`defined` are the flags that may be read; gives the program and the flags defined behind it."""
        program = []
        for _ in range(count):
            width = self.rng.choice((8, 16, 32))
            register = self.rng.choice(REGISTERS[width])
            cell = self.rng.choice([name for name, size in CELLS.items() if size == width])
            to = register if self.rng.random() < 0.8 else cell
            kind = self.rng.random()
            if kind < 0.12:
                program.append(("MOV", width, to, self.source(width, to == register)))
            elif kind < 0.32:
                names = ["ADD", "SUB", "CMP", "AND", "OR", "XOR", "TEST"] + (["ADC", "SBB"] if "C" in defined else [])
                name = self.rng.choice(names)
                program.append((name, width, to, self.source(width, to == register)))
                defined = set("CZSO") if name in ("AND", "OR", "XOR", "TEST") else set("CZSOA")
            elif kind < 0.40:
                name = self.rng.choice(["INC", "DEC", "NEG", "NOT"])
                program.append((name, width, to, None))
                if name != "NOT":
                    defined = set("ZSOA") | ({"C"} if name == "NEG" else defined & {"C"})
            elif kind < 0.56:
                defined = self.shift(program, width, to, defined)
            elif kind < 0.61:
                program.append(("XCHG", width, register, self.rng.choice(REGISTERS[width] + [cell])))
            elif kind < 0.67:
                wide = self.rng.choice((16, 32))
                narrow = 8 if wide == 16 else self.rng.choice((8, 16))
                program.append((self.rng.choice(["MOVZX", "MOVSX"]), (wide, narrow), self.rng.choice(REGISTERS[wide]),
                                self.rng.choice(REGISTERS[narrow])))
            elif kind < 0.73:
                program.append((self.rng.choice(["MUL", "IMUL"]), width, self.rng.choice([register, cell]), None))
                defined = set("CO")
            elif kind < 0.77:
                program.append((self.rng.choice(["DIV", "IDIV"]), width, self.rng.choice([register, cell]), None))
                defined = set()
            elif kind < 0.81:
                program.append((self.rng.choice(["CBW", "CWD", "CWDE", "CDQ"]), 0, None, None))
            elif kind < 0.85:
                decimal = {"A", "C"} <= defined
                program.append((self.rng.choice(["DAA", "DAS"] if decimal else ["AAM", "AAD"]), 8, None, None))
                defined = set("CZSA") if decimal else set("ZS")
            elif kind < 0.88:
                program.append((self.rng.choice(["CLC", "STC"] + (["CMC"] if "C" in defined else [])), 0, None, None))
                defined = defined | {"C"}
            elif depth < 2:
                possible = [name for name, (flags, _) in JUMPS.items() if set(flags) <= defined]
                if possible:
                    self.labels += 1
                    label = f"L{self.labels}"
                    inner, behind = self.body(self.rng.randint(1, 5), depth + 1, set(defined))
                    program.append(("IF", self.rng.choice(possible), label, inner))
                    defined = defined & behind
        return program, defined

    def shift(self, program, width, to, defined):
        names = [*SHIFTS, "ROL", "ROR"] + (["RCL", "RCR"] if "C" in defined else [])
        name = self.rng.choice(names)
        count = self.rng.choice([0, 1, 2, width - 1, width, width + 1, 31, "CL", self.rng.randint(0, 40)])
        program.append((name, width, to, count))
        of_result = set("CZS") if name in SHIFTS else {"C"}
        if count == "CL":
            return (defined | of_result) - {"O"} - ({"A"} if name in SHIFTS else set())
        if count & 31 == 0 and name[1] != "C":
            return defined
        kept = set() if name in SHIFTS else defined & set("ZSA")
        return kept | of_result | ({"O"} if count & 31 == 1 else set())


def text(program):
    lines = []
    for name, width, to, source in program:
        if name == "IF":
            lines += [f"        {width} {to}", *text(source), f"{to}:"]
            continue
        operands = [str(operand) for operand in (to, source) if operand is not None]
        if isinstance(source, int) and name not in SHIFTS and name[:2] not in ("RO", "RC"):
            operands[1] = f"0{source:X}h"
        lines.append(f"        {name} {','.join(operands)}".rstrip())
    return lines


class Machine:
    def __init__(self, registers, cells):
        self.registers, self.cells, self.flags = list(registers), dict(cells), {}

    def read(self, operand):
        if isinstance(operand, int):
            return operand
        if operand in R32:
            return self.registers[R32.index(operand)]
        if operand in R16:
            return self.registers[R16.index(operand)] & 0xFFFF
        if operand in R8:
            half = R8.index(operand)
            return (self.registers[half % 4] >> (8 if half >= 4 else 0)) & 0xFF
        return self.cells[operand]

    def write(self, operand, value):
        if operand in CELLS:
            self.cells[operand] = value & i8086.MASK[CELLS[operand]]
            return
        width = 32 if operand in R32 else 16 if operand in R16 else 8
        index = REGISTERS[width].index(operand)
        low = 8 if width == 8 and index >= 4 else 0
        index %= 4 if width == 8 else 6
        kept = self.registers[index] & ~(i8086.MASK[width] << low)
        self.registers[index] = kept | (value & i8086.MASK[width]) << low

    def run(self, program):
        for name, width, to, source in program:
            if name == "IF":
                if not JUMPS[width][1](self.flags):
                    self.run(source)
            else:
                self.step(name, width, to, source)

    def step(self, name, width, to, source):
        flags = self.flags
        if name in ("ADD", "ADC", "SUB", "SBB", "CMP"):
            function = i8086.add if name[0] == "A" else i8086.sub
            carry = flags["C"] if name in ("ADC", "SBB") else 0
            result, self.flags = function(self.read(to), self.read(source), width, carry)
            if name != "CMP":
                self.write(to, result)
        elif name in ("AND", "TEST", "OR", "XOR"):
            a, b = self.read(to), self.read(source)
            result, self.flags = i8086.logic(a | b if name == "OR" else a ^ b if name == "XOR" else a & b, width)
            if name != "TEST":
                self.write(to, result)
        elif name in ("INC", "DEC"):
            result, new = (i8086.add if name == "INC" else i8086.sub)(self.read(to), 1, width)
            del new["C"]
            self.flags = {**new, **{flag: flags[flag] for flag in "C" if flag in flags}}
            self.write(to, result)
        elif name == "NEG":
            result, self.flags = i8086.neg(self.read(to), width)
            self.write(to, result)
        elif name == "NOT":
            self.write(to, ~self.read(to))
        elif name in SHIFTS or name[:2] in ("RO", "RC") and len(name) == 3:
            self.shift(name, width, to, source)
        elif name == "XCHG":
            a, b = self.read(to), self.read(source)
            self.write(to, b)
            self.write(source, a)
        elif name in ("MOV", "MOVZX"):
            self.write(to, self.read(source))
        elif name == "MOVSX":
            self.write(to, i8086.signed(self.read(source), width[1]))
        elif name in ("MUL", "IMUL", "DIV", "IDIV"):
            self.product_or_quotient(name, width, self.read(to))
        else:
            self.without_operands(name)

    def shift(self, name, width, to, source):
        count = (self.read("CL") if source == "CL" else source) & 31
        flags = dict(self.flags)
        if source == "CL":  # behind the count 0 a flag that was undefined is 0
            for flag in "CZS" if name in SHIFTS else "C":
                flags.setdefault(flag, 0)
        function = i8086.shift if name in SHIFTS else i8086.rotate
        result, self.flags = function(name, self.read(to), count, width, flags)
        if source == "CL":
            self.flags.pop("O", None)
        self.write(to, result)

    def product_or_quotient(self, name, width, operand):
        low, high = {8: ("AL", "AH"), 16: ("AX", "DX"), 32: ("EAX", "EDX")}[width]
        if name in ("MUL", "IMUL"):
            product, self.flags = i8086.multiply(name, self.read(low), operand, width)
            self.write(low, product)
            self.write(high, product >> width)
            return
        dividend = self.read(high) << width | self.read(low)
        quotient, remainder = i8086.divide(name, dividend, operand, width)
        self.write(low, quotient)
        self.write(high, remainder)
        self.flags = {}

    def without_operands(self, name):
        al, ah = self.read("AL"), self.read("AH")
        if name in ("DAA", "DAS"):
            al, self.flags = i8086.adjust(name, al, self.flags)
            self.write("AL", al)
        elif name == "AAM":
            self.write("AX", (al // 10) << 8 | al % 10)
            self.flags = i8086.zero_sign(al % 10, 8)
        elif name == "AAD":
            self.write("AX", (al + 10 * ah) & 0xFF)
            self.flags = i8086.zero_sign((al + 10 * ah) & 0xFF, 8)
        elif name == "CBW":
            self.write("AX", i8086.signed(al, 8))
        elif name == "CWD":
            self.write("DX", -(self.read("AX") >> 15))
        elif name == "CWDE":
            self.write("EAX", i8086.signed(self.read("AX"), 16))
        elif name == "CDQ":
            self.write("EDX", -(self.read("EAX") >> 31))
        else:
            self.flags = {**self.flags, "C": {"CLC": 0, "STC": 1}.get(name, 1 - self.flags.get("C", 0))}


def make(rng):
    """The text of a program and the steps of its scenario."""
    program, _ = Generator(rng).body(rng.randint(3, 25), 0, set())
    cells = [f"{side}{r}: DS 4" for side in "IO" for r in R32] + [f"{c}: DS {w // 8}" for c, w in CELLS.items()]
    lines = ["        DATA", *cells, "        DATA_END", "        MODULE_MAIN"]
    lines += [f"        MOV {r},I{r}" for r in R32] + text(program) + [f"        MOV O{r},{r}" for r in R32]
    lines += ["        MODULE_MAIN_END", "        STOP", ""]
    steps = []
    for _ in range(6):
        edges = (0, 1, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF)
        values = [rng.choice(edges) if rng.random() < 0.4 else rng.getrandbits(rng.choice((8, 16, 32))) for _ in R32]
        machine = Machine(values, {c: rng.choice((0, 1, i8086.MASK[w], rng.getrandbits(w))) for c, w in CELLS.items()})
        steps += [("set", {**{f"I{r}": v for r, v in zip(R32, values)}, **machine.cells}), ("run", {"slow": 1})]
        machine.run(program)
        steps.append(("expect", {**{f"O{r}": v for r, v in zip(R32, machine.registers)}, **machine.cells}))
    return "\n".join(lines), {}, steps
