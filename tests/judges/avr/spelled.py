"""Expressions in two spellings, and the structs of a program with the layout that the specification gives them.

An expression is built once; each builder writes what plcxx reads and what avr-gcc reads. Where the language defines what C
leaves open (division by 0, shift counts, accesses outside, the order of evaluation) avr-gcc's spelling says it in full.
"""
import dataclasses

NOTHING = frozenset()
FAULT = frozenset({"FAULT"})
SIZES = {"char": 1, "signed char": 1, "unsigned char": 1, "short": 2, "unsigned short": 2, "int": 2, "unsigned": 2, "long": 4,
         "unsigned long": 4, "float": 4, "double": 8}
INTEGERS = tuple(SIZES)[:-2]
REAL = tuple(SIZES)[-2:]
VIEWS = {"uc": "unsigned char", "c": "char", "ui": "unsigned", "i": "int", "ul": "unsigned long", "l": "long"}
PRECEDENCE = {",": 1, "=": 2, "?": 3, "||": 4, "&&": 5, "|": 6, "^": 7, "&": 8, "==": 9, "!=": 9, "<": 10, ">": 10, "<=": 10,
              ">=": 10, "<<": 11, ">>": 11, "+": 12, "-": 12, "*": 13, "/": 13, "%": 13}
UNARY, POSTFIX = 14, 15
NAMED = {"/": "DIV", "%": "MOD", "<<": "SHL", ">>": "SHR"}


@dataclasses.dataclass(frozen=True)
class Spelled:
    plc: str
    avr: str
    kind: str = "int"
    level: int = POSTFIX
    reads: frozenset = NOTHING
    writes: frozenset = NOTHING
    constant: bool = False  # its value may be known without running; not a divisor
    target: frozenset = NOTHING  # the objects that a store to it changes
    faulty: bool = False  # an access that may be outside of its object
    field: bool = False  # a bit-field: no address

    def at(self, level):
        """In parentheses, if it binds less."""
        if self.level >= level:
            return self
        return dataclasses.replace(self, plc=f"({self.plc})", avr=f"({self.avr})", level=POSTFIX)

    def conflicts(self, other):
        return bool(self.writes & (other.reads | other.writes) or other.writes & self.reads)


def promoted(kind):
    return kind if kind in ("long", "unsigned long", "unsigned", "float") else "unsigned" if kind == "unsigned short" else "int"


def common(one, other):
    for kind in ("float", "unsigned long", "long", "unsigned"):
        if kind in (promoted(one), promoted(other)):
            return kind
    return "int"


def literal(text, kind="int", avr=None):
    return Spelled(text, avr if avr is not None else text, kind, constant=True)


def binary(operator, left, right):
    level = PRECEDENCE[operator]
    sequenced = operator in ("&&", "||")
    ordered = not sequenced and left.conflicts(right)
    one, other = left.at(level), right.at(level + 1)
    if ordered:
        # the left operand first
        inner = f"{NAMED[operator]}(left_, right_)" if operator in NAMED else f"left_ {operator} right_"
        avr = f"({{ __auto_type left_ = ({left.avr}) + 0; __auto_type right_ = ({right.avr}) + 0; {inner}; }})"
    elif operator in NAMED:
        avr = f"{NAMED[operator]}({left.avr}, {right.avr})"
    else:
        avr = f"{one.avr} {operator} {other.avr}"
    writes = left.writes | right.writes | (FAULT if operator in "/%" and not right.constant else NOTHING)
    kind = "int" if level in (4, 5, 9, 10) else promoted(left.kind) if level == 11 else common(left.kind, right.kind)
    return Spelled(f"{one.plc} {operator} {other.plc}", avr, kind,
                   level if not (ordered or operator in NAMED) else level, left.reads | right.reads, writes,
                   left.constant and (right.constant or sequenced))


def unary(operator, operand):
    inner = operand.at(UNARY)
    space = " " if inner.plc[0] in "+-&" else ""
    kind = "int" if operator == "!" else promoted(operand.kind)
    return dataclasses.replace(operand, plc=operator + space + inner.plc, avr=operator + space + inner.avr, kind=kind, level=UNARY,
                               target=NOTHING, faulty=False, field=False)


def cast(kind, operand, spelling=None):
    inner = operand.at(UNARY)
    return dataclasses.replace(operand, plc=f"({spelling or kind}) {inner.plc}", avr=f"({kind}) {inner.avr}", kind=kind,
                               level=UNARY, target=NOTHING, faulty=False, field=False)


def choice(condition, yes, no):
    one, two, three = condition.at(4), yes.at(2), no.at(3)
    arms = [arm.avr if arm.constant else f"ARM({arm.avr})" for arm in (two, three)]
    return Spelled(f"{one.plc} ? {two.plc} : {three.plc}", f"{one.avr} ? {arms[0]} : {arms[1]}", common(yes.kind, no.kind), 3,
                   condition.reads | yes.reads | no.reads, condition.writes | yes.writes | no.writes,
                   condition.constant or yes.constant and no.constant)


def comma(first, second):
    one, two = first.at(1), second.at(2)
    return Spelled(f"{one.plc}, {two.plc}", f"{one.avr}, {two.avr}", promoted(second.kind), 1, first.reads | second.reads,
                   first.writes | second.writes, second.constant)


