"""Random expressions and the objects that they use."""
import dataclasses
import random

import spelled
from control import SYSTEM, Control
from reals import Reals
from spelled import FAULT, INTEGERS, NOTHING, POSTFIX, REAL, UNARY, VIEWS, Spelled, Struct

# What programs use of the areas, in bytes, and so what is looked at: the rest stays 0.
WINDOWS = {"X": 16, "Y": 16, "R": 48, "P": 16, "B": 16, "F": 32, "G": 32}
AREA_BYTES = {"X": 128, "Y": 128, "R": 768, "P": 200, "B": 200}
# Macros of plc.h (9.3) that stay inside of the windows: name, view, word.
HEADER_WORDS = {
    "F": [(f"{name}({axis})", view, 10 * axis + at) for axis in (0, 1) for name, view, at in (
        ("axis_stat", "ui", 0), ("axis_pout", "l", 1), ("axis_pact", "l", 3), ("axis_speed", "i", 5)) if 10 * axis + at < 15]
    + [("axis_current(0)", "i", 6), ("axis_vmax(0)", "i", 7)],
    "G": [(f"{name}({axis})", view, 10 * axis + at) for axis in (0, 1) for name, view, at in (
        ("axis_ctrl", "ui", 0), ("axis_pic_a", "l", 1), ("axis_pic_v", "i", 3), ("axis_pvcmd", "i", 4), ("axis_pecmd", "i", 5))]}
BINARY = ("+", "-", "*", "&", "|", "^", "<", ">", "<=", ">=", "==", "!=", "&&", "||", "/", "%", "<<", ">>", "+", "-", "&", "*")
# Divisors that are known without running, with their types: of both signs and of each width.
DIVISORS = {"1": "int", "2": "int", "3": "int", "7": "int", "10": "int", "100": "int", "255": "int", "1000": "int", "256u": "unsigned", "3L": "long",
            "-1": "int", "-3": "int", "-10L": "long", "0x8000": "unsigned", "65535u": "unsigned", "40000": "long", "-1L": "long", "0xFFFFFFFF": "unsigned long"}
# Counts of shifts likewise: some leave nothing of the value, and only their low 8 bits count (6.2).
COUNTS = {**{str(n): "int" for n in (0, 1, 2, 3, 4, 7, 8, 9, 12, 14, 15)}, "16": "int", "17": "int", "31": "int", "32": "int", "33": "int", "200": "int", "-1": "int",
          "256": "int", "259": "int", "1u": "unsigned", "5L": "long", "40UL": "unsigned long"}
ESCAPES = {"\\n": 10, "\\t": 9, "\\r": 13, "\\a": 7, "\\b": 8, "\\f": 12, "\\v": 11, "\\0": 0, "\\\\": 92, "\\'": 39, '\\"': 34,
           "\\x7f": 127, "\\xff": -1, "\\x80": -128, "\\101": 65, "\\377": -1}
SUFFIXES = {"": None, "u": "unsigned", "U": "unsigned", "L": "long", "l": "long", "UL": "unsigned long", "lu": "unsigned long"}
# name, result, and for a count its mask
LIBRARY = (("abs", "int", ""), ("labs", "long", ""), ("_rotl", "unsigned", "15"), ("_rotr", "unsigned", "15"),
           ("_lrotl", "unsigned long", "31"), ("_lrotr", "unsigned long", "31"), ("max", "", ""), ("min", "", ""))


@dataclasses.dataclass
class Object:
    """A variable: scalar, array (count), table (second), struct, or pointer to `count` elements of some objects."""
    name: str
    kind: object
    count: int = 0
    second: int = 0
    pointer: frozenset = NOTHING
    constant: bool = False
    plc: str = ""  # where it hides another one's name
    is_volatile: bool = False  # or has no address

    def spelled(self):
        whole = frozenset({self.name.partition(".")[0]})  # of a member
        return Spelled(self.plc or self.name, self.name, self.kind, reads=whole, target=whole)


@dataclasses.dataclass
class Function:
    name: str
    kind: str
    parameters: list  # Objects
    reads: frozenset = NOTHING
    writes: frozenset = NOTHING
    rounds: int = 1


@dataclasses.dataclass
class Macro:
    name: str
    build: object  # arguments to Spelled
    parameters: int


