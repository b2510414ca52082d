"""Random programs over the language that plcxx accepts, each written for both compilers."""
import dataclasses
import re

import shapes
import spelled
from expressions import LIBRARY, Function, Macro, Object
from inputs import HANDLED, Inputs
from program import Observed, Program
from spelled import INTEGERS, NOTHING, SIZES, VIEWS, Member, Spelled, Struct
from statements import Body, Lines, Statements, both

# Further names of a type, in declarations (3.2).
WORDS = {"unsigned long": ("long unsigned int", "unsigned long int"), "long": ("long int", "signed long", "int long"),
         "unsigned": ("unsigned int", "int unsigned"), "short": ("short int", "signed short"), "int": ("signed", "int near", "signed int"),
         "unsigned char": ("char unsigned", "unsigned char far")}
MOST_REPEATED = 8  # bytes of a struct of which another one has an array
KINDS = "MSTB"  # of the dispatcher; the fifth is E
NEVER = "#if {}\nthis isn't C at all: {{ 'x\n#{}\n"
POINTED = ("unsigned char", "int", "unsigned", "long", "char")
# Macros with ?: for avr-gcc, see ARM of judge.h.
ARMS = {"((x) > (y) ? (x) : (y))": "((x) > (y) ? ARM(x) : ARM(y))",
        "((x) < 0 ? -(x) : (x) | (y))": "((x) < 0 ? ARM(-(x)) : ARM((x) | (y)))"}


