"""Instances that call functions of the compilers' own libraries, one for each row of library.def."""
import re
import struct

from instances import EDGES, Instance, word


def rows(path):
    """(kind, symbol, the other columns)"""
    found = re.findall(r'^PLCXX_(\w+)\("(\w+)", ([^)]*)\)', open(path).read(), re.M)
    return [(kind, symbol, [c.strip() for c in columns.split(",")]) for kind, symbol, columns in found]


def floating(rng, bits):
    """A float's bits, of every kind."""
    kind = rng.random()
    if kind < 0.4:
        number = rng.choice([0.0, -0.0, 1.0, -1.0, 0.5, 1.5, 2.0, 3.0, -7.25, 1e10, 65536.0, float("inf"), -float("inf"),
                             float("nan"), float(rng.randrange(-1000, 1000)), rng.uniform(-100, 100)])
        return struct.unpack("<I" if bits == 32 else "<Q", struct.pack("<f" if bits == 32 else "<d", number))[0]
    return rng.getrandbits(bits)


def wide(rng):
    return word(rng) | word(rng) << 32 if rng.random() < 0.7 else word(rng)


def signed(value, bits):
    return value - (1 << bits) if value >> (bits - 1) else value


def divides(rng, make, bits, has_sign):
    """Only what the functions promise: no division by zero, none that overflows."""
    while True:
        a, b = make(rng), make(rng)
        if b != 0 and not (has_sign and a == 1 << (bits - 1) and b == (1 << bits) - 1):
            return a, b


def within(rng, bits, to, has_sign):
    """A float whose integer part the result can hold."""
    while True:
        value = floating(rng, bits)
        number = struct.unpack("<f" if bits == 32 else "<d", value.to_bytes(bits // 8, "little"))[0]
        lowest, highest = (-(1 << (to - 1)), (1 << (to - 1)) - 1) if has_sign else (0, (1 << to) - 1)
        if number == number and abs(number) != float("inf") and lowest <= int(number) <= highest:
            return value


def memory(target, symbol, operation, rng):
    """Two places of the block that do not overlap, and a length."""
    instance = Instance()
    aligned = 8 if symbol.endswith("8") else 4 if symbol.endswith("4") else 1
    length = rng.choice([0, 1, 3, 4, 8, 15, 16, rng.randrange(60)])
    first, second = (104, 200) if rng.random() < 0.5 else (200, 104)
    instance.may_demand = aligned > 4  # more than the block promises
    skew = 0 if aligned > 1 else rng.randrange(8)
    a = target.arguments
    instance.bases = {a[0]: first + skew}
    count = 1
    if operation.startswith("kCopy"):
        instance.bases[a[1]] = second + (0 if aligned > 1 else rng.randrange(8))
        if symbol.endswith("move") and rng.random() < 0.5:
            instance.bases[a[1]] = first + skew + rng.randrange(-4, 5)  # these may overlap
        instance.lines = [target.number(a[2], length)]
    elif operation == "kFill":
        instance.lines = [target.number(a[2], length)]
        count = 1
    else:
        instance.lines = [target.number(a[1], length)]
    instance.lines.append(target.call(symbol))
    if not symbol.startswith("__aeabi"):
        instance.lines += [target.clear(r) for r in target.scratched if r != a[0]]
        instance.zeroed = set(instance.bases) - {a[0]}
    else:  # of these nothing is promised but what memory holds
        instance.lines += [target.clear(r) for r in target.scratched]
        instance.zeroed = set(instance.bases)
    instance.lines += target.after_call()
    return instance


def library_instance(target, row, rng):
    kind, symbol, columns = row
    if kind == "MEMORY":
        instance = memory(target, symbol, columns[0], rng)
        instance.text = f"{symbol}: " + "; ".join(instance.lines)
        return instance
    instance = Instance()
    results = 1
    extra = []
    if kind == "WIDE":
        results = 4 if columns[0].endswith("Both") else 2
        quotient = "Product" not in columns[0]
        make = (lambda r: divides(r, wide, 64, "Signed" in columns[0] and "Un" not in columns[0])) if quotient else (
            lambda r: (wide(r), wide(r)))
        instance.header = lambda r: [part for n in make(r) for part in (n & 0xFFFFFFFF, n >> 32)]
    elif kind == "SHIFT":
        results = 2
        instance.header = lambda r: [word(r), word(r), r.choice([0, 1, 31, 32, 33, 63, r.randrange(64)])]
    elif kind == "NARROW":
        results = 2 if columns[0].endswith("Both") else 1
        quotient = "Product" not in columns[0]
        instance.header = (lambda r: list(divides(r, word, 32, "Signed" in columns[0] and "Un" not in columns[0]))
                           ) if quotient else (lambda r: [word(r), word(r)])
    elif kind == "BITS":
        instance.header = lambda r: [word(r) or 1]
    elif kind in ("FLOAT", "COMPARE"):
        bits = int(columns[-1])

        def floats(r):
            numbers = [floating(r, bits), floating(r, bits)]
            if r.random() < 0.2:
                numbers[1] = numbers[0]
            return [n >> s & 0xFFFFFFFF for n in numbers for s in range(0, bits, 32)]
        instance.header = floats
        results = bits // 32 if kind == "FLOAT" else 1
        instance.is_float = bits if kind == "FLOAT" else 0
        if kind == "COMPARE":
            extra = target.truth(columns[1])
    else:  # CONVERT
        cast, bits, to = columns[0], int(columns[1]), int(columns[2])
        results = to // 32
        instance.is_float = to if cast not in ("FPToSI", "FPToUI") else 0

        def convert(r):
            if cast in ("FPToSI", "FPToUI"):
                value = within(r, bits, to, cast == "FPToSI")
            elif cast in ("FPExt", "FPTrunc"):
                value = floating(r, bits)
            else:
                value = r.getrandbits(bits) if r.random() < 0.5 else wide(r) & ((1 << bits) - 1)
            return [value >> s & 0xFFFFFFFF for s in range(0, bits, 32)]
        instance.header = convert
    kept = target.results[:results] if results <= len(target.results) else target.arguments[:results]
    instance.lines = [target.call(symbol)] + [target.clear(r) for r in target.scratched if r not in kept]
    instance.lines += extra + target.after_call()
    instance.text = f"{symbol}"
    return instance
