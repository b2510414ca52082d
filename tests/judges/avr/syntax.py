"""What `plcxx print syntax` shows of a program in C: operators with the types of their operands, conversions, places, statements.

Conversions are all in the text, so a type is that of the variable, the constant or the conversion below an operator.
"""
import re

TOKEN = re.compile(r"-?[\d.e+-]+:(?:unsigned |signed )?\w+|(?:to|cast|[-+*/%&|^]=|<<=|>>=)<[^<>]*>|\(unnamed[^)]*\)|\(|\)|[^\s()]+")
CONSTANT = re.compile(r"-?[\d.e+-]+(?:inf|nan)?:([a-z][a-z ]*)")
VARIABLE = re.compile(r"\s*(?:\d+: )?variable (\S+) : (.*?), ([a-z0-9_ ]+?)(, const)?$")
FUNCTION = re.compile(r"\d+: function (\S+) : (.*?) \((.*)\)( without prototype)?$")
RECORD = re.compile(r"(struct|union) (.*?) ?size \d+$")
MEMBER = re.compile(r"  (\S*) : (.*?) at \d+( bits .*)?$")
STATEMENT = re.compile(r"(\s*)(?:\d+: )?(if|switch|while|do while|for|return|case|label|goto|default|continue|break|empty|else|cli|sti)\b ?(.*)$")
UNARY = ("+", "-", "~", "!")
COMPARISONS = ("<", ">", "<=", ">=", "==", "!=")
STEPS = ("++x", "--x", "x++", "x--")


def unqualified(kind):
    return re.sub(r"\b(const|volatile|near|far|huge) ?", "", kind).strip()


def shape(kind):
    """The type as it is counted."""
    kind = unqualified(kind)
    if kind.endswith("*") or "(*)" in kind:
        return "pointer"
    if kind.endswith("]"):
        return "array"
    if kind.startswith(("struct", "union")):
        return kind.split()[0]
    names = {"char": "signed char", "short": "int", "unsigned short": "unsigned int"}  # as the tree has them, but in arrays
    return "int" if kind.startswith("enum") else names.get(kind, kind)