def assignment(operator, target, value):
    """Right side first, then the left side's address."""
    plc = f"{target.plc} {operator} {value.at(2).plc}"
    base = operator[:-1]
    ordered = target.conflicts(value) or bool(value.writes & target.target)
    if base in NAMED:
        if target.field:
            avr = f"({{ __auto_type right_ = ({value.avr}) + 0; {target.avr} = {NAMED[base]}({target.avr}, right_); }})"
        else:
            avr = (f"({{ __auto_type right_ = ({value.avr}) + 0; __auto_type at_ = &{target.at(UNARY).avr}; "
                   f"*at_ = {NAMED[base]}(*at_, right_); *at_; }})")
    elif ordered:
        avr = f"({{ __auto_type right_ = ({value.avr}) + 0; {target.avr} {operator} right_; }})"
    else:
        avr = f"{target.avr} {operator} {value.at(2).avr}"
    fault = FAULT if base in ("/", "%") and not value.constant else NOTHING
    return Spelled(plc, avr, target.kind, 2, target.reads | value.reads, target.writes | value.writes | target.target | fault,
                   value.constant)


def step(operator, target, prefix):
    plc = f"{operator}{target.at(UNARY).plc}" if prefix else f"{target.at(POSTFIX).plc}{operator}"
    avr = f"{operator}{target.at(UNARY).avr}" if prefix else f"{target.at(POSTFIX).avr}{operator}"
    return Spelled(plc, avr, target.kind, UNARY if prefix else POSTFIX, target.reads, target.writes | target.target)


def call(function, arguments):
    """Arguments from right to left."""
    plc = ", ".join(a.at(2).plc for a in arguments)
    reads = function.reads.union(*(a.reads for a in arguments))
    writes = function.writes.union(*(a.writes for a in arguments))
    ordered = any(one.conflicts(other) for i, one in enumerate(arguments) for other in arguments[:i])
    if ordered:
        rows = "".join(f"__auto_type argument{i}_ = ({a.avr}) + 0; " for i, a in reversed(list(enumerate(arguments))))
        avr = f"({{ {rows}{function.name}({', '.join(f'argument{i}_' for i in range(len(arguments)))}); }})"
    else:
        avr = f"{function.name}({', '.join(a.at(2).avr for a in arguments)})"
    return Spelled(f"{function.name}({plc})", avr, function.kind, POSTFIX, reads, writes)


@dataclasses.dataclass
class Member:
    name: str
    kind: object  # a word of SIZES or a Struct
    count: int = 0
    bits: int = 0  # of a bit-field; without name it skips, with 0 bits and no name it closes


@dataclasses.dataclass
class Struct:
    word: str  # struct or union
    tag: str
    members: list

    def size(self):
        return self.layout()[0]

    def has_fields(self):
        return any(m.bits for m in self.members)

    def layout(self):
        """The size, and the members for avr-gcc with every unit of bit-fields filled up, so that nothing depends on how
        that compiler places them."""
        rows, total, unit, used = [], 0, 0, 0

        def close():
            nonlocal total, unit, used
            if unit and used < unit:
                rows.append(f"unsigned {'char ' if unit == 8 else ''}: {unit - used};")
            total += unit // 8
            unit, used = 0, 0

        for member in self.members:
            if isinstance(member.kind, Struct) or not (member.bits or not member.name):
                close()
                size = (member.kind.size() if isinstance(member.kind, Struct) else SIZES[member.kind]) * max(1, member.count)
                total = max(total, size) if self.word == "union" else total + size
                rows.append(declared(member.kind, member.name, member.count) + ";")
                continue
            width = 8 * SIZES[member.kind]
            if not member.bits:
                close()
                continue
            if unit != width or used + member.bits > width:
                close()
                unit = width
            used += member.bits
            rows.append(f"{member.kind} {member.name}: {member.bits};")
        close()
        return total, rows

    def plc(self):
        rows = [f"{m.kind} {m.name}: {m.bits};" if m.bits or not m.name else declared(m.kind, m.name, m.count) + ";"
                for m in self.members]
        return f"{self.word} {self.tag} {{ {' '.join(rows)} }};"

    def avr(self):
        size, rows = self.layout()
        check = f"_Static_assert(sizeof({self.word} {self.tag}) == {size}, \"layout\");"
        return f"{self.word} {self.tag} {{ {' '.join(rows)} }}; {check}"


def declared(kind, name, count=0):
    word = f"{kind.word} {kind.tag}" if isinstance(kind, Struct) else kind
    return f"{word} {name}" + (f"[{count}]" if count else "")


def leaves(name, kind, count=0):
    """(location, type, is a bit-field) of everything in an object, in the order of its bytes; of a union the first member."""
    if count:
        return [leaf for i in range(count) for leaf in leaves(f"{name}[{i}]", kind)]
    if not isinstance(kind, Struct):
        return [(name, kind, False)]
    members = kind.members[:1] if kind.word == "union" else kind.members
    result = []
    for member in members:
        if member.bits:
            result += [(f"{name}.{member.name}", member.kind, True)] if member.name else []
        elif member.name:
            result += leaves(f"{name}.{member.name}", member.kind, member.count)
    return result
