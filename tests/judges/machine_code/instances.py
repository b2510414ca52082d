"""Random instances of instructions, as assembler: from lines with marks in which registers and numbers are filled in.

Marks of both: %r a register, %z also the zero register (RISC-V), %l one of r0-r7 (ARM), %c one that compressed
instructions have (RISC-V), %iN a number of N bits with a sign, %uN without one, %nN not 0, %wN a multiple of 4 of N bits.
Memory: %B a base register, whose address is in the middle of what the judge compares; what is written to it is compared
as an offset. {L:H:S} an offset from L to H in steps of S, for which the base is moved.
"""
import random
import re

EDGES = [0, 1, 2, 3, 4, 7, 8, 31, 32, 33, 63, 64, 127, 128, 255, 256, 0x7FFF, 0x8000, 0xFFFF, 0x10000, 0x7FFFFFFF,
         0x80000000, 0x80000001, 0xFFFFFFFE, 0xFFFFFFFF, 0xFFFF8000, 0xFFFFFF80, 0x00FF00FF, 0x55555555, 0xAAAAAAAA]
CONDITIONS = "eq ne cs cc mi pl vs vc hi ls ge lt gt le".split()
SCRATCH, SCRATCH_END = 96, 352  # bytes of the block that instructions may read and write
MIDDLE = 200


def word(rng):
    kind = rng.random()
    if kind < 0.3:
        return rng.randrange(36)
    if kind < 0.65:
        return rng.choice(EDGES)
    return rng.getrandbits(32)


def modified(rng):
    """A number that ARM's instructions of 32 bits can have."""
    byte = rng.choice([0, 1, 0x7F, 0x80, 0xFF, rng.randrange(256)])
    kind = rng.randrange(6)
    if kind == 0:
        return byte
    if kind == 1:
        return byte | byte << 16
    if kind == 2:
        return byte << 8 | byte << 24
    if kind == 3:
        return byte * 0x01010101
    return (byte | 0x80) << rng.randrange(1, 25)


class Instance:
    """A few lines of assembler, and what must be so around them."""

    def __init__(self):
        self.lines = []
        self.bases = {}  # register: its offset in the block
        self.results = []  # other registers that hold addresses afterwards
        self.values = {}  # register: function of a generator to its value
        self.text = ""
        self.may_demand = False  # what it needs the block need not have
        self.is_float = 0  # bits of the float that it gives; 0: none
        self.zeroed = set()  # of the bases: the lines themselves clear them
        self.header = None  # function of a generator and a block's header; none: any registers


def fill(template, target, rng):
    instance = Instance()
    options = {}
    while template.startswith("<"):
        option, template = template[1:].split(">", 1)
        name, _, value = option.partition("=")
        options[name] = value
    taken = set(re.findall(r"\b(?:r\d+|lr|sp|ra|[ast]\d)\b", template))
    free = [r for r in target.registers if r not in taken]

    def register(pool, reserve=False):
        one = rng.choice([r for r in pool if r in free])
        if reserve:
            free.remove(one)
        return one

    names = {}
    # Bases first: nothing else may be one of them.
    for mark in sorted(set(re.findall(r"%[BbXx](?![a-z])", template))):
        low = mark in ("%b", "%x")
        names[mark] = register(target.low if low else target.registers, reserve=True)
    text = template
    offset = 0
    found = re.search(r"\{(-?\d+):(-?\d+):(\d+)\}", text)
    if found:
        lowest, highest, step = map(int, found.groups())
        offset = rng.choice([lowest, highest, lowest + step * rng.randrange((highest - lowest) // step + 1)])
        text = text[:found.start()] + str(offset) + text[found.end():]
    if "after" in options:
        offset = 0
    for mark, name in names.items():
        text = text.replace(mark, name)
        if mark in ("%B", "%b"):
            instance.bases[name] = MIDDLE - offset + 8 * rng.randrange(-4, 5)
        else:
            scale, most = int(options.get("scale", "1")), int(options.get("most", "24"))
            instance.values[name] = lambda r, scale=scale, most=most: scale * r.randrange(0, most // scale + 1)
    if "sp" in options or re.search(r"\bsp\b", text):
        instance.bases["sp"] = MIDDLE - offset
    if "zeroed" in options:
        instance.zeroed = set(instance.bases)
    list_of = [r for r in target.registers if r in free]
    fixed = {}

    def replace(match):
        mark = match.group(0)
        if mark in fixed:
            return fixed[mark]
        kind, rest = mark[1], mark[2:]
        if kind == "r":
            value = register(target.registers)
        elif kind == "z":
            value = target.zero if rng.random() < 0.1 else register(target.registers)
        elif kind in "lc":
            value = register(target.low)
        elif kind == "A":  # a register that holds an address afterwards
            value = register(target.low, reserve=True)
            instance.results.append(value)
        elif kind == "i":
            bits = int(rest)
            value = str(rng.choice([0, 1, -1, -(1 << (bits - 1)), (1 << (bits - 1)) - 1,
                                    rng.randrange(-(1 << (bits - 1)), 1 << (bits - 1))]))
        elif kind in "un":
            bits = int(rest)
            value = str(rng.choice([0 if kind == "u" else 1, 1, (1 << bits) - 1, rng.randrange(kind == "n", 1 << bits)]))
        elif kind == "w":
            value = str(4 * rng.randrange(0, 1 << (int(rest) - 2)))
        elif kind == "m":
            value = str(modified(rng))
        elif kind == "s":
            name = rng.choice(["lsl", "lsr", "asr", "ror", "rrx"])
            most = {"lsl": 31, "lsr": 32, "asr": 32, "ror": 31}.get(name, 0)
            value = "rrx" if name == "rrx" else f"{name} #{rng.choice([1, most, rng.randrange(1, most + 1)])}"
        elif kind == "S":
            value = str(rng.choice([1, 32, rng.randrange(1, 33)]))
        elif kind == "R":
            value = rng.choice(["0", "8", "16", "24"])
        elif kind == "F":
            low = rng.randrange(32)
            width = rng.choice([1, 32 - low, rng.randrange(1, 33 - low)])
            value = f"#{low}, #{width}"
        elif kind == "L":  # a list of registers
            pool = list_of if rest == "" else [r for r in list_of if r in target.low]
            count = rng.randrange(2, min(7, len(pool)) + 1)
            value = "{" + ", ".join(sorted(rng.sample(pool, count), key=target.order.index)) + "}"
        elif kind == "C":
            fixed["%C"] = rng.choice(CONDITIONS)
            inverse = CONDITIONS[CONDITIONS.index(fixed["%C"]) ^ 1]
            fixed["%I"] = inverse
            value = fixed["%C"]
        else:
            raise ValueError(mark)
        return value

    text = text.replace("~", rng.choice(["", "s"]))
    condition = ""
    if "?" in text and ("it" in options or rng.random() < 0.34):
        condition = rng.choice(CONDITIONS)
    text = text.replace("?", condition)
    text = re.sub(r"%(?:[iunw]\d+|[rzlcAmsSRFCI](?![a-z])|Ll?)", replace, text)
    lines = [line.strip() for line in text.split(";")]
    if condition:
        lines.insert(0, "it " + condition)
    instance.lines = lines
    instance.text = "; ".join(lines)
    return instance
