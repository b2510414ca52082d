"""What those write who write for these controls: macros that store, tables and arrays walked by their counters, pointers to
members, states in a register, records handed over by their address."""
import dataclasses

import spelled
from spelled import INTEGERS, Spelled, Struct

# Macros that store to an argument or to registers: parameters, text, and where it differs the text for avr-gcc (see ARM of judge.h).
STORING = {
    "next": ("v", "((v)++)", None),
    "swap": ("t,a,b", "{ t t_; t_ = a; a = b; b = t_; }", None),
    "clamp": ("v,low,high", "if ((v) < (low)) (v) = (low); else if ((v) > (high)) (v) = (high)", None),
    "set": ("g,b", "R[g] |= (1 << (b))", "R.uc[g] |= (1 << (b))"),
    "reset": ("g,b", "R[g] &= ~(1 << (b))", "R.uc[g] &= ~(1 << (b))"),
    "out": ("g,b,on", "if (on) Y[g] |= 1 << (b); else Y[g] &= ~(1 << (b))", "if (on) Y.uc[g] |= 1 << (b); else Y.uc[g] &= ~(1 << (b))"),
    "timer": ("t,limit,on", "((on) ? (t) < (limit) ? ++(t) : (t) : ((t) = 0))", "((on) ? (t) < (limit) ? ARM(++(t)) : ARM(t) : ARM((t) = 0))"),
    "edge": ("now,last", "((now) && !(last) ? ((last) = 1) : ((last) = (now) != 0, 0))", "((now) && !(last) ? ARM((last) = 1) : ((last) = (now) != 0, 0))"),
    "once": ("c,s", "do { if (c) { s } } while (0)", None),
    "most": ("a,b", "((a) > (b) ? (a) : (b))", "((a) > (b) ? ARM(a) : ARM(b))"),
}


