"""Values and places of a program in both spellings: C of dialect hnc, and calls of borland.h; types and constants."""
import dataclasses

SPELLING = {"kChar": "char", "kUchar": "unsigned char", "kInt": "int", "kUnsigned": "unsigned", "kLong": "long",
            "kUlong": "unsigned long", "kDouble": "double"}
WHOLE = [name for name in SPELLING if name != "kDouble"]
SIZE = {"kChar": 1, "kUchar": 1, "kInt": 2, "kUnsigned": 2, "kLong": 4, "kUlong": 4, "kDouble": 8}
RANGE = {"kChar": (-128, 127), "kUchar": (0, 255), "kInt": (-32768, 32767), "kUnsigned": (0, 65535),
         "kLong": (-2**31, 2**31 - 1), "kUlong": (0, 2**32 - 1), "kDouble": (-100, 100)}
ARITHMETIC = {"+": "kAdd", "-": "kSub", "*": "kMul"}
BITS = {"&": "kAnd", "|": "kOr", "^": "kXor", "<<": "kShl", ">>": "kShr"}
DIVISION = {"/": "kDiv", "%": "kMod"}
RELATIONS = {"<": "kLt", "<=": "kLe", ">": "kGt", ">=": "kGe", "==": "kEq", "!=": "kNe"}


@dataclasses.dataclass
class Expr:
    c: str
    cpp: str
    type: str


@dataclasses.dataclass
class Place:
    c: str
    cpp: str
    type: str
    inside: bool = True  # certainly inside its object

    def read(self):
        return Expr(self.c, f"Read({self.cpp})", self.type)


def promoted(kind):
    return "kInt" if kind in ("kChar", "kUchar") else kind


def common(a, b):
    a, b = promoted(a), promoted(b)
    for kind in ("kDouble", "kUlong", "kLong", "kUnsigned"):
        if kind in (a, b):
            return kind
    return "kInt"


def converted(value, kind):
    return Expr(f"(({SPELLING[kind]}) ({value.c}))", f"Convert(Type::{kind}, {value.cpp})", kind)


def literal(number, rng):
    """A constant with the type that its spelling gives it."""
    if number < 0:
        value = literal(-number, rng)
        return Expr(f"(-{value.c})", f"Minus({value.cpp})", promoted(value.type))
    spelled = rng.choice(["d", "d", "x", "o"])
    suffix = rng.choice(["", "", "", "u", "L", "UL"])
    order = {"": ["kInt", "kLong", "kUlong"] if spelled == "d" else ["kInt", "kUnsigned", "kLong", "kUlong"],
             "u": ["kUnsigned", "kUlong"], "L": ["kLong", "kUlong"], "UL": ["kUlong"]}[suffix]
    kind = next(k for k in order if number <= RANGE[k][1])
    text = {"d": str(number), "x": hex(number), "o": "0" + oct(number)[2:]}[spelled] + suffix
    return Expr(text, f"Whole(Type::{kind}, {number}LL)", kind)


def literal_int(number):
    return Expr(str(number), f"Whole(Type::kInt, {number})", "kInt")


def indented(lines):
    text, depth = [], 0
    for line in lines:
        if line.startswith("}"):
            depth -= 1
        text.append("    " * depth + line)
        if line.endswith("{"):
            depth += 1
        elif line.startswith("{ "):  # a block with its first declaration
            depth += 1
    return "\n".join(text) + "\n"
