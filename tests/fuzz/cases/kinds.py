"""Programs of n lines that hold one kind of statement each, for every kind that the languages have.

The kinds are not picked: they are the words of a language's tables (the quoted texts of `*.def`) and of its grammar. Each
word is shown by the smallest golden program with it; the body of that program (the part that may hold any number of
statements) is repeated, and what a copy defines (labels, mechanisms) gets names of its own.
"""
import dataclasses
import re

import corpus

# Dialect: (the file that is repeated ends so, what stands around its body). A project of classicladder is none that grows
# line by line: its rungs have numbers, and are in picked_kinds.py.
BODIES = {
    "nc110": (".plc", r"(?P<head>(?:.*\n)*?\$.*\n)(?P<body>(?:[^$].*\n|\n)+)(?P<tail>)\Z"),
    "host50": (".il", r"(?P<head>(?:.*\n)*?(?:SLOW)\b.*\n)(?P<body>(?:.*\n)+?)(?P<tail>END_SLOW(?:.*\n)*)\Z"),
    "prostep": (".plc", r"(?P<head>(?:.*\n)*?:MOD PM \d+.*\n)(?P<body>(?:.*\n)+?)(?P<tail>:END PM(?:.*\n)*)\Z"),
    "technol": (".plc", r"(?P<head>(?:.*\n)*?\s*MODULE_MAIN\s*\n)(?P<body>(?:.*\n)+?)(?P<tail>\s*MODULE_MAIN_END(?:.*\n)*)\Z"),
    "hnc": (".cld", r"(?P<head>(?:.*\n)*?void plc1\([a-z]*\)\s*\{)(?P<body>(?:.*\n)*?.*?)(?P<tail>\}\s*(?:\n(?:[^ \t\n}].*)?)*\n?)\Z"),
}
# What a body defines: one group, the name.
DEFINITIONS = {
    "nc110": r"$^",
    "host50": r"^NETWORK +L(\d{4})",
    "prostep": r"^([A-Z][A-Z0-9]{0,3}) +:",
    "technol": r"^([A-Z_][A-Z0-9_]*):|^\s+MECH_BEGIN\s+([A-Z_][A-Z0-9_]*)",
    "hnc": r"^\s*([a-z]\w*) *:(?!:)",
}
DIGITS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"
WORD = r"[A-Za-z_][A-Za-z_0-9]*|<<=?|>>=?|><|!=|[<>=]=?|\+\+|--|&&|\|\||[-+*/%&|^]=|[?*+&/%^~-]"


@dataclasses.dataclass
class Kind:
    name: str       # the words that it shows
    dialect: str
    case: corpus.Case
    source: str     # the name of the file that grows
    head: str
    body: str
    tail: str


def new_name(dialect, number):
    if dialect == "host50":
        return f"{number % 10000:04d}"
    text = ""
    for _ in range(3):
        number, digit = divmod(number, 36)
        text = DIGITS[digit] + text
    return {"hnc": "n"}.get(dialect, "N") + text + (DIGITS[number] * bool(number))


def copies(kind, lines):
    """The program with so many lines of the kind."""
    defined = sorted({name for found in re.findall(DEFINITIONS[kind.dialect], kind.body, re.MULTILINE)
                      for name in ((found,) if isinstance(found, str) else found) if name})
    count = max(1, lines // (kind.body.count("\n") or 1))
    if not defined:
        repeated = kind.body * count
    else:
        pattern = re.compile(r"(?<![A-Za-z0-9_])([LJ]?)(" + "|".join(map(re.escape, defined)) + r")(?![A-Za-z0-9_])")
        at = {name: place for place, name in enumerate(defined)}
        repeated = "".join(
            pattern.sub(lambda found, i=i: found[1] + new_name(kind.dialect, i * len(defined) + at[found[2]]), kind.body)
            for i in range(count))
    return kind.head + repeated + kind.tail


def vocabulary(root, dialect):
    words = set()
    for table in (root / "transpiler/dialects" / dialect).glob("*.def"):
        for text in re.findall(r'"([^"\n]+)"', re.sub(r"//.*", "", table.read_text("utf-8"))):
            words |= set(re.findall(WORD, text)) if len(text) < 24 else set()
    grammar = root / "grammars" / f"{dialect}.ebnf"
    if grammar.exists():
        text = re.sub(r"\(\*.*?\*\)", "", grammar.read_text("utf-8"), flags=re.DOTALL)
        words |= {word for quoted in re.findall(r'"([^"\n]+)"', text) for word in re.findall(WORD, quoted)}
    else:  # C's words
        words |= set("if else while do for switch case default break continue goto return sizeof struct union enum "
                     "static const int char long unsigned float double ++ -- && || << >> <= >= == != += -= *= /= %= "
                     "&= |= ^= <<= >>= ?".split())
    return words


def candidates(root, dialect, wrong):
    suffix, around = BODIES[dialect]
    for case in corpus.cases(root):
        if case.dialect != dialect or case.scenario.stem.endswith("_bad") != wrong or "samples" in case.scenario.parts:
            continue
        for name in case.sources:
            text = case.files[name].decode("utf-8", "replace").replace("\r\n", "\n")
            text += "" if text.endswith("\n") else "\n"
            found = re.match(around, text) if name.endswith(suffix) and len(text) < 5000 else None
            if found:
                yield len(found["body"]), case, name, found


def body_of(dialect, found):
    return found["body"] if dialect != "hnc" else "{" + found["body"].rstrip("\n") + "}\n"


def wrong_lines(root, dialect):
    """(case, file, program of n lines) for each golden program that is refused: the line of its error, n times."""
    for case in corpus.cases(root):
        text = case.files[case.scenario.name].decode("utf-8", "replace")
        found = re.search(r"^expect_error: *\{(.*)\}", text, re.MULTILINE)
        line = re.search(r"\bline: *(\d+)", found[1]) if found else None
        file = re.search(r"\bfile: *([^,}]+)", found[1]) if found else None
        name = file[1].strip(" '\"") if file else case.sources[0]
        if case.dialect != dialect or line is None or name not in case.files:
            continue
        lines = case.files[name].splitlines(keepends=True)
        at = int(line[1]) - 1
        if at < len(lines):
            yield case, name, lambda n, lines=lines, at=at: b"".join(
                lines[:at] + [lines[at].rstrip(b"\r\n") + b"\n"] * n + lines[at + 1:])


def errors(root, dialect):
    """A kind for each golden program that is refused."""
    return [Kind(case.scenario.stem, dialect, case, name, found["head"], body_of(dialect, found), found["tail"])
            for _, case, name, found in candidates(root, dialect, True)] if dialect in BODIES else []


def kinds(root, dialect):
    """A kind for each word, and the words that no golden program shows in its body."""
    if dialect not in BODIES:
        return [], set()
    words = vocabulary(root, dialect)
    left, chosen = set(words), []
    for _, case, name, found in sorted(candidates(root, dialect, False),
                                       key=lambda each: (each[0], str(each[1].scenario))):
        body = body_of(dialect, found)
        shown = set(re.findall(WORD, found["body"])) & left
        if shown:
            left -= shown
            chosen.append(Kind(" ".join(sorted(shown)), dialect, case, name, found["head"], body, found["tail"]))
    return chosen, left