class Reader:
    """Counts the forms of one program into `counts`."""

    def __init__(self, counts):
        self.counts = counts
        self.variables, self.functions, self.records = {}, {}, {}
        self.open = []  # (indent, kind) of the statements around

    def count(self, group, name):
        self.counts[group, name] += 1

    def read(self, text):
        record = None
        for row in text.splitlines():
            if found := FUNCTION.match(row):
                self.functions[found[1]] = found[2]
                names = [part.rpartition(" : ") for part in found[3].split(", ") if part]
                self.variables.update({name: kind for name, _, kind in names})
                for _, _, kind in names:
                    self.count("parameter", shape(kind) + (" without prototype" if found[4] else ""))
                self.count("parameters", str(min(4, len(names))))
                self.count("result", shape(found[2]))
        for row in text.splitlines():
            if found := RECORD.match(row):
                record = self.records.setdefault(f"{found[1]} {found[2]}".strip(), [])
            elif record is not None and (found := MEMBER.match(row)):
                record.append((found[2], bool(found[3])))
                self.count("member", ("field of " if found[3] else "") + shape(found[2]))
            elif found := VARIABLE.match(row):
                record = None
                self.variables[found[1]] = found[2]
                if found[3] != "system":
                    self.count("variable", f"{found[3]} {shape(found[2])}")
            elif FUNCTION.match(row):
                record, self.open = None, []
            else:
                record = None
                self.line(row)

    def line(self, row):
        if found := re.match(r"\s*at \d+: (.*)", row):
            self.count("initial value", shape(self.expression(found[1]) or "text"))
            return
        if found := STATEMENT.match(row):
            indent, kind, rest = len(found[1]), found[2], found[3]
            while self.open and self.open[-1][0] >= indent:
                self.open.pop()
            if kind == "else":
                self.open.append((indent, "else"))
                return
            self.statement(kind)
            if kind in ("if", "switch", "while", "do while", "for", "case", "default", "label"):
                self.open.append((indent, kind))
            if kind == "for":
                parts = rest.split("; ")
                self.count("statement", "for without " + ", ".join(
                    name for name, part in zip(("start", "test", "step"), parts) if part == "none") if "none" in parts else "for with all")
                for part in parts:
                    self.expression(part)
            elif kind in ("if", "switch", "while", "do while", "return") and rest and rest != "none":
                value = self.expression(rest)
                self.count("tested by", f"{kind} {shape(value or 'none')}") if kind != "return" else None
            return
        text = row.strip().partition(": ")
        rest = text[2] if text[0].isdigit() else row.strip()
        indent = len(row) - len(row.lstrip())
        while self.open and self.open[-1][0] >= indent:
            self.open.pop()
        if rest.startswith("("):
            self.statement("expression")
            self.expression(rest)

    def statement(self, kind):
        self.count("statement", kind)
        around = [name for _, name in self.open if name in ("if", "else", "switch", "while", "do while", "for")]
        if around and kind in ("if", "switch", "while", "do while", "for"):
            self.count("statement in", f"{kind} in {around[-1]}")
        left = [name for name in around if name not in ("if", "else")]
        if left and kind in ("return", "goto", "continue", "break"):
            self.count("statement in", f"{kind} in {left[-1]}")
        self.count("depth", str(min(6, len(around))))

    # expressions

    def expression(self, text):
        self.tokens = TOKEN.findall(text)
        self.at = 0
        return self.value() if self.tokens else None

    def value(self):
        """The type of what begins here."""
        token = self.tokens[self.at]
        self.at += 1
        if token != "(":
            return self.leaf(token)
        head = self.tokens[self.at]
        self.at += 1
        operands = []
        while self.tokens[self.at] != ")":
            operands.append(self.value())
        self.at += 1
        return self.node(head, operands)

    def leaf(self, token):
        if found := CONSTANT.fullmatch(token):
            return found[1]
        if token.startswith("string#"):
            self.count("leaf", "string")
            return "char[]"
        if token in ("null", "none", "poison"):
            self.count("leaf", token)
            return "void *"
        return self.variables.get(token, "")

    def node(self, head, operands):
        kinds = [shape(kind or "") for kind in operands]
        if head.startswith(("to<", "cast<")):
            word, _, target = head.partition("<")
            target = target[:-1]
            self.count("conversion" if word == "to" else "cast", f"{kinds[0]} to {shape(target)}")
            return target
        if found := re.fullmatch(r"(\S+)=<(.*)>", head):
            self.count("compound", f"{found[1]}= {kinds[0]}")
            self.count("computed in", f"{found[1]}= {shape(found[2])}")
            return operands[0]
        if head in STEPS:
            self.count("step", f"{head} {kinds[0]}")
            return operands[0]
        if head in ("load", "decay"):
            if head == "load":
                self.count("load", kinds[0])
                return operands[0]
            return unqualified(re.sub(r" ?\[\d*\]", " *", operands[0] or "", count=1)) if operands[0] else ""
        if head == "=":
            self.count("assign", kinds[0])
            return operands[0]
        if head in ("&&", "||"):
            for kind in kinds:
                self.count("tested by", f"{head} {kind}")
            return "int"
        if head == "?:":
            self.count("?:", kinds[1])
            self.count("tested by", f"?: {kinds[0]}")
            return operands[1]
        if head == ",":
            self.count("comma", kinds[1])
            return operands[1]
        if head == "*" and len(operands) == 1:
            self.count("place", "* of a pointer")
            return (operands[0] or "").rstrip()[:-1].strip() if (operands[0] or "").rstrip().endswith("*") else ""
        if head == "&" and len(operands) == 1:
            self.count("address", kinds[0])
            return (operands[0] or "") + " *"
        if head == "[]":
            base = operands[0] or ""
            self.count("place", "[] of " + shape(base))
            self.count("index", kinds[1])
            return base.rstrip()[:-1].strip() if base.rstrip().endswith("*") else re.sub(r" ?\[\d*\]", "", base, count=1)
        if re.fullmatch(r"\.\d+", head):
            members = self.records.get(unqualified(operands[0] or ""), [])
            kind, field = members[int(head[1:])] if int(head[1:]) < len(members) else ("", False)
            self.count("place", "bit-field" if field else f"member {shape(kind)}")
            return kind
        if len(operands) == 1 and head in UNARY:
            self.count("operator", f"{head}x {kinds[0]}")
            return "int" if head == "!" else operands[0]
        if len(operands) == 2 and head in ("<<", ">>"):
            self.count("operator", f"{head} {kinds[0]} by {kinds[1]}")
            return operands[0]
        if len(operands) == 2 and not re.match(r"\w", head) or head in ("p+", "p-", "p-p"):
            self.count("operator", f"{head} {kinds[0]}")
            return "int" if head in COMPARISONS or head == "p-p" else operands[0]
        self.count("call", head if head not in self.functions else "own")
        return self.functions.get(head, "int")
