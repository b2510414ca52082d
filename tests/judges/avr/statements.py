"""Random statements, each as two lists of lines: for plcxx and for avr-gcc."""
import dataclasses

import spelled
from customs import Customs
from expressions import Expressions, Object
from pointing import Pointing
from shapes import Forms
from spelled import INTEGERS, NOTHING, SIZES, Spelled, Struct

MOST_ROUNDS = 1500
# again: { ...; if (i < n) goto again; }
GOTO_BODY_IN_BRACES = True


@dataclasses.dataclass
class Body:
    """What a function is being given."""
    kind: str
    hoisted: list = dataclasses.field(default_factory=list)  # avr-gcc's locals that plcxx starts with 0
    reads: frozenset = NOTHING
    writes: frozenset = NOTHING
    labels: int = 0
    rounds: int = 1


class Lines:
    def __init__(self, plc=(), avr=()):
        self.plc, self.avr = list(plc), list(avr)

    def __add__(self, other):
        return Lines(self.plc + other.plc, self.avr + other.avr)


def both(row):
    return Lines([row], [row])


def block(inner):
    return both("{") + inner + both("}")


class Statements(Expressions, Pointing, Forms, Customs):
    def __init__(self, seed, mark):
        super().__init__(seed)
        self.struct_functions = []
        self.function_locals = []
        self.mark, self.serial, self.body = mark, 0, None
        self.used_exits = set()
        self.exits = []  # labels behind the loops around
        self.loops = []  # around: for, loop, switch, switch for, goto; what break and continue may be written in

    def fresh(self, letter):
        self.serial += 1
        return f"{letter}{self.serial}_{self.mark}"

    def note(self, *expressions):
        for e in expressions:
            self.body.reads |= e.reads
            self.body.writes |= e.writes
        return expressions[0]

    def simple(self, e):
        self.note(e)
        return Lines([e.plc + ";"], [e.avr + ";"])

    def condition(self, depth=2):
        return self.note(self.integer(depth))

    # statements

    def statement(self, depth):
        if self.chance(14) and (made := self.special(depth)):
            return made
        pick = self.random.randrange(100)
        if depth <= 0 or pick < 42:
            return self.simple(self.assigned(self.shape.expression, sure=self.chance(60)))
        if pick < 46:
            return self.simple(self.stepped(2))
        if pick < 48:
            return self.expression_statement()
        if self.has_customs and self.chance(15):
            return self.custom(depth)
        if pick < 58:
            return self.chain(depth) if self.chance(15) else self.dangling() if self.chance(8) else self.conditional(depth)
        if pick < 66:
            return self.odd_selection(depth) if self.chance(25) else self.selection(depth)
        if pick < 82:
            if not self.chance(self.shape.loops):
                return self.simple(self.assigned(self.shape.expression))
            return self.odd_loop(depth) if self.chance(20) else self.loop(depth)
        if pick < 86:
            if self.exits and self.chance(50):
                return self.leave()
            return self.jump_between_arms(depth) if self.chance(25) else self.jump_forward(depth)
        if pick < 90:
            return self.once(depth) if self.chance(25) else self.inner_block(depth)
        if pick < 93:
            return self.floating()
        if pick < 95 and self.loops:
            word = "continue" if "for" in self.loops[-1] and self.chance(50) else "break"
            if self.loops[-1] == "goto":
                return both(";")
            test = self.condition(1)
            return Lines([f"if ({test.plc}) {word};"], [f"if ({test.avr}) {word};"])
        if pick < 96:
            return self.copied() if self.has_memory and self.chance(60) else self.whole_struct() or both(";")
        if pick < 98:
            usable = [f for f in self.functions if not f.writes & self.protected and f.rounds * self.rounds <= MOST_ROUNDS]
            if usable:
                function = self.random.choice(usable)
                self.body.rounds += function.rounds
                return self.simple(self.call_of(function, 2))
        if self.chance(30) and "goto" not in self.loops:
            return self.early_return()
        return self.walk()

    def special(self, depth):
        """What only some programs have; none: something else is to be made."""
        pick = self.random.randrange(12)
        if pick < 4 and self.has_reals:
            return self.real_statement(depth)
        if pick < 8 and self.has_pointers and depth > 0:
            return self.struct_elements() if self.chance(25) else self.text_pointing() if self.chance(15) else self.pointing(depth)
        if pick < 10 and self.has_control:
            return self.system_call(2)
        if pick < 11 and self.has_control and self.chance(40):
            return self.critical()
        if self.has_reals and depth > 0 and self.chance(50):
            test = self.real_condition(2)
            return Lines([f"if ({test.plc}) {{"], [f"if ({test.avr}) {{"]) + self.several(depth - 1, 3) + both("}")
        return None

    def expression_statement(self):
        """A value of which only the effects count: x && y++; c ? (a = 1) : (b = 2);"""
        for _ in range(10):
            value = self.integer(3)
            if value.writes - {"FAULT"}:
                return self.simple(value)
        return self.simple(self.stepped(2))

    def once(self, depth):
        """A loop whose first round is the last one."""
        head, tail = self.random.choice((("do {", "} while (0);"), ("for (;;) {", "break; }"), ("while (1) {", "break; }")))
        self.loops.append("loop")
        inner = self.several(depth - 1, 3)
        if self.chance(50):
            test = self.condition(1)
            inner += Lines([f"if ({test.plc}) break;"], [f"if ({test.avr}) break;"]) + self.several(depth - 1, 3)
        self.loops.pop()
        return both(head) + inner + both(tail)

    def several(self, depth, most=4):
        made = Lines()
        for _ in range(self.random.randrange(1, most)):
            made += self.statement(depth)
        return made

    def conditional(self, depth):
        test = self.condition()
        yes = self.several(depth - 1, min(3, self.shape.block))
        made = Lines([f"if ({test.plc}) {{"], [f"if ({test.avr}) {{"]) + yes + both("}")
        if self.chance(50):
            made += both("else {") + self.several(depth - 1, 3) + both("}")
        return made

    def selection(self, depth):
        selector = self.integer(2)
        if self.chance(60):
            selector = spelled.binary(self.random.choice("&%"), selector, spelled.literal(self.random.choice(("3", "7", "5"))))
        self.note(selector)
        values = self.random.sample((0, 1, 2, 3, 4, 5, 6, 7, -1, -2, 10, 255, "'a'", "0x10"), self.random.randrange(1, 6))
        groups = [f"case {v}:" for v in values]
        if self.chance(70):
            groups.insert(self.random.randrange(len(groups) + 1), "default:")
        made = Lines([f"switch ({selector.plc}) {{"], [f"switch ({selector.avr}) {{"])
        self.loops.append("switch for" if self.loops and "for" in self.loops[-1] else "switch")
        for group in groups:
            made += both(group)
            if self.chance(80):
                made += self.several(depth - 1, 3)
                if self.chance(65):
                    made += both("break;")
        self.loops.pop()
        if made.plc[-1].endswith(":"):
            made += both(";")
        return made + both("}")

    def counter(self, integer_kinds=("int", "unsigned", "unsigned char", "char", "long", "unsigned long")):
        """A counter that nothing else changes: a new local, or a global that is protected."""
        if self.chance(25):
            usable = [o for o in self.objects if not (o.count or o.pointer or o.constant or o.plc) and o.kind in integer_kinds
                      and o.name not in self.protected]
            if usable:
                found = self.random.choice(usable)
                self.body.writes |= {found.name}
                return found, Lines()
        made = Object(self.fresh("i"), self.random.choice(integer_kinds))
        return made, self.local(made)

    def local(self, item):
        """A declaration without initialiser: such variables are 0 when the function is entered."""
        text = spelled.declared(item.kind, item.name, item.count)
        self.body.hoisted.append(f"{text} = {{0}};" if item.count or isinstance(item.kind, Struct) else f"{text} = 0;")
        word = "" if item.count or isinstance(item.kind, Struct) or self.chance(85) else self.random.choice(("register ", "auto ", "volatile "))
        item.is_volatile = word in ("register ", "volatile ")  # has no address that a pointer takes
        return Lines([word + text.replace(item.name, item.plc or item.name) + ";"])

    def filled(self, item):
        """A structure with an initialiser, which gives a part of it; the rest is 0, each time."""
        parts = len(spelled.leaves(item.name, item.kind, item.count))
        values = ", ".join(str(self.random.randrange(-3, 100)) for _ in range(self.random.randrange(1, parts + 1)))
        declared = spelled.declared(item.kind, item.name, item.count)
        self.body.hoisted.append(f"{declared} = {{0}};")
        filled = spelled.declared(item.kind, "filled", item.count)
        return Lines([f"{declared} = {{{values}}};"],
                     [f"{{ {filled} = {{{values}}}; __builtin_memcpy(&{item.name}, &filled, sizeof filled); }}"])

    def changed(self, item):
        """What is not given is changed, and seen: it is 0 the next time, too."""
        if self.sink in self.protected:
            return Lines()
        self.note(Spelled("", "", writes=frozenset({self.sink}), reads=frozenset({self.sink})))
        return both(f"{self.sink} += ++{spelled.leaves(item.name, item.kind, item.count)[-1][0]};")

    def loop(self, depth):
        counter, declaration = self.counter()
        name = counter.name
        limit, limit_rows = self.limit()
        most, text, avr = limit
        if self.rounds * most > MOST_ROUNDS:
            return both(";")
        step = self.random.choice((1, 1, 1, 2, 3))
        form = self.random.choice(("up", "up", "up", "down", "while", "do", "countdown", "plain", "noted", "goto"))
        start = self.random.randrange(3)
        self.protected.add(name)
        self.rounds *= most + 1
        self.body.rounds = max(self.body.rounds, self.rounds)
        self.loops.append("for" if form in ("up", "down", "countdown") else "goto" if form == "goto" else "loop")
        label_behind = self.fresh("out")
        self.exits.append(label_behind)
        self.objects.append(counter) if declaration.plc else None
        if form != "noted":  # which counts nothing
            self.counting.append((counter, most + 1))
        body = self.several(depth - 1, self.shape.block)
        if form != "noted":
            self.counting.pop()
        self.loops.pop()
        self.exits.pop()
        self.rounds //= most + 1
        behind = both(f"{label_behind}:") + self.simple(self.stepped(1)) if label_behind in self.used_exits else Lines()
        further = self.further_test() if form in ("up", "down", "while") else ("", "")
        add = f"{name}++" if step == 1 else self.random.choice((f"{name} += {step}", f"{name} = {name} + {step}"))
        relation = self.random.choice(("<", "<="))
        before, head, tail = Lines(), None, both("}")
        if form == "up":
            head = (f"for ({name} = {start}; {name} {relation} {{}}; {add}) {{{{", text + further[0], avr + further[1])
            if self.chance(25):  # the parts of the head elsewhere
                before, head = both(f"{name} = {start};"), (f"for (; {name} {relation} {{}}; {add}) {{{{", *head[1:])
            elif self.chance(25):
                second = Object(self.fresh("j"), self.random.choice(("int", "long", "unsigned char")))
                self.function_locals.append(f"{second.kind} {second.name};")
                self.body.hoisted.append(f"{second.kind} {second.name} = 0;")
                head = (f"for ({name} = {start}, {second.name} = {most}; {name} {relation} {{}}; {add}, {second.name}--) {{{{", *head[1:])
                place = self.lvalue(1, True)
                self.note(dataclasses.replace(place, writes=place.writes | place.target))
                body = Lines([f"{place.plc} = {second.name};"], [f"{place.avr} = {second.name};"]) + body
        elif form == "down":
            head = (f"for ({name} = {most}; {name} {self.random.choice(('>', '!='))} 0{{}}; {name}--) {{{{", *further)
        elif form == "while":
            before, head = both(f"{name} = {start};"), (f"while ({name} < {{}}) {{{{", text + further[0], avr + further[1])
            tail = self.changed_once(add) + tail
        elif form == "do":
            before, tail = both(f"{name} = {most + 1};"), both(f"{name} -= 1;") + both(f"}} while ({name} > 0);")
            head = ("do {{", "", "")
        elif form == "countdown":
            before, head = both(f"{name} = {most};"), (f"while ({self.random.choice((f'{name}--', f'--{name} > 0'))}) {{{{", "", "")
        elif form == "plain":
            before, head = both(f"{name} = {most};"), (f"while ({name}) {{{{", "", "")
            tail = both(self.random.choice((f"{name}--;", f"{name} -= 1;"))) + tail
        elif form == "noted":
            test = self.real_condition(2) if self.has_reals and self.chance(40) else self.condition()
            bound = self.random.randrange(1, 6)
            guard = self.fresh("n")
            self.body.hoisted.append(f"int {guard} = 0;")
            made = Lines([f"//@loop_bound {bound}", f"while ({test.plc}) {{"],
                         [f"{guard} = 0;", f"while (({test.avr}) && ({guard}++ < {bound} || (fault(3), 0))) {{"])
            self.body.writes |= {"FAULT"}
            result = made + body + both("}")
            self.protected -= {name}
            return self.wrapped(declaration, limit_rows + result + behind, counter)
        else:
            label = self.fresh("again")
            before = both(f"{name} = {start};")
            if self.chance(25):  # the label is reached from above, too
                test = self.condition(1)
                before += Lines([f"if ({test.plc}) goto {label};"], [f"if ({test.avr}) goto {label};"]) + both(f"{name} = {2 - start};")
            before, head = before + both(f"{label}:"), ("{{", "", "") if GOTO_BODY_IN_BRACES else ("", "", "")
            tail = both(add + ";") + Lines([f"if ({name} < {text}) goto {label};"], [f"if ({name} < {avr}) goto {label};"]) + (tail if GOTO_BODY_IN_BRACES else Lines())
        made = before + Lines([head[0].format(head[1])], [head[0].format(head[2])]) + body + tail
        self.protected -= {name}
        return self.wrapped(declaration, limit_rows + made + behind, counter)

    def changed_once(self, add):
        """At the end of a round, in one place or in each arm of an if."""
        if self.chance(80):
            return both(f"{add};")
        test = self.condition(1)
        last = self.random.choice((f"}} {add};", f"}} else {{ {add}; }}"))
        middle = f"{add}; continue; " if last.startswith("} " + add) else f"{add}; "
        return Lines([f"if ({test.plc}) {{ {middle}{last}"], [f"if ({test.avr}) {{ {middle}{last}"])

    def further_test(self):
        if self.chance(80):
            return "", ""
        test = self.condition(1).at(5)
        return f" && {test.plc}", f" && {test.avr}"

    def wrapped(self, declaration, made, counter):
        if declaration.plc:
            self.objects.remove(counter)
            return block(declaration + made)
        return made

    def limit(self):
        """(most, spelling, avr's spelling) and what is to precede."""
        most = self.random.randrange(2, 11)
        if self.chance(55):
            return (most + 1, str(most), str(most)), Lines()
        mask = self.random.choice((3, 7, 15))
        item = Object(self.fresh("m"), self.random.choice(("int", "unsigned", "unsigned char")))
        value = spelled.binary("&", self.note(self.integer(1)), spelled.literal(str(mask)))
        self.body.hoisted.append(f"{item.kind} {item.name} = 0;")
        rows = Lines([f"{item.name} = {value.plc};"], [f"{item.name} = {value.avr};"])
        self.function_locals.append(f"{item.kind} {item.name};")
        return (mask + 1, item.name, item.name), rows

    def leave(self):
        """goto out of the loops around."""
        label = self.random.choice(self.exits)
        self.used_exits.add(label)
        test = self.condition(1)
        return Lines([f"if ({test.plc}) goto {label};"], [f"if ({test.avr}) goto {label};"])

    def jump_forward(self, depth):
        label = self.fresh("skip")
        test = self.condition()
        made = Lines([f"if ({test.plc}) goto {label};"], [f"if ({test.avr}) goto {label};"])
        return made + self.several(depth - 1, 3) + both(f"{label}:") + self.simple(self.stepped(1))

    def jump_between_arms(self, depth):
        """goto from one arm of an if to a label in another one."""
        label = self.fresh("arm")
        first, second, leaves = self.condition(), self.condition(1), self.condition(1)
        made = Lines([f"if ({first.plc}) {{"], [f"if ({first.avr}) {{"]) + self.several(depth - 1, 2)
        made += Lines([f"if ({leaves.plc}) goto {label};"], [f"if ({leaves.avr}) goto {label};"])
        made += Lines([f"}} else if ({second.plc}) {{"], [f"}} else if ({second.avr}) {{"]) if self.chance(50) else both("} else {")
        made += self.several(depth - 1, 2) + both(f"{label}:") + self.simple(self.stepped(1))
        return made + self.several(depth - 1, 2) + both("}")

    def inner_block(self, depth):
        """Locals: with an initialiser each time, without it 0 once."""
        items, rows, changes = [], Lines(), Lines()
        hidden, macros = None, self.macros
        if self.chance(12):
            hidden = self.hide()
            if hidden:
                rows += self.local(hidden[1])
        for _ in range(self.random.randrange(1, 3)):
            item = Object(self.fresh("v"), self.random.choice(INTEGERS), self.random.choice((0, 0, 0, 3, 5)))
            aggregates = [struct for struct in self.structs if struct.word == "struct"]
            if aggregates and self.chance(50):
                item.kind = self.random.choice(aggregates)
                item.count = self.random.choice((0, 0, 2))
                rows += self.filled(item)
                changes += self.changed(item)
            elif item.count or self.chance(40):
                rows += self.local(item)
            else:
                value = self.note(self.integer(2))
                rows.plc.append(f"{item.kind} {item.name} = {value.at(2).plc};")
                self.body.hoisted.append(f"{item.kind} {item.name};")
                rows.avr.append(f"{item.name} = {value.at(2).avr};")
            items.append(item)
        self.objects += items
        inner = self.several(depth - 1, 4)
        for item in items:
            self.objects.remove(item)
        if hidden:
            self.objects.remove(hidden[1])
            self.objects.append(hidden[0])
        self.macros = macros
        return block(rows + changes + inner)

    def hide(self):
        """A local with the name of a global variable; a macro would mean the local."""
        usable = [o for o in self.objects if o.name.startswith("g") and not (o.count or o.pointer or o.constant or o.plc)
                  and o.kind in INTEGERS and o.name not in self.protected
                  and not any(other.name == o.name and other.plc for other in self.objects)]  # spelled by a macro, too
        if not usable:
            return None
        outer = self.random.choice(usable)
        inner = Object(self.fresh("v"), self.random.choice(INTEGERS), plc=outer.name)
        self.objects.remove(outer)
        self.objects.append(inner)
        self.macros = []
        return outer, inner

    def floating(self):
        """One operation a statement: rounding once is what plcxx' double and AVR's float have in common."""
        floats = [o for o in self.objects if o.name in self.unions]
        if not floats:
            return both(";")
        target, other = (self.random.choice(floats).spelled() for _ in range(2))
        t, o = f"{target.plc}.f", f"{other.plc}.f"
        if target.target & self.protected:
            return both(";")
        self.note(Spelled("", "", writes=target.target, reads=other.reads | target.reads))
        pick = self.random.randrange(6)
        if pick == 0:
            value = self.note(self.integer(2))
            return Lines([f"{t} = {value.at(2).plc};"], [f"{t} = {value.at(2).avr};"])
        if pick == 1:
            return both(f"{t} = {o} {self.random.choice('+-*')} {self.random.choice(floats).name}.f;") + self.tamed(t)
        if pick == 2:
            return both(f"{t} {self.random.choice(('+=', '-=', '*=', '/='))} {self.random.choice(('0.5f', '3.0f', '1.25f', '7'))};") + self.tamed(t)
        place = self.lvalue(1, True)
        self.note(dataclasses.replace(place, writes=place.writes | place.target))
        if pick == 3:
            test = f"{t} {self.random.choice(('<', '<=', '>', '>=', '==', '!='))} {self.random.choice((o, '0.5f', '3'))}"
            return Lines([f"{place.plc} = {test};"], [f"{place.avr} = {test};"])
        if pick == 4:
            guard = f"if ({o} > -30000.0f && {o} < 30000.0f) "
            return Lines([f"{guard}{place.plc} = (int) {o};"], [f"{guard}{place.avr} = (int) {o};"])
        return both(f"{t} = -{o};")

    def tamed(self, t):
        return both(f"if ({t} > 1e6f || {t} < -1e6f || {t} > -1e-6f && {t} < 1e-6f) {t} = 1.5f;")

    def whole_struct(self):
        usable = [o for o in self.objects if isinstance(o.kind, Struct) and not o.count and not o.pointer]
        pairs = [(a, b) for a in usable for b in usable if a.kind is b.kind and a is not b and a.name not in self.protected
                 and not a.constant]
        if not pairs:
            return None
        one, other = self.random.choice(pairs)
        self.note(Spelled("", "", writes=frozenset({one.name})))
        plc, avr = self.struct_value(one.kind, [o for o in usable if o.kind is one.kind], 2)
        if self.chance(15) and other.name not in self.protected and not other.constant:
            self.note(Spelled("", "", writes=frozenset({other.name})))
            return Lines([f"{one.name} = {other.name} = {plc};"], [f"{one.name} = {other.name} = {avr};"])
        if self.chance(15):
            step = self.stepped(1)
            if not step.writes & {o.name for o in usable}:
                self.note(step)
                return Lines([f"{one.name} = ({step.plc}, {plc});"], [f"{one.name} = ({step.avr}, {avr});"])
        return Lines([f"{one.name} = {plc};"], [f"{one.name} = {avr};"])

    def struct_value(self, kind, usable, depth):
        """In both spellings: an object, what a function makes of one or two, one that a condition chooses."""
        makers = [(name, values) for name, made, values in self.struct_functions if made is kind]
        pick = self.random.randrange(10) if depth > 0 else 9
        was, self.pure = self.pure, True
        number = self.note(self.integer(1))
        self.pure = was
        if pick < 5 and makers:
            name, values = self.random.choice(makers)
            plc, avr = self.struct_value(kind, usable, depth - 1)
            first = (number.at(2).plc, number.at(2).avr) if values == 1 else self.struct_value(kind, usable, depth - 1)
            return f"{name}({first[0]}, {plc})", f"{name}({first[1]}, {avr})"
        if pick < 8:
            (yes, avr_yes), (no, avr_no) = (self.struct_value(kind, usable, depth - 1) for _ in range(2))
            return f"({number.at(4).plc} ? {yes} : {no})", f"({number.at(4).avr} ? {avr_yes} : {avr_no})"
        item = self.random.choice(usable)
        self.note(Spelled("", "", reads=frozenset({item.name})))
        return item.name, item.name

    def copied(self):
        """memset, memcpy and memmove: within one object, or from one into another."""
        usable = [o for o in self.objects if o.count >= 2 and not (o.second or o.pointer or o.constant or o.plc)
                  and not isinstance(o.kind, Struct) and o.kind in INTEGERS and o.name not in self.protected]
        if not usable or "R" in self.protected:
            return both(";")
        item = self.random.choice(usable)
        size = self.random.randrange(0, SIZES[item.kind] * item.count + 1)
        at = self.random.randrange(0, 16)
        register = (f"&R[{at}]", f"&R.uc[{at}]")
        own = (item.name, item.name)
        self.note(Spelled("", "", reads=frozenset({item.name, "R"}), writes=frozenset({item.name, "R"})))
        to, source = self.random.choice(((own, register), (register, own)))
        if self.chance(40):
            value = self.note(self.integer(1)).at(2)
            return Lines([f"memset({to[0]}, {value.plc}, {size});"], [f"memset((void *)({to[1]}), {value.avr}, {size});"])
        if self.chance(20):
            relation = self.random.choice(("== 0", "> 0", "< 0", "!= 0"))
            return Lines([f"{self.sink} = memcmp({to[0]}, {source[0]}, {size}) {relation};"],
                         [f"{self.sink} = memcmp((void *)({to[1]}), (void *)({source[1]}), {size}) {relation};"])
        word = self.random.choice(("memcpy", "memmove"))
        return Lines([f"{word}({to[0]}, {source[0]}, {size});"], [f"{word}((void *)({to[1]}), (void *)({source[1]}), {size});"])

    def early_return(self):
        test = self.condition(1)
        value = self.note(self.integer(1)).at(2) if self.body.kind != "void" else Spelled("", "")
        if not self.body.kind == "void" and self.chance(15):
            return Lines([f"if ({test.plc}) return;"], [f"if ({test.avr}) return 0;"])
        return Lines([f"if ({test.plc}) return {value.plc};"], [f"if ({test.avr}) return {value.avr};"])

    def walk(self):
        """A pointer over an array or over registers."""
        kind = self.random.choice(("unsigned char", "int", "unsigned", "long"))
        arrays = [o for o in self.objects if o.count >= 2 and not o.second and o.kind == kind and not o.pointer and not o.constant
                  and o.name not in self.protected]
        name, i = self.fresh("p"), self.fresh("k")
        size = self.random.randrange(2, 5)
        if arrays and self.chance(60):
            item = self.random.choice(arrays)
            size = min(size, item.count)
            plc = avr = self.random.choice((item.name, f"&{item.name}[0]"))
            target = item.name
        else:
            if "R" in self.protected:
                return both(";")
            at = self.random.randrange(20)
            plc, avr, target = f"({kind} *) &R[{at}]", f"({kind} *) &R.uc[{at}]", "R"
        if self.rounds * size > MOST_ROUNDS:
            return both(";")
        value = self.integer(1)
        self.note(value, Spelled("", "", reads=frozenset({target}), writes=frozenset({target})))
        self.function_locals.append(f"{kind} *{name}; unsigned char {i};")
        self.body.hoisted.append(f"{kind} *{name} = 0; unsigned char {i} = 0;")
        if value.writes & {target} or target in value.reads:
            value = spelled.literal("5")
        body = self.random.choice(("*{p}++ {op} {v};", "{p}[0] {op} {v}; {p} = {p} + 1;", "*{p} {op} {v}; ++{p};", "*{p} {op} {v}; {p} += 1;",
                                   "*++{p} {op} {v}; {p}[0] ^= 1;", "{p}++; {p}[-1] {op} {v};"))
        if body.startswith("*++"):
            size -= 1  # begins with the second element
        operator = self.random.choice(("=", "+=", "^=", "-="))
        make = lambda v: body.format(p=name, op=operator, v=v)
        rows = Lines([f"{name} = {plc};"], [f"{name} = {avr};"])
        rows += both(f"for ({i} = 0; {i} < {size}; {i}++) {{")
        rows = rows + Lines([make(value.at(2).plc)], [make(value.at(2).avr)]) + both("}")
        if self.chance(50):
            place = self.lvalue(1, True)
            self.note(dataclasses.replace(place, writes=place.writes | place.target))
            form = self.random.choice(("{p} - {b}", "{p} == {b} + 2", "{p} > {b}", "{b} + 1 - {p}"))
            rows += Lines([f"{place.plc} = {form.format(p=name, b=plc)};"], [f"{place.avr} = {form.format(p=name, b=avr)};"])
        return rows
