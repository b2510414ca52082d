"""Random programs of dialect hnc, each spelled twice: as C, and as C++ over borland.h that does the same step by step.

Expr and Place carry both spellings and the type, so whatever is put together stays equivalent. The C keeps to what the
dialect accepts: loops with a bound in sight, no recursion, declarations first, no constant divisor 0 or constant index
outside. Everything else is as wild as possible: widths, signs, shift counts, side effects inside expressions, indices
that leave their object, divisors that happen to be 0.
"""
import dataclasses
import random

from spelling import (ARITHMETIC, BITS, DIVISION, RANGE, RELATIONS, SIZE, SPELLING, WHOLE, Expr, Place, common, converted,
                      indented, literal, literal_int, promoted)

CYCLES = 6
R_BYTES, INPUTS = 64, 8
G_FIRST, G_WORDS, F_FIRST = 20, 4, 30


@dataclasses.dataclass
class Function:
    name: str
    result: str
    parameters: list
    pointer: bool    # the first parameter is an int *
    old_style: bool  # K&R: arguments must have the promoted types of the parameters


class Generator:
    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.names = 0
        self.objects = []    # (name, bytes): what the reference allocates
        self.observed = []   # (location of a scenario, place of the reference)
        self.places = []     # globals that may be read and written
        self.locals = []     # of the function that is being made
        self.functions = []
        self.called = set()
        self.arrays = []     # (name, type of the elements, count)
        self.c, self.cpp, self.initial = [], [], []
        self.with_reals = self.rng.random() < 0.3

    def fresh(self, prefix):
        self.names += 1
        return f"{prefix}{self.names}"

    def chance(self, probability):
        return self.rng.random() < probability

    def number(self, kind):
        low, high = RANGE[kind]
        edge = [0, 1, 2, 7, 100, low, high, high - 1, low + 1]
        number = self.rng.choice(edge) if self.chance(0.4) else self.rng.randint(max(low, -300), min(high, 300))
        return number if self.chance(0.8) else self.rng.randint(low, high)

    # ---- data

    def global_data(self):
        for _ in range(self.rng.randint(5, 8)):
            self.scalar(self.rng.choice(WHOLE))
        for kind in self.rng.sample(WHOLE, 2) + ["kInt"]:
            self.array(kind, self.rng.randint(3, 6))
        self.structure()
        self.bit_fields()
        if self.with_reals:
            name = self.fresh("d")
            self.objects.append((name, 8))
            self.c.append(f"double {name};")
            self.places.append(Place(name, f"At({name}, Type::kDouble, 0)", "kDouble"))
        for view, kind in (("R", "kUchar"), ("R_c", "kChar"), ("R_i", "kInt"), ("R_ui", "kUnsigned"),
                           ("R_l", "kLong"), ("R_ul", "kUlong")):
            for _ in range(2):
                index = self.rng.randrange(R_BYTES // SIZE[kind])
                self.places.append(
                    Place(f"{view}[{index}]", f"At(R, Type::{kind}, {index * SIZE[kind]})", kind))
        self.places.append(Place("Y[1]", "At(Y, Type::kUchar, 1)", "kUchar"))
        word = G_FIRST + self.rng.randrange(G_WORDS)
        self.places.append(Place(f"*G_i[{word}]", f"At(G, Type::kInt, {2 * word})", "kInt"))
        self.observed += [(f"R_ul[{i}]", f"At(R, Type::kUlong, {4 * i})") for i in range(R_BYTES // 4)]
        self.observed += [("Y_ul[0]", "At(Y, Type::kUlong, 0)")]
        self.observed += [(f"G_i[{i}]", f"At(G, Type::kInt, {2 * i})") for i in range(G_FIRST, G_FIRST + G_WORDS)]

    def scalar(self, kind):
        name = self.fresh("g")
        start = self.number(kind)
        storage = self.rng.choice(["", "", "static "])
        if self.chance(0.3):
            start = 0
            self.c.append(f"{storage}{SPELLING[kind]} {name};")
        else:
            self.c.append(f"{storage}{SPELLING[kind]} {name} = {start};")
        self.objects.append((name, SIZE[kind]))
        place = f"At({name}, Type::{kind}, 0)"
        self.initial.append(f"Store({place}, Whole(Type::{kind}, {start}LL));")
        self.places.append(Place(name, place, kind))
        self.observed.append((name, place))

    def array(self, kind, count):
        name = self.fresh("a")
        values = [self.number(kind) for _ in range(self.rng.randint(1, count))]
        self.c.append(f"{SPELLING[kind]} {name}[{count}] = {{{', '.join(map(str, values))}}};")
        self.objects.append((name, SIZE[kind] * count))
        for i in range(count):
            place = f"At({name}, Type::{kind}, {i * SIZE[kind]})"
            if i < len(values):
                self.initial.append(f"Store({place}, Whole(Type::{kind}, {values[i]}LL));")
            self.observed.append((f"{name}[{i}]", place))
        self.arrays.append((name, kind, count))

    def structure(self):
        """struct of 10 bytes: char, int, long, three bytes; one of them and three in an array; a union."""
        self.c += ["struct rec { char c; int i; long l; unsigned char u[3]; } s, t[3];",
                   "union { unsigned w; unsigned char b[2]; long l; } un;"]
        self.objects += [("s", 10), ("t", 30), ("un", 4)]
        for member, kind, offset in (("c", "kChar", 0), ("i", "kInt", 1), ("l", "kLong", 3)):
            self.places.append(Place(f"s.{member}", f"At(s, Type::{kind}, {offset})", kind))
            self.observed.append((f"s.{member}", f"At(s, Type::{kind}, {offset})"))
            for i in range(3):
                self.observed.append((f"t[{i}].{member}", f"At(t, Type::{kind}, {10 * i + offset})"))
        self.places.append(Place("s.u[1]", "At(s, Type::kUchar, 8)", "kUchar"))
        for member, kind, offset in (("w", "kUnsigned", 0), ("b[1]", "kUchar", 1), ("l", "kLong", 0)):
            self.places.append(Place(f"un.{member}", f"At(un, Type::{kind}, {offset})", kind))
        self.observed.append(("un.l", "At(un, Type::kLong, 0)"))

    def bit_fields(self):
        """Fields from bit 0 on in 16-bit units; one that does not fit begins the next unit."""
        members, unit, shift = [], 0, 0
        for i in range(self.rng.randint(3, 6)):
            width = self.rng.choice([1, 2, 3, 5, 7, 9, 12, 16])
            signed = self.chance(0.5)
            if shift + width > 16:
                unit, shift = unit + 1, 0
            members.append(f"{'int' if signed else 'unsigned'} f{i} : {width};")
            place = f"Field{{bf.bytes + {2 * unit}, 2, {shift}, {width}, {'true' if signed else 'false'}}}"
            kind = "kUnsigned" if width == 16 and not signed else "kInt"
            self.places.append(Place(f"bf.f{i}", place, kind))
            shift += width
        self.c.append(f"struct {{ {' '.join(members)} }} bf;")
        self.objects.append(("bf", 2 * (unit + 1)))

    # ---- places and values

    def place(self, depth):
        """Something that can be stored to."""
        if depth > 0 and self.chance(0.3):
            return self.element(depth - 1)
        writable = self.places + [p for p in self.locals for _ in range(3)]
        return self.rng.choice(writable)

    def index(self, depth, count):
        """(index, certainly inside); constants stay inside."""
        kind = self.rng.random()
        if kind < 0.3:
            number = self.rng.randrange(count)
            return Expr(str(number), f"Whole(Type::kInt, {number})", "kInt"), True
        value = self.small(self.variable(depth))
        if kind < 0.8:
            mask = max(m for m in (0, 1, 3, 7, 15, 31, 63) if m < count)
            return self.binary(value, "&", Expr(str(mask), f"Whole(Type::kInt, {mask})", "kInt")), True
        return value, False

    def small(self, value):
        """An int or narrower: no index that wraps in 16 bits."""
        if value.type in ("kChar", "kUchar", "kInt"):
            return value
        return Expr(f"(char) {value.c}", f"Convert(Type::kChar, {value.cpp})", "kChar")

    def element(self, depth):
        choice = self.rng.random()
        if choice < 0.5:
            name, kind, count = self.rng.choice(self.arrays)
            index, inside = self.index(depth, count)
            return Place(f"{name}[{index.c}]", f"Element({name}, Type::{kind}, 0, {index.cpp})", kind, inside)
        if choice < 0.75:
            member, kind, offset = self.rng.choice([("c", "kChar", 0), ("i", "kInt", 1), ("l", "kLong", 3)])
            index, inside = self.index(depth, 3)
            cpp = f"At(t, Type::{kind}, ({index.cpp}).whole * 10 + {offset})"
            return Place(f"t[{index.c}].{member}", cpp, kind, inside)
        view, kind = self.rng.choice([("R", "kUchar"), ("R_c", "kChar"), ("R_ui", "kUnsigned"), ("R_l", "kLong")])
        index, _ = self.index(depth, R_BYTES // SIZE[kind])
        index = self.binary(index, "&", literal_int(R_BYTES // SIZE[kind] - 1))
        return Place(f"{view}[{index.c}]", f"Element(R, Type::{kind}, 0, {index.cpp})", kind)

    def variable(self, depth):
        """A value that no compiler can fold."""
        choice = self.rng.random()
        k = self.rng.randrange(INPUTS)
        if choice < 0.15:
            return Expr(f"X[{k}]", f"Read(At(X, Type::kUchar, {k}))", "kUchar")
        if choice < 0.3:
            return Expr(f"P_i[{k}]", f"Read(At(P, Type::kInt, {2 * k}))", "kInt")
        if choice < 0.4:
            return Expr(f"*F_l[{F_FIRST + k}]", f"Read(At(F, Type::kLong, {2 * (F_FIRST + k)}))", "kLong")
        return self.place(depth).read()

    def whole(self, depth):
        value = self.expression(depth)
        if value.type != "kDouble":
            return value
        kind = self.rng.choice(WHOLE)
        return Expr(f"({SPELLING[kind]}) ({value.c})", f"Convert(Type::{kind}, {value.cpp})", kind)

    def binary(self, left, op, right):
        names = {**ARITHMETIC, **BITS, **DIVISION, **RELATIONS}
        if op in RELATIONS:
            kind = "kInt"
        elif op in ("<<", ">>"):
            kind = promoted(left.type)
        else:
            kind = common(left.type, right.type)
        return Expr(f"({left.c} {op} {right.c})", f"Binary{{{left.cpp}, Op::{names[op]}, {right.cpp}}}()", kind)

    def expression(self, depth):
        if depth <= 0 or self.chance(0.15):
            if self.chance(0.35):
                return literal(self.number(self.rng.choice(WHOLE)), self.rng)
            return self.variable(depth - 1)
        makers = [self.arithmetic] * 5 + [self.bits] * 4 + [self.division] * 2 + [self.unary] * 2 + \
                 [self.relation] * 2 + [self.logical, self.conditional, self.cast, self.cast, self.effect, self.call]
        return self.rng.choice(makers)(depth)

    def arithmetic(self, depth):
        left, right = self.expression(depth - 1), self.expression(depth - 1)
        return self.binary(left, self.rng.choice(list(ARITHMETIC)), right)

    def bits(self, depth):
        left, right = self.whole(depth - 1), self.whole(depth - 1)
        return self.binary(left, self.rng.choice(list(BITS)), right)

    def division(self, depth):
        """By something that is no constant, or by a constant that is not 0."""
        left = self.whole(depth - 1)
        right = self.variable(depth - 1) if self.chance(0.7) else literal(self.rng.choice([1, 2, 3, 10, 200]), self.rng)
        if right.type == "kDouble":
            return self.binary(left, "/", right)
        return self.binary(left, self.rng.choice(["/", "%"]), right)

    def unary(self, depth):
        op = self.rng.choice("-~!")
        value = self.whole(depth - 1) if op == "~" else self.expression(depth - 1)
        function = {"-": "Minus", "~": "Complement", "!": "Not"}[op]
        return Expr(f"({op}({value.c}))", f"{function}({value.cpp})", "kInt" if op == "!" else promoted(value.type))

    def relation(self, depth):
        return self.binary(self.expression(depth - 1), self.rng.choice(list(RELATIONS)), self.expression(depth - 1))

    def logical(self, depth):
        op = self.rng.choice(["&&", "||"])
        left, right = self.expression(depth - 1), self.expression(depth - 1)
        return Expr(f"({left.c} {op} {right.c})", f"Bool({left.cpp}.Truth() {op} {right.cpp}.Truth())", "kInt")

    def conditional(self, depth):
        condition, a, b = (self.expression(depth - 1) for _ in range(3))
        kind = common(a.type, b.type)
        return Expr(f"({condition.c} ? {a.c} : {b.c})",
                    f"({condition.cpp}.Truth() ? Convert(Type::{kind}, {a.cpp}) : Convert(Type::{kind}, {b.cpp}))", kind)

    def cast(self, depth):
        return converted(self.expression(depth - 1), self.rng.choice(WHOLE))

    def effect(self, depth):
        """An assignment or a step inside an expression, to a place that is certainly there."""
        place = self.rng.choice(self.places + self.locals)
        where = f"[&] {{ return {place.cpp}; }}"
        if self.chance(0.5):
            value = self.expression(depth - 1)
            return Expr(f"({place.c} = {value.c})", f"Assign({value.cpp}, {where})", place.type)
        step = self.rng.choice(["++", "--"])
        number = 1 if step == "++" else -1
        if self.chance(0.5):
            return Expr(f"({step}{place.c})", f"Before({where}, {number})", place.type)
        c = f"({place.c})" if place.c.startswith("*") else place.c
        return Expr(f"({c}{step})", f"After({where}, {number})", place.type)

    def call(self, depth):
        if not self.functions:
            return self.variable(depth)
        return self.call_of(self.rng.choice(self.functions), depth)

    def call_of(self, function, depth):
        self.called.add(function.name)
        arguments = [self.expression(depth - 2) for _ in function.parameters]
        if function.old_style:
            kinds = [promoted(kind) for _, kind in function.parameters]
            arguments = [converted(a, kind) for a, kind in zip(arguments, kinds)]
        c, names = [a.c for a in arguments], [f"v{i}" for i in range(len(arguments))]
        # Arguments are evaluated from right to left.
        steps = "".join(f"const Value {n} = {a.cpp}; " for n, a in reversed(list(zip(names, arguments))))
        if function.pointer:
            name, _, count = next(a for a in self.arrays if a[1] == "kInt")
            first = self.rng.randrange(count)
            pointer = self.rng.choice([(f"&{name}[{first}]", name, 2 * first), (f"&R_i[{first}]", "R", 2 * first)])
            c, names = [pointer[0]] + c, [pointer[1], str(pointer[2])] + names
        return Expr(f"{function.name}({', '.join(c)})",
                    f"[&] {{ {steps}return {function.name}({', '.join(names)}); }}()", function.result)

    # ---- statements: (lines of C, lines of C++)

    def statement(self, depth, in_loop):
        makers = [self.assignment] * 6 + [self.compound_assignment] * 3 + [self.step] + [self.structure_copy] * self.chance(0.3)
        if depth > 0:
            makers += [self.if_statement] * 3 + [self.switch_statement] * 2 + [self.loop] * 2
        return self.rng.choice(makers)(depth, in_loop)

    def statements(self, count, depth, in_loop=False):
        c, cpp = [], []
        for _ in range(count):
            more = self.statement(depth, in_loop)
            c += more[0]
            cpp += more[1]
        return c, cpp

    def assignment(self, _depth, _in_loop):
        place, value = self.place(2), self.expression(3)
        return [f"{place.c} = {value.c};"], [f"Assign({value.cpp}, [&] {{ return {place.cpp}; }});"]

    def compound_assignment(self, _depth, _in_loop):
        place = self.place(2)
        names = {**ARITHMETIC} if place.type == "kDouble" else {**ARITHMETIC, **BITS, **DIVISION}
        op = self.rng.choice(list(names))
        value = self.variable(1) if op in DIVISION else self.whole(2)
        if op in DIVISION and value.type == "kDouble":
            op = "/"
        return ([f"{place.c} {op}= {value.c};"],
                [f"AssignOp({value.cpp}, Op::{names[op]}, [&] {{ return {place.cpp}; }});"])

    def structure_copy(self, _depth, _in_loop):
        i = self.rng.randrange(3)
        if self.chance(0.5):
            return [f"s = t[{i}];"], [f"Copy(s, 0, t, {10 * i}, 10);"]
        return [f"t[{i}] = s;"], [f"Copy(t, {10 * i}, s, 0, 10);"]

    def step(self, _depth, _in_loop):
        value = self.effect(1)
        return [f"{value.c};"], [f"{value.cpp};"]

    def if_statement(self, depth, in_loop):
        condition = self.expression(3)
        then_c, then_cpp = self.statements(self.rng.randint(1, 2), depth - 1, in_loop)
        if in_loop and self.chance(0.4):
            word = self.rng.choice(["break;", "continue;"])
            then_c, then_cpp = then_c + [word], then_cpp + [word]
        c, cpp = [f"if ({condition.c}) {{"] + then_c, [f"if ({condition.cpp}.Truth()) {{"] + then_cpp
        if self.chance(0.5):
            else_c, else_cpp = self.statements(1, depth - 1, in_loop)
            c, cpp = c + ["} else {"] + else_c, cpp + ["} else {"] + else_cpp
        return c + ["}"], cpp + ["}"]

    def switch_statement(self, depth, in_loop):
        """With and without break; a `continue` inside belongs to the loop around, so there is none here."""
        selector = self.whole(2)
        if self.chance(0.7):
            selector = self.binary(selector, "&", literal_int(7))
        low = -2 if promoted(selector.type) in ("kInt", "kLong") else 0
        labels = self.rng.sample(range(low, 8), self.rng.randint(2, 5)) + (["default"] if self.chance(0.7) else [])
        self.rng.shuffle(labels)
        c, cpp = [f"switch ({selector.c}) {{"], [f"switch (Promote({selector.cpp}).whole) {{"]
        for label in labels:
            text = "default:" if label == "default" else f"case {label}:"
            body = self.statements(self.rng.randint(1, 2), depth - 1, False)
            end = ["break;"] if self.chance(0.7) else []
            c, cpp = c + [text] + body[0] + end, cpp + [text, "{"] + body[1] + ["}"] + end
        return c + ["}"], cpp + ["}"]

    def loop(self, depth, _in_loop):
        kind = self.rng.choice(["kInt", "kUnsigned", "kUchar", "kLong"])
        name, rounds = self.fresh("i"), self.rng.randint(1, 6)
        declared = [f"uint8_t {name}_[4] = {{}};", f"const Object {name}{{{name}_, {SIZE[kind]}}};"]
        place = f"At({name}, Type::{kind}, 0)"
        where = f"[&] {{ return {place}; }}"
        body_c, body_cpp = self.statements(self.rng.randint(1, 3), depth - 1, True)
        shape = self.rng.choice(["for", "down", "while", "do"])
        set_c, set_cpp = f"{name} = {rounds};", f"Store({place}, Whole(Type::kInt, {rounds}));"
        if shape == "for":
            c = [f"for ({name} = 0; {name} < {rounds}; {name}++) {{"] + body_c + ["}"]
            test = f"Binary{{Read({place}), Op::kLt, Whole(Type::kInt, {rounds})}}().Truth()"
            cpp = [f"for (Store({place}, Whole(Type::kInt, 0)); {test}; After({where}, 1)) {{"] + body_cpp + ["}"]
        elif shape == "down":
            c = [f"for ({name} = {rounds}; {name} > 0; {name}--) {{"] + body_c + ["}"]
            test = f"Binary{{Read({place}), Op::kGt, Whole(Type::kInt, 0)}}().Truth()"
            cpp = [f"for ({set_cpp} {test}; After({where}, -1)) {{"] + body_cpp + ["}"]
        elif shape == "while":
            c = [set_c, f"while ({name}--) {{"] + body_c + ["}"]
            cpp = [set_cpp, f"while (After({where}, -1).Truth()) {{"] + body_cpp + ["}"]
        else:
            c = [set_c, "do {"] + body_c + [f"}} while (--{name});"]
            cpp = [set_cpp, "do {"] + body_cpp + [f"}} while (Before({where}, -1).Truth());"]
        return [f"{{ {SPELLING[kind]} {name};"] + c + ["}"], ["{"] + declared + cpp + ["}"]

    # ---- functions

    def local_variables(self):
        c, cpp = [], []
        for _ in range(self.rng.randint(0, 3)):
            kind = self.rng.choice(WHOLE)
            name = self.fresh("k")
            place = f"At({name}, Type::{kind}, 0)"
            value = self.expression(1)
            if self.chance(0.2):  # static: its start is a constant
                start = self.number(kind)
                self.objects.append((name, SIZE[kind]))
                self.initial.append(f"Store({place}, Whole(Type::{kind}, {start}LL));")
                c.append(f"static {SPELLING[kind]} {name} = {start};")
            else:
                c.append(f"{SPELLING[kind]} {name} = {value.c};")
                cpp += [f"uint8_t {name}_[8] = {{}};", f"const Object {name}{{{name}_, {SIZE[kind]}}};",
                        f"Store({place}, {value.cpp});"]
            self.locals.append(Place(name, place, kind))
        return c, cpp

    def function(self):
        name, result = self.fresh("f"), self.rng.choice(WHOLE)
        pointer = self.chance(0.4)
        parameters = [(self.fresh("p"), self.rng.choice(WHOLE)) for _ in range(self.rng.randint(0, 3))]
        self.locals = []
        cpp_head, cpp = [], []
        for parameter, kind in parameters:
            place = f"At({parameter}, Type::{kind}, 0)"
            cpp_head.append(f"Value {parameter}_value")
            cpp += [f"uint8_t {parameter}_[8] = {{}};", f"const Object {parameter}{{{parameter}_, {SIZE[kind]}}};",
                    f"Store({place}, {parameter}_value);"]
            self.locals.append(Place(parameter, place, kind))
        if pointer:
            cpp_head = ["Object q", "int64_t q_at"] + cpp_head
            for offset in range(2):
                self.locals.append(
                    Place(f"q[{offset}]", f"At(q, Type::kInt, q_at + {2 * offset})", "kInt", inside=False))
        sure = [p for p in self.locals if p.inside]
        unsure, self.locals = [p for p in self.locals if not p.inside], sure
        local_c, local_cpp = self.local_variables()
        body_c, body_cpp = self.statements(self.rng.randint(1, 3), 1)
        for place in unsure:
            value = self.expression(2)
            body_c.append(f"{place.c} = {value.c};")
            body_cpp.append(f"Assign({value.cpp}, [&] {{ return {place.cpp}; }});")
        if pointer:
            value = self.expression(1)
            body_c.append(f"*q++ += {value.c};")
            body_cpp.append(f"AssignOp({value.cpp}, Op::kAdd, "
                            "[&] { const Place p = At(q, Type::kInt, q_at); q_at += 2; return p; });")
        value = self.expression(2)
        heads = (["int *q"] if pointer else []) + [f"{SPELLING[k]} {p}" for p, k in parameters]
        old_style = self.chance(0.25)
        names = (["q"] if pointer else []) + [p for p, _ in parameters]
        head = ", ".join(names) if old_style else ", ".join(heads) or "void"
        self.c += [f"{SPELLING[result]} {name}({head})"] + [f"{h};" for h in heads if old_style]
        self.c += ["{"] + local_c + body_c + [f"return {value.c};", "}"]
        self.cpp += [f"Value {name}({', '.join(cpp_head)})", "{"] + cpp + local_cpp + body_cpp + \
                    [f"return Convert(Type::{result}, {value.cpp});", "}"]
        self.functions.append(Function(name, result, parameters, pointer, old_style))

    def part(self, name, count):
        self.locals = []
        local_c, local_cpp = self.local_variables()
        c, cpp = self.statements(count, 2)
        for function in self.functions:  # a pointer that nothing is assigned to would be refused
            if name == "plc2" and function.pointer and function.name not in self.called:
                value = self.call_of(function, 3)
                c.append(f"{value.c};")
                cpp.append(f"{value.cpp};")
        self.c += [f"void {name}()", "{"] + local_c + c + ["}"]
        self.cpp += [f"void {name}()", "{"] + local_cpp + cpp + ["}"]

    def program(self):
        self.c += ['#include "plc.h"']
        self.global_data()
        for _ in range(self.rng.randint(1, 3)):
            self.function()
        self.c += ["void init()", "{", "plc1_time = 16;", "plc2_time = 32;", "}"]
        self.part("plc1", self.rng.randint(5, 9))
        self.part("plc2", self.rng.randint(1, 3))
        return indented(self.c)

    def inputs(self):
        """For each cycle: values of X, P and F."""
        def values(count, kind):
            return [self.number(kind) for _ in range(count)]
        return [(values(INPUTS, "kUchar"), values(INPUTS, "kUnsigned"), values(INPUTS + 1, "kUnsigned"))
                for _ in range(CYCLES)]