class Generator(Statements, Inputs):
    def __init__(self, seed, mark):
        super().__init__(seed, mark)
        self.text = Lines()
        self.observed, self.defined, self.header = [], [], []
        self.registered = []
        self.has_memory = self.chance(40)
        self.shape = shapes.draw(self.random)
        self.has_reals, self.has_pointers, self.has_control, self.has_customs = (self.chance(share) for share in (35, 60, 45, 60))
        if self.has_reals and self.chance(60):
            self.headers.add("math")
        self.choose_options()

    def program(self):
        if self.chance(40):
            self.known = list(LIBRARY)
            if self.options.get("abs"):
                self.known.remove(LIBRARY[0])
        self.types()
        self.variables()
        self.real_objects()
        self.preprocessor()
        functions = self.struct_function() + self.real_functions_made()
        if self.has_pointers:
            functions += self.pointer_functions_made()
        if self.has_customs:
            functions += self.custom_functions_made()
        for _ in range(self.random.randrange(1, self.shape.functions + 1)):
            functions += self.function()
        if self.chance(35):
            functions += self.handlers()
        parts = self.part("plc1", self.shape.part) + self.part("plc2", (self.shape.part + 1) // 2)
        init = self.init()
        library = ["#include <stdlib.h>"] if len(self.known) > 1 else []
        library += ["#include <string.h>"] if self.has_memory else []
        library += [f"#include <{name}.h>" for name in sorted(self.headers)]
        self.hidden_text()
        plc = ['#include "plc.h"', *library, *self.text.plc, *functions.plc, *init.plc, *parts.plc]
        files = {}
        if self.chance(25):
            cut = 1 + len(library) + len(self.text.plc)
            plc = ['#include "plc.h"', *library, f'#include "{self.mark}.h"'] + plc[cut:]
            files[f"{self.mark}.h"] = "\n".join([f"#ifndef H_{self.mark}", f"#define H_{self.mark}", *self.text.plc, "#endif", ""])
        avr = [*self.text.avr, *functions.avr, *init.avr, *parts.avr, *(f"#undef {name}" for name in self.defined)]
        text = "\n".join(avr) + "\n"
        if self.options.get("char"):
            text = re.sub(r"(?<!signed )\bchar\b", "unsigned char", re.sub(r"\b([XYRPBFG])\.c\b", r"\1.uc", text))
        return Program(self.mark, {f"{self.mark}.cld": "\n".join(plc) + "\n", **files}, text, self.inputs(),
                       self.observed + self.areas(), options=self.options, settings=self.settings())

    # what only the control and the preprocessor see

    def init(self):
        """The periods, registrations of handlers, and statements; before the first cycle."""
        body = self.body = Body("void")
        self.function_locals = []
        inner = Lines()
        for _ in range(self.random.randrange(0, 3)):
            inner += self.simple(self.assigned(2, True)) if self.chance(60) else self.statement(2)
        # Last: a statement may have assigned them.
        one, other = (self.random.choice((1, 1, 1, 0, 2, 3, 5)) for _ in range(2))
        inner += both(f"plc1_time = {one};") + both(f"plc2_time = {other};")
        for channel, kind, name in self.registered:
            word = "&" if self.chance(20) else ""
            row = (f"set_mst_func({channel}, '{kind}', {word}{name});", f"handler[{channel}][{(KINDS + 'E').index(kind)}] = {name};")
            if self.chance(20):
                test = self.condition(1)
                row = (f"if ({test.plc}) {row[0]}", f"if ({test.avr}) {row[1]}")
            inner += Lines([row[0]], [row[1]])
        return Lines([f"{self.random.choice(('void init()', 'init()', 'void init(void)'))}", "{", *self.function_locals, *inner.plc, "}"],
                     [f"static void init_{self.mark}(void)", "{", *body.hoisted, *inner.avr, "}"])

    def handlers(self):
        """Functions that the dispatcher calls; each ends its request at some time, or leaves that to the default."""
        made = Lines()
        for _ in range(self.random.randrange(1, 4)):
            name, channel = self.fresh("h"), self.random.choice(HANDLED)
            kind = self.random.choice("MMSTBE")
            body = self.body = Body("void")
            self.function_locals = []
            parameter = Object(self.fresh("a"), "int")
            self.objects.append(parameter)
            inner = self.several(2, 4)
            self.objects.remove(parameter)
            if kind != "E":
                test = self.condition(1)
                inner += Lines([f"if ({test.plc}) mod_{kind}_code({channel}) = -1;"],
                               [f"if ({test.avr}) G.i[{170 + 20 * channel + KINDS.index(kind)}] = -1;"])
            self.registered.append((channel, kind, name))
            made += Lines([f"void {name}(int {parameter.name})", "{", *self.function_locals, *inner.plc, "}"],
                          [f"static void {name}(int {parameter.name})", "{", *body.hoisted, *inner.avr, "}"])
        return made

    def hidden_text(self):
        """Groups that are not taken, and names of types in other words: for plcxx only."""
        rows = []
        for row in self.text.plc:
            head, _, rest = row.partition(" ")
            for kind, others in WORDS.items():
                if row.startswith(kind + " ") and row.endswith(";") and "{" not in row.partition("=")[0] and "(" not in row and self.chance(20):
                    name = row[len(kind) + 1:]
                    if not name.startswith(("int ", "char ", "long ", "*")):
                        row = f"{self.random.choice(others)} {name}"
                    break
            rows.append(row)
            if self.chance(4) and not row.startswith("#"):
                test = self.random.choice(("0", "!defined(__TURBOC__)", "(1L << 16) == 0", "'a' != 97 || UNKNOWN", "65535u + 1 != 0x10000"))
                if self.chance(40):
                    rows += self.random.choice(((f"#ifdef __PLCXX__", f"#undef NONE_{self.mark}", "#elif 1", "no C {", "#endif"), ("#pragma argsused",), ("#pragma warn -par",),
                                                (f"#line {self.random.randrange(1, 32767)}",), (f'#line {self.random.randrange(1, 999)} "x.h"',),
                                                (f"#define NONE_{self.mark} 1", f"#ifndef NONE_{self.mark}", "'", "#elif NONE_{0} == 1".format(self.mark), "#else", "{", "#endif",
                                                 f"#undef NONE_{self.mark}")))
                elif self.chance(50):
                    rows += NEVER.format(test, "endif").splitlines()
                else:
                    rows += [*NEVER.format(test, "else").splitlines(), f"/* taken */ extern int sink_{self.mark};", "#endif"]
        self.text.plc = rows

    # declarations

    def types(self):
        names, value = [], -1
        for _ in range(self.random.randrange(0, 5)):
            name = self.fresh("E")
            if names and self.chance(30):  # of those before it
                other, by = self.random.choice(self.enumerators[-len(names):]), self.random.randrange(1, 5)
                text, value = self.random.choice(((f"{other} * 2 + {by}", self.enumerator_values[other] * 2 + by), (f"-{other}", -self.enumerator_values[other]),
                                                  (f"({other} & 15) << {by}", (self.enumerator_values[other] & 15) << by),
                                                  (f"{other} > {by} ? {by} : {other}", min(by, self.enumerator_values[other]))))
                names.append(f"{name} = {text}")
            elif self.chance(40):
                value = self.random.randrange(-300, 300)
                names.append(f"{name} = {value}")
            else:
                value += 1
                names.append(name)
            self.enumerators.append(name)
            self.enumerator_values[name] = value
        self.enumerators_apart = list(self.enumerators)
        if names:
            self.enum = self.fresh("T")
            self.text += both(f"enum {self.enum} {{ {', '.join(names)} }};")
        for _ in range(self.random.randrange(0, 3)):
            struct = self.struct()
            self.structs.append(struct)
            self.text += Lines([struct.plc()], [struct.avr()])

    def struct(self):
        members = []
        if self.chance(25):
            parts = [Member("b", "unsigned char", 4), Member("w", "unsigned", 2), Member("l", "long"), Member("c", "char", 3),
                     Member("u", "unsigned long"), Member("i", "int")]
            inner = [s for s in self.structs if s.word == "struct" and s.size() <= 4]
            members = parts[:1] + self.random.sample(parts[1:], 3) + [Member("s", s) for s in inner[:1]]
            return Struct("union", self.fresh("U"), members)
        for i in range(self.random.randrange(2, 6)):
            pick = self.random.randrange(10)
            if pick < 5:
                members.append(Member(f"m{i}", "float" if self.has_reals and self.chance(15) else self.random.choice(INTEGERS)))
            elif pick < 7:
                members.append(Member(f"m{i}", self.random.choice(INTEGERS), self.random.choice((2, 3, 4))))
            elif pick < 8 and self.structs:
                inner = self.random.choice(self.structs)
                members.append(Member(f"m{i}", inner, self.random.choice((0, 0, 2, 3)) if inner.size() <= MOST_REPEATED else 0))
            else:
                kind = self.random.choice(("int", "unsigned", "unsigned", "unsigned char", "char"))
                for k in range(self.random.randrange(1, 5)):
                    name = "" if self.chance(10) else f"f{i}{k}"
                    bits = self.random.randrange(0 if not name else 1, 9 if kind.endswith("char") else 17 if self.chance(20) else 8)
                    members.append(Member(name, kind, 0, bits))
        if not any(m.name and m.kind not in spelled.REAL for m in members):
            members.append(Member("m", "int"))
        return Struct("struct", self.fresh("S"), members)

    def variables(self):
        self.text += Lines([f"int sink_{self.mark};"], [f"static int sink_{self.mark};"])
        self.sink = f"sink_{self.mark}"
        for _ in range(self.random.randrange(*self.shape.variables)):
            self.variable()
        for struct in self.structs:
            # At least two, so that one is assigned to another.
            for _ in range(2 if struct.word == "struct" and self.chance(60) else 0):
                item = Object(self.fresh("g"), struct)
                text = spelled.declared(struct, item.name)
                self.text += Lines([text + ";"], [f"static {text};"])
                self.objects.append(item)
                self.observe(item)

    def initial(self, kind, count):
        if self.chance(50):
            return ""
        if count:
            return " = {" + ", ".join(str(self.random.randrange(-100, 200)) for _ in range(self.random.randrange(1, count + 1))) + "}"
        return f" = {self.random.choice(('0', '1', '-1', '100', '0x7FFF', '3 * 7', '1000', '~5', '-300'))}"

    def variable(self):
        pick = self.random.randrange(22)
        name = self.fresh("g")
        if pick >= 20:
            self.table(name)
            return
        if pick < 9:
            item = Object(name, self.random.choice(self.shape.kinds))
        elif pick < 12:
            item = Object(name, self.random.choice(self.shape.kinds), self.random.choice((1, 2, 3, 4, 5, 8, 13)))
        elif pick < 13:
            item = Object(name, self.random.choice(self.shape.kinds), *self.random.choice(((3, 4), (2, 2), (1, 5), (5, 1))))
        elif pick < 14:
            kind = self.random.choice(("unsigned char", "int", "unsigned", "long", "char"))
            count = self.random.choice((4, 5, 8))
            item = Object(name, kind, count, constant=True)
            values = ", ".join(str(self.random.randrange(-120, 120)) for _ in range(count))
            self.text += Lines([f"const {kind} {name}[{count}] = {{{values}}};"], [f"static const {kind} {name}[{count}] = {{{values}}};"])
            self.objects.append(item)
            return
        elif pick < 15:
            text = "".join(self.random.choice(("a", "B", "7", " ", "\\x41", "\\n", "\\201")) for _ in range(4))
            text = text.replace("\\x41", '\\x41""') if self.chance(50) else text.replace("\\x41", "A")
            self.text += Lines([f'const char {name}[] = "{text}";'], [f'static const char {name}[] = "{text}";'])
            self.objects.append(Object(name, "char", 5, constant=True))
            return
        elif pick < 17 and self.structs:
            item = Object(name, self.random.choice(self.structs), self.random.choice((0, 0, 0, 2, 3)))
        elif pick < 18:
            self.text += Lines([f"union {{ float f; unsigned long u; }} {name};"], [f"static union {{ float f; unsigned long u; }} {name};"])
            self.objects.append(Object(name, "float"))
            self.unions.add(name)
            self.observed.append(Observed(f"{name}.u", [(f"{name}.u", "unsigned long")]))
            return
        else:
            self.pointer(name)
            return
        initial = "" if isinstance(item.kind, Struct) or item.second else self.initial(item.kind, item.count)
        if item.second and self.chance(60):
            row = lambda most: ", ".join(str(self.random.randrange(-100, 200)) for _ in range(self.random.randrange(1, most + 1)))
            nested = ", ".join(f"{{{row(item.second)}}}" for _ in range(self.random.randrange(1, item.count + 1)))
            initial = f" = {{{nested}}}" if self.chance(70) else f" = {{{row(item.count * item.second)}}}"
        if isinstance(item.kind, Struct) and item.kind.word == "struct" and not item.count and self.chance(50):
            values = [str(self.random.randrange(-3, 100)) for _ in range(self.random.randrange(1, 3))]
            named = sum(1 for member in item.kind.members if member.name)  # a bit-field without a name takes none
            initial = f" = {{{', '.join(values[:named])}}}"
        text = spelled.declared(item.kind, name, item.count) + (f"[{item.second}]" if item.second else "") + initial
        if not isinstance(item.kind, Struct) and self.chance(15):
            alias = self.fresh("D")
            self.text += both(f"typedef {item.kind} {alias};")
            text = alias + text[len(item.kind):]
        plc = text
        if item.kind == "int" and self.enumerators and self.chance(40) and text.startswith("int "):
            plc = f"enum {self.enum}{text[3:]}"
        word = self.random.choice(("", "", "static ", "" if item.count or isinstance(item.kind, Struct) else "volatile "))
        self.text += Lines([f"{word}{plc};"], [f"static {text};"])
        item.is_volatile = word == "volatile "
        self.objects.append(item)
        self.observe(item)

    def table(self, name):
        """A constant table of texts or of structs."""
        structs = [s for s in self.structs
                   if s.word == "struct" and not any(m.count or isinstance(m.kind, Struct) for m in s.members)]
        count = self.random.choice((2, 3, 4))
        values = lambda least, most, number: ", ".join(str(self.random.randrange(least, most)) for _ in range(number))
        if structs and self.chance(60):
            kind = self.random.choice(structs)
            named = sum(1 for member in kind.members if member.name)
            rows = ", ".join(f"{{{values(-3, 120, self.random.randrange(1, named + 1))}}}" for _ in range(count))
            text = f"const {spelled.declared(kind, name)}[{self.random.choice(('', count))}] = {{{rows}}};"
            item = Object(name, kind, count, constant=True)
        elif self.chance(50):
            item = self.number_table(name)
            self.objects.append(item)
            return
        else:
            rows = [[self.random.choice(("a", "B", "7", " ", "\\n", "\\201")) for _ in range(self.random.randrange(5))] for _ in range(count)]
            texts = [f'"{"".join(row)}"' for row in rows]
            text = f"const char {name}[{count}][4] = {{{', '.join(texts)}}};"
            item = Object(name, "char", count, 4, constant=True)
            if self.chance(50):  # one text, which the program may change; with or without room for its end
                item = Object(name, self.random.choice(("char", "unsigned char")), max(1, len(rows[0])) + self.random.randrange(3))
                text = f"{item.kind} {name}[{item.count}] = {texts[0]};"
                self.text += Lines([text], ["static " + text])
                self.objects.append(item)
                self.observe(item)
                return
        self.text += Lines([text], ["static " + text])
        self.objects.append(item)

    def number_table(self, name, local=False):
        """const int T[3][4] = {{..}, ..}; its first bound may be that of its rows, its inner braces may be left out."""
        kind = self.random.choice(INTEGERS)
        count, second = self.random.choice(((2, 3), (3, 4), (4, 2), (1, 6), (5, 5)))
        numbers = [[str(self.random.choice((0, 1, -1, 7, 100, 255, -128, 32767, self.random.randrange(-300, 300)))) for _ in range(second)] for _ in range(count)]
        rows = ", ".join(f"{{{', '.join(row)}}}" for row in numbers) if self.chance(70) else ", ".join(", ".join(row) for row in numbers)
        bound = self.random.choice(("", count))
        text = f"{'static ' if local else ''}const {kind} {name}[{bound}][{second}] = {{{rows}}};"
        row = Lines([text], [text if local else "static " + text])
        item = Object(name, kind, count, second, constant=True)
        if local:
            return item, row
        self.text += row
        return item

    def pointer(self, name):
        """A global pointer to one of two objects; functions leave it alone."""
        arrays = [o for o in self.objects if o.count >= 2 and not o.second and not o.pointer and not o.constant]
        if not arrays:
            return
        item = self.random.choice(arrays)
        at = self.random.randrange(2) if item.count > 3 else 0
        text = f"{spelled.declared(item.kind, '*' + name)} = &{item.name}[{at}]"
        self.text += Lines([text + ";"], ["static " + text + ";"])
        self.objects.append(Object(name, item.kind, item.count - at, pointer=frozenset({item.name}), constant=False))

    def observe(self, item):
        if item.second:
            names = [(f"{item.name}[{i}][{j}]", item.kind) for i in range(item.count) for j in range(item.second)]
            self.observed.append(Observed(item.name, names))
            return
        found = spelled.leaves(item.name, item.kind, item.count)
        if isinstance(item.kind, Struct):
            for name, kind, is_field in found:
                if kind in spelled.REAL:
                    continue
                self.observed.append(Observed(name, [(name, kind)], is_field))
        else:
            self.observed.append(Observed(item.name, [(name, kind) for name, kind, _ in found]))

    # preprocessor

    def preprocessor(self):
        if self.chance(40):
            join, text = self.fresh("J"), self.fresh("K")
            self.defined += [join, text]
            self.text += both(f"#define {join}(a, b) a ## b")
            # Another spelling of a variable: put together by ##.
            usable = [o for o in self.objects if o.name.startswith("g") and "." not in o.name and not (o.plc or o.pointer)]
            for item in self.random.sample(usable, min(2, len(usable))):
                cut = self.random.randrange(1, len(item.name) - 1)
                if item.name[cut].isalpha() or item.name[cut] == "_":
                    self.objects.append(dataclasses.replace(item, plc=f"{join}({item.name[:cut]}, {item.name[cut:]})"))
        if self.has_customs:
            self.custom_macros()
        for _ in range(self.random.randrange(0, 5)):
            name, parameters = self.fresh("M"), self.random.randrange(0, 3)
            names = ("x", "y")[:parameters]
            templates = {0: None, 1: ("((x) & 0x0F)", "(1 << ((x) & 7))", "(-(x))", "((x) * (x) + 1)", "x * 2 + 1", "!x", "(unsigned char)(x)"),
                         2: ("((x) > (y) ? (x) : (y))", "((x) & (1 << ((y) & 15)))", "(x - y)", "x + y * 3", "((x) ^ (y))",
                             "((x) < 0 ? -(x) : (x) | (y))")}[parameters]
            self.defined.append(name)
            if not parameters:
                was, self.pure = self.pure, True
                body = self.integer(2).at(spelled.POSTFIX)
                self.pure = was
                self.text += Lines([f"#define {name} {body.plc}"], [f"#define {name} {body.avr}"])
                self.macros.append(Macro(name, lambda _, n=name, b=body: dataclasses.replace(b, plc=n, avr=n, constant=b.constant, target=NOTHING), 0))
                continue
            body = self.random.choice(templates)
            row = f"#define {name}({','.join(names)}) "
            self.text += Lines([row + body], [row + ARMS.get(body, body)])
            self.macros.append(Macro(name, lambda args, n=name: self.macro_call(n, args), parameters))

    def macro_call(self, name, arguments):
        # the shift in a macro's body is of a masked count; what the body is made of decides the type. An operator that avr-gcc has
        # as a call does not come apart in a body without parentheses.
        arguments = [a.at(spelled.POSTFIX if any(f"{called}(" in a.avr for called in spelled.NAMED.values()) else 2) for a in arguments]
        return Spelled(f"{name}({', '.join(a.plc for a in arguments)})", f"{name}({', '.join(a.avr for a in arguments)})",
                       "int", spelled.PRECEDENCE["+"], frozenset().union(*(a.reads for a in arguments)),
                       frozenset().union(*(a.writes for a in arguments)), all(a.constant for a in arguments))

    # functions

    def function(self):
        name = self.fresh("f")
        kind = self.random.choice((*INTEGERS, "int", "int", "void", "void"))
        body = self.body = Body(kind)
        self.function_locals = []
        parameters = []
        for _ in range(self.random.randrange(0, self.shape.parameters)):
            parameters.append(self.parameter())
        old = self.chance(20) and parameters and not any(p.pointer for p in parameters)
        rows_at_end = Lines()
        statics = Lines()
        items = list(parameters)
        for _ in range(self.random.randrange(0, 3)):
            item = Object(self.fresh("s"), self.random.choice(INTEGERS))
            if self.chance(25):
                item.count = self.random.choice((2, 4))
                values = ", ".join(str(self.random.randrange(-50, 200)) for _ in range(self.random.randrange(1, item.count + 1)))
                statics += both(f"static {item.kind} {item.name}[{item.count}] = {{{values}}};")
            else:
                statics += both(f"static {item.kind} {item.name} = {self.random.randrange(-50, 50)};")
            items.append(item)
        if self.structs and self.chance(30):
            struct = self.random.choice(self.structs)
            same = [o for o in self.objects if o.kind is struct and not (o.count or o.pointer or o.constant)]
            item = Object(self.fresh("v"), struct)
            if same and self.chance(60):
                other = self.random.choice(same)
                body.reads |= {other.name}
                statics += both(f"{spelled.declared(struct, item.name)} = {other.name};")
            else:
                statics += self.local(item)
            items.append(item)
        if self.chance(15):
            item, declared = self.number_table(self.fresh("t"), local=True)
            statics += declared
            items.append(item)
        if self.structs and self.chance(20):
            struct = self.random.choice([s for s in self.structs])
            item = Object(self.fresh("s"), struct)
            statics += both(f"static {spelled.declared(struct, item.name)};")
            items.append(item)
        if self.has_reals and self.chance(50):
            item, declared = self.local_real()
            statics += declared
            items.append(item)
        if self.has_reals and self.chance(20):
            item = Object(self.fresh("s"), self.random.choice(spelled.REAL))
            statics += both(f"static {item.kind} {item.name} = {self.random.choice(('1.5', '-3', '0.25f'))};")
            items.append(item)
        for _ in range(self.random.randrange(0, 3)):
            item = Object(self.fresh("v"), self.random.choice(INTEGERS), self.random.choice((0, 0, 4)))
            statics += self.local(item)
            items.append(item)
        before = list(self.objects)
        if self.has_pointers and self.chance(20):
            declared, rows_at_end = self.static_pointer()
            statics += declared
        self.objects += items
        inner = self.several(min(2, self.shape.depth), self.shape.block + 1) + rows_at_end
        result = self.note(self.integer(2)) if kind != "void" else None
        self.objects = before
        tail = Lines([f"return {result.plc};"], [f"return {result.avr};"]) if result else Lines()
        if result and self.chance(10):
            tail = Lines([], ["return 0;"])
        made = Function(name, kind, parameters, body.reads, body.writes, body.rounds * 2)
        made.old = old
        self.functions.append(made)
        texts = [f"{p.kind} {p.name}{self.random.choice(('[]', '[3]'))}" if p.pointer and not isinstance(p.kind, Struct) and self.chance(20)
                 else spelled.declared(p.kind, ("*" if p.pointer else "") + p.name) for p in parameters]
        head = f"{kind} {name}({', '.join(texts) or 'void'})"
        plc_head = [f"{kind} {name}({', '.join(p.name for p in parameters)})", *(t + ";" for t in texts)] if old else [head]
        plc_head[0] = (self.random.choice(("static ", "")) if not old else "") + plc_head[0]
        if self.chance(6):  # no meaning here, but words of the language
            plc_head[0] = plc_head[0].replace(f" {name}(", f" {self.random.choice(('pascal', 'cdecl', '_cdecl', 'far', 'huge'))} {name}(", 1)
        if not old and self.chance(30):
            names = [t.rsplit(p.name, 1)[0].strip() if self.chance(50) and not t.endswith("]") else t for t, p in zip(texts, parameters)]
            self.text.plc.append(plc_head[0].partition("(")[0] + f"({', '.join(names) or 'void'});")
        # for avr-gcc the locals and the function's own static variables first
        return Lines(plc_head + ["{", *self.function_locals, *statics.plc, *inner.plc, *tail.plc, "}"],
                     ["static " + head, "{", *body.hoisted, *statics.avr, *inner.avr, *tail.avr, "}"])

    def struct_function(self):
        """Structs go in and out by value."""
        made = Lines()
        for struct in self.structs:
            scalars = [m.name for m in struct.members if m.name and not m.count and not isinstance(m.kind, Struct) and m.kind not in spelled.REAL]
            if not scalars or self.chance(50):
                continue
            name, word = self.fresh("h"), f"{struct.word} {struct.tag}"
            member = self.random.choice(scalars)
            operator = self.random.choice(("+=", "=", "^=", "-="))
            rows = [f"{word} {name}(long a, {word} s)", "{", f"s.{member} {operator} a;", "return s;", "}"]
            made += Lines(rows, ["static " + rows[0], *rows[1:]])
            self.struct_functions.append((name, struct, 1))
            if self.chance(50):
                name = self.fresh("h")
                rows = [f"{word} {name}({word} s, {word} t)", "{", f"s.{member} {operator} t.{member};", "return s;", "}"]
                made += Lines(rows, ["static " + rows[0], *rows[1:]])
                self.struct_functions.append((name, struct, 2))
        return made

    def parameter(self):
        name = self.fresh("a")
        if self.chance(60):
            return Object(name, self.random.choice(INTEGERS))
        if self.chance(25) and (found := self.struct_parameter(name)):
            return found
        kind = self.random.choice(POINTED)
        at = self.random.randrange(16)
        view = next(v for v, k in VIEWS.items() if k == kind)
        addresses = {"R": (f"&R_{view}[{at // SIZES[kind]}]", f"&R.{view}[{at // SIZES[kind]}]")}
        count = 3
        for item in self.objects:
            if item.kind == kind and item.count >= 2 and not item.second and not item.pointer and not item.constant and self.chance(60):
                addresses[item.name] = (item.name, item.name)
                count = min(count, item.count)
        if self.chance(40):
            # One value only: a variable, an element, a member.
            count = 1
            for item in self.objects:
                if item.second or item.pointer or item.constant or item.plc or item.is_volatile:
                    continue
                text = f"&{item.name}" if not item.count else f"&{item.name}[{self.random.randrange(item.count)}]"
                if isinstance(item.kind, Struct):
                    members = [m for m in item.kind.members if m.kind == kind and m.name and not m.bits]
                    if members and self.chance(50):
                        member = self.random.choice(members)
                        addresses[item.name] = (f"{text}.{member.name}" + ("[0]" if member.count else ""),) * 2
                elif item.kind == kind and self.chance(50):
                    addresses[item.name] = (text, text)
        made = Object(name, kind, count, pointer=frozenset(addresses))
        made.addresses = addresses
        return made

    def struct_parameter(self, name):
        usable = [o for o in self.objects if isinstance(o.kind, Struct) and not (o.pointer or o.constant)]
        if not usable:
            return None
        kind = self.random.choice(usable).kind
        addresses = {}
        for item in usable:
            if item.kind is kind:
                text = f"&{item.name}[{self.random.randrange(item.count)}]" if item.count else f"&{item.name}"
                addresses[item.name] = (text, text)
        made = Object(name, kind, 1, pointer=frozenset(addresses))
        made.addresses = addresses
        return made

    def part(self, name, statements):
        body = self.body = Body("void")
        self.function_locals = []
        inner = Lines()
        for _ in range(self.random.randrange(2, statements + 2)):
            inner += self.statement(self.shape.depth)
            if self.chance(25):
                inner += self.whole_struct() or Lines()
            if self.chance(6):
                value = self.note(spelled.binary("&", self.integer(1), spelled.literal("3")))
                period = self.random.choice(("plc1_time", "plc2_time"))
                inner += Lines([f"{period} = {value.plc};"], [f"{period} = {value.avr};"])
            if self.chance(8):
                channel, kind = self.random.choice(HANDLED), self.random.randrange(4)
                test = self.condition(1)
                inner += Lines([f"if ({test.plc}) mod_{KINDS[kind]}_code({channel}) = -1;"],
                               [f"if ({test.avr}) G.i[{170 + 20 * channel + kind}] = -1;"])
        if name == "plc2" and self.chance(10):
            inner += Lines(["plc1();"], [f"plc1_{self.mark}();"])
        if name == "plc1":
            for function, kind in self.pointer_functions:
                # its parameters are to have objects
                item = self.random.choice([o for o in self.pointed_arrays(kind) if o.name.startswith("g")])
                self.note(Spelled("", "", reads=frozenset({item.name})))
                inner += both(f"{self.sink} = *{function}(2, {item.name}, {item.name});")
            for function, item in self.row_functions.values():
                inner += both(f"{self.sink} = {function}({item.name}, 0);")
            for function, kind in self.real_changers:
                inner += both(f"{{ {kind} own; own = 1; {function}(&own, 2); }}")
            # a function that no part reaches is not the judge's business
            for function in self.functions:
                inner += self.simple(self.call_of(function, 2))
        return Lines([f"void {name}()", "{", *self.function_locals, *inner.plc, "}"],
                     [f"static void {name}_{self.mark}(void)", "{", *body.hoisted, *inner.avr, "}"])


def generate(seed):
    return Generator(f"program {seed}", f"p{seed}").program()
