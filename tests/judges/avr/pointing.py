"""Statements about pointers: chosen, returned, compared, moved, tested, null; into arrays, structs, texts and registers."""
import dataclasses

import spelled
from expressions import Object
from spelled import INTEGERS, NOTHING, Spelled, Struct

TEXTS = ('"abc"', '"\\x41\\n" "9"', '"\\377z "')  # of three characters
KINDS = ("unsigned char", "int", "unsigned", "long", "char", "unsigned long", "short")


class Pointing:
    def pointed_arrays(self, kind=None):
        return [o for o in self.objects if o.count >= 3 and not (o.second or o.pointer or o.constant or o.plc or o.is_volatile)
                and (o.kind == kind if kind else o.kind in KINDS) and o.name not in self.protected]

    def pointer_functions_made(self):
        """int *f(char a, int *p, int *q): one of them, or beyond."""
        from statements import Lines
        made = Lines()
        kinds = sorted({o.kind for o in self.pointed_arrays()})
        for kind in self.random.sample(kinds, min(len(kinds), self.random.randrange(0, 3))):
            name, by = self.fresh("h"), self.random.choice(INTEGERS)
            rows = self.random.choice((["return a ? p : q;"], ["if (a > 9) p++; else return q + 1;", "return p;"],
                                       ["p += a & 1;", "return a == 3 ? q : p;"], ["switch (a & 3) { case 1: return q; case 2: return &p[1]; }", "return &q[1] - 1;"]))
            head = f"{kind} *{name}({by} a, {kind} *p, {kind} *q)"
            made += Lines([head, "{", *rows, "}"], ["static " + head, "{", *rows, "}"])
            self.pointer_functions.append((name, kind))
        return made

    def pointing(self, depth):
        """{ T *p = ..., *q = ...; statements }"""
        from statements import Lines, block, both
        arrays = self.pointed_arrays()
        if not arrays:
            return self.text_pointing()
        item = self.random.choice(arrays)
        others = self.pointed_arrays(item.kind)
        other = self.random.choice(others)
        kind, one, two = item.kind, self.fresh("p"), self.fresh("p")
        test = self.note(self.integer(1)).at(4)
        self.note(Spelled("", "", reads=frozenset({item.name, other.name}), writes=frozenset({item.name, other.name})))
        makers = [name for name, made in self.pointer_functions if made == kind]
        into = frozenset({item.name, other.name})
        if makers and self.chance(60):
            call = self.random.choice(makers)
            first = (f"{call}({test.plc}, {item.name}, {other.name})", f"{call}({test.avr}, {item.name}, {other.name})")
            if test.writes & into:
                first = (f"{call}(1, {item.name}, {other.name})",) * 2
        elif self.chance(50):
            first = (f"{test.plc} ? {item.name} : &{other.name}[0]", f"{test.avr} ? {item.name} : &{other.name}[0]")
        else:
            first, other, into = (item.name, f"&{item.name}[0]") if self.chance(50) else (item.name,) * 2, item, frozenset({item.name})
        second = self.random.choice((f"{one} + 1", f"&{one}[1]", f"1 + {one}", f"({one} ? &{one}[1] : 0)"))
        null = self.chance(25)
        rows = Lines([f"{kind} *{one} = {first[0]}, *{two} = {'0' if null else second};"], [])
        self.body.hoisted.append(f"{kind} *{one} = 0, *{two} = 0;")
        rows.avr += [f"{one} = {first[1]};", f"{two} = {'0' if null else second};"]
        if null:
            rows += both(f"if ({self.random.choice((two, f'!{one}', f'{two} != 0'))}) {two}[0] = 1;")
            rows += both(f"{two} = {second};")
        for _ in range(self.random.randrange(1, 4)):
            rows += self.pointer_statement(one, two, kind, into)
        own = Object(one, kind, 2, pointer=into)
        self.objects.append(own)
        inner = self.several(depth - 1, 3)
        self.objects.remove(own)
        return block(rows + inner)

    def pointer_statement(self, one, two, kind, into):
        """Two pointers one element apart."""
        from statements import Lines, both
        pick = self.random.randrange(12)
        value = self.note(self.integer(1))
        if value.writes & into or value.reads & into:
            value = spelled.literal("3")
        if pick < 5:
            place = self.lvalue(1, True)
            if place.target & into or (place.reads | place.writes) & into or place.conflicts(value) or value.writes & place.target:
                place = Spelled(self.sink, self.sink, target=frozenset({self.sink}))
            self.note(dataclasses.replace(place, writes=place.writes | place.target))
            form = self.random.choice(("{p} == {q}", "{p} != {q}", "{p} < {q}", "{p} <= {q}", "{p} >= {q}", "{p} > {q} - 1", "!{p}", "{p} && {v}", "{v} || {q}",
                                       "{p} ? {v} : 7", "{q} - {p}", "*({q} - 1)", "{q}[-1] + *{p}", "({v} ? {p} : {q})[0]", "*({v} ? {q} : {p})", "{p} != 0",
                                       "({p} = {q}, *{p})", "*{p}-- + 1", "*--{q}", "({p}++)[0]", "*{q}++", "({q}--)[0]", "{p} + 1 == {q}", "sizeof *{p} + ({p} == {q})"))
            make = lambda v: form.format(p=one, q=two, v=v)
            undone = {"*{p}--": f"{one}++;", "*--{q}": f"{two}++;", "({p}++": f"{one}--;", "*{q}++": f"{two}--;", "({q}--)": f"{two}++;", "({p} = ": f"{one}--;"}
            after = next((row for head, row in undone.items() if form.startswith(head)), "")
            plc, avr = (value.at(4).plc, value.at(4).avr)
            if "?" in form:
                plc, avr = value.at(4).plc, value.at(4).avr
            else:
                plc, avr = value.at(6).plc, value.at(6).avr
            if form == "*{p}-- + 1":  # from the second element
                return Lines([f"++{one};", f"{place.plc} = {make(plc)};"], [f"++{one};", f"{place.avr} = {make(avr)};"])
            return Lines([f"{place.plc} = {make(plc)};"], [f"{place.avr} = {make(avr)};"]) + (both(after) if after else Lines())
        operator = self.random.choice(("=", "+=", "^=", "-=", "|="))
        store = lambda target: Lines([f"{target} {operator} {value.at(2).plc};"], [f"{target} {operator} {value.at(2).avr};"])
        if pick < 7:
            return both(f"if ({self.random.choice((one, f'{one} && {two}', f'{one} != {two}', f'{two} > {one}'))})") + store(f"*{self.random.choice((one, two))}")
        if pick == 7 and self.chance(50):
            back = both(f"{two} = {one} + 1;")
            if self.chance(50):
                return Lines(["//@loop_bound 2"], []) + both("do {") + store(f"*{two}") + both(f"{two} = 0; }} while ({two});") + back
            return Lines(["//@loop_bound 2"], []) + both(f"while ({two}) {{") + store(f"*{two}") + both(f"{two} = 0; }}") + back
        if pick < 9:  # up to the other one, and back
            guard = self.fresh("n")
            self.body.hoisted.append(f"int {guard} = 0;")
            self.body.writes |= {"FAULT"}
            test = self.random.choice((f"{one} != {two}", f"{one} < {two}"))
            if self.chance(30):
                return Lines(["//@loop_bound 3"], []) + both("do {") + store(f"*{one}") + both(f"}} while (++{one} < {two});") + both(f"--{one};")
            head = Lines(["//@loop_bound 3", f"while ({test}) {{"], [f"{guard} = 0;", f"while (({test}) && ({guard}++ < 3 || (fault(3), 0))) {{"])
            return head + store(f"*{one}++") + both("}") + both(f"{one}--;")
        if pick < 10:
            return store(self.random.choice((f"*({one} + 1)", f"*(1 + {one})", f"{two}[-1]", f"0[{two}]", f"*&*{one}", f"(&{two}[-1])[1]")))
        if pick < 11:
            test = value.at(4)
            return Lines([f"{test.plc} ? (void) (*{one} = 1) : (void) ({two}[0]++);"], [f"{test.avr} ? (void) (*{one} = 1) : (void) ({two}[0]++);"])
        return both(f"{{ {kind} *{one}_ = {one}; {one} = {two}; {one} = {one}_; }}")

    def text_pointing(self):
        """A letter of a text."""
        from statements import Lines
        index = spelled.binary("&", self.note(self.integer(1)), spelled.literal("1"))
        text = self.random.choice(TEXTS)
        place = self.lvalue(1, True)
        if place.target & index.writes or place.conflicts(index):
            index = spelled.literal("1")
        self.note(dataclasses.replace(place, writes=place.writes | place.target))
        form = self.random.choice(("{t}[{i}]", "*({t} + ({i}))", "({i})[{t}]"))
        own = f'((unsigned char *) {text})' if self.options.get("char") else text
        return Lines([f"{place.plc} = {form.format(t=text, i=index.plc)};"], [f"{place.avr} = {form.format(t=own, i=index.avr)};"])

    def static_pointer(self):
        """static T *p = a; which moves on with each call, and comes back."""
        from statements import Lines, both
        arrays = [o for o in self.pointed_arrays() if o.name.startswith("g")]
        if not arrays:
            return Lines(), Lines()
        item = self.random.choice(arrays)
        name = self.fresh("s")
        self.note(Spelled("", "", reads=frozenset({item.name}), writes=frozenset({item.name})))
        self.note(value := self.integer(1))
        if value.writes & {item.name} or item.name in value.reads:
            value = spelled.literal("2")
        operator = self.random.choice(("=", "+=", "-=", "^="))
        moved = self.random.choice((f"if ({name} == &{item.name}[{item.count - 1}]) {name} = {item.name}; else {name}++;",
                                    f"if (++{name} >= {item.name} + {item.count}) {name} = &{item.name}[0];",
                                    f"if ({name} - {item.name} > 0) --{name}; else {name} += {item.count - 1};"))
        rows = Lines([f"*{name} {operator} {value.at(2).plc};"], [f"*{name} {operator} {value.at(2).avr};"]) + both(moved)
        return both(f"static {item.kind} *{name} = {self.random.choice((item.name, f'&{item.name}[1]', f'{item.name} + 2'))};"), rows

    def struct_elements(self):
        """Structs from one element or pointer into another; pointers to structs that walk."""
        from statements import Lines, both
        arrays = [o for o in self.objects if isinstance(o.kind, Struct) and o.count >= 2 and not (o.pointer or o.constant or o.plc)
                  and o.name not in self.protected]
        if not arrays:
            return both(";")
        item = self.random.choice(arrays)
        self.note(Spelled("", "", reads=frozenset({item.name}), writes=frozenset({item.name})))
        index = spelled.binary("&", self.note(self.integer(1)), spelled.literal("1"))
        if index.writes & {item.name}:
            index = spelled.literal("1")
        singles = [o for o in self.objects if o.kind is item.kind and not (o.count or o.pointer or o.constant or o.plc) and o.name not in self.protected]
        if singles and self.chance(50):
            single = self.random.choice(singles)
            self.note(Spelled("", "", reads=frozenset({single.name}), writes=frozenset({single.name})))
            if index.writes & {single.name}:
                index = spelled.literal("1")
            element = (f"{item.name}[{index.plc}]", f"{item.name}[{index.avr}]")
            rows = (f"{element[0]} = {single.name};", f"{element[1]} = {single.name};") if self.chance(50) else (f"{single.name} = {element[0]};",
                                                                                                                    f"{single.name} = {element[1]};")
            return Lines([rows[0]], [rows[1]])
        pointer, word = self.fresh("p"), f"{item.kind.word} {item.kind.tag}"
        self.body.hoisted.append(f"{word} *{pointer} = 0;")
        start = (f"&{item.name}[{index.plc}]", f"&{item.name}[{index.avr}]")
        rows = Lines(["{", f"{word} *{pointer} = {start[0]};"], ["{", f"{pointer} = {start[1]};"])
        members = [m for m in item.kind.members if m.name and not m.count and not isinstance(m.kind, Struct) and m.kind not in spelled.REAL]
        if members:
            name = self.random.choice(members).name
            rows += both(self.random.choice((f"{pointer}->{name}++;", f"(*{pointer}).{name} -= 3;", f"if (!{pointer}->{name}) {pointer}->{name} = 1;",
                                             f"{item.name}[0].{name} = {pointer}->{name}--;")))
        return rows + both(self.random.choice((f"*{pointer} = {item.name}[1];", f"{item.name}[0] = *{pointer};", f"{pointer} = {item.name}; {pointer}[1] = *{pointer}++;",
                                               f"{pointer} = &{item.name}[1]; *--{pointer} = {item.name}[1];")).replace("[1] = *" + pointer + "++", "[1] = *" + pointer)) + both("}")