class Customs:
    def custom_macros(self):
        """The names of those that this program has."""
        from statements import Lines
        for word in self.random.sample(list(STORING), self.random.randrange(2, len(STORING))):
            parameters, plc, avr = STORING[word]
            name = self.fresh("N")
            self.defined.append(name)
            self.text += Lines([f"#define {name}({parameters}) {plc}"], [f"#define {name}({parameters}) {avr or plc}"])
            self.storing[word] = name

    def custom_functions_made(self):
        """Tables of rows and records, by their address."""
        from statements import Lines
        made = Lines()
        for item in self.tables_of_rows():
            if self.chance(40) or any(key == (item.kind, item.second) for key in self.row_functions):
                continue
            name = self.fresh("w")
            word = "const " if item.constant else ""
            parameter = self.random.choice((f"{word}{item.kind} t[][{item.second}]", f"{word}{item.kind} (*t)[{item.second}]", f"{word}{item.kind} t[{item.count}][{item.second}]"))
            rows = ["int j; long sum; sum = 0;", f"for (j = 0; j < {item.second}; j++) sum = sum * 3 + {self.random.choice(('t[n][j]', '(*(t + n))[j]', '*(t[n] + j)'))};", "return sum;"]
            head = f"long {name}({parameter}, int n)"
            made += Lines([head, "{", *rows, "}"], ["static " + head, "{", *rows, "}"])
            self.row_functions[item.kind, item.second] = (name, item)
        return made

    def tables_of_rows(self):
        return [o for o in self.objects if o.second and o.kind in INTEGERS and o.name.startswith("g") and not o.plc]

    # statements

    def custom(self, depth):
        forms = [self.stored_by_macro] * 5 + [self.walked] * 4 + [self.rows_walked, self.states, self.member_pointed, self.member_pointed,
                                                                  self.records_walked, self.records_walked, self.searched, self.digits]
        return self.random.choice(forms)(depth)

    def plain_place(self, apart=(), sizes=(1, 2, 4)):
        """An integer that can be named twice: nothing is stored by naming it, and it has an address."""
        for _ in range(12):
            place = self.lvalue(1, True)
            if not (place.writes or place.field or place.faulty or spelled.SIZES[place.kind] not in sizes
                    or any(place.target & other.target or place.reads & other.target or other.reads & place.target for other in apart)):
                break
        else:
            place = Spelled(self.sink, self.sink, reads=frozenset({self.sink}), target=frozenset({self.sink}))
        self.note(dataclasses.replace(place, writes=place.target))
        return place

    def apart(self, *places):
        """An expression that stores nothing and does not read the places."""
        was, self.pure = self.pure, True
        value = self.integer(1)
        self.pure = was
        if value.writes or any(value.reads & place.target for place in places):
            value = self.constant()
        return self.note(value).at(2)

    def stored_by_macro(self, depth):
        from statements import Lines, both
        if not self.storing:
            return both(";")
        word, name = self.random.choice(list(self.storing.items()))
        call = lambda *arguments: (f"{name}({', '.join(a.plc for a in arguments)})", f"{name}({', '.join(a.avr for a in arguments)})")
        number = lambda most: spelled.literal(str(self.random.randrange(most)))
        statement = lambda texts: Lines([texts[0] + ";"], [texts[1] + ";"])
        if word in ("set", "reset", "out"):
            area = "Y" if word == "out" else "R"
            if area in self.protected:
                return both(";")
            self.note(Spelled("", "", reads=frozenset({area}), writes=frozenset({area})))
            bit = self.random.choice((number(8), spelled.binary("&", self.apart(), spelled.literal("7"))))
            rest = [self.apart()] if word == "out" else []
            return statement(call(number(16), bit, *rest))
        place = self.plain_place()
        if word == "swap":
            other = self.plain_place((place,))
            if place.plc == other.plc:
                return both(";")
            kind = spelled.literal(self.random.choice((place.kind, "long", "int")))
            texts = call(kind, place, other)
            return Lines([texts[0]], [texts[1]])
        if word == "clamp":
            low = self.random.randrange(-20, 100)
            texts = call(place, spelled.literal(str(low)), spelled.literal(str(low + self.random.randrange(200))))
            return both("{") + statement(texts) + both("}")
        if word == "once":
            test, value = self.apart(place), self.apart(place)
            operator = self.random.choice(("=", "+=", "-=", "^=", "*="))
            return Lines([f"{name}({test.plc}, {place.plc} {operator} {value.at(spelled.POSTFIX).plc};);"],
                         [f"{name}({test.avr}, {place.avr} {operator} {value.at(spelled.POSTFIX).avr};);"])
        if word == "timer":
            texts = call(place, spelled.literal(str(self.random.choice((3, 20, 100, 200)))), self.apart(place))
        elif word == "edge":
            texts = call(self.apart(place), place)
        elif word == "most":
            step = self.random.choice((lambda p: spelled.step("++", p, False), lambda p: spelled.step("--", p, True)))(place)
            arguments = [step, self.apart(place)]
            self.random.shuffle(arguments)
            texts = call(*arguments)
        else:
            texts = call(place)
        if self.chance(40):
            return statement(texts)
        to = self.plain_place((place,))
        if to.plc == place.plc:
            return statement(texts)
        operator = self.random.choice(("=", "+=", "|=", "^="))
        return Lines([f"{to.plc} {operator} {texts[0]};"], [f"{to.avr} {operator} {texts[1]};"])

    def own_counter(self, kinds=("int", "int", "unsigned", "unsigned char", "char")):
        from expressions import Object
        item = Object(self.fresh("i"), self.random.choice(kinds))
        return item, self.local(item)

    def indexed_arrays(self, writable=False):
        return [o for o in self.objects if o.count >= 3 and o.kind in INTEGERS and not (o.second or o.pointer or o.plc)
                and not (writable and (o.constant or o.name in self.protected))]

    def walked(self, depth):
        """for (i = 0; i < n; i++) a[i] = b[n - i] + i; with indices that may leave their array at its ends."""
        from statements import Lines, MOST_ROUNDS, block, both
        to, source = self.indexed_arrays(True), self.indexed_arrays()
        if not source or self.rounds * 9 > MOST_ROUNDS:
            return both(";")
        one = self.random.choice(source)
        other = self.random.choice(to) if to and self.chance(70) else None
        counter, declaration = self.own_counter()
        i, n = counter.name, self.random.choice((one.count, one.count - 1, one.count + 1, min(one.count, other.count) if other else 2))
        n = min(n, 9)
        head = self.random.choice((f"for ({i} = 0; {i} < {n}; {i}++) {{", f"for ({i} = {n}; {i} > 0; {i}--) {{", f"for ({i} = 1; {i} <= {n}; {i} += 1) {{",
                                   f"for ({i} = {n - 1}; {i} != 0; --{i}) {{"))
        index = lambda: self.random.choice(("{i}", "{i}", "{i}", "{i} + 1", "{i} - 1", "{n} - {i}", "{n} - 1 - {i}", "{i} * 2", "{i} / 2", "({i} + 1) % {n}", "{i} & 3",
                                            "{i} ^ 1", "{i} > 2 ? 2 : {i}")).format(i=i, n=n)
        self.note(Spelled("", "", reads=frozenset({one.name} | ({other.name} if other else set())), writes=frozenset({other.name} if other else set()) | spelled.FAULT))
        at = lambda item: (lambda text: (f"{item.name}[{text}]", f"AT({item.name}, {text})"))(index())
        read, again = at(one), at(one)
        rows = Lines()
        form = self.random.randrange(5 if other else 2)
        if form < 2:
            total = self.plain_place()
            if total.target & {one.name} or total.reads & {one.name} or other and total.target & {other.name}:
                total = Spelled(self.sink, self.sink, target=frozenset({self.sink}))
            operator = self.random.choice(("+=", "^=", "-=", "|="))
            text = self.random.choice(("{0}", "{0} * {i}", "{0} - {1}", "({0} > {1})", "({0} & 1) << ({i} & 7)"))
            rows += Lines([f"{total.plc} {operator} {text.format(read[0], again[0], i=i)};"], [f"{total.avr} {operator} {text.format(read[1], again[1], i=i)};"])
        elif form < 4:
            stored, operator = at(other), self.random.choice(("=", "=", "+=", "^="))
            text = self.random.choice(("{0}", "{0} + {i}", "{0} >> 1", "{i}", "{0} < 0 ? ARM(-{0}) : ARM({0})"))
            plc = text.replace("ARM", "").format(read[0], i=i)
            rows += Lines([f"{stored[0]} {operator} {plc};"], [f"{{ long right_ = {text.format(read[1], i=i)}; {stored[1]} {operator} right_; }}"])
        else:
            first, second = at(other), at(other)
            rows += Lines([f"if ({first[0]} > {second[0]}) {{", f"{other.kind} t; t = {first[0]}; {first[0]} = {second[0]}; {second[0]} = t; }}"],
                          [f"{{ __auto_type a_ = {first[1]} + 0; __auto_type b_ = {second[1]} + 0; if (a_ > b_) {{", f"{other.kind} t; t = {first[1]}; b_ = {second[1]}; {first[1]} = b_; {second[1]} = t; }} }}"])
        self.protected.add(i)
        self.rounds *= n + 1
        self.body.rounds = max(self.body.rounds, self.rounds)
        if depth > 1 and self.chance(40):
            self.objects.append(counter)
            self.counting.append((counter, n + 1))
            self.loops.append("for")
            rows += self.several(depth - 2, 2)
            self.loops.pop()
            self.counting.pop()
            self.objects.remove(counter)
        self.rounds //= n + 1
        self.protected.remove(i)
        return block(declaration + both(head) + rows + both("}"))

    def rows_walked(self, depth):
        """for i for j: t[i][j], over the rows of a table; or a function that is given the table."""
        from statements import Lines, MOST_ROUNDS, block, both
        tables = self.tables_of_rows() + [o for o in self.objects if o.second and o.name.startswith("t")]
        if not tables:
            return both(";")
        item = self.random.choice(tables)
        found = self.row_functions.get((item.kind, item.second))
        place = self.plain_place()
        if found and (found[1].constant or not item.constant) and item.name.startswith("g") and self.chance(50):
            self.note(Spelled("", "", reads=frozenset({item.name})))
            index = spelled.binary("%", self.apart(place), spelled.literal(str(item.count)))
            index = spelled.literal(str(self.random.randrange(item.count))) if self.chance(70) or index.kind != "int" else spelled.binary("&", index, spelled.literal("1" if item.count > 1 else "0"))
            return Lines([f"{place.plc} = {found[0]}({item.name}, {index.plc});"], [f"{place.avr} = {found[0]}({item.name}, {index.avr});"])
        if self.rounds * (item.count * item.second + 2) > MOST_ROUNDS or place.target & {item.name}:
            return both(";")
        one, declaration = self.own_counter()
        two, other = self.own_counter()
        i, j = one.name, two.name
        self.note(Spelled("", "", reads=frozenset({item.name}), writes=frozenset() if item.constant else frozenset({item.name})))
        self.body.rounds = max(self.body.rounds, self.rounds * item.count * item.second)
        inner = f"{item.name}[{i}][{j}]"
        operator = self.random.choice(("+=", "^=", "-="))
        rows = Lines([f"{place.plc} {operator} {inner};"], [f"{place.avr} {operator} {inner};"])
        if not item.constant and item.name not in self.protected and self.chance(60):
            rows += both(self.random.choice((f"{inner} = {i} * {j};", f"{inner}++;", f"if ({i} == {j}) {inner} = 1;", f"*(*({item.name} + {i}) + {j}) -= {j};",
                                             f"{item.name}[{i}][{item.second - 1} - {j}] = {inner};")))
        heads = both(f"for ({i} = 0; {i} < {item.count}; {i}++)" + self.random.choice(("", " {")))
        closing = both("}") if heads.plc[0].endswith("{") else Lines()
        return block(declaration + other + heads + both(f"for ({j} = {item.second - 1}; {j} >= 0; {j}--) {{" if two.kind in ("int", "char") and not self.options.get("char")
                                                        else f"for ({j} = 0; {j} < {item.second}; ++{j}) {{") + rows + both("}") + closing)

    def states(self, depth):
        """switch (state) { case 0: if (...) state = 1; break; ... } of a register or a variable."""
        from statements import Lines, both
        place = self.plain_place().at(spelled.POSTFIX)
        count = self.random.randrange(2, 6)
        made = Lines([f"switch ({place.plc}) {{"], [f"switch ({place.avr}) {{"])
        self.loops.append("switch for" if self.loops and "for" in self.loops[-1] else "switch")
        for state in range(count):
            test = self.apart(place)
            forward = self.random.choice((f"= {(state + 1) % count}", f"= {(state + 2) % count}", "+= 1", "++", "= 0"))
            made += both(f"case {state}:")
            stored = Lines([f"{place.plc} {forward};"], [f"{place.avr} {forward};"])
            made += Lines([f"if ({test.plc})"], [f"if ({test.avr})"]) + stored if self.chance(70) else stored
            if depth > 1 and self.chance(30):
                made += self.several(depth - 2, 2)
            made += both(self.random.choice(("break;", "break;", "/* falls through */")))
        start = self.random.randrange(count)
        made += Lines([f"default: {place.plc} = {start};", "}"], [f"default: {place.avr} = {start};", "}"])
        self.loops.pop()
        return made

    def records(self, counted):
        return [o for o in self.objects if isinstance(o.kind, Struct) and bool(o.count) == counted and not (o.pointer or o.constant or o.plc or o.is_volatile)
                and o.name not in self.protected]

    def inside(self, text, kind):
        """(text, type) of each integer of a record that has an address; arrays by one of their elements."""
        for member in kind.members:
            if not member.name or member.bits or member.kind in spelled.REAL:
                continue
            name = f"{text}{member.name}" + (f"[{self.random.randrange(member.count)}]" if member.count else "")
            if isinstance(member.kind, Struct):
                yield from self.inside(name + ".", member.kind)
            else:
                yield name, member.kind

    def member_pointed(self, depth):
        """{ int *p = &record.member; *p += 3; ... }"""
        from expressions import Object
        from statements import Lines, block, both
        usable = self.records(False) + self.records(True)
        if not usable:
            return both(";")
        item = self.random.choice(usable)
        found = list(self.inside(f"{item.name}[{self.random.randrange(item.count)}]." if item.count else f"{item.name}.", item.kind))
        if not found:
            return both(";")
        text, kind = self.random.choice(found)
        into = frozenset({item.name})
        pointer = self.fresh("p")
        self.note(Spelled("", "", reads=into, writes=into))
        self.body.hoisted.append(f"{kind} *{pointer} = 0;")
        rows = Lines([f"{kind} *{pointer} = &{text};"], [f"{pointer} = &{text};"])
        value = self.apart(Spelled("", "", target=into))
        for _ in range(self.random.randrange(1, 4)):
            form = self.random.choice(("*{p} {o} {v};", "{p}[0] {o} {v};", "if ({p} == &{t}) {t} {o} {v};", "if (*{p} > {v}) --*{p};", "{t} = *{p} - ({v});", "(*{p})++;",
                                       "*{p} = -*{p};", "{{ {k} *q = {p}; *q {o} {t}; }}"))
            operator = self.random.choice(("=", "+=", "-=", "^=", "|=", "&=", "*="))
            rows += Lines([form.format(p=pointer, t=text, k=kind, o=operator, v=value.at(spelled.POSTFIX).plc)],
                          [form.format(p=pointer, t=text, k=kind, o=operator, v=value.at(spelled.POSTFIX).avr)])
        own = Object(pointer, kind, 1, pointer=into)
        self.objects.append(own)
        inner = self.several(depth - 1, 2) if depth > 0 else Lines()
        self.objects.remove(own)
        return block(rows + inner)

    def records_walked(self, depth):
        """A pointer from record to record of an array: p->m, (p + 1)->m, p++->m, p - a, p < end."""
        from statements import Lines, MOST_ROUNDS, block, both
        usable = self.records(True)
        if not usable or self.rounds * 5 > MOST_ROUNDS:
            return both(";")
        item = self.random.choice(usable)
        names = [m.name for m in item.kind.members if m.name and not m.count and not isinstance(m.kind, Struct) and m.kind not in spelled.REAL]
        if not names or item.count < 2:
            return both(";")
        into = frozenset({item.name})
        self.note(Spelled("", "", reads=into, writes=into))
        counter, declaration = self.own_counter()
        i, p, q, m = counter.name, self.fresh("p"), self.fresh("p"), self.random.choice(names)
        word, last = f"{item.kind.word} {item.kind.tag}", item.count - 1
        value = self.apart(Spelled("", "", target=into)).at(spelled.POSTFIX)
        place = self.plain_place()
        if place.target & into or place.reads & into:
            place = Spelled(self.sink, self.sink)
        self.body.hoisted.append(f"{word} *{p} = 0, *{q} = 0;")
        a = item.name
        rows = Lines([f"{word} *{p} = {a}, *{q} = &{a}[{last}];"], [f"{p} = {a};", f"{q} = &{a}[{last}];"])
        body = self.random.choice((["{p}->{m} += {i};", "{p}++;"], ["{p}++->{m} ^= 1;"], ["if ({p} < {q}) {p}->{m} = ({p} + 1)->{m};", "{p} += 1;"], ["(*{p}).{m}++;", "++{p};"],
                                   ["if ({p} - {a} == 1) {p}->{m} = {v};", "{p} = {p} + 1;"], ["if ({q} >= {p}) {q}->{m} -= {p}->{m};", "{q}--; {p}++;"],
                                   ["if ({p} != {q}) *{p} = *{q};", "{p} = &{p}[1];"]))
        texts = [[row.format(p=p, q=q, m=m, i=i, a=a, v=v) for row in body] for v in (value.plc, value.avr)]
        rows += both(f"for ({i} = 0; {i} < {item.count}; {i}++) {{") + Lines(*texts) + both("}")
        self.body.rounds = max(self.body.rounds, self.rounds * item.count)
        told = self.random.choice(("{p} - {a}", "{p}[-1].{m}", "{p} > {q}", "({p} - 1)->{m} + {q}->{m}", "&{a}[1] <= {p}", "{p} == {a} + " + str(item.count)))
        if "{q}->" in told and "{q}--" in "".join(body):
            told = "{p} - {a}"
        told = told.format(p=p, q=q, m=m, a=a)
        return block(declaration + rows + Lines([f"{place.plc} = {told};"], [f"{place.avr} = {told};"]))

    def searched(self, depth):
        """for (...) if (a[i] == v) break; and what the counter says behind it."""
        from statements import Lines, MOST_ROUNDS, block, both
        arrays = self.indexed_arrays()
        if not arrays or self.rounds * 14 > MOST_ROUNDS:
            return both(";")
        item = self.random.choice(arrays)
        counter, declaration = self.own_counter()
        i, n = counter.name, item.count
        self.note(Spelled("", "", reads=frozenset({item.name})))
        self.body.rounds = max(self.body.rounds, self.rounds * n)
        value, place = self.apart(), self.plain_place()
        value = value.at(spelled.POSTFIX)
        relation = self.random.choice(("==", ">", "!=", "<="))
        head = f"for ({i} = 0; {i} < {n}; {i}++)"
        if self.chance(30):
            test = "{i} < {n} && {a}[{i}] {r} {v}"
            rows = both(f"{i} = 0;") + Lines([f"while ({test.format(i=i, n=n, a=item.name, r=relation, v=value.plc)}) {i}++;"],
                                             [f"while ({test.format(i=i, n=n, a=item.name, r=relation, v=value.avr)}) {i}++;"])
        else:
            rows = Lines([f"{head} if ({item.name}[{i}] {relation} {value.plc}) break;"], [f"{head} if ({item.name}[{i}] {relation} {value.avr}) break;"])
        told = self.random.choice((f"{i}", f"{i} < {n} ? {i} : -1", f"{i} == {n}", f"{n} - {i}"))
        return block(declaration + rows + Lines([f"{place.plc} = {told};"], [f"{place.avr} = {told};"]))

    def digits(self, depth):
        """Decimal digits, products over long, per cents."""
        from statements import Lines
        place = self.plain_place()
        one, other = self.apart(), self.apart()
        form = self.random.choice(("(({a}) / 10 << 4) | ({a}) % 10", "(({a}) >> 4) * 10 + (({a}) & 15)", "(long) ({a}) * ({b}) / 100", "(long) ({a}) * 1000L % 97",
                                   "(unsigned) ({a}) * ({b}) >> 3", "(unsigned char) (({a}) / 256) - (unsigned char) ({a})", "(char) -({a}) < (unsigned char) ({b})",
                                   "((unsigned long) ({a}) << 16 | (unsigned) ({b}))", "(unsigned char) -3 + ({a})", "(int) (({b}) * 100L / 360)"))
        plain = dataclasses.replace(one, plc=form.format(a=one.plc, b=other.plc), avr=form.format(a=one.avr, b=other.avr), level=2)
        if place.target & (one.writes | other.writes):
            return Lines([";"], [";"])
        return Lines([f"{place.plc} = {plain.plc};"], [f"{place.avr} = {plain.avr};"])


