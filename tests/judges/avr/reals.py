"""Random expressions of float and double.

avr-gcc's double is a float, so every value here is a multiple of a power of two that both hold exactly: each expression comes
with the greatest magnitude that it may have and the bits behind its point, which together stay within a float. Only
floating() in statements.py rounds, once a statement.
"""
import dataclasses

import spelled
from spelled import INTEGERS, NOTHING, POSTFIX, UNARY, Spelled
from spelled import REAL as WORDS

MOST_BITS = 22
MOST_STORED, STORED_FRACTION = 1024, 2  # of a variable, always
LITERALS = (("0.5", 1, 1), ("1.25f", 2, 2), ("3.0", 3, 0), ("2.f", 2, 0), ("100.0", 100, 0), ("1e2", 100, 0), ("25e-2", 1, 2), (".75", 1, 2), ("7.0F", 7, 0))


@dataclasses.dataclass
class Real:
    value: Spelled
    most: int
    fraction: int = 0

    def fits(self):
        return self.most.bit_length() + self.fraction <= MOST_BITS


def combined(operator, one, other):
    if operator == "*":
        return one.most * other.most, one.fraction + other.fraction
    return one.most + other.most, max(one.fraction, other.fraction)


def as_kind(kind, value):
    """What C converts a real number to where it meets an integer's place: through 64 bits, of which the low ones count."""
    return f"({kind}) (long) ({value.avr})"