class Expressions(Reals, Control):
    """What is in scope, and expressions over it."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.objects, self.functions, self.macros, self.enumerators = [], [], [], []
        self.counting = []  # counters of the loops around, with the greatest value that each has
        self.protected = set()  # not to be changed: counters and limits of the loops around
        self.structs = []
        self.rounds = 1
        self.pure = False  # neither stores nor calls
        self.known = list(LIBRARY[:1])
        self.headers, self.options, self.words, self.unions = set(), {}, set(), set()
        self.enumerator_values, self.enumerators_apart = {}, []
        self.real_functions, self.real_changers, self.pointer_functions = [], [], []
        self.has_reals = self.has_pointers = self.has_control = self.has_customs = self.uses_system = False
        self.storing, self.row_functions = {}, {}  # names of macros by their words; functions over tables by the type of their rows

    def chance(self, of_hundred):
        return self.random.randrange(100) < of_hundred

    # leaves

    def constant(self):
        pick = self.random
        kind = pick.randrange(12)
        if kind < 5:
            return spelled.literal(str(pick.choice((0, 1, 2, 3, 5, 7, 8, 10, 15, 16, 100, 127, 128, 255, 256, 1000))))
        if kind < 7:
            value = pick.choice((pick.randrange(65536), 32767, 32768, 40000, 65535, 65536, 70000, 2147483647, 2147483648, 4294967295))
            limits = ((32767, "int"), (2147483647, "long"), (4294967295, "unsigned long"))
            return spelled.literal(str(value), next(k for limit, k in limits if value <= limit))
        if kind < 9:
            value = pick.choice((0x80, 0xFF, 0x7FFF, 0x8000, 0xFFFF, 0x10000, 0x7FFFFFFF, 0x80000000, pick.randrange(256), 1 << pick.randrange(31)))
            text = pick.choice((f"0x{value:X}", f"0X{value:x}", f"0{value:o}", f"0x{value:04x}"))
            limits = ((32767, "int"), (65535, "unsigned"), (2147483647, "long"), (4294967295, "unsigned long"))
            return spelled.literal(text, next(k for limit, k in limits if value <= limit))
        if kind == 9:
            text, value = pick.choice(list(ESCAPES.items()))
            value &= 255 if self.options.get("char") else -1
            return spelled.literal(f"'{text}'", "int", str(value) if value >= 0 else f"({value})")
        if kind == 10:
            one, other = pick.choice("ABMSTaz09 "), pick.choice("ABxyz12")
            if self.chance(50):
                return spelled.literal(f"'{one}'", "int", str(ord(one)))
            return spelled.literal(f"'{one}{other}'", "int", str(ord(one) | ord(other) << 8))
        suffix = pick.choice(list(SUFFIXES))
        return spelled.literal(f"{pick.choice((1, 3, 50, 255, 3000))}{suffix}", SUFFIXES[suffix] or "int")

    def number(self):
        """A constant, an enumerator or a sizeof."""
        pick = self.random.randrange(10)
        if pick == 0 and self.enumerators:
            return spelled.literal(self.random.choice(self.enumerators))
        if pick == 2 and self.objects:
            # not evaluated
            inner = self.integer(1)
            # avr-gcc gives an assignment to a bit-field the size of the field
            if not inner.field and not (inner.writes and ("." in inner.plc or "->" in inner.plc)):
                return spelled.literal(f"sizeof({inner.plc})", "unsigned", f"sizeof({inner.avr})")
        if pick == 3 and (arrays := [o for o in self.objects if o.count and o.kind != "double" and not (o.pointer or o.plc)]):
            item = self.random.choice(arrays)
            text = self.random.choice(("sizeof {0} / sizeof {0}[0]", "sizeof({0}) / sizeof(*{0})", "sizeof {0}", "sizeof {0}[0]")).format(item.name)
            return dataclasses.replace(spelled.literal(text, "unsigned"), level=spelled.PRECEDENCE["/"] if "/" in text else UNARY)
        if pick == 1:
            if self.structs and self.chance(30):
                struct = self.random.choice(self.structs)
                return spelled.literal(f"sizeof(struct {struct.tag})" if struct.word == "struct" else f"sizeof(union {struct.tag})",
                                       "unsigned", f"{struct.size()}u")
            kind = self.random.choice(INTEGERS)
            return spelled.literal(f"sizeof({kind})", "unsigned", f"{spelled.SIZES[kind]}u")
        return self.constant()

    def index(self, count, depth, sure):
        """An expression and whether it may be outside of 0..count-1."""
        if depth <= 0 or self.chance(30 if self.counting else 45):
            return spelled.literal(str(self.random.randrange(count))), False
        if self.counting and self.chance(40):
            counter, most = self.random.choice(self.counting)
            if most < count or not sure:
                return counter.spelled(), most >= count
        inner = self.integer(depth - 1)
        if inner.constant or "sizeof" in inner.plc:
            return spelled.literal(str(self.random.randrange(count))), False
        if inner.kind in ("long", "unsigned long") or not sure and self.chance(70) or sure:
            mask = (1 << (count.bit_length() - 1)) - 1
            return spelled.binary("&", inner, spelled.literal(str(mask))), False
        return spelled.binary("%", inner, spelled.literal(str(count + 1))), True

    def element(self, base, kind, count, depth, sure=False):
        """base[index]; avr-gcc's array is checked where the index may be outside."""
        index, outside = self.index(count, depth, sure)
        array = base.at(POSTFIX)
        avr = f"AT({array.avr}, {index.avr})" if outside else f"{array.avr}[{index.avr}]"
        return Spelled(f"{array.plc}[{index.plc}]", avr, kind, POSTFIX, base.reads | index.reads,
                       base.writes | index.writes | (FAULT if outside else NOTHING), target=base.target, faulty=outside)

    def register(self, depth, writable, sure=False):
        area = self.random.choice("YRBGYRG" if writable else "XYRFGPBXR")
        if area in "FG":
            return self.word(area, depth, writable, sure)
        if area == "R" and self.structs and self.chance(15):
            return self.register_struct(depth)
        view = self.random.choice(list(VIEWS) + [""] * 6)
        used = view or ("ui" if area in "PB" else "uc")
        kind = VIEWS[used]
        name = Spelled(f"{area}_{view}" if view else area, f"{area}.{used}", kind, reads=frozenset({area}), target=frozenset({area}))
        if not sure and not writable and depth > 0 and self.chance(8):
            # maybe outside of the area; what is between the window and its end is 0
            inner = self.integer(depth - 1)
            if not inner.constant and inner.kind not in ("long", "unsigned long") and "sizeof" not in inner.plc:
                return Spelled(f"{name.plc}[{inner.plc}]", f"AT({name.avr}, {inner.avr})", kind, POSTFIX, name.reads | inner.reads,
                               inner.writes | FAULT, target=name.target, faulty=True)
        return self.element(name, kind, WINDOWS[area] // spelled.SIZES[kind], depth, True)

    def register_struct(self, depth):
        """Registers as a struct, at any address."""
        struct = self.random.choice(self.structs)
        if struct.size() > WINDOWS["R"]:
            return Spelled("R[0]", "R.uc[0]", "unsigned char", reads=frozenset({"R"}), target=frozenset({"R"}))
        at = self.random.randrange(WINDOWS["R"] - struct.size() + 1)
        head = f"(({struct.word} {struct.tag} *) "
        base = Spelled(f"{head}&R[{at}])->", f"{head}&R.uc[{at}])->", reads=frozenset({"R"}), target=frozenset({"R"}))
        return self.member(base, struct, depth, True)

    def bytes_of(self, item):
        """A byte of a variable, or a part of an array's bytes in another type."""
        kind = self.random.choice(("unsigned char", "char", "unsigned", "int"))
        size = spelled.SIZES[item.kind] * max(1, item.count)
        if size < spelled.SIZES[kind]:
            kind = "unsigned char"
        at = self.random.randrange(size // spelled.SIZES[kind])
        base = item.spelled()
        cast = f"(({kind} *) {'' if item.count else '&'}{{}})[{at}]"
        return dataclasses.replace(base, plc=cast.format(base.plc), avr=cast.format(base.avr), kind=kind, level=POSTFIX)

    def word(self, area, depth, writable, sure):
        """*F_T[k] and F_T[k][n] of the tables of pointers, and the names that the header has for some."""
        if self.has_control and self.chance(25):
            return self.control_word(area, depth)
        if self.chance(15):
            name, view, at = self.random.choice(HEADER_WORDS[area])
            kind = VIEWS[view]
            text = f"WORD({area}, {kind}, {at})"
            return Spelled(f"*{name}", text, kind, UNARY, frozenset({area}), target=frozenset({area}))
        view = self.random.choice(list(VIEWS) + [""] * 6)
        kind = VIEWS[view or "ui"]
        table = f"{area}_{view}" if view else area
        effect = frozenset({area})
        index, _ = self.index(8, depth, True)
        if not index.constant or self.chance(60):
            return Spelled(f"*{table}[{index.plc}]", f"WORD({area}, {kind}, {index.avr})", kind, UNARY, effect | index.reads,
                           index.writes | (FAULT if not index.constant else NOTHING), target=effect)
        inner = self.random.randrange(3)
        text = f"(({kind}*)&{area}.uc[2 * ({index.avr})])[{inner}]"
        return Spelled(f"{table}[{index.plc}][{inner}]", text, kind, POSTFIX, effect, target=effect)

    def access(self, item, depth, sure=False):
        """An integer of the object."""
        base = item.spelled()
        if item.pointer:
            base = dataclasses.replace(base, target=item.pointer, reads=base.reads | item.pointer)
            if self.chance(40) and not isinstance(item.kind, Struct):
                return dataclasses.replace(base, plc=f"*{base.plc}", avr=f"*{base.avr}", level=UNARY)
            index = spelled.literal(str(self.random.randrange(item.count)))
            if self.chance(40) and item.count > 1 and depth > 0:
                index, _ = self.index(item.count, depth, True)
            if isinstance(item.kind, Struct):
                return self.member(dataclasses.replace(base, plc=f"{base.plc}->", avr=f"{base.avr}->"), item.kind, depth, sure)
            form = self.random.randrange(2)
            plc = f"{base.plc}[{index.plc}]" if form else f"*({base.plc} + {index.at(13).plc})"
            avr = f"{base.avr}[{index.avr}]" if form else f"*({base.avr} + {index.at(13).avr})"
            return dataclasses.replace(base, plc=plc, avr=avr, level=POSTFIX if form else UNARY, reads=base.reads | index.reads,
                                       writes=base.writes | index.writes)
        if item.kind in spelled.INTEGERS and not (item.second or item.constant or item.is_volatile) and self.chance(5):
            return self.bytes_of(item)
        if item.second:
            row = self.element(base, item.kind, item.count, depth, True)
            return self.element(row, item.kind, item.second, depth, True)
        if item.count:
            if not item.is_volatile and self.chance(3):
                base = dataclasses.replace(base, plc=f"(*&{base.plc})", avr=f"(*&{base.avr})")
            base = self.element(base, item.kind, item.count, depth, sure or isinstance(item.kind, Struct))
        if isinstance(item.kind, Struct):
            return self.member(dataclasses.replace(base, plc=f"{base.plc}.", avr=f"{base.avr}."), item.kind, depth, sure)
        return base

    def member(self, base, struct, depth, sure):
        """`base` ends in . or ->"""
        member = self.random.choice([m for m in struct.members if m.name and m.kind not in REAL])
        inner = dataclasses.replace(base, plc=base.plc + member.name, avr=base.avr + member.name)
        if isinstance(member.kind, Struct):
            if member.count:
                inner = self.element(inner, member.kind, member.count, depth, True)
            inner = dataclasses.replace(inner, plc=inner.plc + ".", avr=inner.avr + ".")
            return self.member(inner, member.kind, depth, sure)
        inner = dataclasses.replace(inner, kind=member.kind, field=bool(member.bits), faulty=False)
        if member.bits and member.bits < 8 * spelled.SIZES[member.kind]:
            inner = dataclasses.replace(inner, kind="int")
        # outside of a member's array is not yet outside of the object
        return self.element(inner, member.kind, member.count, depth, True) if member.count else inner

    def lvalue(self, depth, sure=False):
        """Something that may be stored to here."""
        for _ in range(20):
            usable = [o for o in self.objects if not o.constant]
            if not usable or self.chance(35):
                found = self.register(depth, True, sure)
            else:
                item = self.random.choice(usable)
                found = self.access(item, depth, sure)
            if not (found.target | found.writes) & self.protected and found.kind not in REAL:
                return found
        return Spelled(self.sink, self.sink, "int", reads=frozenset({self.sink}), target=frozenset({self.sink}))

    # expressions

    def leaf(self, depth):
        if self.chance(22):
            return self.number()
        if self.chance(30) or not self.objects:
            return self.register(depth, False)
        found = self.access(self.random.choice(self.objects), depth)
        return found if found.kind not in REAL else self.number()

    def integer(self, depth):
        if depth <= 0:
            return self.leaf(0)
        pick = self.random.randrange(100)
        if pick < 14:
            return self.leaf(depth)
        if self.has_reals and depth > 1 and self.chance(6):
            return self.of_real(depth).at(POSTFIX)
        if self.has_control and not self.pure and self.chance(2) and not SYSTEM & self.protected:
            return self.system_value(depth)
        if pick < 62:
            return self.operation(depth)
        if pick < 72:
            return spelled.unary(self.random.choice(("-", "~", "!", "+", "-", "~")), self.integer(depth - 1))
        if pick < 78:
            return spelled.cast(self.random.choice(INTEGERS), self.integer(depth - 1))
        if pick < 81:
            return self.library(depth)
        if pick < 85:
            return spelled.choice(*(self.integer(depth - 1) for _ in range(3)))
        if pick < 89 and self.macros:
            return self.expanded(depth)
        if self.pure:
            return self.operation(depth)
        if pick < 92:
            return self.stepped(depth)
        if pick < 94:
            return self.assigned(depth).at(POSTFIX)
        if pick < 96:
            return spelled.comma(self.effect(depth - 1), self.integer(depth - 1)).at(POSTFIX)
        made = self.member_of_result(depth) if self.chance(25) else None
        return made or self.called(depth) or self.operation(depth)

    def operation(self, depth):
        operator = self.random.choice(BINARY)
        left, right = self.integer(depth - 1), self.integer(depth - 1 if self.chance(70) else 0)
        if operator in "/%":
            if right.constant:
                right = self.one_of(DIVISORS)
        elif operator in ("<<", ">>") and right.constant:
            right = self.one_of(COUNTS)
        elif operator in ("<<", ">>") and self.chance(60):
            right = spelled.binary("&", right, spelled.literal(self.random.choice(("7", "15", "31", "63"))))
        return spelled.binary(operator, left, right)

    def one_of(self, constants):
        text, kind = self.random.choice(list(constants.items()))
        return dataclasses.replace(spelled.literal(text, kind), level=UNARY if text[0] == "-" else POSTFIX)

    def library(self, depth):
        """abs is known without its header."""
        name, kinds, mask = self.random.choice(self.known)
        first = self.integer(depth - 1)
        arguments = [first]
        if mask:
            arguments.append(spelled.binary("&", self.integer(depth - 1), spelled.literal(mask)))
        if name in ("max", "min"):
            was, self.pure = self.pure, True
            one, other = (self.integer(depth - 2).at(2) for _ in range(2))
            self.pure = was
            return Spelled(f"{name}({one.plc}, {other.plc})", f"{name}({one.avr}, {other.avr})", spelled.common(one.kind, other.kind),
                           POSTFIX, one.reads | other.reads, one.writes | other.writes, one.constant and other.constant)
        made = spelled.call(Function(name, kinds, []), arguments)
        if name == "abs" and self.options.get("abs"):
            # of the width of its argument; in the two spellings alike but for the name
            kind = "long" if first.kind in ("long", "unsigned long") else "int"
            made = dataclasses.replace(made, avr="ABS" + made.avr[len("abs"):], kind=kind)
        return dataclasses.replace(made, constant=all(a.constant for a in arguments))

    def stepped(self, depth):
        return spelled.step(self.random.choice(("++", "--")), self.lvalue(depth - 1, True), self.chance(50))

    def assigned(self, depth, sure=True):
        target = self.lvalue(depth - 1, sure)
        operator = self.random.choice(("=", "=", "=", "+=", "-=", "*=", "&=", "|=", "^=", "<<=", ">>=", "/=", "%="))
        if target.field and target.writes and operator[:-1] in spelled.NAMED:
            operator = "^="  # avr-gcc's spelling would evaluate the index twice
        value = self.integer(depth - 1)
        if operator in ("/=", "%=") and value.constant:
            value = self.one_of(DIVISORS)
        if operator in ("<<=", ">>="):
            value = self.one_of(COUNTS) if value.constant else value
        return spelled.assignment(operator, target, value)

    def member_of_result(self, depth):
        """f(a, s).m, and (c ? s : t).m"""
        usable = [o for o in self.objects if isinstance(o.kind, Struct) and not (o.count or o.pointer or o.constant)]
        if not usable:
            return None
        item = self.random.choice(usable)
        makers = [name for name, kind, values in self.struct_functions if kind is item.kind and values == 1]
        others = [o for o in usable if o.kind is item.kind]
        if makers and self.chance(70):
            value, name = self.integer(depth - 1).at(2), self.random.choice(makers)
            if value.writes & {item.name}:
                value = spelled.literal("3")
            base = dataclasses.replace(value, plc=f"{name}({value.plc}, {item.name})", avr=f"{name}({value.avr}, {item.name})",
                                       reads=value.reads | {item.name}, level=POSTFIX, constant=False, target=NOTHING)
        elif len(others) > 1:
            other, test = self.random.choice(others), self.integer(depth - 1).at(4)
            base = dataclasses.replace(test, plc=f"({test.plc} ? {item.name} : {other.name})", level=POSTFIX, constant=False,
                                       avr=f"({test.avr} ? {item.name} : {other.name})",
                                       reads=test.reads | {item.name, other.name}, target=NOTHING)
        else:
            return None
        # An array in a value cannot be indexed in the C of either compiler.
        members = [m for m in item.kind.members if m.name and not m.count and not isinstance(m.kind, Struct) and m.kind not in REAL]
        if not members:
            return None
        member = self.random.choice(members)
        kind = "int" if member.bits and member.bits < 8 * spelled.SIZES[member.kind] else member.kind
        return dataclasses.replace(base, plc=f"{base.plc}.{member.name}", avr=f"{base.avr}.{member.name}", kind=kind, faulty=False,
                                   field=bool(member.bits))

    def effect(self, depth):
        return self.stepped(depth) if self.chance(40) else self.assigned(depth)

    def called(self, depth):
        usable = [f for f in self.functions if not f.writes & self.protected and f.rounds * self.rounds <= 3000 and f.kind != "void"]
        return self.call_of(self.random.choice(usable), depth) if usable else None

    def call_of(self, function, depth):
        arguments = []
        for parameter in function.parameters:
            value = self.pointed(parameter) if parameter.pointer else self.integer(depth - 1)
            if getattr(function, "old", False):
                value = spelled.cast(parameter.kind, value)
            arguments.append(value)
        through = frozenset().union(*(a.target for f, a in zip(function.parameters, arguments) if f.pointer))
        made = spelled.call(function, arguments)
        return dataclasses.replace(made, reads=made.reads | through, writes=made.writes | through)

    def pointed(self, parameter):
        """The argument for a pointer parameter: one of the objects that it was made for."""
        own = [o for o in self.objects if o.name[0] in "vs" and o.kind == parameter.kind and max(1, o.count) >= parameter.count
               and not (o.second or o.pointer or o.constant or o.plc or o.is_volatile) and o.name not in self.protected]
        if own and self.chance(30):  # of the calling function
            item = self.random.choice(own)
            text = item.name if item.count else f"&{item.name}"
            return Spelled(text, text, "pointer", 2 if item.count else UNARY, NOTHING, target=frozenset({item.name}))
        hidden = {o.plc for o in self.objects}  # the address would be that of the local with this name
        name = self.random.choice(sorted(parameter.pointer - hidden))
        plc, avr = parameter.addresses[name]
        return Spelled(plc, avr, "pointer", 2, NOTHING, target=frozenset({name}))

    def expanded(self, depth):
        macro = self.random.choice(self.macros)
        was, self.pure = self.pure, True
        arguments = [self.integer(depth - 2) for _ in range(macro.parameters)]
        self.pure = was
        return macro.build(arguments)