class Reals:
    def real_variables(self):
        return [o for o in self.objects if o.kind in WORDS and not (o.pointer or o.name in self.unions)]

    def small(self, depth):
        """An integer of at most 255, and never below 0 or with its sign."""
        inner = self.integer(max(0, depth - 1))
        if self.chance(40):
            kind = self.random.choice(("char", "signed char", "unsigned char"))
            return spelled.cast(kind, inner), 128 if kind == "signed char" or kind == "char" and not self.options.get("char") else 255
        return spelled.binary("&", inner, spelled.literal("63")), 63

    def real_leaf(self, depth):
        usable = self.real_variables()
        if usable and self.chance(55):
            item = self.random.choice(usable)
            place = item.spelled()
            if item.count:
                index, _ = self.index(item.count, depth, True)
                place = dataclasses.replace(place, plc=f"{place.plc}[{index.plc}]", avr=f"{place.avr}[{index.avr}]", reads=place.reads | index.reads,
                                            writes=place.writes | index.writes)
            return Real(place, MOST_STORED, STORED_FRACTION)
        if self.chance(35):
            text, most, fraction = self.random.choice(LITERALS)
            return Real(spelled.literal(text, "float" if text[-1] in "fF" else "double"), most, fraction)
        value, most = self.small(depth)
        kind = self.random.choice(WORDS)
        return Real(spelled.cast(kind, value), most)

    def real(self, depth):
        if depth <= 0:
            return self.real_leaf(depth)
        pick = self.random.randrange(20)
        if pick < 4:
            return self.real_leaf(depth)
        if pick < 6:
            inner = self.real(depth - 1)
            return dataclasses.replace(inner, value=spelled.unary(self.random.choice("--+"), inner.value))
        if pick < 8:
            inner = self.real(depth - 1)
            return dataclasses.replace(inner, value=spelled.cast(self.random.choice(WORDS), inner.value))
        if pick < 10:
            one, other = self.real(depth - 1), self.real(depth - 1)
            test = self.real(depth - 1).value if self.chance(20) else self.integer(depth - 1)
            made = spelled.choice(test, one.value, other.value)
            return Real(dataclasses.replace(made, kind=common(one, other)), max(one.most, other.most), max(one.fraction, other.fraction))
        if pick < 11 and not self.pure:
            other = self.real(depth - 1)
            return dataclasses.replace(other, value=dataclasses.replace(spelled.comma(self.effect(depth - 1), other.value), kind=other.value.kind).at(POSTFIX))
        if pick < 13:
            inner = self.real(depth - 1)
            divided = Real(dataclasses.replace(plain("/", inner.value, spelled.literal(self.random.choice(("2", "2.0", "2.0f")), "double")), kind="double"),
                           inner.most, inner.fraction + 1)
            return divided if divided.fits() else inner
        if pick < 14 and "math" in self.headers:
            return self.rounded(depth)
        if pick < 15 and self.real_functions and not self.pure:
            return self.real_call(depth)
        operator = self.random.choice("+-*+-")
        one, other = self.real(depth - 1), self.real(depth - 1)
        if self.chance(30):
            value, most = self.small(depth)  # converted to the other's type
            other = Real(value, most)
        most, fraction = combined(operator, one, other)
        made = Real(dataclasses.replace(plain(operator, one.value, other.value), kind="double"), most, fraction)
        return made if made.fits() else one

    def rounded(self, depth):
        inner, name = self.real(depth - 1), self.random.choice(("fabs", "floor", "ceil", "sqrt"))
        if name == "sqrt":  # of a square
            value, most = spelled.binary("&", self.integer(max(0, depth - 1)), spelled.literal("63")), 63
            if value.writes:
                value, most = spelled.literal("9"), 9
            product = spelled.binary("*", value, value)
            return Real(dataclasses.replace(product, plc=f"sqrt({product.plc})", avr=f"sqrt({product.avr})", kind="double", level=POSTFIX), most)
        value = dataclasses.replace(inner.value, plc=f"{name}({inner.value.at(2).plc})", avr=f"{name}({inner.value.at(2).avr})", kind="double",
                                    level=POSTFIX, target=NOTHING)
        return Real(value, inner.most + 1, inner.fraction if name == "fabs" else 0)

    def real_call(self, depth):
        name, kind = self.random.choice(self.real_functions)
        one, other = self.real(depth - 1), self.small(depth)[0]
        if not Real(one.value, one.most + 300, max(2, one.fraction)).fits() or one.value.conflicts(other):
            other = spelled.literal("3")
        value = Spelled(f"{name}({one.value.at(2).plc}, {other.at(2).plc})", f"{name}({one.value.at(2).avr}, {other.at(2).avr})", kind, POSTFIX,
                        one.value.reads | other.reads, one.value.writes | other.writes)
        return Real(value, one.most + 300, max(2, one.fraction))

    def real_functions_made(self):
        """float f(double a, char b): results that stay small when the argument is."""
        from statements import Lines
        made = Lines()
        for _ in range(self.random.randrange(0, 3) if self.has_reals else 0):
            name, kind, first, second = self.fresh("r"), *(self.random.choice(WORDS) for _ in range(2)), self.random.choice(INTEGERS)
            operator, constant = self.random.choice("+-"), self.random.choice(("0.25", "2", "1.5f"))
            head = f"{kind} {name}({first} a, {second} b)"
            rows = ["{", f"if (b {self.random.choice('<>')} {self.random.choice(('2', '10'))}) return -a;", f"a {operator}= {constant};",
                    f"return b {self.random.choice(('& 1', '> a', '== 3'))} ? a : a {operator} (b & 31);", "}"]
            made += Lines([head, *rows], ["static " + head, *rows])
            self.real_functions.append((name, kind))
        if self.has_reals and self.chance(50):
            for kind in WORDS:
                name, by = self.fresh("r"), self.random.choice(INTEGERS)
                head = f"void {name}({kind} *p, {by} n)"
                rows = ["{", f"if (n {self.random.choice(('& 4', '> 3', '== 0'))}) *p = n & 31; else {self.random.choice(('*p -= 1.5', '++*p', 'p[0] = -*p'))};", "}"]
                made += Lines([head, *rows], ["static " + head, *rows])
                self.real_changers.append((name, kind))
        return made

    def of_real(self, depth):
        """An integer that is made of real numbers: a comparison, a conversion, a truth."""
        one = self.real(depth - 1)
        pick = self.random.randrange(10)
        if pick < 4:
            other = self.real(depth - 1)
            made = plain(self.random.choice(("<", ">", "<=", ">=", "==", "!=")), one.value, other.value)
            return dataclasses.replace(made, kind="int")
        if pick < 7:
            kind = self.random.choice(INTEGERS)
            inner = one.value.at(UNARY)
            return dataclasses.replace(inner, plc=f"({kind}) {inner.plc}", avr=as_kind(kind, inner), kind=kind, level=UNARY, target=NOTHING)
        if pick < 8:
            return dataclasses.replace(spelled.unary("!", one.value), kind="int")
        word = self.random.choice(("&&", "||"))
        other = self.integer(depth - 1) if self.chance(60) else self.real(depth - 1).value
        return plain(word, *((one.value, other) if self.chance(50) else (other, one.value)))

    def real_condition(self, depth):
        return self.note(self.real(depth).value)

    def real_statement(self, depth):
        """A store to a real variable, of a real number to an integer's place, or a step."""
        from statements import Lines, both
        usable = [o for o in self.real_variables() if o.name not in self.protected]
        value = self.real(3)
        if not usable or self.chance(35):
            place = self.lvalue(1, True)
            if place.target & value.value.writes or place.conflicts(value.value):
                return both(";")
            self.note(value.value, dataclasses.replace(place, writes=place.writes | place.target))
            kind = place.kind
            avr = f"(long) ({value.value.avr})" if place.field else as_kind(kind, value.value)
            return Lines([f"{place.plc} = {value.value.at(2).plc};"], [f"{place.avr} = {avr};"])
        item = self.random.choice(usable)
        own = item.spelled().target
        index = f"[{self.random.randrange(item.count)}]" if item.count else ""
        name = item.name + index
        plc = (item.plc or item.name) + index
        self.note(value.value, Spelled("", "", writes=own, reads=own))
        again = lambda text: Lines([text.format(plc)], [text.format(name)])
        tame = again(f"if ({{0}} > {MOST_STORED - 300} || {{0}} < {300 - MOST_STORED}) {{0}} = {self.random.choice(('1.5', '-2', '0'))};")
        whole = Real(value.value, value.most + 2 * MOST_STORED, max(STORED_FRACTION, value.fraction))
        if own & value.value.writes:
            return again("{0}++;") + tame
        if self.real_changers and self.chance(20):
            name_, kind = self.random.choice(self.real_changers)
            argument = self.note(self.integer(1)).at(2)
            if kind == item.kind and not item.is_volatile and not argument.writes & own and not own & argument.reads:
                return Lines([f"{name_}(&{plc}, {argument.plc});"], [f"{name_}(&{name}, {argument.avr});"]) + tame
        if self.chance(15):
            number = self.note(self.small(2)[0])
            if not number.writes & own:
                return Lines([f"{plc} = {number.at(2).plc};"], [f"{name} = {number.at(2).avr};"])
        if self.chance(45):
            # Halves and quarters at most: what is below them goes.
            store = Lines([f"{plc} = {value.value.at(2).plc};"], [f"{name} = {value.value.at(2).avr};"])
            exact = value.fraction <= STORED_FRACTION
            return store + (Lines() if exact else again("{0} = (long) {0};")) + tame
        pick = self.random.randrange(4)
        if pick == 0:
            return again(self.random.choice(("{0}++;", "{0}--;", "++{0};", "--{0};", "{0} *= 2; {0} = (int) {0};", "{0} = (int) {0}; {0} /= 4;"))) + tame
        if pick == 1:
            step = self.random.choice(("{0}++", "--{0}", "++{0}", "{0}--"))
            place = self.lvalue(1, True)
            self.note(dataclasses.replace(place, writes=place.writes | place.target))
            store = f"{step} > {self.random.choice(('2', '0.5', '-1'))}"
            return Lines([f"{place.plc} = {store.format(plc)};"], [f"{place.avr} = {store.format(name)};"]) + tame
        if not whole.fits() or value.fraction > STORED_FRACTION:
            return again("{0} -= 0.5;") + tame
        operator = self.random.choice(("+=", "-="))
        return Lines([f"{plc} {operator} {value.value.at(2).plc};"], [f"{name} {operator} {value.value.at(2).avr};"]) + tame

    def real_objects(self):
        """Global ones; floats are looked at through integers."""
        from expressions import Object
        from statements import both
        for _ in range(self.random.randrange(1, 4) if self.has_reals else 0):
            kind, name = self.random.choice(WORDS), self.fresh("q")
            item = Object(name, kind, self.random.choice((0, 0, 3)))
            initial = {0: f" = {self.random.choice(('1', '-2.5', '0.25f', '100'))}", 3: " = {1.5, -3}"}[item.count] if self.chance(60) else ""
            self.text += both(f"static {spelled.declared(kind, name, item.count)}{initial};")
            self.objects.append(item)
        for item in list(self.objects) if self.has_reals else ():
            # members of structs, too
            if isinstance(item.kind, spelled.Struct) and item.kind.word == "struct" and not (item.count or item.pointer or item.constant or item.plc):
                self.objects += [Object(f"{item.name}.{m.name}", m.kind) for m in item.kind.members if m.kind in WORDS and not m.count]

    def local_real(self):
        """A local variable: its declaration, and the object."""
        from expressions import Object
        item = Object(self.fresh("v"), self.random.choice(WORDS))
        return item, self.local(item)


def common(one, other):
    return "double" if "double" in (one.value.kind, other.value.kind) else "float"


def plain(operator, left, right):
    """Both operands in their order where one changes what the other reads."""
    level = spelled.PRECEDENCE[operator]
    one, other = left.at(level), right.at(level + 1)
    if operator not in ("&&", "||") and left.conflicts(right):
        avr = f"({{ __auto_type left_ = ({left.avr}) + 0; __auto_type right_ = ({right.avr}) + 0; left_ {operator} right_; }})"
    else:
        avr = f"{one.avr} {operator} {other.avr}"
    return Spelled(f"{one.plc} {operator} {other.plc}", avr, "int", level, left.reads | right.reads, left.writes | right.writes,
                   left.constant and (right.constant or operator in ("&&", "||")))
